// Every field that can be wrong, made wrong: the call must say INVALID_ARGUMENT and name the field, the element, the
// value and the right range; the id that it would hand out stays untouched.
#include <cmath>
#include <functional>

#include "fixture.h"

namespace ups_test {
namespace {

template <class Desc>
struct Case {
  std::function<void(Desc&)> spoil;
  std::vector<std::string> words;
};

template <class Desc, class Id>
void expect_each_fails(ups_scene* scene, const Desc& good, ups_status (*add)(ups_scene*, const Desc*, Id*),
                       const std::vector<Case<Desc>>& cases, const char* function) {
  Id id{};
  for (size_t i = 0; i < cases.size(); ++i) {
    SCOPED_TRACE("case " + std::to_string(i));
    Desc d = good;
    cases[i].spoil(d);
    auto words = cases[i].words;
    words.push_back(function);
    expect_error(add(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT, words);
    EXPECT_EQ(id.v, 0u);
  }
  expect_error(add(nullptr, &good, &id), UPS_ERROR_INVALID_ARGUMENT, {"scene is NULL"});
  expect_error(add(scene, nullptr, &id), UPS_ERROR_INVALID_ARGUMENT, {"desc is NULL"});
  expect_error(add(scene, &good, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"out is NULL"});
  EXPECT_OK(add(scene, &good, &id));
  EXPECT_GT(id.v, 0u);
}

// The transforms of instances, lights, luminaires and cameras.
template <class Desc>
std::vector<Case<Desc>> transform_cases() {
  return {{[](Desc& d) { d.to_world[7] = NAN; }, {"to_world[7]", "nan", "finite"}},
          {[](Desc& d) { d.to_world[0] = 0; }, {"to_world", "singular", "invertible"}},
          {[](Desc& d) { d.to_world[0] = INFINITY; }, {"to_world[0]", "inf"}},
          {[](Desc& d) { d.to_world[10] = 1e-170; }, {"to_world", "singular", "axis 2"}},
          {[](Desc& d) { d.to_world[0] = 1e-320; }, {"to_world", "singular", "axis 0"}}};
}

template <class Desc>
std::vector<Case<Desc>> operator+(std::vector<Case<Desc>> a, const std::vector<Case<Desc>>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

TEST_F(Api, TextureFields) {
  float bad[12] = {0, 0, 0, 0, 0, 0, 0, 0, 0, 0, NAN, 0};
  using D = ups_texture_desc;
  const std::vector<Case<D>> cases = {
      {[](D& d) { d.width = 0; }, {"width is 0"}},
      {[](D& d) { d.height = 0; }, {"height is 0"}},
      {[](D& d) { d.channel_count = 2; }, {"channel_count is 2", "1, 3 or 4"}},
      {[](D& d) { d.texels = nullptr; }, {"texels is NULL"}},
      {[](D& d) { d.row_stride_bytes = 20; }, {"row_stride_bytes is 20", "24"}},
      {[](D& d) { d.row_stride_bytes = 27; }, {"row_stride_bytes is 27", "multiple of 4"}},
      {[&](D& d) { d.texels = bad; }, {"texels: row 1, column 1, channel 1 is nan"}},
  };
  expect_each_fails(scene, texture_desc(), &ups_scene_add_texture, cases, "ups_scene_add_texture");
}

TEST_F(Api, MaterialFields) {
  float wide_texels[3] = {1.5f, 0, 0}, one = 0.5f;
  auto t = make(&ups_texture_desc_init);
  t.width = t.height = 1, t.channel_count = 3, t.texels = wide_texels;
  ups_texture_id wide{}, grey{};
  EXPECT_OK(ups_scene_add_texture(scene, &t, &wide));
  t.channel_count = 1, t.texels = &one;
  EXPECT_OK(ups_scene_add_texture(scene, &t, &grey));
  using D = ups_material_desc;
  const std::vector<Case<D>> cases = {
      {[](D& d) { d.model = 7; }, {"model is 7", "UPS_MATERIAL_*", "0 to 6"}},
      {[](D& d) { d.reflectance_rgb[1] = 1.5f; }, {"reflectance_rgb[1] is 1.5", "[0, 1]"}},
      {[](D& d) { d.reflectance_rgb[2] = NAN; }, {"reflectance_rgb[2] is nan"}},
      {[](D& d) { d.transmittance_rgb[0] = 0.5f; }, {"transmittance_rgb[1] is -1"}},
      {[](D& d) {
         d.model = UPS_MATERIAL_DIFFUSER, d.transmittance_rgb[0] = d.transmittance_rgb[1] = 0.2f,
         d.transmittance_rgb[2] = 0.6f;
       },
       {"reflectance_rgb[2] + transmittance_rgb[2] is 1.1"}},
      {[](D& d) { d.pane_angle_count = 3; }, {"pane_angle_count is 3", "UPS_MATERIAL_GLAZING"}},
      {[](D& d) { d.model = UPS_MATERIAL_GLAZING, d.pane_angle_count = 3; }, {"pane_angle_deg"}},
      {[](D& d) {
         static const float angle[] = {0, 95}, share[] = {0.5f, 0.6f};
         d.model = UPS_MATERIAL_GLAZING, d.pane_angle_count = 2, d.pane_angle_deg = angle;
         d.pane_transmittance = d.pane_reflectance = share;
       },
       {"pane_angle_deg[1] is 95", "from 0 to 90"}},
      {[](D& d) {
         static const float angle[] = {0, 90}, share[] = {0.5f, 0.6f};
         d.model = UPS_MATERIAL_GLAZING, d.pane_angle_count = 2, d.pane_angle_deg = angle;
         d.pane_transmittance = d.pane_reflectance = share;
       },
       {"at 90 degrees is 1.2", "at most 1"}},
      {[](D& d) { d.roughness = -0.1f; }, {"roughness is -0.1", "[0, 1]"}},
      {[](D& d) { d.model = UPS_MATERIAL_GLASS, d.ior = 0.9f; }, {"ior is 0.9", "[1, 1e+06]"}},
      {[](D& d) { d.model = UPS_MATERIAL_GLAZING, d.ior = 1e20f; }, {"ior is 1e+20", "[1, 1e+06]"}},
      {[](D& d) { d.ior = INFINITY; }, {"ior is inf"}},
      {[](D& d) { d.ior_k_rgb[0] = -1; }, {"ior_k_rgb[0] is -1"}},
      {[](D& d) { d.ior_rgb[2] = NAN; }, {"ior_rgb[2]"}},
      {[](D& d) { d.ior_k_rgb[1] = 1e10f; }, {"ior_k_rgb[1] is 1e+10", "1e+06"}},
      {[](D& d) { d.model = UPS_MATERIAL_METAL, d.ior_k_rgb[0] = 3, d.ior_rgb[1] = 0; }, {"ior_rgb[1] is 0"}},
      {[](D& d) { d.absorption_per_m_rgb[0] = -2; }, {"absorption_per_m_rgb[0] is -2", "at least 0"}},
      {[](D& d) { d.metallic = 2; }, {"metallic is 2"}},
      {[](D& d) { d.alpha_mode = -1; }, {"alpha_mode is -1"}},
      {[](D& d) { d.alpha = 1.01f; }, {"alpha is 1.01"}},
      {[](D& d) { d.alpha_cutoff = -1; }, {"alpha_cutoff is -1"}},
      {[](D& d) { d.luminance_cd_m2[1] = -5; }, {"luminance_cd_m2[1] is -5"}},
      {[](D& d) { d.emits_both_sides = 2; }, {"emits_both_sides is 2", "0 or 1"}},
      {[](D& d) { d.normal_scale = NAN; }, {"normal_scale is nan"}},
      {[](D& d) { d.reflectance_texture.v = 99; }, {"reflectance_texture", "99"}},
      {[&](D& d) { d.reflectance_texture = wide; }, {"reflectance_texture", "1.5", "[0, 1]"}},
      {[&](D& d) { d.roughness_texture = wide; }, {"roughness_texture", "1.5"}},
      {[&](D& d) { d.metallic_texture = wide; }, {"metallic_texture", "1.5"}},
      {[](D& d) { d.alpha_texture.v = 98; }, {"alpha_texture", "98"}},
      {[&](D& d) { d.normal_texture = grey; }, {"normal_texture", "1 channel"}},
  };
  const auto good = make(&ups_material_desc_init);
  expect_each_fails(scene, good, &ups_scene_add_material, cases, "ups_scene_add_material");
  auto changed = good;
  changed.roughness = 3;
  expect_error(ups_scene_set_material(scene, material, &changed), UPS_ERROR_INVALID_ARGUMENT,
               {"ups_scene_set_material", "roughness"});
  expect_error(ups_scene_set_material(scene, {77}, &good), UPS_ERROR_INVALID_ARGUMENT, {"material id 77"});
  EXPECT_OK(ups_scene_set_material(scene, material, &good));
}

TEST_F(Api, MeshFields) {
  using D = ups_mesh_desc;
  float bad[16] = {};
  bad[7] = INFINITY;
  uint32_t out_of_range[6] = {0, 1, 2, 0, 4, 3};
  const std::vector<Case<D>> cases = {
      {[](D& d) { d.vertex_count = 0; }, {"vertex_count is 0"}},
      {[](D& d) { d.triangle_count = 0; }, {"triangle_count is 0"}},
      {[](D& d) { d.material.v = 0; }, {"material is 0"}},
      {[](D& d) { d.material.v = 5; }, {"material id 5"}},
      {[](D& d) { d.positions_m = nullptr; }, {"positions_m is NULL"}},
      {[](D& d) { d.indices = nullptr; }, {"indices is NULL"}},
      {[](D& d) { d.position_stride_bytes = 8; }, {"position_stride_bytes is 8", "12"}},
      {[&](D& d) { d.positions_m = bad; }, {"positions_m: element 2, component 1 is inf"}},
      {[&](D& d) { d.normals = bad; }, {"normals: element 2, component 1"}},
      {[&](D& d) { d.normals = normals, d.normal_stride_bytes = 13; }, {"normal_stride_bytes is 13"}},
      {[&](D& d) { d.uvs = bad; }, {"uvs: element 3, component 1"}},
      {[&](D& d) { d.uvs = uvs, d.uv_stride_bytes = 4; }, {"uv_stride_bytes is 4"}},
      {[&](D& d) { d.tangents = bad; }, {"tangents: element 1, component 3"}},
      {[&](D& d) { d.tangents = tangents, d.tangent_stride_bytes = 12; }, {"tangent_stride_bytes is 12"}},
      {[&](D& d) { d.indices = out_of_range; }, {"indices: element 4 is 4", "vertex_count, 4"}},
  };
  expect_each_fails(scene, quad(), &ups_scene_add_mesh, cases, "ups_scene_add_mesh");
}

TEST_F(Api, InstanceFields) {
  using D = ups_instance_desc;
  auto good = make(&ups_instance_desc_init);
  good.mesh = mesh;
  const std::vector<Case<D>> cases = {{[](D& d) { d.mesh.v = 0; }, {"mesh is 0"}},
                                      {[](D& d) { d.mesh.v = 9; }, {"mesh id 9"}}};
  expect_each_fails(scene, good, &ups_scene_add_instance, cases + transform_cases<D>(), "ups_scene_add_instance");
  expect_error(ups_scene_set_transform(scene, instance, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"to_world is NULL"});
  expect_error(ups_scene_set_transform(scene, {50}, good.to_world), UPS_ERROR_INVALID_ARGUMENT, {"instance id 50"});
  good.to_world[5] = 0;
  expect_error(ups_scene_set_transform(scene, instance, good.to_world), UPS_ERROR_INVALID_ARGUMENT, {"singular"});
}

TEST_F(Api, LightFields) {
  using D = ups_light_desc;
  auto good = make(&ups_light_desc_init);
  good.kind = UPS_LIGHT_SPOT;
  const std::vector<Case<D>> cases = {
      {[](D& d) { d.kind = 3; }, {"kind is 3"}},
      {[](D& d) { d.intensity_rgb[0] = -1; }, {"intensity_rgb[0] is -1"}},
      {[](D& d) { d.inner_cone_rad = d.outer_cone_rad; }, {"inner_cone_rad", "less than outer_cone_rad"}},
      {[](D& d) { d.inner_cone_rad = -0.1f; }, {"inner_cone_rad is -0.1"}},
      {[](D& d) { d.outer_cone_rad = 2; }, {"outer_cone_rad is 2"}},
      {[](D& d) { d.outer_cone_rad = NAN; }, {"outer_cone_rad is nan"}},
  };
  expect_each_fails(scene, good, &ups_scene_add_light, cases + transform_cases<D>(), "ups_scene_add_light");
}

TEST_F(Api, LuminaireFields) {
  using D = ups_luminaire_desc;
  auto good = make(&ups_luminaire_desc_init);
  good.profile = profile;
  const std::vector<Case<D>> cases = {
      {[](D& d) { d.profile = nullptr; }, {"profile is NULL"}},
      {[](D& d) { d.use_opening = 2; }, {"use_opening is 2"}},
      {[](D& d) { d.color_rgb[0] = -1; }, {"color_rgb[0] is -1"}},
      {[](D& d) { d.color_rgb[0] = d.color_rgb[1] = d.color_rgb[2] = 0; }, {"color_rgb is black"}},
      {[](D& d) { d.flux_lm = NAN; }, {"flux_lm is nan"}},
      {[](D& d) { d.dimming = -0.5f; }, {"dimming is -0.5"}},
      {[](D& d) { d.intensity_scale = INFINITY; }, {"intensity_scale is inf"}},
  };
  expect_each_fails(scene, good, &ups_scene_add_luminaire, cases + transform_cases<D>(), "ups_scene_add_luminaire");
  ups_luminaire_id id{};
  EXPECT_OK(ups_scene_add_luminaire(scene, &good, &id));
  expect_error(ups_scene_set_dimming(scene, id, -1), UPS_ERROR_INVALID_ARGUMENT, {"dimming is -1"});
  expect_error(ups_scene_set_dimming(scene, {8}, 1), UPS_ERROR_INVALID_ARGUMENT, {"luminaire id 8", "none has"});
  expect_error(ups_scene_set_dimming(scene, {id.v + 8}, 1), UPS_ERROR_INVALID_ARGUMENT,
               {"luminaire id 10 is not of this scene; it has numbers 1 to 2"});
}

TEST_F(Api, CameraFields) {
  using D = ups_camera_desc;
  const std::vector<Case<D>> cases = {
      {[](D& d) { d.projection = 4; }, {"projection is 4", "UPS_PANORAMA"}},
      {[](D& d) { d.projection = -1; }, {"projection is -1"}},
      {[](D& d) { d.layers = 16; }, {"layers is 16", "15"}},
      {[](D& d) { d.reserved = 1; }, {"reserved is 1"}},
      {[](D& d) { d.width = 0; }, {"width is 0", "16384"}},
      {[](D& d) { d.height = 20000; }, {"height is 20000"}},
      {[](D& d) { d.vertical_fov_rad = 0; }, {"vertical_fov_rad is 0"}},
      {[](D& d) { d.vertical_fov_rad = 3.2f; }, {"vertical_fov_rad is 3.2", "pi"}},
      {[](D& d) { d.vertical_fov_rad = NAN; }, {"vertical_fov_rad is nan"}},
      {[](D& d) { d.vertical_fov_rad = 1e-22f; }, {"vertical_fov_rad is 1e-22", "1e-6"}},
      {[](D& d) { d.illuminance = -1; }, {"illuminance is -1"}},
  };
  expect_each_fails(scene, make(&ups_camera_desc_init), &ups_scene_add_camera, cases + transform_cases<D>(),
                    "ups_scene_add_camera");
}

TEST_F(Api, MeterFields) {
  using D = ups_meter_desc;
  double bad_position[6] = {0, 0, 0, 0, INFINITY, 0};
  float zero[6] = {0, 0, 1, 0, 0, 0}, nan[6] = {0, 0, 1, 0, NAN, 0}, along[6] = {1, 0, 0, 0, 0, 1};
  const std::vector<Case<D>> cases = {
      {[](D& d) { d.kind = 6; }, {"kind is 6"}},
      {[](D& d) { d.count = 0; }, {"count is 0"}},
      {[](D& d) { d.count = 16'777'217; }, {"count is 16777217"}},
      {[](D& d) { d.reserved = 3; }, {"reserved is 3"}},
      {[](D& d) { d.positions_m = nullptr; }, {"positions_m is NULL"}},
      {[](D& d) { d.normals = nullptr; }, {"normals is NULL"}},
      {[](D& d) { d.cell_size_m[0] = 1; }, {"cell_size_m is 1, 0"}},
      {[](D& d) { d.cell_size_m[0] = d.cell_size_m[1] = -1; }, {"cell_size_m is -1"}},
      {[](D& d) { d.cell_size_m[0] = d.cell_size_m[1] = 1e-23f; }, {"cell_size_m is 1e-23", "at least 1e-9"}},
      {[](D& d) { d.footprint_m = 1e-23f; }, {"footprint_m is 1e-23", "at least 1e-9"}},
      {[](D& d) { d.cell_size_m[0] = d.cell_size_m[1] = 1, d.tangents = nullptr; }, {"tangents is NULL"}},
      {[&](D& d) { d.positions_m = bad_position; }, {"positions_m: element 1, component 1 is inf"}},
      {[&](D& d) { d.normals = zero; }, {"normals: element 1 has length 0"}},
      {[&](D& d) { d.normals = nan; }, {"normals: element 1, component 1 is nan"}},
      {[&](D& d) { d.tangents = along; }, {"tangents: element 1 is parallel"}},
      {[&](D& d) { d.tangents = nan; }, {"tangents: element 1, component 1 is nan"}},
  };
  expect_each_fails(scene, meters(), &ups_scene_add_meters, cases, "ups_scene_add_meters");
  auto d = meters();
  d.kind = UPS_METER_SEMICYLINDRICAL;
  const float vertical[6] = {1, 0, 0, 0, 0, -2};
  d.normals = vertical, d.tangents = nullptr;
  ups_sensor_id id{};
  expect_error(ups_scene_add_meters(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT,
               {"normals: element 1 is vertical", "horizontal part"});
}

TEST_F(Api, NullScenes) {
  ups_scene* out = nullptr;
  expect_error(ups_scene_create(nullptr, &out), UPS_ERROR_INVALID_ARGUMENT, {"context is NULL"});
  expect_error(ups_scene_create(context, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"out is NULL"});
  expect_error(ups_scene_commit(nullptr), UPS_ERROR_INVALID_ARGUMENT, {"ups_scene_commit", "scene is NULL"});
  expect_error(ups_scene_get_info(nullptr, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"scene is NULL"});
  expect_error(ups_scene_set_dimming(nullptr, {1}, 1), UPS_ERROR_INVALID_ARGUMENT, {"scene is NULL"});
  expect_error(ups_scene_remove_sensor(nullptr, {1}), UPS_ERROR_INVALID_ARGUMENT, {"scene is NULL"});
  expect_error(ups_profile_get_info(nullptr, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"profile is NULL"});
  expect_error(ups_profile_parse(nullptr, "x", 1, 0, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"context is NULL"});
  expect_error(ups_context_pop_log(nullptr, nullptr, 0, nullptr, nullptr), UPS_ERROR_INVALID_ARGUMENT,
               {"context is NULL"});
}

}  // namespace
}  // namespace ups_test
