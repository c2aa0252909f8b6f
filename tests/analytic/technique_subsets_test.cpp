// Does every subset of techniques that can carry all light measure the same? Weights that do not sum to one over
// exactly the techniques that ran show here, as does a technique that runs although it is switched off.
//
// A single subset is bounded by four times its noise, of up to 1 %, or 6 % without eye paths: a technique that is
// missing or twice there is off by tens of percent. The mean over all subsets, and over those that have a technique,
// for each of these, finds 1 % (expect_lx.h): seeds differ, so that the subsets' errors are independent, and each counts by
// the inverse of its error.
//
// Meters float in an integrating sphere around a black sphere emitter, half of them facing it, half the wall; E is
// known. They are complete with emitter hits, with next-event estimation, with merging at the meter's own point, or,
// for cells, with light paths that land.
#include <map>

#include "../support/expect_lx.h"

namespace ups::test {
namespace {

constexpr uint32_t all_techniques = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT |
                                    UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT;

class TechniqueSubsets : public ::testing::Test {
 protected:
  static constexpr uint32_t eye = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE;
  static constexpr double rho = 0.5, luminance = 1000, distance = 0.7, side = 0.1;

  void SetUp() override {
    const Shape wall = icosphere({0, 0, 0}, 1, 4), lamp = icosphere({0, 0, 0}, 0.3, 3);
    scene.add(wall, matte(rho));
    scene.add(lamp, emitter(luminance));
    for (size_t t = 0; t < 4; ++t) {
      const P3 d = normalize(lamp.centroid(300 * t)), across = normalize(cross({0.1, 0.2, 1}, d));
      centers.insert(centers.end(), {d * distance, d * distance});
      normals.insert(normals.end(), {d, d * -1});
      tangents.insert(tangents.end(), {across, across});
    }
    const double on_wall = pi_d * luminance * lamp.area() / (wall.area() * (1 - rho * (1 - lamp.area() / wall.area())));
    const double share = lamp.area() / (4 * pi_d * distance * distance);  // of what faces the lamp
    facing_wall = rho * on_wall;
    facing_lamp = pi_d * luminance * share + rho * on_wall * (1 - share);
    // Over a small square, to second order: E falls off as (1 + (x / d)^2)^(-3/2), the mean of x^2 is side^2 / 6.
    lamp_cell = facing_lamp - pi_d * luminance * share * side * side / (4 * distance * distance);
  }
  struct Pooled {
    double sum = 0, weights = 0, count = 0;
    void add(double value, double standard_error) {
      sum += value / standard_error, weights += 1 / standard_error, ++count;
    }
    // Of the mean: the root of the sum of (weight * error)^2, over the weights.
    void expect(double expected, const std::string& what) const {
      expect_lx(sum / weights, std::sqrt(count) / weights, expected, quiet, what);
    }
  };
  // The mean over the meters, by every subset of `all` that has one of `complete`: 56 at the most. P(|t_15| > 4) each:
  // a right engine fails with probability below 7 %; of the seven pooled means, below 1e-4 each.
  void expect_all(const Sensor& meters, double expected, uint32_t all, uint32_t complete, uint32_t light_paths) {
    Pooled pooled;
    std::map<uint32_t, Pooled> having;
    for (uint32_t subset = 1; subset <= all; ++subset) {
      if (!(subset & complete) || (subset & ~all)) continue;
      const Result result = scene.render({.method = UPS_METHOD_UPS,
                                          .iterations = 16,
                                          .seed = subset,
                                          .merge_radius_m = 0.05,
                                          .light_paths = light_paths,
                                          .techniques = subset});
      EXPECT_EQ(result.info().techniques & ~subset, 0u);
      const auto s = result.statistics(meters);
      expect_lx(s.mean_lx, s.mean_standard_error_lx, expected, one_of(subset & eye ? 0.01 : 0.06),
                "subset " + std::to_string(subset));
      pooled.add(s.mean_lx, s.mean_standard_error_lx);
      for (uint32_t bit = 1; bit <= subset; bit <<= 1)
        if (subset & bit) having[bit].add(s.mean_lx, s.mean_standard_error_lx);
    }
    pooled.expect(expected, "all subsets");
    for (const auto& [technique, mean] : having) mean.expect(expected, "with technique " + std::to_string(technique));
  }
  Scene scene;
  std::vector<P3> centers, normals, tangents;
  double facing_wall = 0, facing_lamp = 0, lamp_cell = 0;
};

TEST_F(TechniqueSubsets, PointMetersAgreeWithTheClosedForm) {
  const Sensor meters = scene.add_meters(centers, normals);
  expect_all(meters, (facing_wall + facing_lamp) / 2,
             all_techniques & ~(UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_SENSOR_HIT),
             UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_MERGE, 1u << 13);
}

// A camera beside them turns on what only cameras need.
TEST_F(TechniqueSubsets, CellsBesideACameraAgreeWithTheClosedForm) {
  const Sensor cells = scene.add_cells(centers, normals, tangents, side, side);
  scene.add_camera({0, 0, 0.7}, {0, 1, 0}, 4, 4, 1);
  expect_all(cells, (facing_wall + lamp_cell) / 2, all_techniques,
             UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_SENSOR_HIT, 1u << 11);
}

}  // namespace
}  // namespace ups::test
