// What of a surface lies in which texel of a lightmap: triangles cut along the texels' borders in UV. Called by
// scene/prepare_meters.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "geometry/raytracer.h"

namespace ups {

struct Vec2d {
  double x, y;
};

// A triangle of a surface, and the weights of its corners at those of a part of it.
struct TexelPart {
  uint32_t texel, triangle;
  std::array<std::array<double, 3>, 3> weights;
};

class LightmapCut {
 public:
  LightmapCut(uint32_t width, uint32_t height) : width_(width), height_(height) {}
  // uv: of a triangle's corners. Counts it as flat where it has no area in UV. Throws Error INVALID_ARGUMENT where all of
  // them lie over one another so often that parts would fill the memory.
  void add(uint32_t triangle, const std::array<Vec2d, 3>& uv);
  // By texel, then in the order of the triangles.
  std::vector<TexelPart> take();

  size_t flat() const { return flat_; }
  // Of texels in which different triangles lie over one another; found by take().
  struct Overlaps {
    size_t texels = 0;
    uint32_t texel = 0, first = 0, second = 0;  // the first texel found, and two of its triangles
  };
  const Overlaps& overlaps() const { return overlaps_; }

 private:
  void cover(double texels);
  void find_overlaps();

  uint32_t width_, height_;
  std::vector<TexelPart> parts_;
  std::vector<std::array<Vec2d, 3>> uvs_;  // of parts_, in texels
  size_t flat_ = 0;
  double covered_ = 0;  // texels
  Overlaps overlaps_;
};

}  // namespace ups
