// Readings by source and goniometers through the C API: what is refused, and with which words.
#include <cmath>

#include "fixture.h"

namespace ups_test {
namespace {

class Sources : public Api {
 protected:
  Sources() {
    auto lamp = make(&ups_light_desc_init);
    lamp.to_world[11] = 1;
    ups_luminaire_id lamp_id{};
    EXPECT_OK(ups_scene_add_light(scene, &lamp, &lamp_id));
    auto d = make(&ups_meter_desc_init);
    d.count = 1, d.positions_m = on_floor, d.normals = up;
    EXPECT_OK(ups_scene_add_meters(scene, &d, &meter));
    gonio = make(&ups_goniometer_desc_init);
    EXPECT_OK(ups_scene_add_goniometer(scene, &gonio, &goniometer));
    EXPECT_OK(ups_scene_commit(scene));
    desc = make(&ups_render_desc_init);
    desc.iteration_count = 4;
    desc.method = UPS_METHOD_LIGHT_TRACING;
  }
  ~Sources() override { ups_result_destroy(result); }
  void render() { ASSERT_EQ(ups_render(scene, &desc, &result), UPS_OK) << ups_last_error(); }

  double on_floor[3] = {0.3, 0.4, 0};
  float up[3] = {0, 0, 1};
  ups_goniometer_desc gonio{};
  ups_sensor_id meter{}, goniometer{};
  ups_render_desc desc{};
  ups_result* result = nullptr;
};

TEST_F(Sources, WithoutSeparationThereAreNone) {
  render();
  uint32_t count = 7;
  EXPECT_OK(ups_result_get_source_count(result, &count));
  EXPECT_EQ(count, 0u);
  ups_meter_reading reading;
  expect_error(ups_result_read_source_meters(result, 0, meter, &reading, 1), UPS_ERROR_INVALID_ARGUMENT,
               {"source 0", "separation"});
}

// All its fields: a part's is the length of that part's own vector, and never below 0. A wall that shines back on the
// meter from the lamp's other side has these lie apart.
TEST_F(Sources, OneSourcesVectorsAreThoseOfAllLight) {
  auto vectors = make(&ups_meter_desc_init);
  const double between[3] = {0.5, 0.5, 0.2};
  vectors.count = 1, vectors.positions_m = between, vectors.normals = up, vectors.kind = UPS_METER_VECTOR;
  ups_sensor_id at{};
  EXPECT_OK(ups_scene_add_meters(scene, &vectors, &at));
  auto floor = make(&ups_instance_desc_init);
  floor.mesh = mesh;
  floor.to_world[11] = -0.1;
  ups_instance_id below{};
  EXPECT_OK(ups_scene_add_instance(scene, &floor, &below));
  EXPECT_OK(ups_scene_commit(scene));
  desc.separation = UPS_SEPARATE_LUMINAIRES, desc.method = UPS_METHOD_UPS, desc.iteration_count = 32;
  render();
  ups_meter_reading all{}, source{};
  EXPECT_OK(ups_result_read_meters(result, at, &all, 1));
  EXPECT_OK(ups_result_read_source_meters(result, 0, at, &source, 1));
  EXPECT_GT(all.indirect_lx, 0.01f * all.direct_lx) << "or the test shows nothing";
  EXPECT_NEAR(source.illuminance_lx, all.illuminance_lx, 1e-4f * all.illuminance_lx);
  EXPECT_NEAR(source.direct_lx, all.direct_lx, 1e-4f * all.direct_lx);
  EXPECT_NEAR(source.indirect_lx, all.indirect_lx, 1e-3f * all.indirect_lx);
}

TEST_F(Sources, WrongArgumentsAreNamed) {
  desc.separation = 3;
  ups_result* none = nullptr;
  expect_error(ups_render(scene, &desc, &none), UPS_ERROR_INVALID_ARGUMENT, {"separation: 3"});
  desc.separation = UPS_SEPARATE_LUMINAIRES;
  desc.reserved = 1;
  expect_error(ups_render(scene, &desc, &none), UPS_ERROR_INVALID_ARGUMENT, {"reserved is 1"});
  desc.reserved = 0;
  render();
  ups_meter_reading readings[2];
  expect_error(ups_result_read_source_meters(result, 1, meter, readings, 1), UPS_ERROR_INVALID_ARGUMENT,
               {"there are 1"});
  expect_error(ups_result_read_source_meters(result, 0, meter, readings, 2), UPS_ERROR_INVALID_ARGUMENT,
               {"count is 2"});
  expect_error(ups_result_read_source_meters(result, 0, goniometer, readings, 1), UPS_ERROR_INVALID_ARGUMENT,
               {"not a meter set"});
  EXPECT_OK(ups_result_read_source_meters(result, 0, meter, readings, 1));
}

TEST_F(Sources, GoniometerReadingsHaveTheirGrid) {
  render();
  std::vector<ups_intensity_reading> nodes(24 * 73);
  expect_error(ups_result_read_goniometer(result, goniometer, nodes.data(), 5), UPS_ERROR_INVALID_ARGUMENT,
               {"count is 5", "1752 nodes"});
  EXPECT_OK(ups_result_read_goniometer(result, goniometer, nodes.data(), nodes.size()));
  expect_error(ups_result_read_goniometer(result, meter, nodes.data(), nodes.size()), UPS_ERROR_INVALID_ARGUMENT,
               {"not a goniometer"});
  std::vector<float> c(24), gamma(73);
  EXPECT_OK(ups_result_get_goniometer_angles(result, goniometer, c.data(), c.size(), gamma.data(), gamma.size()));
  EXPECT_EQ(c[23], 345.0f);
  EXPECT_EQ(gamma[72], 180.0f);
  expect_error(ups_result_get_goniometer_angles(result, goniometer, c.data(), 23, gamma.data(), gamma.size()),
               UPS_ERROR_INVALID_ARGUMENT, {"24 planes of 73"});
  ups_profile* measured = nullptr;
  EXPECT_OK(ups_result_get_goniometer_profile(result, goniometer, &measured));
  ups_profile_destroy(measured);
}

// 95 % noise of the nodes, in the mean over the light; nodes weigh by solid angle, those that too few paths found not
// at all.
double mean_noise(const std::vector<ups_intensity_reading>& nodes) {
  constexpr double t = 2.131, radian = 3.14159265358979323846 / 180;  // t of 15 degrees of freedom, two-sided
  double noise = 0, light = 0;
  for (size_t i = 0; i < nodes.size(); ++i) {
    const double weight = std::max(std::sin(2.5 * double(i % 73) * radian), 1e-3);
    noise += weight * t * std::max(0.0, double(nodes[i].standard_error_cd));
    light += weight * double(nodes[i].intensity_cd);
  }
  return noise / light;
}

TEST_F(Sources, AGoniometersTargetIsItsNoise) {
  EXPECT_OK(ups_scene_remove_sensor(scene, meter));
  EXPECT_OK(ups_scene_commit(scene));
  desc.light_paths_per_iteration = 256;
  desc.iteration_count = 20000;
  uint32_t iterations[2] = {};
  for (int i = 0; i < 2; ++i) {
    desc.target_relative_error = i ? 0.05f : 0.1f;
    ups_result_destroy(result);
    result = nullptr;
    render();
    ups_result_info info{};
    info.struct_size = sizeof info;
    EXPECT_OK(ups_result_get_info(result, &info));
    iterations[i] = info.iterations;
    std::vector<ups_intensity_reading> nodes(24 * 73);
    EXPECT_OK(ups_result_read_goniometer(result, goniometer, nodes.data(), nodes.size()));
    EXPECT_LT(mean_noise(nodes), 1.05 * double(desc.target_relative_error));
    EXPECT_GT(mean_noise(nodes), 0.6 * double(desc.target_relative_error)) << "checked at every fourth more iterations";
  }
  EXPECT_GT(iterations[1], iterations[0]);
  EXPECT_LT(iterations[1], 6.5 * iterations[0]);  // 4, or less: samples are stratified
}

TEST_F(Sources, ADarkGoniometerEndsItsRender) {
  const float nadir[] = {0, 1};
  const double below_the_lamp[12] = {1, 0, 0, -0.5, 0, 1, 0, -0.5, 0, 0, 1, 0};
  EXPECT_OK(ups_scene_set_transform(scene, instance, below_the_lamp));
  gonio.gamma_deg = nadir, gonio.gamma_count = 2;
  EXPECT_OK(ups_scene_remove_sensor(scene, meter));
  EXPECT_OK(ups_scene_remove_sensor(scene, goniometer));
  EXPECT_OK(ups_scene_add_goniometer(scene, &gonio, &goniometer));
  EXPECT_OK(ups_scene_commit(scene));
  desc.light_paths_per_iteration = 256;
  desc.iteration_count = 2000;
  desc.target_relative_error = 0.02f;
  render();
  ups_result_info info{};
  info.struct_size = sizeof info;
  EXPECT_OK(ups_result_get_info(result, &info));
  EXPECT_EQ(info.iterations, 32u);  // 3 of 32 x 256 light paths are far less than 2 % of the light
  std::vector<ups_intensity_reading> nodes(24 * 2);
  EXPECT_OK(ups_result_read_goniometer(result, goniometer, nodes.data(), nodes.size()));
  for (const ups_intensity_reading& n : nodes) {
    EXPECT_EQ(n.intensity_cd, 0);
    EXPECT_EQ(n.standard_error_cd, -1);
    EXPECT_GT(n.error_bound_cd, 0) << "not exact";
  }
}

// Equal steps of any number end at 180, which their rounding would pass; many planes find their images quickly.
TEST_F(Sources, GoniometersOfManyEqualSteps) {
  ups_sensor_id id{};
  for (const uint32_t count : {170u, 339u, 340u, 1001u}) {
    auto d = gonio;
    d.gamma_count = count, d.c_deg = d.gamma_deg = nullptr;
    EXPECT_OK(ups_scene_add_goniometer(scene, &d, &id));
    EXPECT_OK(ups_scene_remove_sensor(scene, id));
  }
  auto d = gonio;
  d.c_count = 1000000, d.gamma_count = 2, d.c_deg = d.gamma_deg = nullptr;
  d.symmetry = UPS_SYMMETRY_QUADRANTS;
  EXPECT_OK(ups_scene_add_goniometer(scene, &d, &id));
}

TEST_F(Sources, GoniometerFieldsAreChecked) {
  const float falling[] = {0, 90, 45}, late[] = {10, 20, 30}, far[] = {0, 90, 181};
  ups_sensor_id id{};
  const auto refused = [&](const ups_goniometer_desc& bad, const std::vector<std::string>& words) {
    expect_error(ups_scene_add_goniometer(scene, &bad, &id), UPS_ERROR_INVALID_ARGUMENT, words);
  };
  auto d = gonio;
  d.c_count = 0;
  refused(d, {"c_count"});
  d = gonio, d.gamma_count = 1;
  refused(d, {"gamma_count"});
  d = gonio, d.c_count = d.gamma_count = 4000;
  refused(d, {"c_count * gamma_count is 16000000"});
  d = gonio, d.c_count = 3, d.c_deg = falling;
  refused(d, {"c_deg[2] is 45"});
  d.c_deg = late;
  refused(d, {"c_deg[0] is 10"});
  d = gonio, d.gamma_count = 3, d.gamma_deg = far;
  refused(d, {"gamma_deg[2] is 181"});
  d = gonio, d.symmetry = 9;
  refused(d, {"symmetry is 9"});
  d = gonio, d.symmetry = UPS_SYMMETRY_AXIAL;
  refused(d, {"UPS_SYMMETRY_AXIAL", "24"});
  d = gonio, d.opening_shape = UPS_OPENING_DISC, d.opening_m[0] = NAN;
  refused(d, {"opening_m[0]"});
  d = gonio, d.to_world[0] = INFINITY;
  refused(d, {"to_world"});
}

TEST_F(Sources, OfASceneAreListedWithPlaceFluxAndProfile) {
  const float c[] = {0};
  std::vector<float> gamma, cd;
  for (int i = 0; i <= 90; ++i) gamma.push_back(float(i)), cd.push_back(100 * std::cos(float(i) * 0.01745329f));
  auto table = make(&ups_profile_desc_init);
  table.c_count = 1, table.gamma_count = 90, table.c_deg = c, table.gamma_deg = gamma.data();
  table.intensity_cd = cd.data();
  table.opening_shape = UPS_OPENING_RECTANGLE;
  table.opening_m[0] = 1.2f, table.opening_m[1] = 0.3f;
  ups_profile* profile = nullptr;
  ASSERT_EQ(ups_profile_create(context, &table, &profile), UPS_OK) << ups_last_error();
  auto d = make(&ups_luminaire_desc_init);
  const double quarter_turn[] = {0, -1, 0, 2, 1, 0, 0, 3, 0, 0, 1, 2.5};
  std::copy(quarter_turn, quarter_turn + 12, d.to_world);
  d.profile = profile, d.flux_lm = 3000, d.dimming = 0.5f, d.group = 7;
  ups_luminaire_id id{};
  EXPECT_OK(ups_scene_add_luminaire(scene, &d, &id));
  uint32_t count = 0;
  EXPECT_OK(ups_scene_get_source_count(scene, &count));
  EXPECT_EQ(count, 1u);  // as committed
  EXPECT_OK(ups_scene_commit(scene));
  EXPECT_OK(ups_scene_get_source_count(scene, &count));
  ASSERT_EQ(count, 2u);
  ups_scene_source lamp{}, luminaire{};
  lamp.struct_size = luminaire.struct_size = sizeof lamp;
  EXPECT_OK(ups_scene_get_source(scene, 0, &lamp));
  EXPECT_EQ(lamp.light_kind, UPS_LIGHT_POINT);
  EXPECT_NEAR(lamp.flux_lm, 4 * 3.14159265, 1e-5);
  EXPECT_EQ(lamp.bounds_min_m[2], 1);
  EXPECT_EQ(lamp.bounds_max_m[2], 1);
  EXPECT_OK(ups_scene_get_source(scene, 1, &luminaire));
  EXPECT_EQ(luminaire.kind, UPS_SOURCE_LUMINAIRE);
  EXPECT_EQ(luminaire.id, id.v);
  EXPECT_EQ(luminaire.group, 7u);
  EXPECT_EQ(luminaire.light_kind, -1);
  EXPECT_NEAR(luminaire.flux_lm, 1500, 1);  // the interpolated table's, the band rule's of the desc
  EXPECT_TRUE(std::equal(quarter_turn, quarter_turn + 12, luminaire.to_world));
  const double low[] = {1.85, 2.4, 2.5}, high[] = {2.15, 3.6, 2.5};
  for (int i = 0; i < 3; ++i) {
    EXPECT_NEAR(luminaire.bounds_min_m[i], low[i], 1e-6);
    EXPECT_NEAR(luminaire.bounds_max_m[i], high[i], 1e-6);
  }
  ups_profile* same = nullptr;
  EXPECT_OK(ups_scene_get_source_profile(scene, 1, &same));
  ups_profile_info info{};
  info.struct_size = sizeof info;
  EXPECT_OK(ups_profile_get_info(same, &info));
  EXPECT_EQ(info.peak_cd, 100);
  expect_error(ups_scene_get_source_profile(scene, 0, &same), UPS_ERROR_INVALID_ARGUMENT, {"source 0", "no luminaire"});
  expect_error(ups_scene_get_source(scene, 2, &lamp), UPS_ERROR_INVALID_ARGUMENT, {"source 2", "has 2"});
  expect_error(ups_scene_get_source_count(nullptr, &count), UPS_ERROR_INVALID_ARGUMENT, {"scene"});
  ups_profile_destroy(same);
  ups_profile_destroy(profile);
}

}  // namespace
}  // namespace ups_test
