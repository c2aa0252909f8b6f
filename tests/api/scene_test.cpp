// Commit and what can be asked afterwards: ids, changes, removal, counts, bounds, effects, warnings.
#include "fixture.h"

namespace ups_test {
namespace {

ups_scene_info info_of(const ups_scene* scene) {
  ups_scene_info info{};
  info.struct_size = sizeof info;
  EXPECT_OK(ups_scene_get_info(scene, &info));
  return info;
}

std::string text_of(const ups_scene* scene, ups_scene_text topic) {
  size_t needed = 0;
  EXPECT_OK(ups_scene_get_text(scene, topic, nullptr, 0, &needed));
  std::string text(needed, '?');
  EXPECT_OK(ups_scene_get_text(scene, topic, text.data(), text.size(), &needed));
  EXPECT_EQ(text.back(), '\0');
  text.pop_back();
  return text;
}

TEST_F(Api, NothingCanBeAskedBeforeACommit) {
  ups_scene_info info{};
  info.struct_size = sizeof info;
  size_t needed = 0;
  expect_error(ups_scene_get_info(scene, &info), UPS_ERROR_INVALID_STATE, {"ups_scene_commit"});
  expect_error(ups_scene_get_text(scene, UPS_SCENE_TEXT_EFFECTS, nullptr, 0, &needed), UPS_ERROR_INVALID_STATE,
               {"ups_scene_commit"});
}

TEST_F(Api, EmptySceneCommits) {
  ups_scene* empty = nullptr;
  EXPECT_OK(ups_scene_create(context, &empty));
  EXPECT_OK(ups_scene_commit(empty));
  const ups_scene_info info = info_of(empty);
  EXPECT_EQ(info.triangle_count, 0u);
  EXPECT_GT(info.bounds_min_m[0], info.bounds_max_m[0]);
  EXPECT_EQ(info.effects, 0u);
  ups_scene_destroy(empty);
}

TEST_F(Api, CountsAndBounds) {
  auto light = make(&ups_light_desc_init);
  auto luminaire = make(&ups_luminaire_desc_init);
  luminaire.profile = profile;
  luminaire.flux_lm = 500;
  luminaire.dimming = 0.5f;
  const auto camera = make(&ups_camera_desc_init);
  const auto meter = meters();
  ups_luminaire_id light_id{}, luminaire_id{};
  ups_sensor_id camera_id{}, meters_id{};
  EXPECT_OK(ups_scene_add_light(scene, &light, &light_id));
  EXPECT_OK(ups_scene_add_luminaire(scene, &luminaire, &luminaire_id));
  EXPECT_OK(ups_scene_add_camera(scene, &camera, &camera_id));
  EXPECT_OK(ups_scene_add_meters(scene, &meter, &meters_id));
  const double moved[12] = {2, 0, 0, 1e6, 0, 3, 0, -2e6, 0, 0, 1, 5};
  EXPECT_OK(ups_scene_set_transform(scene, instance, moved));
  auto emitting = make(&ups_material_desc_init);
  for (float& l : emitting.luminance_cd_m2) l = 100;
  EXPECT_OK(ups_scene_set_material(scene, material, &emitting));
  EXPECT_OK(ups_scene_commit(scene));

  const double pi = 3.14159265358979;
  ups_scene_info info = info_of(scene);
  EXPECT_EQ(info.triangle_count, 2u);
  EXPECT_EQ(info.light_count, 1u);
  EXPECT_EQ(info.luminaire_count, 1u);
  EXPECT_EQ(info.emissive_instance_count, 1u);
  EXPECT_EQ(info.meter_count, 2u);
  EXPECT_EQ(info.pixel_count, 512u * 512u);
  EXPECT_NEAR(info.emitted_flux_lm, 4 * pi + 250 + pi * 100 * 6,
              600 * 3e-2);  // floats 1e6 m apart: 2 x 3 m within 0.125 m
  EXPECT_NEAR(info.bounds_min_m[0], 1e6, 0.2);
  EXPECT_NEAR(info.bounds_max_m[1], -2e6 + 3, 0.2);

  // With the far thing gone, the rest is exact again; ids of removed things stay unknown.
  EXPECT_OK(ups_scene_remove_instance(scene, instance));
  EXPECT_OK(ups_scene_remove_luminaire(scene, light_id));
  EXPECT_OK(ups_scene_remove_sensor(scene, camera_id));
  EXPECT_NEAR(info_of(scene).pixel_count, 512. * 512, 0) << "changes take effect at the next commit";
  EXPECT_OK(ups_scene_commit(scene));
  info = info_of(scene);
  EXPECT_EQ(info.triangle_count, 0u);
  EXPECT_EQ(info.pixel_count, 0u);
  EXPECT_EQ(info.meter_count, 2u);
  EXPECT_NEAR(info.emitted_flux_lm, 250, 1e-3);
  expect_error(ups_scene_remove_instance(scene, instance), UPS_ERROR_INVALID_ARGUMENT, {"instance id 1 was removed"});
  expect_error(ups_scene_remove_sensor(scene, camera_id), UPS_ERROR_INVALID_ARGUMENT, {"sensor id 1 was removed"});
  EXPECT_OK(ups_scene_set_dimming(scene, luminaire_id, 2));
  ups_luminaire_id next{};
  EXPECT_OK(ups_scene_add_light(scene, &light, &next));
  EXPECT_EQ(next.v & 0xffffff, 3u) << "ids are not used again";
  EXPECT_OK(ups_scene_commit(scene));
  EXPECT_NEAR(info_of(scene).emitted_flux_lm, 1000 + 4 * pi, 1e-2);
}

TEST_F(Api, ThingsBeyondReachAreNamed) {
  const double far[12] = {1, 0, 0, 1e10, 0, 1, 0, 0, 0, 0, 1, 0};
  EXPECT_OK(ups_scene_set_transform(scene, instance, far));
  expect_error(ups_scene_commit(scene), UPS_ERROR_INVALID_ARGUMENT, {"instance id 1", "1e+10"});
}

// A directional light has no place, whatever its transform says.
TEST_F(Api, DirectionalLightsShineFromAnywhere) {
  auto light = make(&ups_light_desc_init);
  light.kind = UPS_LIGHT_DIRECTIONAL;
  ups_luminaire_id id{};
  for (const double far : {1e19, 1e300}) {
    light.to_world[11] = far;
    EXPECT_OK(ups_scene_add_light(scene, &light, &id));
    EXPECT_OK(ups_scene_commit(scene));
  }
}

TEST_F(Api, EffectsNameTheirCause) {
  EXPECT_OK(ups_scene_commit(scene));
  EXPECT_EQ(info_of(scene).effects, uint32_t(UPS_EFFECT_INTERREFLECTION)) << text_of(scene, UPS_SCENE_TEXT_EFFECTS);
  auto mirror = make(&ups_material_desc_init);
  mirror.model = UPS_MATERIAL_MIRROR;
  ups_material_id unused{};
  EXPECT_OK(ups_scene_add_material(scene, &mirror, &unused));
  auto coloured = make(&ups_material_desc_init);
  coloured.reflectance_rgb[0] = 0.9f;
  coloured.reflectance_texture = texture;
  EXPECT_OK(ups_scene_set_material(scene, material, &coloured));
  EXPECT_OK(ups_scene_commit(scene));
  EXPECT_EQ(info_of(scene).effects, uint32_t(UPS_EFFECT_INTERREFLECTION | UPS_EFFECT_COLOUR | UPS_EFFECT_TEXTURES))
      << "a material that nothing bears has no effect: " << text_of(scene, UPS_SCENE_TEXT_EFFECTS);

  auto second = quad();
  second.material = unused;
  auto placed = make(&ups_instance_desc_init);
  placed.to_world[11] = 1;
  ups_instance_id instance_id{};
  EXPECT_OK(ups_scene_add_mesh(scene, &second, &placed.mesh));
  EXPECT_OK(ups_scene_add_instance(scene, &placed, &instance_id));
  const auto light = make(&ups_light_desc_init);
  ups_luminaire_id light_id{};
  EXPECT_OK(ups_scene_add_light(scene, &light, &light_id));
  EXPECT_OK(ups_scene_commit(scene));
  const uint32_t effects = info_of(scene).effects;
  EXPECT_TRUE(effects & UPS_EFFECT_SPECULAR_REFLECTION);
  EXPECT_TRUE(effects & UPS_EFFECT_CAUSTICS);
  EXPECT_FALSE(effects & UPS_EFFECT_TRANSMISSION);
  EXPECT_NE(text_of(scene, UPS_SCENE_TEXT_EFFECTS).find("caustics: material 2 (mirror)"), std::string::npos)
      << text_of(scene, UPS_SCENE_TEXT_EFFECTS);
  EXPECT_EQ(info_of(scene).method, UPS_METHOD_UPS);
  EXPECT_NE(text_of(scene, UPS_SCENE_TEXT_TECHNIQUES).find("merge: on"), std::string::npos);
}

TEST_F(Api, DuplicateTrianglesAreReported) {
  auto again = make(&ups_instance_desc_init);
  again.mesh = mesh;
  ups_instance_id id{};
  EXPECT_OK(ups_scene_add_instance(scene, &again, &id));
  EXPECT_OK(ups_scene_commit(scene));
  EXPECT_NE(
      text_of(scene, UPS_SCENE_TEXT_WARNINGS)
          .find("2 triangles lie exactly on another, such as triangle 0 of instance 2 on triangle 0 of instance 1"),
      std::string::npos)
      << text_of(scene, UPS_SCENE_TEXT_WARNINGS);
}

}  // namespace
}  // namespace ups_test
