// Many of everything in one place: light vertices in a cell, samples in an accumulator, meters in a set.
#include "torture.h"

namespace ups::test {
namespace {

// A spot of 1 cm catches all light paths, and a camera's pixel and a meter look at nothing else. Discs of 5 cm about
// it: cells of photons of 10 cm, of which its middle is one's, and radii fall by less than a fifth. SPPM merges each
// photon with the meter, and with the pixel's eye path 2^14 at most, each for many. The black patch makes the floor the
// middle of a layer of cells.
TEST(Torture, AMillionLightVerticesInOneCell) {
  const uint32_t paths = fast_or_full(1u << 16, 1u << 20);
  Scene scene;
  scene.add(quad({-1, -1, 0.05}, {2, 0, 0}, {0, 2, 0}), matte(0.8));
  scene.add(quad({-0.01, -0.01, -0.05}, {0.02, 0, 0}, {0, 0.02, 0}), matte(0));
  scene.add_spot({0.05, 0.05, 1.05}, {0, 0, -1}, 1000, 0.005, 0.0056);
  const Sensor meters = scene.add_meters({{0.05, 0.05, 0.05}}, {0, 0, 1});
  scene.add_camera({0.35, 0.05, 0.35}, {-1, 0, -1}, 1, 1, 0.01);
  // Four iterations know no error.
  const std::vector<Result> results =
      survive("crowded cell", scene, {{.meters = meters, .noise = INFINITY}},
              {.iterations = 4, .light_paths = paths, .sppm_factor = 1, .merge_radius_m = 0.05, .sppm_radius_m = 0.05});
  for (size_t r = 0; r < results.size(); ++r) {
    const ups_result_info i = results[r].info();
    EXPECT_NEAR(results[r].readings(meters)[0].illuminance_lx, 1000, 1) << method_name(torture_methods[r]);
    if (torture_methods[r] != UPS_METHOD_SPPM) continue;
    EXPECT_EQ(i.light_paths, uint64_t(4) * paths);
    EXPECT_NEAR(double(i.merges), double(i.light_paths) * (1 + 1.0 / (paths / (1u << 14) | 1u)), 4);
    std::printf("SPPM: %.3g ns a light path\n", 1e9 * i.elapsed_s / double(i.light_paths));
  }
}

// All light paths land on one cell, of the area that a cone of light covers: Phi / A.
TEST(Torture, ABillionSamplesInOneAccumulator) {
  constexpr double half = 0.1;
  Scene scene;
  const double angle = std::atan(half / 2);
  scene.add_spot({0, 0, 1}, {0, 0, -1}, 1000, 0.99 * angle, angle);
  const Sensor cell = scene.add_cells({{0, 0, 0}}, {{0, 0, 1}}, {{1, 0, 0}}, 2 * half, 2 * half);
  // Full intensity inside, ((cos a - cos o) / (cos i - cos o))^2 between, whose mean over cos a is 1 / 3.
  const double ci = std::cos(0.99 * angle), co = std::cos(angle);
  const double truth = 2000 * pi_d * ((1 - ci) + (ci - co) / 3) / (4 * half * half);
  const uint32_t iterations = fast_or_full(16u, 60u), paths = fast_or_full(1u << 13, 1u << 24);
  const std::vector<Result> results =
      survive("a billion samples", scene, {{cell, truth, 1e-5}},
              {.iterations = iterations, .light_paths = paths, .methods = {UPS_METHOD_LIGHT_TRACING}});
  EXPECT_GE(results[0].info().light_paths, full() ? uint64_t(1000000000) : 1u);
}

// Over a black floor: straight from a lamp, exact at each; and by way of a mirror, whose light photons alone carry. A
// spot aims at the mirror, has nearly all of the flux, and its image's cone ends within the meters, on half of them: so
// nearly each photon counts in their mean. That is within 0.5 % or 4 standard errors, which are at most 0.16 %: 1 % is
// found in 98 cases of 100, a false alarm is one of 860, P(|t_15| > 4); each meter is visited 16 times, once a batch.
// Discs of a few meters each. Where they have no technique for it methods say so, and what comes straight is judged.
TEST(Torture, AMillionMeters) {
  const int n = fast_or_full(316, 1000);
  constexpr double reflectance = 0.9, lamp_cd = 10, spot_cd = 1e4, inner = 0.25, outer = 0.29;
  Scene scene;
  scene.add(box({-1, -1, -0.1}, {5, 5, 0}), matte(0));
  scene.add(quad({-1, -1, 0}, {0, 6, 0}, {0, 0, 3}), photon_mirror(reflectance));
  // Images in the mirror, at x = -1; axis: of the spot's.
  const P3 lamp{2, 2, 2.5}, image{-4, 2, 2.5}, spot{-0.5, 2, 2.9}, spot_image{-1.5, 2, 2.9};
  const P3 axis = normalize({1, 0, -1.007});
  scene.add_point_light(lamp, lamp_cd);
  scene.add_spot(spot, {-axis.x, axis.y, axis.z}, spot_cd, inner, outer);
  const std::vector<P3> points = grid_points({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, n);
  const Sensor meters = scene.add_meters(points, {0, 0, 1});
  add_small_camera(scene, {0.5, 0.5, 1.5}, {1, 1, -0.5});
  const auto lx = [](const P3& from, const P3& p, double cd) {
    const P3 to = from - p;
    return cd * to.z / std::pow(dot(to, to), 1.5);
  };
  // Full intensity inside, ((cos a - cos o) / (cos i - cos o))^2 between.
  const auto spot_cd_to = [&](const P3& p) {
    const double ramp = (dot(normalize(p - spot_image), axis) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    return spot_cd * std::pow(std::clamp(ramp, 0.0, 1.0), 2);
  };
  double direct = 0, mirrored = 0;
  for (const P3& p : points) {
    direct += lx(lamp, p, lamp_cd) / double(points.size());
    mirrored += reflectance * (lx(image, p, lamp_cd) + lx(spot_image, p, spot_cd_to(p))) / double(points.size());
  }
  const uint32_t passes = uint32_t(points.size() / 32768 + 1) | 1u;  // an iteration visits 32768 at most
  const std::vector<Result> results = survive("many meters", scene, {{.meters = meters, .noise = INFINITY}},
                                              {.iterations = 16 * passes,
                                               .light_paths = fast_or_full(1u << 13, 1u << 14),
                                               .sppm_factor = 1,
                                               .merge_radius_m = fast_or_full(0.02, 0.01),
                                               .sppm_radius_m = fast_or_full(0.02, 0.01)});
  for (size_t r = 0; r < results.size(); ++r) {
    const ups_method method = torture_methods[r];
    const ups_meter_statistics s = results[r].statistics(meters);
    const bool by_photons = method == UPS_METHOD_UPS || method == UPS_METHOD_SPPM || method == UPS_METHOD_AUTO;
    const double straight = method == UPS_METHOD_SPPM ? 0 : direct, rest = direct + mirrored - straight;
    if (by_photons)
      expect_lx(s.mean_lx - straight, s.mean_standard_error_lx, rest, largest_s,
                std::string("photons, ") + method_name(method));
    if (method == UPS_METHOD_SPPM) continue;
    const auto readings = results[r].readings(meters);
    for (size_t m = 0; m < points.size(); m += 97)
      ASSERT_NEAR(readings[m].direct_lx / lx(lamp, points[m], lamp_cd), 1, 1e-4) << m;
  }
}

}  // namespace
}  // namespace ups::test
