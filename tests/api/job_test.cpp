// Renders as jobs: start, poll, wait, cancel, destroy; the limits and the target that end them.
#include <chrono>
#include <cstring>
#include <thread>

#include "fixture.h"

namespace ups_test {
namespace {

// Tests run beside others on slow machines: limits of time are there to end what hangs, not to measure.
constexpr double patience_s = 60;
constexpr uint32_t patience_ms = 60'000, short_ms = 20;

// A room of two facing squares of 1 m, 1 m apart, under a lamp between them, and two meters on the lower one.
class Jobs : public Api {
 protected:
  Jobs() {
    auto above = make(&ups_instance_desc_init);
    above.mesh = mesh;
    above.to_world[11] = 1;
    auto lamp = make(&ups_light_desc_init);
    lamp.to_world[3] = lamp.to_world[7] = lamp.to_world[11] = 0.5;
    auto d = make(&ups_meter_desc_init);
    d.count = 2, d.positions_m = on_floor, d.normals = up;
    ups_instance_id ceiling{};
    ups_luminaire_id lamp_id{};
    EXPECT_OK(ups_scene_add_instance(scene, &above, &ceiling));
    EXPECT_OK(ups_scene_add_light(scene, &lamp, &lamp_id));
    EXPECT_OK(ups_scene_add_meters(scene, &d, &sensor));
    EXPECT_OK(ups_scene_commit(scene));
  }
  ~Jobs() override { ups_job_destroy(job); }

  static ups_render_desc of_iterations(uint32_t count) {
    auto d = make(&ups_render_desc_init);
    d.iteration_count = count;
    return d;
  }
  // No test waits for its end.
  static ups_render_desc endless() {
    auto d = make(&ups_render_desc_init);
    d.time_limit_s = 100 * patience_s;
    return d;
  }
  void start(const ups_render_desc& desc) { ASSERT_EQ(ups_job_start(scene, &desc, &job), UPS_OK) << ups_last_error(); }
  static ups_progress poll(const ups_job* of) {
    ups_progress p{};
    p.struct_size = sizeof p;
    EXPECT_OK(ups_job_poll(of, &p));
    return p;
  }
  // Waits for the first whole iteration.
  void wait_for_something() {
    for (uint32_t waited = 0; poll(job).iterations_done == 0 && waited < patience_ms; waited += short_ms) {
      ASSERT_EQ(ups_job_wait(job, short_ms), UPS_TIMEOUT);
    }
    ASSERT_GT(poll(job).iterations_done, 0u);
  }
  std::vector<ups_meter_reading> readings_of(const ups_result* result) const {
    std::vector<ups_meter_reading> readings(2);
    EXPECT_OK(ups_result_read_meters(result, sensor, readings.data(), readings.size()));
    return readings;
  }
  std::vector<ups_meter_reading> readings_of(const ups_job* of) const {
    ups_result* result = nullptr;
    EXPECT_OK(ups_job_result(of, &result));
    const auto readings = readings_of(result);
    ups_result_destroy(result);
    return readings;
  }
  static ups_result_info info_of(const ups_result* result) {
    ups_result_info info{};
    info.struct_size = sizeof info;
    EXPECT_OK(ups_result_get_info(result, &info));
    return info;
  }
  ups_meter_statistics statistics_of(const ups_result* result) const {
    ups_meter_statistics statistics{};
    statistics.struct_size = sizeof statistics;
    EXPECT_OK(ups_result_get_meter_statistics(result, sensor, &statistics));
    return statistics;
  }

  double on_floor[6] = {0.25, 0.25, 0, 0.6, 0.7, 0};
  float up[6] = {0, 0, 1, 0, 0, 1};
  ups_sensor_id sensor{};
  ups_job* job = nullptr;
};

TEST_F(Jobs, ProgressGrowsUntilTheEnd) {
  constexpr uint32_t count = 200;
  start(of_iterations(count));
  ups_progress before = poll(job);
  ups_status status = UPS_TIMEOUT;
  for (uint32_t waited = 0; status == UPS_TIMEOUT && waited < patience_ms; ++waited) {
    status = ups_job_wait(job, 1);
    const ups_progress now = poll(job);
    EXPECT_GE(now.iterations_done, before.iterations_done);
    EXPECT_GE(now.elapsed_s, before.elapsed_s);
    EXPECT_GE(now.fraction, before.fraction);
    EXPECT_LE(now.fraction, 1);
    before = now;
  }
  EXPECT_EQ(status, UPS_OK) << ups_last_error();
  const ups_progress end = poll(job);
  EXPECT_EQ(end.state, UPS_JOB_FINISHED);
  EXPECT_EQ(end.iterations_done, count);
  EXPECT_EQ(end.fraction, 1);
  EXPECT_EQ(end.remaining_s, 0);
  EXPECT_GE(end.worst_relative_error, end.median_relative_error);
  EXPECT_OK(ups_job_wait(job, 0)) << "a finished job can be waited for again";
}

// While nothing is delivered, too: within a long iteration or a pilot.
TEST_F(Jobs, ProgressTellsTheTimeBeforeTheFirstIteration) {
  ups_render_desc desc = of_iterations(1);
  desc.method = UPS_METHOD_UPS;
  desc.light_paths_per_iteration = 1u << 24;
  start(desc);
  std::this_thread::sleep_for(std::chrono::milliseconds(200));
  const ups_progress now = poll(job);
  if (now.state == UPS_JOB_RUNNING && now.iterations_done == 0) {
    EXPECT_GE(now.elapsed_s, 0.15);
  }
  ups_job_cancel(job);
  ups_job_wait(job, patience_ms);
  const double end_s = poll(job).elapsed_s;
  EXPECT_GE(end_s, now.elapsed_s);
  std::this_thread::sleep_for(std::chrono::milliseconds(20));
  EXPECT_EQ(poll(job).elapsed_s, end_s) << "a job that is over has its time";
}

// No later iteration is promised.
TEST_F(Jobs, CancelledBeforeItsFirstIterationItHasNoResult) {
  ups_render_desc desc = of_iterations(1);
  desc.method = UPS_METHOD_UPS;
  desc.light_paths_per_iteration = 1u << 24;
  start(desc);
  ups_job_cancel(job);
  ASSERT_EQ(ups_job_wait(job, patience_ms), UPS_CANCELLED);
  if (poll(job).iterations_done > 0) GTEST_SKIP() << "it was quicker";
  ups_result* result = nullptr;
  EXPECT_EQ(ups_job_result(job, &result), UPS_ERROR_INVALID_STATE);
  EXPECT_NE(std::string(ups_last_error()).find("was cancelled before"), std::string::npos) << ups_last_error();
}

TEST_F(Jobs, WaitReturnsAtItsTimeout) {
  start(endless());
  EXPECT_EQ(ups_job_wait(job, 0), UPS_TIMEOUT);
  EXPECT_EQ(ups_job_wait(job, short_ms), UPS_TIMEOUT);
  EXPECT_EQ(poll(job).state, UPS_JOB_RUNNING);
}

TEST_F(Jobs, CancelLeavesWhatIsThere) {
  start(endless());
  wait_for_something();
  ups_job_cancel(job);
  ASSERT_EQ(ups_job_wait(job, patience_ms), UPS_CANCELLED);
  const ups_progress state = poll(job);
  EXPECT_EQ(state.state, UPS_JOB_CANCELLED);
  ups_result* result = nullptr;
  ASSERT_EQ(ups_job_result(job, &result), UPS_OK) << ups_last_error();
  EXPECT_EQ(info_of(result).iterations, state.iterations_done);
  for (const ups_meter_reading& reading : readings_of(result)) EXPECT_GT(reading.illuminance_lx, 0);
  ups_result_destroy(result);
}

TEST_F(Jobs, ResultsCanBeTakenWhileItRuns) {
  start(endless());
  wait_for_something();
  ups_result* result = nullptr;
  ASSERT_EQ(ups_job_result(job, &result), UPS_OK) << ups_last_error();
  const uint32_t iterations = info_of(result).iterations;
  EXPECT_GE(iterations, 1u);
  for (uint32_t waited = 0; poll(job).iterations_done == iterations && waited < patience_ms; ++waited) {
    ASSERT_EQ(ups_job_wait(job, 1), UPS_TIMEOUT);
  }
  EXPECT_GT(poll(job).iterations_done, iterations);
  EXPECT_EQ(info_of(result).iterations, iterations) << "what was taken does not change";
  ups_result_destroy(result);
}

TEST_F(Jobs, DestroyEndsWhatRuns) {
  start(endless());
  ups_job_destroy(job);  // at once, perhaps before the first iteration
  job = nullptr;
  start(endless());
  wait_for_something();
  ups_job_destroy(job);
  job = nullptr;
  ups_job_destroy(nullptr);
  ups_job_cancel(nullptr);
}

TEST_F(Jobs, TwoOnOneScene) {
  const ups_render_desc desc = of_iterations(32);
  start(desc);
  ups_job* other = nullptr;
  ASSERT_EQ(ups_job_start(scene, &desc, &other), UPS_OK) << ups_last_error();
  EXPECT_EQ(ups_job_wait(other, patience_ms), UPS_OK);
  EXPECT_EQ(ups_job_wait(job, patience_ms), UPS_OK);
  ups_result* alone = nullptr;
  EXPECT_OK(ups_render(scene, &desc, &alone));
  const auto expected = readings_of(alone);
  for (const ups_job* each : {job, other}) {
    const auto found = readings_of(each);
    EXPECT_EQ(std::memcmp(found.data(), expected.data(), 2 * sizeof expected[0]), 0) << "same seed, same bits";
  }
  ups_result_destroy(alone);
  ups_job_destroy(other);
}

TEST_F(Jobs, GoOnWithoutTheirScene) {
  start(of_iterations(64));
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  scene = nullptr;
  context = nullptr;
  EXPECT_EQ(ups_job_wait(job, patience_ms), UPS_OK) << ups_last_error();
  for (const ups_meter_reading& reading : readings_of(job)) EXPECT_GT(reading.illuminance_lx, 0);
}

TEST_F(Jobs, EndAtTheirTargetError) {
  constexpr float target = 0.0005f;
  auto desc = make(&ups_render_desc_init);
  desc.target_relative_error = target;
  desc.time_limit_s = patience_s;
  ups_result* result = nullptr;
  ASSERT_EQ(ups_render(scene, &desc, &result), UPS_OK) << ups_last_error();
  const ups_result_info info = info_of(result);
  EXPECT_LT(info.elapsed_s, 0.5 * patience_s) << "the target ends it, not the time";
  EXPECT_GE(info.iterations, 16u);
  EXPECT_GT(statistics_of(result).worst_relative_error_bound, 0);
  EXPECT_LE(statistics_of(result).worst_relative_error_bound, target);
  size_t count = 0;
  EXPECT_OK(ups_result_read_convergence(result, nullptr, 0, &count));
  std::vector<ups_convergence_point> convergence(count);
  EXPECT_OK(ups_result_read_convergence(result, convergence.data(), count, &count));
  ASSERT_GT(count, 0u);
  EXPECT_GT(convergence.front().worst_relative_error, target) << "or the test shows nothing";
  EXPECT_LE(convergence.back().worst_relative_error, target);
  ups_result_destroy(result);
}

TEST_F(Jobs, EndAtTheirTimeLimit) {
  constexpr double limit_s = 2;  // long enough for a first iteration wherever
  auto desc = make(&ups_render_desc_init);
  desc.time_limit_s = limit_s;
  start(desc);
  EXPECT_EQ(ups_job_wait(job, patience_ms), UPS_OK) << ups_last_error();
  const ups_progress state = poll(job);
  EXPECT_EQ(state.state, UPS_JOB_FINISHED);
  EXPECT_GT(state.iterations_done, 0u);
  EXPECT_GT(state.elapsed_s, 0.1 * limit_s);
  EXPECT_LT(state.elapsed_s, 0.5 * patience_s) << "the limit ends it";
}

}  // namespace
}  // namespace ups_test
