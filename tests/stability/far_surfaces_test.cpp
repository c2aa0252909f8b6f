// Surfaces far from all that a scene is about: floats hold places relative to its middle, so that a stray triangle
// would cost the room its precision. What nobody can see is left out and told; what cannot be left out is told.
#include <gtest/gtest.h>

#include "../support/scene_warnings.h"

namespace ups::test {
namespace {

struct Room {
  Scene scene{1};
  Sensor meters;

  Room() {
    scene.add(box({0, 0, 0}, {4, 3, 2.5}).flipped(), matte(0.5));
    scene.add_point_light({2, 1.5, 2}, 100);
    meters = scene.add_meters({{1, 1, 0.75}, {2, 2, 0.75}, {3, 1, 0.2}}, {0, 0, 1});
  }
  ups_instance_id add_far(double distance, double size, const ups_material_desc& material) {
    return scene.add(quad({0, 0, 0}, {size, 0, 0}, {0, size, 0}), material, {distance, 0, 0});
  }
  std::vector<float> lux() {
    std::vector<float> out;
    for (const ups_meter_reading& r : scene.render({.iterations = 8}).readings(meters))
      out.push_back(r.illuminance_lx);
    return out;
  }
};

// The same bits as without it; it comes back with the edit that brings it near.
TEST(Taught, OneSurfaceFarAwayCostsNoPrecision) {
  Room alone;
  const auto expected = alone.lux();
  for (const double distance : {1e5, 1e6, 3e6, 1e8}) {
    Room room;
    room.add_far(distance, distance * 1e-4, matte(0.5));
    EXPECT_EQ(room.lux(), expected) << distance;
    EXPECT_NE(scene_warnings(room.scene).find("instance 2: left out"), std::string::npos) << scene_warnings(room.scene);
  }
  Room many;  // most of what there is, together still nothing to be seen
  for (int i = 0; i < 100; ++i) many.add_far(1e6 + 1e5 * i, 10, matte(0.5));
  EXPECT_EQ(many.lux(), expected);
  EXPECT_NE(scene_warnings(many.scene).find("instances 2, 3, 4 and 97 more: left out"), std::string::npos);
  Room edited;
  const ups_instance_id far = edited.add_far(3e6, 1, matte(0.5));
  EXPECT_EQ(edited.lux(), expected);
  Room near;
  near.add_far(1.5, 1, matte(0.5));
  auto desc = make_desc<ups_instance_desc>(ups_instance_desc_init);
  check(ups_scene_get_instance(edited.scene.get(), far, &desc), "ups_scene_get_instance");
  desc.to_world[3] = 1.5;
  check(ups_scene_set_instance(edited.scene.get(), far, &desc), "ups_scene_set_instance");
  EXPECT_EQ(edited.lux(), near.lux());
  EXPECT_EQ(scene_warnings(edited.scene).find("left out"), std::string::npos);
}

// What shines, is measured, may throw a shadow of parallel light, or is wide enough to be seen is not left out.
TEST(Taught, SurfacesFarAwayThatCountAreNamed) {
  const auto names_it = [](const std::string& text, const char* verdict = "readings are wrong") {
    const size_t at = text.find("instance id 2 reaches farthest");
    return at != std::string::npos && text.find(verdict, at) != std::string::npos;
  };
  Room shining;
  shining.add_far(3e6, 100, emitter(1000));
  EXPECT_TRUE(names_it(scene_warnings(shining.scene))) << scene_warnings(shining.scene);
  Room measured;
  measured.scene.add_surface_meters({measured.add_far(3e6, 100, matte(0.5))}, 2);
  EXPECT_TRUE(names_it(scene_warnings(measured.scene))) << scene_warnings(measured.scene);
  Room sunlit;
  sunlit.add_far(3e6, 100, matte(0.5));
  sunlit.scene.add_directional({-1, 0, -0.1}, 1e4);
  EXPECT_TRUE(names_it(scene_warnings(sunlit.scene))) << scene_warnings(sunlit.scene);
  Room wide;
  wide.add_far(1e5, 1e3, matte(0.5));
  EXPECT_TRUE(names_it(scene_warnings(wide.scene), "more exact")) << scene_warnings(wide.scene);
  Room horizon;  // each tile is too small to be seen, not all of them
  for (int i = 0; i < 6000; ++i) horizon.add_far(1e6 + i, 100, matte(0.5));
  const std::string told = scene_warnings(horizon.scene);
  EXPECT_NE(told.find("instance id 6001 reaches farthest"), std::string::npos) << told;
  Room plain;
  plain.add_far(1e3, 100, matte(0.5));
  EXPECT_EQ(scene_warnings(plain.scene), "");
}

// A mesh with one vertex astray is one surface, which cannot be left out.
TEST(Taught, AVertexAstrayIsNamed) {
  Scene scene;
  Shape room = box({0, 0, 0}, {4, 3, 2.5}).flipped();
  room.vertices.push_back({3e6, 0, 0});
  room.triangles.push_back({0, 1, uint32_t(room.vertices.size() - 1)});
  scene.add(room, matte(0.5));
  scene.add_point_light({2, 1.5, 2}, 100);
  scene.add_meters({{1, 1, 0.75}, {2, 2, 0.75}}, {0, 0, 1});
  const std::string told = scene_warnings(scene);
  EXPECT_NE(told.find("instance id 1 reaches farthest: readings are wrong"), std::string::npos) << told;
}

}  // namespace
}  // namespace ups::test
