// A Material at a surface point becomes a Bsdf; calls go to the model's functions by a switch. Also the classes of
// whole materials that the scene's analysis asks for.
#include "bsdf/material.h"

#include <cmath>
#include <type_traits>

#include "bsdf/fresnel.h"
#include "bsdf/microfacet.h"
#include "bsdf/models.h"

namespace ups {
namespace {

float unit(float x) { return std::isgreater(x, 0.0f) ? std::min(x, 1.0f) : 0.0f; }  // NaN: 0
Rgb unit(const Rgb& c) { return {unit(c.r), unit(c.g), unit(c.b)}; }

bool grazing(const Vec3& w) { return !(std::abs(w.z) >= min_cosine); }

bool is_interface_smooth(const Material& m, float alpha, float ior) {
  return m.model == MaterialModel::glass ? glass::is_smooth(alpha, ior) : alpha < min_alpha;
}

bool is_sharp(MaterialModel model, float alpha, float ior) {
  return (model == MaterialModel::glass ? glass::apparent_alpha(alpha, ior) : alpha) < default_glossy_alpha;
}
// An interface has most of the light; a plastic's, where it is metal for the most part.
bool is_mostly_interface(MaterialModel model, float metallic) {
  return is_interface_alone(model, metallic) || (model == MaterialModel::plastic && metallic >= 0.5f);
}

// With the denser side behind. As a function of its own inverse it brings a result back, too.
Vec3 turned(const BsdfParameters& p, const Vec3& w) { return p.flipped ? Vec3{w.x, w.y, -w.z} : w; }

inline Scattering evaluate_model(const BsdfParameters& p, const Vec3& wo, const Vec3& wi) {
  if (grazing(wo) || grazing(wi)) return {};
  switch (p.material->model) {
    case MaterialModel::matte:
    case MaterialModel::diffuser:
      return diffuse::evaluate(p, wo, wi);
    case MaterialModel::plastic:
    case MaterialModel::metal:
      return glossy::evaluate(p, wo, wi);
    case MaterialModel::glass:
      return glass::evaluate(p, turned(p, wo), turned(p, wi));
    case MaterialModel::glazing:
    case MaterialModel::mirror:
      break;
  }
  return {};
}

Sampled sample_model(const BsdfParameters& p, const Vec3& wo, float u_lobe, const Vec2& u, TransportMode mode,
                     BsdfSample& out) {
  switch (p.material->model) {
    case MaterialModel::matte:
    case MaterialModel::diffuser:
      return diffuse::sample(p, wo, u_lobe, u, out);
    case MaterialModel::plastic:
    case MaterialModel::metal:
      return glossy::sample(p, wo, u_lobe, u, out);
    case MaterialModel::glass: {
      const Sampled sampled = glass::sample(p, turned(p, wo), u_lobe, u, mode, out);
      out.wi = turned(p, out.wi);
      return sampled;
    }
    case MaterialModel::glazing:
      return glazing::sample(p, wo, u_lobe, out);
    case MaterialModel::mirror:
      return mirror::sample(p, wo, out);
  }
  return Sampled::none;
}

// Importance is carried unchanged through a refraction, radiance changes with n^2 (Veach 1997, 5.2).
float radiance_scale(const BsdfParameters& p, const Vec3& wo, const Vec3& wi, TransportMode mode) {
  if (mode != TransportMode::radiance || p.material->model != MaterialModel::glass || wo.z * wi.z > 0) return 1;
  const float n2 = p.ior * p.ior;
  return turned(p, wo).z > 0 ? 1 / n2 : n2;
}

// Which lobes there are, once all else is prepared: a vertex asks for it many times.
void find_lobes(BsdfParameters& p) {
  const MaterialModel model = p.material->model;
  const bool rough = p.alpha > 0;
  p.is_caster = rough && is_mostly_interface(model, p.metallic) && is_sharp(model, p.alpha, p.ior);
  switch (model) {
    case MaterialModel::matte:
    case MaterialModel::diffuser:
      p.transmits_continuously = !is_black(p.transmittance);
      p.min_alpha_continuous = is_black(p.reflectance) && is_black(p.transmittance) ? 0.0f : 1.0f;
      break;
    case MaterialModel::mirror:
      p.has_delta = !is_black(p.reflectance);
      break;
    case MaterialModel::glazing:
      p.has_delta = true;
      break;
    case MaterialModel::glass:
      p.has_delta = !rough;
      p.transmits_continuously = rough;
      p.min_alpha_continuous = p.alpha;
      break;
    case MaterialModel::plastic:
    case MaterialModel::metal: {
      const bool reflects = p.metallic > 0 || p.material->ior > 1;
      p.has_delta = !rough && reflects;
      p.min_alpha_continuous = rough && reflects ? p.alpha : is_black(p.base) ? 0.0f : 1.0f;
      break;
    }
  }
}

}  // namespace

void prepare_interface(Material& m) {
  if (m.model != MaterialModel::plastic && m.model != MaterialModel::metal) return;
  m.interface_albedo = InterfaceAlbedo(m.ior);
  if (glossy::has_complex_index(m)) m.conductor_average = fresnel_conductor_average(m.ior_rgb, m.ior_k_rgb);
  if (!m.roughness_texture) m.interface_albedo->set_alpha(Textured(m, {}, m.ior).alpha);
}

static_assert(std::is_trivially_copyable_v<Bsdf> && sizeof(Bsdf) <= 160);

Textured::Textured(const Material& m, const Vec2& uv, float relative_ior)
    : reflectance(unit(m.reflectance_texture ? m.reflectance * m.reflectance_texture->rgb(uv) : m.reflectance)) {
  if (m.model == MaterialModel::metal) metallic = 1;
  if (m.model == MaterialModel::plastic)
    metallic = unit(m.metallic_texture ? m.metallic * m.metallic_texture->first(uv) : m.metallic);
  else if (m.model != MaterialModel::metal && m.model != MaterialModel::glass)
    return;
  const float roughness = unit(m.roughness_texture ? m.roughness * m.roughness_texture->first(uv) : m.roughness);
  alpha = roughness * roughness;
  if (is_interface_smooth(m, alpha, relative_ior < 1 ? 1 / relative_ior : relative_ior)) alpha = 0;
}

Bsdf::Bsdf(const Material& m, float relative_ior, const Textured& textured) {
  p_.material = &m;
  p_.reflectance = textured.reflectance;
  p_.alpha = textured.alpha;
  p_.metallic = textured.metallic;
  switch (m.model) {
    case MaterialModel::matte:
    case MaterialModel::mirror:
    case MaterialModel::glazing:
      break;
    case MaterialModel::diffuser:
      p_.transmittance = unit(m.transmittance);
      break;
    case MaterialModel::plastic:
    case MaterialModel::metal:
      glossy::prepare(p_);
      break;
    case MaterialModel::glass:
      p_.flipped = relative_ior < 1;
      p_.ior = p_.flipped ? 1 / relative_ior : relative_ior;
      glass::prepare(p_);
      break;
  }
  find_lobes(p_);
}

Textured Bsdf::textured() const {
  Textured out;
  out.reflectance = p_.reflectance, out.alpha = p_.alpha, out.metallic = p_.metallic;
  return out;
}

Rgb base_colour(const Material& m, const Vec2& uv) {
  if (m.model == MaterialModel::glass || m.model == MaterialModel::glazing) return Rgb(1.0f);
  const Rgb reflectance = Textured(m, uv, m.ior).reflectance;
  if (m.model == MaterialModel::diffuser) return unit(reflectance + m.transmittance);
  if (m.model != MaterialModel::metal || is_black(m.ior_k_rgb)) return reflectance;
  const auto facing = [](float n, float k) { return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k); };
  return {facing(m.ior_rgb.r, m.ior_k_rgb.r), facing(m.ior_rgb.g, m.ior_k_rgb.g), facing(m.ior_rgb.b, m.ior_k_rgb.b)};
}

bool Bsdf::transmits() const {
  const Material& m = *p_.material;
  if (m.pane) return m.pane->transmits();
  return m.model == MaterialModel::glass || !is_black(m.model == MaterialModel::glazing ? m.transmittance
                                                                                       : p_.transmittance);
}

Scattering Bsdf::evaluate(const Vec3& wo, const Vec3& wi, TransportMode mode) const {
  Scattering s = evaluate_model(p_, wo, wi);
  if (p_.material->model == MaterialModel::glass) s.value *= radiance_scale(p_, wo, wi, mode);
  return s;
}

bool Bsdf::sample(const Vec3& wo, float u_lobe, const Vec2& u, TransportMode mode, BsdfSample& out) const {
  if (grazing(wo)) return false;
  const Sampled sampled = sample_model(p_, wo, u_lobe, u, mode, out);
  if (sampled != Sampled::direction) return sampled == Sampled::delta;
  const Vec3 wi = out.wi;
  const Scattering s = evaluate_model(p_, wo, wi);
  if (s.pdf <= 0) return false;  // a density that is no number makes a weight that is none, which the walks count
  out = {wi, s.value * (radiance_scale(p_, wo, wi, mode) / s.pdf), s.pdf, s.pdf_reverse};
  out.transmitted = wo.z * wi.z < 0;
  return true;
}

namespace {

bool tinted(const Rgb& c) { return c.r != c.g || c.r != c.b; }

// GGX alpha over all values of the roughness texture.
struct AlphaRange {
  float smallest, largest;
};
AlphaRange alpha_range(const Material& m) {
  const float largest = unit(m.roughness);
  const float smallest = m.roughness_texture ? largest * unit(m.roughness_texture->min_first()) : largest;
  return {smallest * smallest, largest * largest};
}

// The GGX lobe of a plastic, metal or glass.
void add_interface(const Material& m, MaterialTraits& t) {
  const AlphaRange alpha = alpha_range(m);
  t.delta = is_interface_smooth(m, alpha.smallest, m.ior);
  if (is_interface_smooth(m, alpha.largest, m.ior)) return;
  t.continuous = true;
  t.glossy = is_sharp(m.model, alpha.smallest, m.ior);
}

}  // namespace

MaterialTraits traits_of(const Material& m) {
  const bool reflects = !is_black(unit(m.reflectance)), diffuses = !is_black(unit(m.transmittance));
  const bool coloured =
      reflects && (tinted(m.reflectance) || (m.reflectance_texture && m.reflectance_texture->coloured()));
  const bool metallic = m.model == MaterialModel::metal || unit(m.metallic) > 0;
  MaterialTraits t{};
  switch (m.model) {
    case MaterialModel::matte:
      t.continuous = t.interreflects = reflects;
      t.coloured = coloured;
      break;
    case MaterialModel::diffuser:
      t.continuous = t.interreflects = reflects || diffuses;
      t.transmits = diffuses;
      t.coloured = coloured || tinted(unit(m.transmittance));
      break;
    case MaterialModel::mirror:
      t.delta = t.interreflects = reflects;
      t.coloured = coloured;
      break;
    case MaterialModel::glazing:
      // What it lets through goes straight on, which is no scattering.
      t.delta = t.interreflects = m.pane && m.pane->has_reflectance() ? m.pane->reflects() : m.ior > 1;
      t.transmits = m.pane ? m.pane->transmits() : !is_black(m.transmittance);
      t.coloured = !m.pane && tinted(m.transmittance);
      break;
    case MaterialModel::glass:
      add_interface(m, t);
      t.transmits = t.interreflects = true;
      t.coloured = tinted(m.absorption_per_m);
      break;
    case MaterialModel::plastic:
      if (metallic || m.ior > 1) add_interface(m, t);
      t.continuous = t.continuous || (reflects && (unit(m.metallic) < 1 || m.metallic_texture));
      t.interreflects = reflects || metallic || m.ior > 1;
      t.coloured = coloured;
      break;
    case MaterialModel::metal:
      add_interface(m, t);
      t.interreflects = true;
      t.coloured = glossy::has_complex_index(m) ? tinted(m.ior_rgb) || tinted(m.ior_k_rgb) : coloured;
      break;
  }
  t.caster = t.delta || (t.glossy && is_mostly_interface(m.model, unit(m.metallic)));
  return t;
}

GlossyParts glossy_parts(const Material& m, float below_alpha) {
  const bool continuous = traits_of(m).continuous;
  if (!continuous || !is_interface_alone(m.model, unit(m.metallic))) return {false, continuous};
  const AlphaRange alpha = alpha_range(m);
  const bool glossy = std::max(alpha.smallest, min_alpha) < below_alpha;
  const bool base = m.model == MaterialModel::plastic && m.metallic_texture;  // where it is not metal
  return {glossy, !glossy || alpha.largest >= below_alpha || base};
}

}  // namespace ups
