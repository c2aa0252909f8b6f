// Which technique found a contribution to a camera, and images of each: diagnostics that a render can be asked for.
// Written by the walks, summed by render/accumulator.
#pragma once
#include <array>
#include <cstdint>

#include "base/rgb.h"
#include "base/stop.h"
#include "base/zeroed.h"

namespace ups {

inline constexpr uint32_t max_technique_edges = 16;

// The two families of the extended path space (Hachisuka, Pantaleoni, Jensen 2012, Eq. 14 and 15).
enum class Family { path_integration, density_estimation };

// s vertices of the light path and t of the eye path make a path of `edges` edges: s + t = edges + 1, and edges + 2
// where both paths have a vertex at the same place, a merge.
struct Technique {
  Family family = Family::path_integration;
  uint32_t s = 0, edges = 0;
  uint32_t t() const { return edges + (family == Family::path_integration ? 1 : 2) - s; }
};

// Paths of k edges have k + 1 techniques of path integration, s = 0 ... k,
// then k - 1 of density estimation, s = 2 ... k.
inline uint32_t technique_count(uint32_t max_edges) { return max_edges * (max_edges + 1); }
inline uint32_t technique_index(const Technique& t) {
  return t.edges * (t.edges - 1) + (t.family == Family::path_integration ? t.s : t.edges + t.s - 1);
}
inline Technique technique_at(uint32_t index) {
  uint32_t k = 1;
  while (technique_count(k) <= index) ++k;
  const uint32_t i = index - k * (k - 1);
  return i <= k ? Technique{Family::path_integration, i, k} : Technique{Family::density_estimation, i - k + 1, k};
}

// One iteration's images of one camera: technique by technique, each pixel by pixel.
struct TechniqueTally {
  uint32_t max_edges = 0, pixels = 0;
  ZeroedVector<Rgb> weighted, unweighted;
  std::array<ZeroedVector<Rgb>, 2> families;  // weighted, of eye paths (t > 1) of any length, by Family

  // Of no use where `stop` is set on the way.
  void reset(uint32_t edges, uint32_t pixel_count, const StopSignal& stop) {
    max_edges = edges, pixels = pixel_count;
    const size_t n = size_t(technique_count(edges)) * pixels;
    for (auto* images : {&weighted, &unweighted}) clear(*images, n, stop);
    for (auto& f : families) clear(f, pixels, stop);
  }
  static void clear(ZeroedVector<Rgb>& images, size_t size, const StopSignal& stop) {
    if (images.size() != size)
      images = ZeroedVector<Rgb>(size);
    else
      stop.for_each(size, [&](size_t i) { images[i] = Rgb(0.0f); });
  }
  // Each pixel by one thread at a time.
  void add(const Technique& t, uint32_t pixel, const Rgb& with_weight, const Rgb& without) {
    if (t.t() > 1) families[size_t(t.family)][pixel] += with_weight;
    if (t.edges > max_edges) return;
    const size_t i = size_t(technique_index(t)) * pixels + pixel;
    weighted[i] += with_weight;
    unweighted[i] += without;
  }
};

}  // namespace ups
