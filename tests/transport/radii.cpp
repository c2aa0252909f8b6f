// Where merging starts: pixels' discs follow what pixels see, those of walks how dense light is.
#include "transport/radii.h"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/snapshot_room.h"

namespace {

using namespace ups;

// share: as choose_radii() is told.
Plan radii_of(const Snapshot& room, double share) {
  TransportSettings settings{.method = *method_of(UPS_METHOD_UPS)};
  settings.techniques = settings.method.techniques;
  settings.light_paths = 16;
  Plan plan = make_plan(room, settings);
  ThreadPool pool(2);
  choose_radii(room, settings, pool, StopSignal(), share, plan);
  return plan;
}

// 4 x 4 pixels of a field of 1 rad, from 2.5 m over a floor: squares of 0.68 m, of whose area a disc has 2.25 times.
TEST(Radii, APixelsIsOneAndAHalfTimesThatOfItsFootprint) {
  const std::shared_ptr<const Snapshot> room = test::room(UPS_MATERIAL_MATTE);
  const Plan plan = radii_of(*room, 1);
  const double side = 2 * 2.5 * std::tan(0.5) / 4;
  ASSERT_EQ(plan.pixel_radius.at(0).size(), 16u);
  for (const size_t pixel : {5u, 6u, 9u, 10u})
    EXPECT_NEAR(double(plan.pixel_radius[0][pixel]), 1.5 * side / std::sqrt(pi_d), 1e-3) << pixel;
}

// Of a quarter of a render's light paths, whose photons are twice as far apart.
TEST(Radii, ThatOfWalksIsOfAllLightPaths) {
  const std::shared_ptr<const Snapshot> room = test::room(UPS_MATERIAL_MATTE);
  const float all = radii_of(*room, 1).walk_radius, quarter = radii_of(*room, 0.25).walk_radius;
  EXPECT_GT(all, 0);
  EXPECT_FLOAT_EQ(quarter, all / 2);
}

}  // namespace
