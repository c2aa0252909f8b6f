// Lambertian surfaces: matte (reflects) and diffuser (reflects and transmits), alike on both sides.
#include "base/warp.h"
#include "bsdf/models.h"

namespace ups::diffuse {
namespace {

float reflection_probability(const BsdfParameters& p) {
  if (is_black(p.transmittance)) return is_black(p.reflectance) ? 0.0f : 1.0f;
  const float r = luminance(p.reflectance), t = luminance(p.transmittance);
  return r + t > 0 ? r / (r + t) : 0.0f;
}

}  // namespace

Scattering evaluate(const BsdfParameters& p, const Vec3& wo, const Vec3& wi) {
  const bool reflected = wo.z * wi.z > 0;
  const Rgb& albedo = reflected ? p.reflectance : p.transmittance;
  if (is_black(albedo)) return {};
  const float r = reflection_probability(p), probability = reflected ? r : 1 - r;
  const float lambert = cosine_hemisphere_pdf(std::abs(wi.z));
  return {albedo * lambert, probability * lambert, probability * cosine_hemisphere_pdf(std::abs(wo.z))};
}

Sampled sample(const BsdfParameters& p, const Vec3& wo, float u_lobe, const Vec2& u, BsdfSample& out) {
  const bool reflected = u_lobe < reflection_probability(p);
  if (is_black(reflected ? p.reflectance : p.transmittance)) return Sampled::none;
  out.wi = square_to_cosine_hemisphere(u);
  if ((wo.z > 0) != reflected) out.wi.z = -out.wi.z;
  return Sampled::direction;
}

}  // namespace ups::diffuse
