// The GGX distribution of microfacet normals (Trowbridge, Reitz 1975; Walter et al. 2007) with Smith shadowing, and
// sampling of the normals visible from a direction. Used by all rough models and by the albedo tables.
// Here `wo`, `wi` and `h` are local; z is the macroscopic normal, and h.z > 0.
#pragma once
#include "base/vec.h"

namespace ups {

// Nothing is scattered to or from directions closer to the surface than this.
inline constexpr float min_cosine = 1e-6f;

// From the components that are small near the normal, not from 1 - cos^2: exact for sharp lobes.
inline float ggx_density(const Vec3& h, float alpha) {
  const float a2 = alpha * alpha, q = a2 * h.z * h.z + h.x * h.x + h.y * h.y;
  return q > 0 ? a2 / (pi * q * q) : 0.0f;
}

// cos * sqrt(1 + alpha^2 tan^2): everything of Smith's shadowing that depends on one direction. Lambda is
// (this / |cos| - 1) / 2 (Heitz 2014, eq. 72).
inline float smith_root(const Vec3& w, float alpha) {
  return std::sqrt(alpha * alpha * (w.x * w.x + w.y * w.y) + w.z * w.z);
}
// G1 / |cos|, which stays finite at grazing incidence.
inline float smith_g1_over_cosine(const Vec3& w, float alpha) { return 2 / (std::abs(w.z) + smith_root(w, alpha)); }
// G2 / (4 |cos_o| |cos_i|) with height-correlated shadowing, both directions on one side (Heitz 2014, eq. 99).
inline float smith_visibility(const Vec3& wo, const Vec3& wi, float alpha) {
  const float cos_o = std::abs(wo.z), cos_i = std::abs(wi.z);
  return 0.5f / (cos_o * smith_root(wi, alpha) + cos_i * smith_root(wo, alpha));
}

// A microfacet normal as seen from wo, wo.z > 0, with density G1(wo) |wo.h| D(h) / wo.z (Dupuy, Benyoub 2023).
inline Vec3 sample_visible_normal(const Vec3& wo, float alpha, const Vec2& u) {
  const Vec3 v = normalize(Vec3{alpha * wo.x, alpha * wo.y, wo.z});
  const float drop = u.y * (1 + v.z);  // 1 - z of a point of the spherical cap
  const float sine = std::sqrt(std::max(0.0f, drop * (2 - drop))), phi = 2 * pi * u.x;
  const Vec3 h{v.x + sine * std::cos(phi), v.y + sine * std::sin(phi), v.z + (1 - drop)};
  // h.z >= 0; it is 0 at most for a facet seen edge-on from below the horizon
  const Vec3 normal{alpha * h.x, alpha * h.y, std::max(h.z, 1e-12f)};
  return normalize(normal);
}

inline Vec3 reflect(const Vec3& w, const Vec3& h) { return h * (2 * dot(w, h)) - w; }

// w refracted at the interface of normal h (on w's side) with eta = n_t / n_i; false under total internal reflection.
inline bool refract(const Vec3& w, const Vec3& h, float eta, float cos_t, Vec3& out) {
  if (!(cos_t > 0)) return false;
  out = (h * dot(w, h) - w) / eta - h * cos_t;
  return true;
}

}  // namespace ups
