// Glazing against closed forms of a slab, the classes of materials, and input that must not break anything.
#include <gtest/gtest.h>

#include "bsdf/fresnel.h"
#include "cases.h"

namespace ups::test {
namespace {

constexpr TransportMode importance = TransportMode::importance;

struct PaneTotals {
  Rgb reflectance, transmittance;
};
PaneTotals totals(const Material& m, float cosine) {
  const Bsdf bsdf(m, {0, 0});
  PaneTotals t;
  BsdfSample s;
  if (bsdf.sample(direction(cosine), 0, {0, 0}, importance, s) && !s.transmitted) t.reflectance = s.weight * s.pdf;
  if (bsdf.sample(direction(cosine), 0x1.fffffep-1f, {0, 0}, importance, s) && s.transmitted)
    t.transmittance = s.weight * s.pdf;
  return t;
}

TEST(Glazing, ClearPaneAtNormalIncidence) {
  const float expected[][2] = {{1.5f, 0.92308f}, {1.52f, 0.91832f}, {1.49f, 0.92544f}, {1.59f, 0.90134f}};
  for (const auto& [n, t] : expected) {  // 2 n / (n^2 + 1)
    Material m = make(MaterialModel::glazing, 0, Rgb(0.5f), n);
    m.transmittance = Rgb(-1.0f);
    EXPECT_NEAR(totals(m, 1).transmittance.g, t, 1e-5f);
    EXPECT_NEAR(totals(m, -1).reflectance.g, 1 - t, 1e-5f);
  }
}

TEST(Glazing, ClearPaneAtAngles) {
  Material m = make(MaterialModel::glazing, 0, Rgb(0.5f), 1.52f);
  m.transmittance = Rgb(-1.0f);
  for (double degrees : {20.0, 40.0, 60.0, 75.0, 85.0, 89.0}) {
    const double i = degrees * M_PI / 180, t = std::asin(std::sin(i) / 1.52);
    const double s = std::pow(std::sin(i - t) / std::sin(i + t), 2), p = std::pow(std::tan(i - t) / std::tan(i + t), 2);
    const double expected = 0.5 * ((1 - s) / (1 + s) + (1 - p) / (1 + p));  // lossless slab, a polarisation each
    EXPECT_NEAR(totals(m, float(std::cos(i))).transmittance.g, expected, 1e-5) << degrees;
    EXPECT_NEAR(totals(m, float(std::cos(i))).reflectance.g, 1 - expected, 1e-5) << degrees;
  }
}

TEST(Glazing, DiffuseTransmittanceOfAClearSlab) {
  for (const auto& [n, expected] : {std::pair{1.5f, 0.8509}, std::pair{1.52f, 0.8464}}) {
    Material m = make(MaterialModel::glazing, 0, Rgb(0.5f), n);
    m.transmittance = Rgb(-1.0f);
    double sum = 0;
    constexpr int count = 5000;
    for (int i = 0; i < count; ++i) {
      const float c = (float(i) + 0.5f) / count;
      sum += 2.0 * c * totals(m, c).transmittance.g / count;
    }
    EXPECT_NEAR(sum, expected, 1e-4);
  }
}

TEST(Glazing, TintedPane) {
  Material m = make(MaterialModel::glazing, 0, Rgb(0.5f), 1.52f);
  m.transmittance = {0.8f, 0.3f, 0.0f};
  const Rgb t = totals(m, 1).transmittance;  // as given, inner reflections included
  EXPECT_NEAR(t.r, 0.8f, 1e-5f);
  EXPECT_NEAR(t.g, 0.3f, 1e-5f);
  EXPECT_EQ(t.b, 0);
  const PaneTotals opaque = totals(m, 0.5f);
  EXPECT_NEAR(opaque.reflectance.b, fresnel_dielectric(0.5f, 1.52f), 1e-6f);  // of the first face alone
  EXPECT_LT(opaque.transmittance.r, 0.8f);                                    // longer way, more reflection
  m.transmittance = Rgb(1.0f);  // more than any pane of this index lets through
  EXPECT_NEAR(totals(m, 1).transmittance.r, 0.91832f, 1e-5f);
}

TEST(Glazing, AbsorptionFollowsTheLengthOfThePassage) {
  // An absorbing slab, a = exp(-k d / cos_t), by the geometric series for each polarisation.
  const double n = 1.52, a0 = 0.9;
  const double f0 = std::pow((n - 1) / (n + 1), 2);
  Material m = make(MaterialModel::glazing, 0, Rgb(0.5f), float(n));
  m.transmittance = Rgb(float((1 - f0) * (1 - f0) * a0 / (1 - f0 * f0 * a0 * a0)));
  for (double degrees : {30.0, 60.0, 80.0}) {
    const double i = degrees * M_PI / 180, t = std::asin(std::sin(i) / n), a = std::pow(a0, 1 / std::cos(t));
    const double f[2] = {std::pow(std::sin(i - t) / std::sin(i + t), 2),
                         std::pow(std::tan(i - t) / std::tan(i + t), 2)};
    double transmitted = 0, reflected = 0;
    for (double face : f) {
      const double through = (1 - face) * (1 - face) * a / (1 - face * face * a * a);
      transmitted += 0.5 * through;
      reflected += 0.5 * (face + face * a * through);
    }
    const PaneTotals result = totals(m, float(std::cos(i)));
    EXPECT_NEAR(result.transmittance.g, transmitted, 1e-5) << degrees;
    EXPECT_NEAR(result.reflectance.g, reflected, 1e-5) << degrees;
  }
}

// At the angles of the table, straight between them, and whatever side light comes from.
TEST(Glazing, TableByAngle) {
  Material m = make(MaterialModel::glazing, 0, Rgb(0.5f), 1.52f);
  m.pane = std::make_shared<const PaneTable>(std::vector<float>{0, 40, 60, 90}, std::vector<float>{0.8f, 0.7f, 0.5f, 0},
                                             std::vector<float>{0.1f, 0.1f, 0.3f, 1});
  const double expected[][3] = {{0, 0.8, 0.1}, {20, 0.75, 0.1}, {40, 0.7, 0.1}, {50, 0.6, 0.2}, {60, 0.5, 0.3},
                                {75, 0.25, 0.65}, {88, 0.5 / 15, 1 - 0.7 / 15}};
  for (const auto& [degrees, t, r] : expected)
    for (const double side : {1.0, -1.0}) {
      const PaneTotals all = totals(m, float(side * std::cos(degrees * M_PI / 180)));
      EXPECT_NEAR(all.transmittance.g, t, 1e-5) << degrees;
      EXPECT_NEAR(all.reflectance.g, r, 1e-5) << degrees;
    }
  EXPECT_FALSE(traits_of(m).coloured);
  EXPECT_TRUE(traits_of(m).delta);
}

// Without a table of its own the reflectance is a clear pane's, but for what the table lets through.
TEST(Glazing, TableWithoutReflectance) {
  Material clear = make(MaterialModel::glazing, 0, Rgb(0.5f), 1.52f), m = clear;
  clear.transmittance = Rgb(-1.0f);
  m.pane = std::make_shared<const PaneTable>(std::vector<float>{0, 90}, std::vector<float>{0.97f, 0.5f},
                                             std::vector<float>());
  const PaneTotals normal = totals(m, 1), oblique = totals(m, 0.5f);
  EXPECT_NEAR(normal.reflectance.g, 0.03, 1e-6);  // Fresnel's 0.082 would be too much beside 0.97
  EXPECT_NEAR(oblique.transmittance.g, 0.97 - 0.47 * 60 / 90, 1e-5);
  EXPECT_NEAR(oblique.reflectance.g, totals(clear, 0.5f).reflectance.g, 1e-6);
  Material opaque = m;
  opaque.pane = std::make_shared<const PaneTable>(std::vector<float>{0, 90}, std::vector<float>{0, 0},
                                                  std::vector<float>{0, 0});
  EXPECT_FALSE(traits_of(opaque).transmits);
  EXPECT_FALSE(traits_of(opaque).delta);
}

TEST(Glazing, IndexOneIsATintAlone) {
  Material m = make(MaterialModel::glazing, 0, Rgb(0.5f), 1);
  m.transmittance = Rgb(0.7f);
  EXPECT_NEAR(totals(m, 1).transmittance.r, 0.7f, 1e-6f);
  EXPECT_NEAR(totals(m, 0.5f).transmittance.r, 0.49f, 1e-5f);
}

TEST(Material, FlagsAgreeWithTraits) {
  for (const Case& c : all_cases()) {
    const Bsdf bsdf(c.material, {0, 0});
    const MaterialTraits t = traits_of(c.material);
    EXPECT_EQ(bsdf.has_delta(), t.delta) << c.name;
    EXPECT_EQ(bsdf.has_continuous(), t.continuous) << c.name;
    EXPECT_EQ(bsdf.transmits(), t.transmits) << c.name;
    const bool low = c.material.model == MaterialModel::glass && c.material.ior < 1.2f;  // bends light by little
    EXPECT_EQ(bsdf.min_alpha_continuous() > 0 && (low || bsdf.min_alpha_continuous() < 0.2f), t.glossy) << c.name;
    EXPECT_EQ(bsdf.has_delta() || bsdf.is_caster(), t.caster) << c.name;
    EXPECT_TRUE(t.interreflects) << c.name;
  }
  EXPECT_FALSE(traits_of(make(MaterialModel::matte, 0, Rgb(0.0f))).interreflects);
  EXPECT_FALSE(traits_of(make(MaterialModel::matte)).coloured);
  EXPECT_TRUE(traits_of(make(MaterialModel::matte, 0, {0.5f, 0.5f, 0.4f})).coloured);
  Material glass = make(MaterialModel::glass);
  EXPECT_FALSE(traits_of(glass).coloured);
  glass.absorption_per_m = {0, 0, 1};
  EXPECT_TRUE(traits_of(glass).coloured);
}

TEST(Material, TraitsSpanTheRoughnessTexture) {
  const Texture stripes(2, 1, 1, {0.0f, 1.0f});
  Material m = make(MaterialModel::metal, 1);
  m.roughness_texture = &stripes;
  const MaterialTraits t = traits_of(m);
  EXPECT_TRUE(t.delta && t.continuous && t.glossy);
  EXPECT_TRUE(Bsdf(m, {0.25f, 0}).has_delta());
  EXPECT_FALSE(Bsdf(m, {0.75f, 0}).has_delta());
  EXPECT_NEAR(Bsdf(m, {0.5f, 0}).min_alpha_continuous(), 0.25f, 1e-6f);
}

TEST(Material, TexturesMultiply) {
  const Texture texture(1, 1, 3, {0.5f, 0.25f, 2.0f});
  Material m = make(MaterialModel::matte, 0, Rgb(0.8f));
  m.reflectance_texture = &texture;
  const Rgb f = Bsdf(m, {3.7f, -2.1f}).eval({0, 0, 1}, {0, 0, 1}, importance) * pi;
  EXPECT_NEAR(f.r, 0.4f, 1e-6f);
  EXPECT_NEAR(f.g, 0.2f, 1e-6f);
  EXPECT_NEAR(f.b, 1.0f, 1e-6f);  // never above 1
}

TEST(Material, GrazingDirectionsScatterNothing) {
  for (const Case& c : all_cases()) {
    const Bsdf bsdf(c.material, {0, 0});
    BsdfSample s;
    for (const Vec3& grazing : {direction(0), direction(5e-7f), direction(-9e-7f)}) {
      EXPECT_FALSE(bsdf.sample(grazing, 0.4f, {0.2f, 0.7f}, importance, s)) << c.name;
      EXPECT_TRUE(is_black(bsdf.eval(grazing, direction(0.5f), importance))) << c.name;
      EXPECT_TRUE(is_black(bsdf.eval(direction(0.5f), grazing, importance))) << c.name;
      EXPECT_EQ(bsdf.pdf(grazing, direction(0.5f)), 0) << c.name;
      EXPECT_EQ(bsdf.pdf(direction(0.5f), grazing), 0) << c.name;
    }
  }
}

// Directions at and beyond what float resolves, extreme parameters, extreme random numbers: finite and not negative.
TEST(Material, AdversarialInputStaysFinite) {
  std::vector<Case> cases = all_cases();
  for (float ior : {1.0f, 1.0000001f, 1.00003f, 1.001f, 3.0f})
    for (float alpha : {3.0e-5f, 3.1e-5f, 1.0f})
      for (auto model : {MaterialModel::glass, MaterialModel::plastic, MaterialModel::glazing})
        cases.push_back({"extreme", make(model, roughness_of(alpha), Rgb(1.0f), ior)});
  const float cosine[] = {1, 1 - 6e-8f, 0.7453560f, 0.5f, 1e-2f, 1e-4f, 1.1e-6f, 1e-6f, 9e-7f, 0};
  const float u[] = {0, 1e-7f, 0.5f, 0x1.fffffep-1f};
  const auto good = [](const Rgb& v) { return is_finite(v) && v.r >= 0 && v.g >= 0 && v.b >= 0; };
  for (const Case& c : cases) {
    const Bsdf bsdf(c.material, {0, 0});
    std::vector<Vec3> directions;
    for (float z : cosine)
      for (float sign : {1.0f, -1.0f})
        for (float phi : {0.0f, pi, 2.1f}) directions.push_back(direction(sign * z, phi));
    for (const Vec3& wo : directions) {
      for (const Vec3& wi : directions) {
        ASSERT_TRUE(good(bsdf.eval(wo, wi, TransportMode::radiance))) << c.name << wo.z << " " << wi.z;
        const float pdf = bsdf.pdf(wo, wi);
        ASSERT_TRUE(std::isfinite(pdf) && pdf >= 0) << c.name << wo.z << " " << wi.z;
      }
      for (float lobe : u)
        for (float x : u)
          for (float y : u) {
            BsdfSample s;
            if (!bsdf.sample(wo, lobe, {x, y}, TransportMode::radiance, s)) continue;
            ASSERT_TRUE(good(s.weight) && is_finite(s.wi)) << c.name << wo.z;
            ASSERT_TRUE(std::isfinite(s.pdf) && s.pdf > 0 && std::isfinite(s.pdf_reverse) && s.pdf_reverse >= 0)
                << c.name;
            ASSERT_TRUE(std::isfinite(s.delta_jacobian) && s.delta_jacobian > 0) << c.name;
          }
    }
  }
}

// Denser in front than behind: the same interface turned over, whatever its material's own index.
TEST(Glass, RelativeIndexBelowOneIsTheInterfaceTurnedOver) {
  for (const float roughness : {0.0f, 0.5f}) {
    const Material m = make(MaterialModel::glass, roughness, Rgb(0.5f), 1.8f);
    const Bsdf dense_behind(m, {}, 1.25f), dense_in_front(m, {}, 1 / 1.25f);
    const auto over = [](const Vec3& w) { return Vec3{w.x, w.y, -w.z}; };
    for (const float cosine : {0.9f, 0.4f, -0.3f, -0.95f}) {
      const Vec3 wo = direction(cosine);
      for (const float u : {0.01f, 0.3f, 0.95f}) {
        BsdfSample a, b;
        const bool found = dense_behind.sample(wo, u, {0.3f, 0.6f}, TransportMode::radiance, a);
        ASSERT_EQ(dense_in_front.sample(over(wo), u, {0.3f, 0.6f}, TransportMode::radiance, b), found);
        if (!found) continue;
        EXPECT_LT(length(over(b.wi) - a.wi), 1e-5f);
        EXPECT_NEAR(b.weight.g / a.weight.g, 1, 1e-4f);
        EXPECT_NEAR(b.pdf / a.pdf, 1, 1e-4f);
        EXPECT_NEAR(b.pdf_reverse / a.pdf_reverse, 1, 1e-4f);
        EXPECT_NEAR(b.delta_jacobian / a.delta_jacobian, 1, 1e-4f);
        EXPECT_EQ(a.transmitted, b.transmitted);
      }
    }
  }
}

TEST(Glass, EqualIndicesAreNoBoundary) {
  for (const float roughness : {0.0f, 1.0f}) {
    const Material m = make(MaterialModel::glass, roughness, Rgb(0.5f), 1.8f);
    const Bsdf bsdf(m, {}, 1.0f);
    EXPECT_FALSE(bsdf.has_continuous());
    BsdfSample s;
    ASSERT_TRUE(bsdf.sample(direction(0.2f), 1e-6f, {0.3f, 0.6f}, TransportMode::radiance, s));
    EXPECT_LT(length(s.wi + direction(0.2f)), 1e-6f);
    EXPECT_EQ(s.weight.g, 1);
    EXPECT_EQ(s.pdf, 1);
  }
}

bool same(const Scattering& a, const Scattering& b) {
  return a.value.r == b.value.r && a.value.g == b.value.g && a.value.b == b.value.b && a.pdf == b.pdf &&
         a.pdf_reverse == b.pdf_reverse;
}

// The same bits, whatever was asked before, and of what is left of the textures.
TEST(Bsdf, AnswersAlikeWhateverItWasAskedBefore) {
  for (const auto& [name, m] : all_cases()) {
    const Bsdf asked(m, {0, 0}), copied(m, m.ior, asked.textured());
    for (const float o : {0.9f, -0.4f, 0.05f, 0.9f})
      for (const float i : {0.3f, 0.9f, -0.7f, 0.3f}) {
        const Vec3 wo = direction(o), wi = direction(i, 2.1f);
        const Scattering fresh = Bsdf(m, {0, 0}).evaluate(wo, wi, importance);
        EXPECT_TRUE(same(asked.evaluate(wo, wi, importance), fresh)) << name;
        EXPECT_TRUE(same(copied.evaluate(wo, wi, importance), fresh)) << name;
      }
  }
}

// What casts caustics: sharp lobes that have most of the light; of glass of low index, what it lets through is bent by less
// than its facets lean.
TEST(Bsdf, CastersAreSharpAndHaveMostOfTheLight) {
  const auto casts = [](MaterialModel model, float alpha, float metallic, float ior) {
    Material m = make(model, std::sqrt(alpha), Rgb(0.9f), ior);
    m.metallic = metallic;
    return Bsdf(m, {0, 0}).is_caster();
  };
  EXPECT_TRUE(casts(MaterialModel::metal, 0.1f, 0, 1.5f));
  EXPECT_FALSE(casts(MaterialModel::metal, 0.3f, 0, 1.5f));
  for (const float metallic : {0.0f, 0.4f, 0.6f, 0.95f, 1.0f})
    EXPECT_EQ(casts(MaterialModel::plastic, 0.01f, metallic, 1.5f), metallic > 0.5f) << metallic;
  EXPECT_TRUE(casts(MaterialModel::glass, 0.1f, 0, 1.5f));
  EXPECT_FALSE(casts(MaterialModel::glass, 0.25f, 0, 1.5f));
  EXPECT_TRUE(casts(MaterialModel::glass, 0.25f, 0, 1.05f));
}

TEST(Bsdf, ReadsNoLobeWhereItChoosesNone) {
  int choosing = 0;
  for (const auto& [name, m] : all_cases()) {
    const Bsdf bsdf(m, {0, 0});
    choosing += bsdf.chooses_lobe();
    if (bsdf.chooses_lobe()) continue;
    BsdfSample a, b;
    ASSERT_TRUE(bsdf.sample(direction(0.5f), 0, {0.2f, 0.6f}, importance, a)) << name;
    ASSERT_TRUE(bsdf.sample(direction(0.5f), 0x1.fffffep-1f, {0.2f, 0.6f}, importance, b)) << name;
    EXPECT_TRUE(a.wi.x == b.wi.x && a.wi.y == b.wi.y && a.pdf == b.pdf && a.weight.g == b.weight.g) << name;
  }
  EXPECT_EQ(choosing, int(all_cases().size()) - 2);  // matte and mirror
}

}  // namespace
}  // namespace ups::test
