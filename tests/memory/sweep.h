// What sweeps of failing allocations share: a small room, its short render, and how a call is tried.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <string>
#include <vector>

#include "failing_memory.h"
#include "support/scene_builder.h"

namespace ups::test {

inline constexpr long all_after = 1000000000;

// A room with a mirror, so that photons are merged, a shared mesh, a luminaire with an opening, a camera, and meters
// enough for their index to be a tree, which takes five.
struct Room {
  Scene scene;
  Sensor meters, camera;
  explicit Room(int threads, int meter_count = 40) : scene(threads) {
    scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
    scene.add(box({1, 1, 0}, {2, 2, 0.5}), mirror(0.9));
    scene.add(box({2.5, 2.5, 0}, {3, 3, 1}), rough(UPS_MATERIAL_METAL, 0.8, 0.3));
    scene.add_luminaire(table_profile(scene.context(), 0.3f).get(), {2, 2, 2.9}, {0, 0, -1}, true);
    std::vector<P3> places;
    for (int i = 0; i < meter_count; ++i) places.push_back({0.5 + 0.07 * i, 3, 0.75});
    meters = scene.add_meters(places, {0, 0, 1});
    camera = scene.add_camera({0.3, 0.3, 2}, {1, 1, -0.7}, 16, 12, 1, true);
  }
};

// Without a radius of merging a pilot pass of many light paths finds one first.
inline ups_render_desc short_render(float merge_radius_m) {
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  d.method = UPS_METHOD_UPS;
  d.iteration_count = 1;
  d.max_path_length = 3;
  d.light_paths_per_iteration = 256;
  d.merge_radius_m = merge_radius_m;
  return d;
}

using Call = std::function<ups_status()>;
using LastError = const char*();

inline void begin_watch() {
  watch_library();
  ups_context_create(nullptr, nullptr);  // fails: the room for this thread's messages stays
}

// Runs `call` with failing memory, then without; what both leave behind is `held` allocations. False where it makes
// fewer calls than `first`.
inline bool try_failing(const Call& call, long first, long count, LastError* last_error = &ups_last_error) {
  fail_memory(first, count);
  const ups_status status = call();
  const long calls = end_of_failing();
  const std::string message = last_error();
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

inline bool sweeps_all() {
  const char* sweep = std::getenv("UPS_MEMORY_SWEEP");
  return sweep && std::strcmp(sweep, "all") == 0;
}

// All allocations, or about `samples` of them.
inline long stride(long allocations, long samples) { return sweeps_all() ? 1 : std::max(1L, allocations / samples); }

inline long count_calls(const Call& call, LastError* last_error = &ups_last_error) {
  fail_memory(all_after, 1);
  EXPECT_EQ(call(), UPS_OK) << last_error();
  return end_of_failing();
}

// After a sweep, of all that the process holds: others hold memory for the library, too, such as Embree.
inline void expect_as_much([[maybe_unused]] long bytes) {
#ifndef UPS_SANITIZE  // it has memory of its own
  constexpr long varies = 512;
  EXPECT_LT(bytes_allocated() - bytes, varies);
#endif
}

// After each failure of one of about so many allocations, and of all from it on, `call` works again, and nothing is left
// behind.
inline void expect_nothing_lost(const Call& call, long samples, long least_allocations = 0) {
  ASSERT_EQ(call(), UPS_OK) << ups_last_error();  // tables that the process makes once
  const long calls = count_calls(call), before = allocations_held(), bytes = bytes_allocated();
  EXPECT_GT(calls, least_allocations);
  for (const long count : {1L, all_after})
    for (long k = 1; try_failing(call, k, count); k += stride(calls, samples)) {
      ASSERT_EQ(call(), UPS_OK) << "after the failure of allocation " << k << ": " << ups_last_error();
      ASSERT_EQ(allocations_held(), before) << "after the failure of allocation " << k;
    }
  expect_as_much(bytes);
}

}  // namespace ups::test
