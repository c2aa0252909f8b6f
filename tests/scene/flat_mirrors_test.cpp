// Which surfaces are flat mirrors, and the choice among the images of lamps in them.
#include "scene/flat_mirrors.h"

#include <gtest/gtest.h>

#include "../oracle/replay_room.h"

namespace ups::test {
namespace {

const ups_material_desc mirror = RoomBuilder::material(UPS_MATERIAL_MIRROR, 0.8f),
                        other = RoomBuilder::material(UPS_MATERIAL_MIRROR, 0.5f);

void add_lamps(RoomBuilder& b, int count) {
  for (int i = 0; i < count; ++i)
    b.add_light(i % 3 ? UPS_LIGHT_POINT : UPS_LIGHT_SPOT, {0.3 + 0.37 * (i % 10), 0.5 + 0.21 * (i / 10), 2.5},
                100.0f + float(i));
}

TEST(FlatMirrors, WhatLiesInOnePlaneIsOne) {
  RoomBuilder b;
  b.add(quad({0, 0, 0}, {0, 0, 1}, {1, 0, 0}), mirror);
  b.add(quad({2, 0, 0}, {1, 0, 0}, {0, 0, 1}), mirror);
  b.add(quad({4, 0, 0}, {1, 0, 0}, {0, 0, 1}), other);
  add_lamps(b, 2);
  const Room room = b.build();
  const FlatMirrors& m = room.scene->flat_mirrors;
  // Each material is a number of its own, so that none of the three may share a plane; all lie in one.
  EXPECT_EQ(m.planes.size(), 3u);
  EXPECT_EQ(m.images.size(), 6u);
  EXPECT_TRUE(m.all_flat && m.complete);
  EXPECT_EQ(m.plane_of(0, 0), m.plane_of(0, 1));
  EXPECT_NE(m.plane_of(0, 0), m.plane_of(1, 0));
}

TEST(FlatMirrors, ASlabHasSixThatAreNotComplete) {
  RoomBuilder b;
  b.add(box({0, 0, 0}, {1, 1, 0.01}), mirror);
  add_lamps(b, 1);
  const Room room = b.build();
  const FlatMirrors& m = room.scene->flat_mirrors;
  EXPECT_EQ(m.planes.size(), 6u);
  EXPECT_TRUE(m.all_flat);
  EXPECT_FALSE(m.complete);
  EXPECT_FALSE(room.scene->effects.path_tracing_complete);
}

TEST(FlatMirrors, WhatIsBentOrShinesOrHasALampOnItIsNone) {
  Shape bent = quad({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  bent.normals.assign(4, normalize(P3{0.001, 1, 0}));
  ups_material_desc shining = mirror, masked = mirror;
  std::fill_n(shining.luminance_cd_m2, 3, 1.0f);
  masked.alpha_mode = UPS_ALPHA_MASK;
  const auto found = [](const Shape& shape, const ups_material_desc& material, const P3& lamp) {
    RoomBuilder b;
    b.add(shape, material);
    b.add_light(UPS_LIGHT_POINT, lamp, 100);
    const Room room = b.build();
    EXPECT_EQ(room.scene->flat_mirrors.empty(), !room.scene->flat_mirrors.complete);
    return room.scene->flat_mirrors.images.size();
  };
  const Shape flat = quad({0, 0, 0}, {0, 0, 1}, {1, 0, 0});
  EXPECT_EQ(found(flat, mirror, {0, 1, 0}), 1u);
  EXPECT_EQ(found(bent, mirror, {0, 1, 0}), 0u);
  EXPECT_EQ(found(flat, shining, {0, 1, 0}), 0u);
  EXPECT_EQ(found(flat, masked, {0, 1, 0}), 0u);
  EXPECT_EQ(found(flat, mirror, {0.5, 0, 0.5}), 0u);
  EXPECT_EQ(found(icosphere({0, 0, 0}, 1, 0), mirror, {0, 3, 0}), 0u);  // twenty planes
}

// Chosen as often as it is said, each with the probability that can be asked for: few images, which are weighed, and
// many, which are a tree's; of mirrors, and of panes, which are looked into more seldom.
TEST(FlatMirrors, ImagesAreChosenAsOftenAsIsSaid) {
  for (const int lamps : {3, 90})
    for (const bool panes : {false, true}) {
      RoomBuilder b;
      if (panes)
        b.add_pane({0, 0, 0}, {0, 0, 3}, {4, 0, 0}, 1), b.add_pane({0, 0, 0}, {0, 4, 0}, {0, 0, 3}, 1);
      else
        b.add(quad({0, 0, 0}, {0, 0, 3}, {4, 0, 0}), mirror), b.add(quad({0, 0, 0}, {0, 4, 0}, {0, 0, 3}), other);
      add_lamps(b, lamps);
      const Room room = b.build();
      const Snapshot& scene = *room.scene;
      ASSERT_EQ(scene.flat_mirrors.images.size(), size_t(2 * lamps));
      EXPECT_NEAR(scene.flat_mirrors.frequency, panes ? 2 * 0.04 / 1.04 : 0.8, 1e-3);
      const auto at = [&](const Vec3d& p, const Vec3& n) { return Receiver{Vec3(p - scene.origin), n}; };
      const Receiver receivers[] = {at({1, 1, 0}, {0, 0, 1}), at({3, 2, 1}, normalize(Vec3(-1, -1, 0))),
                                    at({2, 2, 1}, Vec3())};
      for (const Receiver& r : receivers) {
        constexpr int count = 1 << 14;
        std::vector<double> share(scene.flat_mirrors.images.size());
        for (int i = 0; i < count; ++i) {
          const EmitterChoice c = choose_image(scene, r, (float(i) + 0.5f) / count);
          if (!(c.probability > 0)) continue;
          share[c.index] += 1.0 / count;
          EXPECT_NEAR(c.probability, image_probability(scene, r, c.index), 1e-5 * double(c.probability));
        }
        double sum = 0;
        for (uint32_t i = 0; i < share.size(); ++i) {
          sum += share[i];
          EXPECT_NEAR(share[i], image_probability(scene, r, i), 2.0 / count + 1e-4 * share[i]) << i;
        }
        EXPECT_NEAR(sum, scene.flat_mirrors.frequency, 1e-3);
      }
    }
}

}  // namespace
}  // namespace ups::test
