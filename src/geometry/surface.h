// A point on a surface as both walks see it: position rebuilt from barycentrics,
// geometric and shading normal, error bound.
#pragma once
#include <cstdint>

#include "base/frame.h"

namespace ups {

struct Hit {
  float t = 0;
  uint32_t instance = 0, primitive = 0;
  float u = 0, v = 0;  // barycentrics of vertices 1 and 2
};

struct SurfacePoint {
  Vec3 p;
  Vec3 ng;        // unit; front: counter-clockwise; a mirroring transform keeps the front in front
  Frame shading;  // shading.n on the same side as ng
  Vec2 uv;
  float error = 0;  // p is within this distance of the true surface; grows with |p| and the triangle
  uint32_t instance = 0, primitive = 0;
  float u = 0, v = 0;
  uint32_t material = 0;

  // Where a ray towards d starts: off the surface by its error, on d's side.
  Vec3 ray_origin(const Vec3& d) const { return p + ng * (dot(d, ng) >= 0 ? 2 * error : -2 * error); }
};

}  // namespace ups
