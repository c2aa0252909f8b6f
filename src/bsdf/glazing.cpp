// Thin panes of glass and ideal mirrors: materials of delta lobes alone, alike on both sides. A pane reflects and lets
// pass straight on, with all reflections between its two faces; it is not resolved as a solid.
#include "bsdf/fresnel.h"
#include "bsdf/models.h"

namespace ups {
namespace glazing {

// T = (1 - F)^2 a / (1 - F^2 a^2) at normal incidence, solved for a without cancellation. At most 1: no pane of this
// index transmits more.
float internal_transmittance(float transmittance, float ior) {
  if (transmittance < 0) return 1;
  const float f = normal_reflectance(ior), pass = (1 - f) * (1 - f);
  const float root = std::sqrt(pass * pass + 4 * transmittance * transmittance * f * f);
  return std::min(1.0f, 2 * transmittance / (pass + root));
}

namespace {

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

Sampled sample(const BsdfParameters& p, const Vec3& wo, float u_lobe, BsdfSample& out) {
  const float cos_o = std::abs(wo.z), ior = p.material->ior;
  const PolarisedReflectance face = fresnel_polarised(cos_o, ior);
  const float length = 1 / std::max(refracted_cosine(cos_o, ior), 1e-6f);  // of the passage, in thicknesses
  const auto channel = [&](float a) { return pane(face, a < 1 ? std::pow(a, length) : 1.0f); };
  const Pane r = channel(p.transmittance.r), g = channel(p.transmittance.g), b = channel(p.transmittance.b);
  const Rgb reflectance{r.reflectance, g.reflectance, b.reflectance};
  const Rgb transmittance{r.transmittance, g.transmittance, b.transmittance};
  const float lr = luminance(reflectance), lt = luminance(transmittance);
  if (!(lr + lt > 0)) return Sampled::none;
  const float reflected = lr / (lr + lt);
  if (u_lobe < reflected) return mirrored(wo, reflectance / reflected, reflected, out);
  out = {};
  out.wi = -wo;
  out.pdf = out.pdf_reverse = 1 - reflected;
  if (!(out.pdf > 0)) return Sampled::none;
  out.weight = transmittance / out.pdf;
  out.delta = out.transmitted = true;
  return Sampled::delta;
}

}  // namespace glazing

namespace mirror {

Sampled sample(const BsdfParameters& p, const Vec3& wo, BsdfSample& out) { return mirrored(wo, p.reflectance, 1, out); }

}  // namespace mirror
}  // namespace ups
