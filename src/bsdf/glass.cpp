// Solid dielectrics: smooth (delta reflection and refraction by Fresnel and Snell) and rough (Walter et al. 2007),
// which gets back the light that single scattering loses. Absorption belongs to the medium, not to the surface.
//
// Rough transmission shadows both directions independently, as Walter does. Missing light (bsdf/albedo.h) leaves by a
// lobe on either side. Shares of both sides must balance for reciprocity: (1 - r_out) M_out = n^2 (1 - r_in) M_in with
// the mean missing albedos M; diffuse light crosses a smooth interface in just this proportion where M_out = M_in.
#include "bsdf/albedo.h"
#include "bsdf/fresnel.h"
#include "bsdf/microfacet.h"
#include "bsdf/models.h"

namespace ups::glass {

// Refraction spreads an angle of alpha over about alpha (ior - 1); below min_alpha it cannot be told from a delta lobe.
float apparent_alpha(float alpha, float ior) { return alpha * std::min(1.0f, 2 * (ior - 1)); }
bool is_smooth(float alpha, float ior) { return apparent_alpha(alpha, ior) < min_alpha; }

void prepare(BsdfParameters& p) {
  if (!(p.alpha > 0)) return;
  const float ior = p.ior, outside = dielectric_missing_average(p.alpha, ior, false);
  const float inside = dielectric_missing_average(p.alpha, ior, true);
  const float crossing = 1 - diffuse_fresnel_reflectance(ior);  // from outside; from inside 1 / ior^2 of it
  p.missing_norm[0] = 1 / (pi * outside);
  p.missing_norm[1] = 1 / (pi * inside);
  p.missing_reflected[0] = 1 - crossing * std::min(1.0f, inside / outside);
  p.missing_reflected[1] = 1 - crossing / (ior * ior) * std::min(1.0f, outside / inside);
}

Scattering evaluate(const BsdfParameters& p, const Vec3& wo_, const Vec3& wi_) {
  if (!(p.alpha > 0)) return {};
  const float ior = p.ior, alpha = p.alpha, sign = wo_.z > 0 ? 1.0f : -1.0f;
  const bool inside_o = wo_.z < 0, inside_i = wi_.z < 0, reflected = inside_o == inside_i;
  const float eta = reflected ? 1.0f : inside_o ? 1 / ior : ior;  // n_i / n_o
  const float cos_o = std::abs(wo_.z), cos_i = std::abs(wi_.z);
  const Vec3 wo{wo_.x, wo_.y, cos_o}, wi{wi_.x, wi_.y, sign * wi_.z};

  const float missing_o = dielectric_missing(cos_o, alpha, ior, inside_o);
  const float missing_i = dielectric_missing(cos_i, alpha, ior, inside_i);
  const auto stays = [&](bool inside) { return p.missing_reflected[inside]; };
  const float share_o = reflected ? stays(inside_o) : 1 - stays(inside_o);
  const float share_i = reflected ? stays(inside_i) : 1 - stays(inside_i);
  float value = missing_o * missing_i * share_o * p.missing_norm[inside_i] * cos_i;
  Scattering s;
  s.pdf = missing_o * share_o * missing_lobe_pdf(cos_i, alpha);
  s.pdf_reverse = missing_i * share_i * missing_lobe_pdf(cos_o, alpha);

  // Microfacet normal: along wo + wi for reflection, wo + eta wi for refraction (Walter et al. 2007, eq. 13 and 16).
  const Vec3 sum = wo + wi * eta;
  const float length_squared = length2(sum);
  if (length_squared > 0) {
    Vec3 h = sum / std::sqrt(length_squared);
    if (h.z < 0) h = -h;
    const float o_h = dot(wo, h), i_h = dot(wi, h);
    // Across the interface from the thin side, where it is well conditioned, so that both ways agree.
    const float fresnel = reflected ? fresnel_dielectric(std::min(1.0f, o_h), inside_o ? 1 / ior : ior)
                                    : fresnel_dielectric(std::min(1.0f, inside_o ? -i_h : o_h), ior);
    const float density = ggx_density(h, alpha);
    const float g_o = smith_g1_over_cosine(wo, alpha), g_i = smith_g1_over_cosine(wi, alpha);
    if (reflected && o_h > 0) {
      value += fresnel * density * smith_visibility(wo, wi, alpha) * cos_i;
      s.pdf += (1 - missing_o) * fresnel * 0.25f * density * g_o;
      s.pdf_reverse += (1 - missing_i) * fresnel * 0.25f * density * g_i;
    } else if (!reflected && o_h > 0 && i_h < 0) {
      const float common = (1 - fresnel) * density * o_h * -i_h / length_squared;
      value += common * eta * eta * g_o * g_i * cos_i;
      s.pdf += (1 - missing_o) * common * eta * eta * g_o;
      s.pdf_reverse += (1 - missing_i) * common * g_i;
    }
  }
  s.value = Rgb(value);
  return s;
}

namespace {

Sampled sample_smooth(const BsdfParameters& p, const Vec3& wo, float u_lobe, TransportMode mode, BsdfSample& out) {
  const float eta = wo.z > 0 ? p.ior : 1 / p.ior, cos_o = std::abs(wo.z);
  const float fresnel = fresnel_dielectric(cos_o, eta);
  if (u_lobe < fresnel) return mirrored(wo, Rgb(1.0f), fresnel, out);
  const float cos_i = refracted_cosine(cos_o, eta);
  if (!(cos_i > min_cosine)) return Sampled::none;
  out = {};
  out.wi = normalize(Vec3{-wo.x / eta, -wo.y / eta, wo.z > 0 ? -cos_i : cos_i});
  out.weight = Rgb(mode == TransportMode::radiance ? 1 / (eta * eta) : 1.0f);
  out.pdf = out.pdf_reverse = 1 - fresnel;
  out.delta = out.transmitted = true;
  out.delta_jacobian = cos_o / (eta * eta * cos_i);
  return Sampled::delta;
}

// Relative to wo's side: z > 0 there.
bool sample_rough(const BsdfParameters& p, const Vec3& wo, bool inside, float u_lobe, const Vec2& u, Vec3& wi) {
  const float ior = p.ior, missing = dielectric_missing(wo.z, p.alpha, ior, inside);
  if (u_lobe < missing) {
    wi = sample_missing_lobe(p.alpha, u);
    if (stretch(u_lobe, 0, missing) >= p.missing_reflected[inside]) wi.z = -wi.z;
    return true;
  }
  const Vec3 h = sample_visible_normal(wo, p.alpha, u);
  const float cos_h = dot(wo, h), eta = inside ? 1 / ior : ior;
  if (!(cos_h > 0)) return false;
  if (stretch(u_lobe, missing, 1) < fresnel_dielectric(std::min(1.0f, cos_h), eta)) {
    wi = reflect(wo, h);
    return wi.z > 0;
  }
  if (!refract(wo, h, eta, refracted_cosine(cos_h, eta), wi)) return false;
  wi = normalize(wi);
  return wi.z < 0;
}

}  // namespace

Sampled sample(const BsdfParameters& p, const Vec3& wo, float u_lobe, const Vec2& u, TransportMode mode,
               BsdfSample& out) {
  if (!(p.alpha > 0)) return sample_smooth(p, wo, u_lobe, mode, out);
  const bool inside = wo.z < 0;
  if (!sample_rough(p, {wo.x, wo.y, std::abs(wo.z)}, inside, u_lobe, u, out.wi)) return Sampled::none;
  if (inside) out.wi.z = -out.wi.z;
  return Sampled::direction;
}

}  // namespace ups::glass
