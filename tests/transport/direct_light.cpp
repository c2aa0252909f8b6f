// Is exact light found once for each meter, whoever asks first?
#include "transport/direct_light.h"

#include <gtest/gtest.h>

#include "../support/snapshot_room.h"

namespace {

using namespace ups;

// Pilots ask before the render's first iteration does. One lamp, two meters.
TEST(DirectLight, IsFoundOnceForAMeter) {
  const std::shared_ptr<const Snapshot> room = test::room(UPS_MATERIAL_MATTE);
  TransportSettings settings{.method = *method_of(UPS_METHOD_UPS)};
  settings.techniques = settings.method.techniques;
  const Plan plan = make_plan(*room, settings);
  DirectLight direct(*room, plan, settings);
  ThreadPool pool(1);
  const StopSignal stop;
  const Iteration in(*room, plan, settings, 0, stop);
  double lx[2];
  for (const bool again : {false, true}) {
    WorkCounts work;
    direct.find(in, pool, work);
    EXPECT_EQ(work.rays == 0, again);
    IterationTally tally;
    tally.meters.emplace_back(2);
    tally.separated.resize(1);
    direct.add(in, tally);
    lx[again] = tally.meters[0][0].value;
  }
  EXPECT_GT(lx[0], 0);
  EXPECT_EQ(lx[0], lx[1]);
}

}  // namespace
