// The weights take a delta lobe's Jacobian as given. Is it the one of the map? A delta lobe sends the solid angle
// around wo onto one around wi; their ratio, by finite differences of the sampled direction, must be
// BsdfSample::delta_jacobian.
#include <gtest/gtest.h>

#include <cmath>

#include "base/frame.h"
#include "bsdf/material.h"

namespace ups::test {
namespace {

// Directions around wo, and the solid angles that a small square of them spans before and after.
double measured_jacobian(const Bsdf& bsdf, const Vec3& wo, float u_lobe) {
  const Frame frame(wo);
  const float h = 4e-3f;
  Vec3d in[4], out[4];
  const Vec2 offsets[4] = {{h, 0}, {-h, 0}, {0, h}, {0, -h}};
  for (int i = 0; i < 4; ++i) {
    const Vec3 w = normalize(wo + frame.s * offsets[i].x + frame.t * offsets[i].y);
    BsdfSample sample;
    if (!bsdf.sample(w, u_lobe, {0.5f, 0.5f}, TransportMode::radiance, sample) || !sample.delta) return -1;
    in[i] = Vec3d(w);
    out[i] = Vec3d(sample.wi);
  }
  return length(cross(out[0] - out[1], out[2] - out[3])) / length(cross(in[0] - in[1], in[2] - in[3]));
}

TEST(DeltaJacobian, IsTheRatioOfSolidAngles) {
  for (MaterialModel model : {MaterialModel::glass, MaterialModel::mirror, MaterialModel::glazing}) {
    Material material;
    material.model = model;
    material.ior = 1.5f;
    material.reflectance = Rgb(0.9f);
    material.transmittance = Rgb(-1.0f);
    const Bsdf bsdf(material, {0, 0});
    int transmitted = 0, reflected = 0;
    for (float side : {1.0f, -1.0f})
      for (float angle = 0; angle < 1.4f; angle += 0.1f)
        for (float u_lobe : {0.0f, 0.99999f}) {  // one end of the range reflects, the other transmits
          const Vec3 wo{0.6f * std::sin(angle), 0.8f * std::sin(angle), side * std::cos(angle)};
          BsdfSample sample;
          if (!bsdf.sample(wo, u_lobe, {0.5f, 0.5f}, TransportMode::importance, sample)) continue;
          const double measured = measured_jacobian(bsdf, wo, u_lobe);
          if (measured < 0) continue;  // a neighbour is beyond the critical angle
          ++(sample.transmitted ? transmitted : reflected);
          const bool near_critical =
              model == MaterialModel::glass && sample.transmitted && std::abs(sample.wi.z) < 0.2f;
          EXPECT_NEAR(measured / sample.delta_jacobian, 1, near_critical ? 0.05 : 2e-3)
              << "model " << int(model) << ", side " << side << ", angle " << angle << ", transmitted "
              << sample.transmitted;
        }
    EXPECT_GE(reflected, 20) << int(model);
    EXPECT_GE(transmitted, model == MaterialModel::mirror ? 0 : 15) << int(model);
  }
}

}  // namespace
}  // namespace ups::test
