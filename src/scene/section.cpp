// See section.h.
#include "scene/section.h"

namespace ups {

std::vector<ups_segment> section(const Snapshot& scene, const Vec3d& point, const Vec3d& normal) {
  std::vector<ups_segment> out;
  const Vec3d own = point - scene.origin;
  scene.raytracer->each_triangle([&](const Vec3d (&p)[3]) {
    double height[3];
    for (int i = 0; i < 3; ++i) height[i] = dot(p[i] - own, normal);
    Vec3d ends[2];
    int count = 0;
    for (int i = 0; i < 3; ++i) {
      const int j = (i + 1) % 3;
      if ((height[i] > 0) == (height[j] > 0)) continue;
      ends[count++] = p[i] + (p[j] - p[i]) * (height[i] / (height[i] - height[j])) + scene.origin;
    }
    if (count == 2 && length2(ends[1] - ends[0]) > 0)
      out.push_back({{ends[0].x, ends[0].y, ends[0].z}, {ends[1].x, ends[1].y, ends[1].z}});
  });
  return out;
}

}  // namespace ups
