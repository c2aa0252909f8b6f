// Many of everything in one place: light vertices in a cell, samples in an accumulator, meters in a set.
#include "torture.h"

namespace ups::test {
namespace {

// A spot of 1 cm^2 catches all light paths, and a camera and a meter look at nothing else.
TEST(Torture, AMillionLightVerticesInOneCell) {
  const uint32_t paths = fast_or_full(1u << 16, 1u << 20);
  Scene scene;
  scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte(0.8));
  scene.add_spot({0, 0, 1}, {0, 0, -1}, 1000, 0.005, 0.0056);
  const Sensor meters = scene.add_meters({{0, 0, 0}}, {0, 0, 1});
  scene.add_camera({0.3, 0, 0.3}, {-1, 0, -1}, 1, 1, 0.01);
  const std::vector<Result> results = survive("crowded cell", scene, {{meters, 0.05, 1000, 1e-3}},
                                              {.iterations = 4, .light_paths = paths, .sppm_factor = 1});
  EXPECT_GE(results[0].info().light_paths, uint64_t(4) * paths);
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
  const std::vector<Result> results = survive(
      "a billion samples", scene, {{cell, 1e-3, truth, 1e-5}},
      {.iterations = iterations, .light_paths = paths, .methods = {UPS_METHOD_LIGHT_TRACING}});
  EXPECT_GE(results[0].info().light_paths, full() ? uint64_t(1000000000) : 1u);
}

// Each of them exact, straight from a lamp over a black floor.
TEST(Torture, AMillionMeters) {
  const int n = fast_or_full(316, 1000);
  Scene scene;
  scene.add(box({0, 0, -0.1}, {4, 4, 0}), matte(0));
  const P3 lamp{2, 2, 2.5};
  scene.add_point_light(lamp, 1000);
  const std::vector<P3> points = grid_points({0, 0, 0}, {4, 0, 0}, {0, 4, 0}, n);
  const Sensor meters = scene.add_meters(points, {0, 0, 1});
  add_small_camera(scene, {0.5, 0.5, 1.5}, {1, 1, -0.2});
  double mean = 0;
  const auto truth = [&](const P3& p) {
    const P3 to = lamp - p;
    return 1000 * to.z / std::pow(dot(to, to), 1.5);
  };
  for (const P3& p : points) mean += truth(p) / double(points.size());
  const uint32_t passes = uint32_t(points.size() / 32768 + 1) | 1u;  // an iteration visits 32768 at most
  const std::vector<Result> results = survive("many meters", scene, {{meters, 0.05, mean, 1e-3}},
                                              {.iterations = 4 * passes,
                                               .light_paths = 1u << 10,
                                               .blind = without_next_event});
  for (size_t r = 0; r < results.size(); ++r) {
    if (torture_methods[r] == UPS_METHOD_SPPM) continue;  // finds light by chance alone
    const auto readings = results[r].readings(meters);
    for (size_t m = 0; m < points.size(); m += 97)
      ASSERT_NEAR(readings[m].illuminance_lx, truth(points[m]), 1e-4 * truth(points[m])) << m;
  }
}

}  // namespace
}  // namespace ups::test
