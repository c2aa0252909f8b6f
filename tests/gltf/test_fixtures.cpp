// `extras.ups.fixture`: every word ends up in the field of the C API that it names; wrong words are named with their
// place.
#include <cmath>

#include "scene_builder.h"

namespace {

class FixtureFile : public ImportTest {
 protected:
  static json with(const json& parts) { return {{"ups", {{"fixture", {{"parts", parts}}}}}}; }
  const RecordedFixture& import_parts(const json& parts) {
    SceneBuilder builder;
    builder.add_node({{"name", "lamp"}, {"extras", with(parts)}});
    import(builder);
    EXPECT_EQ(scene.fixtures.size(), 1u);
    return scene.fixtures.at(0);
  }
  void expect_parts_refused(const json& parts, std::initializer_list<const char*> words) {
    SceneBuilder builder;
    builder.add_node({{"name", "lamp"}, {"extras", with(parts)}});
    expect_failure(builder, UPS_ERROR_PARSE, words);
    EXPECT_TRUE(scene.fixtures.empty());
    EXPECT_EQ(living_fixtures(), 0);
  }
};

const json disc = {{"emitter", {{"radius_m", 0.0045}, {"flux_lm", 1000}}}};

TEST_F(FixtureFile, ADownlightNeedsAHandfulOfWords) {
  const RecordedFixture& placed = import_parts(
      {disc, {{"reflector", {{"focal_length_m", 0.004}, {"inner_radius_m", 0.008}, {"aperture_radius_m", 0.025}}}}});
  const ups_fixture& f = placed.fixture;
  EXPECT_EQ(f.parts, (std::vector<std::string>{"emitter", "reflector"}));
  EXPECT_EQ(f.emitters[0].shape, UPS_EMITTER_DISC);
  EXPECT_EQ(f.emitters[0].radius_m, 0.0045);
  EXPECT_EQ(f.emitters[0].flux_lm, 1000);
  EXPECT_EQ(f.emitters[0].color_rgb[2], 1);
  EXPECT_EQ(f.emitters[0].to_fixture[0], 1);
  EXPECT_EQ(f.emitters[0].to_fixture[11], 0);
  EXPECT_EQ(f.reflectors[0].profile, UPS_REFLECTOR_PARABOLOID);
  EXPECT_EQ(f.reflectors[0].finish, UPS_FINISH_SPECULAR_ALUMINIUM);
  EXPECT_EQ(f.reflectors[0].focal_length_m, 0.004);
  EXPECT_EQ(f.reflectors[0].inner_radius_m, 0.008);
  EXPECT_EQ(f.reflectors[0].aperture_radius_m, 0.025);
  EXPECT_EQ(f.reflectors[0].finish_reflectance, -1);
  EXPECT_EQ(f.reflectors[0].normal_tolerance_rad, 0);
  EXPECT_EQ(placed.desc.dimming, 1);
  EXPECT_EQ(placed.desc.flux_lm, -1);
}

TEST_F(FixtureFile, EveryWordOfAnEmitterAndAReflector) {
  const ups_fixture& f = import_parts({{{"emitter",
                                         {{"shape", "cylinder"},
                                          {"radius_m", 1},
                                          {"length_m", 2},
                                          {"width_m", 3},
                                          {"flux_lm", 4},
                                          {"reflectance", 0.5},
                                          {"colour_temperature_k", 3000},
                                          {"chord_tolerance_m", 0.1},
                                          {"position_m", {5, 6, 7}},
                                          {"rotation", {0, 0, 0.70710678, 0.70710678}}}}},
                                       {{"reflector",
                                         {{"profile", "polyline"},
                                          {"semi_axis_m", 1},
                                          {"half_distance_m", 2},
                                          {"depth_m", 3},
                                          {"points_m", {{0.1, 0}, {0.2, -0.3}}},
                                          {"smooth", false},
                                          {"finish", "semi_specular_aluminium"},
                                          {"reflectance", 0.8},
                                          {"roughness", 0.3},
                                          {"transmittance", 0.1},
                                          {"facets_around", 12},
                                          {"facets_along", 4},
                                          {"chord_tolerance_m", 1e-5},
                                          {"normal_tolerance_deg", 2}}}}})
                             .fixture;
  const ups_fixture_emitter_desc& e = f.emitters[0];
  EXPECT_EQ(e.shape, UPS_EMITTER_CYLINDER);
  EXPECT_EQ(e.length_m, 2);
  EXPECT_EQ(e.width_m, 3);
  EXPECT_EQ(e.reflectance, 0.5f);
  EXPECT_EQ(e.chord_tolerance_m, 0.1);
  EXPECT_GT(e.color_rgb[0], 1.3f * e.color_rgb[2]);
  EXPECT_NEAR(e.to_fixture[0], 0, 1e-7);  // a quarter about z: x to y
  EXPECT_NEAR(e.to_fixture[4], 1, 1e-7);
  EXPECT_EQ(e.to_fixture[3], 5);
  EXPECT_EQ(e.to_fixture[7], 6);
  EXPECT_EQ(e.to_fixture[11], 7);
  const ups_reflector_desc& r = f.reflectors[0];
  EXPECT_EQ(r.profile, UPS_REFLECTOR_POLYLINE);
  EXPECT_EQ(r.semi_axis_m, 1);
  EXPECT_EQ(r.half_distance_m, 2);
  EXPECT_EQ(r.depth_m, 3);
  EXPECT_EQ(f.points, (std::vector<double>{0.1, 0, 0.2, -0.3}));
  EXPECT_EQ(r.smooth, 0);
  EXPECT_EQ(r.finish, UPS_FINISH_SEMI_SPECULAR_ALUMINIUM);
  EXPECT_EQ(r.finish_reflectance, 0.8f);
  EXPECT_EQ(r.finish_roughness, 0.3f);
  EXPECT_EQ(r.finish_transmittance, 0.1f);
  EXPECT_EQ(r.facets_around, 12u);
  EXPECT_EQ(r.facets_along, 4u);
  EXPECT_EQ(r.chord_tolerance_m, 1e-5);
  EXPECT_NEAR(r.normal_tolerance_rad, 2 * 3.14159265358979 / 180, 1e-12);
}

TEST_F(FixtureFile, EveryWordOfALensAndACollimator) {
  const ups_fixture& f = import_parts({{{"lens",
                                         {{"radius_m", 1},
                                          {"thickness_m", 2},
                                          {"entry_radius_m", 3},
                                          {"entry_conic", 4},
                                          {"entry_coefficients", {1, 2, 3, 4}},
                                          {"exit_radius_m", -5},
                                          {"exit_conic", -6},
                                          {"exit_coefficients", {5, 6, 7, 8}},
                                          {"finish", "frosted_pmma"},
                                          {"roughness", 0.4},
                                          {"absorption_per_m", 9},
                                          {"ior", 1.6},
                                          {"facets_around", 6}}}},
                                       {{"collimator",
                                         {{"cavity_radius_m", 1},
                                          {"cavity_depth_m", 2},
                                          {"flat_lens", true},
                                          {"lens_conic", 3},
                                          {"wall", "polyline"},
                                          {"wall_thickness_m", 4},
                                          {"wall_focal_length_m", 5},
                                          {"wall_points_m", {{1, 0}, {2, -1}}},
                                          {"smooth", false},
                                          {"height_m", 6},
                                          {"exit_radius_m", 7},
                                          {"exit_conic", 8},
                                          {"exit_facets_along", 9},
                                          {"facets_around", 10},
                                          {"finish", {{"model", "glass"}, {"ior", 1.7}}}}}}})
                             .fixture;
  const ups_lens_desc& l = f.lenses[0];
  EXPECT_EQ(l.radius_m, 1);
  EXPECT_EQ(l.thickness_m, 2);
  EXPECT_EQ(l.entry_radius_m, 3);
  EXPECT_EQ(l.entry_conic, 4);
  EXPECT_EQ(l.entry_coefficients[3], 4);
  EXPECT_EQ(l.exit_radius_m, -5);
  EXPECT_EQ(l.exit_conic, -6);
  EXPECT_EQ(l.exit_coefficients[0], 5);
  EXPECT_EQ(l.finish, UPS_FINISH_FROSTED_PMMA);
  EXPECT_EQ(l.finish_roughness, 0.4f);
  EXPECT_EQ(l.finish_absorption_per_m, 9);
  EXPECT_EQ(l.finish_ior, 1.6f);
  EXPECT_EQ(l.facets_around, 6u);
  const ups_collimator_desc& c = f.collimators[0];
  EXPECT_EQ(c.cavity_radius_m, 1);
  EXPECT_EQ(c.cavity_depth_m, 2);
  EXPECT_TRUE(std::isinf(c.lens_radius_m));
  EXPECT_EQ(c.lens_conic, 3);
  EXPECT_EQ(c.wall, UPS_COLLIMATOR_POLYLINE);
  EXPECT_EQ(c.wall_thickness_m, 4);
  EXPECT_EQ(c.wall_focal_length_m, 5);
  EXPECT_EQ(f.points, (std::vector<double>{1, 0, 2, -1}));
  EXPECT_EQ(c.smooth, 0);
  EXPECT_EQ(c.height_m, 6);
  EXPECT_EQ(c.exit_radius_m, 7);
  EXPECT_EQ(c.exit_conic, 8);
  EXPECT_EQ(c.exit_facets_along, 9u);
  EXPECT_EQ(c.facets_around, 10u);
  EXPECT_EQ(c.finish, UPS_FINISH_CUSTOM);
  ASSERT_EQ(f.custom.size(), 1u);
  EXPECT_EQ(f.custom[0].model, UPS_MATERIAL_GLASS);
  EXPECT_EQ(f.custom[0].ior, 1.7f);
}

TEST_F(FixtureFile, NodesPlaceFixturesAndShareTheirParts) {
  SceneBuilder builder;
  const json upward = {-0.7071068, 0, 0, 0.7071068};  // local +Z to glTF's +Y: local -Z looks down
  json dimmed = with(json::array({disc}));
  dimmed["ups"]["fixture"]["dimming"] = 0.25;
  dimmed["ups"]["fixture"]["flux_lm"] = 700;
  builder.add_node({{"translation", {1, 2.6, 3}}, {"rotation", upward}, {"extras", with(json::array({disc}))}});
  builder.add_node({{"scale", {2, 2, 2}}, {"extras", dimmed}});
  json other = disc;
  other["emitter"]["flux_lm"] = 999;
  builder.add_node({{"extras", with(json::array({other}))}});
  const int before = made_fixtures();
  import(builder);
  ASSERT_EQ(scene.fixtures.size(), 3u);
  EXPECT_EQ(made_fixtures() - before, 2);
  const double(&m)[12] = scene.fixtures[0].desc.to_world;
  EXPECT_NEAR(m[10], 1, 1e-6);  // local +Z is up
  EXPECT_NEAR(m[3], 1, 1e-6);
  EXPECT_NEAR(m[7], -3, 1e-6);
  EXPECT_NEAR(m[11], 2.6, 1e-6);
  EXPECT_EQ(scene.fixtures[1].desc.dimming, 0.25f);
  EXPECT_EQ(scene.fixtures[1].desc.flux_lm, 700);
  EXPECT_EQ(scene.fixtures[1].desc.to_world[0], 1);
  EXPECT_TRUE(warned("scale is ignored"));
  EXPECT_EQ(scene.fixtures[2].fixture.emitters[0].flux_lm, 999);
}

TEST_F(FixtureFile, WrongWordsAreNamedWithTheirPlace) {
  const char* lamp = "node 0 \"lamp\": extras.ups.fixture";
  expect_parts_refused(5, {lamp, "\"parts\" must be an array"});
  expect_parts_refused({disc, {{"mirror", json::object()}}},
                       {lamp, ".parts[1]", "\"mirror\" is not known", "reflector"});
  expect_parts_refused(json::array({json::object()}), {lamp, ".parts[0]", "one member"});
  expect_parts_refused(json::array({{{"emitter", {{"radius_m", 1}}}}}),
                       {".parts[0].emitter", "\"flux_lm\" is missing"});
  const auto reflector = [](const char* key, const json& value) {
    return json::array({{{"reflector", {{key, value}}}}});
  };
  expect_parts_refused(reflector("radius_m", 1),
                       {".parts[0].reflector", "\"radius_m\" is not known", "focal_length_m"});
  expect_parts_refused(reflector("profile", "parabola"), {"\"profile\" must be one of paraboloid, ellipsoid"});
  expect_parts_refused(reflector("finish", "gold"), {"\"finish\" must be one of specular_aluminium"});
  expect_parts_refused(reflector("finish", {{"model", "gold"}}), {"reflector.finish", "\"model\" must be one of"});
  expect_parts_refused(reflector("focal_length_m", "1 cm"), {"\"focal_length_m\" must be a number of any size"});
  expect_parts_refused(reflector("position_m", {1, 2}), {"\"position_m\" must be an array of 3 numbers"});
  expect_parts_refused(reflector("rotation", {0, 0, 0, 0}), {"reflector", "rotation"});
  expect_parts_refused(reflector("points_m", json::array({{1, 2}})), {"\"points_m\" needs the profile polyline"});
  expect_parts_refused(reflector("points_m", {{1, 2}, {3}}), {"\"points_m\" must be an array of [r, z]", "element 1"});
  expect_parts_refused(reflector("facets_around", 2.5), {"\"facets_around\" must be a whole number"});
  expect_parts_refused(reflector("reflectance", -1), {"\"reflectance\" must be a number at least 0"});
  expect_parts_refused(json::array({{{"collimator", {{"flat_lens", true}, {"lens_radius_m", 1}}}}}),
                       {"\"flat_lens\"", "lens_radius_m"});
  SceneBuilder builder;
  builder.add_node({{"extras", {{"ups", {{"fixture", {{"part", json::array()}}}}}}}});
  expect_failure(builder, UPS_ERROR_PARSE, {"\"part\" is not known here", "dimming"});
  SceneBuilder none;
  none.add_node({{"extras", {{"ups", {{"fixture", json::object()}}}}}});
  expect_failure(none, UPS_ERROR_PARSE, {"\"parts\" is missing"});
  // What the core refuses has its place too.
  SceneBuilder core;
  core.add_node({{"name", "lamp"}, {"extras", with({disc, {{"reflector", {{"aperture_radius_m", -1}}}}})}});
  expect_failure(core, UPS_ERROR_INVALID_ARGUMENT, {lamp, ".parts[1].reflector: recorded core: aperture_radius_m"});
}

}  // namespace
