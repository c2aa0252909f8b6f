// See probe.h.
#include "scene/probe.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "base/frame.h"
#include "base/parallel.h"
#include "base/rng.h"
#include "base/warp.h"

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

bool lets_light_by(const Snapshot& scene, const SurfacePoint& s) {
  return scene.panes.is_crossed(s.instance) || traits_of(scene.materials[s.material]).transmits;
}

}  // namespace

SourcePlace off_surfaces(const Snapshot& scene, const Vec3& p, const Emitter& emitter) {
  const float reach = 0x1p-17f * scene.radius, own = free_error(p);
  // Shadow rays end this much before it at most, see segment_free (transport/encounter.h).
  const float least_lift = 16 * 0x1p-24f * 4 * scene.radius;
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
    if (std::abs(height) > 1.9f * rounding) {  // off it by so little that from far away it would be seen through it
      out.p = out.p + s.ng * (std::copysign(lift, height) - height);
      continue;
    }
    const Sides sides(scene, emitter, out.p - s.ng * height, s.ng, lift);
    // What lies on glass is outside.
    const bool glass = scene.materials[s.material].model == MaterialModel::glass,
               behind = glass ? scene.media.is_inside_out(s.instance) : sides.is_behind();
    out.p = out.p + s.ng * ((behind ? -lift : lift) - height);
    if (!lets_light_by(scene, s)) out.into_surface = std::max(out.into_surface, float(sides.share(!behind)));
  }
  return out;
}

bool lies_in_another(const Snapshot& scene, const Emitter& emitter, uint32_t instance) {
  constexpr uint32_t count = 64;
  for (uint32_t i = 0; i < count; ++i) {
    const auto u = philox({i, 5, 0, 0}, {0, 0});
    EmissionSample s;
    if (!emitter.sample_emission({(float(i) + 0.5f) / count, to_unit_float(u[0])},
                                 {to_unit_float(u[1]), to_unit_float(u[2])}, s))
      continue;
    const float away = 64 * s.error / std::max(s.cos_0, 0.1f);
    Hit hit;
    if (!scene.raytracer->intersect(s.p + s.direction * away, -s.direction, 2 * away, hit) || hit.instance == instance)
      continue;
    const SurfacePoint other = scene.raytracer->surface_at(hit);
    if (std::abs(dot(other.p - s.p, s.n)) <= 2 * (s.error + other.error) && std::abs(dot(other.ng, s.n)) > 0.9999f &&
        !lets_light_by(scene, other))
      return true;
  }
  return false;
}

std::vector<uint32_t> some_emitters(const EmitterSet& emitters, size_t most) {
  const size_t stride = (emitters.size() + most - 1) / most;
  const double strong = emitters.flux_lm() / double(most);
  std::vector<uint32_t> out;
  for (size_t i = 0; i < emitters.size(); ++i)
    if (i % stride == 0 || emitters[i].flux_lm() > strong) out.push_back(uint32_t(i));
  return out;
}

FirstLight first_light(const Snapshot& scene, const Emitter& emitter, uint32_t i) {
  const auto a = philox({i, 0, 0, 0}, {0, 0}), b = philox({i, 1, 0, 0}, {0, 0});
  FirstLight out;
  EmissionSample s;
  if (!emitter.sample_emission({to_unit_float(a[0]), to_unit_float(a[1])}, {to_unit_float(b[0]), to_unit_float(b[1])},
                               s))
    return out;
  out.flux = double(luminance(s.flux));
  out.intensity_cd = out.flux * double(s.pdf_direction_w);
  out.lift = length(s.n) * (2 * s.error);
  out.origin = s.p + s.n * (2 * s.error);
  out.direction = s.direction;
  Hit hit;
  out.hit = intersect_beyond_panes(scene, out.origin, s.direction, hit);
  if (out.hit) out.surface = scene.raytracer->surface_at(hit);
  return out;
}

namespace {

bool is_continuous(const Snapshot& scene, const SurfacePoint& s) {
  return Bsdf(scene.materials[s.material], s.uv).has_continuous();
}

}  // namespace

float exposed_share(const Snapshot& scene, const Emitter& emitter) {
  constexpr uint32_t rays = 1024;
  double total = 0, exposed = 0;
  for (uint32_t i = 0; i < rays; ++i) {
    const FirstLight light = first_light(scene, emitter, i);
    total += light.flux;
    // What meets nothing counts: a meter in the air may stand in its way.
    if (light.flux > 0 && (!light.hit || is_continuous(scene, light.surface))) exposed += light.flux;
  }
  return total > 0 ? float(exposed / total) : 1.0f;
}

namespace {

// Squared, how far light sees that scatters where it arrives; 0: it meets nothing. At a diffuser on the side where that
// is farther, as on the other it may see an emitter close by; the open is as far as the scene.
double reach2_from(const Snapshot& scene, const FirstLight& light, const Vec2& u) {
  const SurfacePoint& s = light.surface;
  const bool through = Bsdf(scene.materials[s.material], s.uv).transmits_continuously();
  const Vec3 lit = dot(light.direction, s.ng) < 0 ? s.ng : -s.ng;
  double farthest2 = 0;
  for (const Vec3& side : {lit, -lit}) {
    const Vec3 onwards = Frame(side).to_world(square_to_cosine_hemisphere(u));
    Hit hit;
    const bool met = intersect_blended(scene, s.ray_origin(onwards), onwards, hit);
    const double distance2 = met       ? double(length2(scene.raytracer->surface_at(hit).p - s.p))
                             : through ? double(scene.radius) * double(scene.radius)
                                       : 0;
    farthest2 = std::max(farthest2, distance2);
    if (!through) break;
  }
  return farthest2;
}

// What a flat mirror or pane makes of it, if that is what it meets first.
bool by_mirror(const Snapshot& scene, FirstLight& light) {
  Hit hit;
  if (!intersect_blended(scene, light.origin, light.direction, hit)) return false;
  const uint32_t plane = scene.flat_mirrors.plane_of(hit.instance, hit.primitive);
  if (plane == none) return false;
  light.direction = scene.flat_mirrors.planes[plane].mirrored_direction(light.direction);
  light.origin = scene.raytracer->surface_at(hit).ray_origin(light.direction);
  light.hit = intersect_beyond_panes(scene, light.origin, light.direction, hit);
  if (light.hit) light.surface = scene.raytracer->surface_at(hit);
  return light.hit;
}

// Directional light that a mirror reflects: of rays all over a scene few would meet it.
FirstLight light_by_plane(const Snapshot& scene, const Emitter& directional, const FlatMirrors::Plane& plane,
                          uint32_t i) {
  const auto u = philox({i, 3, 0, 0}, {0, 0});
  const auto within = [](uint32_t number, float half) { return half * (2 * to_unit_float(number) - 1); };
  const Vec3 at = plane.center + plane.s * within(u[0], plane.half_s) + plane.t * within(u[1], plane.half_t);
  DirectSample s;
  FirstLight out;
  if (!directional.sample_direct(at, {0.5f, 0.5f}, s)) return out;
  out.direction = -s.wi;
  out.origin = at + s.wi * s.distance;
  if (by_mirror(scene, out)) out.flux = 1;
  return out;
}

// trace(i): the light of an emitter. Pairs of points where it arrives that lie within some distance r of each other give
// the mean of E^2 over discs of that size: the largest over r, as long as there are pairs enough for a fifth's error. How
// far the patches see is told by one bounce more.
template <class Trace>
double concentration(const Snapshot& scene, uint32_t rays, const Trace& trace) {
  constexpr uint32_t least_pairs = 25;
  std::vector<Vec3> points;
  double reach2 = 0;
  uint32_t arrived = 0;
  for (uint32_t i = 0; i < rays; ++i) {
    const FirstLight light = trace(i);
    if (!(light.flux > 0) || !light.hit || !is_continuous(scene, light.surface)) continue;
    points.push_back(light.surface.p);
    const auto u = philox({i, 2, 0, 0}, {0, 0});
    const double d2 = reach2_from(scene, light, {to_unit_float(u[0]), to_unit_float(u[1])});
    if (!(d2 > 0)) continue;
    reach2 += d2;
    ++arrived;
  }
  reach2 = arrived > 0 ? reach2 / arrived : double(scene.radius) * double(scene.radius);
  constexpr int sizes = 16;
  double size2[sizes];
  for (int k = 0; k < sizes; ++k) size2[k] = std::ldexp(reach2, -2 * k);
  uint32_t within[sizes] = {};  // pairs closer than 2^-k of the reach
  for (size_t i = 0; i < points.size(); ++i)
    for (size_t j = 0; j < i; ++j) {
      const double d2 = double(length2(points[i] - points[j]));
      for (int k = 0; k < sizes && d2 < size2[k]; ++k) ++within[k];
    }
  double most = 0;
  for (int k = 0; k < sizes && within[k] >= least_pairs; ++k)  // area within reach 4 pi D^2, of a disc pi r^2
    most = std::max(most, within[k] / (0.5 * rays * rays) * std::ldexp(4.0, 2 * k));
  return most;
}

// By way of flat mirrors in which it has images.
double mirrored_concentration(const Snapshot& scene, uint32_t emitter, uint32_t rays) {
  const Emitter& e = scene.emitters[emitter];
  const FlatMirrors& mirrors = scene.flat_mirrors;
  if (!e.is_directional())
    return concentration(scene, rays, [&](uint32_t i) {
      FirstLight light = first_light(scene, e, i);
      if (!by_mirror(scene, light)) light.flux = 0;
      return light;
    });
  double most = 0;
  for (uint32_t plane = 0; plane < mirrors.planes.size(); ++plane)
    if (mirrors.image_of(emitter, plane) != none)
      most = std::max(most, concentration(scene, rays, [&](uint32_t i) {
                        return light_by_plane(scene, e, mirrors.planes[plane], i);
                      }));
  return most;
}

}  // namespace

float first_light_concentration(const Snapshot& scene, std::vector<EmitterProbe>& probes, ThreadPool& pool) {
  constexpr double least_share = 1e-4;  // of all flux
  constexpr size_t few = 64, most = 1024;
  const size_t count = scene.emitters.size();
  if (count == 0) return 0;
  const uint32_t rays = count > few ? 64 : 256;
  const double least_lm = std::min(least_share, 0.1 / double(count)) * scene.emitters.flux_lm();
  std::vector<uint32_t> looked_at = some_emitters(scene.emitters, most);
  looked_at.erase(std::remove_if(looked_at.begin(), looked_at.end(),
                                 [&](uint32_t e) { return !(scene.emitters[e].flux_lm() >= least_lm); }),
                  looked_at.end());
  std::vector<double> found(looked_at.size());
  parallel_for(pool, found.size(), [&](size_t i) {
    const Emitter& emitter = scene.emitters[looked_at[i]];
    EmitterProbe& probe = probes[looked_at[i]];
    if (probe.concentration_rays != rays) {
      probe.concentration = concentration(scene, rays, [&](uint32_t k) { return first_light(scene, emitter, k); });
      if (!scene.flat_mirrors.empty())
        probe.concentration =
            std::max(probe.concentration, mirrored_concentration(scene, looked_at[i], rays));
    }
    probe.concentration_rays = rays;
    found[i] = probe.concentration;
  });
  return found.empty() ? 0 : float(*std::max_element(found.begin(), found.end()));
}

}  // namespace ups
