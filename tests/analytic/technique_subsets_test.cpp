// Does every subset of techniques that can carry all light measure the same? Weights that do not sum to one over
// exactly the techniques that ran show here, as does a technique that runs although it is switched off.
//
// An integrating sphere around a black sphere emitter (see energy_test.cpp): E is known. Meters are complete with
// emitter hits, with next-event estimation, with merging at the meter's own point, or, for cells, with light paths that
// land.
#include "../support/expect_lx.h"

namespace ups::test {
namespace {

constexpr uint32_t all_techniques = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT |
                                    UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT;

class TechniqueSubsets : public ::testing::Test {
 protected:
  static constexpr double rho = 0.5, luminance = 1000, gap = 0.01;

  void SetUp() override {
    const Shape wall = icosphere({0, 0, 0}, 1, 4), lamp = icosphere({0, 0, 0}, 0.3, 3);
    scene.add(wall, matte(rho));
    scene.add(lamp, emitter(luminance));
    points = points_inside(wall, 8, 5);
    on_wall = pi_d * luminance * lamp.area() / (wall.area() * (1 - rho * (1 - lamp.area() / wall.area())));
    // At a distance `gap` from the wall the lamp's share of the view is larger than on it.
    const double d = std::sqrt(wall.area() / (4 * pi_d)) - gap, share = lamp.area() / (4 * pi_d * d * d);
    near_wall = pi_d * luminance * share + rho * on_wall * (1 - share);
  }
  // The mean over the set, by every subset that has one of `complete`. The error of each is judged by itself; 4
  // standard errors of 16 batches, 56 subsets at the most: a right engine fails with probability below 7 %, were noise
  // all that counts.
  void expect_all(const Sensor& meters, double expected, uint32_t complete) {
    for (uint32_t subset = 1; subset <= all_techniques; ++subset) {
      if (!(subset & complete)) continue;
      const Result result =
          scene.render({.method = UPS_METHOD_UPS, .iterations = 16, .light_paths = 1u << 13, .techniques = subset});
      EXPECT_EQ(result.info().techniques & ~subset, 0u);
      const auto s = result.statistics(meters);
      expect_lx(s.mean_lx, s.mean_standard_error_lx, expected, 0.02, "subset " + std::to_string(subset));
    }
  }
  Scene scene;
  Points points;
  double on_wall = 0, near_wall = 0;
};

TEST_F(TechniqueSubsets, PointMetersAgreeWithTheClosedForm) {
  const Sensor meters = scene.add_meters(points.positions, points.normals);
  expect_all(meters, on_wall, UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_MERGE);
}

// Cells that float just inside the wall; a camera beside them turns on what only cameras need.
TEST_F(TechniqueSubsets, CellsBesideACameraAgreeWithTheClosedForm) {
  std::vector<P3> centers, tangents;
  for (size_t i = 0; i < points.positions.size(); ++i) {
    const P3 n = points.normals[i];
    centers.push_back(points.positions[i] + n * gap);
    tangents.push_back(normalize(std::abs(n.x) < 0.9 ? cross({1, 0, 0}, n) : cross({0, 1, 0}, n)));
  }
  const Sensor cells = scene.add_cells(centers, points.normals, tangents, 0.05, 0.05);
  scene.add_camera({0, 0, 0.7}, {0, 1, 0}, 4, 4, 1);
  expect_all(cells, near_wall, UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_SENSOR_HIT);
}

}  // namespace
}  // namespace ups::test
