// What both walks do alike: roulette, media, visibility, consistent sides, gates.
// Used by the light pass and the eye pass.
#pragma once
#include <algorithm>
#include <limits>

#include "base/stop.h"
#include "scene/snapshot.h"
#include "transport/plan.h"
#include "transport/tally.h"

namespace ups {

inline constexpr float min_cosine = 1e-6f;  // below it an edge is rejected by both walks (algorithm's grazing rule)

// Survival probability: one before 4 edges; then the throughput left relative to its start, never below 0.05, so that
// no path ends certainly and none lives long without light. Nearly lossless delta chains (light guides, facing mirrors)
// are exempt up to 64 edges; beyond, even an enclosure that absorbs nothing ends its paths.
inline float survival(const Rgb& now, const Rgb& start, uint32_t edges, bool lossless_delta) {
  if (edges < 4 || (lossless_delta && edges < 64)) return 1.0f;
  const float s = max_component(start);
  return std::clamp(s > 0 ? max_component(now) / s : 1.0f, 0.05f, edges < 64 ? 1.0f : 0.95f);
}

// Shading and geometric normal agree on which side w lies.
inline bool consistent_side(const SurfacePoint& s, const Vec3& w, const Vec3& local) {
  const float g = dot(w, s.ng);
  return std::abs(g) > min_cosine && g * local.z > 0;
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

// The solid dielectric that an edge runs in. The surface at its end knows best: its back is inside. `walk` is what the
// walk believes.
inline uint32_t medium_of_edge(const Snapshot& scene, uint32_t walk, const SurfacePoint* end, const Vec3& d) {
  if (!end || scene.materials[end->material].model != MaterialModel::glass) return walk;
  if (dot(d, end->ng) > 0) return end->material;
  return walk == end->material ? none : walk;
}
// After the surface: behind a solid dielectric is its inside.
inline uint32_t medium_beyond(const Snapshot& scene, const SurfacePoint& s, uint32_t walk, const Vec3& w) {
  if (scene.materials[s.material].model != MaterialModel::glass) return walk;
  return dot(w, s.ng) < 0 ? s.material : none;
}
inline Rgb attenuation(const Snapshot& scene, uint32_t medium, float distance) {
  if (medium == none) return Rgb(1.0f);
  return exp(scene.materials[medium].absorption_per_m * -distance);
}

inline bool segment_free(const Snapshot& scene, const Vec3& a, const Vec3& b, WorkCounts& work) {
  const Vec3 d = b - a;
  const float l = length(d);
  if (!(l > 0)) return true;
  ++work.rays;
  // The rounding of origin, direction and length moves the end along, however exact the end's own coordinates are: a
  // small surface in the middle of the scene must not hide its own points from what is far away.
  const float rounding = 16 * 0x1p-24f * (max_abs(a) + l);
  return !(l > rounding) || !scene.raytracer->occluded(a, d / l, l - rounding);
}

// Photons may be merged at a point: a function of the point alone, so that both walks know it. Sharp lobes are in:
// light that comes to them by way of mirrors and lenses from a small emitter is found by nothing else in reasonable
// time. So are black surfaces: what lights them can be measured.
inline bool merge_gate(const Bsdf& bsdf) { return bsdf.has_continuous() || !bsdf.has_delta(); }

// Photons are merged, and vertices perturbed, within one surface: normals that agree so far,
// and so flat within the radius.
inline constexpr float min_merge_cosine = 0.7f, max_merge_height = 0.1f;

// Long walks look up now and then whether they are still wanted.
inline bool is_stopped(const StopSignal& stop, uint32_t edges) {
  return edges % 64 == 0 && stop.is_set();
}

// The first point with a diffuse or glossy lobe along a ray, through mirrors and glass by their likelier lobe. Its
// distance along the chain; 0: none. `medium`: at the start; becomes the one in front of the point.
inline float first_diffuse(const Snapshot& scene, Vec3 o, Vec3 d, uint32_t& medium, SurfacePoint& s, Vec3& direction) {
  float distance = 0;
  for (int edges = 0; edges < 32; ++edges) {
    Hit hit;
    if (!scene.raytracer->intersect(o, d, std::numeric_limits<float>::infinity(), hit)) return 0;
    s = scene.raytracer->surface_at(hit);
    distance += hit.t;
    direction = d;
    medium = medium_of_edge(scene, medium, &s, d);
    const Bsdf bsdf(scene.materials[s.material], s.uv);
    if (merge_gate(bsdf)) return distance;
    BsdfSample next;
    if (!bsdf.sample(s.shading.to_local(-d), 0.5f, {0.5f, 0.5f}, TransportMode::radiance, next)) return 0;
    d = s.shading.to_world(next.wi);
    o = s.ray_origin(d);
    medium = medium_beyond(scene, s, medium, d);
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
