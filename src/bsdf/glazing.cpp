// Thin panes of glass and ideal mirrors: materials of delta lobes alone, alike on both sides. A pane reflects and lets
// pass straight on, with all reflections between its two faces; it is not resolved as a solid.
#include "bsdf/fresnel.h"
#include "bsdf/models.h"

namespace ups {
namespace {

// T = (1 - F)^2 a / (1 - F^2 a^2) at normal incidence, solved for a without cancellation. At most 1: no pane of this
// index transmits more.
float internal_transmittance(float transmittance, float ior) {
  if (transmittance < 0) return 1;
  const float f = normal_reflectance(ior), pass = (1 - f) * (1 - f);
  const float root = std::sqrt(pass * pass + 4 * transmittance * transmittance * f * f);
  return std::min(1.0f, 2 * transmittance / (pass + root));
}

struct Pane {
  float reflectance, transmittance;
};
// Geometric series of the reflections between both faces, for each polarisation: they do not mix in the pane.
Pane pane(const PolarisedReflectance& face, float passage) {
  const auto one = [passage](float f) -> Pane {
    const float inner = f * passage, denominator = (1 - inner) * (1 + inner);
    if (!(denominator > 0)) return {1, 0};  // total reflection at the first face
    const float t = (1 - f) * (1 - f) * passage / denominator;
    return {f + inner * t, t};
  };
  const Pane s = one(face.s), p = one(face.p);
  return {0.5f * (s.reflectance + p.reflectance), 0.5f * (s.transmittance + p.transmittance)};
}

}  // namespace

PaneCrossing cross_pane(const Material& m, float cosine) {
  const PolarisedReflectance face = fresnel_polarised(cosine, m.ior);
  if (m.pane) {
    Pane p;
    m.pane->at(cosine, p.reflectance, p.transmittance);
    const float left = 1 - p.transmittance;
    p.reflectance = m.pane->has_reflectance() ? std::min(p.reflectance, left) : std::min(pane(face, 1).reflectance, left);
    const float sum = p.reflectance + p.transmittance;
    return {Rgb(p.reflectance), Rgb(p.transmittance), sum > 0 ? p.reflectance / sum : 0};
  }
  const float length = 1 / std::max(refracted_cosine(cosine, m.ior), 1e-6f);  // of the passage, in thicknesses
  const auto channel = [&](float transmittance) {
    const float a = internal_transmittance(std::min(transmittance, 1.0f), m.ior);
    return pane(face, a < 1 ? std::pow(a, length) : 1.0f);
  };
  const Pane r = channel(m.transmittance.r);
  const bool grey = m.transmittance.g == m.transmittance.r && m.transmittance.b == m.transmittance.r;
  const Pane g = grey ? r : channel(m.transmittance.g), b = grey ? r : channel(m.transmittance.b);
  PaneCrossing out{{r.reflectance, g.reflectance, b.reflectance}, {r.transmittance, g.transmittance, b.transmittance}};
  const float reflected = luminance(out.reflectance), sum = reflected + luminance(out.transmittance);
  out.reflected = sum > 0 ? reflected / sum : 0;
  return out;
}

MirrorLobe mirror_lobe(const Material& m, float cosine) {
  if (m.model == MaterialModel::mirror) return {Textured(m, {}, m.ior).reflectance, 1};
  const PaneCrossing pane = cross_pane(m, cosine);
  return {pane.reflectance, pane.reflected};
}

namespace glazing {

Sampled sample(const BsdfParameters& p, const Vec3& wo, float u_lobe, BsdfSample& out) {
  const PaneCrossing pane = cross_pane(*p.material, std::abs(wo.z));
  if (u_lobe < pane.reflected) return mirrored(wo, pane.reflectance / pane.reflected, pane.reflected, out);
  out = {};
  out.wi = -wo;
  out.pdf = out.pdf_reverse = 1 - pane.reflected;
  if (!(out.pdf > 0) || is_black(pane.transmittance)) return Sampled::none;
  out.weight = pane.transmittance / out.pdf;
  out.delta = out.transmitted = true;
  return Sampled::delta;
}

}  // namespace glazing

namespace mirror {

Sampled sample(const BsdfParameters& p, const Vec3& wo, BsdfSample& out) { return mirrored(wo, p.reflectance, 1, out); }

}  // namespace mirror
}  // namespace ups
