// Rooms of a millimetre and of a hundred kilometres, far from the origin, of doubled faces, with thin walls, of
// needles, of millions of triangles.
#include "torture.h"

namespace ups::test {
namespace {

// A cube with a lamp at its centre, every wall of reflectance 0.5: by symmetry and the balance of energy each wall has
// Phi / (S (1 - rho)) in the mean, whatever its size.
void survive_cube(const std::string& name, double side, const P3& offset, int faces) {
  Scene scene;
  for (int k = 0; k < faces; ++k) scene.add(box({0, 0, 0}, {side, side, side}).flipped(), matte(0.5), offset);
  const double intensity = 100 * side * side;
  scene.add_point_light(offset + P3{side / 2, side / 2, side / 2}, intensity);
  const Sensor floor = add_cells(scene, offset, {side, 0, 0}, {0, side, 0}, 2);
  add_small_camera(scene, offset + P3{side / 4, side / 4, side / 2}, {1, 1, -0.3});
  survive(name, scene, {{floor, 4 * pi_d * intensity / (6 * side * side * 0.5)}});
}

TEST(Torture, UnitsFromAMillimetreToAHundredKilometres) {
  for (const double side : {1e-3, 1.0, 1e5}) survive_cube("cube of side " + std::to_string(side), side, {}, 1);
}

TEST(Torture, AHundredKilometresFromTheOrigin) {
  survive_cube("cube far away", 4, {1e5, -1e5, 1e5}, 1);
  survive_cube("cube very far away, 1 cm", 0.01, {1e5, -1e5, 1e5}, 1);
}

TEST(Torture, DoubledCoplanarFaces) {
  survive_cube("doubled faces", 4, {}, 2);
  survive_cube("doubled faces far away", 4, {1e5, -1e5, 1e5}, 2);
}

// No light comes through 5 mm: but for photons that stand for light up to a merge radius away, and what these bring is
// within the stated bound.
TEST(Torture, WallsOfFiveMillimetres) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
  scene.add(box({4.005, 0, 0}, {8, 4, 3}).flipped(), matte(0.5));
  scene.add(quad({2, 1, 2.9}, {0, 2, 0}, {1.9, 0, 0}), emitter(1000));
  const std::vector<P3> near_wall = grid_points({3.99, 0, 0.01}, {0, 4, 0}, {0, 0, 2.9}, 24);  // many: less noise
  std::vector<P3> beyond;
  for (const P3& p : near_wall) beyond.push_back({8.005 - p.x, p.y, p.z});
  const Sensor lit = scene.add_meters(near_wall, {0, 0, 1}), dark = scene.add_meters(beyond, {0, 0, 1});
  add_small_camera(scene, {2, 2, 1.5}, {1, 0, 0});
  const Sensor in_dark = add_small_camera(scene, {6, 2, 1.5}, {-1, 0, 0});
  const std::vector<Result> results =
      survive("walls of 5 mm", scene, {{.meters = lit}}, {.iterations = 32, .sppm_iterations = 128});
  for (size_t r = 0; r < results.size(); ++r) {
    const double most = 1e-3 * results[r].statistics(lit).mean_lx;
    const std::string what = method_name(torture_methods[r]);
    for (const ups_meter_reading& m : results[r].readings(dark)) {
      EXPECT_LE(m.illuminance_lx, most) << what;
      EXPECT_LE(m.illuminance_lx, m.error_bound_lx) << what;
    }
    for (const float v : results[r].image(in_dark).luminance) EXPECT_EQ(v, 0) << what;
  }
}

// 1 : 10^6 as emitter, as slivers along the walls, as meters. SPPM's noise is that of the photons on the discs of 36
// points, the other methods' that of 16 cells; of more than 64 meters in all each would have fewer paths an iteration.
TEST(Torture, NeedlesAndSlivers) {
  constexpr double thin = 4e-6;
  Scene scene;
  for (const auto& [from, to] : {std::pair{0.0, thin}, {thin, 4 - thin}, {4 - thin, 4.0}}) {
    scene.add(quad({from, 0, 0}, {to - from, 0, 0}, {0, 4, 0}), matte(0.5));
    scene.add(quad({from, 0, 3}, {0, 4, 0}, {to - from, 0, 0}), matte(0.5));
    scene.add(quad({from, 0, 0}, {0, 0, 3}, {to - from, 0, 0}), matte(0.5));
    scene.add(quad({from, 4, 0}, {to - from, 0, 0}, {0, 0, 3}), matte(0.5));
  }
  scene.add(quad({0, 0, 0}, {0, 4, 0}, {0, 0, 3}), matte(0.5));
  scene.add(quad({4, 0, 0}, {0, 0, 3}, {0, 4, 0}), matte(0.5));
  scene.add(quad({0.2, 2, 2.5}, {0, 3.6e-6, 0}, {3.6, 0, 0}), emitter(1e8));
  const Sensor points = scene.add_meters(grid_points({0.5, 0.5, 0.8}, {3, 0, 0}, {0, 3, 0}, 6), {0, 0, 1});
  const std::vector<P3> centres = grid_points({0.5, 0.5, 0.5}, {3, 0, 0}, {0, 3, 0}, 4),
                        up(centres.size(), {0, 0, 1}), along(centres.size(), {1, 0, 0});
  const Sensor cells = scene.add_cells(centres, up, along, 0.75, 7.5e-7);
  add_small_camera(scene, {0.5, 0.5, 1.5}, {1, 1, -0.2});
  survive("needles", scene,
          {{points}, {.meters = cells, .looser = {{UPS_METHOD_SPPM, INFINITY, "no photon meets a cell of 1 um"}}}},
          {.iterations = 32, .sppm_iterations = 128, .sppm_radius_m = radius_in_rooms});
}

// A floor of ripples, 0.1 mm high.
TEST(Torture, AMeshOfTenMillionTriangles) {
  const uint32_t n = fast_or_full(224u, 2237u);
  Shape floor;
  floor.vertices.reserve(size_t(n + 1) * (n + 1));
  floor.triangles.reserve(size_t(n) * n * 2);
  for (uint32_t j = 0; j <= n; ++j)
    for (uint32_t i = 0; i <= n; ++i) {
      const double x = 4.0 * i / n, y = 4.0 * j / n;
      floor.vertices.push_back({x, y, 0.01 + 1e-4 * std::sin(40 * x) * std::cos(40 * y)});
    }
  for (uint32_t j = 0; j < n; ++j)
    for (uint32_t i = 0; i < n; ++i) {
      const uint32_t a = j * (n + 1) + i, b = a + n + 1;
      floor.triangles.push_back({a, a + 1, b + 1});
      floor.triangles.push_back({a, b + 1, b});
    }
  Scene scene;
  scene.add(floor, matte(0.5));
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
  scene.add(quad({1.5, 1.5, 2.9}, {0, 1, 0}, {1, 0, 0}), emitter(1000));
  const Sensor meters = scene.add_meters(many_points(0.8), {0, 0, 1});
  add_small_camera(scene, {0.5, 0.5, 1.5}, {1, 1, -0.6});
  survive(std::to_string(2 * n * n) + " triangles", scene, {{meters}},
          {.sppm_iterations = 64, .sppm_radius_m = radius_in_rooms});
}

}  // namespace
}  // namespace ups::test
