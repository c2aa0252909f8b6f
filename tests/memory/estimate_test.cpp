// What ups_scene_estimate_memory foretells, against what the allocators were asked for: the peak of scene, render and
// result together lies within 0.7 and 1.3 times the estimate, of the parts that are known beforehand too. With the
// environment variable UPS_MEMORY_SWEEP=all a million meters and more passes of large images are among the cases: some
// 5 GB.
#include <gtest/gtest.h>

#include <functional>
#include <string>

#include "rooms.h"
#include "sweep.h"
#ifdef UPS_HAS_GLTF
#include "ups/ups_gltf.h"
#endif

using namespace ups::test;

namespace {

struct Case {
  const char* name;
  std::function<void(Scene&)> build;
  std::function<void(ups_render_desc&)> change;
  bool full = false;  // of UPS_MEMORY_SWEEP=all, and smaller, of low effort
};
void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }

void by_ups(ups_render_desc& d) { d.method = UPS_METHOD_UPS; }
void automatic(ups_render_desc&) {}
void tell_sources(ups_render_desc& d) { d.separation = UPS_SEPARATE_LUMINAIRES; }

void box_and_meters(Scene& s) {
  add_box(s);
  s.add_meters(grid(8, 8, 0.5, 0.5, 0.4, 0.75), {0, 0, 1});
}
void office(Scene& s) {
  add_office(s, 8);
  s.add_meters(grid(30, 20, 0.5, 0.5, 0.3, 0.75), {0, 0, 1});
  s.add_camera({0.5, 0.5, 1.7}, {1, 1, -0.2}, 320, 240, 1);
}
void office_camera(Scene& s, uint32_t width, uint32_t height, bool illuminance) {
  add_office(s, 8);
  s.add_camera({0.5, 0.5, 1.7}, {1, 1, -0.2}, width, height, 1, illuminance);
}
// Small ones are visited in every iteration.
void layered_camera(Scene& s) {
  add_office(s, 8);
  s.add_camera({0.5, 0.5, 1.7}, {1, 1, -0.2}, 160, 120, 1, false, UPS_EQUISOLID, 15);
}
void large_camera(Scene& s) { office_camera(s, 3840, 2160, false); }
void small_camera(Scene& s) { office_camera(s, 160, 120, true); }
void many_meters(Scene& s) {
  add_office(s, 8);
  s.add_meters(grid(400, 250, 0.5, 0.5, 0.02, 0.75), {0, 0, 1});
}
void many_vectors(Scene& s) {
  s.set_meter_kind(UPS_METER_VECTOR);
  add_office(s, 8);
  s.add_meters(grid(100, 100, 0.5, 0.5, 0.07, 0.75), {0, 0, 1});
}
void million_meters(Scene& s) {
  add_office(s, 8);
  const int rows = low_effort() ? 250 : 1000;  // the thread sanitizer takes four times the memory beside it
  s.add_meters(grid(1000, rows, 0.5, 0.5, 0.007, 0.75), {0, 0, 1});
}
void many_sources(Scene& s) {
  add_office(s, 100);
  s.add_meters(grid(20, 20, 0.5, 0.5, 0.3, 0.75), {0, 0, 1});
}
void many_triangles(Scene& s) {
  box_and_meters(s);
  s.add(icosphere({2, 2, 1}, 0.5, 7), matte(0.5));  // 327680
}
void goniometer(Scene& s) {
  s.add_goniometer(73, 181);
  s.add_point_light({0, 0, 0}, 100);
  s.add(box({-1, -1, 0.2}, {1, 1, 0.3}), matte(0.5));
}
#ifdef UPS_HAS_GLTF
void bathroom(Scene& s) {
  ups_gltf_import_desc d;
  ups_gltf_import_desc_init(&d, sizeof d);
  ups_gltf_import* imported = nullptr;
  ASSERT_EQ(ups_gltf_import_file(s.context(), UPS_BATHROOM, &d, s.get(), &imported), UPS_OK) << ups_gltf_last_error();
  ups_gltf_import_destroy(imported);
}
#endif

const Case cases[] = {
    {"box", box_and_meters, automatic},
    {"box_by_ups", box_and_meters, by_ups},
    {"office", office, automatic},
    {"office_by_ups", office, by_ups},
#ifdef UPS_HAS_GLTF
    {"bathroom", bathroom, automatic},
#endif
    {"camera_4k", large_camera, [](auto& d) { d.iteration_count = 2; }},
    {"camera_4k_all_passes", large_camera, [](auto& d) {
       d.iteration_count = low_effort() ? 16 * 4 : 16 * 254, d.max_path_length = 2;
     }, true},
    {"illuminance", small_camera, [](auto& d) { by_ups(d), d.iteration_count = 8; }},
    {"layers", layered_camera, [](auto& d) { by_ups(d), d.iteration_count = 8; }},
    {"technique_images", small_camera, [](auto& d) { by_ups(d), d.technique_images = 5, d.iteration_count = 6; }},
    {"meters_1e5", many_meters, automatic},
    {"vectors_1e4", many_vectors, [](auto& d) { d.method = UPS_METHOD_PATH_TRACING; }},
    {"meters_1e6", million_meters, [](auto& d) { d.iteration_count = low_effort() ? 16 : 64; }, true},
    {"sources_100", many_sources, tell_sources},
    {"sources_100_by_ups", many_sources, [](auto& d) { by_ups(d), tell_sources(d); }},
    {"triangles", many_triangles, by_ups},
    {"goniometer", goniometer, by_ups},
    {"light_paths_2_18", box_and_meters, [](auto& d) {
       by_ups(d), d.light_paths_per_iteration = 1 << 18, d.iteration_count = 1;
     }},
};

class MemoryEstimate : public testing::TestWithParam<Case> {};

void expect_near(double measured, double estimated, const char* what) {
  std::printf("%-10s %9.2f MB, estimated %9.2f MB, ratio %.3f\n", what, measured / 1e6, estimated / 1e6,
              measured / estimated);
  EXPECT_GE(measured, 0.7 * estimated) << what;
#ifndef UPS_SANITIZE  // what the sanitizer reads for the stacks of a report, of a suppressed one too, is measured with it
  EXPECT_LE(measured, 1.3 * estimated) << what;
#endif
}

TEST_P(MemoryEstimate, HoldsThePeak) {
  const Case& c = GetParam();
  if (c.full && !sweeps_all() && !low_effort()) GTEST_SKIP() << "of UPS_MEMORY_SWEEP=all";
  Scene first(2);  // what the process makes once, and keeps as long as there is a scene
  add_box(first);
  ASSERT_EQ(ups_scene_commit(first.get()), UPS_OK);
  Scene scene(2);
  const long before = bytes_allocated();
  c.build(scene);
  ASSERT_EQ(ups_scene_commit(scene.get()), UPS_OK) << ups_last_error();
  const long committed = bytes_allocated() - before;
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  d.iteration_count = with_effort(16);
  c.change(d);
  ups_memory_estimate e{};
  e.struct_size = sizeof e;
  ASSERT_EQ(ups_scene_estimate_memory(scene.get(), &d, &e), UPS_OK) << ups_last_error();
  EXPECT_LT(bytes_allocated() - before - committed, 100000);  // what threads keep
  EXPECT_GT(e.allowed_bytes, 0u);
  if (e.allowed_bytes < 1.5 * double(e.peak_bytes) && e.peak_bytes > 500000000) GTEST_SKIP() << "of a small machine";
  begin_peak();
  ups_result* result = nullptr;
  ASSERT_EQ(ups_render(scene.get(), &d, &result), UPS_OK) << ups_last_error();
  const long peak = peak_allocated() - before, kept = bytes_allocated() - before - committed;
  ups_result_destroy(result);
  expect_near(double(peak), double(e.peak_bytes), "peak");
  // Small ones are of no interest: texts, tables of the process.
  if (committed > 1000000) expect_near(double(committed), double(e.scene_bytes), "scene");
  if (kept > 1000000) expect_near(double(kept), double(e.result_bytes), "result");
  EXPECT_GE(e.peak_bytes, e.scene_bytes + e.result_bytes);
  EXPECT_GE(e.working_bytes, e.light_bytes);
  EXPECT_GT(e.allowed_bytes, e.peak_bytes);
}

INSTANTIATE_TEST_SUITE_P(Of, MemoryEstimate, testing::ValuesIn(cases),
                         [](const auto& c) { return std::string(c.param.name); });

}  // namespace
