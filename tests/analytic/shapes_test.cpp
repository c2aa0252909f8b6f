// Are the references themselves right? Meshes' areas and sides, and the closed forms that other tests judge the engine
// by, against published numbers: view factors of squares, CIE 171:2006 case 5.3, discs and spheres.
#include <gtest/gtest.h>

#include "../support/shapes.h"

namespace ups::test {
namespace {

TEST(Shapes, FacesPointOutwardsAndAreasAreRight) {
  for (const Shape& s : {box({-1, -2, -3}, {1, 2, 3}), icosphere({0, 0, 0}, 2, 3)})
    for (size_t t = 0; t < s.triangles.size(); ++t) ASSERT_GT(dot(s.area_normal(t), s.centroid(t)), 0);
  EXPECT_NEAR(box({-1, -2, -3}, {1, 2, 3}).area(), 2 * (8 + 12 + 24), 1e-12);
  EXPECT_NEAR(icosphere({1, 2, 3}, 2, 4).area() / (16 * pi_d), 1, 2e-3);
  EXPECT_NEAR(disc({1, 2, 3}, {1, 1, 0}, 2, 360).area() / (4 * pi_d), 1, 1e-4);
  EXPECT_GT(dot(disc({0, 0, 0}, {0, -1, 2}, 1, 8).area_normal(3), {0, -1, 2}), 0);
}

TEST(Shapes, PolygonFormulaGivesKnownViewFactors) {
  const auto factor = [](const Shape& q, const P3& p, const P3& n) {
    return polygon_irradiance_factor(q.vertices, p, n);
  };
  const Shape above = quad({0, 0, 1}, {0, 1, 0}, {1, 0, 0});  // unit square, faces down
  EXPECT_NEAR(1000 * factor(above, {0, 0, 0}, {0, 0, 1}), 435.21, 0.01);
  EXPECT_NEAR(1000 * factor(above, {0.5, 0.5, 0}, {0, 0, 1}), 752.275, 0.001);
  EXPECT_LT(factor(above, {0, 0, 2}, {0, 0, -1}), 0);  // from behind
  const Shape upright = quad({0, 1, 0}, {1, 0, 0}, {0, 0, 1});
  EXPECT_NEAR(1000 * factor(upright, {0, 0, 0}, {0, 0, 1}), 175.094, 0.001);
}

TEST(Shapes, PolygonFormulaGivesTheAreaSourceOfCie171) {
  const Shape source = quad({1.5, 1.5, 3}, {0, 1, 0}, {1, 0, 0});
  const double wall[] = {32.677, 75.194, 81.323, 69.061, 53.404, 40.002};
  for (int i = 0; i < 6; ++i)
    EXPECT_NEAR(1000 * polygon_irradiance_factor(source.vertices, {2, 0, 2.75 - 0.5 * i}, {0, 1, 0}), wall[i], 0.001);
  const double floor[] = {61.424, 79.255, 95.667, 105.778};
  for (int i = 0; i < 4; ++i)
    EXPECT_NEAR(1000 * polygon_irradiance_factor(source.vertices, {2, 0.25 + 0.5 * i, 0}, {0, 0, 1}), floor[i], 0.001);
}

TEST(Shapes, MeshesComeCloseToTheirRoundModels) {
  const double radius = 0.5, distance = 0.8;
  EXPECT_NEAR(convex_irradiance_factor(disc({0, 0, distance}, {0, 0, -1}, radius, 256), {0, 0, 0}, {0, 0, 1}),
              pi_d * radius * radius / (radius * radius + distance * distance), 2e-4);
  EXPECT_NEAR(convex_irradiance_factor(icosphere({0, 0, distance}, radius, 4), {0, 0, 0}, {0, 0, 1}),
              pi_d * radius * radius / (distance * distance), 3e-3);
}

}  // namespace
}  // namespace ups::test
