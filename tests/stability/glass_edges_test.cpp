// Where a meter stands right below the edge of a solid of glass, or touches one, its reading may be off by more than its
// bound says: that is told, and of meters elsewhere it is not.
#include "../support/scene_warnings.h"
#include "../support/shapes.h"

namespace ups::test {
namespace {

std::string told(const std::vector<P3>& meters, double slab_from) {
  Scene scene;
  scene.add(quad({-0.5, -0.5, 0}, {1, 0, 0}, {0, 1, 0}), matte(0));
  scene.add(box({-0.2, -0.2, slab_from}, {0.2, 0.2, slab_from + 0.02}), glass(1.5));
  scene.add_directional({0, 0, -1}, 1000);
  scene.add_meters(meters, {0, 0, 1});
  return scene_warnings(scene);
}

TEST(Taught, MetersByAnEdgeOfGlassAreTold) {
  const std::vector<P3> meters = {{0.195, 0, 0}, {0.205, 0.1, 0}, {0.2, 0.2, 0}, {0.17, 0, 0}, {0.23, 0, 0}, {0, 0, 0}};
  EXPECT_NE(told(meters, 0.001).find("3 of 6 lie within 1 cm of an edge of glass"), std::string::npos)
      << told(meters, 0.001);
  EXPECT_EQ(told(meters, 0.001).find("touch a solid of glass"), std::string::npos);
  EXPECT_EQ(told(meters, 0.1).find("edge of glass"), std::string::npos) << "far above";
  EXPECT_EQ(told({{0.17, 0, 0}, {0.23, 0, 0}}, 0.001).find("edge of glass"), std::string::npos) << "beside";
}

TEST(Taught, MetersThatTouchGlassAreTold) {
  EXPECT_NE(told({{0, 0, 0}, {0.1, 0.1, 0}, {0.3, 0, 0}}, 0).find("2 of 3 touch a solid of glass"), std::string::npos)
      << told({{0, 0, 0}, {0.1, 0.1, 0}, {0.3, 0, 0}}, 0);
  EXPECT_EQ(told({{0, 0, 0}, {0.3, 0, 0}}, 0.0001).find("touch a solid of glass"), std::string::npos);
}

}  // namespace
}  // namespace ups::test
