// Plastic and metal, which are alike but for their Fresnel reflectance: one GGX lobe, and under a plastic's coat a
// diffuse base. `metallic` mixes both (glTF 2.0, appendix B).
//
// Energy: what the coat does not reflect reaches the base, so base * (1 - A(wo)) (1 - A(wi)) / (pi (1 - mean A)) with
// the coat's albedo A (Kelemen, Szirmay-Kalos 2001) is reciprocal and conserves energy: a base of reflectance 1 returns
// all light. Metal gets back what single scattering loses, coloured by repeated reflection (Kulla, Conty 2017).
#include "base/warp.h"
#include "bsdf/albedo.h"
#include "bsdf/fresnel.h"
#include "bsdf/microfacet.h"
#include "bsdf/models.h"

namespace ups::glossy {

bool has_complex_index(const Material& m) { return m.model == MaterialModel::metal && max_component(m.ior_k_rgb) > 0; }

namespace {

Rgb metal_fresnel(const BsdfParameters& p, float cos_h) {
  const Material& m = *p.material;
  return has_complex_index(m) ? fresnel_conductor(cos_h, m.ior_rgb, m.ior_k_rgb)
                              : fresnel_schlick(cos_h, p.reflectance);
}

Rgb interface_fresnel(const BsdfParameters& p, float cos_h) {
  Rgb f{0.0f};
  if (p.metallic > 0) f += metal_fresnel(p, cos_h) * p.metallic;
  if (p.metallic < 1) f += Rgb(fresnel_dielectric(cos_h, p.material->ior) * (1 - p.metallic));
  return f;
}

// Light repeatedly reflected before it leaves: the share of the missing light that is not absorbed.
float repeated(float fresnel, float missing) { return fresnel * fresnel * (1 - missing) / (1 - fresnel * missing); }

Division divide(const BsdfParameters& p, float mu) {
  Division d;
  d.mu = mu;
  float interface_albedo = 0;
  if (p.metallic < 1) {
    const float coat = p.interface_albedo.coat(mu);
    d.base = 1 - coat;
    interface_albedo += (1 - p.metallic) * coat;
  }
  if (p.metallic > 0) {
    d.missing = p.interface_albedo.missing(mu);
    interface_albedo += p.metallic * luminance(metal_fresnel(p, mu)) * (1 - d.missing);
  }
  const float base = luminance(p.base) * d.base, missing = luminance(p.multiple) * d.missing;
  const float total = interface_albedo + base + missing;
  if (!(total > 0)) return d;
  d.p_base = base / total;
  d.p_missing = missing / total;
  d.p_interface = std::max(0.0f, 1 - d.p_base - d.p_missing);
  if (!(interface_albedo > 0)) d.p_interface = 0;
  return d;
}
// The same of the direction that a vertex was reached from.
const Division& divide_again(const BsdfParameters& p, float mu) {
  if (p.division.mu != mu) p.division = divide(p, mu);
  return p.division;
}

}  // namespace

void prepare(BsdfParameters& p) {
  const Material& m = *p.material;
  p.interface_albedo = m.interface_albedo ? *m.interface_albedo : InterfaceAlbedo(m.ior);
  if (!m.interface_albedo || m.roughness_texture) p.interface_albedo.set_alpha(p.alpha);
  if (p.metallic < 1) {
    p.base = p.reflectance * (1 - p.metallic);
    p.base_norm = 1 / (pi * std::max(1e-6f, 1 - p.interface_albedo.coat_average()));
  }
  if (p.metallic > 0 && p.alpha > 0) {
    const Rgb f = !has_complex_index(m)  ? fresnel_schlick_average(p.reflectance)
                  : m.interface_albedo ? m.conductor_average
                                       : fresnel_conductor_average(m.ior_rgb, m.ior_k_rgb);
    const float missing = p.interface_albedo.missing_average();
    p.multiple = Rgb{repeated(f.r, missing), repeated(f.g, missing), repeated(f.b, missing)} * p.metallic;
    p.missing_norm[0] = 1 / (pi * missing);
  }
}

Scattering evaluate(const BsdfParameters& p, const Vec3& wo_, const Vec3& wi_) {
  if (!(wo_.z * wi_.z > 0)) return {};
  const Vec3 wo{wo_.x, wo_.y, std::abs(wo_.z)}, wi{wi_.x, wi_.y, std::abs(wi_.z)};
  const Division &from = divide_again(p, wo.z), to = divide(p, wi.z);
  Scattering s;
  s.value = p.base * (from.base * to.base * p.base_norm * wi.z) +
            p.multiple * (from.missing * to.missing * p.missing_norm[0] * wi.z);
  s.pdf = from.p_base * cosine_hemisphere_pdf(wi.z);
  s.pdf_reverse = to.p_base * cosine_hemisphere_pdf(wo.z);
  if (!(p.alpha > 0)) return s;
  if (p.metallic > 0) {
    s.pdf += from.p_missing * p.interface_albedo.missing_lobe_pdf(wi.z);
    s.pdf_reverse += to.p_missing * p.interface_albedo.missing_lobe_pdf(wo.z);
  }
  const Vec3 h = normalize(wo + wi);
  const float density = ggx_density(h, p.alpha), cos_h = std::min(1.0f, std::abs(dot(wo, h)));
  s.value += interface_fresnel(p, cos_h) * (density * smith_visibility(wo, wi, p.alpha) * wi.z);
  s.pdf += from.p_interface * 0.25f * density * smith_g1_over_cosine(wo, p.alpha);
  s.pdf_reverse += to.p_interface * 0.25f * density * smith_g1_over_cosine(wi, p.alpha);
  return s;
}

Sampled sample(const BsdfParameters& p, const Vec3& wo_, float u_lobe, const Vec2& u, BsdfSample& out) {
  const Vec3 wo{wo_.x, wo_.y, std::abs(wo_.z)};
  const Division& from = divide_again(p, wo.z);
  if (u_lobe < from.p_base) {
    out.wi = square_to_cosine_hemisphere(u);
  } else if (u_lobe < from.p_base + from.p_missing) {
    out.wi = sample_missing_lobe(p.alpha, u);
  } else {
    if (!(from.p_interface > 0)) return Sampled::none;
    if (!(p.alpha > 0)) return mirrored(wo_, interface_fresnel(p, wo.z) / from.p_interface, from.p_interface, out);
    out.wi = reflect(wo, sample_visible_normal(wo, p.alpha, u));
    if (!(out.wi.z > 0)) return Sampled::none;
  }
  if (wo_.z < 0) out.wi.z = -out.wi.z;
  return Sampled::direction;
}

}  // namespace ups::glossy
