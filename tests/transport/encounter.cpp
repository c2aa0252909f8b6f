// Which of several faces at one place a ray meets.
#include "transport/encounter.h"

#include <gtest/gtest.h>

#include "../oracle/replay_room.h"

namespace ups {
namespace {

// Blocks of glass that touch, one of them rough: the boundary is that of the stronger one, whichever way a ray comes,
// so that both walks of a path scatter at the same.
TEST(Encounter, FacesThatTouchAreTheStrongestSolids) {
  for (const int32_t first_priority : {2, 0}) {
    test::RoomBuilder builder;
    ups_material_desc first = test::RoomBuilder::material(UPS_MATERIAL_GLASS, 1, 0), second = first;
    first.ior = 1.4f, first.priority = first_priority;
    second.ior = 1.7f, second.priority = 1, second.roughness = 0.5f;
    builder.add(test::box({0, 0, 0}, {1, 1, 1}), first);
    builder.add(test::box({1, 0, 0}, {2, 1, 1}), second);
    const test::Room room = builder.build();
    const Snapshot& scene = *room.scene;
    for (const float sign : {1.0f, -1.0f}) {
      const Vec3 from = Vec3(Vec3d(sign > 0 ? -1 : 3, 0.4, 0.6) - scene.origin), d(sign, 0, 0);
      WorkCounts work;
      Encounter outside, between;
      PaneNumber u(0);
      meet(scene, from, d, {}, u, work, outside);
      ASSERT_TRUE(outside.found);
      meet(scene, outside.surface.ray_origin(d), d, outside.beyond(d), u, work, between);
      ASSERT_TRUE(between.found);
      EXPECT_NEAR(between.surface.p.x + scene.origin.x, 1, 1e-5);
      EXPECT_EQ(scene.materials[between.surface.material].ior, first_priority > 1 ? 1.4f : 1.7f) << sign;
      const float ahead = between.surface.ng.x * sign < 0 ? between.relative_ior : 1 / between.relative_ior;
      EXPECT_NEAR(ahead, sign > 0 ? 1.7f / 1.4f : 1.4f / 1.7f, 1e-6f) << sign;
    }
  }
}

}  // namespace
}  // namespace ups
