// Meters on surfaces: what their descs must say, where the committed scene has them, and what edits of the scene do.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <functional>

#include "fixture.h"

namespace ups_test {
namespace {

class MeterPlaces : public Api {
 protected:
  MeterPlaces() {
    auto with_uvs = quad();
    with_uvs.uvs = unit_uvs;
    EXPECT_OK(ups_scene_add_mesh(scene, &with_uvs, &mapped_mesh));
    auto d = make(&ups_instance_desc_init);
    d.mesh = mapped_mesh;
    d.to_world[11] = 1;
    EXPECT_OK(ups_scene_add_instance(scene, &d, &mapped));
  }
  ups_surface_meters_desc surface_of(const ups_instance_id& id) {
    auto d = make(&ups_surface_meters_desc_init);
    d.instances = &id, d.instance_count = 1;
    return d;
  }
  ups_lightmap_desc map_of(const ups_instance_id& id, uint32_t width = 2, uint32_t height = 2) {
    auto d = make(&ups_lightmap_desc_init);
    d.instances = &id, d.instance_count = 1;
    d.width = width, d.height = height;
    return d;
  }
  std::vector<ups_meter_place> places(ups_sensor_id id, size_t count) {
    std::vector<ups_meter_place> out(count);
    EXPECT_OK(ups_scene_read_meter_places(scene, id, out.data(), count, nullptr));
    return out;
  }
  std::string warnings() {
    size_t needed = 0;
    EXPECT_OK(ups_scene_get_text(scene, UPS_SCENE_TEXT_WARNINGS, nullptr, 0, &needed));
    std::string text(needed, 0);
    EXPECT_OK(ups_scene_get_text(scene, UPS_SCENE_TEXT_WARNINGS, text.data(), needed, &needed));
    return text;
  }
  float unit_uvs[8] = {0, 0, 1, 0, 1, 1, 0, 1};
  ups_mesh_id mapped_mesh{};
  ups_instance_id mapped{};
};

TEST_F(MeterPlaces, FieldsAreChecked) {
  ups_sensor_id id{};
  const auto expect_surface_fails = [&](ups_surface_meters_desc d, const std::vector<std::string>& words) {
    expect_error(ups_scene_add_surface_meters(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT, words);
  };
  const auto expect_map_fails = [&](ups_lightmap_desc d, const std::vector<std::string>& words) {
    expect_error(ups_scene_add_lightmap(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT, words);
  };
  auto s = surface_of(instance);
  s.instance_count = 0;
  expect_surface_fails(s, {"instance_count is 0"});
  s = surface_of(instance), s.instances = nullptr;
  expect_surface_fails(s, {"instances is NULL"});
  s = surface_of(instance), s.back = 2;
  expect_surface_fails(s, {"back is 2"});
  s = surface_of(instance), s.reserved = 4;
  expect_surface_fails(s, {"reserved is 4"});
  const ups_instance_id twice[] = {instance, mapped, instance}, none[] = {instance, {0}};
  s.instances = twice, s.instance_count = 3, s.reserved = 0;
  expect_surface_fails(s, {"instances[2]", "listed twice"});
  s.instances = none, s.instance_count = 2;
  expect_surface_fails(s, {"instances[1] is 0"});
  const ups_instance_id stranger{7};
  expect_surface_fails(surface_of(stranger), {"instances[0]", "id 7 is not of this scene"});
  expect_map_fails(map_of(instance), {"instance 1 has no uvs"});
  expect_map_fails(map_of(mapped, 0, 4), {"width is 0"});
  expect_map_fails(map_of(mapped, 4, 16385), {"height is 16385"});
  expect_map_fails(map_of(mapped, 16384, 16384), {"width * height is 268435456"});
  auto m = map_of(mapped);
  m.back = -1;
  expect_map_fails(m, {"back is -1"});
  m = map_of(mapped), m.reserved = 1;
  expect_map_fails(m, {"reserved is 1"});
  expect_error(ups_scene_add_lightmap(scene, nullptr, &id), UPS_ERROR_INVALID_ARGUMENT, {"desc is NULL"});
  expect_error(ups_scene_add_lightmap(scene, &m, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"out is NULL"});
  expect_error(ups_scene_add_surface_meters(nullptr, &s, &id), UPS_ERROR_INVALID_ARGUMENT, {"scene is NULL"});
  auto discs = meters();
  discs.footprint_m = -1;
  expect_error(ups_scene_add_meters(scene, &discs, &id), UPS_ERROR_INVALID_ARGUMENT, {"footprint_m is -1"});
  discs.footprint_m = 0.01f, discs.cell_size_m[0] = discs.cell_size_m[1] = 1;
  expect_error(ups_scene_add_meters(scene, &discs, &id), UPS_ERROR_INVALID_ARGUMENT,
               {"footprint_m is 0.01 beside cell_size_m"});
  EXPECT_EQ(id.v, 0u);
}

TEST_F(MeterPlaces, FollowTheirInstanceAtEachCommit) {
  ups_sensor_id surface{}, map{}, points{};
  const auto s = surface_of(instance);
  const auto m = map_of(mapped);
  const auto p = meters();
  EXPECT_OK(ups_scene_add_surface_meters(scene, &s, &surface));
  EXPECT_OK(ups_scene_add_lightmap(scene, &m, &map));
  EXPECT_OK(ups_scene_add_meters(scene, &p, &points));
  ups_meter_place one[4];
  size_t needed = 0;
  expect_error(ups_scene_read_meter_places(scene, surface, one, 2, &needed), UPS_ERROR_INVALID_STATE,
               {"never committed"});
  EXPECT_OK(ups_scene_commit(scene));
  EXPECT_OK(ups_scene_read_meter_places(scene, surface, nullptr, 0, &needed));
  EXPECT_EQ(needed, 2u);
  expect_error(ups_scene_read_meter_places(scene, surface, one, 1, &needed), UPS_ERROR_BUFFER_TOO_SMALL,
               {"capacity is 1", "2 places"});
  expect_error(ups_scene_read_meter_places(scene, surface, nullptr, 2, &needed), UPS_ERROR_INVALID_ARGUMENT,
               {"places is NULL"});
  expect_error(ups_scene_read_meter_places(scene, {99}, one, 2, &needed), UPS_ERROR_INVALID_ARGUMENT,
               {"sensor id 99"});
  const auto at = places(surface, 2);
  EXPECT_NEAR(at[0].position_m[0], 2 / 3.0, 1e-6);
  EXPECT_NEAR(at[1].position_m[1], 2 / 3.0, 1e-6);
  EXPECT_FLOAT_EQ(at[1].area_m2, 0.5f);
  EXPECT_EQ(at[1].triangle, 1u);
  EXPECT_FLOAT_EQ(at[1].normal[2], 1);
  const auto texels = places(map, 4);
  EXPECT_NEAR(texels[3].position_m[0], 0.75, 1e-6);
  EXPECT_NEAR(texels[3].position_m[2], 1, 1e-6);
  EXPECT_FLOAT_EQ(texels[3].area_m2, 0.25f);
  EXPECT_EQ(texels[1].triangle, 0u);
  EXPECT_EQ(texels[2].triangle, 1u);
  const auto given = places(points, 2);
  EXPECT_EQ(given[1].position_m[0], 0.5);
  EXPECT_EQ(given[1].area_m2, 0);
  EXPECT_EQ(given[1].triangle, UINT32_MAX);
  EXPECT_EQ(given[1].valid, 1);
  auto info = ups_scene_info{};
  info.struct_size = sizeof info;
  EXPECT_OK(ups_scene_get_info(scene, &info));
  EXPECT_EQ(info.meter_count, 8u);

  const double mirrored[12] = {-2, 0, 0, 5, 0, 1, 0, 0, 0, 0, 1, 3};  // the front stays in front
  EXPECT_OK(ups_scene_set_transform(scene, instance, mirrored));
  EXPECT_NEAR(places(surface, 2)[0].position_m[0], 2 / 3.0, 1e-6) << "not committed yet";
  EXPECT_OK(ups_scene_commit(scene));
  const auto moved = places(surface, 2);
  EXPECT_NEAR(moved[0].position_m[0], 5 - 4 / 3.0, 1e-6);
  EXPECT_FLOAT_EQ(moved[0].area_m2, 1);
  EXPECT_FLOAT_EQ(moved[0].normal[2], 1);

  EXPECT_OK(ups_scene_remove_instance(scene, instance));
  expect_error(ups_scene_commit(scene), UPS_ERROR_INVALID_ARGUMENT,
               {"sensor id 1", "measures instance 1", "removed", "remove the sensor"});
  EXPECT_OK(ups_scene_remove_sensor(scene, surface));
  EXPECT_OK(ups_scene_commit(scene));
}

TEST_F(MeterPlaces, BacksLookTheOtherWay) {
  auto d = surface_of(instance);
  d.back = 1;
  ups_sensor_id id{};
  EXPECT_OK(ups_scene_add_surface_meters(scene, &d, &id));
  EXPECT_OK(ups_scene_commit(scene));
  EXPECT_FLOAT_EQ(places(id, 2)[0].normal[2], -1);
}

// Samples, warnings and readings name a meter by its triangle, whatever has no area before it.
TEST_F(MeterPlaces, TrianglesWithoutAreaKeepTheirNumbers) {
  const uint32_t with_flat[9] = {1, 1, 2, 0, 1, 2, 0, 2, 3};
  auto d = quad();
  d.indices = with_flat, d.triangle_count = 3;
  ups_mesh_id mesh{};
  EXPECT_OK(ups_scene_add_mesh(scene, &d, &mesh));
  auto i = make(&ups_instance_desc_init);
  i.mesh = mesh, i.to_world[11] = 2;
  ups_instance_id id{};
  EXPECT_OK(ups_scene_add_instance(scene, &i, &id));
  auto light = make(&ups_light_desc_init);
  light.to_world[3] = 0.3, light.to_world[7] = 0.4, light.to_world[11] = 3;
  for (float& cd : light.intensity_rgb) cd = 100;
  ups_luminaire_id lamp{};
  EXPECT_OK(ups_scene_add_light(scene, &light, &lamp));
  const auto s = surface_of(id);
  ups_sensor_id set{};
  EXPECT_OK(ups_scene_add_surface_meters(scene, &s, &set));
  EXPECT_OK(ups_scene_commit(scene));
  for (const ups_method method : {UPS_METHOD_LIGHT_TRACING, UPS_METHOD_PATH_TRACING}) {
    auto r = make(&ups_render_desc_init);
    r.method = method, r.iteration_count = 4;
    ups_result* result = nullptr;
    ASSERT_EQ(ups_render(scene, &r, &result), UPS_OK) << ups_last_error();
    ups_meter_reading readings[3];
    EXPECT_OK(ups_result_read_meters(result, set, readings, 3));
    EXPECT_EQ(readings[0].illuminance_lx, 0);
    EXPECT_EQ(readings[0].error_bound_lx, 0);
    EXPECT_GT(readings[1].illuminance_lx, 0);
    EXPECT_GT(readings[2].illuminance_lx, 0);
    expect_error(ups_result_read_meters(result, set, readings, 2), UPS_ERROR_INVALID_ARGUMENT,
                 {"count is 2", "3 meters"});
    ups_sample samples[8];
    size_t count = 0;
    EXPECT_OK(ups_result_read_largest_samples(result, set, samples, 8, &count));
    ASSERT_EQ(count, 2u);
    for (size_t k = 0; k < count; ++k) {
      EXPECT_GE(samples[k].index, 1u);
      ups_path* path = nullptr;
      ASSERT_EQ(ups_replay(scene, &r, &samples[k], &path), UPS_OK) << ups_last_error();
      ups_path_info info{};
      info.struct_size = sizeof info;
      EXPECT_OK(ups_path_get_info(path, &info));
      EXPECT_NEAR(double(info.value), double(samples[k].value), 1e-4 * double(samples[k].value));
      ups_path_destroy(path);
    }
    ups_path* path = nullptr;
    samples[0].index = 0;
    expect_error(ups_replay(scene, &r, &samples[0], &path), UPS_ERROR_INVALID_ARGUMENT, {"no area to measure on"});
    samples[0].index = 3;
    expect_error(ups_replay(scene, &r, &samples[0], &path), UPS_ERROR_INVALID_ARGUMENT, {"index is 3", "3 meters"});
    ups_result_destroy(result);
  }
}

TEST_F(MeterPlaces, MapsSayWhatTheyDoNotMeasure) {
  const auto add = [&](const std::vector<float>& uvs) {
    auto d = quad();
    d.uvs = uvs.data();
    ups_mesh_id mesh{};
    EXPECT_OK(ups_scene_add_mesh(scene, &d, &mesh));
    auto i = make(&ups_instance_desc_init);
    i.mesh = mesh;
    ups_instance_id id{};
    EXPECT_OK(ups_scene_add_instance(scene, &i, &id));
    return id;
  };
  ups_sensor_id half{}, twice{}, flat{}, outside{};
  const ups_instance_id beyond = add({0.5f, 0, 1.5f, 0, 1.5f, 1, 0.5f, 1}), folded = add({0, 0, 1, 0, 0, 1, 1, 0}),
                        line = add({0, 0, 1, 0, 1, 1, 0.5f, 0.5f}), away = add({2, 2, 3, 2, 3, 3, 2, 3});
  auto d = map_of(beyond, 4, 4);
  EXPECT_OK(ups_scene_add_lightmap(scene, &d, &half));
  d = map_of(folded, 4, 4);
  EXPECT_OK(ups_scene_add_lightmap(scene, &d, &twice));
  d = map_of(line, 4, 4);
  EXPECT_OK(ups_scene_add_lightmap(scene, &d, &flat));
  EXPECT_OK(ups_scene_commit(scene));
  const std::string text = warnings();
  for (const char* part : {"lightmap 1: 0.5 of 1 m^2 of the surface is not measured", "outside the unit square",
                           "lightmap 2: different triangles overlap in", "triangles 0 and 1",
                           "lightmap 3: 0.5 of 1 m^2", "1 of its triangles have no area in UV"})
    EXPECT_NE(text.find(part), std::string::npos) << "'" << part << "' not in: " << text;
  const auto texels = places(half, 16);
  EXPECT_EQ(texels[0].valid, 0);
  EXPECT_EQ(texels[0].area_m2, 0);
  EXPECT_EQ(texels[0].triangle, UINT32_MAX);
  EXPECT_EQ(texels[3].valid, 1);
  d = map_of(away, 4, 4);
  EXPECT_OK(ups_scene_add_lightmap(scene, &d, &outside));
  expect_error(ups_scene_commit(scene), UPS_ERROR_INVALID_ARGUMENT, {"sensor id 4", "no texel", "unit square"});
}

// As with the UVs of a tiled texture: each of many surfaces over the whole of it.
TEST_F(MeterPlaces, MapsThatSurfacesCoverManyTimesAreRefused) {
  const float unit[] = {0, 0, 1, 0, 1, 1, 0, 1};
  auto mesh_desc = quad();
  mesh_desc.uvs = unit;
  ups_mesh_id mesh{};
  EXPECT_OK(ups_scene_add_mesh(scene, &mesh_desc, &mesh));
  auto i = make(&ups_instance_desc_init);
  i.mesh = mesh;
  std::vector<ups_instance_id> ids(5);
  for (ups_instance_id& id : ids) EXPECT_OK(ups_scene_add_instance(scene, &i, &id));
  auto d = map_of(ids[0], 16, 16);
  ups_sensor_id map{};
  d.instances = ids.data(), d.instance_count = 4;
  EXPECT_OK(ups_scene_add_lightmap(scene, &d, &map));
  EXPECT_OK(ups_scene_commit(scene));
  d.instance_count = 5;
  EXPECT_OK(ups_scene_set_lightmap(scene, map, &d));
  expect_error(ups_scene_commit(scene), UPS_ERROR_INVALID_ARGUMENT, {"lightmap 1", "more than 4 times over", "UVs"});
}

// A map of which only half the texels are on the mesh.
TEST_F(MeterPlaces, AViewHasTheMetersThatReadingHas) {
  for (float& u : unit_uvs) u *= 0.5f;
  auto with_uvs = quad();
  with_uvs.uvs = unit_uvs;
  EXPECT_OK(ups_scene_set_mesh(scene, mapped_mesh, &with_uvs));
  auto light = make(&ups_luminaire_desc_init);
  light.profile = profile, light.to_world[11] = 3;
  ups_luminaire_id lamp;
  EXPECT_OK(ups_scene_add_luminaire(scene, &light, &lamp));
  ups_sensor_id id;
  const auto map = map_of(mapped, 4, 4);
  EXPECT_OK(ups_scene_add_lightmap(scene, &map, &id));
  EXPECT_OK(ups_scene_commit(scene));
  auto d = make(&ups_render_desc_init);
  d.iteration_count = 16;
  ups_result* result = nullptr;
  EXPECT_OK(ups_render(scene, &d, &result));
  std::vector<ups_meter_reading> read(16);
  EXPECT_OK(ups_result_read_meters(result, id, read.data(), read.size()));
  const ups_meter_reading *seen = nullptr, *again = nullptr;
  size_t count = 0;
  EXPECT_OK(ups_result_view_meters(result, id, &seen, &count));
  ASSERT_EQ(count, 16u);
  EXPECT_EQ(std::memcmp(seen, read.data(), sizeof(ups_meter_reading) * count), 0);
  EXPECT_EQ(std::count_if(read.begin(), read.end(), [](const auto& r) { return r.illuminance_lx > 0; }), 4);
  EXPECT_OK(ups_result_view_meters(result, id, &again, &count));
  EXPECT_EQ(again, seen);
  ups_result_destroy(result);
}

}  // namespace
}  // namespace ups_test
