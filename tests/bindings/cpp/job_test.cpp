// Jobs of ups.hpp: renders and commits that are watched, waited for and cancelled.
#include <cstring>

#include "room.h"

namespace {

using std::chrono::milliseconds;

TEST(Jobs, HaveTheSameBitsAsARender) {
  Room room;
  room.scene.commit();
  ups::RenderDesc desc = Room::few(32);
  desc.thread_limit = 1;
  const ups::Job job = room.scene.start(desc);
  ups_status status;
  do status = job.wait(milliseconds(20));
  while (status == UPS_TIMEOUT);
  EXPECT_EQ(status, UPS_OK);
  const ups_progress progress = job.poll();
  EXPECT_EQ(progress.state, UPS_JOB_FINISHED);
  EXPECT_EQ(progress.iterations_done, 32u);
  const auto waited = job.result().read_meters(room.meters);
  const auto rendered = room.scene.render(Room::few(32)).read_meters(room.meters);
  EXPECT_EQ(std::memcmp(waited.data(), rendered.data(), waited.size() * sizeof waited[0]), 0);
  EXPECT_FALSE(job.curve().empty());
  EXPECT_EQ(job.get_largest_error().sensor.v, room.meters.v);
  EXPECT_GT(job.get_prediction(0.1).seconds, 0);
  EXPECT_GT(job.get_memory_estimate().peak_bytes, 0u);
}

TEST(Jobs, AreCancelledAndKeepWhatTheyFound) {
  Room room;
  room.scene.commit();
  ups::Job job = room.scene.start(Room::few(1000000000));
  EXPECT_EQ(job.wait(milliseconds(-5)), UPS_TIMEOUT) << "as 0";
  EXPECT_EQ(job.wait(std::chrono::microseconds(1)), UPS_TIMEOUT);
  while (job.poll().iterations_done == 0) EXPECT_EQ(job.wait(milliseconds(1)), UPS_TIMEOUT);
  job.cancel();
  EXPECT_EQ(job.wait(), UPS_CANCELLED);
  EXPECT_EQ(job.poll().state, UPS_JOB_CANCELLED);
  EXPECT_GE(job.result().get_info().iterations, 1u);
  { const ups::Job dropped = room.scene.start(Room::few(1000000000)); }  // its destructor ends it
}

TEST(Jobs, CommitBesideEdits) {
  Room room;
  EXPECT_TRUE(room.scene.is_dirty());
  const ups::Job job = room.scene.start_commit();
  room.scene.set_dimming(room.lamp, 0.25f);
  EXPECT_EQ(job.wait(std::chrono::hours::max()), UPS_OK) << "milliseconds would overflow";
  EXPECT_TRUE(room.scene.is_dirty()) << "the dimming belongs to the next commit";
  expect_error(UPS_ERROR_INVALID_STATE, {}, [&] { job.result(); });
  const float before = room.scene.render(Room::few()).read_meters(room.meters)[0].illuminance_lx;
  room.scene.commit();
  EXPECT_FALSE(room.scene.is_dirty());
  const float after = room.scene.render(Room::few()).read_meters(room.meters)[0].illuminance_lx;
  EXPECT_NEAR(after / before, 0.25, 1e-3);
}

TEST(Jobs, CommitOnFewerThreads) {
  Room room;
  ups::CommitDesc desc;
  desc.thread_limit = 1;
  desc.priority = UPS_PRIORITY_LOW;
  EXPECT_EQ(room.scene.start_commit(desc).wait(), UPS_OK);
  EXPECT_FALSE(room.scene.is_dirty());
  desc.priority = 2;
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"priority"}, [&] { room.scene.start_commit(desc); });
}

}  // namespace
