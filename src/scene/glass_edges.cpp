// See glass_edges.h.
#include "scene/glass_edges.h"

#include <atomic>
#include <cmath>

namespace ups {
namespace {

bool is_glass(const Snapshot& scene, const SurfacePoint& s) {
  return scene.materials[s.material].model == MaterialModel::glass;
}

// A solid begins so closely above p.
bool is_below_glass(const Snapshot& scene, const Vec3& p, const Vec3& n, float error, float height = glass_height) {
  Hit hit;
  if (!scene.raytracer->intersect(p + n * (2 * error), n, height, hit)) return false;
  const SurfacePoint s = scene.raytracer->surface_at(hit);
  return is_glass(scene, s) && dot(s.ng, n) < 0;
}

// Does a ray from p leave a solid first?
bool is_within_glass(const Snapshot& scene, const Vec3& p, const Vec3& d, float reach) {
  Hit hit;
  if (!scene.raytracer->intersect(p, d, reach, hit)) return false;
  const SurfacePoint s = scene.raytracer->surface_at(hit);
  return is_glass(scene, s) && dot(s.ng, d) > 0;
}

// A solid begins where p is, as far as rounding tells: whether there is air between chance decides.
bool touches_glass(const Snapshot& scene, const Vec3& p, const Vec3& n, float error) {
  const float rounding = 10 * error;
  return is_below_glass(scene, p, n, error, rounding) ||
         (is_within_glass(scene, p + n * (2 * error), n, glass_height) &&
          !is_within_glass(scene, p - n * rounding, -n, 4 * scene.radius));
}

bool has_glass(const Snapshot& scene) {
  for (const Raytracer::Instance& instance : scene.instances)
    if (scene.materials[instance.material].model == MaterialModel::glass) return true;
  return false;
}

}  // namespace

GlassEdges find_glass_edges(const Snapshot& scene, const MeterSet& meters, ThreadPool& pool) {
  constexpr int directions = 8;
  constexpr size_t most_asked = 65536;  // of more, so many stand for all
  if (meters.is_cell() || meters.disc_radius > 0 || !has_glass(scene)) return {};
  const size_t stride = (meters.count() + most_asked - 1) / most_asked;
  std::atomic<size_t> beside{0}, touching{0};
  parallel_for(pool, stride ? meters.count() / stride : 0, [&](size_t i) {
    const Meter& m = meters.meters[i * stride];
    if (touches_glass(scene, m.p, m.frame.n, m.error)) touching.fetch_add(1, std::memory_order_relaxed);
    const bool own = is_below_glass(scene, m.p, m.frame.n, m.error);
    for (int k = 0; k < directions; ++k) {
      const float phi = float(k) * (2 * pi / directions);
      const Vec3 p = m.p + (m.frame.s * std::cos(phi) + m.frame.t * std::sin(phi)) * edge_width;
      if (is_below_glass(scene, p, m.frame.n, m.error) == own) continue;
      beside.fetch_add(1, std::memory_order_relaxed);
      break;
    }
  });
  return {beside * stride, touching * stride};
}

}  // namespace ups
