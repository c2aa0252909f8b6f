// See probe.h.
#include "scene/probe.h"

#include <limits>

#include "base/rng.h"

namespace ups {

float error_at(const Snapshot& scene, const Vec3& p, const Vec3& n) {
  const float own = free_error(p);
  const float reach = 0x1p-17f * scene.radius;  // no surface point's error is larger
  Hit hit;
  if (!(reach > 0) || !scene.raytracer->intersect(p + n * reach, -n, 2 * reach, hit)) return own;
  const SurfacePoint s = scene.raytracer->surface_at(hit);
  const float distance = std::abs(reach - hit.t);
  return distance <= own + 2 * s.error ? own + distance + s.error : own;
}

float error_at(const Snapshot& scene, const Vec3& p, const Vec3& n, const Vec3& half_a, const Vec3& half_b) {
  float error = error_at(scene, p, n);
  for (const Vec3& corner : {p + half_a + half_b, p + half_a - half_b, p - half_a + half_b, p - half_a - half_b})
    error = std::max(error, error_at(scene, corner, n));
  return error;
}

Vec3 off_surface(const Snapshot& scene, const Vec3& p, const Vec3& n) {
  const float error = error_at(scene, p, n);
  return error > free_error(p) ? p + n * (2 * error) : p;
}

uint32_t medium_at(const Snapshot& scene, Vec3 p) {
  const Vec3 d = normalize(Vec3(0.0123f, 0.0071f, 1.0f));  // along no wall
  Hit hit;
  for (int crossings = 0; crossings < 10'000; ++crossings) {
    if (!scene.raytracer->intersect(p, d, INFINITY, hit)) return none;
    const SurfacePoint s = scene.raytracer->surface_at(hit);
    if (scene.materials[s.material].model == MaterialModel::glass) return dot(d, s.ng) > 0 ? s.material : none;
    p = s.ray_origin(d);
  }
  return none;
}

float exposed_share(const Snapshot& scene, const Emitter& emitter) {
  constexpr uint32_t rays = 1024;
  double total = 0, exposed = 0;
  for (uint32_t i = 0; i < rays; ++i) {
    const auto a = philox({i, 0, 0, 0}, {0, 0}), b = philox({i, 1, 0, 0}, {0, 0});
    EmissionSample s;
    if (!emitter.sample_emission({to_unit_float(a[0]), to_unit_float(a[1])}, {to_unit_float(b[0]), to_unit_float(b[1])}, s))
      continue;
    const double flux = luminance(s.flux);
    total += flux;
    Hit hit;
    if (!scene.raytracer->intersect(s.p + s.n * (2 * s.error), s.direction, std::numeric_limits<float>::infinity(), hit)) {
      exposed += flux;  // a meter in the air may stand in its way
      continue;
    }
    const SurfacePoint surface = scene.raytracer->surface_at(hit);
    if (Bsdf(scene.materials[surface.material], surface.uv).has_continuous()) exposed += flux;
  }
  return total > 0 ? float(exposed / total) : 1.0f;
}

}  // namespace ups
