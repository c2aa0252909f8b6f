// See footing.h.
#include "scene/footing.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "base/frame.h"
#include "base/rng.h"
#include "scene/emission_samples.h"
#include "scene/panes.h"

namespace ups {

namespace {

// Asked by emissive surfaces, too, before panes are known.
bool lets_light_by(const Snapshot& scene, const SurfacePoint& s) {
  const Material& m = scene.materials[s.material];
  return traits_of(m).transmits || scene.texturing[s.material].alpha_mode == SurfaceTexturing::blend ||
         (m.model == MaterialModel::glazing && scene.emitter_of_instance[s.instance] == none);
}

}  // namespace

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

bool lies_on_opaque(const Snapshot& scene, const Vec3& p, const Vec3& n, const Vec3& half_a, const Vec3& half_b) {
  const float reach = 0x1p-17f * scene.radius;
  int on = 0, all = 0;
  for (const float u : {-0.8f, 0.0f, 0.8f})
    for (const float v : {-0.8f, 0.0f, 0.8f}) {
      const Vec3 at = p + half_a * u + half_b * v;
      Hit hit;
      ++all;
      if (!(reach > 0) || !scene.raytracer->intersect(at + n * reach, -n, 2 * reach, hit)) continue;
      const SurfacePoint s = scene.raytracer->surface_at(hit);
      on += std::abs(reach - hit.t) <= free_error(at) + 2 * s.error && !lets_light_by(scene, s);
    }
  return 2 * on > all;
}

float least_source_lift(const Snapshot& scene) { return 16 * 0x1p-24f * 4 * scene.radius; }

Vec3 off_walls(const Snapshot& scene, const Vec3& p, const Frame& frame) {
  constexpr int directions = 8, passes = 2;  // in a corner the first wall hides the second
  const float reach = 0x1p-17f * scene.radius, error = free_error(p);
  Vec3 moved = p;
  for (int k = 0; k < passes * directions && reach > 0; ++k) {
    const float phi = float(k) * (2 * pi / directions);
    const Vec3 u = frame.s * std::cos(phi) + frame.t * std::sin(phi);
    Hit hit;
    if (!scene.raytracer->intersect(moved + frame.n * reach - u * reach, u, 2 * reach, hit)) continue;
    const SurfacePoint wall = scene.raytracer->surface_at(hit);
    const float height = dot(moved - wall.p, wall.ng), rounding = error + wall.error;
    if (std::abs(height) < 2 * rounding) moved = moved + wall.ng * (2 * rounding - height);
  }
  return moved;
}

namespace {

// A source on a plane: the shares of its light that leave to the front and to the back.
class Sides {
 public:
  Sides(const Snapshot& scene, const Emitter& emitter, const Vec3& p, const Vec3& n, float lift)
      : scene_(scene), emitter_(emitter), p_(p), n_(n), lift_(lift) {
    each([&](const Vec3&, bool behind, double flux) { flux_[behind] += flux; });
  }
  double share(bool behind) const {
    const double all = flux_[0] + flux_[1];
    return all > 0 ? flux_[behind] / all : 0.5;
  }

  // Nearly all of the light decides; else what it meets, as a lamp on a floor lights the room and not what is below it.
  // Between two rooms the front is meant.
  bool is_behind() const {
    constexpr double nearly_all = 0.9, more = 1.25, least = 0.15;
    for (const bool behind : {false, true})
      if (share(behind) >= nearly_all) return behind;
    double met[2] = {};
    // The inside of a slab or a plinth is no room: lengths are measured across the plane.
    const float narrow = std::min(1.0f, scene_.radius / 2);
    each([&](const Vec3& direction, bool behind, double flux) {
      // Beyond another wall that it lies on, too.
      const Vec3 origin = p_ + n_ * (behind ? -lift_ : lift_) + direction * (4 * lift_);
      Hit hit;
      if (!intersect_beyond_panes(scene_, origin, direction, hit)) return;
      if (std::abs(dot(scene_.raytracer->surface_at(hit).p - p_, n_)) > narrow) met[behind] += flux;
    });
    return met[1] > more * met[0] + least * flux_[1];
  }

 private:
  template <class Visit>
  void each(const Visit& visit) const {
    constexpr uint32_t count = 256;
    for (uint32_t i = 0; i < count; ++i) {
      const auto u = philox({i, 4, 0, 0}, {0, 0});
      const Vec2 direction((float(i) + 0.5f) / count, to_unit_float(u[0]));
      EmissionSample s;
      if (!emitter_.sample_emission({0.5f, 0.5f}, direction, s)) continue;
      visit(s.direction, dot(s.direction, n_) < 0, double(luminance(s.flux)));
    }
  }

  const Snapshot& scene_;
  const Emitter& emitter_;
  Vec3 p_, n_;
  float lift_;
  double flux_[2] = {};
};

}  // namespace

bool shines_behind(const Snapshot& scene, const Emitter& emitter, const Vec3& p, const Vec3& n, float lift) {
  return Sides(scene, emitter, p, n, lift).is_behind();
}

float room_for(const Snapshot& scene, const Vec3& p, const Vec3& u, float least, float lift) {
  Hit hit;
  const bool met = scene.raytracer->intersect(p + u * least, u, 2 * lift - least, hit);
  return met ? std::max(least, 0.5f * (least + hit.t)) : lift;
}

SourcePlace off_surfaces(const Snapshot& scene, const Vec3& p, const Emitter& emitter) {
  const float reach = 0x1p-17f * scene.radius, own = free_error(p);
  const float least_lift = least_source_lift(scene);
  SourcePlace out{p, 0};
  constexpr int lines = 6, passes = 2;  // a plane is crossed by one axis at least; what is met first may hide another
  for (int k = 0; k < lines * passes && reach > 0; ++k) {
    const float sign = k % 2 == 0 ? 1.0f : -1.0f;
    const Vec3 u(k / 2 % 3 == 0 ? sign : 0, k / 2 % 3 == 1 ? sign : 0, k / 2 % 3 == 2 ? sign : 0);
    Hit hit;
    if (!scene.raytracer->intersect(out.p - u * reach, u, 2 * reach, hit)) continue;
    const SurfacePoint s = scene.raytracer->surface_at(hit);
    const float height = dot(out.p - s.p, s.ng), rounding = own + s.error, lift = std::max(2 * rounding, least_lift);
    if (!(std::abs(height) < 0.95f * lift)) continue;  // 1: it has been moved off this one
    const Vec3 plane = out.p - s.ng * height;
    bool behind = height < 0;
    // Else it is off it by so little that it would be seen through it from far away.
    if (std::abs(height) < 1.9f * rounding) {
      const Sides sides(scene, emitter, plane, s.ng, 2 * rounding);
      // What lies on glass is outside.
      const bool glass = scene.materials[s.material].model == MaterialModel::glass;
      behind = glass ? scene.media.is_inside_out(s.instance) : sides.is_behind();
      if (!lets_light_by(scene, s)) out.into_surface = std::max(out.into_surface, float(sides.share(!behind)));
    }
    const Vec3 away = behind ? -s.ng : s.ng;
    out.p = plane + away * room_for(scene, plane, away, 2 * rounding, lift);
  }
  return out;
}

bool lies_in_another(const Snapshot& scene, const Emitter& emitter, uint32_t instance) {
  bool lies = false;
  each_emission(emitter, 64, 5, [&](const EmissionSample& s) {
    const float away = 64 * s.error / std::max(s.cos_0, 0.1f);
    Hit hit;
    if (!scene.raytracer->intersect(s.p + s.direction * away, -s.direction, 2 * away, hit) || hit.instance == instance)
      return true;
    const SurfacePoint other = scene.raytracer->surface_at(hit);
    lies = std::abs(dot(other.p - s.p, s.n)) <= 2 * (s.error + other.error) &&
           std::abs(dot(other.ng, s.n)) > 0.9999f && !lets_light_by(scene, other);
    return !lies;
  });
  return lies;
}

uint32_t starts_beyond(const Snapshot& scene, const Emitter& emitter, uint32_t instance) {
  constexpr uint32_t count = 64;
  std::map<uint32_t, uint32_t> beyond;
  each_emission(emitter, count, 7, [&](const EmissionSample& s) {
    // Slanting: which of two in the same plane is met is rounding's choice.
    const float away = 2 * s.error / std::max(s.cos_0, 0.25f);
    const Vec3 start = s.p + s.direction * away;
    Hit hit;
    if (!scene.raytracer->intersect(start, -s.direction, 1.5f * away, hit) || hit.instance == instance) return true;
    const SurfacePoint other = scene.raytracer->surface_at(hit);
    if (!(std::abs(dot(other.ng, s.n)) > 0.999f) || lets_light_by(scene, other)) return true;
    // What leaves the scene, as from under a box on the floor, or meets a slab's other face from within, lights nothing
    // that it should not.
    Hit lit;
    if (!intersect_beyond_panes(scene, start, s.direction, lit)) return true;
    const bool within = lit.instance == hit.instance && dot(scene.raytracer->surface_at(lit).ng, s.direction) > 0;
    if (!within) ++beyond[hit.instance];
    return true;
  });
  for (const auto& [other, samples] : beyond)
    if (10 * samples >= count) return other;
  return none;
}

}  // namespace ups
