// Photons where arithmetic ends: radii below what coordinates resolve, and all photons of a render in one cell.
#include <numeric>

#include "../support/expect_lx.h"
#include "../support/image_mean.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

double mean(const std::vector<float>& v) { return std::accumulate(v.begin(), v.end(), 0.0) / double(v.size()); }

struct Floor {
  Scene scene;
  Sensor camera, meters;
  Floor() {
    scene.add(quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), matte(0.5));
    scene.add(quad({-2, -2, 2}, {0, 4, 0}, {4, 0, 0}), matte(0.5));
    scene.add_point_light({0.2, 0.1, 1.5}, 100);
    camera = scene.add_camera({0, 0, 1.2}, {0, 0, -1}, 8, 8, 0.6);
    meters = scene.add_meters({{0.5, 0.5, 0}, {0, 0, 0}}, {0, 0, 1});
  }
  double luminance(const RenderOptions& options) { return mean(scene.render(options).image(camera).luminance); }
};

// alpha near 0 lets r^2 fall as 1 / n: from 20 um to the 6 um that floats resolve here within some ten iterations. All
// that is read stays finite (Result sees to it) and nothing is dropped.
TEST(Hazard21, ARadiusThatReachesTheLeastIsKeptThereAndTold) {
  Floor floor;
  RenderOptions options{.iterations = 24, .merge_radius_m = 2e-5, .light_paths = 256, .radius_alpha = 1e-3};
  const std::string text = floor.scene.render(options).text(UPS_TEXT_WARNINGS);
  for (const char* words : {"camera 1: from iteration ", "after the first surface: from iteration ",
                            "the merge radius is kept at ", "the least that the coordinates of this scene resolve"})
    EXPECT_NE(text.find(words), std::string::npos) << words << " not in: " << text;
  EXPECT_EQ(text.find("meters"), std::string::npos) << "their discs do not shrink";
  options.iterations = 4;
  EXPECT_EQ(floor.scene.render(options).text(UPS_TEXT_WARNINGS).find("merge radius"), std::string::npos);
}

// A radius far below the least from the start: kept at the least from the first iteration on, by every method that
// merges; where others find the light it is all there: the ratio of images' means, from the same random numbers, over 8
// seeds. Its standard error is at most 0.05 %, and 0.2 % is allowed: 0.3 % is found in 98 of 100 cases, and a false
// alarm takes four standard errors, P(|t_7| > 4) = 0.5 %.
TEST(Hazard21, ARadiusBelowTheLeastLosesNoLight) {
  Floor floor;
  for (const double radius : {1e-12, 1e-30}) {
    const RenderOptions tiny{.iterations = 16, .merge_radius_m = radius, .light_paths = 1u << 12};
    for (const ups_method method :
         {UPS_METHOD_UPS, UPS_METHOD_PPM, UPS_METHOD_SPPM, UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING}) {
      RenderOptions options = tiny;
      options.method = method;
      const std::string text = floor.scene.render(options).text(UPS_TEXT_WARNINGS);
      EXPECT_NE(text.find("from iteration 1 on, the merge radius"), std::string::npos) << method_name(method) << text;
    }
    std::vector<double> ratios;
    for (uint64_t seed = 1; seed <= 8; ++seed) {
      RenderOptions options = tiny;
      options.seed = seed;
      const double with = floor.luminance(options);
      options.method = UPS_METHOD_BIDIRECTIONAL;
      ratios.push_back(with / floor.luminance(options));
    }
    const Mean ratio = mean_of(ratios);
    expect_within(ratio.value, ratio.standard_error, 1, 0.002, 5e-4, "radius " + short_number(radius));
  }
}

// The middles of pixels tell how wide to merge: of these each looks through a hole in the floor. Under parallel light
// L = rho E / pi times what is floor (before: 0). By expect_lx.h, of 8 seeds at a standard error of at most 0.33 %
// (P(|t_7| > 4) = 0.5 %): 2 % is found.
TEST(Taught, APixelWhoseMiddleSeesNothingMerges) {
  constexpr double rho = 0.5, lx = 1000, hole = 0.002, seen = 0.5, margin = 0.05;
  constexpr int pixels = 8;
  constexpr double side = 2 * seen / pixels, half = side / 2, around = half - hole;
  Scene scene;
  Shape floor;
  for (int i = 0; i < pixels * pixels; ++i) {
    const double x = side * (i % pixels) - seen, y = side * (i / pixels) - seen;
    floor.append(quad({x, y, 0}, {side, 0, 0}, {0, around, 0}));
    floor.append(quad({x, y + half + hole, 0}, {side, 0, 0}, {0, around, 0}));
    floor.append(quad({x, y + around, 0}, {around, 0, 0}, {0, 2 * hole, 0}));
    floor.append(quad({x + half + hole, y + around, 0}, {around, 0, 0}, {0, 2 * hole, 0}));
  }
  constexpr double to = seen + margin;  // beyond what is seen, so that discs there are full
  floor.append(quad({-to, -to, 0}, {2 * to, 0, 0}, {0, margin, 0}));
  floor.append(quad({-to, seen, 0}, {2 * to, 0, 0}, {0, margin, 0}));
  floor.append(quad({-to, -seen, 0}, {margin, 0, 0}, {0, 2 * seen, 0}));
  floor.append(quad({seen, -seen, 0}, {margin, 0, 0}, {0, 2 * seen, 0}));
  scene.add(floor, matte(rho));
  scene.add_directional({0, 0, -1}, lx);
  const Sensor camera = scene.add_camera({0, 0, 1}, {0, 0, -1}, pixels, pixels, 2 * std::atan(seen));
  const double expected = rho * lx / pi_d * (1 - 4 * hole * hole / (side * side));
  for (const ups_method method : {UPS_METHOD_PPM, UPS_METHOD_SPPM}) {
    const Mean mean = image_mean(scene, camera, {.method = method, .iterations = 96, .light_paths = 2048});
    expect_lx(mean.value, mean.standard_error, expected, 0.0033, method_name(method));
  }
}

// A spot that lights 1 cm of the floor, where all photons fall into one disc of 5 cm and, away from the faces between
// cells at multiples of twice the radius, into one cell of the grid: what is merged there has a closed form without
// noise, flux / (pi r^2), held to 0.1 %. Eye paths merge 2^14 of them at most, each for an odd number k of them, and the
// meter all. The time that a photon takes is told and not judged.
TEST(Hazard22, ACrowdedCellIsCountedWholly) {
  constexpr double radius = 0.05, at = 0.05, candela = 1000, cone = 0.01, rho = 0.5;
  const double flux = 2 * pi_d * candela * (1 - std::cos(cone));
  double seconds = 0;
  const uint32_t least = 14, most = fast_or_full(16u, 20u);
  for (uint32_t power = least; power <= most; ++power) {
    Scene scene;
    scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte(rho));
    scene.add_spot({at, at, 1}, {0, 0, -1}, candela, cone, cone * (1 + 1e-5));
    const Sensor camera = scene.add_camera({at, at, 0.5}, {0, 0, -1}, 4, 4, 0.02);
    const Sensor meters = scene.add_meters({P3{at, at, 0}}, {0, 0, 1});
    const Result r =
        scene.render({.method = UPS_METHOD_PPM, .iterations = 1, .merge_radius_m = radius, .light_paths = 1u << power});
    expect_ratio(mean(r.image(camera).luminance) * pi_d / rho, flux / (pi_d * radius * radius), 1e-3,
                 "pixels, 2^" + std::to_string(power));
    const auto reading = r.readings(meters)[0];
    expect_ratio(reading.illuminance_lx, flux / (pi_d * radius * radius), 1e-3, "meter, 2^" + std::to_string(power));
    const auto info = r.info();
    const double k = power > 14 ? (1u << (power - 14)) + 1 : 1;
    EXPECT_NEAR(double(info.merges), double(info.light_paths) * (1 + 16 / k), power > 14 ? 16 : 0) << power;
    EXPECT_EQ(r.text(UPS_TEXT_WARNINGS).find("merging: at 16 of the places") != std::string::npos, power > 14);
    if (power == least) seconds = info.elapsed_s;
    measured("2^%u photons: %.3g times the time a photon of 2^%u", power,
             info.elapsed_s / seconds / double(1u << (power - least)), least);
  }
}

// A spot whose light is more than the disc of 5 cm and the cells about it hold: which of a crowd's photons are merged
// is drawn, and their mean is the flux through the disc, 2 pi I (1 - h / sqrt(h^2 + r^2)), over its area. 32 seeds: the
// standard error is 0.15 % at most, which is asserted, four of them are allowed, P(|t_31| > 4) = 0.04 %: 0.9 % is
// found.
TEST(Hazard22, WhatOfACrowdIsMergedStandsForAll) {
  constexpr double radius = 0.05, candela = 1000, cone = 0.15, rho = 0.5;
  const double expected =
      2 * pi_d * candela * (1 - 1 / std::sqrt(1 + radius * radius)) / (pi_d * radius * radius) * rho / pi_d;
  std::vector<double> ratios;
  uint64_t merges = 0, photons = 0;
  for (uint64_t seed = 1; seed <= 32; ++seed) {
    Scene scene;
    scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte(rho));
    scene.add_spot({0, 0, 1}, {0, 0, -1}, candela, cone, cone * (1 + 1e-5));
    const Sensor camera = scene.add_camera({0, 0, 0.5}, {0, 0, -1}, 8, 8, 0.02);
    const Result r = scene.render({.method = UPS_METHOD_PPM,
                                   .iterations = 1,
                                   .seed = seed,
                                   .merge_radius_m = radius,
                                   .light_paths = fast_or_full(1u << 18, 1u << 20)});
    ratios.push_back(mean(r.image(camera).luminance) / expected);
    merges += r.info().merges, photons += r.info().light_paths;
  }
  const Mean ratio = mean_of(ratios);
  EXPECT_LT(merges / 64, photons / 16);  // of a tenth that the disc has
  measured("a crowd thinned: %+.2f +- %.2f %%, %.0f photons a pixel", 100 * (ratio.value - 1),
           100 * ratio.standard_error, double(merges) / 64 / 32);
  EXPECT_LE(ratio.standard_error, 0.0015);
  EXPECT_NEAR(ratio.value, 1, 4 * ratio.standard_error);
}

// Many photons on one meter: the disc that is read shrinks to the lit centimetre, and the reading is I / h^2. It holds
// twice its bound, of which 0.3 % at most is asserted: 0.8 % is found, and a false alarm is beyond 4 standard errors.
TEST(Hazard22, MillionsOfPhotonsOnOneMeter) {
  constexpr double candela = 1000, cone = 0.01;
  Scene scene;
  scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte(0));
  scene.add_spot({0, 0, 1}, {0, 0, -1}, candela, cone, cone * 1.0001);
  const Sensor meters = scene.add_meters({P3{0, 0, 0}}, {0, 0, 1});
  const Result r = scene.render({.method = UPS_METHOD_PPM,
                                 .iterations = fast_or_full(16u, 32u),
                                 .light_paths = fast_or_full(1u << 18, 1u << 20)});
  EXPECT_EQ(r.info().merges, r.info().light_paths);
  const auto reading = r.readings(meters)[0];
  measured("%llu photons on one meter: %+.3f %%", (unsigned long long)r.info().light_paths,
           100 * (double(reading.illuminance_lx) / candela - 1));
  expect_inside_bound(reading, candela, 0.003, "to 0.8 %");
}

}  // namespace
}  // namespace ups::test
