// Vertices of the light paths of one iteration, as connections and merges read them.
#pragma once
#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <new>
#include <span>
#include <vector>

#include "transport/subpath.h"

namespace ups {

// Two lines of the cache: merges read the first one and have the place from the index.
struct alignas(64) LightVertex {
  Vec3 ng;
  Vec3 wo;   // towards the vertex before
  Rgb flux;  // lm that this light path carries here; divide by N for a photon
  // Of mis::LightState, in float: their weights are right to 1e-6.
  float inverse_density = 0, by_connection = 0, by_caustic = 0, by_merge = 0, by_eye = 0;
  uint32_t emitter = 0;  // that the path started from
  uint16_t depth = 0;    // a of x_a
  bool merge : 1 = false;       // photons are merged here: the material's gate and g_1
  bool lit : 1 = true;          // from the front of its shading normal; else merged alone
  bool lambertian : 1 = false;  // scatters continuously by Lambertian lobes alone
  bool both_sides : 1 = false;  // Bsdf::transmits_continuously
  bool first : 1 = true, casters : 1 = true;  // of mis::LightState
  bool blended : 1 = false;     // coverage < 1
  uint8_t error_exponent = 0;   // error < 2^(this - 127)

  Vec3 p, ns;
  Textured textured;
  float error = 0;
  uint32_t material = 0;
  float relative_ior = 1;  // where it is of glass, see Encounter
  float coverage = 1;      // chance of being met, where the surface is blended

  float most_error() const { return std::bit_cast<float>(uint32_t(error_exponent) << 23); }
  void set_error(float e) {
    error = e;
    error_exponent = uint8_t(std::min((std::bit_cast<uint32_t>(e) >> 23) + 1, 254u));
  }
  void set_coverage(float c) { coverage = c, blended = c < 1; }
  mis::LightState state() const {
    return {inverse_density, by_connection, by_caustic, by_merge, by_eye, bool(first), bool(casters)};
  }
  void set_state(const mis::LightState& s) {
    const auto kept = [](double x) { return float(std::min(x, double(std::numeric_limits<float>::max()))); };
    inverse_density = kept(s.inverse_density), by_eye = kept(s.by_eye);
    by_connection = kept(s.by_connection), by_caustic = kept(s.by_caustic), by_merge = kept(s.by_merge);
    first = s.first, casters = s.casters;
  }

  // Into one that is used again: its other members stay as they were made.
  void fill(const Snapshot& scene, LightEnd& e) const {
    e.surface.p = p;
    e.surface.ng = ng;
    e.surface.shading = Frame(ns);
    e.surface.error = error;
    e.bsdf.emplace(scene.materials[material], relative_ior, textured);
    e.wo = wo;
    e.local_wo = e.surface.shading.to_local(wo);
    e.state = state();
    e.merge = merge;
    e.caster = e.bsdf->is_caster();
    e.edges = depth;
    e.carried = flux;
  }
};
static_assert(sizeof(LightVertex) == 128 && offsetof(LightVertex, p) == 64);

// Of the paths of a block, what the index is made of.
struct StoredPhoton {
  Vec3 p;
  uint32_t vertex;  // of the block's
};

// The paths of one iteration. Vertices lie in blocks, those of a path side by side; a vertex's place names it by its
// block and where it is there.
struct LightPaths {
  static constexpr uint32_t paths_per_block = 1024;
  // What an eye path connects to.
  struct Path {
    const LightVertex* vertices = nullptr;
    uint32_t count = 0, first = 0;  // first: its running number
  };

  std::vector<std::span<const LightVertex>> blocks;
  std::vector<std::span<const StoredPhoton>> photons;  // of the same blocks, those whose gate is open
  std::vector<uint32_t> begin;  // N + 1: a path's first vertex by the running numbers of all
  uint32_t shift = 0;           // of a block's number in a place
  size_t merged = 0;            // vertices whose gate is open
  MemoryShare share;            // of begin, and of what is made of it

  uint32_t path_count() const { return begin.empty() ? 0 : uint32_t(begin.size() - 1); }
  Path path(uint32_t i) const {
    const uint32_t block = i / paths_per_block, first = begin[i];
    return {blocks[block].data() + (first - begin[block * paths_per_block]), begin[i + 1] - first, first};
  }
  uint32_t place(size_t block, size_t i) const { return uint32_t(block) << shift | uint32_t(i); }
  const LightVertex& at(uint32_t place) const { return blocks[place >> shift][place & ((1u << shift) - 1)]; }
  uint32_t running_number(uint32_t place) const {
    return begin[(place >> shift) * paths_per_block] + (place & ((1u << shift) - 1));
  }
  // visit(place, vertex), path by path.
  template <class Visit>
  void each(const Visit& visit) const {
    for (size_t b = 0; b < blocks.size(); ++b)
      for (size_t i = 0; i < blocks[b].size(); ++i) visit(place(b, i), blocks[b][i]);
  }
  // After blocks and begin: throws where there are more vertices than places.
  void number_places() {
    size_t largest = 1;
    for (const auto& block : blocks) largest = std::max(largest, block.size());
    shift = uint32_t(std::bit_width(largest - 1));
    if (shift > 31 || blocks.size() > size_t(1) << (32 - shift)) throw std::bad_alloc();
  }
  // Of these photons alone, which must outlive it: their places are the numbers of their vertices.
  static LightPaths of(const std::vector<StoredPhoton>& photons) {
    LightPaths out;
    out.photons = {photons};
    out.merged = photons.size();
    return out;
  }
};

}  // namespace ups
