// ups_glare.h: what is refused and how, structs of any size, defaults, and answers that need no render.
#include <cmath>
#include <limits>

#include "fixture_scene.h"

namespace ups_test {
namespace {

using Glare = Api;

template <class Info>
Info sized() {
  Info info{};
  info.struct_size = sizeof info;
  return info;
}

TEST_F(Glare, PositionIndicesOfDirections) {
  const float directions[] = {0, 0, -2, 1, 1, -1, 0, 0, 1, 3.1f, 0.1f, -1};
  float index[4];
  EXPECT_OK(ups_glare_get_position_index(UPS_POSITION_INDEX_TABLE, directions, 4, index));
  EXPECT_FLOAT_EQ(index[0], 1);
  EXPECT_FLOAT_EQ(index[1], 7);
  EXPECT_FLOAT_EQ(index[2], -1);
  EXPECT_FLOAT_EQ(index[3], -1);
  EXPECT_OK(ups_glare_get_position_index(UPS_POSITION_INDEX_GUTH, directions, 4, index));
  EXPECT_GT(index[3], 1);  // the closed form has no end
  EXPECT_OK(ups_glare_get_position_index(UPS_POSITION_INDEX_TABLE, nullptr, 0, nullptr));
  const float zero[] = {0, 0, -1, 0, 0, 0};
  expect_error(ups_glare_get_position_index(UPS_POSITION_INDEX_TABLE, zero, 2, index), UPS_ERROR_INVALID_ARGUMENT,
               {"directions_xyz", "element 1"});
  expect_error(ups_glare_get_position_index(2, zero, 1, index), UPS_ERROR_INVALID_ARGUMENT, {"kind"});
  expect_error(ups_glare_get_position_index(0, zero, 1, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"index"});
}

TEST_F(Glare, UgrByHand) {
  const float l[] = {1000, 5000}, w[] = {0.01f, 0.02f}, p[] = {2, -1};
  float ugr = 0;
  EXPECT_OK(ups_glare_get_ugr(l, w, p, 2, 10, &ugr));
  EXPECT_NEAR(ugr, 8 * std::log10(0.025 * 2500), 1e-5);
  EXPECT_OK(ups_glare_get_ugr(l + 1, w + 1, p + 1, 1, 10, &ugr));
  EXPECT_EQ(ugr, -1);
  EXPECT_OK(ups_glare_get_ugr(nullptr, nullptr, nullptr, 0, 10, &ugr));
  EXPECT_EQ(ugr, -1);
  for (double background : {0.0, -1.0, double(NAN), double(INFINITY)})
    expect_error(ups_glare_get_ugr(l, w, p, 2, background, &ugr), UPS_ERROR_INVALID_ARGUMENT, {"background_cd_m2"});
  const float bad[] = {-1, 0};
  expect_error(ups_glare_get_ugr(bad, w, p, 2, 10, &ugr), UPS_ERROR_INVALID_ARGUMENT, {"source 0"});
  expect_error(ups_glare_get_ugr(l, w, nullptr, 1, 10, &ugr), UPS_ERROR_INVALID_ARGUMENT, {"source 0"});
  expect_error(ups_glare_get_ugr(l, w, p, 2, 10, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"ugr"});
}

TEST_F(Glare, TablesNeedAnOpeningAndLight) {
  auto table = sized<ups_ugr_table>();
  expect_error(ups_profile_get_ugr_table(profile, &table), UPS_ERROR_UNSUPPORTED, {"opening"});
  auto utilisation = sized<ups_utilisation_table>();
  EXPECT_OK(ups_profile_get_utilisation(profile, &utilisation));
  EXPECT_FLOAT_EQ(utilisation.room_index[9], 5);
  auto sheet = sized<ups_data_sheet>();
  EXPECT_OK(ups_profile_get_data_sheet(profile, 0, &sheet));
  EXPECT_EQ(sheet.highest_luminance_cd_m2, -1);
  EXPECT_NEAR(sheet.flux_code[3], 50, 1e-4);
  expect_error(ups_profile_get_data_sheet(profile, NAN, &sheet), UPS_ERROR_INVALID_ARGUMENT, {"front_c_deg"});
  sheet.struct_size = 3;
  expect_error(ups_profile_get_data_sheet(profile, 0, &sheet), UPS_ERROR_INVALID_ARGUMENT, {"struct_size"});
  expect_error(ups_profile_get_ugr_table(profile, nullptr), UPS_ERROR_UNSUPPORTED, {"opening"});
  expect_error(ups_profile_get_ugr_table(nullptr, &table), UPS_ERROR_INVALID_ARGUMENT, {"profile"});

  const float dark[2] = {0, 0};
  auto d = uniform_profile();
  d.intensity_cd = dark;
  ups_profile* none = nullptr;
  EXPECT_OK(ups_profile_create(context, &d, &none));
  expect_error(ups_profile_get_utilisation(none, &utilisation), UPS_ERROR_INVALID_ARGUMENT, {"flux"});
  sheet = sized<ups_data_sheet>();
  EXPECT_OK(ups_profile_get_data_sheet(none, 0, &sheet));
  EXPECT_EQ(sheet.spacing_criterion[0], -1);
  ups_profile_destroy(none);
}

TEST_F(Glare, ObserversAreChecked) {
  auto d = make(&ups_observer_desc_init);
  EXPECT_EQ(d.struct_size, sizeof d);
  EXPECT_EQ(d.metric, UPS_GLARE_METRIC_UGR);
  EXPECT_EQ(d.position_index, UPS_POSITION_INDEX_TABLE);
  EXPECT_EQ(d.to_world[0], 1);
  ups_sensor_id id{};
  d.metric = 1;
  expect_error(ups_scene_add_observer(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT, {"metric"});
  d = make(&ups_observer_desc_init);
  d.position_index = -1;
  expect_error(ups_scene_add_observer(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT, {"position_index"});
  d = make(&ups_observer_desc_init);
  d.to_world[3] = std::numeric_limits<double>::quiet_NaN();
  expect_error(ups_scene_add_observer(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT, {"to_world"});
  d = make(&ups_observer_desc_init);
  for (const float area : {-1.0f, std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN()}) {
    d.ceiling_area_m2 = area;
    expect_error(ups_scene_add_observer(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT, {"ceiling_area_m2"});
  }
}

TEST_F(Glare, ReadingsAreOfObserversAlone) {
  auto d = make(&ups_observer_desc_init);
  ups_sensor_id eye{}, meters_id{};
  EXPECT_OK(ups_scene_add_observer(scene, &d, &eye));
  const auto m = meters();
  EXPECT_OK(ups_scene_add_meters(scene, &m, &meters_id));
  EXPECT_OK(ups_scene_commit(scene));
  auto render = make(&ups_render_desc_init);
  render.iteration_count = 2;
  ups_result* result = nullptr;
  EXPECT_OK(ups_render(scene, &render, &result));
  auto reading = sized<ups_observer_reading>();
  EXPECT_OK(ups_result_get_observer(result, eye, &reading));
  EXPECT_EQ(reading.flags, uint32_t(UPS_OBSERVER_NO_SOURCE | UPS_OBSERVER_NO_BACKGROUND));  // nothing emits
  EXPECT_EQ(reading.ugr, -1);
  expect_error(ups_result_get_observer(result, meters_id, &reading), UPS_ERROR_INVALID_ARGUMENT, {"observer"});
  auto source = sized<ups_glare_source>();
  expect_error(ups_result_get_glare_source(result, eye, 0, &source), UPS_ERROR_INVALID_ARGUMENT, {"index is 0"});
  ups_meter_reading meter{};
  EXPECT_OK(ups_result_read_meters(result, eye, &meter, 1));
  EXPECT_EQ(meter.illuminance_lx, 0);
  ups_result_destroy(result);
  EXPECT_OK(ups_scene_remove_sensor(scene, eye));
  EXPECT_OK(ups_scene_commit(scene));
}

// A spotlight in view and one behind the eye, which looks along -z. Of the one its cup is no source of its own.
TEST_F(Fixtures, InViewOfAnObserverAreToldOf) {
  auto emitter = cob(0.01, 1000);
  auto cup_desc = cup();
  EXPECT_OK(ups_fixture_add_emitter(fixture, &emitter, nullptr));
  EXPECT_OK(ups_fixture_add_reflector(fixture, &cup_desc, nullptr));
  auto d = make(&ups_observer_desc_init);
  ups_sensor_id eye{};
  EXPECT_OK(ups_scene_add_observer(scene, &d, &eye));
  auto render = make(&ups_render_desc_init);
  render.iteration_count = 2;
  for (const double z : {3.0, -3.0}) {
    place(0, 0, z);
    EXPECT_OK(ups_scene_commit(scene));
    ups_result* result = nullptr;
    EXPECT_OK(ups_render(scene, &render, &result));
    auto reading = sized<ups_observer_reading>();
    EXPECT_OK(ups_result_get_observer(result, eye, &reading));
    EXPECT_EQ((reading.flags & UPS_OBSERVER_FIXTURE) != 0, z < 0) << z;
    char text[4096];
    EXPECT_OK(ups_result_get_text(result, UPS_TEXT_WARNINGS, text, sizeof text, nullptr));
    EXPECT_EQ(std::string(text).find("fixtures are in view") != std::string::npos, z < 0) << text;
    ups_result_destroy(result);
  }
}

}  // namespace
}  // namespace ups_test
