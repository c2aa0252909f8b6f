// Renders that want more memory than they are allowed: refused, or ended with a status; never beyond the limit.
#include <gtest/gtest.h>

#include <string>

#include "failing_memory.h"
#include "rooms.h"
#include "ups/ups_replay.h"

using namespace ups::test;

namespace {

constexpr double slack = 2e6;  // allocations that no estimate counts: texts, a thread's own, tables of the process

struct Limited {
  ups_status status;
  std::string message;
  long peak;
};

class MemoryLimit : public testing::TestWithParam<int> {
 protected:
  MemoryLimit() : first_(1), scene(GetParam()) {
    add_box(first_);
    check(ups_scene_commit(first_.get()), "ups_scene_commit");  // what the process makes once
    before_ = bytes_allocated();
  }
  void commit() { ASSERT_EQ(ups_scene_commit(scene.get()), UPS_OK) << ups_last_error(); }
  ups_memory_estimate estimate(const ups_render_desc& d) {
    ups_memory_estimate e{};
    e.struct_size = sizeof e;
    EXPECT_EQ(ups_scene_estimate_memory(scene.get(), &d, &e), UPS_OK) << ups_last_error();
    return e;
  }
  Limited render(ups_render_desc d, double limit) {
    d.memory_limit_bytes = uint64_t(limit);
    begin_peak();
    ups_result* result = nullptr;
    Limited out;
    out.status = ups_render(scene.get(), &d, &result);
    out.message = out.status == UPS_OK ? "" : ups_last_error();
    out.peak = peak_allocated() - before_;
    EXPECT_EQ(result != nullptr, out.status == UPS_OK);
    ups_result_destroy(result);
    return out;
  }
  static ups_render_desc desc(ups_method method, uint32_t iterations) {
    auto d = make_desc<ups_render_desc>(ups_render_desc_init);
    d.method = method;
    d.iteration_count = iterations;
    return d;
  }
  void expect_refused(const ups_render_desc& d, double share, const std::string& fewer) {
    const ups_memory_estimate e = estimate(d);
    const Limited r = render(d, share * double(e.peak_bytes));
    EXPECT_EQ(r.status, UPS_ERROR_OUT_OF_MEMORY);
    for (const std::string& part : {std::string("want about"), std::string("memory_limit_bytes allows"), fewer})
      EXPECT_NE(r.message.find(part), std::string::npos) << r.message;
    EXPECT_LE(r.peak, share * double(e.peak_bytes) + slack);
    const Limited whole = render(d, 1.3 * double(e.peak_bytes) + slack);
    EXPECT_EQ(whole.status, UPS_OK) << whole.message;
    EXPECT_LE(whole.peak, 1.3 * double(e.peak_bytes) + slack);
  }

 private:
  Scene first_;

 protected:
  long before_;
  Scene scene;
};

// What could not be rendered in any case is told without being prepared, which takes some of it already.
TEST_P(MemoryLimit, IsNotPassedByItsOwnEstimate) {
  add_box(scene);
  scene.add_camera({0.5, 0.5, 0.5}, {0, 1, 0}, 16384, 16384, 1);
  commit();
  auto d = desc(UPS_METHOD_UPS, 16);
  d.memory_limit_bytes = 100'000'000;
  begin_peak();
  const ups_memory_estimate e = estimate(d);
  EXPECT_LT(peak_allocated() - before_, 10'000'000);
  EXPECT_GT(e.peak_bytes, uint64_t(16384) * 16384 * 50);
  EXPECT_EQ(e.allowed_bytes, d.memory_limit_bytes);
}

TEST_P(MemoryLimit, TooManyPixels) {
  add_box(scene);
  scene.add_camera({0.3, 0.3, 2}, {1, 1, -0.7}, 1280, 720, 1);
  commit();
  expect_refused(desc(UPS_METHOD_PATH_TRACING, 2), 0.5, "fewer pixels (");
  expect_refused(desc(UPS_METHOD_AUTO, 2), 0.5, "fewer pixels (");
}

TEST_P(MemoryLimit, TooManyMeters) {
  add_box(scene);
  scene.add_meters(grid(100, 100, 0.5, 0.5, 0.03, 0.75), {0, 0, 1});
  commit();
  expect_refused(desc(UPS_METHOD_UPS, 2), 0.5, "fewer meters (");
}

TEST_P(MemoryLimit, TooManyLightPaths) {
  add_box(scene);
  scene.add_meters(grid(4, 4, 0.5, 0.5, 0.4, 0.75), {0, 0, 1});
  commit();
  auto d = desc(UPS_METHOD_UPS, 1);
  d.light_paths_per_iteration = 1 << 17;
  d.merge_radius_m = 0.1f;
  expect_refused(d, 0.5, "fewer light_paths_per_iteration (");
  d.merge_radius_m = 0;  // a pilot of as many paths finds a radius
  const ups_memory_estimate e = estimate(d);
  const Limited r = render(d, 0.5 * double(e.peak_bytes));
  EXPECT_EQ(r.status, UPS_ERROR_OUT_OF_MEMORY);
  EXPECT_NE(r.message.find("light_paths_per_iteration"), std::string::npos) << r.message;
  EXPECT_LE(r.peak, 0.5 * double(e.peak_bytes) + slack);
}

// Pilots keep the caller's limit too, of an estimate and of a path that is traced again.
TEST_P(MemoryLimit, OfEstimatesAndReplays) {
  add_box(scene);
  const Sensor meters = scene.add_meters(grid(4, 4, 0.5, 0.5, 0.4, 0.75), {0, 0, 1});
  commit();
  auto d = desc(UPS_METHOD_UPS, 1);
  d.light_paths_per_iteration = 1 << 17;
  const double whole = double(estimate(d).peak_bytes), limit = 0.3 * whole;
  d.memory_limit_bytes = uint64_t(limit);
  begin_peak();
  const ups_memory_estimate e = estimate(d);
  EXPECT_LE(double(peak_allocated() - before_), limit + slack);
  EXPECT_EQ(e.allowed_bytes, d.memory_limit_bytes);
  EXPECT_GT(e.peak_bytes, e.allowed_bytes) << "what cannot be rendered is told so";

  ups_sample sample{};
  sample.sensor = meters.id;
  sample.walk = UPS_WALK_EYE;
  const auto replay = [&] {
    ups_path* path = nullptr;
    const ups_status status = ups_replay(scene.get(), &d, &sample, &path);
    EXPECT_EQ(path != nullptr, status == UPS_OK);
    ups_path_destroy(path);
    return status;
  };
  for (const float radius : {0.1f, 0.0f}) {  // the iteration's light paths are too many, or those of a pilot
    d.merge_radius_m = radius;
    begin_peak();
    EXPECT_EQ(replay(), UPS_ERROR_OUT_OF_MEMORY);
    EXPECT_NE(std::string(ups_last_error()).find("memory_limit_bytes"), std::string::npos) << ups_last_error();
    EXPECT_LE(double(peak_allocated() - before_), limit + slack);
  }
  d.memory_limit_bytes = 1000;
  EXPECT_EQ(replay(), UPS_ERROR_OUT_OF_MEMORY) << "the scene takes more";
  d.memory_limit_bytes = uint64_t(1.3 * whole + slack);
  EXPECT_EQ(replay(), UPS_OK) << ups_last_error();
}

// A light path in some 60 000 starts within a closed white box, where it crosses the discs of a thousand meters in one
// place again and again: no probe sees it, and few iterations have one.
TEST_P(MemoryLimit, ReachedOnTheWay) {
  scene.add(quad({-2, -2, 0}, {4, 0, 0}, {0, 4, 0}), matte(0));
  scene.add(box({9, 9, 0}, {10, 10, 1}).flipped(), matte(0.9999));
  scene.add_point_light({0, 0, 2}, 6e4);
  scene.add_point_light({9.5, 9.5, 0.8}, 1);
  scene.add_meters(std::vector<P3>(1000, {9.5, 9.5, 0.5}), {0, 0, 1});
  commit();
  auto d = desc(UPS_METHOD_PPM, 200);  // no eye paths, which would be reflected there for as long
  d.merge_radius_m = 0.45f;
  const ups_memory_estimate e = estimate(d);
  d.memory_limit_bytes = e.peak_bytes + 500000;
  begin_peak();
  ups_job* job = nullptr;
  ASSERT_EQ(ups_job_start(scene.get(), &d, &job), UPS_OK) << ups_last_error();
  ups_status status;
  do status = ups_job_wait(job, 1000);
  while (status == UPS_TIMEOUT);
  EXPECT_EQ(status, UPS_ERROR_OUT_OF_MEMORY);
  const std::string message = ups_last_error();
  for (const char* part : {"the light paths of an iteration want", "memory_limit_bytes", "max_path_length"})
    EXPECT_NE(message.find(part), std::string::npos) << message;
  EXPECT_LE(peak_allocated() - before_, double(d.memory_limit_bytes) + slack);
  ups_progress progress{};
  progress.struct_size = sizeof progress;
  ASSERT_EQ(ups_job_poll(job, &progress), UPS_OK);
  EXPECT_EQ(progress.state, UPS_JOB_FAILED);
  ASSERT_GT(progress.iterations_done, 0u);
  ups_result* result = nullptr;  // of the iterations before
  ASSERT_EQ(ups_job_result(job, &result), UPS_OK) << ups_last_error();
  ups_result_info info{};
  info.struct_size = sizeof info;
  EXPECT_EQ(ups_result_get_info(result, &info), UPS_OK);
  EXPECT_EQ(info.iterations, progress.iterations_done);
  ups_result_destroy(result);
  ups_job_destroy(job);
}

// Room for what it needs, and none for a result beside it.
TEST_P(MemoryLimit, ResultWhileItRenders) {
  add_box(scene);
  scene.add_camera({0.3, 0.3, 2}, {1, 1, -0.7}, 640, 480, 1);
  commit();
  auto d = desc(UPS_METHOD_UPS, 0);
  d.time_limit_s = 60;
  const ups_memory_estimate e = estimate(d);
  for (const bool enough : {false, true}) {
    d.memory_limit_bytes = uint64_t((enough ? 3.0 : 1.05) * double(e.peak_bytes));
    ups_job* job = nullptr;
    ASSERT_EQ(ups_job_start(scene.get(), &d, &job), UPS_OK) << ups_last_error();
    ups_progress progress{};
    progress.struct_size = sizeof progress;
    do ASSERT_EQ(ups_job_poll(job, &progress), UPS_OK);
    while (progress.state == UPS_JOB_RUNNING && progress.iterations_done == 0);
    ups_result* result = nullptr;
    const ups_status status = ups_job_result(job, &result);
    EXPECT_EQ(status, enough ? UPS_OK : UPS_ERROR_OUT_OF_MEMORY);
    if (!enough) {
      EXPECT_NE(std::string(ups_last_error()).find("no room for a result"), std::string::npos) << ups_last_error();
    }
    ups_result_destroy(result);
    result = nullptr;
    ups_job_cancel(job);
    EXPECT_EQ(ups_job_wait(job, 60000), UPS_CANCELLED);
    EXPECT_EQ(ups_job_result(job, &result), UPS_OK) << ups_last_error();
    ups_result_destroy(result);
    ups_job_destroy(job);
  }
}

INSTANTIATE_TEST_SUITE_P(Threads, MemoryLimit, testing::Values(1, 2),
                         [](const auto& threads) { return std::to_string(threads.param); });

}  // namespace
