// Which surfaces are flat mirrors, and the choice among the images of lamps in them.
#include "scene/flat_mirrors.h"

#include <gtest/gtest.h>

#include "../oracle/random_path.h"
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

void add_luminous_quads(RoomBuilder& b, int count) {
  for (int i = 0; i < count; ++i) {
    ups_material_desc shining = RoomBuilder::material(UPS_MATERIAL_MATTE, 0, 0);
    std::fill_n(shining.luminance_cd_m2, 3, 100.0f + float(i));
    b.add(quad({0.3 + 0.37 * (i % 10), 0.5 + 0.21 * (i / 10), 2.5}, {0, 0.2, 0}, {0.05 + 0.2 * (i % 2), 0, 0.1}),
          shining);
  }
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

// One by one, triangles whose planes lean by a tenth of a millimetre are two mirrors.
TEST(FlatMirrors, WhatLeansIsNotInOnePlane) {
  for (const double off : {0.0, 1e-4}) {
    RoomBuilder b;
    const auto triangle = [](const P3& p, const P3& q, const P3& r) {
      Shape shape;
      shape.vertices = {p, q, r};
      shape.triangles = {{0, 1, 2}};
      return shape;
    };
    b.add(triangle({2, 0, 0}, {2, 0, 2}, {0, 0, 2}), mirror);
    b.share_material();
    b.add(triangle({0, 0, 0}, {-2, -off, 0}, {0, 0, 2}), mirror);
    b.add_light(UPS_LIGHT_POINT, {0, 1, 0}, 100);
    EXPECT_EQ(b.build().scene->flat_mirrors.planes.size(), off > 0 ? 2u : 1u) << off;
  }
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
// many, which are a tree's; of mirrors, and of panes, which are looked into more seldom; of lamps with extent and
// without, of which a tree has none with extent.
TEST(FlatMirrors, ImagesAreChosenAsOftenAsIsSaid) {
  for (const int kinds : {0, 1, 2, 3}) {
    const bool panes = kinds & 1, extended = kinds & 2;
    for (const int lamps : {3, extended ? 30 : 90}) {
      RoomBuilder b;
      if (panes)
        b.add_pane({0, 0, 0}, {0, 0, 3}, {4, 0, 0}, 1), b.add_pane({0, 0, 0}, {0, 4, 0}, {0, 0, 3}, 1);
      else
        b.add(quad({0, 0, 0}, {0, 0, 3}, {4, 0, 0}), mirror), b.add(quad({0, 0, 0}, {0, 4, 0}, {0, 0, 3}), other);
      if (extended) add_luminous_quads(b, lamps);
      else add_lamps(b, lamps);
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
          const EmitterChoice c = choose_image(scene, r, (float(i) + 0.5f) / count, false);
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
}

// Chosen by itself; and of the lamps none is forgotten, however strong another one is.
TEST(FlatMirrors, TheSunLeavesLampsTheirImages) {
  RoomBuilder b;
  b.add(quad({0, 0, 0}, {0, 0, 3}, {4, 0, 0}), mirror);
  add_lamps(b, 3);
  b.add_light(UPS_LIGHT_POINT, {3.5, 2, 2}, 1e7f);
  b.add_light(UPS_LIGHT_DIRECTIONAL, {}, 1e5f, -0.9);  // towards the mirror
  const Room room = b.build();
  const Snapshot& scene = *room.scene;
  const double frequency = double(scene.flat_mirrors.frequency);
  const uint32_t sun = scene.flat_mirrors.image_of(4, 0);
  ASSERT_NE(sun, none);
  const Receiver r{Vec3(Vec3d{2, 0.5, 0} - scene.origin), {0, 0, 1}};
  EXPECT_NEAR(image_probability(scene, r, sun), frequency, 1e-6);
  double lamps = 0;
  for (uint32_t i = 0; i < 4; ++i) {
    const double p = image_probability(scene, r, scene.flat_mirrors.image_of(i, 0));
    EXPECT_GE(p, 0.0249 * frequency) << i;
    lamps += p;
  }
  EXPECT_NEAR(lamps, frequency, 1e-5);
}

// As long as all images can be weighed; else it is left to light paths.
TEST(FlatMirrors, TheSunHasImagesInFewMirrors) {
  for (const int mirrors : {30, 70})
    for (const int lamps : {0, 1}) {
      RoomBuilder b;
      for (int i = 0; i < mirrors; ++i) b.add(quad({0.01 * i, 0.1 * i, 0}, {0, 0, 1}, {1, 0.01 * i, 0}), mirror);
      add_lamps(b, lamps);
      b.add_light(UPS_LIGHT_DIRECTIONAL, {}, 1e5f, -0.9);
      const Room room = b.build();
      const FlatMirrors& m = room.scene->flat_mirrors;
      size_t of_sun = 0;
      for (const FlatMirrors::Image& image : m.images) of_sun += image.far;
      EXPECT_EQ(of_sun, mirrors == 30 ? 30u : lamps ? 0u : 64u) << mirrors << " " << lamps;
      EXPECT_EQ(m.all_flat, mirrors == 30) << mirrors << " " << lamps;
    }
}

// At 45 degrees to the axes: a lamp of 1.4 m, along the mirror and 0.28 m before it, and across it. An opening of 0.3 m by
// 0.4 m by 0.15 m, whose corners are 0.26 m from its middle, 0.22 and 0.1 m before a mirror.
TEST(FlatMirrors, ALampsExtentIsThatAcrossTheMirror) {
  for (const bool along : {false, true}) {
    RoomBuilder b;
    b.add(quad({0, 0, 0}, {0, 0, 1}, {1, 1, 0}), mirror);
    ups_material_desc shining = RoomBuilder::material(UPS_MATERIAL_MATTE, 0, 0);
    std::fill_n(shining.luminance_cd_m2, 3, 100.0f);
    const P3 s = along ? P3{1, 1, 0} : P3{1, -1, 0}, at{0.2, 0.6, 1.5};
    b.add(quad(at - s * 0.5, s, {0, 0, 0.05}), shining);
    EXPECT_EQ(b.build().scene->flat_mirrors.images.size(), along ? 1u : 0u);
  }
  for (const double before : {0.22, 0.1}) {
    RoomBuilder b;
    b.add(quad({0, 0, 0}, {0, 0, 1}, {1, 0, 0}), mirror);
    b.add_luminaire({0.5, before, 2}, true);
    EXPECT_EQ(b.build().scene->flat_mirrors.images.size(), before > 0.2 ? 1u : 0u);
  }
}

// Lamps without extent come first; of the others those in the largest mirrors, as long as all images can be weighed.
TEST(FlatMirrors, LampsWithExtentTakeNoRoomFromOthers) {
  const auto find = [](int points, int quads, bool straddling) {
    RoomBuilder b;
    b.add(quad({0, 0, 0}, {0, 0, 3}, {4, 0, 0}), mirror);
    b.add(quad({0, 0, 0}, {0, 1, 0}, {0, 0, 1}), other);
    add_lamps(b, points);
    add_luminous_quads(b, quads);
    if (straddling) {
      ups_material_desc shining = RoomBuilder::material(UPS_MATERIAL_MATTE, 0, 0);
      std::fill_n(shining.luminance_cd_m2, 3, 100.0f);
      b.add(quad({1, -0.1, 3.5}, {0, 0.5, 0}, {0.6, 0, 0}), shining);
    }
    const Room room = b.build();
    const FlatMirrors& m = room.scene->flat_mirrors;
    EXPECT_EQ(m.of_extended, m.images.size() > size_t(2 * points));
    return std::pair(m.images.size(), m.of_all);
  };
  EXPECT_EQ(find(3, 20, false), (std::pair<size_t, bool>(46, true)));
  EXPECT_EQ(find(3, 20, true), (std::pair<size_t, bool>(47, false)));  // it stands before the small one
  EXPECT_EQ(find(0, 40, false), (std::pair<size_t, bool>(40, true)));  // of one plane; the other is none
  EXPECT_EQ(find(10, 40, false), (std::pair<size_t, bool>(60, false)));
  EXPECT_EQ(find(10, 70, false), (std::pair<size_t, bool>(20, false)));
  EXPECT_EQ(find(40, 5, false), (std::pair<size_t, bool>(80, false)));
}

// A lamp in a box of glass, one beside a ball of glass, one that shines into the mirror alone.
TEST(FlatMirrors, WhatGlassHidesHasNoImage) {
  RoomBuilder b;
  b.add(quad({-4, 0, -4}, {0, 0, 8}, {8, 0, 0}), mirror);
  ups_material_desc shining = RoomBuilder::material(UPS_MATERIAL_MATTE, 0, 0);
  std::fill_n(shining.luminance_cd_m2, 3, 100.0f);
  b.add(icosphere({0, 1, 0}, 0.05, 1), shining);
  b.add(box({-0.1, 0.9, -0.1}, {0.1, 1.1, 0.1}), RoomBuilder::material(UPS_MATERIAL_GLASS, 1, 0));
  b.add(icosphere({2, 1, 0}, 0.05, 1), shining);
  b.add(quad({-2, 0.5, 0}, {0.1, 0, 0}, {0, 0, 0.1}), shining);
  const Room room = b.build();
  const FlatMirrors& m = room.scene->flat_mirrors;
  EXPECT_EQ(m.image_of(0, 0), none);
  EXPECT_NE(m.image_of(1, 0), none);
  EXPECT_NE(m.image_of(2, 0), none);
  EXPECT_FALSE(m.of_all);
}

// Of boxes that stand before the mirror anyhow, and seen from anywhere: whatever point of one the mirror shows, the box is
// seen; and where it is seen, some point often is.
TEST(FlatMirrors, WhereAPartIsShownTheWholeIsSeen) {
  RoomBuilder b;
  b.add(quad({0, 0, 0}, {0, 0, 0.5}, {0.8, 0, 0}), mirror);
  add_lamps(b, 1);
  const Room room = b.build();
  const FlatMirrors& m = room.scene->flat_mirrors;
  const FlatMirrors::Plane& plane = m.planes[0];
  const Vec3 origin(room.scene->origin);
  Random random(4);
  const auto in = [&](float low, float high) { return float(random.uniform(double(low), double(high))); };
  int seen = 0, shown = 0;
  for (int i = 0; i < 20000; ++i) {
    const Vec3 half(in(0, 0.8f), in(0, 0.8f), in(0, 0.8f)), center(in(-2, 2), half.y + in(1e-4f, 2), in(-2, 2)),
        p = Vec3(in(-2, 2), in(0.01f, 3), in(-2, 2)) - origin;
    const FlatMirrors::Image image{0, 0, center - origin, length(half), half.y, false};
    const bool may = m.may_show(image, p);
    bool is = false;
    for (int k = 0; k < 64; ++k) {
      const auto corner = [&](int axis) { return k < 8 ? (k >> axis & 1 ? 1.0f : -1.0f) : in(-1, 1); };
      const Vec3 x = image.center + Vec3(half.x * corner(0), half.y * corner(1), half.z * corner(2));
      Vec3 at;
      is |= plane.shows(x, false, p, at);
    }
    EXPECT_TRUE(may || !is) << i;
    seen += may, shown += is;
  }
  EXPECT_GT(shown, 2000);
  EXPECT_GT(shown, seen / 4);
}

// A lamp through whose body the mirror's plane goes has no image, nor has one on it.
TEST(FlatMirrors, LampsWithExtentHaveImagesWhereTheyStandOnOneSide) {
  const auto images = [](const Shape& lamp, bool pane) {
    RoomBuilder b;
    ups_material_desc shining = RoomBuilder::material(UPS_MATERIAL_MATTE, 0, 0);
    std::fill_n(shining.luminance_cd_m2, 3, 100.0f);
    b.add(lamp, shining);
    if (pane) b.add_pane({0, 0, 0}, {0, 0, 1}, {1, 0, 0}, 1);
    else b.add(quad({0, 0, 0}, {0, 0, 1}, {1, 0, 0}), mirror);
    const Room room = b.build();
    EXPECT_TRUE(room.scene->flat_mirrors.empty() || room.scene->flat_mirrors.of_all);
    EXPECT_EQ(room.scene->flat_mirrors.of_extended, !room.scene->flat_mirrors.empty());
    return room.scene->flat_mirrors.images.size();
  };
  for (const bool pane : {false, true}) {
    EXPECT_EQ(images(icosphere({0.5, 1, 0.5}, 0.9, 1), pane), 1u);
    EXPECT_EQ(images(icosphere({0.5, 1, 0.5}, 1.1, 1), pane), 0u);
    EXPECT_EQ(images(quad({0.2, 0.1, 2}, {0, 0.5, 0}, {0.6, 0, 0}), pane), 1u);
    EXPECT_EQ(images(quad({0.2, 0, 2}, {0, 0.5, 0}, {0.6, 0, 0}), pane), 0u);
  }
}

}  // namespace
}  // namespace ups::test
