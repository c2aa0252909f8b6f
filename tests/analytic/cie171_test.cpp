// CIE 171:2006, "Test cases to assess the accuracy of lighting computer programs": the quick analytic cases that
// sources_test.cpp does not have: 5.4 flux conservation, 5.6 and 5.7 reflection over diffuse surfaces, 5.8
// interreflection.
#include "../support/expect_lx.h"

namespace ups::test {
namespace {

constexpr double flux_lm = 10000;

// Six cells, one on each inner face of a box of equal side lengths per pair: floor, ceiling and the four walls.
struct Faces {
  Sensor floor_and_ceiling, walls;
};
Faces add_faces(Scene& scene, double width, double height) {
  const double w = width, c = width / 2, h = height;
  return {scene.add_cells({{c, c, 0}, {c, c, h}}, {{0, 0, 1}, {0, 0, -1}}, {{1, 0, 0}, {1, 0, 0}}, w, w),
          scene.add_cells({{0, c, h / 2}, {w, c, h / 2}, {c, 0, h / 2}, {c, w, h / 2}},
                          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}}, {{0, 1, 0}, {0, 1, 0}, {1, 0, 0}, {1, 0, 0}},
                          w, h)};
}

// 5.4: isotropic 10,000 lm in the centre of a black room of 4 x 4 x 3 m.
TEST(Cie171, FluxConservationInABlackRoom) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0));
  scene.add_point_light({2, 2, 1.5}, flux_lm / (4 * pi_d));
  const Faces faces = add_faces(scene, 4, 3);
  for (ups_method method : cell_methods) {
    const Result result = scene.render({.method = method, .iterations = 128});
    const std::string name = method_name(method);
    for (const auto& r : result.readings(faces.floor_and_ceiling))
      expect_lx(r, 2210.66 / 16, 0.003, name + ", floor or ceiling");
    for (const auto& r : result.readings(faces.walls)) expect_lx(r, 1394.67 / 12, 0.003, name + ", wall");
  }
}

// 5.6, scenario 2: a diffuse 4 x 4 m reflector of 30 %, uniformly lit; 100 E / (E_hz rho) on a wall and on the ceiling.
TEST(Cie171, DiffuseReflectionOverAHorizontalReflector) {
  const double rho = 0.3, horizontal = 10000;
  Scene scene;
  scene.add(quad({0, 0, 0}, {4, 0, 0}, {0, 4, 0}), matte(rho));
  scene.add_directional({0, 0, -1}, horizontal);
  const double wall[] = {35.9005, 27.9916, 21.6385, 16.7163, 12.9674};  // z = 0.75 ... 2.75
  const double ceiling[] = {26.795, 30.939, 33.976, 35.567};            // y = 0.25 ... 1.75
  std::vector<P3> on_wall, on_ceiling;
  for (int i = 0; i < 5; ++i) on_wall.push_back({2, 0, 0.75 + 0.5 * i});
  for (int i = 0; i < 4; ++i) on_ceiling.push_back({2, 0.25 + 0.5 * i, 3});
  const Sensor wall_meters = scene.add_meters(on_wall, {0, 1, 0}),
               ceiling_meters = scene.add_meters(on_ceiling, {0, 0, -1});
  for (ups_method method : eye_methods) {
    const uint32_t iterations = method == UPS_METHOD_PATH_TRACING ? 256 : 512;
    const Result result = scene.render({.method = method, .iterations = iterations});
    const auto w = result.readings(wall_meters), c = result.readings(ceiling_meters);
    for (int i = 0; i < 5; ++i)
      expect_lx(w[i], wall[i] / 100 * horizontal * rho, 0.01,
                std::string(method_name(method)) + ", wall " + std::to_string(i));
    for (int i = 0; i < 4; ++i)
      expect_lx(c[i], ceiling[i] / 100 * horizontal * rho, 0.01,
                std::string(method_name(method)) + ", ceiling " + std::to_string(i));
  }
}

// 5.7, corrected (Table 19 of the report is wrong): a uniformly bright wall of 4 x 3 m partly hidden by a box.
TEST(Cie171, DiffuseReflectionWithAnObstruction) {
  const double exitance = 1000;
  Scene scene;
  scene.add(quad({0, 4, 0}, {4, 0, 0}, {0, 0, 3}), emitter(exitance / pi_d));
  scene.add(box({0, 2.5, 0}, {4, 2.7, 1}), matte(0));
  const double wall[] = {16.071, 16.330, 15.399, 13.322, 10.317, 7.079};  // z = 2.75 ... 0.25
  const double floor[] = {3.382, 3.629, 3.013, 0, 0};                     // y = 0.25 ... 2.25
  std::vector<P3> on_wall, on_floor;
  for (int i = 0; i < 6; ++i) on_wall.push_back({2, 0, 2.75 - 0.5 * i});
  for (int i = 0; i < 5; ++i) on_floor.push_back({2, 0.25 + 0.5 * i, 0});
  const Sensor wall_meters = scene.add_meters(on_wall, {0, 1, 0}), floor_meters = scene.add_meters(on_floor, {0, 0, 1});
  for (ups_method method : eye_methods) {
    const Result result = scene.render({.method = method, .iterations = 256});
    const auto w = result.readings(wall_meters), f = result.readings(floor_meters);
    for (int i = 0; i < 6; ++i)
      expect_lx(w[i], wall[i] / 100 * exitance, 0.01, std::string(method_name(method)) + ", wall " + std::to_string(i));
    for (int i = 0; i < 5; ++i) {
      const std::string what = std::string(method_name(method)) + ", floor " + std::to_string(i);
      if (floor[i] > 0)
        expect_lx(f[i], floor[i] / 100 * exitance, 0.015, what);
      else
        EXPECT_EQ(f[i].illuminance_lx, 0) << what;
    }
  }
}

// 5.8: isotropic 10,000 lm in the centre of a cube of 4 m. The mean over each face is Phi / (S (1 - rho)) exactly.
class Cie171Cube : public ::testing::TestWithParam<double> {};
TEST_P(Cie171Cube, InternallyReflectedComponent) {
  const double rho = GetParam(), area = 96;
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 4, 4}).flipped(), matte(rho));
  scene.add_point_light({2, 2, 2}, flux_lm / (4 * pi_d));
  const Faces faces = add_faces(scene, 4, 4);
  for (ups_method method : cell_methods) {
    const Result result = scene.render({.method = method, .iterations = 64});
    for (const Sensor& sensor : {faces.floor_and_ceiling, faces.walls})
      for (const auto& r : result.readings(sensor)) {
        expect_lx(r, flux_lm / (area * (1 - rho)), 0.01, std::string(method_name(method)) + ", total");
        EXPECT_NEAR(r.direct_lx + r.indirect_lx, r.illuminance_lx, 1e-4 * r.illuminance_lx);
      }
  }
}
INSTANTIATE_TEST_SUITE_P(Reflectances, Cie171Cube, ::testing::Values(0.5, 0.9),
                         [](const auto& i) { return "rho_0" + std::to_string(int(std::lround(100 * i.param))); });

}  // namespace
}  // namespace ups::test
