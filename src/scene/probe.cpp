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

double lamps_lm(const EmitterSet& emitters) {
  double sum = 0;
  for (size_t i = 0; i < emitters.size(); ++i) sum += emitters[i].is_directional() ? 0.0 : emitters[i].flux_lm();
  return sum;
}

std::vector<uint32_t> some_emitters(const EmitterSet& emitters, size_t most) {
  const size_t stride = (emitters.size() + most - 1) / most;
  const double strong = lamps_lm(emitters) / double(most);
  std::vector<uint32_t> out;
  for (size_t i = 0; i < emitters.size(); ++i)
    if (i % stride == 0 || (!emitters[i].is_directional() && emitters[i].flux_lm() > strong))
      out.push_back(uint32_t(i));
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
// is farther, as on the other it may see an emitter close by, and beyond further ones behind it, as of a frosted bulb in
// a shade; the open is as far as the scene.
double reach2_from(const Snapshot& scene, const FirstLight& light, const Vec2& u) {
  constexpr int most = 8;  // layers
  SurfacePoint s = light.surface;
  Vec3 direction = light.direction;
  double farthest2 = 0;
  for (int layer = 0; layer < most; ++layer) {
    const bool through = Bsdf(scene.materials[s.material], s.uv).transmits_continuously();
    if (layer > 0 && !through) break;
    const Vec3 lit = dot(direction, s.ng) < 0 ? s.ng : -s.ng;
    Hit hit;
    bool met = false;
    for (const Vec3& side : {lit, -lit}) {
      direction = Frame(side).to_world(square_to_cosine_hemisphere(u));
      met = intersect_blended(scene, s.ray_origin(direction), direction, hit);
      const double distance2 = met       ? double(length2(scene.raytracer->surface_at(hit).p - light.surface.p))
                               : through ? double(scene.radius) * double(scene.radius)
                                         : 0;
      farthest2 = std::max(farthest2, distance2);
      if (!through) break;
    }
    if (!met || !through) break;
    s = scene.raytracer->surface_at(hit);
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

// Directional light that a mirror reflects: of rays all over a scene few would meet it, and of those to a plane, where
// its mirrors are far apart.
FirstLight light_by_plane(const Snapshot& scene, const Emitter& directional, const FlatMirrors::Plane& plane,
                          uint32_t i) {
  constexpr uint32_t tries = 32;
  const auto within = [](uint32_t number, float half) { return half * (2 * to_unit_float(number) - 1); };
  FirstLight out;
  for (uint32_t k = 0; k < tries; ++k) {
    const auto u = philox({i, 3, k, 0}, {0, 0});
    const Vec3 at = plane.center + plane.s * within(u[0], plane.half_s) + plane.t * within(u[1], plane.half_t);
    DirectSample s;
    if (!directional.sample_direct(at, {0.5f, 0.5f}, s)) return out;
    out.direction = -s.wi;
    out.origin = at + s.wi * s.distance;
    if (by_mirror(scene, out)) {
      out.flux = 1;
      return out;
    }
  }
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
  const double least_lm = std::min(least_share, 0.1 / double(count)) * lamps_lm(scene.emitters);
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
