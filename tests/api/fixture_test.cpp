// Fixtures: what their parts emit, placing, sharing, dimming, moving and removing.
#include "fixture_scene.h"

#include <cmath>

namespace ups_test {
namespace {

TEST_F(Fixtures, EmittedFluxIsWhatWasAskedFor) {
  ups_fixture_part_id part{};
  auto d = cob(0.0045, 1000);
  d.color_rgb[2] = 0.3f;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &d, &part));
  EXPECT_EQ(part.v, 1u);
  d = cob(0, 200);
  d.shape = UPS_EMITTER_RECTANGLE, d.width_m = 0.1, d.length_m = 0.02;
  d.to_fixture[11] = 0.05;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &d, nullptr));
  d = cob(0.001, 30);
  d.shape = UPS_EMITTER_SPHERE;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &d, nullptr));
  d.shape = UPS_EMITTER_CYLINDER, d.length_m = 0.01, d.flux_lm = 4;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &d, &part));
  EXPECT_EQ(part.v, 4u);
  const ups_fixture_info i = info();
  EXPECT_EQ(i.part_count, 4u);
  EXPECT_NEAR(i.flux_lm, 1234, 1e-3);
  EXPECT_NEAR(i.emitter_area_m2, pi * 0.0045 * 0.0045 + 0.002 + 4 * pi * 1e-6 + pi * (2 * 0.001 * 0.01 + 2 * 1e-6),
              1e-6);
  place(3, 4, 2.7);
  ups_scene_info s = scene_info();
  EXPECT_NEAR(s.emitted_flux_lm / 1234, 1, 2e-5);  // single precision of millimetres, metres from the scene's centre
  EXPECT_EQ(s.emissive_instance_count, 4u);
  EXPECT_EQ(s.triangle_count, i.triangle_count);
  place(-3, 4, 2.7);
  EXPECT_NEAR(scene_info().emitted_flux_lm / 2468, 1, 1e-4);
}

// Corners of a chip are floats of the scene's frame: 60 m off they are 4 um apart, some hundredths of the chip's side.
TEST_F(Fixtures, SmallEmittersKeepTheirFluxFarFromTheCentre) {
  auto chip = make(&ups_fixture_emitter_desc_init);
  chip.shape = UPS_EMITTER_RECTANGLE, chip.width_m = 0.0003, chip.length_m = 0.00031, chip.flux_lm = 100;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &chip, nullptr));
  auto wire = make(&ups_fixture_emitter_desc_init);
  wire.shape = UPS_EMITTER_CYLINDER, wire.radius_m = 0.0003, wire.length_m = 0.004, wire.flux_lm = 50;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &wire, nullptr));
  place(-60.123, -50, 9);
  const ups_fixture_id second = place(60.123, 50, 9);
  EXPECT_NEAR(scene_info().emitted_flux_lm / 300, 1, 1e-5);
  EXPECT_OK(ups_scene_set_fixture_dimming(scene, second, 0.5f));  // of emitters that stay where they are
  EXPECT_NEAR(scene_info().emitted_flux_lm / 225, 1, 1e-5);
}

TEST_F(Fixtures, AreDimmedMovedScaledAndRemoved) {
  const auto emitter = cob(0.01, 1000);
  const auto reflector = cup();
  EXPECT_OK(ups_fixture_add_emitter(fixture, &emitter, nullptr));
  EXPECT_OK(ups_fixture_add_reflector(fixture, &reflector, nullptr));
  const ups_fixture_id first = place(0, 0, 1);
  auto d = make(&ups_fixture_instance_desc_init);
  d.flux_lm = 300, d.dimming = 0.5f;
  ups_fixture_id second{};
  EXPECT_OK(ups_scene_add_fixture(scene, fixture, &d, &second));
  EXPECT_NE(first.v, second.v);
  ups_fixture_destroy(fixture);  // the scene keeps what it needs
  fixture = nullptr;
  EXPECT_NEAR(scene_info().emitted_flux_lm, 1150, 0.1);
  EXPECT_OK(ups_scene_set_fixture_dimming(scene, second, 2));
  EXPECT_NEAR(scene_info().emitted_flux_lm, 1600, 0.1);
  EXPECT_OK(ups_scene_set_fixture_dimming(scene, first, 0));
  EXPECT_NEAR(scene_info().emitted_flux_lm, 600, 0.1);
  uint32_t sources = 0;
  EXPECT_OK(ups_scene_get_source_count(scene, &sources));
  ASSERT_EQ(sources, 2u) << "what is dark is listed, too";
  ups_scene_source dark{};
  dark.struct_size = sizeof dark;
  EXPECT_OK(ups_scene_get_source(scene, 0, &dark));
  EXPECT_EQ(dark.flux_lm, 0);
  EXPECT_NEAR(dark.bounds_max_m[0], 0.01, 1e-4);
  EXPECT_OK(ups_scene_set_maintenance_factor(scene, 0.75));
  EXPECT_NEAR(scene_info().emitted_flux_lm, 450, 0.1);
  EXPECT_OK(ups_scene_set_maintenance_factor(scene, 1));
  EXPECT_OK(ups_scene_set_fixture_dimming(scene, first, 1));
  // Head over: the paraboloid's vertex, f above its focus, goes down.
  const double turned[12] = {1, 0, 0, 5, 0, -1, 0, 0, 0, 0, -1, 2};
  EXPECT_OK(ups_scene_set_fixture_transform(scene, second, turned));
  ups_scene_info s = scene_info();
  EXPECT_NEAR(s.bounds_max_m[0], 5.06, 1e-5);
  EXPECT_NEAR(s.bounds_max_m[2], 2 + 0.045 - 0.02, 1e-5);  // rim at f - R^2 / 4f = -0.025
  EXPECT_NEAR(s.bounds_min_m[2], 1 - 0.025, 1e-5);
  const uint64_t both = s.triangle_count;
  EXPECT_OK(ups_scene_remove_fixture(scene, first));
  s = scene_info();
  EXPECT_NEAR(s.emitted_flux_lm, 600, 0.1);
  EXPECT_EQ(s.triangle_count, both / 2);
  expect_error(ups_scene_remove_fixture(scene, first), UPS_ERROR_INVALID_ARGUMENT, {"fixture id 1 was removed"});
  expect_error(ups_scene_set_fixture_dimming(scene, {9}, 1), UPS_ERROR_INVALID_ARGUMENT, {"fixture id 9"});
  expect_error(ups_scene_set_fixture_dimming(scene, second, -1), UPS_ERROR_INVALID_ARGUMENT, {"dimming is -1"});
  expect_error(ups_scene_set_fixture_dimming(scene, second, NAN), UPS_ERROR_INVALID_ARGUMENT, {"dimming is nan"});
  expect_error(ups_scene_set_fixture_transform(scene, second, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"to_world"});
}

TEST_F(Fixtures, TellTheInstancesOfTheirParts) {
  const auto emitter = cob(0.01, 1000);
  const auto reflector = cup();
  EXPECT_OK(ups_fixture_add_reflector(fixture, &reflector, nullptr));
  EXPECT_OK(ups_fixture_add_emitter(fixture, &emitter, nullptr));
  const ups_fixture_id first = place(0, 0, 1), second = place(1, 0, 1);
  ups_instance_id mirror{}, light{}, other{};
  EXPECT_OK(ups_scene_get_fixture_instance(scene, first, {1}, &mirror));
  EXPECT_OK(ups_scene_get_fixture_instance(scene, first, {2}, &light));
  EXPECT_OK(ups_scene_get_fixture_instance(scene, second, {2}, &other));
  EXPECT_NE(light.v, other.v);
  EXPECT_NEAR(scene_info().emitted_flux_lm, 2000, 0.1);
  EXPECT_OK(ups_scene_remove_instance(scene, mirror));
  EXPECT_NEAR(scene_info().emitted_flux_lm, 2000, 0.1);
  EXPECT_OK(ups_scene_remove_instance(scene, light));
  EXPECT_NEAR(scene_info().emitted_flux_lm, 1000, 0.1);
  for (uint32_t part : {0u, 3u})
    expect_error(ups_scene_get_fixture_instance(scene, first, {part}, &other), UPS_ERROR_INVALID_ARGUMENT, {"part"});
  expect_error(ups_scene_get_fixture_instance(scene, {99}, {1}, &other), UPS_ERROR_INVALID_ARGUMENT, {"fixture"});
  expect_error(ups_scene_get_fixture_instance(scene, first, {1}, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"out"});
}

}  // namespace
}  // namespace ups_test
