// Scenes of ups.hpp: what was added is asked for, set and removed by ids that stay.
#include <cmath>
#include <limits>

#include "room.h"

namespace {

template <class Call>
void expect_removed(Call call) {
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"removed"}, call);
}

TEST(Edits, OfTexturesAndMaterials) {
  Room room;
  ups::Scene &scene = room.scene;
  const std::vector<float> texels = {0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f};
  const auto texture = scene.add_texture({2, 1, 3, texels});
  EXPECT_EQ(scene.get_texture(texture).width, 2u);
  EXPECT_EQ(scene.read_texture(texture), texels);
  scene.set_texture(texture, {1, 2, 3, texels});
  EXPECT_EQ(scene.get_texture(texture).height, 2u);

  ups::MaterialDesc material = scene.get_material(room.material);
  EXPECT_EQ(material.reflectance_rgb[1], 0.6f);
  material.model = UPS_MATERIAL_GLAZING;
  material.reflectance_texture = {};
  const std::vector<float> angles = {0, 90}, transmittances = {0.8f, 0}, reflectances = {0.1f, 1};
  material.set_pane(angles, transmittances, reflectances);
  scene.set_material(room.material, material);
  const ups::MaterialDesc pane = scene.get_material(room.material);
  ASSERT_EQ(pane.pane_angle_count, 2u);
  EXPECT_EQ(pane.pane_reflectance[0], 0.1f);

  const auto textured = [&] {
    ups::MaterialDesc desc;
    desc.reflectance_texture = texture;
    return scene.add_material(desc);
  }();
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"material"}, [&] { scene.remove_texture(texture); });
  scene.remove_material(textured);
  scene.remove_texture(texture);
  expect_removed([&] { scene.get_texture(texture); });
  expect_removed([&] { scene.get_material(textured); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"values", "5 values; expected 6"},
               [&] { ups::TextureDesc(2, 1, 3, {texels.data(), 5}); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"reflectances", "expected 2"},
               [&] { material.set_pane(angles, transmittances, texels); });
}

TEST(Edits, OfMeshesAndInstances) {
  Room room;
  ups::Scene &scene = room.scene;
  ups::MeshDesc mesh = scene.get_mesh(room.mesh);
  EXPECT_EQ(mesh.vertex_count, 8u);
  EXPECT_EQ(mesh.triangle_count, 12u);
  EXPECT_EQ(mesh.normals, nullptr);
  const std::vector<float> normals = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1};
  mesh.set_normals(normals);
  mesh.set_uvs(std::vector<float>());
  EXPECT_EQ(mesh.uvs, nullptr);
  scene.set_mesh(room.mesh, mesh);
  std::vector<float> higher = room.positions;
  for (std::size_t i = 14; i < higher.size(); i += 3) higher[i] = 3;
  scene.set_mesh_vertices(room.mesh, higher);
  EXPECT_EQ(scene.get_mesh(room.mesh).positions_m[14], 3);
  EXPECT_EQ(scene.get_mesh(room.mesh).normals[14], -1);
  scene.set_transform(room.instance, ups::Transform::translation(0, 0, 0.5));
  EXPECT_EQ(scene.get_instance(room.instance).to_world[11], 0.5);
  scene.commit();
  EXPECT_EQ(scene.get_info().bounds_max_m[2], 3.5);

  ups::InstanceDesc instance = scene.get_instance(room.instance);
  instance.group = 4;
  scene.set_instance(room.instance, instance);
  EXPECT_EQ(scene.get_instance(room.instance).group, 4u);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"instance"}, [&] { scene.remove_mesh(room.mesh); });
  scene.remove_instance(room.instance);
  scene.remove_mesh(room.mesh);
  expect_removed([&] { scene.get_mesh(room.mesh); });
  expect_removed([&] { scene.set_transform(room.instance, ups::Transform()); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"positions", "multiple of 3"},
               [&] { ups::MeshDesc({room.positions.data(), 4}, room.indices, room.material); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"normals", "3 values; expected 24"},
               [&] { mesh.set_normals({normals.data(), 3}); });
}

TEST(Edits, OfLuminairesAndLights) {
  Room room;
  ups::Scene &scene = room.scene;
  ups::LuminaireDesc lamp = scene.get_luminaire(room.lamp);
  EXPECT_EQ(lamp.to_world[11], 2.4);
  lamp.flux_lm = 500;  // its profile stays
  scene.set_luminaire(room.lamp, lamp);
  scene.set_luminaire_transform(room.lamp, ups::Transform::aim({1, 1, 2.4}, {2, 1, 0.75}));
  scene.set_dimming(room.lamp, 0.5f);
  EXPECT_EQ(scene.get_luminaire(room.lamp).to_world[3], 1);
  EXPECT_EQ(scene.get_luminaire_profile(room.lamp).get_info().peak_cd, 1000);
  scene.set_maintenance_factor(0.8);
  EXPECT_EQ(scene.get_maintenance_factor(), 0.8);

  ups::LightDesc light(UPS_LIGHT_SPOT, ups::Transform::translation(3, 1, 2));
  light.inner_cone_rad = 0.1f;
  light.outer_cone_rad = 0.2f;
  const auto spot = scene.add_light(light);
  light.outer_cone_rad = 0.3f;
  scene.set_light(spot, light);
  EXPECT_EQ(scene.get_light(spot).outer_cone_rad, 0.3f);
  scene.commit();
  const auto sources = scene.sources();
  ASSERT_EQ(sources.size(), 2u);
  const ups_profile_info info = scene.get_luminaire_profile(room.lamp).get_info();
  EXPECT_NEAR(sources[0].flux_lm, 500 * 0.5 * 0.8 * info.interpolated_flux_lm / info.flux_lm, 1e-3);
  EXPECT_EQ(sources[1].light_kind, UPS_LIGHT_SPOT);
  EXPECT_EQ(scene.get_source_profile(0).get_info().peak_cd, 1000);
  scene.remove_luminaire(spot);
  scene.remove_luminaire(room.lamp);
  expect_removed([&] { scene.get_dimming(room.lamp); });
  expect_removed([&] { scene.get_light(spot); });
}

TEST(Edits, OfSensors) {
  Room room;
  ups::Scene &scene = room.scene;
  ups::CameraDesc camera = scene.get_camera(room.camera);
  camera.width = 10;
  scene.set_camera(room.camera, camera);
  EXPECT_EQ(scene.get_camera(room.camera).width, 10u);
  ups::MeterDesc meters = scene.get_meters(room.meters);
  EXPECT_EQ(meters.positions_m[3], 3);
  const std::vector<float> sides = {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0};
  meters.set_cells(sides, 0.5f, 0.25f);
  scene.set_meters(room.meters, meters);
  EXPECT_EQ(scene.get_meters(room.meters).cell_size_m[1], 0.25f);

  const std::vector<ups_instance_id> instances = {room.instance};
  const auto surface = scene.add_surface_meters(ups::SurfaceMetersDesc(instances));
  ups::SurfaceMetersDesc back = scene.get_surface_meters(surface);
  back.back = 1;
  scene.set_surface_meters(surface, back);
  EXPECT_EQ(scene.get_surface_meters(surface).instances[0].v, room.instance.v);
  ups::MeshDesc mesh = scene.get_mesh(room.mesh);
  const std::vector<float> uvs = {0, 0, 1, 0, 1, 1, 0, 1, 0, 0, 1, 0, 1, 1, 0, 1};
  mesh.set_uvs(uvs);
  scene.set_mesh(room.mesh, mesh);
  const auto lightmap = scene.add_lightmap({instances, 4, 4});
  ups::LightmapDesc finer = scene.get_lightmap(lightmap);
  finer.width = 8;
  scene.set_lightmap(lightmap, finer);
  const std::vector<float> c_deg = {0, 90, 180, 270}, gamma_deg = {0, 45, 90, 135, 180};
  const auto goniometer = scene.add_goniometer({c_deg, gamma_deg});
  scene.set_goniometer(goniometer, scene.get_goniometer(goniometer));
  EXPECT_EQ(scene.get_goniometer(goniometer).gamma_count, 5u);
  const auto observer = scene.add_observer(ups::ObserverDesc(ups::Transform::look_at({1, 1, 1.2}, {3, 1, 1.2})));
  ups::ObserverDesc eye = scene.get_observer(observer);
  eye.position_index = UPS_POSITION_INDEX_GUTH;
  scene.set_observer(observer, eye);
  EXPECT_EQ(scene.get_observer(observer).position_index, UPS_POSITION_INDEX_GUTH);
  scene.commit();
  EXPECT_EQ(scene.read_meter_places(surface).size(), 12u);
  EXPECT_EQ(scene.read_meter_places(lightmap).size(), 32u);
  for (const auto sensor : {room.camera, room.meters, surface, lightmap, goniometer, observer})
    scene.remove_sensor(sensor);
  expect_removed([&] { scene.get_camera(room.camera); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"directions", "6 values; expected 12"},
               [&] { ups::MeterDesc(room.points, {room.up.data(), 6}); });
}

TEST(Committed, ScenesTellWhatTheyAre) {
  Room room;
  EXPECT_TRUE(room.scene.is_dirty());
  expect_error(UPS_ERROR_INVALID_STATE, {}, [&] { room.scene.get_info(); });
  room.scene.commit();
  EXPECT_FALSE(room.scene.is_dirty());
  EXPECT_EQ(room.scene.get_info().triangle_count, 12u);
  EXPECT_NE(room.scene.get_text(UPS_SCENE_TEXT_TECHNIQUES), "");
  const auto section = room.scene.read_section({2, 1.5, 1}, {0, 0, 1});
  double length = 0;
  for (const ups_segment &s : section) length += std::hypot(s.to_m[0] - s.from_m[0], s.to_m[1] - s.from_m[1]);
  EXPECT_NEAR(length, 14, 1e-5) << "around the walls";
  EXPECT_FALSE(room.scene.read_outlines({2, 1.5, 2}, {0, 0, 1}).empty());
  EXPECT_TRUE(room.scene.read_outlines({2, 1.5, -1}, {0, 0, 1}, 0.5).empty()) << "nothing is beneath the floor";
  EXPECT_GT(room.scene.estimate_memory(Room::few()).peak_bytes, 0u);
}

}  // namespace
