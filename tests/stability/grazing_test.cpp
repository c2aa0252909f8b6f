// Hazard 5: cosines near zero. A beam that meets a floor at 89.9 degrees, measured on the floor, and above it after its
// reflection; an emitter that is seen edge-on. Cosines divide densities and areas, and a meter that is lifted off its
// surface by rounding is nearer to the beam.
#include "../support/expect_same.h"

namespace ups::test {
namespace {

// Readings in closed form within 0.5 %, their standard errors at most 0.1 %: errors of 1 % are found with certainty, of
// 0.6 % in five cases of six; a false alarm takes 5 standard errors, P(|t_15| > 5) = 1.6e-4 where one is at its limit.
void expect_close(const ups_meter_reading& r, double expected, const std::string& what) {
  expect_within(r.illuminance_lx, r.standard_error_lx, expected, 0.005, 0.001, what);
}

// A spot 1 cm above the plane of a floor that begins at 4 m and ends at 9 m from it: 89.86 to 89.94 degrees. The beam
// has its full intensity all over the floor.
class Hazard05 : public ::testing::Test {
 protected:
  static constexpr double h = 0.01, intensity = 1000, rho = 0.8, near = 4, far = 9, half = 0.07;
  void SetUp() override {
    scene.add_spot({0, 0, h}, {1, 0, 0}, intensity, 0.02, 0.021);
  }
  void add_floor(double reflectance) {
    scene.add(quad({near, -half, 0}, {far - near, 0, 0}, {0, 2 * half, 0}), matte(reflectance));
  }
  static double lx(double x, double y) { return intensity * h / std::pow(x * x + y * y + h * h, 1.5); }
  // By the midpoint rule over the floor: E at p, facing down, of what the floor reflects.
  static double reflected(const P3& p) {
    constexpr int nx = 400, ny = 24;
    double sum = 0;
    for (int i = 0; i < nx; ++i)
      for (int j = 0; j < ny; ++j) {
        const P3 q{near + (far - near) * (i + 0.5) / nx, half * (2 * (j + 0.5) / ny - 1), 0}, d = p - q;
        sum += rho * lx(q.x, q.y) / pi_d * p.z * p.z / (dot(d, d) * dot(d, d));
      }
    return sum * (far - near) * 2 * half / (nx * ny);
  }
  Scene scene;
};

TEST_F(Hazard05, MetersUnderAGrazingBeam) {
  add_floor(0);
  const std::vector<P3> at = {{5.73, 0, 0}, {4.5, 0.05, 0}, {8.5, -0.05, 0}};
  const Sensor meters = scene.add_meters(at, {0, 0, 1});
  for (const ups_method method : eye_methods) {
    const auto readings = scene.render({.method = method, .iterations = 16}).readings(meters);
    for (size_t i = 0; i < at.size(); ++i) expect_close(readings[i], lx(at[i].x, at[i].y), method_name(method));
  }
}

TEST_F(Hazard05, PhotonsOfAGrazingBeamLandOnCells) {
  add_floor(0);
  const P3 middle{6.5, 0, 0};
  const Sensor cell = scene.add_cells({middle}, {{0, 0, 1}}, {{0, 1, 0}}, 2 * half, 4);
  double expected = 0;
  for (int i = 0; i < 4000; ++i)
    for (int j = 0; j < 8; ++j) expected += lx(4.5 + 4 * (i + 0.5) / 4000, half * ((j + 0.5) / 4 - 1)) / 32000;
  for (const ups_method method : {UPS_METHOD_LIGHT_TRACING, UPS_METHOD_PATH_TRACING, UPS_METHOD_UPS}) {
    const bool light = method == UPS_METHOD_LIGHT_TRACING;
    const Result r = scene.render({.method = method, .iterations = 128, .light_paths = light ? 1u << 16 : 1u << 12});
    expect_close(r.readings(cell)[0], expected, method_name(method));
  }
}

// By every technique that has a vertex on the floor: its cosine to the beam is in all their weights.
TEST_F(Hazard05, AFloorUnderAGrazingBeamReflectsWhatItGets) {
  add_floor(rho);
  const P3 s{1, 0, 0}, t{0, 1, 0}, down{0, 0, -1}, middle{6, 0, 0.3};
  std::vector<P3> at, centers;
  for (int i = 0; i < 16; ++i) at.push_back(middle + s * (0.25 * (i - 7.5)));
  for (int i = 0; i < 32; ++i)
    for (int j = 0; j < 4; ++j) centers.push_back(middle + s * (0.125 * (i - 15.5)) + t * (0.125 * (j - 1.5)));
  const Sensor points = scene.add_meters(at, down),
               cells = scene.add_cells(centers, std::vector<P3>(centers.size(), down),
                                       std::vector<P3>(centers.size(), s), 0.125, 0.125);
  double expected_points = 0, expected_cells = 0;
  for (const P3& p : at) expected_points += reflected(p) / 16;
  for (const P3& p : centers)
    for (const double y : {-0.03125, 0.03125}) expected_cells += reflected(p + t * y) / double(2 * centers.size());
  expect_same(scene,
              {trial(UPS_METHOD_PATH_TRACING, 64), trial(UPS_METHOD_LIGHT_TRACING, 64, 1u << 17),
               trial(UPS_METHOD_BIDIRECTIONAL, 64, 1u << 13), trial(UPS_METHOD_UPS, 64, 1u << 13, 0.02)},
              points, cells, expected_points, expected_cells);
}

// A panel of 1 cm by 1 m, in the plane just below which the meter looks at it: the emitter's own cosine.
TEST(Hazard05Emitter, SeenEdgeOn) {
  Scene scene;
  const Shape panel = quad({-0.5, -0.5, 0.01}, {0, 1, 0}, {1, 0, 0});
  scene.add(panel, emitter(10000));
  const std::vector<P3> at = {{5.73, 0, 0}, {5, 1, 0}, {-6, 2, 0.004}};
  std::vector<P3> normals;
  for (const P3& p : at) normals.push_back(normalize(P3{-p.x, -p.y, 0}));
  const Sensor meters = scene.add_meters(at, normals);
  for (const ups_method method : eye_methods) {
    const auto readings = scene.render({.method = method, .iterations = 256}).readings(meters);
    for (size_t i = 0; i < at.size(); ++i)
      expect_close(readings[i], 10000 * polygon_irradiance_factor(panel.vertices, at[i], normals[i]),
                   method_name(method));
  }
}

}  // namespace
}  // namespace ups::test
