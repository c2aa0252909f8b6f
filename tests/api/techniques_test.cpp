// Within a method: the fields of ups_render_desc that choose techniques, what is said of light that a set cannot
// sample, and the images of single techniques.
#include <cfloat>
#include <cmath>
#include <cstddef>

#include "fixture.h"

namespace ups_test {
namespace {

// A lamp between the fixture's square, a mirror above, a camera that looks down and a meter on the square.
class Techniques : public Api {
 protected:
  Techniques() {
    auto mirror = make(&ups_material_desc_init);
    mirror.model = UPS_MATERIAL_MIRROR;
    auto above = quad();
    EXPECT_OK(ups_scene_add_material(scene, &mirror, &above.material));
    auto instance_of_mirror = make(&ups_instance_desc_init);
    EXPECT_OK(ups_scene_add_mesh(scene, &above, &instance_of_mirror.mesh));
    instance_of_mirror.to_world[11] = 1;
    ups_instance_id id{};
    EXPECT_OK(ups_scene_add_instance(scene, &instance_of_mirror, &id));
    auto lamp = make(&ups_light_desc_init);
    lamp.to_world[3] = lamp.to_world[7] = lamp.to_world[11] = 0.5;
    ups_luminaire_id lamp_id{};
    EXPECT_OK(ups_scene_add_light(scene, &lamp, &lamp_id));
    auto eye = make(&ups_camera_desc_init);
    eye.width = 4, eye.height = 3;
    eye.to_world[3] = eye.to_world[7] = 0.5, eye.to_world[11] = 0.8;
    EXPECT_OK(ups_scene_add_camera(scene, &eye, &camera));
    auto d = make(&ups_meter_desc_init);
    d.count = 1, d.positions_m = on_floor, d.normals = up;
    EXPECT_OK(ups_scene_add_meters(scene, &d, &meter));
    EXPECT_OK(ups_scene_commit(scene));
    desc = make(&ups_render_desc_init);
    desc.iteration_count = 4;
  }
  ~Techniques() override { ups_result_destroy(result); }

  void render() {
    ups_result_destroy(result);
    result = nullptr;
    ASSERT_EQ(ups_render(scene, &desc, &result), UPS_OK) << ups_last_error();
  }
  std::string warnings() {
    render();
    size_t needed = 0;
    EXPECT_OK(ups_result_get_text(result, UPS_TEXT_WARNINGS, nullptr, 0, &needed));
    std::string text(needed, '\0');
    EXPECT_OK(ups_result_get_text(result, UPS_TEXT_WARNINGS, text.data(), needed, &needed));
    return text.c_str();
  }
  void expect_refused(ups_render_desc bad, const std::vector<std::string>& words) {
    ups_result* none = nullptr;
    expect_error(ups_render(scene, &bad, &none), UPS_ERROR_INVALID_ARGUMENT, words);
    EXPECT_EQ(none, nullptr);
  }

  double on_floor[3] = {0.3, 0.4, 0};
  float up[3] = {0, 0, 1};
  ups_sensor_id camera{}, meter{};
  ups_render_desc desc{};
  ups_result* result = nullptr;
};

TEST_F(Techniques, FieldsOutsideTheirRangeAreNamed) {
  for (const float alpha : {-0.5f, 1.0f, 2.0f, NAN}) {
    auto d = desc;
    d.radius_alpha = alpha;
    expect_refused(d, {"radius_alpha"});
  }
  auto d = desc;
  d.glossy_alpha = 1.5f;
  expect_refused(d, {"glossy_alpha", "1.5"});
  d = desc, d.perturbation = 2;
  expect_refused(d, {"perturbation", "2"});
  d = desc, d.technique_images = 17;
  expect_refused(d, {"technique_images", "17", "16"});
  d = desc, d.method = UPS_METHOD_PATH_TRACING, d.perturbation = UPS_PERTURBATION_ACTUAL;
  expect_refused(d, {"perturbation", "merge_radius_m"});
}

// Embree asserts that a ray is one: a radius whose square is infinite ended the process.
TEST_F(Techniques, ARadiusBeyondTheSceneIsItsDiameter) {
  for (const float radius : {1e4f, 1e20f, FLT_MAX})
    for (ups_method m : {UPS_METHOD_UPS, UPS_METHOD_PPM, UPS_METHOD_SPPM}) {
      desc.method = m, desc.merge_radius_m = radius;
      render();
    }
}

TEST_F(Techniques, ADescOfAnOlderCallerGetsTheDefaults) {
  desc.struct_size = offsetof(ups_render_desc, radius_alpha);
  desc.radius_alpha = 7;  // beyond its end
  render();
}

TEST_F(Techniques, EveryMethodRuns) {
  for (ups_method m : {UPS_METHOD_UPS, UPS_METHOD_PATH_TRACING, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_BIDIRECTIONAL,
                       UPS_METHOD_PPM, UPS_METHOD_SPPM, UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING}) {
    desc.method = m;
    render();
    ups_result_info info{};
    info.struct_size = sizeof info;
    EXPECT_OK(ups_result_get_info(result, &info));
    EXPECT_EQ(info.method, m);
    ups_meter_reading reading{};
    EXPECT_OK(ups_result_read_meters(result, meter, &reading, 1));
    EXPECT_GT(reading.illuminance_lx, 0) << m;
  }
}

// Light of the lamp that the mirror sends to the meter has no technique without merging; seen in the mirror it has none
// in bidirectional path tracing.
TEST_F(Techniques, LightThatASetCannotSampleIsNamed) {
  for (ups_method m : {UPS_METHOD_PATH_TRACING, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_LIGHT_TRACING}) {
    desc.method = m;
    const std::string text = warnings();
    for (const char* word : {"luminaire 1 (without extent)", "specular (material 2 (mirror))", "point meter"})
      EXPECT_NE(text.find(word), std::string::npos) << m << ": " << text;
  }
  for (ups_method m :
       {UPS_METHOD_AUTO, UPS_METHOD_UPS, UPS_METHOD_PPM, UPS_METHOD_SPPM, UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING}) {
    desc.method = m;
    EXPECT_EQ(warnings().find("luminaire 1"), std::string::npos) << m << ": " << warnings();
  }
  desc.method = UPS_METHOD_UPS;
  desc.techniques = UPS_TECHNIQUE_LIGHT_SAMPLE;
  EXPECT_NE(warnings().find("luminaire 1"), std::string::npos);
}

TEST_F(Techniques, ImagesHaveTheirNumbersAndNothingElse) {
  desc.technique_images = 3;
  render();
  uint32_t count = 0;
  EXPECT_OK(ups_result_get_technique_count(result, camera, &count));
  ASSERT_EQ(count, 3u * 4u);  // k + 1 of path integration and k - 1 of density estimation for k edges
  std::vector<float> pixels(4 * 3 * 3);
  const size_t bytes = pixels.size() * sizeof(float);
  for (uint32_t i = 0; i < count; ++i) {
    ups_technique_info info{};
    info.struct_size = sizeof info;
    EXPECT_OK(ups_result_get_technique(result, camera, i, &info));
    EXPECT_GE(info.edges, 1u);
    EXPECT_LE(info.edges, 3u);
    EXPECT_EQ(info.light_vertices + info.eye_vertices, info.edges + (info.technique == UPS_TECHNIQUE_MERGE ? 2 : 1));
    for (ups_contribution c : {UPS_CONTRIBUTION_WEIGHTED, UPS_CONTRIBUTION_UNWEIGHTED})
      EXPECT_OK(ups_result_read_technique(result, camera, i, c, pixels.data(), 0, bytes));
  }
  ups_technique_info info{};
  info.struct_size = sizeof info;
  const auto read = [&](ups_sensor_id id, uint32_t index, ups_contribution c, float* out, size_t size) {
    return ups_result_read_technique(result, id, index, c, out, 0, size);
  };
  expect_error(ups_result_get_technique(result, camera, count, &info), UPS_ERROR_INVALID_ARGUMENT,
               {"index is 12", "12"});
  expect_error(ups_result_get_technique(result, meter, 0, &info), UPS_ERROR_INVALID_ARGUMENT, {"is not a camera"});
  expect_error(read(camera, 0, 2, pixels.data(), bytes), UPS_ERROR_INVALID_ARGUMENT, {"contribution: 2"});
  expect_error(read(camera, 0, 0, nullptr, bytes), UPS_ERROR_INVALID_ARGUMENT, {"out is NULL"});
  expect_error(read(camera, 0, 0, pixels.data(), bytes - 1), UPS_ERROR_BUFFER_TOO_SMALL, {"size_bytes"});
  EXPECT_OK(ups_result_read_image(result, camera, UPS_CHANNEL_PATH_INTEGRATION_RGB, pixels.data(), 0, bytes));
}

TEST_F(Techniques, WithoutAskingThereAreNoImages) {
  render();
  uint32_t count = 7;
  EXPECT_OK(ups_result_get_technique_count(result, camera, &count));
  EXPECT_EQ(count, 0u);
  std::vector<float> pixels(4 * 3 * 3);
  expect_error(
      ups_result_read_image(result, camera, UPS_CHANNEL_DENSITY_ESTIMATION_RGB, pixels.data(), 0, pixels.size() * 4),
      UPS_ERROR_INVALID_ARGUMENT, {"technique_images"});
}

}  // namespace
}  // namespace ups_test
