// Hazard 3: emitters a millionth of the scene's size. What samples solid angles loses all digits there, what hits them
// finds them once in 1e12 paths.
#include "../support/expect_same.h"

namespace ups::test {
namespace {

// A disc of 1000 cd/m^2 in a black room of 4 m, E of its mesh in closed form. Each reading within 0.5 % and its
// standard error at most 0.1 %: errors of 1 % are found with certainty (by 5 standard errors), of 0.6 % in five cases
// of six. A false alarm takes 5 standard errors: P(|t_15| > 5) = 1.6e-4 for a reading whose error is at its limit; most
// are far below. That of 4e-6 m is a millionth of the room across; floats place its corners to 1.5 % of its radius, which
// costs 0.15 % of E. (Of a radius of 1e-6 m it was 0.5 %.) The one of 1e-6 m hangs in the middle of the room, where floats
// are finer.
constexpr double tolerance = 0.005, largest_noise = 0.001;

void expect_close(const ups_meter_reading& r, double expected, const std::string& what) {
  expect_within(r.illuminance_lx, r.standard_error_lx, expected, tolerance, largest_noise, what);
}

class Hazard03 : public ::testing::TestWithParam<double> {
 protected:
  void SetUp() override {
    const Shape source = disc({0, 0, 0}, {0.1, -0.2, -1}, GetParam(), 64);
    scene.add(source, emitter(1000), center);
    scene.add(box({-2, -2, -1}, {2, 2, 3}).flipped(), matte(0));
    at_origin = source;
  }
  double lx(const P3& p, const P3& n) const { return 1000 * convex_irradiance_factor(at_origin, p - center, n); }
  const P3 center = GetParam() < 2e-6 ? P3{0, 0, 1} : P3{0.37, -0.41, 1.13};
  Scene scene;
  Shape at_origin;
};
INSTANTIATE_TEST_SUITE_P(Radii, Hazard03, ::testing::Values(1, 0.1, 0.01, 1e-3, 1e-4, 1e-5, 4e-6, 1e-6),
                         [](const auto& i) { return "of_" + std::to_string(std::lround(1e6 * i.param)) + "um"; });

TEST_P(Hazard03, PointMetersReadTheClosedForm) {
  const std::vector<P3> at = {{0, 0, -0.5}, {1.5, 0.3, -0.9}, {-1, -1.5, 0}};
  const std::vector<P3> normals = {{0, 0, 1}, {-1, 0, 1}, {0.2, 0.3, 1}};
  const Sensor meters = scene.add_meters(at, normals);
  for (const ups_method method : eye_methods) {
    const auto readings = scene.render({.method = method, .iterations = 128}).readings(meters);
    for (size_t i = 0; i < at.size(); ++i)
      expect_close(readings[i], lx(at[i], normalize(normals[i])),
                   std::string(method_name(method)) + ", meter " + std::to_string(i));
  }
}

// By photons alone: no cell is seen by an eye path.
TEST_P(Hazard03, CellsCountTheClosedForm) {
  constexpr double side = 1.6;
  const P3 middle{0.2, -0.3, -0.9};
  const Sensor cell = scene.add_cells({middle}, {{0, 0, 1}}, {{1, 0, 0}}, side, side);
  double expected = 0;
  const auto points = grid_about(middle, {1, 0, 0}, {0, 1, 0}, side, 64);
  for (const P3& p : points) expected += lx(p, {0, 0, 1}) / double(points.size());
  const Result result =
      scene.render({.method = UPS_METHOD_LIGHT_TRACING, .iterations = 64, .light_paths = 1u << 15});
  expect_close(result.readings(cell)[0], expected, "LT");
}

}  // namespace
}  // namespace ups::test
