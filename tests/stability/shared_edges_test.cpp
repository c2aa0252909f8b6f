// Hazard 10: a ray through an edge or a corner that triangles share meets them all, or none. Light that goes straight
// through a pane or a block of absorbing index-1 glass must lose to it once. Deterministic: no false alarm; an error of
// 1e-5 is found, and a pane that counts twice is 8 % or more.
#include <vector>

#include "../support/expect_lx.h"

namespace ups::test {
namespace {

constexpr int cells = 16;

// The unit square at z, in cells x cells squares of two triangles; faces up.
Shape tiled_square(double z) {
  Shape s;
  for (int j = 0; j <= cells; ++j)
    for (int i = 0; i <= cells; ++i) s.vertices.push_back({double(i) / cells, double(j) / cells, z});
  for (uint32_t j = 0; j < cells; ++j)
    for (uint32_t i = 0; i < cells; ++i) {
      const uint32_t a = j * (cells + 1) + i, b = a + 1, c = a + cells + 1, d = c + 1;
      s.triangles.insert(s.triangles.end(), {{a, b, d}, {a, d, c}});
    }
  return s;
}

// Meters under the inner corners, edges, diagonals and middles of the tiles.
std::vector<P3> under_the_grid() {
  std::vector<P3> out;
  for (int j = 1; j < 4 * cells; ++j)
    for (int i = 1; i < 4 * cells; ++i) out.push_back({0.25 * i / cells, 0.25 * j / cells, 0});
  return out;
}

// Direct light: panes also send some to and fro between them.
void expect_everywhere(Scene& scene, const Sensor& meters, double expected) {
  for (const ups_method method : {UPS_METHOD_PATH_TRACING, UPS_METHOD_UPS}) {
    const auto readings = scene.render({.method = method, .iterations = 8, .light_paths = 1024}).readings(meters);
    for (size_t i = 0; i < readings.size() && !::testing::Test::HasFailure(); ++i)
      expect_ratio(readings[i].direct_lx, expected, 1e-5, method_name(method) + (", meter " + std::to_string(i)));
  }
}

ups_material_desc pane(double transmittance) {
  ups_material_desc m = material(UPS_MATERIAL_GLAZING, 1);
  m.ior = 1.5f;
  for (float& t : m.transmittance_rgb) t = float(transmittance);
  return m;
}

TEST(Hazard10, LightStraightThroughPanesIsTransmittedOnceByEach) {
  Scene scene;
  scene.add(tiled_square(0.5), pane(0.5));
  scene.add(tiled_square(0.75), pane(0.8));
  scene.add_directional({0, 0, -1}, 1000);
  const Sensor meters = scene.add_meters(under_the_grid(), {0, 0, 1});
  expect_everywhere(scene, meters, 1000 * 0.5 * 0.8);
}

// Index 1 beside another solid: boundaries without effect, which only absorb.
TEST(Hazard10, LightStraightThroughABlockIsAbsorbedOnce) {
  Scene scene;
  ups_material_desc block = glass(1);
  for (float& a : block.absorption_per_m_rgb) a = 2;
  Shape solid = tiled_square(0.75);
  solid.append(tiled_square(0.5).flipped());
  solid.append(quad({0, 0, 0.5}, {1, 0, 0}, {0, 0, 0.25}));
  solid.append(quad({0, 1, 0.5}, {0, 0, 0.25}, {1, 0, 0}));
  solid.append(quad({0, 0, 0.5}, {0, 0, 0.25}, {0, 1, 0}));
  solid.append(quad({1, 0, 0.5}, {0, 1, 0}, {0, 0, 0.25}));
  scene.add(solid, block);
  scene.add_directional({0, 0, -1}, 1000);
  const Sensor meters = scene.add_meters(under_the_grid(), {0, 0, 1});
  expect_everywhere(scene, meters, 1000 * std::exp(-0.5));
}

}  // namespace
}  // namespace ups::test
