// How much an emitter, or a group of them, shines towards a direction, roughly and cheaply: never nothing where it does
// shine, but for what a texel misses. Made by the light tree from outlines.
#pragma once
#include <array>
#include <cstdint>

#include "base/frame.h"
#include "base/lanes.h"

namespace photometry {
class Distribution;
}

namespace ups {

// Directions on a square: an octahedron unfolded (Meyer et al. 2010, On floating-point normal vectors).
template <int N>
struct DirectionMap {
  static constexpr int size = N * N;
  // w of any length. Real: float, or several at once.
  template <class Real>
  static auto texel(const Vec3T<Real>& w) {
    using std::abs, std::copysign, ups::abs, ups::copysign;
    constexpr float half = 0.5f * N;
    const Real zero{}, least = all_lanes<Real>(1e-30f), last = all_lanes<Real>(N - 0.5f);
    const Real scale = half / larger(least, abs(w.x) + abs(w.y) + abs(w.z)), x = w.x * scale, y = w.y * scale;
    const Real u = w.z < zero ? copysign(half - abs(y), x) : x, v = w.z < zero ? copysign(half - abs(x), y) : y;
    const auto within = [&](const Real& a) { return truncated(smaller(larger(a + half, zero), last)); };
    return within(v) * N + within(u);
  }
  // Unit; x, y in [0, 1] across the texel.
  static Vec3 direction(int texel, float x, float y) {
    float u = (float(texel % N) + x) * (2.0f / N) - 1, v = (float(texel / N) + y) * (2.0f / N) - 1;
    const float z = 1 - std::abs(u) - std::abs(v);
    if (z < 0) {
      const float unfolded = std::copysign(1 - std::abs(v), u);
      v = std::copysign(1 - std::abs(u), v);
      u = unfolded;
    }
    return normalize(Vec3(u, v, z));
  }
};

struct Lobe {
  using Fine = DirectionMap<32>;   // of a distribution, in its frame
  using Coarse = DirectionMap<8>;  // of a group, in the scene's
  enum class Shape : uint32_t { uniform, cosine, two_cosines, cone, fine, coarse };

  Shape shape = Shape::uniform;
  float outer_cosine = 0, inverse_width = 0;  // cone: in cosines
  const float* table = nullptr;
  Frame frame;

  // Towards w, whose length is 1 / inverse_length. Relative to the intensity that goes with the lobe.
  float towards(const Vec3& w, float inverse_length) const {
    switch (shape) {
      case Shape::uniform: return 1;
      case Shape::cosine: return std::max(0.0f, dot(w, frame.n) * inverse_length);
      case Shape::two_cosines: return std::abs(dot(w, frame.n)) * inverse_length;
      case Shape::cone: return cone(dot(w, frame.n) * inverse_length);
      case Shape::fine: return table[Fine::texel(frame.to_local(w))];
      case Shape::coarse: return table[Coarse::texel(w)];
    }
    return 0;
  }

  float largest() const {
    const int size = shape == Shape::fine ? Fine::size : shape == Shape::coarse ? Coarse::size : 0;
    return size ? *std::max_element(table, table + size) : 1;
  }

 private:
  float cone(float cosine) const {
    const float ramp = std::min(1.0f, (cosine - outer_cosine) * inverse_width);
    return ramp > 0 ? std::max(0.01f, ramp * ramp) : 0;
  }
};

using FineTable = std::array<float, Lobe::Fine::size>;
using CoarseTable = std::array<float, Lobe::Coarse::size>;

Lobe cone_lobe(const Frame& frame, double inner_versine, double outer_versine);
// The largest intensity, cd, that is found in each texel.
FineTable fine_table(const photometry::Distribution& distribution);
// What a lobe shines into each texel, on the average of a few directions.
void add_to(CoarseTable& table, const Lobe& lobe, float intensity);

}  // namespace ups
