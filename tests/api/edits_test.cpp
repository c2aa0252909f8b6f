// What was added is set, asked for and removed by an id that stays.
#include <unistd.h>

#include <cmath>
#include <cstdio>

#include "edited_room.h"

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
extern "C" size_t __sanitizer_get_current_allocated_bytes();  // g++ 12 has no header of it
#endif

using namespace ups_test;

namespace {

class Edits : public Api {
 protected:
  long resident_kb() {
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
    return long(__sanitizer_get_current_allocated_bytes() / 1024);  // they keep what was freed, to find uses of it
#else
    long total = 0, resident = 0;
    if (FILE* file = std::fopen("/proc/self/statm", "r")) {
      EXPECT_EQ(std::fscanf(file, "%ld %ld", &total, &resident), 2);
      std::fclose(file);
    }
    return resident * (sysconf(_SC_PAGESIZE) / 1024);
#endif
  }
  // An emitter of 100 lm and a reflector.
  ups_fixture* lamp_in_a_cup() {
    ups_fixture* fixture = nullptr;
    EXPECT_OK(ups_fixture_create(context, &fixture));
    auto cob = make(&ups_fixture_emitter_desc_init);
    cob.radius_m = 0.01, cob.flux_lm = 100;
    EXPECT_OK(ups_fixture_add_emitter(fixture, &cob, nullptr));
    auto cup = make(&ups_reflector_desc_init);
    cup.focal_length_m = 0.02, cup.aperture_radius_m = 0.06;
    EXPECT_OK(ups_fixture_add_reflector(fixture, &cup, nullptr));
    return fixture;
  }
};

}  // namespace

TEST_F(Edits, ATextureComesBackAsItWasGiven) {
  auto d = sized<ups_texture_desc>();
  EXPECT_OK(ups_scene_get_texture(scene, texture, &d));
  EXPECT_EQ(d.width, 2u);
  EXPECT_EQ(d.height, 2u);
  EXPECT_EQ(d.channel_count, 3u);
  EXPECT_EQ(d.texels, nullptr);
  size_t needed = 0;
  EXPECT_OK(ups_scene_read_texture(scene, texture, nullptr, 0, &needed));
  ASSERT_EQ(needed, 12u);
  std::vector<float> read(12);
  EXPECT_OK(ups_scene_read_texture(scene, texture, read.data(), 12, nullptr));
  EXPECT_EQ(read, std::vector<float>(texels, texels + 12));
  EXPECT_EQ(ups_scene_read_texture(scene, texture, read.data(), 11, nullptr), UPS_ERROR_BUFFER_TOO_SMALL);
  d.width = 1, d.height = 1, d.channel_count = 1, d.texels = texels + 5;
  EXPECT_OK(ups_scene_set_texture(scene, texture, &d));
  EXPECT_OK(ups_scene_read_texture(scene, texture, read.data(), 1, nullptr));
  EXPECT_EQ(read[0], texels[5]);
}

TEST_F(Edits, ATextureKeepsToWhatItsMaterialsWant) {
  auto d = make(&ups_material_desc_init);
  d.normal_texture = texture;
  ups_material_id bumpy;
  EXPECT_OK(ups_scene_add_material(scene, &d, &bumpy));
  EXPECT_OK(ups_scene_commit(scene));
  auto grey = texture_desc();
  grey.channel_count = 1;
  expect_error(ups_scene_set_texture(scene, texture, &grey), UPS_ERROR_INVALID_ARGUMENT,
               {"material 2", "normal_texture", "1 channel"});
  auto now = sized<ups_texture_desc>();
  EXPECT_OK(ups_scene_get_texture(scene, texture, &now));
  EXPECT_EQ(now.channel_count, 3u) << "as it was";
  int32_t dirty = -1;
  EXPECT_OK(ups_scene_is_dirty(scene, &dirty));
  EXPECT_EQ(dirty, 0) << "nothing has changed";
}

TEST_F(Edits, AMaterialComesBackWithItsTable) {
  const float angle[3] = {0, 60, 90}, t[3] = {0.8f, 0.7f, 0}, r[3] = {0.1f, 0.2f, 1};
  auto d = make(&ups_material_desc_init);
  d.model = UPS_MATERIAL_GLAZING, d.ior = 1.6f, d.priority = 3;
  d.pane_angle_deg = angle, d.pane_transmittance = t, d.pane_reflectance = r, d.pane_angle_count = 3;
  EXPECT_OK(ups_scene_set_material(scene, material, &d));
  auto back = sized<ups_material_desc>();
  EXPECT_OK(ups_scene_get_material(scene, material, &back));
  for (int i = 0; i < 3; ++i) {
    EXPECT_EQ(back.pane_angle_deg[i], angle[i]);
    EXPECT_EQ(back.pane_transmittance[i], t[i]);
    EXPECT_EQ(back.pane_reflectance[i], r[i]);
  }
  EXPECT_OK(ups_scene_set_material(scene, material, &back)) << "the scene's own arrays";
  back.pane_angle_deg = back.pane_transmittance = back.pane_reflectance = d.pane_angle_deg = d.pane_transmittance =
      d.pane_reflectance = nullptr;
  EXPECT_EQ(std::memcmp(&back, &d, sizeof d), 0);
}

TEST_F(Edits, AMeshComesBackAndIsSet) {
  auto d = sized<ups_mesh_desc>();
  EXPECT_OK(ups_scene_get_mesh(scene, mesh, &d));
  EXPECT_EQ(d.vertex_count, 4u);
  EXPECT_EQ(d.triangle_count, 2u);
  EXPECT_EQ(d.material.v, material.v);
  EXPECT_EQ(std::memcmp(d.positions_m, positions, sizeof positions), 0);
  EXPECT_EQ(std::memcmp(d.indices, indices, sizeof indices), 0);
  EXPECT_EQ(d.normals, nullptr);
  d.triangle_count = 1, d.uvs = uvs, d.normals = normals, d.tangents = tangents;
  EXPECT_OK(ups_scene_set_mesh(scene, mesh, &d));
  EXPECT_OK(ups_scene_get_mesh(scene, mesh, &d));
  EXPECT_EQ(d.triangle_count, 1u);
  EXPECT_EQ(std::memcmp(d.normals, normals, sizeof normals), 0);
  positions[0] = -1;
  EXPECT_OK(ups_scene_set_mesh_vertices(scene, mesh, positions, nullptr, 4));
  EXPECT_OK(ups_scene_get_mesh(scene, mesh, &d));
  EXPECT_EQ(d.positions_m[0], -1);
  EXPECT_EQ(std::memcmp(d.normals, normals, sizeof normals), 0) << "as they were";
  expect_error(ups_scene_set_mesh_vertices(scene, mesh, positions, nullptr, 3), UPS_ERROR_INVALID_ARGUMENT,
               {"vertex_count is 3", "4 vertices"});
  positions[1] = NAN;
  expect_error(ups_scene_set_mesh_vertices(scene, mesh, positions, nullptr, 4), UPS_ERROR_INVALID_ARGUMENT,
               {"positions_m", "nan"});
}

TEST_F(Edits, LuminairesAndLightsAreSetAsWhatTheyAre) {
  EditedRoom r(context);
  auto l = sized<ups_luminaire_desc>();
  EXPECT_OK(ups_scene_get_luminaire(r.scene, r.opening, &l));
  EXPECT_EQ(l.profile, nullptr);
  EXPECT_EQ(l.use_opening, 1);
  EXPECT_EQ(l.to_world[11], 3.5);
  EXPECT_EQ(l.flux_lm, -1);
  l.group = 5, l.flux_lm = 800;
  EXPECT_OK(ups_scene_set_luminaire(r.scene, r.opening, &l)) << "with the profile that it has";
  ups_profile* had = nullptr;
  EXPECT_OK(ups_scene_get_luminaire_profile(r.scene, r.opening, &had));
  auto info = sized<ups_profile_info>();
  EXPECT_OK(ups_profile_get_info(had, &info));
  EXPECT_EQ(info.peak_cd, 900);
  ups_profile_destroy(had);
  l.profile = profile;
  EXPECT_OK(ups_scene_set_luminaire(r.scene, r.opening, &l));
  EXPECT_OK(ups_scene_get_luminaire_profile(r.scene, r.opening, &had));
  EXPECT_OK(ups_profile_get_info(had, &info));
  EXPECT_EQ(info.peak_cd, 1);
  ups_profile_destroy(had);
  EXPECT_OK(ups_scene_get_luminaire(r.scene, r.opening, &l));
  EXPECT_EQ(l.group, 5u);
  EXPECT_EQ(l.flux_lm, 800);
  auto light = sized<ups_light_desc>();
  expect_error(ups_scene_get_light(r.scene, r.opening, &light), UPS_ERROR_INVALID_ARGUMENT, {"not a light"});
  expect_error(ups_scene_set_luminaire(r.scene, r.spot, &l), UPS_ERROR_INVALID_ARGUMENT, {"not a luminaire"});
  EXPECT_OK(ups_scene_set_dimming(r.scene, r.spot, 0.5f));
  EXPECT_OK(ups_scene_get_light(r.scene, r.spot, &light));
  light.kind = UPS_LIGHT_POINT;
  EXPECT_OK(ups_scene_set_light(r.scene, r.spot, &light));
  float dimming = 0;
  EXPECT_OK(ups_scene_get_dimming(r.scene, r.spot, &dimming));
  EXPECT_EQ(dimming, 0.5f);
  double factor = 0;
  EXPECT_OK(ups_scene_set_maintenance_factor(r.scene, 0.7));
  EXPECT_OK(ups_scene_get_maintenance_factor(r.scene, &factor));
  EXPECT_EQ(factor, 0.7);
}

TEST_F(Edits, SensorsKeepTheirKind) {
  EditedRoom r(context);
  auto camera = sized<ups_camera_desc>();
  EXPECT_OK(ups_scene_get_camera(r.scene, r.camera, &camera));
  camera.width = 8, camera.layers = UPS_LAYER_ID;
  EXPECT_OK(ups_scene_set_camera(r.scene, r.camera, &camera));
  EXPECT_OK(ups_scene_get_camera(r.scene, r.camera, &camera));
  EXPECT_EQ(camera.width, 8u);
  EXPECT_EQ(camera.layers, uint32_t(UPS_LAYER_ID));
  expect_error(ups_scene_set_camera(r.scene, r.meters, &camera), UPS_ERROR_INVALID_ARGUMENT,
               {"set of meters", "not a camera"});
  auto m = sized<ups_meter_desc>();
  EXPECT_OK(ups_scene_get_meters(r.scene, r.meters, &m));
  EXPECT_EQ(m.count, 2u);
  EXPECT_EQ(m.positions_m[3], 3);
  EXPECT_EQ(m.normals[5], 1);
  auto s = sized<ups_surface_meters_desc>();
  EXPECT_OK(ups_scene_get_surface_meters(r.scene, r.surface, &s));
  EXPECT_EQ(s.instance_count, 1u);
  EXPECT_EQ(s.instances[0].v, r.first.v);
  auto map = sized<ups_lightmap_desc>();
  expect_error(ups_scene_get_lightmap(r.scene, r.surface, &map), UPS_ERROR_INVALID_ARGUMENT, {"not a lightmap"});
  expect_error(ups_scene_get_lightmap(r.scene, r.meters, &map), UPS_ERROR_INVALID_ARGUMENT,
               {"set of meters", "not a lightmap"});
  auto d = make(&ups_lightmap_desc_init);
  d.instance_count = 1, d.instances = &r.panel, d.width = d.height = 3;
  ups_sensor_id id{};
  EXPECT_OK(ups_scene_add_lightmap(r.scene, &d, &id));
  EXPECT_OK(ups_scene_get_lightmap(r.scene, id, &map));
  EXPECT_EQ(map.width, 3u);
  map.back = 1;
  EXPECT_OK(ups_scene_set_lightmap(r.scene, id, &map));
  const float c_deg[2] = {0, 90};
  auto g = make(&ups_goniometer_desc_init);
  g.c_deg = c_deg, g.c_count = 2;
  EXPECT_OK(ups_scene_add_goniometer(r.scene, &g, &id));
  auto back = sized<ups_goniometer_desc>();
  EXPECT_OK(ups_scene_get_goniometer(r.scene, id, &back));
  EXPECT_EQ(back.c_deg[1], 90);
  EXPECT_EQ(back.gamma_deg, nullptr);
  EXPECT_EQ(back.gamma_count, 73u);
  EXPECT_OK(ups_scene_set_goniometer(r.scene, id, &back));
  auto o = make(&ups_observer_desc_init);
  EXPECT_OK(ups_scene_add_observer(r.scene, &o, &id));
  o.position_index = UPS_POSITION_INDEX_GUTH;
  EXPECT_OK(ups_scene_set_observer(r.scene, id, &o));
  auto eye = sized<ups_observer_desc>();
  EXPECT_OK(ups_scene_get_observer(r.scene, id, &eye));
  EXPECT_EQ(eye.position_index, UPS_POSITION_INDEX_GUTH);
  EXPECT_OK(ups_scene_commit(r.scene));
}

TEST_F(Edits, WhatOthersNeedIsNotRemoved) {
  auto d = make(&ups_material_desc_init);
  d.alpha_texture = texture;
  EXPECT_OK(ups_scene_set_material(scene, material, &d));
  expect_error(ups_scene_remove_texture(scene, texture), UPS_ERROR_INVALID_ARGUMENT, {"texture", "material 1"});
  expect_error(ups_scene_remove_material(scene, material), UPS_ERROR_INVALID_ARGUMENT, {"material", "mesh 1"});
  expect_error(ups_scene_remove_mesh(scene, mesh), UPS_ERROR_INVALID_ARGUMENT, {"mesh", "instance 1"});
  EXPECT_OK(ups_scene_remove_instance(scene, instance));
  EXPECT_OK(ups_scene_remove_mesh(scene, mesh));
  EXPECT_OK(ups_scene_remove_material(scene, material));
  EXPECT_OK(ups_scene_remove_texture(scene, texture));
  expect_error(ups_scene_remove_texture(scene, texture), UPS_ERROR_INVALID_ARGUMENT, {"was removed"});
  expect_error(ups_scene_set_material(scene, material, &d), UPS_ERROR_INVALID_ARGUMENT, {"was removed"});
  auto m = sized<ups_mesh_desc>();
  expect_error(ups_scene_get_mesh(scene, mesh, &m), UPS_ERROR_INVALID_ARGUMENT, {"was removed"});
  ups_material_id fresh;
  EXPECT_OK(ups_scene_add_material(scene, &(d = make(&ups_material_desc_init)), &fresh));
  EXPECT_NE(fresh.v, material.v) << "an id never comes back";
  EXPECT_OK(ups_scene_commit(scene));
}

TEST_F(Edits, GapsOfRemovedThingsAreHarmless) {
  EditedRoom r(context);
  ups_texture_id t;
  EXPECT_OK(ups_scene_add_texture(r.scene, &texture_desc(), &t));
  const ups_material_id unused = r.add(make(&ups_material_desc_init));
  const ups_mesh_id sheet = r.add_sheet(r.wall, 3, 1);
  auto d = make(&ups_material_desc_init);
  d.reflectance_texture = t;
  const ups_material_id textured = r.add(d);
  r.add_instance(r.add_sheet(textured, 2, 0.5f), 1, 1, 1.5);
  EXPECT_OK(ups_scene_remove_mesh(r.scene, sheet));
  EXPECT_OK(ups_scene_remove_material(r.scene, unused));
  EXPECT_OK(ups_scene_remove_texture(r.scene, r.texture));
  EXPECT_OK(ups_scene_commit(r.scene));
  const Readings all = r.render();
  EXPECT_GT(all.meters[0][0].illuminance_lx, 0);
}

TEST_F(Edits, AMeshReplacedAgainAndAgainTakesNoMoreMemory) {
  EditedRoom r(context);
  const auto replace = [&](int times) {
    for (int i = 0; i < times; ++i) {
      const ups_mesh_id mesh = r.add_sheet(r.wall, 150, 1);  // some 10 MB with its index
      const ups_instance_id shown = r.add_instance(mesh, 1, 1, 1);
      EXPECT_OK(ups_scene_commit(r.scene));
      EXPECT_OK(ups_scene_remove_instance(r.scene, shown));
      EXPECT_OK(ups_scene_remove_mesh(r.scene, mesh));
    }
    EXPECT_OK(ups_scene_commit(r.scene));
  };
  replace(3);
  const long before = resident_kb();
  replace(12);
  EXPECT_LT(resident_kb() - before, 30'000) << "kB";
}

// A flux that is set is that of the emitters which are still there.
TEST_F(Edits, FixturesAreSetWithoutEmittersThatWereRemoved) {
  ups_fixture* fixture = nullptr;
  EXPECT_OK(ups_fixture_create(context, &fixture));
  auto led = make(&ups_fixture_emitter_desc_init);
  led.radius_m = 0.01, led.flux_lm = 500;
  for (const float x : {0.0f, 0.1f}) {
    led.to_fixture[3] = x;
    EXPECT_OK(ups_fixture_add_emitter(fixture, &led, nullptr));
  }
  auto d = make(&ups_fixture_instance_desc_init);
  ups_fixture_id id;
  EXPECT_OK(ups_scene_add_fixture(scene, fixture, &d, &id));
  ups_instance_id first;
  EXPECT_OK(ups_scene_get_fixture_instance(scene, id, {1}, &first));
  EXPECT_OK(ups_scene_remove_instance(scene, first));
  d.flux_lm = 1000;
  EXPECT_OK(ups_scene_set_fixture(scene, id, &d));
  EXPECT_OK(ups_scene_commit(scene));
  auto info = sized<ups_scene_info>();
  EXPECT_OK(ups_scene_get_info(scene, &info));
  EXPECT_NEAR(info.emitted_flux_lm, 1000, 1e-2);
  ups_fixture_destroy(fixture);
}

TEST_F(Edits, FixturesAreSetAndGiveBackWhatTheyTook) {
  ups_fixture* fixture = lamp_in_a_cup();
  auto d = make(&ups_fixture_instance_desc_init);
  ups_fixture_id a, b;
  EXPECT_OK(ups_scene_add_fixture(scene, fixture, &d, &a));
  place(d, 1, 0, 0);
  EXPECT_OK(ups_scene_add_fixture(scene, fixture, &d, &b));
  const auto flux = [&] {
    auto info = sized<ups_scene_info>();
    EXPECT_OK(ups_scene_commit(scene));
    EXPECT_OK(ups_scene_get_info(scene, &info));
    return info.emitted_flux_lm;
  };
  EXPECT_NEAR(flux(), 200, 1e-3);
  auto got = sized<ups_fixture_instance_desc>();
  EXPECT_OK(ups_scene_get_fixture(scene, b, &got));
  EXPECT_EQ(got.to_world[3], 1);
  got.flux_lm = 500, got.dimming = 0.5f, got.group = 9;
  EXPECT_OK(ups_scene_set_fixture(scene, b, &got));
  EXPECT_NEAR(flux(), 350, 1e-3);
  EXPECT_OK(ups_scene_set_fixture_dimming(scene, b, 1));
  EXPECT_NEAR(flux(), 600, 1e-3) << "of the flux that was set";
  ups_instance_id part;
  EXPECT_OK(ups_scene_get_fixture_instance(scene, b, {1}, &part));
  auto instance_desc = sized<ups_instance_desc>();
  EXPECT_OK(ups_scene_get_instance(scene, part, &instance_desc));
  EXPECT_EQ(instance_desc.group, 9u);
  expect_error(ups_scene_set_instance(scene, part, &instance_desc), UPS_ERROR_INVALID_ARGUMENT, {"fixture"});
  expect_error(ups_scene_set_transform(scene, part, instance_desc.to_world), UPS_ERROR_INVALID_ARGUMENT, {"fixture"});
  EXPECT_NEAR(flux(), 600, 1e-3);
  EXPECT_OK(ups_scene_remove_instance(scene, part));
  EXPECT_OK(ups_scene_set_fixture(scene, b, &got));
  EXPECT_NEAR(flux(), 100, 1e-3) << "without the part that was removed";
  ups_instance_id reflector;
  EXPECT_OK(ups_scene_get_fixture_instance(scene, a, {2}, &reflector));
  EXPECT_OK(ups_scene_get_instance(scene, reflector, &instance_desc));
  const ups_mesh_id curved = instance_desc.mesh;
  const auto mesh_desc = quad();
  expect_error(ups_scene_set_mesh(scene, curved, &mesh_desc), UPS_ERROR_INVALID_ARGUMENT, {"curved part"});
  auto m = sized<ups_mesh_desc>();
  EXPECT_OK(ups_scene_get_mesh(scene, curved, &m));
  auto of_part = sized<ups_material_desc>();
  EXPECT_OK(ups_scene_get_material(scene, m.material, &of_part));
  auto luminous = of_part;
  luminous.luminance_cd_m2[0] = 1000;
  EXPECT_OK(ups_scene_set_material(scene, m.material, &luminous));
  expect_error(ups_scene_commit(scene), UPS_ERROR_INVALID_ARGUMENT, {"curved part", "luminance", "emitter"});
  EXPECT_OK(ups_scene_set_material(scene, m.material, &of_part));
  EXPECT_OK(ups_scene_commit(scene));
  EXPECT_OK(ups_scene_remove_fixture(scene, a));
  EXPECT_OK(ups_scene_get_mesh(scene, curved, &m)) << "b has it too";
  EXPECT_OK(ups_scene_remove_fixture(scene, b));
  expect_error(ups_scene_get_mesh(scene, curved, &m), UPS_ERROR_INVALID_ARGUMENT, {"was removed"});
  expect_error(ups_scene_get_fixture(scene, b, &got), UPS_ERROR_INVALID_ARGUMENT, {"was removed"});
  EXPECT_EQ(flux(), 0);
  ups_fixture_destroy(fixture);
}

// A part's mesh that something else has stays when its fixture is removed; one that was removed is made again.
TEST_F(Edits, MeshesOfFixturesAreSharedAndRemovedByOthers) {
  constexpr ups_fixture_part_id cup_part{2};
  ups_fixture* fixture = lamp_in_a_cup();
  const auto d = make(&ups_fixture_instance_desc_init);
  ups_fixture_id a, b;
  EXPECT_OK(ups_scene_add_fixture(scene, fixture, &d, &a));
  ups_instance_id reflector, other;
  EXPECT_OK(ups_scene_get_fixture_instance(scene, a, cup_part, &reflector));
  auto instance_desc = sized<ups_instance_desc>();
  EXPECT_OK(ups_scene_get_instance(scene, reflector, &instance_desc));
  const ups_mesh_id curved = instance_desc.mesh;
  place(instance_desc, 1, 0, 0);
  EXPECT_OK(ups_scene_add_instance(scene, &instance_desc, &other));
  EXPECT_OK(ups_scene_remove_fixture(scene, a));
  auto m = sized<ups_mesh_desc>();
  EXPECT_OK(ups_scene_get_mesh(scene, curved, &m)) << "another instance has it";
  expect_error(ups_scene_get_fixture(scene, a, nullptr), UPS_ERROR_INVALID_ARGUMENT, {});
  EXPECT_OK(ups_scene_remove_instance(scene, other));
  EXPECT_OK(ups_scene_remove_mesh(scene, curved));
  EXPECT_OK(ups_scene_commit(scene));

  EXPECT_OK(ups_scene_add_fixture(scene, fixture, &d, &a));
  EXPECT_OK(ups_scene_get_fixture_instance(scene, a, cup_part, &reflector));
  EXPECT_OK(ups_scene_get_instance(scene, reflector, &instance_desc));
  EXPECT_OK(ups_scene_remove_instance(scene, reflector));
  EXPECT_OK(ups_scene_remove_mesh(scene, instance_desc.mesh));
  EXPECT_OK(ups_scene_add_fixture(scene, fixture, &d, &b)) << "its mesh is made again";
  EXPECT_OK(ups_scene_commit(scene));
  auto info = sized<ups_scene_info>();
  EXPECT_OK(ups_scene_get_info(scene, &info));
  EXPECT_NEAR(info.emitted_flux_lm, 200, 1e-3);
  EXPECT_OK(ups_scene_remove_fixture(scene, a));
  EXPECT_OK(ups_scene_remove_fixture(scene, b));
  EXPECT_OK(ups_scene_commit(scene));
  EXPECT_OK(ups_scene_get_info(scene, &info));
  EXPECT_EQ(info.emitted_flux_lm, 0);
  ups_fixture_destroy(fixture);
}
