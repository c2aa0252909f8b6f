// Exhausted memory: every allocation of a call fails once, and all from one on. Each time the call must answer with a
// status; nothing of it may be left behind, and the same call must work once there is memory. A hang is ended by
// ctest's time limit. UPS_MEMORY_SWEEP=all tries every allocation (tests/long.sh memory); without it they are sampled.
#include <gtest/gtest.h>

#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "failing_memory.h"
#include "support/scene_builder.h"
#ifdef UPS_HAS_EXR
#include "ups/ups_exr.h"
#endif
#ifdef UPS_HAS_GLTF
#include "ups/ups_gltf.h"
#endif
#ifdef UPS_HAS_OCIO
#include "ups/ups_ocio.h"
#endif

using namespace ups::test;

namespace {

constexpr long all_after = 1000000000;

// A room with a mirror, so that photons are merged, a shared mesh, a luminaire with an opening, a camera, and meters
// enough for their index to be Embree's.
struct Room {
  Scene scene;
  Sensor meters;
  explicit Room(int threads) : scene(threads) {
    scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
    scene.add(box({1, 1, 0}, {2, 2, 0.5}), mirror(0.9));
    scene.add(box({2.5, 2.5, 0}, {3, 3, 1}), rough(UPS_MATERIAL_METAL, 0.8, 0.3));
    add_luminaire();
    std::vector<P3> places;
    for (int i = 0; i < 40; ++i) places.push_back({0.5 + 0.07 * i, 3, 0.75});
    meters = scene.add_meters(places, {0, 0, 1});
    scene.add_camera({0.3, 0.3, 2}, {1, 1, -0.7}, 16, 12, 1);
  }

 private:
  void add_luminaire() {
    const float gamma[3] = {0, 45, 90}, c = 0, intensity[3] = {1000, 700, 0};
    auto d = make_desc<ups_profile_desc>(ups_profile_desc_init);
    d.c_count = 1;
    d.gamma_count = 3;
    d.c_deg = &c;
    d.gamma_deg = gamma;
    d.intensity_cd = intensity;
    d.opening_shape = UPS_OPENING_RECTANGLE;
    d.opening_m[0] = d.opening_m[1] = 0.3f;
    ups_profile* profile = nullptr;
    ASSERT_EQ(ups_profile_create(scene.context(), &d, &profile), UPS_OK);
    scene.add_luminaire(profile, {2, 2, 2.9}, {0, 0, -1}, true);
    ups_profile_destroy(profile);
  }
};

// Without a radius of merging a pilot pass of many light paths finds one first.
ups_render_desc short_render(float merge_radius_m) {
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  d.method = UPS_METHOD_UPS;
  d.iteration_count = 1;
  d.max_path_length = 3;
  d.light_paths_per_iteration = 256;
  d.merge_radius_m = merge_radius_m;
  return d;
}

std::vector<float> readings(ups_result* result, ups_sensor_id sensor) {
  std::vector<ups_meter_reading> meters(40);
  EXPECT_EQ(ups_result_read_meters(result, sensor, meters.data(), meters.size()), UPS_OK) << ups_last_error();
  std::vector<float> out;
  for (const ups_meter_reading& m : meters) out.push_back(m.illuminance_lx);
  return out;
}

using Call = std::function<ups_status()>;

// Runs `call` with failing memory, then without; what both leave behind is `held` allocations. False where it makes
// fewer calls than `first`.
bool try_failing(const Call& call, long first, long count) {
  fail_memory(first, count);
  const ups_status status = call();
  const long calls = end_of_failing();
  const std::string message = ups_last_error();
  if (calls < first) {
    EXPECT_EQ(status, UPS_OK);
    return false;
  }
  // The library can do without some, such as a helper's thread that oneTBB cannot take in.
  EXPECT_TRUE(status == UPS_OK || status == UPS_ERROR_OUT_OF_MEMORY)
      << "allocation " << first << (count > 1 ? " and all later" : "") << ": " << ups_status_name(status) << " "
      << message;
  if (status == UPS_ERROR_OUT_OF_MEMORY) {
    EXPECT_NE(message.find("memory"), std::string::npos) << message;
  }
  return true;
}

// All allocations, or about `samples` of them.
long stride(long allocations, long samples) {
  const char* sweep = std::getenv("UPS_MEMORY_SWEEP");
  return sweep && std::strcmp(sweep, "all") == 0 ? 1 : std::max(1L, allocations / samples);
}

long count_calls(const Call& call) {
  fail_memory(all_after, 1);
  EXPECT_EQ(call(), UPS_OK) << ups_last_error();
  return end_of_failing();
}

class Memory : public testing::TestWithParam<int> {};

TEST_P(Memory, Commit) {
  watch_library();
  Room room(GetParam());
  const Call commit = [&] { return ups_scene_commit(room.scene.get()); };
  ASSERT_EQ(commit(), UPS_OK) << ups_last_error();  // tables that the process makes once
  const long calls = count_calls(commit), before = allocations_held();
  EXPECT_GT(calls, 100);
  for (const long count : {1L, all_after})
    for (long k = 1; try_failing(commit, k, count); k += stride(calls, 200)) {
      ASSERT_EQ(commit(), UPS_OK) << "after the failure of allocation " << k << ": " << ups_last_error();
      ASSERT_EQ(allocations_held(), before) << "after the failure of allocation " << k;
    }
}

void sweep_renders(int threads, float merge_radius_m, long samples) {
  watch_library();
  Room room(threads);
  ASSERT_EQ(ups_scene_commit(room.scene.get()), UPS_OK) << ups_last_error();
  const ups_render_desc desc = short_render(merge_radius_m);
  std::vector<float> found;
  const Call render = [&] {
    ups_result* result = nullptr;
    const ups_status status = ups_render(room.scene.get(), &desc, &result);
    EXPECT_EQ(result != nullptr, status == UPS_OK);
    if (result && found.empty()) found = readings(result, room.meters.id);  // of an unhindered render: the first
    ups_result_destroy(result);
    return status;
  };
  ASSERT_EQ(render(), UPS_OK) << ups_last_error();
  const std::vector<float> right = found;
  const long calls = count_calls(render), before = allocations_held();
  EXPECT_GT(calls, 100);
  int cases = 0;
  for (const long count : {1L, all_after})
    for (long k = 1; try_failing(render, k, count); k += stride(calls, samples)) {
      ASSERT_EQ(allocations_held(), before) << "after the failure of allocation " << k;
      if (++cases % 10) continue;
      found.clear();
      ASSERT_EQ(render(), UPS_OK) << "after the failure of allocation " << k << ": " << ups_last_error();
      ASSERT_EQ(found, right) << "after the failure of allocation " << k;
    }
}

TEST_P(Memory, Render) { sweep_renders(GetParam(), 0.1f, 60); }
TEST_P(Memory, RenderThatFindsItsRadius) { sweep_renders(GetParam(), 0, 5); }

TEST_P(Memory, JobThatIsCancelled) {
  watch_library();
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
  ASSERT_EQ(cancelled(), UPS_OK) << ups_last_error();
  const long calls = count_calls(cancelled);
  const long before = allocations_held();
  for (long k = 1; k < calls / 2; k += stride(calls / 2, 20)) {
    try_failing(cancelled, k, all_after);
    ASSERT_EQ(cancelled(), UPS_OK) << "after the failure of allocation " << k << ": " << ups_last_error();
    ASSERT_EQ(allocations_held(), before) << "after the failure of allocation " << k;
  }
}

TEST_P(Memory, Context) {
  watch_library();
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
