// See panes.h.
#include "scene/panes.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "base/rng.h"
#include "scene/traced_box.h"

namespace ups {

bool Panes::meets_bounds(const Vec3& a, const Vec3& b) const {
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

bool is_shining_pane(const Snapshot& scene, size_t instance) {
  const Material& m = scene.materials[scene.instances[instance].material];
  return m.model == MaterialModel::glazing && scene.emitter_of_instance[instance] != none && traits_of(m).transmits;
}

Panes find_panes(const Snapshot& scene, const std::vector<Raytracer::Instance>& instances) {
  Panes panes;
  const double margin = 0x1p-17 * scene.radius;  // no surface point's error is larger
  for (size_t i = 0; i < instances.size(); ++i) {
    const uint32_t material = instances[i].material;
    const bool emits = scene.emitter_of_instance[i] != none,
               pane = scene.materials[material].model == MaterialModel::glazing && !emits,
               blended = scene.texturing[material].alpha_mode == SurfaceTexturing::blend;
    const auto mark = [&](std::vector<bool>& marked) { marked.resize(instances.size()), marked[i] = true; };
    if (pane) mark(panes.of_instance);
    if (blended) mark(panes.blended);
    if (!pane && !blended) continue;
    const Box box = traced_box(scene, instances[i]);
    panes.bounds.grow(box.lower - Vec3d{margin, margin, margin});
    panes.bounds.grow(box.upper + Vec3d{margin, margin, margin});
  }
  return panes;
}

float coverage(const Snapshot& scene, const SurfacePoint& s) {
  return scene.panes.is_blended(s.instance) ? std::clamp(scene.texturing[s.material].alpha_at(s.uv), 0.0f, 1.0f) : 1.0f;
}

namespace {

// By a number that belongs to where a ray meets a surface.
bool is_there(const Snapshot& scene, const Hit& hit, const Vec3& d) {
  if (!scene.panes.is_blended(hit.instance)) return true;
  const SurfacePoint s = scene.raytracer->surface_at(hit);
  const auto bits = [](float a, float b) {
    return uint64_t(std::bit_cast<uint32_t>(a)) << 32 | std::bit_cast<uint32_t>(b);
  };
  const uint64_t h = hash_combine(hash_combine(bits(s.p.x, s.p.y), bits(s.p.z, d.x)),
                                  hash_combine(bits(d.y, d.z), uint64_t(s.instance)));
  return to_unit_float(uint32_t(h >> 32)) < coverage(scene, s);
}

// kept(hit): whether the ray ends there.
template <class Kept>
bool intersect_beyond(const Snapshot& scene, const Vec3& o, const Vec3& d, Hit& hit, const Kept& kept) {
  for (Vec3 from = o; scene.raytracer->intersect(from, d, std::numeric_limits<float>::infinity(), hit);) {
    if (kept(hit)) return true;
    from = scene.raytracer->surface_at(hit).ray_origin(d);
  }
  return false;
}

}  // namespace

bool intersect_blended(const Snapshot& scene, const Vec3& o, const Vec3& d, Hit& hit) {
  return intersect_beyond(scene, o, d, hit, [&](const Hit& h) { return is_there(scene, h, d); });
}

bool intersect_beyond_panes(const Snapshot& scene, const Vec3& o, const Vec3& d, Hit& hit) {
  return intersect_beyond(scene, o, d, hit,
                          [&](const Hit& h) { return !scene.panes.is_pane(h.instance) && is_there(scene, h, d); });
}

}  // namespace ups
