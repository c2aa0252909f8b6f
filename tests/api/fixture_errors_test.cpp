// Are wrong fields of fixtures' parts and placements refused, naming the part, the field, its value and what would be
// right?
#include "fixture_scene.h"

#include <cmath>
#include <functional>

namespace ups_test {
namespace {

template <class Desc>
struct Wrong {
  std::function<void(Desc&)> spoil;
  std::vector<std::string> words;
};

template <class Desc>
void expect_refused(ups_fixture* fixture, const Desc& good,
                    ups_status (*add)(ups_fixture*, const Desc*, ups_fixture_part_id*), const char* kind,
                    const std::vector<Wrong<Desc>>& cases) {
  ups_fixture_part_id id{};
  for (const auto& c : cases) {
    Desc d = good;
    c.spoil(d);
    auto words = c.words;
    words.push_back(std::string("part 1 (") + kind + ")");
    expect_error(add(fixture, &d, &id), UPS_ERROR_INVALID_ARGUMENT, words);
    EXPECT_EQ(id.v, 0u);
  }
  expect_error(add(nullptr, &good, &id), UPS_ERROR_INVALID_ARGUMENT, {"fixture is NULL"});
  expect_error(add(fixture, nullptr, &id), UPS_ERROR_INVALID_ARGUMENT, {"desc is NULL"});
  EXPECT_OK(add(fixture, &good, &id));
  EXPECT_EQ(id.v, 1u);
}

TEST_F(Fixtures, EmitterFields) {
  using D = ups_fixture_emitter_desc;
  expect_refused<D>(fixture, cob(0.01, 1), &ups_fixture_add_emitter, "emitter",
                    {{[](D& d) { d.shape = 4; }, {"shape is 4", "UPS_EMITTER_*"}},
                     {[](D& d) { d.radius_m = 0; }, {"radius_m is 0", "above 0"}},
                     {[](D& d) { d.radius_m = 1e-60; }, {"no area"}},
                     {[](D& d) { d.width_m = 1; }, {"width_m is 1", "must be 0"}},
                     {[](D& d) { d.flux_lm = -1; }, {"flux_lm is -1"}},
                     {[](D& d) { d.flux_lm = NAN; }, {"flux_lm is nan"}},
                     {[](D& d) { d.color_rgb[0] = d.color_rgb[1] = d.color_rgb[2] = 0; }, {"color_rgb is black"}},
                     {[](D& d) { d.reflectance = 1.5f; }, {"reflectance is 1.5"}},
                     {[](D& d) { d.reserved = 1; }, {"reserved"}},
                     {[](D& d) { d.chord_tolerance_m = -1; }, {"chord_tolerance_m is -1"}},
                     {[](D& d) { d.chord_tolerance_m = 1e-18; }, {"chord_tolerance_m", "4000000"}},
                     {[](D& d) { d.to_fixture[0] = 2; }, {"to_fixture", "rotation and a translation"}},
                     {[](D& d) { d.to_fixture[0] = -1; }, {"to_fixture", "mirrors"}},
                     {[](D& d) { d.to_fixture[5] = 0; }, {"to_fixture is singular"}}});
}

TEST_F(Fixtures, ReflectorFields) {
  using D = ups_reflector_desc;
  auto material_desc = make(&ups_material_desc_init);
  auto textured = material_desc, glowing = material_desc, glass = material_desc, wrong = material_desc;
  textured.reflectance_texture = texture;
  glowing.luminance_cd_m2[1] = 5;
  glass.model = UPS_MATERIAL_GLASS;
  wrong.roughness = 2;
  const auto with = [](const ups_material_desc& m) {
    return [&m](D& d) { d.finish = UPS_FINISH_CUSTOM, d.material = &m; };
  };
  expect_refused<D>(
      fixture, cup(), &ups_fixture_add_reflector, "reflector",
      {{[](D& d) { d.profile = 5; }, {"profile is 5", "UPS_REFLECTOR_*"}},
       {[](D& d) { d.focal_length_m = 0; }, {"focal_length_m is 0"}},
       {[](D& d) { d.inner_radius_m = 0.06; }, {"inner_radius_m is 0.06", "aperture_radius_m"}},
       {[](D& d) { d.semi_axis_m = 1; }, {"semi_axis_m is 1", "must be 0"}},
       {[](D& d) { d.depth_m = 1; }, {"depth_m is 1", "must be 0"}},
       {[](D& d) { d.smooth = 2; }, {"smooth is 2"}},
       {[](D& d) { d.facets_around = 2; }, {"facets_around is 2", "3 to 100000"}},
       {[](D& d) { d.facets_along = 100001; }, {"facets_along is 100001"}},
       {[](D& d) { d.facets_around = d.facets_along = 100000; }, {"4000000"}},
       {[](D& d) { d.normal_tolerance_rad = NAN; }, {"normal_tolerance_rad is nan"}},
       {[](D& d) { d.finish = 11; }, {"finish is 11", "UPS_FINISH_*"}},
       {[](D& d) { d.finish = UPS_FINISH_PMMA; }, {"finish", "sheet"}},
       {[](D& d) { d.finish_reflectance = 1.5f; }, {"finish_reflectance is 1.5"}},
       {[](D& d) { d.finish_reflectance = NAN; }, {"finish_reflectance is nan"}},
       {[](D& d) { d.finish_roughness = 0.5f; }, {"finish_roughness is 0.5", "SPECULAR_ALUMINIUM has no"}},
       {[](D& d) { d.finish = UPS_FINISH_CUSTOM; }, {"material is NULL"}},
       {[&](D& d) { d.material = &material_desc; }, {"material is set", "UPS_FINISH_CUSTOM"}},
       {with(textured), {"material", "texture"}},
       {with(glowing), {"luminance_cd_m2"}},
       {with(glass), {"finish", "sheet"}},
       {with(wrong), {"roughness is 2"}},
       {[](D& d) { d.profile = UPS_REFLECTOR_POLYLINE; }, {"focal_length_m"}},
       {[](D& d) { d.profile = UPS_REFLECTOR_POLYLINE, d.focal_length_m = d.aperture_radius_m = 0; },
        {"profile_point_count is 0"}},
       {[](D& d) {
          d.profile = UPS_REFLECTOR_POLYLINE, d.focal_length_m = d.aperture_radius_m = 0, d.profile_point_count = 2;
        },
        {"profile_rz_m is NULL"}},
       {[](D& d) { d.profile = UPS_REFLECTOR_ELLIPSOID, d.focal_length_m = 0; }, {"semi_axis_m is 0"}},
       {[](D& d) { d.aperture_radius_m = 1e39; }, {"aperture_radius_m is 1e+39", "at most 1e+09 m"}},
       {[](D& d) { d.profile = UPS_REFLECTOR_CONE, d.focal_length_m = 0; }, {"depth_m is 0"}}});
}

TEST_F(Fixtures, LensFields) {
  using D = ups_lens_desc;
  expect_refused<D>(fixture, plate(), &ups_fixture_add_lens, "lens",
                    {{[](D& d) { d.radius_m = -1; }, {"radius_m is -1"}},
                     {[](D& d) { d.radius_m = 1e150; }, {"radius_m is 1e+150", "at most 1e+09 m"}},
                     {[](D& d) { d.thickness_m = 0; }, {"thickness_m is 0"}},
                     {[](D& d) { d.exit_radius_m = 0.05; }, {"thickness_m is 0.003", "faces cross"}},
                     {[](D& d) { d.entry_radius_m = 0.02; }, {"entry_radius_m is 0.02", "rim"}},
                     {[](D& d) { d.entry_conic = NAN; }, {"entry_conic"}},
                     {[](D& d) { d.exit_coefficients[3] = INFINITY; }, {"exit_coefficients[3]"}},
                     {[](D& d) { d.finish = UPS_FINISH_OPAL; }, {"finish", "solid"}},
                     {[](D& d) { d.finish_ior = 0.5f; }, {"finish_ior is 0.5"}},
                     {[](D& d) { d.finish_ior = NAN; }, {"finish_ior is nan"}},
                     {[](D& d) { d.finish_absorption_per_m = INFINITY; }, {"finish_absorption_per_m is inf"}},
                     {[](D& d) { d.finish_roughness = 0.5f; }, {"finish_roughness", "PMMA has no"}},
                     {[](D& d) { d.facets_around = 1; }, {"facets_around is 1"}}});
}

TEST_F(Fixtures, CollimatorFields) {
  using D = ups_collimator_desc;
  expect_refused<D>(
      fixture, collimator(), &ups_fixture_add_collimator, "collimator",
      {{[](D& d) { d.cavity_radius_m = 0; }, {"cavity_radius_m is 0"}},
       {[](D& d) { d.wall_thickness_m = 0; }, {"wall_thickness_m is 0"}},
       {[](D& d) { d.wall = 3; }, {"wall is 3"}},
       {[](D& d) { d.wall = UPS_COLLIMATOR_PARABOLOID; }, {"wall_thickness_m", "must be 0"}},
       {[](D& d) { d.wall = UPS_COLLIMATOR_PARABOLOID, d.wall_thickness_m = 0; }, {"wall_focal_length_m is 0"}},
       {[](D& d) { d.wall = UPS_COLLIMATOR_POLYLINE, d.wall_thickness_m = 0; }, {"wall_point_count is 0"}},
       {[](D& d) { d.height_m = 0.001; }, {"height_m is 0.001"}},
       {[](D& d) { d.finish = UPS_FINISH_BLACK; }, {"finish", "solid"}},
       {[](D& d) { d.finish_ior = 1; }, {"finish_ior is 1"}}});
}

TEST_F(Fixtures, MeshPartFields) {
  using D = ups_fixture_part_desc;
  auto mesh_desc = quad();
  mesh_desc.material = {};
  auto with_material = mesh_desc, broken = mesh_desc;
  with_material.material = material;
  broken.vertex_count = 2;
  auto good = make(&ups_fixture_part_desc_init);
  good.mesh = &mesh_desc;
  auto unsized_mesh = mesh_desc;
  unsized_mesh.struct_size = 0;
  expect_refused<D>(fixture, good, &ups_fixture_add_part, "mesh",
                    {{[](D& d) { d.mesh = nullptr; }, {"mesh is NULL"}},
                     {[&](D& d) { d.mesh = &with_material; }, {"material is", "must be 0"}},
                     {[&](D& d) { d.mesh = &broken; }, {"indices: element 2 is 2"}},
                     {[&](D& d) { d.mesh = &unsized_mesh; }, {"mesh->struct_size is 0"}},
                     {[](D& d) { d.finish = UPS_FINISH_GLASS; }, {"mesh is not closed"}},
                     {[](D& d) { d.reserved = 1; }, {"reserved"}}});
}

TEST_F(Fixtures, PlacementFields) {
  auto d = make(&ups_fixture_instance_desc_init);
  ups_fixture_id id{};
  const auto refused = [&](std::vector<std::string> words) {
    expect_error(ups_scene_add_fixture(scene, fixture, &d, &id), UPS_ERROR_INVALID_ARGUMENT, words);
    EXPECT_EQ(id.v, 0u);
    d = make(&ups_fixture_instance_desc_init);
  };
  refused({"fixture has no parts"});
  const auto dark = cob(0.01, 0);
  EXPECT_OK(ups_fixture_add_emitter(fixture, &dark, nullptr));
  d.flux_lm = 5;
  refused({"flux_lm is 5", "no flux"});
  const auto emitter = cob(0.01, 10);
  EXPECT_OK(ups_fixture_add_emitter(fixture, &emitter, nullptr));
  d.dimming = -1;
  refused({"dimming is -1"});
  d.dimming = 1e38f;
  refused({"luminance", "not finite"});
  d.flux_lm = NAN;
  refused({"flux_lm is nan"});
  d.to_world[0] = 3;
  refused({"to_world", "rotation and a translation"});
  d.to_world[3] = INFINITY;
  refused({"to_world[3] is inf"});
  expect_error(ups_scene_add_fixture(nullptr, fixture, &d, &id), UPS_ERROR_INVALID_ARGUMENT, {"scene is NULL"});
  expect_error(ups_scene_add_fixture(scene, nullptr, &d, &id), UPS_ERROR_INVALID_ARGUMENT, {"fixture is NULL"});
  expect_error(ups_scene_add_fixture(scene, fixture, &d, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"out is NULL"});
  expect_error(ups_fixture_create(nullptr, &fixture), UPS_ERROR_INVALID_ARGUMENT, {"context is NULL"});
  expect_error(ups_fixture_create(context, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"out is NULL"});
  EXPECT_EQ(scene_info().triangle_count, 0u);  // nothing of what was refused is left
  d = make(&ups_fixture_instance_desc_init);
  d.to_world[3] = 1.7e308;  // that of a part that stands as far off is no number: refused before anything is there
  auto far = make(&ups_fixture_part_desc_init);
  auto mesh_desc = quad();
  mesh_desc.material = {};
  far.mesh = &mesh_desc, far.to_fixture[3] = 1.7e308;
  EXPECT_OK(ups_fixture_add_part(fixture, &far, nullptr));
  int32_t dirty = 1;
  expect_error(ups_scene_add_fixture(scene, fixture, &d, &id), UPS_ERROR_INVALID_ARGUMENT, {"to_world[3] is inf"});
  EXPECT_OK(ups_scene_is_dirty(scene, &dirty));
  EXPECT_EQ(dirty, 0);
}

}  // namespace
}  // namespace ups_test
