// Are the numbers of a data sheet right? Beam and field angles against closed forms, on the interpolated intensity
// exactly; flux by zones against its rule and against quadrature of eval(); luminance against projected areas.
#include "photometry/metrics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "photometry/data_sheet.h"
#include "photometry/files.h"

namespace photometry {
namespace {

constexpr double pi = 3.14159265358979323846;
using test::eval_at;
using test::rad;
using test::read_file;
using test::steps;
double deg(double rad) { return rad * 180 / pi; }

// A table of `intensity` of C and gamma, in degrees.
Photometry tabulate(std::vector<double> c, std::vector<double> g,
                    const std::function<double(double, double)>& intensity) {
  std::vector<double> table;
  for (double c_deg : c)
    for (double g_deg : g) table.push_back(intensity(c_deg, g_deg));
  return Photometry{Distribution(std::move(c), std::move(g), std::move(table))};
}

Photometry axial(std::vector<double> g, std::vector<double> cd) {
  return Photometry{Distribution({0}, std::move(g), std::move(cd))};
}

TEST(Beam, OfALambertianSourceIs120) {
  // Rows at the directions of half and a tenth of the peak, so that the table holds them exactly.
  std::vector<double> g = steps(0, 90, 90);
  g.insert(g.begin() + 85, deg(std::acos(0.1)));
  const Photometry p = tabulate({0}, g, [](double, double gamma) { return 1000 * std::cos(rad(gamma)); });
  const Metrics m = metrics_of(p);
  for (int plane = 0; plane < 2; ++plane) {
    EXPECT_NEAR(m.beam[plane].angle_deg, 120, 1e-6);
    EXPECT_NEAR(m.beam[plane].from_deg, -60, 1e-6);
    EXPECT_NEAR(m.beam[plane].to_deg, 60, 1e-6);
    EXPECT_EQ(m.beam[plane].peak_deg, 0);
    EXPECT_NEAR(m.beam[plane].peak_cd, 1000, 1e-9);
    EXPECT_NEAR(m.field[plane].angle_deg, 2 * deg(std::acos(0.1)), 1e-6);
  }
}

TEST(Beam, OfCosinePowersFollowsTheClosedForm) {
  for (double n : {2.0, 18.0, 400.0}) {
    const Photometry p =
        tabulate({0}, steps(0, 90, 9000), [n](double, double g) { return std::pow(std::cos(rad(g)), n); });
    // The table's chords leave the curve by less than h^2 / 8 times its curvature: here below 1e-4 degrees.
    for (double fraction : {0.5, 0.1})
      EXPECT_NEAR(beam_of(p, 0, fraction).angle_deg, 2 * deg(std::acos(std::pow(fraction, 1 / n))), 1e-4) << n;
  }
}

TEST(Beam, IsExactOnTheInterpolatedIntensity) {
  const Photometry p = axial({0, 10, 30, 50, 90}, {100, 80, 20, 5, 0});
  // 80 to 20 over 20 degrees passes 50 at 20; 20 to 5 over 20 degrees passes 10 at 30 + 20 * 10 / 15.
  EXPECT_NEAR(beam_of(p, 0, 0.5).angle_deg, 40, 1e-8);
  EXPECT_NEAR(beam_of(p, 0, 0.1).angle_deg, 2 * (30 + 20 * 10 / 15.0), 1e-8);
  // The same from eval() alone, at a plane between two of an asymmetric table.
  const Photometry q =
      tabulate({0, 70, 200}, {0, 20, 45, 80}, [](double c, double g) { return 100 - g + 0.1 * (c / 200) * g; });
  const Beam b = beam_of(q, 33, 0.5);
  ASSERT_LT(b.from_deg, 0);
  EXPECT_NEAR(eval_at(q.distribution, 33 + 180, -b.from_deg), 50, 1e-7);
  EXPECT_NEAR(eval_at(q.distribution, 33, b.to_deg), 50, 1e-7);
}

TEST(Beam, OfAnIsotropicSourceHasNoAngle) {
  const Metrics m = metrics_of(axial({0, 90, 180}, {7, 7, 7}));
  for (const Beam& b : {m.beam[0], m.beam[1], m.field[0], m.field[1]}) {
    EXPECT_LT(b.angle_deg, 0);
    EXPECT_EQ(b.peak_cd, 7);
  }
  EXPECT_LT(beam_of(axial({0, 90}, {0, 0}), 0, 0.5).angle_deg, 0);  // no light
  EXPECT_LT(beam_of(axial({0, 180}, {10, 6}), 0, 0.5).angle_deg, 0);
  EXPECT_GT(beam_of(axial({0, 180}, {10, 4}), 0, 0.5).angle_deg, 0);
}

TEST(Beam, EndsWhereTheTableEnds) {
  EXPECT_NEAR(beam_of(axial({0, 65}, {10, 8}), 0, 0.5).angle_deg, 130, 1e-7);
  EXPECT_NEAR(beam_of(axial({0, 90}, {10, 10}), 0, 0.5).angle_deg, 180, 1e-7);
  const Beam up = beam_of(axial({90, 180}, {10, 10}), 0, 0.5);  // about the zenith, 180
  EXPECT_NEAR(up.angle_deg, 180, 1e-7);
}

TEST(Beam, OfANeedle) {
  const Photometry p = axial({0, 0.002, 0.01, 90}, {1e6, 6e5, 0, 0});
  EXPECT_NEAR(beam_of(p, 0, 0.5).angle_deg, 2 * (0.002 + 0.008 / 6), 1e-8);
}

TEST(Beam, OfAWasherIsFollowedFromItsPeak) {
  // Peak 40 degrees off the nadir on the side C0; nothing on the side C180.
  const Photometry p = tabulate({0, 90, 180, 270}, {0, 20, 40, 60, 90}, [](double c, double g) {
    const double side[] = {10, 60, 100, 40, 0}, other[] = {10, 8, 4, 2, 0}, behind[] = {10, 1, 0, 0, 0};
    const int row = g == 0 ? 0 : g == 20 ? 1 : g == 40 ? 2 : g == 60 ? 3 : 4;
    return c == 0 ? side[row] : c == 180 ? behind[row] : other[row];
  });
  const Beam b = beam_of(p, 0, 0.5);
  EXPECT_NEAR(b.peak_deg, 40, 1e-9);
  EXPECT_NEAR(b.from_deg, 20 * 0.8, 1e-7);           // 10 to 60 passes 50 there
  EXPECT_NEAR(b.to_deg, 40 + 20 * 50 / 60.0, 1e-7);  // 100 to 40
  const Beam opposite = beam_of(p, 180, 0.5);        // the same plane, seen from its other side
  EXPECT_NEAR(opposite.from_deg, -b.to_deg, 1e-7);
  EXPECT_NEAR(opposite.to_deg, -b.from_deg, 1e-7);
  EXPECT_NEAR(beam_of(p, 0, 0.1).from_deg, 0, 1e-7);
  const Beam across = beam_of(p, 90, 0.5);  // measured against this plane's own peak, 10 cd
  EXPECT_EQ(across.peak_deg, 0);
  EXPECT_NEAR(across.to_deg, 20 + 20 * 3 / 4.0, 1e-7);
}

TEST(Beam, OverTheZenithAndOfTwoEqualLobes) {
  const Photometry up = axial({0, 120, 150, 180}, {0, 0, 50, 100});
  const Beam b = beam_of(up, 0, 0.5);
  EXPECT_NEAR(b.angle_deg, 60, 1e-7);
  EXPECT_NEAR(b.peak_deg, 180, 1e-9);
  EXPECT_NEAR(b.from_deg, 150, 1e-7);
  EXPECT_NEAR(b.to_deg, 210, 1e-7);
  const Beam lobe = beam_of(axial({0, 30, 60}, {10, 100, 0}), 0, 0.5);
  EXPECT_NEAR(lobe.peak_deg, 30, 1e-9);
  EXPECT_NEAR(lobe.from_deg, 30 * 40 / 90.0, 1e-7);
  EXPECT_NEAR(lobe.to_deg, 45, 1e-7);
  EXPECT_NEAR(beam_of(axial({0, 30, 60}, {60, 100, 0}), 0, 0.5).angle_deg, 90, 1e-7);  // a batwing's shallow dip
}

// s08 to s10 are the same lamp as tables of type C, B and A: 1000 cos(gamma) (1 + 0.25 up + 0.5 left), up and left of
// the unit direction.
TEST(Metrics, OfTypesBAndAAreThoseOfTypeC) {
  const Metrics c = metrics_of(read_file("s08_typeC_asym.ies"));
  for (const char* name : {"s09_typeB_asym.ies", "s10_typeA_asym.ies"}) {
    const Photometry p = read_file(name);
    ASSERT_NE(p.distribution.type(), PhotometricType::c) << name;
    const Metrics m = metrics_of(p);
    for (int i = 0; i < 2; ++i) {
      // Type C has rows of 5 degrees, as the others: the chords of all three differ from the curve by less than 0.1
      // deg.
      EXPECT_NEAR(m.beam[i].from_deg, c.beam[i].from_deg, 0.15) << name;
      EXPECT_NEAR(m.beam[i].to_deg, c.beam[i].to_deg, 0.15) << name;
      EXPECT_NEAR(m.beam[i].peak_cd, c.beam[i].peak_cd, 1) << name;
    }
    EXPECT_NEAR(m.down_flux_lm + m.up_flux_lm, p.distribution.band_flux_lm(), 1e-9 * m.down_flux_lm);
    EXPECT_NEAR(m.interpolated_down_flux_lm, p.distribution.interpolated_flux_lm(), 1e-9 * m.down_flux_lm);
    for (int i = 0; i < 4; ++i) EXPECT_NEAR(m.zonal_flux_lm[i] / c.zonal_flux_lm[i], 1, 4e-3) << name << " " << i;
    EXPECT_NEAR(m.up_flux_lm, 0, 1e-9 * m.down_flux_lm);
  }
}

// Beams narrower than any grid over the sphere, alone and with a skirt around them: all of it goes down.
TEST(Flux, OfNarrowBeamsInTablesOfTypesAAndB) {
  for (const PhotometricType type : {PhotometricType::a, PhotometricType::b})
    for (const double half : {0.3, 0.1, 0.005})
      for (const double skirt : {0.0, 10.0}) {
        const std::vector<double> plane = {-90, 30 - half - 1e-6, 30 - half, 30 + half, 30 + half + 1e-6, 90};
        std::vector<double> table(36, skirt);
        for (size_t i : {2, 3})
          for (size_t j : {2, 3}) table[6 * i + j] = 1e6;
        const Photometry p{Distribution(type, plane, plane, table)};
        const Metrics m = metrics_of(p);
        const double all = p.distribution.band_flux_lm();
        EXPECT_NEAR(m.down_flux_lm, all, 1e-9 * all) << half;
        EXPECT_EQ(m.up_flux_lm, 0) << half;
        // cos gamma = cos 30 cos 30: the beam lies at 41.4 degrees.
        const double ring = skirt * 2 * pi * (std::cos(rad(40)) - std::cos(rad(43))),
                     beam = 1e6 * rad(2 * half) * (std::sin(rad(30 + half)) - std::sin(rad(30 - half)));
        EXPECT_NEAR(zonal_flux_lm(p, 40, 43, FluxRule::interpolated) / (ring + beam), 1, 3e-3) << half << " " << skirt;
      }
}

TEST(Beam, OfATypeBTableIsExactInThePrincipalPlanes) {
  // V (up, C0) falls linearly to both sides by 1 cd a degree above and 2 below; H by 1 to both sides.
  const std::vector<double> v = {-40, 0, 80}, h = {-60, 0, 60};
  std::vector<double> table;
  for (double a : v)
    for (double b : h) table.push_back(100 - std::abs(a) * (a < 0 ? 2 : 1) - (a == 0 ? std::abs(b) : 0));
  const Photometry p{Distribution(PhotometricType::b, v, h, table)};
  const Beam up = beam_of(p, 0, 0.5), across = beam_of(p, 90, 0.5);
  EXPECT_NEAR(up.from_deg, -25, 1e-7);
  EXPECT_NEAR(up.to_deg, 50, 1e-7);
  EXPECT_NEAR(across.angle_deg, 100, 1e-7);
  EXPECT_NEAR(beam_of(p, 90, 0.1).angle_deg, 120, 1e-7);  // where the table ends
}

TEST(Flux, ByZonesFollowsEachRule) {
  const Photometry p = tabulate({0, 40, 100, 210}, {0, 25, 50, 85, 120, 180},
                                [](double c, double g) { return 100 + 30 * std::cos(rad(c)) * std::sin(rad(g)) + g; });
  const Distribution& d = p.distribution;
  EXPECT_NEAR(zonal_flux_lm(p, 0, 180, FluxRule::band), d.band_flux_lm(), 1e-9 * d.band_flux_lm());
  EXPECT_NEAR(zonal_flux_lm(p, 0, 180, FluxRule::interpolated), d.interpolated_flux_lm(), 1e-9 * d.band_flux_lm());
  const Metrics m = metrics_of(p);
  EXPECT_NEAR(m.down_flux_lm + m.up_flux_lm, d.band_flux_lm(), 1e-9 * d.band_flux_lm());
  EXPECT_NEAR(m.interpolated_down_flux_lm + m.interpolated_up_flux_lm, d.interpolated_flux_lm(), 1e-6);
  EXPECT_EQ(m.zonal_flux_lm[3], m.down_flux_lm);
  EXPECT_EQ(m.zonal_flux_lm[4], m.up_flux_lm);
  // The interpolated integral against a midpoint rule over eval().
  double sum = 0;
  constexpr int n = 1200;
  for (int j = 0; j < n; ++j) {
    const double g = rad(40) * (j + 0.5) / n;
    for (int i = 0; i < n; ++i) {
      const double c = 2 * pi * (i + 0.5) / n;
      sum += d.eval(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g)) * std::sin(g);
    }
  }
  sum *= rad(40) * 2 * pi / n / n;
  EXPECT_NEAR(zonal_flux_lm(p, 0, 40, FluxRule::interpolated), sum, 1e-6 * sum);
}

TEST(Flux, ByTheBandRulePartsABandBySolidAngle) {
  const Photometry p = axial({0, 60, 120}, {100, 60, 20});
  const double mean[] = {80, 40};  // of the bands
  const auto solid = [](double a, double b) { return 2 * pi * (std::cos(rad(a)) - std::cos(rad(b))); };
  EXPECT_NEAR(zonal_flux_lm(p, 0, 30, FluxRule::band), mean[0] * solid(0, 30), 1e-9);
  EXPECT_NEAR(zonal_flux_lm(p, 0, 90, FluxRule::band), mean[0] * solid(0, 60) + mean[1] * solid(60, 90), 1e-9);
  EXPECT_NEAR(zonal_flux_lm(p, 90, 180, FluxRule::band), mean[1] * solid(90, 120), 1e-9);
}

TEST(Metrics, RatiosAreUnknownWithoutWhatTheyReferTo) {
  Photometry p = axial({0, 90, 180}, {10, 10, 10});
  EXPECT_LT(metrics_of(p).light_output_ratio, 0);
  EXPECT_LT(metrics_of(p).efficacy_lm_per_w, 0);
  p.rated_flux_lm = 80 * pi;
  p.input_power_w = 4;
  EXPECT_NEAR(metrics_of(p).light_output_ratio, 0.5, 1e-12);
  EXPECT_NEAR(metrics_of(p).efficacy_lm_per_w, 10 * pi, 1e-9);
  // An LED file that states one chip's flux (before: a ratio of 20, utilisation factors above 1).
  p.rated_flux_lm = 2 * pi;
  EXPECT_LT(metrics_of(p).light_output_ratio, 0);
  EXPECT_LT(lamp_flux_lm(p), 0);
  EXPECT_EQ(flux_code(p).n[4], 100);
  EXPECT_LT(utilisation_factors(p).factor[0][0], 1);
}

Opening opening_of(OpeningShape shape, float x, float y, float z, int axis = 2) {
  Opening o;
  o.shape = shape;
  o.size_m[0] = x, o.size_m[1] = y, o.size_m[2] = z;
  o.axis = axis;
  return o;
}

TEST(Luminance, OfProjectedAreas) {
  const double h = std::sqrt(0.5);
  EXPECT_EQ(projected_area_m2(opening_of(OpeningShape::point, 0, 0, 0), 0, 0, -1), 0);
  EXPECT_NEAR(projected_area_m2(opening_of(OpeningShape::rectangle, 2, 3, 0), 0, 5, -5), 6 * h, 1e-6);
  EXPECT_NEAR(projected_area_m2(opening_of(OpeningShape::disc, 0, 2, 4), 1, 0, 0), 2 * pi, 1e-6);
  EXPECT_NEAR(projected_area_m2(opening_of(OpeningShape::box, 2, 3, 4), 1, 1, 1), 26 / std::sqrt(3.0), 1e-6);
  EXPECT_NEAR(projected_area_m2(opening_of(OpeningShape::sphere, 2, 2, 2), 1, 2, -3), pi, 1e-6);
  EXPECT_NEAR(projected_area_m2(opening_of(OpeningShape::sphere, 2, 4, 6), 0, 1, 0), 3 * pi, 1e-6);
  EXPECT_NEAR(projected_area_m2(opening_of(OpeningShape::cylinder, 2, 2, 5), 1, 0, -1), (pi + 10) * h, 1e-6);
  EXPECT_NEAR(projected_area_m2(opening_of(OpeningShape::disc, 2, 2, 5), 1, 0, -1), (pi + 10) * h, 1e-6);
  EXPECT_NEAR(projected_area_m2(opening_of(OpeningShape::cylinder, 5, 2, 4, 0), 0, 0, -1), 10, 1e-6);
  EXPECT_NEAR(projected_area_m2(opening_of(OpeningShape::cylinder, 5, 2, 4, 0), 0, 1, 0), 20, 1e-6);
}

TEST(Luminance, OfALambertianDiscIsTheSameFromEverywhere) {
  std::vector<double> g = steps(0, 90, 18);  // holds 45, 65, 75 and 85
  Photometry p = tabulate({0}, g, [](double, double gamma) { return 100 * std::cos(rad(gamma)); });
  EXPECT_LT(metrics_of(p).luminance_cd_m2[0][0], 0);  // a point has none
  p.opening = opening_of(OpeningShape::disc, 0.2f, 0.2f, 0);
  const Metrics m = metrics_of(p);
  for (const auto& plane : m.luminance_cd_m2)
    for (double luminance : plane) EXPECT_NEAR(luminance, 100 / (pi * 0.01), 0.01);
  EXPECT_LT(luminance_cd_m2(p, 1, 0, 0), 0);  // edge on
}

}  // namespace
}  // namespace photometry
