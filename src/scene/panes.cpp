// See panes.h.
#include "scene/panes.h"

#include <limits>

#include "scene/snapshot.h"

namespace ups {

bool Panes::may_lie_between(const Vec3& a, const Vec3& b) const {
  if (of_instance.empty()) return false;
  double enter = 0, leave = 1;
  const auto clip = [&](double from, double to, double lower, double upper) {
    const double d = to - from;
    if (d == 0) return from >= lower && from <= upper;
    const double t0 = (lower - from) / d, t1 = (upper - from) / d;
    enter = std::max(enter, std::min(t0, t1));
    leave = std::min(leave, std::max(t0, t1));
    return enter <= leave;
  };
  return clip(a.x, b.x, bounds.lower.x, bounds.upper.x) && clip(a.y, b.y, bounds.lower.y, bounds.upper.y) &&
         clip(a.z, b.z, bounds.lower.z, bounds.upper.z);
}

Panes find_panes(const Snapshot& scene, const std::vector<Raytracer::Instance>& instances) {
  Panes panes;
  const double margin = 0x1p-17 * scene.radius;  // no surface point's error is larger
  for (size_t i = 0; i < instances.size(); ++i) {
    const Material& material = scene.materials[instances[i].material];
    if (material.model != MaterialModel::glazing || scene.emitter_of_instance[i] != none) continue;
    panes.of_instance.resize(instances.size());
    panes.of_instance[i] = true;
    const Box box = bounding_box(*scene.meshes[instances[i].mesh]).transformed(instances[i].to_scene);
    panes.bounds.grow(box.lower - Vec3d{margin, margin, margin});
    panes.bounds.grow(box.upper + Vec3d{margin, margin, margin});
  }
  return panes;
}

bool intersect_beyond_panes(const Snapshot& scene, const Vec3& o, const Vec3& d, Hit& hit) {
  for (Vec3 from = o; scene.raytracer->intersect(from, d, std::numeric_limits<float>::infinity(), hit);) {
    if (!scene.panes.is_pane(hit)) return true;
    from = scene.raytracer->surface_at(hit).ray_origin(d);
  }
  return false;
}

}  // namespace ups
