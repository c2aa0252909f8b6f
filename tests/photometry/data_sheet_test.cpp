// Data sheet numbers against closed forms of simple distributions.
#include "photometry/data_sheet.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "photometry/files.h"
#include "photometry/metrics.h"

namespace photometry {
namespace {

constexpr double pi = 3.14159265358979323846;
using test::rad;
using test::steps;

Photometry made(const std::function<double(double, double)>& intensity) {
  const std::vector<double> c = steps(0, 350, 35), g = steps(0, 180, 360);
  std::vector<double> table;
  for (double c_deg : c)
    for (double g_deg : g) table.push_back(intensity(c_deg, g_deg));
  return Photometry{Distribution(c, g, std::move(table))};
}
double lambertian(double, double g) { return g < 90 ? 1000 * std::cos(rad(g)) : 0; }

TEST(FluxCode, OfLambertianAndUniformLight) {
  // Of Lambertian light the share within gamma is sin^2: 1 - 0.75^2, 0.75, 1 - 0.25^2.
  FluxCode code = flux_code(made(lambertian));
  const double expected[5] = {43.75, 75, 93.75, 100, 100};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(code.n[i], expected[i], 0.1) << i;
  Photometry sphere = made([](double, double) { return 100.0; });
  sphere.rated_flux_lm = 4 * pi * 100 / 0.8;
  code = flux_code(sphere);
  const double uniform[5] = {25, 50, 75, 50, 80};
  for (int i = 0; i < 5; ++i) EXPECT_NEAR(code.n[i], uniform[i], 0.01) << i;
}

TEST(HighLuminance, OverAllPlanes) {
  // A flat opening: I / (A cos gamma). The peak of plane 40 stands out.
  Photometry p = made([](double c, double g) { return g < 90 ? (c == 40 ? 300.0 : 100.0) : 0; });
  EXPECT_EQ(high_luminance(p).highest_cd_m2, -1);
  p.opening.shape = OpeningShape::rectangle;
  p.opening.size_m[0] = p.opening.size_m[1] = 0.5f;
  const HighLuminance l = high_luminance(p);
  for (int k = 0; k < 3; ++k)
    EXPECT_NEAR(l.at_cd_m2[k], 300 / (0.25 * std::cos(rad(HighLuminance::gamma_deg[k]))), 0.01) << k;
  EXPECT_NEAR(l.highest_cd_m2, l.at_cd_m2[2], 1e-9);
  EXPECT_EQ(l.c_deg, 40);
  EXPECT_EQ(l.highest_gamma_deg, 85);
  Photometry lambert = made(lambertian);
  lambert.opening = p.opening;
  EXPECT_NEAR(high_luminance(lambert).highest_cd_m2, 4000, 2);
}

// A direction that is computed from a table's last angle may lie an ulp beyond it.
TEST(HighLuminance, AtATablesLastAngle) {
  for (const double last : {60.0, 70.0, 85.0, 88.0}) {
    const std::vector<double> c = steps(0, 345, 23), g = steps(0, last, 5);
    Photometry p{Distribution(c, g, std::vector<double>(c.size() * g.size(), 100.0))};
    for (const double plane : c)
      EXPECT_NEAR(p.distribution.eval(std::sin(rad(last)) * std::cos(rad(plane)),
                                      std::sin(rad(last)) * std::sin(rad(plane)), -std::cos(rad(last))), 100, 1e-9)
          << last << " " << plane;
    p.opening.shape = OpeningShape::rectangle;
    p.opening.size_m[0] = p.opening.size_m[1] = 0.3f;
    if (last == 85) {
      EXPECT_NEAR(high_luminance(p).at_cd_m2[2], 100 / (0.09 * std::cos(rad(85))), 0.01);
    }
    EXPECT_NEAR(p.distribution.resampled(c, g).band_flux_lm(), p.distribution.band_flux_lm(), 1e-9);
  }
}

TEST(SpacingCriterion, OfCosinePowers) {
  // Midway: 2 cos^(n + 3) = 1; at the centre of four: 4 cos^(n + 3) = 1.
  for (const double n : {1.0, 3.0, 10.0}) {
    const SpacingCriterion sc = spacing_criterion(
        made([n](double, double g) { return g < 90 ? 1000 * std::pow(std::cos(rad(g)), n) : 0; }));
    const double two = 2 * std::tan(std::acos(std::pow(0.5, 1 / (n + 3))));
    EXPECT_NEAR(sc.along_c0, two, 1e-3) << n;
    EXPECT_NEAR(sc.along_c90, two, 1e-3) << n;
    EXPECT_NEAR(sc.diagonal, std::sqrt(2.0) * std::tan(std::acos(std::pow(0.25, 1 / (n + 3)))), 1e-3) << n;
  }
  EXPECT_NEAR(spacing_criterion(made(lambertian)).diagonal, 1.41, 0.01);
  EXPECT_LT(spacing_criterion(made([](double, double g) { return g > 90 ? 1.0 : 0; })).along_c0, 0);
}

TEST(SpacingCriterion, PlanesApart) {
  const auto power = [](double c) { return 2 - std::cos(rad(2 * c)); };
  const SpacingCriterion sc = spacing_criterion(
      made([&](double c, double g) { return g < 90 ? 1000 * std::pow(std::cos(rad(g)), power(c)) : 0; }));
  EXPECT_NEAR(sc.along_c0, 2 * std::tan(std::acos(std::pow(0.5, 1.0 / 4))), 1e-3);
  EXPECT_NEAR(sc.along_c90, 2 * std::tan(std::acos(std::pow(0.5, 1.0 / 6))), 1e-3);
}

TEST(NemaType, ByFieldAngle) {
  const std::pair<double, int> expected[] = {{-1, 0},  {9.9, 0}, {10, 1},  {18, 1},   {18.1, 2}, {29, 2},   {29.1, 3},
                                             {46, 3},  {70, 4},  {70.1, 5}, {100, 5}, {130, 6},  {130.1, 7}, {180, 7}};
  for (const auto& [angle, type] : expected) EXPECT_EQ(nema_type(angle), type) << angle;
}

TEST(BugRating, ZonesOfUniformLight) {
  // Each zone's share of 4 pi is (cos a - cos b) / 2, half of it to the front.
  const BugRating bug = bug_rating(made([](double, double) { return 1000.0; }), 0);
  const double edges[5] = {0, 30, 60, 80, 90};
  for (int i = 0; i < 4; ++i) {
    const double half = pi * 1000 * (std::cos(rad(edges[i])) - std::cos(rad(edges[i + 1])));
    EXPECT_NEAR(bug.front_lm[i], half, 0.01) << i;
    EXPECT_NEAR(bug.back_lm[i], half, 0.01) << i;
  }
  EXPECT_NEAR(bug.up_lm[0], 2 * pi * 1000 * std::cos(rad(80)), 0.05);
  EXPECT_NEAR(bug.up_lm[1], 2 * pi * 1000 * (1 - std::cos(rad(80))), 0.05);
}

// Light to the front alone, of so much flux that it meets the limits of TM-15-11 or just goes beyond.
TEST(BugRating, FrontIsWhereItWasSaid) {
  const Photometry p = made([](double c, double g) { return g < 60 && c > 0 && c < 180 ? 1000.0 : 0; });
  const BugRating to_c90 = bug_rating(p, 90), to_c0 = bug_rating(p, 0);
  EXPECT_NEAR(to_c90.back_lm[0] + to_c90.back_lm[1], 0, 1e-9);
  EXPECT_EQ(to_c90.backlight, 0);
  EXPECT_EQ(to_c90.uplight, 0);
  EXPECT_EQ(to_c90.glare, 0);
  EXPECT_NEAR(to_c0.back_lm[1], to_c0.front_lm[1], 1e-6 * to_c0.front_lm[1]);
  EXPECT_EQ(to_c0.backlight, 1);  // 575 lm mid, over 220
}

TEST(BugRating, LimitsOfGlare) {
  // A zone from 60 to 80 degrees, half of it behind, against its two tables.
  const double unit = pi * (std::cos(rad(60)) - std::cos(rad(80)));  // of 1 cd, each half
  const auto of = [&](double lm, Symmetry symmetry) {
    const double cd = lm / unit;
    Photometry p{Distribution({0}, {60, 80}, {cd, cd})};
    p.symmetry = symmetry;
    return bug_rating(p, 0).glare;
  };
  EXPECT_EQ(of(600, Symmetry::axial), 0);
  EXPECT_EQ(of(700, Symmetry::axial), 1);
  EXPECT_EQ(of(12100, Symmetry::axial), 5);
  const auto to_one_side = [&](double lm) {
    const double cd = 4 * lm / unit;  // a quarter of it behind, as planes are interpolated
    return bug_rating({Distribution({0, 90, 180, 270}, {60, 80}, {cd, cd, cd, cd, 0, 0, 0, 0})}, 0).glare;
  };
  EXPECT_EQ(to_one_side(105), 0);
  EXPECT_EQ(to_one_side(600), 2);
}

// A file may write the whole circle out, as it was measured: the light tells, not the planes that are stated.
TEST(BugRating, RoundLightIsTypeVHoweverItIsWritten) {
  const auto of = [](double at_90, double at_180, Symmetry stated) {
    Photometry p{Distribution({0, 90, 180, 270}, {60, 70, 80},
                              {100, 100, 100, at_90, at_90, at_90, at_180, at_180, at_180, at_90, at_90, at_90})};
    p.symmetry = stated;
    return bug_rating(p, 0).type_v;
  };
  EXPECT_TRUE(of(100.4, 99.8, Symmetry::none));
  EXPECT_TRUE(of(60, 100.3, Symmetry::none));  // to both planes
  EXPECT_FALSE(of(60, 80, Symmetry::none));
  EXPECT_FALSE(of(100, 80, Symmetry::none));
  EXPECT_TRUE(of(60, 80, Symmetry::quadrants));
}

TEST(UtilisationFactors, OfLambertianLightAreFormFactors) {
  // Direct light of a Lambertian ceiling: the form factor of the two planes, and more with every reflection.
  Photometry p = made(lambertian);
  const UtilisationFactors uf = utilisation_factors(p);
  const auto form = [](double x) {
    const double x2 = 1 + x * x, s = std::sqrt(x2);
    const double sum = 0.5 * std::log(x2 * x2 / (2 * x2 - 1)) + 2 * x * s * std::atan(x / s) - 2 * x * std::atan(x);
    return 2 / (pi * x * x) * sum;
  };
  for (int r = 0; r < UtilisationFactors::rooms; ++r) {
    EXPECT_NEAR(uf.factor[r][9], form(2 * UtilisationFactors::room_index[r]), 2e-4) << r;
    for (int k = 0; k < 9; ++k) EXPECT_GT(uf.factor[r][k], uf.factor[r][9]);
  }
  p.rated_flux_lm = flux_lm(p) / 0.7;
  EXPECT_NEAR(utilisation_factors(p).factor[4][0], 0.7 * uf.factor[4][0], 1e-12);
}

}  // namespace
}  // namespace photometry
