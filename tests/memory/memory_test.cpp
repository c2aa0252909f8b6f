// Exhausted memory: every allocation of a call fails once, and all from one on. Each time the call must answer with a
// status; nothing of it may be left behind, and the same call must work once there is memory. A hang is ended by
// ctest's time limit. The environment variable UPS_MEMORY_SWEEP=all tries every allocation, in minutes; without it they
// are sampled.
#include "sweep.h"
#include "ups/ups_replay.h"
#ifdef UPS_HAS_EXR
#include "ups/ups_exr.h"
#endif
#ifdef UPS_HAS_GLTF
#include "ups/ups_gltf.h"
#endif
#ifdef UPS_HAS_OCIO
#include "ups/ups_ocio.h"
#include "ups/ups_report.h"
#endif

using namespace ups::test;

namespace {

std::vector<float> readings(ups_result* result, const Sensor& set) {
  std::vector<ups_meter_reading> meters(set.count);
  EXPECT_EQ(ups_result_read_meters(result, set.id, meters.data(), meters.size()), UPS_OK) << ups_last_error();
  std::vector<float> out;
  for (const ups_meter_reading& m : meters) out.push_back(m.illuminance_lx);
  return out;
}

// All that a program asks of a result that tells sources apart and foretells its error; the first status that is not OK.
ups_status read_all(ups_result* result, const Room& room) {
  ups_status worst = UPS_OK;
  const auto keep = [&](ups_status status) { worst = worst == UPS_OK ? status : worst; };
  auto prediction = make_desc<ups_prediction>([](ups_prediction* p, uint32_t size) { p->struct_size = size; });
  keep(ups_result_get_prediction(result, 0.01, &prediction));
  uint32_t sources = 0, points = 0;
  keep(ups_result_get_source_count(result, &sources));
  ups_meter_reading meters[40];  // no vector: memory may be failing
  for (uint32_t s = 0; s < sources; ++s)
    keep(ups_result_read_source_meters(result, s, room.meters.id, meters, room.meters.count));
  keep(ups_result_get_curve_count(result, &points));
  float pixels[3 * 16 * 12];
  for (const ups_channel channel : {UPS_CHANNEL_LUMINANCE_RGB, UPS_CHANNEL_ROBUST_RGB, UPS_CHANNEL_STANDARD_ERROR_RGB})
    keep(ups_result_read_image(result, room.camera.id, channel, pixels, 0, sizeof pixels));
  size_t needed = 0;
  for (const ups_result_text topic : {UPS_TEXT_WARNINGS, UPS_TEXT_EFFECTS, UPS_TEXT_TECHNIQUES, UPS_TEXT_DROPPED})
    keep(ups_result_get_text(result, topic, nullptr, 0, &needed));
  EXPECT_TRUE(worst != UPS_OK || (sources > 0 && points > 0));
  return worst;
}

class Memory : public testing::TestWithParam<int> {};

TEST_P(Memory, Commit) {
  begin_watch();
  Room room(GetParam());
  // Each after an edit, as nothing is built where nothing has changed.
  double factor = 1;
  const Call commit = [&] {
    factor = factor < 1 ? 1 : 0.9;
    const ups_status status = ups_scene_set_maintenance_factor(room.scene.get(), factor);
    return status == UPS_OK ? ups_scene_commit(room.scene.get()) : status;
  };
  expect_nothing_lost(commit, 200, 100);
}

void sweep_renders(Room room, const ups_render_desc& desc, long samples) {
  ASSERT_EQ(ups_scene_commit(room.scene.get()), UPS_OK) << ups_last_error();
  std::vector<float> found;
  bool wanted = true;  // of an unhindered render alone: the test's own memory fails, too
  const Call render = [&] {
    ups_result* result = nullptr;
    ups_status status = ups_render(room.scene.get(), &desc, &result);
    EXPECT_EQ(result != nullptr, status == UPS_OK);
    if (result && desc.separation) status = read_all(result, room);
    if (status == UPS_OK && wanted) found = readings(result, room.meters);
    ups_result_destroy(result);
    return status;
  };
  ASSERT_EQ(render(), UPS_OK) << ups_last_error();
  wanted = false;
  const std::vector<float> right = found;
  const long calls = count_calls(render), before = allocations_held(), bytes = bytes_allocated();
  EXPECT_GT(calls, 100);
  std::printf("%ld allocations\n", calls);
  int cases = 0;
  for (const long count : {1L, all_after})
    for (long k = 1; try_failing(render, k, count); k += stride(calls, samples)) {
      ASSERT_EQ(allocations_held(), before) << "after the failure of allocation " << k;
      if (++cases % 10) continue;
      wanted = true;
      ASSERT_EQ(render(), UPS_OK) << "after the failure of allocation " << k << ": " << ups_last_error();
      ASSERT_EQ(found, right) << "after the failure of allocation " << k;
      wanted = false;
    }
  expect_as_much(bytes);
}

Room watched_room(int threads, int meter_count = 40) {
  begin_watch();
  return Room(threads, meter_count);
}

TEST_P(Memory, Render) { sweep_renders(watched_room(GetParam()), short_render(0.1f), 60); }
TEST_P(Memory, RenderThatFindsItsRadius) { sweep_renders(watched_room(GetParam()), short_render(0), 5); }
// By the method and the techniques that are chosen, with an observer besides; of a fixture by a goniometer.
TEST_P(Memory, RenderAsIsChosen) {
  Room room = watched_room(GetParam(), 5);
  room.scene.add_observer({0.5, 3.5, 1.2}, {1, -1, 0});
  auto d = short_render(0);
  d.method = UPS_METHOD_AUTO;
  sweep_renders(std::move(room), d, 4);
}
TEST_P(Memory, RenderOfAGoniometer) {
  begin_watch();
  Scene scene(GetParam());
  scene.add(box({-0.2, -0.2, 0}, {0.2, 0.2, 0.3}), matte(0.5));
  scene.add_point_light({0, 0, -0.1}, 100);
  scene.add_goniometer(8, 19);
  ASSERT_EQ(ups_scene_commit(scene.get()), UPS_OK) << ups_last_error();
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  d.iteration_count = 2;
  d.light_paths_per_iteration = 256;
  const Call render = [&] {
    ups_result* result = nullptr;
    const ups_status status = ups_render(scene.get(), &d, &result);
    ups_result_destroy(result);
    return status;
  };
  expect_nothing_lost(render, 40);
}
TEST_P(Memory, Replay) {
  Room room = watched_room(GetParam(), 5);
  ASSERT_EQ(ups_scene_commit(room.scene.get()), UPS_OK) << ups_last_error();
  const auto d = short_render(0.1f);
  ups_result* result = nullptr;
  ASSERT_EQ(ups_render(room.scene.get(), &d, &result), UPS_OK) << ups_last_error();
  ups_sample samples[64];
  size_t count = 0;
  ASSERT_EQ(ups_result_read_largest_samples(result, room.camera.id, samples, 64, &count), UPS_OK) << ups_last_error();
  ASSERT_GT(count, 0u);
  ups_result_destroy(result);
  const Call replay = [&] {
    ups_path* path = nullptr;
    ups_status status = ups_replay(room.scene.get(), &d, samples, &path);
    size_t needed = 0;
    if (status == UPS_OK) status = ups_path_get_text(path, nullptr, 0, &needed);
    ups_path_destroy(path);
    return status;
  };
  expect_nothing_lost(replay, 60);
}
// With looks at the error, and predictions from them; within a limit of memory, which counts what light paths take.
TEST_P(Memory, RenderOfSourcesThatForetells) {
  auto d = short_render(0.1f);
  d.iteration_count = 16;
  d.max_path_length = 2;
  d.light_paths_per_iteration = 64;
  d.separation = UPS_SEPARATE_LUMINAIRES;
  d.memory_limit_bytes = 100000000;
  sweep_renders(watched_room(GetParam(), 5), d, 20);
}
// Whatever has no memory, what was rendered before can be read, also where the job failed: a look at the error that
// finds none is left out. Of meters alone, whose sums are all made before the first iteration.
TEST_P(Memory, WhatWasRenderedCanBeRead) {
  begin_watch();
  Scene scene(GetParam());
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
  scene.add_point_light({2, 2, 2.5}, 1000);
  scene.add_meters({{1, 1, 0.75}, {2, 3, 0.75}}, {0, 0, 1});
  ASSERT_EQ(ups_scene_commit(scene.get()), UPS_OK) << ups_last_error();
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  d.method = UPS_METHOD_PATH_TRACING;
  d.iteration_count = 32;
  d.max_path_length = 2;
  ups_job* job = nullptr;
  const Call run = [&] {
    const ups_status status = ups_job_start(scene.get(), &d, &job);
    return status == UPS_OK ? ups_job_wait(job, 60000) : status;
  };
  const long calls = count_calls(run);
  ups_job_destroy(job);
  bool is_failing = true;
  int readable = 0;
  for (long k = 1; is_failing; k += stride(calls, 200)) {
    job = nullptr;
    is_failing = try_failing(run, k, 1);
    if (!job) continue;
    ups_progress progress{};
    progress.struct_size = sizeof progress;
    ASSERT_EQ(ups_job_poll(job, &progress), UPS_OK);
    if (progress.iterations_done > 0) {
      ups_result* result = nullptr;
      EXPECT_EQ(ups_job_result(job, &result), UPS_OK) << "allocation " << k << ": " << ups_last_error();
      if (result) {
        ups_result_info info{};
        info.struct_size = sizeof info;
        EXPECT_EQ(ups_result_get_info(result, &info), UPS_OK);
        EXPECT_EQ(info.iterations, progress.iterations_done);
      }
      ups_result_destroy(result);
      ++readable;
    }
    ups_job_destroy(job);
  }
  EXPECT_GT(readable, 10) << "or the test shows nothing";
}

TEST_P(Memory, Estimate) {
  begin_watch();
  Room room(GetParam());
  ASSERT_EQ(ups_scene_commit(room.scene.get()), UPS_OK) << ups_last_error();
  const ups_render_desc desc = short_render(0.1f);
  const Call estimate = [&] {
    auto e = make_desc<ups_memory_estimate>([](ups_memory_estimate* out, uint32_t size) { out->struct_size = size; });
    return ups_scene_estimate_memory(room.scene.get(), &desc, &e);
  };
  expect_nothing_lost(estimate, 60);
}

TEST_P(Memory, JobThatIsCancelled) {
  begin_watch();
  Room room(GetParam());
  ASSERT_EQ(ups_scene_commit(room.scene.get()), UPS_OK) << ups_last_error();
  auto desc = short_render(0.1f);
  desc.iteration_count = 1000;
  const Call cancelled = [&] {
    ups_job* job = nullptr;
    ups_status status = ups_job_start(room.scene.get(), &desc, &job);
    if (status != UPS_OK) return status;
    auto progress = make_desc<ups_progress>([](ups_progress* p, uint32_t size) { p->struct_size = size; });
    do {
      status = ups_job_poll(job, &progress);
    } while (status == UPS_OK && progress.state == UPS_JOB_RUNNING && progress.iterations_done == 0);
    ups_job_cancel(job);
    status = ups_job_wait(job, 60000);
    ups_job_destroy(job);
    return status == UPS_CANCELLED ? UPS_OK : status;
  };
  expect_nothing_lost(cancelled, 10);  // how many allocations there are is up to the moment
}

TEST_P(Memory, Context) {
  begin_watch();
  const Call create = [&] {
    auto d = make_desc<ups_context_desc>(ups_context_desc_init);
    d.thread_count = GetParam();
    ups_context* context = nullptr;
    const ups_status status = ups_context_create(&d, &context);
    ups_context_destroy(context);
    return status;
  };
  ASSERT_EQ(create(), UPS_OK) << ups_last_error();
  const long before = allocations_held();
  for (const long count : {1L, all_after})
    for (long k = 1; try_failing(create, k, count); ++k) {
      ASSERT_EQ(create(), UPS_OK) << ups_last_error();
      ASSERT_EQ(allocations_held(), before);
    }
}

INSTANTIATE_TEST_SUITE_P(Threads, Memory, testing::Values(1, 2),
                         [](const auto& threads) { return std::to_string(threads.param); });

TEST(MemoryOfMessages, FirstErrorOfAThread) {
  ups_context* context = nullptr;
  ASSERT_EQ(ups_context_create(nullptr, &context), UPS_OK);
  ups_scene* scene = nullptr;
  fail_memory(1, all_after);
  const ups_status status = ups_scene_create(context, &scene);
  const char* message = ups_last_error();
  end_of_failing();
  EXPECT_EQ(status, UPS_ERROR_OUT_OF_MEMORY);
  EXPECT_NE(std::string(message).find("out of memory"), std::string::npos) << message;
  EXPECT_EQ(ups_scene_create(context, nullptr), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_STREQ(ups_last_error(), "ups_scene_create: out is NULL");
  fail_memory(1, all_after);
  const ups_status again = ups_scene_create(context, &scene);
  end_of_failing();
  EXPECT_EQ(again, UPS_ERROR_OUT_OF_MEMORY);
  EXPECT_STREQ(ups_last_error(), "ups_scene_create: out of memory");
  ups_context_destroy(context);
}

// A call that fails for its arguments, where there is no memory for the message.
void expect_status_without_memory(const Call& call, const char* (*last_error)()) {
  fail_memory(1, all_after);
  const ups_status status = call();
  const char* message = last_error();
  end_of_failing();
  EXPECT_EQ(status, UPS_ERROR_OUT_OF_MEMORY);
  EXPECT_NE(std::string(message).find("out of memory"), std::string::npos) << message;
}

#ifdef UPS_HAS_EXR
TEST(MemoryOfMessages, Exr) {
  expect_status_without_memory([] { return ups_exr_read("no such file", nullptr); }, &ups_exr_last_error);
}
#endif
#ifdef UPS_HAS_GLTF
TEST(MemoryOfMessages, Gltf) {
  expect_status_without_memory([] { return ups_gltf_get_sensor_count(nullptr, nullptr); }, &ups_gltf_last_error);
}
#endif
#ifdef UPS_HAS_OCIO
TEST(MemoryOfMessages, Ocio) {
  expect_status_without_memory([] { return ups_ocio_choose_exposure(nullptr, 1, 1, nullptr); }, &ups_ocio_last_error);
}
#endif

#ifdef UPS_HAS_REPORT
TEST(MemoryOfMessages, Report) {
  expect_status_without_memory([] { return ups_report_write_map("no such map", nullptr); }, &ups_report_last_error);
}
#endif

TEST(MemoryOfThreads, JobAndContext) {
  Room room(2);
  ASSERT_EQ(ups_scene_commit(room.scene.get()), UPS_OK) << ups_last_error();
  auto d = make_desc<ups_context_desc>(ups_context_desc_init);
  d.thread_count = 2;
  const ups_render_desc render = short_render(0.1f);
  ups_context* context = nullptr;
  ups_job* job = nullptr;
  ups_result* result = nullptr;
  const Call calls[] = {[&] { return ups_job_start(room.scene.get(), &render, &job); },
                        [&] { return ups_render(room.scene.get(), &render, &result); },
                        [&] { return ups_context_create(&d, &context); }};
  for (const Call& call : calls) {
    fail_threads(true);
    const ups_status status = call();
    fail_threads(false);
    if (&call == &calls[2] && status == UPS_OK) continue;  // one processor: the context has no threads but its caller's
    EXPECT_EQ(status, UPS_ERROR_OUT_OF_MEMORY);
    EXPECT_NE(std::string(ups_last_error()).find("a thread cannot be started"), std::string::npos) << ups_last_error();
    EXPECT_EQ(call(), UPS_OK) << ups_last_error();
  }
  ups_job_destroy(job);
  ups_result_destroy(result);
  ups_context_destroy(context);
}

}  // namespace
