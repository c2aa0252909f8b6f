// What both walks do alike: roulette, consistent sides, gates.
// Used by subpath.h and the techniques.
#pragma once
#include <algorithm>

#include "base/stop.h"
#include "transport/encounter.h"
#include "transport/plan.h"

namespace ups {

inline constexpr float min_cosine = 1e-6f;  // below it an edge is rejected by both walks (algorithm's grazing rule)

// Survival probability of Russian roulette: the throughput left relative to the path's start (of an eye path, to what its
// first surface leaves) times `reserve`, so that a path goes on for certain until it has lost all but 1 / reserve; never
// below 0.05, so that no path ends certainly and none lives long without light. Nearly lossless delta chains (light
// guides, facing mirrors) are exempt up to 64 edges; beyond, even an enclosure that absorbs nothing ends its paths:
// (64 / n)^1.5 of them live to n edges, 192 on the average. A constant share would leave guides of some hundred
// reflections to few paths of great weight.
inline float survival(const Rgb& now, const Rgb& start, float reserve, uint32_t edges, bool lossless_delta) {
  if (lossless_delta && edges < 64) return 1.0f;
  const float s = max_component(start);
  const float left = s > 0 ? reserve * max_component(now) / s : 1.0f;
  return std::clamp(left, 0.05f, edges < 64 ? 1.0f : 1 - 1.5f / float(edges));
}
// Measured, as CPU time x variance (tests/benchmarks/README.md): light paths are dear, as they are all stored and many.
inline constexpr float eye_reserve = 2, light_reserve = 1.5f;

// Shading and geometric normal agree on which side w lies.
inline bool consistent_side(const SurfacePoint& s, const Vec3& w, const Vec3& local) {
  const float g = dot(w, s.ng);
  return std::abs(g) > min_cosine && g * local.z > 0;
}

// How a vertex sees the choice of emitters, where w is on the side that it is lit from (or, of what transmits, any).
inline Receiver receiver_at(const SurfacePoint& s, const Vec3& w, const Bsdf& bsdf) {
  return {s.p, dot(w, s.ng) < 0 ? -s.ng : s.ng, bsdf.transmits_continuously()};
}

// Fades light out that grazes a surface whose shading normal leans towards it (Chiang, Li, Burley 2019, Taming the
// shadow terminator); a part of every continuous lobe, wi towards the light. Without it the flux that arrives by n_g
// and the light that is scattered by n_s have an unbounded ratio, and one photon can outshine a picture.
inline float terminator(const SurfacePoint& s, const Vec3& wi) {
  const float lean = std::abs(dot(wi, s.shading.n) * dot(s.ng, s.shading.n)), cos_g = std::abs(dot(wi, s.ng));
  if (cos_g >= lean) return 1;
  const float g = cos_g / lean;
  return g * (1 + g * (1 - g));
}

// Non-symmetry of shading normals in the light walk (Veach 1997, Eq. 5.19): wi towards the light, wo onwards;
// multiplies f |cos(wo, n_s)|.
inline float shading_correction(const SurfacePoint& s, const Vec3& wi, const Vec3& wo) {
  const float denominator = std::abs(dot(wi, s.ng) * dot(wo, s.shading.n));
  if (denominator <= 0) return 0;
  return std::abs(dot(wi, s.shading.n) * dot(wo, s.ng)) / denominator;
}

// Both, for a continuous lobe at a vertex of the light walk.
inline float light_correction(const SurfacePoint& s, const Vec3& wi, const Vec3& wo) {
  return terminator(s, wi) * shading_correction(s, wi, wo);
}

// Photons may be merged at a point: a function of the point alone, so that both walks know it. Sharp lobes are in:
// light that comes to them by way of mirrors and lenses from a small emitter is found by nothing else in reasonable
// time. So are black surfaces: what lights them can be measured.
inline bool merge_gate(const Bsdf& bsdf) { return bsdf.has_continuous() || !bsdf.has_delta(); }

// Photons are merged, and vertices perturbed, within one surface: normals that agree so far,
// and so flat within the radius.
inline constexpr float min_merge_cosine = 0.7f, max_merge_height = 0.1f;

// A blended surface may lie on another, whose photons are not its own. blends: the coverage there is below 1. material:
// read where it matters alone, as a light vertex has it in a line of the cache that merges need for nothing else.
inline bool merges_with(const Snapshot& scene, const SurfacePoint& own, const uint32_t& material, bool blends) {
  return !(blends || scene.panes.is_blended(own.instance)) || material == own.material;
}

// Long walks look up now and then whether they are still wanted.
inline bool is_stopped(const StopSignal& stop, uint32_t edges) {
  return edges % 64 == 0 && stop.is_set();
}

// The first point with a diffuse or glossy lobe along a ray, through mirrors and glass by their likelier lobe, and panes. Its
// distance along the chain; 0: none. `media`: at the start; `e`: what was met at its end, along `direction`. u decides
// whether a blended surface is seen.
inline float first_diffuse(const Snapshot& scene, Vec3 o, Vec3 d, MediaStack media, float u, Encounter& e,
                           Vec3& direction) {
  float distance = 0;
  WorkCounts work;
  PaneNumber number(u);
  for (int edges = 0; edges < 32; ++edges) {
    meet(scene, o, d, media, number, work, e, true);
    if (!e.found) return 0;
    distance += e.distance;
    direction = d;
    const Bsdf bsdf = e.bsdf(scene);
    if (merge_gate(bsdf)) return distance;
    BsdfSample next;
    if (!bsdf.sample(e.surface.shading.to_local(-d), 0.5f, {0.5f, 0.5f}, TransportMode::radiance, next)) return 0;
    d = e.surface.shading.to_world(next.wi);
    o = e.surface.ray_origin(d);
    media = e.beyond(d);
  }
  return 0;
}

inline Vec3 lifted(const Vec3& p, const Vec3& n, float error) { return p + n * (2 * error); }

// Where a light path that leaves an emitter starts: as high as lifted() but on its own line, as a source that is raised
// off its surface is a larger one; only what grazes leaves the line. A point (n = 0) is where it is.
inline Vec3 emission_origin(const Vec3& p, const Vec3& n, const Vec3& d, float error) {
  const float cosine = dot(n, d), along = dot(n, n) > 0 ? 2 * error / std::max(cosine, 0.25f) : 0;
  return p + d * along + n * (2 * error - along * cosine);
}

}  // namespace ups
