// Hazard 4: lobes of roughness 1e-1 to 1e-5, where half vectors lose their digits, and the smallest below which they
// are delta lobes. Furnaces through the whole engine: sharp_lobes_test.cpp.
#include <gtest/gtest.h>

#include "../bsdf/directional_albedo.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

constexpr float cosines[] = {1.0f, 0.9f, 0.6f, 0.4f, 0.2f, 0.1f, 0.05f, 0.02f};
constexpr float alphas[] = {0.1f, 0.03f, 0.01f, 3e-3f, 1e-3f, 3e-4f, 1e-4f, 3.1e-5f, 2.9e-5f, 1e-5f, 0};

// What absorbs nothing returns all light, at every roughness: continuous within 0.5 %. 16,384 points of Hammersley's
// for each, no chance.
TEST(Hazard04, LosslessMaterialsReturnAllLightAtEveryRoughness) {
  double worst = 0;
  const auto expect_one = [&](MaterialModel model, float ior, bool from_inside) {
    for (const float alpha : alphas)
      for (const float cosine : cosines) {
        const double a = albedo(make(model, roughness_of(alpha), Rgb(1.0f), ior), from_inside ? -cosine : cosine);
        EXPECT_NEAR(a, 1, 0.005) << int(model) << " of " << ior << ", alpha " << alpha << " cos " << cosine
                                 << (from_inside ? " inside" : "");
        worst = std::max(worst, std::abs(a - 1));
      }
  };
  expect_one(MaterialModel::metal, 1.5f, false);
  for (const float ior : {1.5f, 2.2f}) expect_one(MaterialModel::plastic, ior, false);
  for (const float ior : {1.33f, 1.5f, 2.42f})
    for (const bool from_inside : {false, true}) expect_one(MaterialModel::glass, ior, from_inside);
  measured("largest difference from 1: %.4f", worst);
}

// Below min_alpha lobes become delta lobes; nobody must see where. Of rougher ones albedo changes in truth.
TEST(Hazard04, AlbedoIsContinuousInRoughness) {
  double worst = 0;
  Material gold = make(MaterialModel::metal);
  gold.ior_rgb = {0.18f, 0.42f, 1.37f};
  gold.ior_k_rgb = {3.42f, 2.35f, 1.77f};
  const Material plastic = make(MaterialModel::plastic, 0, {0.7f, 0.3f, 0.1f}),
                 metal = make(MaterialModel::metal, 0, Rgb(0.6f));
  for (Material m : {plastic, metal, gold})
    for (const float cosine : {1.0f, 0.6f, 0.2f, 0.05f}) {
      m.roughness = 0;
      double before = albedo(m, cosine);
      for (const float alpha : {1e-5f, 2.9e-5f, 3.1e-5f, 1e-4f, 3e-4f, 1e-3f}) {
        m.roughness = roughness_of(alpha);
        const double now = albedo(m, cosine);
        EXPECT_NEAR(now, before, 0.005) << "alpha " << alpha << " cos " << cosine;
        worst = std::max(worst, std::abs(now - before));
        before = now;
      }
    }
  measured("largest step of albedo %.4f", worst);
}

}  // namespace
}  // namespace ups::test
