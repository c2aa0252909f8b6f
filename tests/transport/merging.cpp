// Which photons are merged, and which part of a meter's disc catches them.
#include <gtest/gtest.h>

#include "../oracle/replay_room.h"
#include "transport/techniques.h"

namespace ups {
namespace {

// A meter on a floor and one photon near it, straight from above but for what is said.
struct Photon {
  Vec3 offset, ng, wo;
};
bool is_merged(const Photon& photon) {
  test::RoomBuilder builder;
  builder.add(test::quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), test::RoomBuilder::material(UPS_MATERIAL_MATTE));
  const test::Room room = builder.build();
  TransportSettings settings;
  settings.method = *method_of(UPS_METHOD_UPS);
  settings.techniques = UPS_TECHNIQUE_MERGE;
  Plan plan = make_plan(*room.scene, settings);
  plan.gates.assign(1, {});
  plan.light_paths = 100;
  plan.walk_radius = 0.1f;
  const StopSignal stop;
  const Iteration in(*room.scene, plan, settings, 0, stop);
  mis::Counts counts;
  counts.eta = 1;
  const MediaStack media;
  const EyeEnd eye = meter_end({0.2f, 0.3f, 0}, 0, Frame(Vec3(0, 0, 1)), {}, mis::at_meter(counts, 1, 0), media);
  LightVertex v;
  v.p = eye.surface.p + photon.offset;
  v.ng = v.ns = normalize(photon.ng);
  v.wo = normalize(photon.wo);
  v.flux = Rgb(1.0f);
  v.depth = 1;
  return merge(in, counts, eye, v, v.p, 0.1).has_value();
}

TEST(Merging, TakesPhotonsOfTheSameSideOfTheSameSurface) {
  const Vec3 up(0, 0, 1), across(0.05f, 0, 0);
  EXPECT_TRUE(is_merged({across, up, up}));
  EXPECT_TRUE(is_merged({across + up * 0.009f, up, up}));
  EXPECT_FALSE(is_merged({across + up * 0.011f, up, up}));  // a tenth of the radius
  EXPECT_FALSE(is_merged({across - up * 0.011f, up, up}));
  EXPECT_TRUE(is_merged({across, Vec3(0.5f, 0, 1), up}));  // turned by 27 degrees
  EXPECT_FALSE(is_merged({across, Vec3(1.2f, 0, 1), up}));  // by 50
  EXPECT_FALSE(is_merged({across, up, -up}));
  EXPECT_TRUE(is_merged({across, Vec3(0.5f, 0, 1), Vec3(-1, 0, 0.6f)}));
  EXPECT_FALSE(is_merged({across, Vec3(0.5f, 0, 1), Vec3(-1, 0, 0.4f)}));  // above the one, below the other
}

// A meter beside a wall that stands askew: what it catches lies before the wall and before its mirror image, and takes
// up the area that is stated for each ring.
// Discs across the light end before the nearest surface, but for one beneath the meter: that hides its part of each.
TEST(Merging, DiscsAcrossTheLightFillABallThatMeetsNothing) {
  test::RoomBuilder builder;
  builder.add(test::quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}), test::RoomBuilder::material(UPS_MATERIAL_MATTE));
  builder.add(test::quad({0.3, -3, -1}, {0, 6, 0}, {0, 0, 4}), test::RoomBuilder::material(UPS_MATERIAL_MATTE));
  const test::Room room = builder.build();
  MeterDiscs discs = MeterDiscs::across(2, 8, 0.4f, 256);
  const float height = 0.01f;
  for (uint32_t m = 0; m < 2; ++m) {
    Meter meter;
    meter.p = Vec3(Vec3d(0, 0, m == 0 ? 0.2 : double(height)) - room.scene->origin);
    discs.look_all_around(*room.scene, meter, m, 0.4f);
    const double free = m == 0 ? 0.2 : 0.3;  // the floor; the wall
    EXPECT_LE(discs.radius(m), free);
    EXPECT_GE(discs.radius(m), 0.85 * free);
  }
  // The lower meter: a ring's points above the floor, over the share that is told, are the whole ring.
  const Vec3 n(0, 0, 1);
  for (const float tilt : {0.0f, 0.2f, 0.8f, 1.5f}) {
    const Vec3 d(std::sin(tilt), 0, -std::cos(tilt)), across(std::cos(tilt), 0, std::sin(tilt)), side(0, 1, 0);
    for (const float r : {0.005f, 0.02f, 0.2f}) {
      constexpr int points = 10000;
      double sum = 0;
      for (int i = 0; i < points; ++i) {
        const float phi = 2 * pi * (float(i) + 0.5f) / points;
        const Vec3 offset = across * (r * std::cos(phi)) + side * (r * std::sin(phi));
        float share = 1;
        const uint32_t ring = discs.ring_across(1, n, d, offset, share);
        EXPECT_EQ(ring == none, offset.z < -height) << tilt << ' ' << r;
        if (ring != none) sum += 1 / double(share) / points;
      }
      EXPECT_NEAR(sum, 1, 2e-3) << tilt << ' ' << r;
    }
  }
}

TEST(Merging, ADiscCatchesWhatItsMeterSees) {
  const double turn = 0.5, distance = 0.1;
  const test::P3 n{std::cos(turn), std::sin(turn), 0}, along{-n.y, n.x, 0};
  test::RoomBuilder builder;
  builder.add(test::quad(n * distance - along * 3 - test::P3{0, 0, 1}, along * 6, {0, 0, 2}),
              test::RoomBuilder::material(UPS_MATERIAL_MATTE));
  const test::Room room = builder.build();
  Meter meter;
  meter.p = Vec3(Vec3d() - room.scene->origin);
  constexpr uint32_t rings_count = 8;
  MeterDiscs discs(1, rings_count, 0.4f, 256);
  discs.look_around(*room.scene, meter, 0, 0.4f);
  const Rings rings = discs.rings(0, 0);
  constexpr int side = 1000;
  const double cell = 0.8 / side;
  double caught[rings_count] = {}, all = 0;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j) {
      const double x = (i + 0.5) * cell - 0.4, y = (j + 0.5) * cell - 0.4;
      const uint32_t ring = discs.ring_at(0, float(x), float(y));
      if (ring == none) continue;
      ASSERT_LE(std::abs(x * n.x + y * n.y), distance);
      caught[ring] += cell * cell, all += cell * cell;
    }
  EXPECT_NEAR(all / discs.area(0), 1, 0.01);
  for (uint32_t k = 2; k < rings_count; ++k)
    EXPECT_NEAR(rings.area[k], caught[k], 0.03 * caught[k] + 2e-4) << k;
  EXPECT_GT(all, 0.6 * 4 * distance * 0.35);  // of what lies between wall and image
}

}  // namespace
}  // namespace ups
