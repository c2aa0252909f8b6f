// The virtual goniophotometer against distributions that are known: intensity, flux balance, symmetry and errors.
//
// Seeds are fixed. The nodes of a grid are judged by the noise and the bias that they state, which shows what is wrong
// in one direction by some percent; what is wrong with the light as a whole by sums: flux, and the intensities of each
// half plane, weighed as flux is, whose mean over the planes finds 1 % (expect_lx.h; P(|t_23| > 4) = 0.06 %). Single
// nodes whose intensity has no slope, and no bias, are judged by expect_lx.h.
#include <gtest/gtest.h>

#include <cmath>

#include "../support/expect_lx.h"
#include "../support/image_mean.h"
#include "ies_text.h"

namespace ups::test {
namespace {

struct Worst {
  double z = 0, relative = 0, mean_bound = 0;
};
// intensity_cd(c, gamma in rad) against all nodes.
template <class Intensity>
Worst compare(const Result& result, const Sensor& g, const Intensity& intensity) {
  const auto nodes = result.intensities(g);
  Worst worst;
  for (uint32_t c = 0; c < g.planes; ++c)
    for (uint32_t i = 0; i < g.gammas; ++i) {
      const ups_intensity_reading& r = nodes[size_t(c) * g.gammas + i];
      const double exact = intensity(2 * pi_d * c / g.planes, pi_d * i / (g.gammas - 1));
      const double off = std::abs(double(r.intensity_cd) - exact);
      // the bound is |bias| + t * noise, t of 15 degrees of freedom
      const double bias = std::abs(double(r.bias_cd)), noise = (double(r.error_bound_cd) - bias) / 2.131;
      if (off > bias + 1e-6 * exact) worst.z = std::max(worst.z, (off - bias) / noise);
      if (exact > 0) worst.relative = std::max(worst.relative, off / exact);
      worst.mean_bound += r.error_bound_cd / double(nodes.size());
    }
  return worst;
}

// The half planes' intensities over the right ones: their spread is that of the mean, or more, as flux is shared.
template <class Intensity>
void expect_planes(const Result& result, const Sensor& g, const Intensity& intensity) {
  const auto nodes = result.intensities(g);
  std::vector<double> ratios;
  for (uint32_t c = 0; c < g.planes; ++c) {
    double found = 0, exact = 0;
    for (uint32_t i = 0; i < g.gammas; ++i) {
      const double gamma = pi_d * i / (g.gammas - 1);
      found += std::sin(gamma) * double(nodes[size_t(c) * g.gammas + i].intensity_cd);
      exact += std::sin(gamma) * intensity(2 * pi_d * c / g.planes, gamma);
    }
    ratios.push_back(found / exact);
  }
  const Mean mean = mean_of(ratios);
  expect_lx(mean.value, mean.standard_error, 1, quiet, "half planes");
}

// 37 x 24 nodes, t with 15 degrees of freedom: |z| > 6.5 happens about once in 100 seeds.
constexpr double most_z = 6.5;

TEST(Goniometer, MeasuresAProfileAsTheFileHasIt) {
  Scene scene;
  const auto law = [](double g) { return g < pi_d / 2 ? 500 * std::pow(std::cos(g), 2) : 0.0; };
  const auto profile = parse(scene.context(), ies_text(law, 90, 0));
  scene.add_luminaire(profile.get(), {1, 2, 3}, {0, 0, -1}, false);
  const Sensor g = scene.add_goniometer(24, 37);
  const Result result = scene.render({.method = UPS_METHOD_AUTO, .iterations = 32});
  EXPECT_EQ(result.info().method, UPS_METHOD_LIGHT_TRACING);
  const auto exact = [&](double, double gamma) { return law(gamma); };
  expect_planes(result, g, exact);
  const Worst worst = compare(result, g, exact);
  EXPECT_LT(worst.z, most_z);
  EXPECT_LT(worst.mean_bound, 2.5);  // cd, of a peak of 500
  const ups_goniometer_info info = result.goniometer_info(g);
  EXPECT_NEAR(info.light_output_ratio, 1, 1e-6);
  EXPECT_NEAR(info.flux_lm, info.emitted_flux_lm, 1e-6 * info.emitted_flux_lm);
}

// A Lambertian square that shines down into a scene without anything else: I = L A cos(gamma).
TEST(Goniometer, MeasuresALambertianSurface) {
  Scene scene;
  scene.add(box({0, 0, 0}, {0.2, 0.3, 1e-4}), emitter(1000));
  const Sensor g = scene.add_goniometer(24, 37);
  const Result result = scene.render({.method = UPS_METHOD_UPS, .iterations = 32});
  const auto exact = [](double c, double gamma) {  // six faces
    const double sides = std::sin(gamma) * (std::abs(std::cos(c)) * 0.3 + std::abs(std::sin(c)) * 0.2) * 1e-4;
    return 1000 * (0.06 * std::abs(std::cos(gamma)) + sides);
  };
  expect_planes(result, g, exact);
  EXPECT_LT(compare(result, g, exact).z, most_z);
  EXPECT_NEAR(result.goniometer_info(g).flux_lm, result.info().escaped_flux_lm, 1e-6 * result.info().escaped_flux_lm);
}

// Above a mirror a point light is two, but for what the mirror absorbs: flux balance and output ratio, to 0.2 %. Within
// the upper half the mean over nodes finds 1 % (P(|t_17| > 4) = 0.09 %); at 120 degrees one node finds 2 % in 99 cases
// of 100, the zenith's, which is 0.02 % of the half space, 30 %.
TEST(Goniometer, BalancesFlux) {
  Scene scene;
  scene.add(box({-50, -50, -0.1}, {50, 50, 0}), mirror(0.8));
  scene.add_point_light({0, 0, 0.01}, 100);
  const Sensor g = scene.add_goniometer(1, 91, UPS_SYMMETRY_AXIAL);
  const Result result = scene.render({.method = UPS_METHOD_LIGHT_TRACING, .iterations = 16});
  const ups_goniometer_info info = result.goniometer_info(g);
  EXPECT_NEAR(info.flux_lm + info.absorbed_flux_lm, info.emitted_flux_lm, 1e-4 * info.emitted_flux_lm);
  EXPECT_NEAR(info.light_output_ratio, 0.9, 0.9 * 2e-3);
  const auto nodes = result.intensities(g);
  const auto expect_node = [&](size_t i, const OneOf& noise) {
    expect_lx(nodes[i].intensity_cd, nodes[i].standard_error_cd, 180, noise, "node " + std::to_string(i));
  };
  expect_node(60, one_of(0.003));
  expect_node(90, one_of(0.06));
  std::vector<double> inner;  // 100 to 168 degrees; neighbours share light
  for (size_t i = 50; i <= 84; i += 2) inner.push_back(double(nodes[i].intensity_cd));
  const Mean mean = mean_of(inner);
  expect_lx(mean.value, mean.standard_error, 180, quiet, "inner nodes");
  EXPECT_EQ(nodes[20].intensity_cd, 0);  // below the mirror
}

// The interpolated table carries exactly the flux that was found;
// with the measured profile in a luminaire the light is there.
TEST(Goniometer, ItsProfileCarriesTheFlux) {
  Scene scene;
  scene.add(box({0, 0, 0}, {0.1, 0.1, 0.05}), emitter(2000));
  const Sensor g = scene.add_goniometer(16, 19, UPS_SYMMETRY_QUADRANTS);
  const Result result = scene.render({.method = UPS_METHOD_LIGHT_TRACING, .iterations = 8});
  const auto profile = result.goniometer_profile(g);
  ups_profile_info info{};
  info.struct_size = sizeof info;
  ASSERT_EQ(ups_profile_get_info(profile.get(), &info), UPS_OK);
  const ups_goniometer_info measured = result.goniometer_info(g);
  EXPECT_NEAR(info.interpolated_flux_lm, measured.flux_lm, 1e-6 * measured.flux_lm);
  EXPECT_EQ(info.symmetry, UPS_SYMMETRY_QUADRANTS);
  const auto nodes = result.intensities(g);
  for (uint32_t i = 0; i < 19; ++i) {
    EXPECT_EQ(nodes[2 * 19 + i].intensity_cd, nodes[6 * 19 + i].intensity_cd);
    EXPECT_EQ(nodes[2 * 19 + i].intensity_cd, nodes[14 * 19 + i].intensity_cd);
  }
}

// A sharp edge is blurred by the grid: a node has the mean over its hat, which is known. False alarms and what is
// found: expect_lx.h, three times.
TEST(Goniometer, ReportsWhatItsGridBlurs) {
  Scene scene;
  const double inner = 0.4999 * pi_d / 3, outer = 0.5 * pi_d / 3,
               edge = inner + (outer - inner) / 3;  // a sharp one that would let as much through
  scene.add_spot({0, 0, 0}, {0, 0, -1}, 1000, inner, outer);
  const Sensor g = scene.add_goniometer(1, 37, UPS_SYMMETRY_AXIAL);
  const auto nodes = scene.render({.method = UPS_METHOD_LIGHT_TRACING, .iterations = 32}).intensities(g);
  const auto expect_node = [&](size_t i, double cd) {
    expect_lx(nodes[i].intensity_cd, nodes[i].standard_error_cd, cd, quiet, "node " + std::to_string(i));
  };
  expect_node(4, 1000);
  EXPECT_EQ(nodes[8].intensity_cd, 0);
  // One step inside, the hat reaches the edge exactly: no blur.
  expect_node(5, 1000);
  // At 30 degrees, the edge itself, half of the hat is bright. Integrals of its sides times the sine, rising and
  // falling.
  const auto deg = [](double d) { return d * pi_d / 180; };
  const double step = deg(5), low = deg(25), high = deg(35),
               bright = (std::sin(edge) - std::sin(low) - (edge - low) * std::cos(edge)) / step,
               rising = (std::sin(deg(30)) - std::sin(low)) / step - std::cos(deg(30)),
               falling = std::cos(deg(30)) - (std::sin(high) - std::sin(deg(30))) / step;
  expect_node(6, 1000 * bright / (rising + falling));
}

TEST(Goniometer, SaysWhereItMeasuresNothing) {
  Scene scene;
  scene.add_point_light({0, 0, 0}, 100);
  scene.add_goniometer(1, 3, UPS_SYMMETRY_AXIAL);
  const Result result = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 4});
  EXPECT_NE(result.text(UPS_TEXT_WARNINGS).find("traces no light paths"), std::string::npos);
}

// A round lamp that is aimed 15 degrees towards C0 is symmetric about the plane C0-C180 alone.
TEST(Goniometer, WarnsOfLightWithoutTheSymmetryAskedFor) {
  const auto law = [](double g) { return g < pi_d / 2 ? 500 * std::pow(std::cos(g), 2) : 0.0; };
  const auto warned = [&](ups_profile_symmetry symmetry, double tilt) {
    Scene scene;
    const auto profile = parse(scene.context(), ies_text(law, 90, 0));
    scene.add_luminaire(profile.get(), {0, 0, 0}, {std::sin(tilt), 0, -std::cos(tilt)}, false);
    scene.add_goniometer(symmetry == UPS_SYMMETRY_AXIAL ? 1 : 8, 19, symmetry);
    const Result result = scene.render({.method = UPS_METHOD_LIGHT_TRACING, .iterations = 16, .light_paths = 1u << 13});
    return result.text(UPS_TEXT_WARNINGS).find("has not the symmetry") != std::string::npos;
  };
  const double tilt = 15 * pi_d / 180;
  for (const auto symmetry : {UPS_SYMMETRY_AXIAL, UPS_SYMMETRY_C90_C270, UPS_SYMMETRY_QUADRANTS}) {
    EXPECT_TRUE(warned(symmetry, tilt)) << symmetry;
    EXPECT_FALSE(warned(symmetry, 0)) << symmetry;  // six standard errors: once in 10,000 seeds
  }
  for (const auto symmetry : {UPS_SYMMETRY_NONE, UPS_SYMMETRY_C0_C180}) EXPECT_FALSE(warned(symmetry, tilt));
}

TEST(Goniometer, PlanesMustBeAsSymmetricAsAskedFor) {
  Scene scene;
  EXPECT_THROW(scene.add_goniometer(5, 19, UPS_SYMMETRY_QUADRANTS), std::runtime_error);
  EXPECT_THROW(scene.add_goniometer(4, 19, UPS_SYMMETRY_AXIAL), std::runtime_error);
  EXPECT_THROW(scene.add_goniometer(4, 1), std::runtime_error);
}

}  // namespace
}  // namespace ups::test
