// The material models behind Bsdf, a namespace each, in a file each. Bsdf (material.cpp) chooses by the model and has
// already rejected directions that graze the surface.
//
// prepare()   fills the direction-independent parameters of a rough model.
// evaluate()  all continuous lobes at once: value (f |cos wi|, importance mode), density and reverse density.
// sample()    one of: Sampled::none; ::delta with the whole BsdfSample filled in; ::direction with only wi chosen, the
//             rest of which follows from evaluate().
#pragma once
#include "base/warp.h"
#include "bsdf/material.h"

namespace ups {

enum class Sampled { none, delta, direction };

namespace diffuse {  // matte, diffuser
inline float reflection_probability(const BsdfParameters& p) {
  if (is_black(p.transmittance)) return is_black(p.reflectance) ? 0.0f : 1.0f;
  const float r = luminance(p.reflectance), t = luminance(p.transmittance);
  return r + t > 0 ? r / (r + t) : 0.0f;
}
inline Scattering evaluate(const BsdfParameters& p, const Vec3& wo, const Vec3& wi) {  // inline: most are of these
  const bool reflected = wo.z * wi.z > 0;
  const Rgb& albedo = reflected ? p.reflectance : p.transmittance;
  if (is_black(albedo)) return {};
  const float r = reflection_probability(p), probability = reflected ? r : 1 - r;
  const float lambert = cosine_hemisphere_pdf(std::abs(wi.z));
  return {albedo * lambert, probability * lambert, probability * cosine_hemisphere_pdf(std::abs(wo.z))};
}
Sampled sample(const BsdfParameters& p, const Vec3& wo, float u_lobe, const Vec2& u, BsdfSample& out);
}  // namespace diffuse

namespace glossy {                          // plastic, metal, mixtures
bool has_complex_index(const Material& m);  // then reflectance is not used
void prepare(BsdfParameters& p);
Scattering evaluate(const BsdfParameters& p, const Vec3& wo, const Vec3& wi);
Sampled sample(const BsdfParameters& p, const Vec3& wo, float u_lobe, const Vec2& u, BsdfSample& out);
}  // namespace glossy

namespace glass {  // solid dielectric; wo.z > 0 is on the thin side
float apparent_alpha(float alpha, float ior);  // of what is let through
bool is_smooth(float alpha, float ior);
void prepare(BsdfParameters& p);
Scattering evaluate(const BsdfParameters& p, const Vec3& wo, const Vec3& wi);
Sampled sample(const BsdfParameters& p, const Vec3& wo, float u_lobe, const Vec2& u, TransportMode mode,
               BsdfSample& out);
}  // namespace glass

namespace glazing {  // thin panes; delta lobes alone
Sampled sample(const BsdfParameters& p, const Vec3& wo, float u_lobe, BsdfSample& out);
}  // namespace glazing

namespace mirror {
Sampled sample(const BsdfParameters& p, const Vec3& wo, BsdfSample& out);
}  // namespace mirror

// A number uniform in [low, high) again uniform in [0, 1).
inline float stretch(float u, float low, float high) {
  return high > low ? std::clamp((u - low) / (high - low), 0.0f, 0x1.fffffep-1f) : 0.0f;
}

// A delta lobe that stays on its side and goes on at the same angle.
inline Sampled mirrored(const Vec3& wo, const Rgb& weight, float probability, BsdfSample& out) {
  out = {};
  out.wi = {-wo.x, -wo.y, wo.z};
  out.weight = weight;
  out.pdf = out.pdf_reverse = probability;
  out.delta = true;
  return is_black(weight) ? Sampled::none : Sampled::delta;
}

}  // namespace ups
