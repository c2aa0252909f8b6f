// Shading normals from both ends: what a light walk carries on at a leaning normal is corrected by
//   |wi ns| |wo ng| / (|wi ng| |wo ns|)     (Veach 1997, Eq. 5.19)
// so that path tracing, light tracing, bidirectional path tracing and photon merging measure the same at meters that a
// bumpy object or floor lights. No closed form is known; the estimators share only the scattering functions.
#include <random>

#include "../support/expect_same.h"

namespace ups::test {
namespace {

// Points over a square and the cells that tile it, so placed that only scattered light comes to their front.
struct Target {
  static constexpr int across = 12;
  Sensor points, cells;
  Target(Scene& scene, const P3& center, const P3& direction, double side) {
    const P3 n = normalize(direction), s = normalize(cross({0, 1, 0}, n)), t = cross(n, s);
    const auto centers = grid_about(center, s, t, side, across);
    const std::vector<P3> normals(centers.size(), n);
    points = scene.add_meters(centers, normals);
    cells = scene.add_cells(centers, normals, std::vector<P3>(centers.size(), s), side / across, side / across);
  }
  void judge(Scene& scene, const std::vector<Run>& runs) { expect_same(scene, runs, points, cells, 0, 0, true); }
};

std::vector<Run> all_runs(uint32_t light_paths, double merge_radius) {
  return {run(UPS_METHOD_PATH_TRACING, 16),
          run(UPS_METHOD_LIGHT_TRACING, 32, light_paths),
          run(UPS_METHOD_BIDIRECTIONAL, 16, light_paths / 4),
          run(UPS_METHOD_UPS, 16, light_paths / 4, merge_radius),
          run(UPS_METHOD_PPM, 32, light_paths, merge_radius),
          merge_only(32, light_paths / 2, merge_radius)};
}

// Random directions within 50 degrees of the true normal, at every vertex of a coarse sphere: facets that are smoothed
// far beyond what their shape is.
Shape bumpy_sphere(const P3& center, double radius) {
  Shape s = icosphere(center, radius, 2);
  std::mt19937 engine(3);
  const auto uniform = [&] { return std::generate_canonical<double, 53>(engine) * 2 - 1; };
  for (const P3& v : s.vertices) {
    const P3 n = normalize(v - center), lean{uniform(), uniform(), uniform()};
    s.normals.push_back(normalize(n + (lean - n * dot(lean, n)) * 0.8));
  }
  return s;
}

class BumpyObject : public ::testing::TestWithParam<std::pair<const char*, ups_material_desc>> {};
INSTANTIATE_TEST_SUITE_P(Materials, BumpyObject,
                         ::testing::Values(std::pair("Matte", matte(0.8)),
                                           std::pair("Plastic", rough(UPS_MATERIAL_PLASTIC, 0.6, 0.4)),
                                           std::pair("Metal", rough(UPS_MATERIAL_METAL, 0.9, 0.5))),
                         [](const auto& i) { return std::string(i.param.first); });

TEST_P(BumpyObject, LightsMetersAlikeFromBothEnds) {
  Scene scene;
  scene.add(bumpy_sphere({0, 0, 0}, 0.5), GetParam().second);
  scene.add(quad({-0.4, -0.4, 0.8}, {0, 0.8, 0}, {0.8, 0, 0}), emitter(1000));
  Target(scene, {0.8, 0, 0.9}, {-0.8, 0, -0.9}, 0.5).judge(scene, all_runs(1u << 16, 0.04));
}

// A floor of the given material whose normal texture leans by up to 45 degrees, smoothly in between.
class BumpyFloor : public ::testing::TestWithParam<std::pair<const char*, ups_material_desc>> {
 protected:
  void SetUp() override {
    constexpr uint32_t size = 16;
    std::mt19937 engine(5);
    const auto uniform = [&] { return std::generate_canonical<double, 53>(engine) * 2 - 1; };
    std::vector<float> texels;
    for (uint32_t i = 0; i < size * size; ++i) {
      const P3 n = normalize({0.7 * uniform(), 0.7 * uniform(), 1});
      texels.insert(texels.end(), {float(n.x / 2 + 0.5), float(n.y / 2 + 0.5), float(n.z / 2 + 0.5)});
    }
    ups_material_desc bumpy = GetParam().second;
    bumpy.normal_texture = scene.add_texture(size, size, texels);
    Shape floor = quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0});
    floor.uvs = {{0, 0}, {2, 0}, {2, 2}, {0, 2}};
    scene.add(floor, bumpy);
  }
  void judge(uint32_t light_paths) {
    Target(scene, {0.5, 0, 0.4}, {-0.5, 0, -0.4}, 0.5).judge(scene, all_runs(light_paths, 0.04));
  }
  Scene scene;
};
INSTANTIATE_TEST_SUITE_P(Materials, BumpyFloor,
                         ::testing::Values(std::pair("Matte", matte(0.8)),
                                           std::pair("Glossy", rough(UPS_MATERIAL_METAL, 0.9, 0.5))),
                         [](const auto& i) { return std::string(i.param.first); });

TEST_P(BumpyFloor, UnderAnAreaEmitter) {
  scene.add(quad({-0.8, -0.3, 0.5}, {0, 0.6, 0}, {0.6, 0, 0}), emitter(1000));
  judge(1u << 15);
}
TEST_P(BumpyFloor, UnderASourceWithoutExtent) {
  scene.add_spot({-0.5, 0, 0.6}, {0, 0, -1}, 100, 0.5, 0.7);
  judge(1u << 15);
}
TEST_P(BumpyFloor, UnderTheSun) {
  scene.add_directional({1, 0, -1}, 1000);
  judge(1u << 15);
}

}  // namespace
}  // namespace ups::test
