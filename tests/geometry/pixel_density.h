// The integral of a camera's density over one of its pixels, by n x n small cells whose solid angle is the area of their
// image on the unit sphere: no formula of the camera enters it.
#pragma once
#include "sensor/camera.h"

namespace ups {

inline double density_over_pixel(const Camera& camera, uint32_t px, uint32_t py, int n) {
  double total = 0;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const float step = 1.0f / float(n), u = float(i) * step, v = float(j) * step;
      const Vec3d a(*camera.ray(px, py, {u, v})), b(*camera.ray(px, py, {u + step, v})),
          c(*camera.ray(px, py, {u + step, v + step})), d(*camera.ray(px, py, {u, v + step}));
      const double solid_angle = 0.5 * length(cross(c - a, d - b));
      total += solid_angle * double(camera.pdf_w(*camera.ray(px, py, {u + step / 2, v + step / 2})));
    }
  return total;
}

}  // namespace ups
