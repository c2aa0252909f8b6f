// Ids of one scene given to another, or to its results: refused, and nothing changes.
#include <set>

#include "fixture.h"

namespace ups_test {
namespace {

// A scene with one of everything, which has the numbers of every other such scene.
struct Everything {
  ups_scene* scene = nullptr;
  ups_texture_id texture{};
  ups_material_id material{};
  ups_mesh_id mesh{};
  ups_instance_id instance{};
  ups_luminaire_id light{};
  ups_sensor_id meters{}, camera{}, goniometer{};
  ups_fixture_id fixture{};
};

struct ForeignIds : Api {
  ForeignIds() {
    EXPECT_OK(ups_fixture_create(context, &fixture));
    auto emitter = make(&ups_fixture_emitter_desc_init);
    emitter.radius_m = 0.01, emitter.flux_lm = 10;
    EXPECT_OK(ups_fixture_add_emitter(fixture, &emitter, nullptr));
    fill(mine), fill(theirs);
  }
  ~ForeignIds() override {
    ups_scene_destroy(mine.scene);
    ups_scene_destroy(theirs.scene);
    ups_fixture_destroy(fixture);
  }
  void fill(Everything& e) {
    EXPECT_OK(ups_scene_create(context, &e.scene));
    EXPECT_OK(ups_scene_add_texture(e.scene, &texture_desc(), &e.texture));
    auto m = make(&ups_material_desc_init);
    m.reflectance_texture = e.texture;
    EXPECT_OK(ups_scene_add_material(e.scene, &m, &e.material));
    auto mesh_desc = quad();
    mesh_desc.material = e.material;
    EXPECT_OK(ups_scene_add_mesh(e.scene, &mesh_desc, &e.mesh));
    auto i = make(&ups_instance_desc_init);
    i.mesh = e.mesh;
    EXPECT_OK(ups_scene_add_instance(e.scene, &i, &e.instance));
    auto l = make(&ups_light_desc_init);
    l.to_world[11] = 2;
    EXPECT_OK(ups_scene_add_light(e.scene, &l, &e.light));
    const auto meter_desc = meters();
    EXPECT_OK(ups_scene_add_meters(e.scene, &meter_desc, &e.meters));
    auto camera_desc = make(&ups_camera_desc_init);
    camera_desc.width = camera_desc.height = 2, camera_desc.to_world[11] = 3;
    EXPECT_OK(ups_scene_add_camera(e.scene, &camera_desc, &e.camera));
    auto goniometer_desc = make(&ups_goniometer_desc_init);
    goniometer_desc.c_count = 4, goniometer_desc.gamma_count = 3;
    EXPECT_OK(ups_scene_add_goniometer(e.scene, &goniometer_desc, &e.goniometer));
    auto placement = make(&ups_fixture_instance_desc_init);
    placement.to_world[11] = 1;
    EXPECT_OK(ups_scene_add_fixture(e.scene, fixture, &placement, &e.fixture));
  }
  void expect_refused(ups_status status, const std::string& noun, uint32_t id) {
    expect_error(status, UPS_ERROR_INVALID_ARGUMENT,
                 {noun + " id " + std::to_string(id) + " is not of this scene, but of another",
                  "number " + std::to_string(id & 0xffffff)});
  }

  ups_fixture* fixture = nullptr;
  Everything mine, theirs;
};

TEST_F(ForeignIds, AreRefusedByCalls) {
  const auto m = make(&ups_material_desc_init);
  const double identity[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  expect_refused(ups_scene_set_material(mine.scene, theirs.material, &m), "material", theirs.material.v);
  expect_refused(ups_scene_set_transform(mine.scene, theirs.instance, identity), "instance", theirs.instance.v);
  expect_refused(ups_scene_set_dimming(mine.scene, theirs.light, 0.1f), "luminaire", theirs.light.v);
  expect_refused(ups_scene_remove_instance(mine.scene, theirs.instance), "instance", theirs.instance.v);
  expect_refused(ups_scene_remove_luminaire(mine.scene, theirs.light), "luminaire", theirs.light.v);
  expect_refused(ups_scene_remove_sensor(mine.scene, theirs.meters), "sensor", theirs.meters.v);
  expect_refused(ups_scene_set_fixture_dimming(mine.scene, theirs.fixture, 0), "fixture", theirs.fixture.v);
  expect_refused(ups_scene_set_fixture_transform(mine.scene, theirs.fixture, identity), "fixture", theirs.fixture.v);
  expect_refused(ups_scene_remove_fixture(mine.scene, theirs.fixture), "fixture", theirs.fixture.v);
  // All is still there, under its own id.
  EXPECT_OK(ups_scene_set_dimming(mine.scene, mine.light, 0.5f));
  EXPECT_OK(ups_scene_remove_fixture(mine.scene, mine.fixture));
  EXPECT_OK(ups_scene_remove_instance(mine.scene, mine.instance));
  EXPECT_OK(ups_scene_remove_sensor(mine.scene, mine.meters));
}

TEST_F(ForeignIds, AreRefusedInDescs) {
  auto m = make(&ups_material_desc_init);
  ups_material_id material_id{};
  for (auto field : {&ups_material_desc::reflectance_texture, &ups_material_desc::roughness_texture,
                     &ups_material_desc::metallic_texture, &ups_material_desc::normal_texture,
                     &ups_material_desc::alpha_texture}) {
    m.*field = theirs.texture;
    expect_refused(ups_scene_add_material(mine.scene, &m, &material_id), "texture", theirs.texture.v);
    m.*field = {};
  }
  auto mesh_desc = quad();
  mesh_desc.material = theirs.material;
  ups_mesh_id mesh_id{};
  expect_refused(ups_scene_add_mesh(mine.scene, &mesh_desc, &mesh_id), "material", theirs.material.v);
  auto i = make(&ups_instance_desc_init);
  i.mesh = theirs.mesh;
  ups_instance_id instance_id{};
  expect_refused(ups_scene_add_instance(mine.scene, &i, &instance_id), "mesh", theirs.mesh.v);
}

TEST_F(ForeignIds, AreRefusedByResults) {
  EXPECT_OK(ups_scene_commit(mine.scene));
  auto d = make(&ups_render_desc_init);
  d.iteration_count = 1, d.separation = UPS_SEPARATE_LUMINAIRES;
  ups_result* result = nullptr;
  ASSERT_EQ(ups_render(mine.scene, &d, &result), UPS_OK) << ups_last_error();
  ups_meter_reading readings[2];
  ups_meter_statistics statistics{};
  statistics.struct_size = sizeof statistics;
  ups_goniometer_info info{};
  info.struct_size = sizeof info;
  float pixels[12];
  uint32_t count = 0;
  const uint32_t m = theirs.meters.v, c = theirs.camera.v, g = theirs.goniometer.v;
  expect_refused(ups_result_read_meters(result, theirs.meters, readings, 2), "sensor", m);
  expect_refused(ups_result_read_source_meters(result, 0, theirs.meters, readings, 2), "sensor", m);
  expect_refused(ups_result_get_meter_statistics(result, theirs.meters, &statistics), "sensor", m);
  expect_refused(ups_result_read_image(result, theirs.camera, UPS_CHANNEL_LUMINANCE_RGB, pixels, 0, sizeof pixels),
                 "sensor", c);
  expect_refused(ups_result_get_technique_count(result, theirs.camera, &count), "sensor", c);
  expect_refused(ups_result_get_goniometer_info(result, theirs.goniometer, &info), "sensor", g);
  ups_meter_part_reading parts[2];
  uint32_t flags[2];
  ups_goniometer_beam beam{};
  beam.struct_size = sizeof beam;
  expect_refused(ups_result_read_meter_part(result, theirs.meters, UPS_LIGHT_PART_DIRECT, parts, 2), "sensor", m);
  expect_refused(ups_result_read_meter_flags(result, theirs.meters, flags, 2), "sensor", m);
  expect_refused(ups_result_get_goniometer_beam(result, theirs.goniometer, 0, 0.5f, &beam), "sensor", g);
  ups_sensor_choice choice{};
  choice.struct_size = sizeof choice;
  expect_refused(ups_result_get_choice(result, theirs.meters, &choice), "sensor", m);
  EXPECT_OK(ups_result_read_meters(result, mine.meters, readings, 2));
  EXPECT_OK(ups_result_read_image(result, mine.camera, UPS_CHANNEL_LUMINANCE_RGB, pixels, 0, sizeof pixels));
  EXPECT_OK(ups_result_get_goniometer_info(result, mine.goniometer, &info));
  // The ids of sources are those that the scene handed out.
  ups_source_info source{};
  source.struct_size = sizeof source;
  EXPECT_OK(ups_result_get_source_count(result, &count));
  ASSERT_EQ(count, 2u);  // the fixture's emitter and the light
  EXPECT_OK(ups_result_get_source(result, 1, &source));
  EXPECT_EQ(source.kind, UPS_SOURCE_LUMINAIRE);
  EXPECT_EQ(source.id, mine.light.v);
  // A result keeps its scene's bits taken: no later scene gets its ids.
  ups_scene_destroy(mine.scene);
  mine.scene = nullptr;
  for (int i = 0; i < 600; ++i) {
    Everything later;
    ASSERT_EQ(ups_scene_create(context, &later.scene), UPS_OK);
    const auto meter_desc = meters();
    ASSERT_EQ(ups_scene_add_meters(later.scene, &meter_desc, &later.meters), UPS_OK);
    EXPECT_NE(ups_result_read_meters(result, later.meters, readings, 2), UPS_OK);
    ups_scene_destroy(later.scene);
  }
  ups_result_destroy(result);
}

TEST_F(Api, ScenesThatExistTogetherShareNoIds) {
  std::vector<ups_scene*> scenes(254);  // and the fixture's own
  std::set<uint32_t> ids{material.v};
  const auto m = make(&ups_material_desc_init);
  for (int round = 0; round < 3; ++round) {
    for (ups_scene*& s : scenes) {
      if (s) ids.clear(), ids.insert(material.v), ups_scene_destroy(s), s = nullptr;
    }
    for (ups_scene*& s : scenes) {
      ASSERT_EQ(ups_scene_create(context, &s), UPS_OK);
      ups_material_id id{};
      EXPECT_OK(ups_scene_add_material(s, &m, &id));
      EXPECT_EQ(id.v & 0xffffff, 1u);
      EXPECT_TRUE(ids.insert(id.v).second);
    }
  }
  // One more must share, but works.
  ups_scene* more = nullptr;
  ups_material_id id{};
  EXPECT_OK(ups_scene_create(context, &more));
  EXPECT_OK(ups_scene_add_material(more, &m, &id));
  EXPECT_OK(ups_scene_set_material(more, id, &m));
  ups_scene_destroy(more);
  for (ups_scene* s : scenes) ups_scene_destroy(s);
}

}  // namespace
}  // namespace ups_test
