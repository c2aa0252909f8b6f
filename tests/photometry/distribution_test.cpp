// Is the interpolated intensity right, are its fluxes, and do samples follow it exactly? The expected numbers come from
// quadrature of eval(), which shares no code with the sampler. Chi-square tests: fixed seeds, false-alarm rate 1e-4
// each; densities that are off by 1.9 %, root mean square, are found in 97.7 of 100 cases, by stratified numbers 1.4 %.
#include "photometry/distribution.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "photometry/files.h"
#include "support/chi_square.h"

namespace photometry {
namespace {

using test::rad;
using test::steps;
constexpr double pi = 3.14159265358979323846;
constexpr double false_alarm = 1e-4;
constexpr double largest_u = 0x1.fffffep-1;  // below 1, as the engine's numbers are

Distribution tabulate(std::vector<double> c_deg, std::vector<double> gamma_deg,
                      const std::function<double(double c, double gamma)>& intensity) {
  std::vector<double> table;
  for (double c : c_deg)
    for (double g : gamma_deg) table.push_back(intensity(rad(c), rad(g)));
  return Distribution(std::move(c_deg), std::move(gamma_deg), std::move(table));
}

double eval_at(const Distribution& d, double c, double gamma) {
  return d.eval(std::sin(gamma) * std::cos(c), std::sin(gamma) * std::sin(c), -std::cos(gamma));
}

// Of intensity times sin(gamma), by the midpoint rule.
double integral(const Distribution& d, double c0, double c1, double g0, double g1, int n) {
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      const double gamma = g0 + (g1 - g0) * (i + 0.5) / n;
      sum += eval_at(d, c0 + (c1 - c0) * (j + 0.5) / n, gamma) * std::sin(gamma);
    }
  return sum * (c1 - c0) * (g1 - g0) / n / n;
}

// Cells between the given gammas, columns of even width in C.
struct Cells {
  std::vector<double> gamma_rad;
  int columns;
  size_t size() const { return (gamma_rad.size() - 1) * size_t(columns) + 1; }  // the last: everything else
  size_t index(const Distribution::Sample& s) const {
    const double gamma = std::atan2(std::hypot(s.x, s.y), -s.z);
    double c = std::atan2(s.y, s.x) / (2 * pi);
    if (c < 0) c += 1;
    if (gamma < gamma_rad.front() || gamma > gamma_rad.back()) return size() - 1;
    const auto row = std::upper_bound(gamma_rad.begin() + 1, gamma_rad.end() - 1, gamma) - gamma_rad.begin() - 1;
    return size_t(row) * size_t(columns) + std::min(size_t(c * columns), size_t(columns) - 1);
  }
  std::vector<double> expected(const Distribution& d, double samples) const {
    std::vector<double> out(size(), 0.0);
    for (size_t i = 0; i + 1 < gamma_rad.size(); ++i)
      for (int j = 0; j < columns; ++j)
        out[i * size_t(columns) + size_t(j)] =
            integral(d, 2 * pi * j / columns, 2 * pi * (j + 1) / columns, gamma_rad[i], gamma_rad[i + 1], 48) *
            samples / d.interpolated_flux_lm();
    return out;
  }
};

// u by strata x strata jittered cells of the unit square, or independent where strata is 0.
std::vector<double> observe(const Distribution& d, const Cells& cells, int samples, int strata, uint32_t seed) {
  std::mt19937 random(seed);
  const auto unit = [&] { return random() * 0x1p-32; };
  std::vector<double> out(cells.size(), 0.0);
  for (int i = 0; i < samples; ++i) {
    double u1 = unit(), u2 = unit();
    if (strata > 0) u1 = (i / strata % strata + u1) / strata, u2 = (i % strata + u2) / strata;
    const Distribution::Sample s = d.sample(u1, u2);
    EXPECT_GT(s.intensity_cd, 0);
    out[cells.index(s)] += 1;
  }
  return out;
}

void expect_exact_sampling(const Distribution& d, std::vector<double> gamma_edges_deg, uint32_t seed) {
  for (double& g : gamma_edges_deg) g = rad(g);
  const Cells cells{std::move(gamma_edges_deg), 18};
  constexpr int strata = 500, samples = strata * strata, more = 2;
  std::vector<double> expected = cells.expected(d, samples);
  // The map from the unit square is continuous but for lobes: stratified numbers give far less than random scatter.
  const auto stratified = ups::test::chi_square_test(observe(d, cells, samples, strata, seed + 1), expected);
  EXPECT_LT(stratified.statistic, 0.15 * stratified.degrees_of_freedom);
  EXPECT_LE(std::sqrt(0.15 * stratified.degrees_of_freedom / samples), 0.014);
  for (double& e : expected) e *= more;
  const auto independent = ups::test::chi_square_test(observe(d, cells, more * samples, 0, seed), expected);
  ASSERT_GT(independent.degrees_of_freedom, 8);
  EXPECT_GT(independent.p_value, false_alarm) << independent.statistic << " / " << independent.degrees_of_freedom;
  EXPECT_LE(ups::test::smallest_found(more * samples, independent.degrees_of_freedom, false_alarm), 0.019);
}

double smooth(double c, double g) { return 300 + 200 * std::cos(g) + 150 * std::sin(g) * std::cos(c - 0.7); }

TEST(Distribution, InterpolatesBilinearly) {
  const Distribution d({0, 90, 200}, {0, 30, 80}, {1, 2, 3, 10, 20, 30, 100, 200, 300});
  EXPECT_NEAR(eval_at(d, rad(0), rad(30)), 2, 1e-12);
  EXPECT_NEAR(eval_at(d, rad(45), rad(15)), 0.25 * (1 + 2 + 10 + 20), 1e-12);
  EXPECT_NEAR(eval_at(d, rad(145), rad(55)), 0.25 * (20 + 30 + 200 + 300), 1e-12);
  EXPECT_NEAR(eval_at(d, rad(280), rad(55)), 0.25 * (2 + 3 + 200 + 300), 1e-12);  // wraps
  EXPECT_NEAR(d.eval(0, 0, -5), 1, 1e-12);                                        // any length
  EXPECT_EQ(eval_at(d, rad(45), rad(80.001)), 0);                                 // outside the table
  EXPECT_EQ(d.eval(0, 0, 0), 0);
  EXPECT_EQ(d.peak_cd(), 300);
  EXPECT_EQ(d.peak_c_deg(), 200);
  EXPECT_EQ(d.peak_gamma_deg(), 80);
}

TEST(Distribution, EndsAtTheTablesEdgesInclusively) {
  const Distribution half({0}, {0, 90}, {5, 5}), upper({0}, {90, 180}, {5, 5});
  EXPECT_EQ(half.eval(1, 0, 0), 5);
  EXPECT_EQ(half.eval(1, 0, 1e-9), 0);
  EXPECT_EQ(upper.eval(0, 0, 1), 5);
  EXPECT_EQ(upper.eval(1, 0, -1e-9), 0);
}

TEST(Distribution, FluxOfClosedForms) {
  const Distribution isotropic({0}, {0, 60, 180}, {2, 2, 2});
  EXPECT_NEAR(isotropic.band_flux_lm(), 8 * pi, 1e-12);
  EXPECT_NEAR(isotropic.interpolated_flux_lm(), 8 * pi, 1e-12);
  // I = 1 - 2 gamma / pi on the lower half: 2 pi (1 - 2/pi) exactly.
  const Distribution ramp({0}, {0, 90}, {1, 0});
  EXPECT_NEAR(ramp.interpolated_flux_lm(), 2 * pi * (1 - 2 / pi), 1e-13);
  EXPECT_NEAR(ramp.band_flux_lm(), pi, 1e-13);
  // Lambertian in fine steps: pi I0 with an error of the order of the step's square.
  const Distribution lambert = tabulate({0}, steps(0, 90, 900), [](double, double g) { return std::cos(g); });
  EXPECT_NEAR(lambert.band_flux_lm(), pi, 1e-5);
  EXPECT_NEAR(lambert.interpolated_flux_lm(), pi, 1e-5);
}

TEST(Distribution, InterpolatedFluxIsTheIntegralOfEval) {
  const Distribution d = tabulate({0, 15, 90, 100, 210, 359}, {0, 1, 10, 11, 45, 90, 140, 179, 180}, smooth);
  EXPECT_NEAR(integral(d, 0, 2 * pi, 0, pi, 2000) / d.interpolated_flux_lm(), 1, 2e-6);
}

TEST(Distribution, SamplesASmoothTable) {
  expect_exact_sampling(tabulate(steps(0, 345, 23), steps(0, 180, 36), smooth), steps(0, 180, 17), 1);
}

TEST(Distribution, SamplesIrregularSteps) {
  expect_exact_sampling(tabulate({0, 15, 90, 100, 210, 359}, {0, 1, 10, 11, 45, 90, 140, 179, 180}, smooth),
                        steps(0, 180, 17), 2);
}

TEST(Distribution, SamplesASinglePlaneOfTwoAngles) {
  expect_exact_sampling(Distribution({0}, {0, 180}, {7, 7}), steps(0, 180, 17), 3);
  expect_exact_sampling(Distribution({0}, {20, 160}, {0, 7}), steps(20, 160, 17), 4);
}

TEST(Distribution, SamplesANeedleAtTheNadirAndAtTheZenith) {
  expect_exact_sampling(Distribution({0}, {0, 0.1}, {1e6, 0}), steps(0, 0.1, 17), 5);
  expect_exact_sampling(Distribution({0}, {179.9, 180}, {0, 1e6}), steps(179.9, 180, 17), 6);
}

// Intensity at one node, 0.1 degrees from its neighbours, in the middle of a dark table.
TEST(Distribution, SamplesANeedleAside) {
  std::vector<double> table(3 * 7, 0.0);
  table[1 * 7 + 3] = 1e6;
  const Distribution d({0, 0.1, 0.2}, {0, 40, 46.9, 47, 47.1, 60, 180}, table);
  std::mt19937 random(7);
  double c_sum = 0, gamma_sum = 0;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    const Distribution::Sample s = d.sample(random() * 0x1p-32, random() * 0x1p-32);
    const double c = std::atan2(s.y, s.x) * 180 / pi, gamma = std::acos(-s.z) * 180 / pi;
    ASSERT_GT(c, 0);
    ASSERT_LT(c, 0.2);
    ASSERT_GT(gamma, 46.9);
    ASSERT_LT(gamma, 47.1);
    ASSERT_NEAR(d.eval(s.x, s.y, s.z), s.intensity_cd, 1e-6 * d.peak_cd());
    c_sum += c;
    gamma_sum += gamma;
  }
  // Triangular densities of half width 0.1: the mean's standard deviation is 0.1 / sqrt(6 n); 4.5 of them, 1e-5 both.
  EXPECT_NEAR(c_sum / n, 0.1, 4.5 * 0.1 / std::sqrt(6.0 * n));
  EXPECT_NEAR(gamma_sum / n, 47, 4.5 * 0.1 / std::sqrt(6.0 * n));
}

TEST(Distribution, NeverSamplesDarkness) {
  // Two lobes, dark between them, at the poles, and in most of the planes.
  const auto lobes = [](double c, double g) {
    const double down = std::max(0.0, std::sin(3 * g)) * (g < rad(59) && g > rad(1)), up = g > rad(130) && g < rad(170);
    return (down + up) * (c > rad(60) && c < rad(130));
  };
  const Distribution d = tabulate(steps(0, 350, 35), steps(0, 180, 36), lobes);
  expect_exact_sampling(d, steps(0, 180, 17), 8);
  std::vector<double> u = {0, 0x1p-24, 0.5, largest_u};
  for (int i = 0; i < 1000; ++i) u.push_back(i / 1000.0);
  for (double u1 : u)
    for (double u2 : {0.0, 0x1p-24, 0.3, largest_u}) {
      const Distribution::Sample s = d.sample(u1, u2);
      ASSERT_GT(s.intensity_cd, 0) << u1 << " " << u2;
      ASSERT_TRUE(std::isfinite(s.x + s.y + s.z));
    }
}

TEST(Distribution, SampleAgreesWithEvalAndPdf) {
  const Distribution d = tabulate({0, 15, 90, 100, 210, 359}, {0, 1, 10, 11, 45, 90, 140, 179, 180}, smooth);
  std::mt19937 random(9);
  for (int i = 0; i < 10000; ++i) {
    const Distribution::Sample s = d.sample(random() * 0x1p-32, random() * 0x1p-32);
    ASSERT_NEAR(s.x * s.x + s.y * s.y + s.z * s.z, 1, 1e-14);
    ASSERT_NEAR(d.eval(s.x, s.y, s.z), s.intensity_cd, 1e-9 * d.peak_cd());
    ASSERT_NEAR(d.pdf_w(s.x, s.y, s.z), s.pdf_w, 1e-9 * d.peak_cd() / d.interpolated_flux_lm());
    ASSERT_NEAR(s.pdf_w * d.interpolated_flux_lm(), s.intensity_cd, 1e-12 * d.peak_cd());
  }
}

// Where a row or a plane is dark on one side, one number belongs to many directions: what counts is that the way back
// gives the number again, wherever in the dark the direction lies. Near the axis the azimuth is lost with the digits.
TEST(Distribution, InvertFindsTheNumbersOfASample) {
  const auto sector = [](double c, double g) {
    return double(g > rad(20) && g < rad(100) && c > rad(60) && c < rad(130));
  };
  const std::vector<Distribution> tables = {
      tabulate({0, 15, 90, 100, 210, 359}, {0, 1, 10, 11, 45, 90, 140, 179, 180}, smooth),
      tabulate(steps(0, 350, 35), steps(0, 180, 36), sector),
      Distribution({0}, {20, 160}, {0, 7}),
      Distribution({30}, {0, 0.1}, {1e6, 0}),
      Distribution(PhotometricType::b, {-40, 0, 70}, {-30, 10, 60}, {1, 2, 3, 4, 5, 6, 7, 8, 9}),
      Distribution(PhotometricType::a, {-40, 0, 70}, {-30, 10, 60}, {1, 0, 3, 0, 0, 6, 7, 8, 0})};
  std::mt19937 random(19);
  for (const Distribution& d : tables)
    for (int i = 0; i < 10000; ++i) {
      const double u1 = random() * 0x1p-32, u2 = random() * 0x1p-32;
      const Distribution::Sample s = d.sample(u1, u2);
      double v1, v2;
      ASSERT_TRUE(d.invert(2 * s.x, 2 * s.y, 2 * s.z, v1, v2));
      const double off_axis = d.type() == PhotometricType::c ? std::hypot(s.x, s.y) : 0.5;
      ASSERT_NEAR(v1, u1, 1e-9);
      ASSERT_NEAR(std::remainder(v2 - u2, 1), 0, 1e-11 + 1e-14 / off_axis);
    }
  double v1, v2;
  EXPECT_FALSE(tables[1].invert(0, 0, -1, v1, v2));
  EXPECT_FALSE(tables[2].invert(0, 0, 1, v1, v2));
  EXPECT_FALSE(tables[0].invert(0, 0, 0, v1, v2));
  EXPECT_FALSE(Distribution({0}, {0, 90}, {0, 0}).invert(1, 0, -1, v1, v2));
}

// The inversion is exact: the flux below a sampled gamma is u1 of the whole, to the quadrature's error.
TEST(Distribution, InvertsTheFluxBelowGamma) {
  for (const Distribution& d : {Distribution({0}, {0, 30, 180}, {1, 4, 0}), Distribution({0}, {0, 1e-3}, {0, 1}),
                                Distribution({0}, {0, 180}, {0, 1}), Distribution({0}, {0, 180}, {1, 0})}) {
    double previous = -1;
    for (double u1 : {0x1p-24, 1e-3, 0.01, 0.2, 0.5, 0.9, 0.999, largest_u}) {
      const Distribution::Sample s = d.sample(u1, 0.25);
      const double gamma = std::atan2(std::hypot(s.x, s.y), -s.z);
      double below = 0;
      constexpr int n = 20000;
      for (int i = 0; i < n; ++i) {
        const double g = gamma * (i + 0.5) / n;
        below += 2 * pi * eval_at(d, 0, g) * std::sin(g) * gamma / n;
      }
      EXPECT_NEAR(below / d.interpolated_flux_lm(), u1, 1e-7);
      EXPECT_GT(gamma, previous);
      previous = gamma;
    }
  }
}

// Rows that no float, and hardly a double, tells apart.
TEST(Distribution, AnglesMayLieAsCloseAsNumbersDo) {
  const Distribution wide({0}, {0, 90}, {50, 10});
  for (const double step : {1e-310, 1e-305, 1e-38, 2e-37, 1e-20}) {
    const Distribution d({0}, {0, step, 90}, {100, 50, 10});
    EXPECT_NEAR(d.interpolated_flux_lm(), wide.interpolated_flux_lm(), 1e-9) << step;
    for (const double gamma : {0.1, 45.0, 89.0}) {
      EXPECT_NEAR(eval_at(d, 1, rad(gamma)), eval_at(wide, 1, rad(gamma)), 1e-9) << step;
      const auto x = float(std::sin(rad(gamma))), z = float(-std::cos(rad(gamma)));
      EXPECT_NEAR(d.fast_pdf_w(x, 0, z), wide.fast_pdf_w(x, 0, z), 1e-6) << step;
    }
    EXPECT_TRUE(std::isfinite(Distribution({0}, {0, step}, {100, 50}).interpolated_flux_lm())) << step;
  }
}

TEST(Distribution, WithoutLightHasNoSamples) {
  const Distribution d({0}, {0, 90}, {0, 0});
  EXPECT_EQ(d.interpolated_flux_lm(), 0);
  EXPECT_EQ(d.sample(0.5, 0.5).pdf_w, 0);
  EXPECT_EQ(d.pdf_w(0, 0, -1), 0);
}

std::string refusal(std::vector<double> c, std::vector<double> g, std::vector<double> cd) {
  try {
    Distribution(std::move(c), std::move(g), std::move(cd));
  } catch (const std::invalid_argument& e) {
    return e.what();
  }
  return "accepted";
}

TEST(Distribution, NamesWhatIsInvalid) {
  EXPECT_NE(refusal({}, {0, 90}, {}).find("c_deg"), std::string::npos);
  EXPECT_NE(refusal({0}, {0}, {1}).find("gamma_deg"), std::string::npos);
  EXPECT_NE(refusal({0, 90, 80}, {0, 90}, {1, 1, 1, 1, 1, 1}).find("c_deg[2]"), std::string::npos);
  EXPECT_NE(refusal({0, 360}, {0, 90}, {1, 1, 1, 1}).find("c_deg[1]"), std::string::npos);
  EXPECT_NE(refusal({5, 90}, {0, 90}, {1, 1, 1, 1}).find("c_deg[0]"), std::string::npos);
  EXPECT_NE(refusal({0}, {0, 181}, {1, 1}).find("gamma_deg[1]"), std::string::npos);
  EXPECT_NE(refusal({0}, {NAN, 90}, {1, 1}).find("gamma_deg[0]"), std::string::npos);
  EXPECT_NE(refusal({0}, {0, 90}, {1, 1, 1}).find("intensity_cd"), std::string::npos);
  EXPECT_NE(refusal({0}, {0, 90}, {1, -1}).find("intensity_cd[1]"), std::string::npos);
  EXPECT_NE(refusal({0}, {0, 90}, {INFINITY, 1}).find("intensity_cd[0]"), std::string::npos);
  EXPECT_NE(refusal({0}, {0, 90}, {1e308, 1e308}).find("too large"), std::string::npos);
}

}  // namespace
}  // namespace photometry
