// Fixtures: parts and their errors, placing, sharing, dimming, moving, removing; and whether light does in them what
// geometrical optics says. Renders fix their seed and compare flux through cells with closed forms within five of the
// reported standard errors (a false alarm in about 2 million checks, and none once the seed passes) and what triangles
// cost, as stated at each.
#include "fixture.h"

#include <cmath>
#include <functional>

namespace ups_test {
namespace {

constexpr double pi = 3.14159265358979;

class Fixtures : public Api {
 protected:
  Fixtures() {
    EXPECT_OK(ups_scene_remove_instance(scene, instance));  // only what the tests add
    EXPECT_OK(ups_fixture_create(context, &fixture));
  }
  ~Fixtures() override { ups_fixture_destroy(fixture); }

  ups_fixture_emitter_desc cob(double radius_m, float flux_lm) {
    auto d = make(&ups_fixture_emitter_desc_init);
    d.radius_m = radius_m, d.flux_lm = flux_lm;
    return d;
  }
  ups_reflector_desc cup() {
    auto d = make(&ups_reflector_desc_init);
    d.focal_length_m = 0.02, d.aperture_radius_m = 0.06;
    return d;
  }
  ups_lens_desc plate() {
    auto d = make(&ups_lens_desc_init);
    d.radius_m = 0.03, d.thickness_m = 0.003;
    return d;
  }
  ups_collimator_desc collimator() {
    auto d = make(&ups_collimator_desc_init);
    d.cavity_radius_m = 0.004, d.cavity_depth_m = 0.005, d.wall_thickness_m = 0.001;
    return d;
  }
  ups_fixture_info info() {
    ups_fixture_info i{};
    i.struct_size = sizeof i;
    EXPECT_OK(ups_fixture_get_info(fixture, &i));
    return i;
  }
  ups_scene_info scene_info() {
    ups_scene_info i{};
    i.struct_size = sizeof i;
    EXPECT_OK(ups_scene_commit(scene));
    EXPECT_OK(ups_scene_get_info(scene, &i));
    return i;
  }
  ups_fixture_id place(double x = 0, double y = 0, double z = 0) {
    auto d = make(&ups_fixture_instance_desc_init);
    d.to_world[3] = x, d.to_world[7] = y, d.to_world[11] = z;
    ups_fixture_id id{};
    EXPECT_OK(ups_scene_add_fixture(scene, fixture, &d, &id));
    return id;
  }
  // A square cell, facing up, on the axis.
  ups_sensor_id cell(double side_m, double z) {
    const double position[3] = {0, 0, z};
    const float normal[3] = {0, 0, 1}, tangent[3] = {1, 0, 0};
    auto d = make(&ups_meter_desc_init);
    d.count = 1, d.positions_m = position, d.normals = normal, d.tangents = tangent;
    d.cell_size_m[0] = d.cell_size_m[1] = float(side_m);
    ups_sensor_id id{};
    EXPECT_OK(ups_scene_add_meters(scene, &d, &id));
    return id;
  }
  struct Flux {
    double lm, standard_error;
  };
  // Through cells, by the light paths that land on them.
  std::vector<Flux> flux(const std::vector<std::pair<ups_sensor_id, double>>& cells, uint32_t iterations) {
    EXPECT_OK(ups_scene_commit(scene));
    auto d = make(&ups_render_desc_init);
    d.method = UPS_METHOD_LIGHT_TRACING, d.iteration_count = iterations, d.seed = 7;
    d.light_paths_per_iteration = 20000;
    ups_result* result = nullptr;
    EXPECT_OK(ups_render(scene, &d, &result));
    std::vector<Flux> out;
    for (const auto& [id, side] : cells) {
      ups_meter_reading r{};
      EXPECT_OK(ups_result_read_meters(result, id, &r, 1));
      out.push_back({double(r.illuminance_lx) * side * side, double(r.standard_error_lx) * side * side});
    }
    ups_result_destroy(result);
    return out;
  }
  static void expect_flux(const Flux& found, double expected, double relative) {
    EXPECT_GT(found.standard_error, 0);
    EXPECT_LT(found.standard_error, 0.01 * expected);
    EXPECT_NEAR(found.lm, expected, 5 * found.standard_error + relative * expected);
  }

  ups_fixture* fixture = nullptr;
};

TEST_F(Fixtures, EmittedFluxIsWhatWasAskedFor) {
  ups_fixture_part_id part{};
  auto d = cob(0.0045, 1000);
  d.color_rgb[2] = 0.3f;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &d, &part));
  EXPECT_EQ(part.v, 1u);
  d = cob(0, 200);
  d.shape = UPS_EMITTER_RECTANGLE, d.width_m = 0.1, d.length_m = 0.02;
  d.to_fixture[11] = 0.05;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &d, nullptr));
  d = cob(0.001, 30);
  d.shape = UPS_EMITTER_SPHERE;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &d, nullptr));
  d.shape = UPS_EMITTER_CYLINDER, d.length_m = 0.01, d.flux_lm = 4;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &d, &part));
  EXPECT_EQ(part.v, 4u);
  const ups_fixture_info i = info();
  EXPECT_EQ(i.part_count, 4u);
  EXPECT_NEAR(i.flux_lm, 1234, 1e-3);
  EXPECT_NEAR(i.emitter_area_m2, pi * 0.0045 * 0.0045 + 0.002 + 4 * pi * 1e-6 + pi * (2 * 0.001 * 0.01 + 2 * 1e-6),
              1e-6);
  place(3, 4, 2.7);
  ups_scene_info s = scene_info();
  EXPECT_NEAR(s.emitted_flux_lm / 1234, 1, 2e-5);  // single precision of millimetres, metres from the scene's centre
  EXPECT_EQ(s.emissive_instance_count, 4u);
  EXPECT_EQ(s.triangle_count, i.triangle_count);
  place(-3, 4, 2.7);
  EXPECT_NEAR(scene_info().emitted_flux_lm / 2468, 1, 1e-4);
}

TEST_F(Fixtures, AreDimmedMovedScaledAndRemoved) {
  const auto emitter = cob(0.01, 1000);
  const auto reflector = cup();
  EXPECT_OK(ups_fixture_add_emitter(fixture, &emitter, nullptr));
  EXPECT_OK(ups_fixture_add_reflector(fixture, &reflector, nullptr));
  const ups_fixture_id first = place(0, 0, 1);
  auto d = make(&ups_fixture_instance_desc_init);
  d.flux_lm = 300, d.dimming = 0.5f;
  ups_fixture_id second{};
  EXPECT_OK(ups_scene_add_fixture(scene, fixture, &d, &second));
  EXPECT_NE(first.v, second.v);
  ups_fixture_destroy(fixture);  // the scene keeps what it needs
  fixture = nullptr;
  EXPECT_NEAR(scene_info().emitted_flux_lm, 1150, 0.1);
  EXPECT_OK(ups_scene_set_fixture_dimming(scene, second, 2));
  EXPECT_NEAR(scene_info().emitted_flux_lm, 1600, 0.1);
  EXPECT_OK(ups_scene_set_fixture_dimming(scene, first, 0));
  EXPECT_NEAR(scene_info().emitted_flux_lm, 600, 0.1);
  EXPECT_OK(ups_scene_set_fixture_dimming(scene, first, 1));
  // Head over: the paraboloid's vertex, f above its focus, goes down.
  const double turned[12] = {1, 0, 0, 5, 0, -1, 0, 0, 0, 0, -1, 2};
  EXPECT_OK(ups_scene_set_fixture_transform(scene, second, turned));
  ups_scene_info s = scene_info();
  EXPECT_NEAR(s.bounds_max_m[0], 5.06, 1e-5);
  EXPECT_NEAR(s.bounds_max_m[2], 2 + 0.045 - 0.02, 1e-5);  // rim at f - R^2 / 4f = -0.025
  EXPECT_NEAR(s.bounds_min_m[2], 1 - 0.025, 1e-5);
  const uint64_t both = s.triangle_count;
  EXPECT_OK(ups_scene_remove_fixture(scene, first));
  s = scene_info();
  EXPECT_NEAR(s.emitted_flux_lm, 600, 0.1);
  EXPECT_EQ(s.triangle_count, both / 2);
  expect_error(ups_scene_remove_fixture(scene, first), UPS_ERROR_INVALID_ARGUMENT, {"fixture id 1 was removed"});
  expect_error(ups_scene_set_fixture_dimming(scene, {9}, 1), UPS_ERROR_INVALID_ARGUMENT, {"fixture id 9"});
  expect_error(ups_scene_set_fixture_dimming(scene, second, -1), UPS_ERROR_INVALID_ARGUMENT, {"dimming is -1"});
  expect_error(ups_scene_set_fixture_dimming(scene, second, NAN), UPS_ERROR_INVALID_ARGUMENT, {"dimming is nan"});
  expect_error(ups_scene_set_fixture_transform(scene, second, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"to_world"});
}

// ---- light ----

// Share of a sphere's light that a paraboloid around it catches: (1 - cos psi) / 2, tan(psi / 2) = R / 2f.
TEST_F(Fixtures, ParaboloidSendsWhatItCatchesDown) {
  auto source = cob(0.001, 1000);
  source.shape = UPS_EMITTER_SPHERE;
  auto reflector = cup();
  reflector.aperture_radius_m = 0.04, reflector.finish_reflectance = 0.9f;
  reflector.chord_tolerance_m = 2e-5;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &source, nullptr));
  EXPECT_OK(ups_fixture_add_reflector(fixture, &reflector, nullptr));
  place();
  const double side = 0.1, below = 0.05;  // of the focus; the rim lies at its height
  const auto meters = cell(side, -below);
  // R = 2f: psi = 90 degrees, half of the light; the beam spreads by less than r / f over 0.07 m. Straight light: the
  // cell's solid angle. Of the light, r^2 / 4 f^2 and less returns to the source: below 0.07 %.
  const double a = side / 2, direct = 1000 * std::asin(a * a / (a * a + below * below)) * 4 / (4 * pi);
  expect_flux(flux({{meters, side}}, 16)[0], 0.9 * 500 + direct, 0.0015);
}

// Sum of distances 2a: all that the ellipsoid catches lands at the other focus, magnified (a + c) / (a - c) at most.
TEST_F(Fixtures, EllipsoidGathersInItsOtherFocus) {
  auto source = cob(0.001, 1000);
  source.shape = UPS_EMITTER_SPHERE;
  auto reflector = make(&ups_reflector_desc_init);
  reflector.profile = UPS_REFLECTOR_ELLIPSOID;
  reflector.semi_axis_m = 0.1, reflector.half_distance_m = 0.05, reflector.aperture_radius_m = 0.075;
  reflector.finish = UPS_FINISH_ENHANCED_ALUMINIUM;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &source, nullptr));
  EXPECT_OK(ups_fixture_add_reflector(fixture, &reflector, nullptr));
  place();
  const double side = 2 * 3 * 0.001 * 1.05, below = 0.1, a = side / 2;
  const auto meters = cell(side, -below);
  const double direct = 1000 * std::asin(a * a / (a * a + below * below)) * 4 / (4 * pi);
  // The source takes back the light of mirror within r / a of the vertex; triangles turn light by up to twice 0.1 deg,
  // so some of the image's edge misses a cell that is 5 % wider.
  expect_flux(flux({{meters, side}}, 16)[0], 0.95 * 500 + direct, 0.005);
}

// A small disc in the focus of a hyperboloid lens, and of a TIR collimator: the light leaves parallel, in a beam no
// wider than the aperture plus the divergence of the source.
TEST_F(Fixtures, CollimatorKeepsItsLightTogether) {
  auto source = cob(0.00005, 100);
  source.to_fixture[11] = -0.00001;
  auto d = collimator();
  d.finish_absorption_per_m = 0;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &source, nullptr));
  EXPECT_OK(ups_fixture_add_collimator(fixture, &d, nullptr));
  place();
  // The exit's radius is 14.3 mm, the divergence at 0.3 m 0.3 * 1.49 * 0.05 / 5 mm: within a radius of 20 mm.
  const auto inside = cell(0.04, -0.3), around = cell(0.4, -0.3001);
  const std::vector<Flux> found = flux({{inside, 0.04}, {around, 0.4}}, 8);
  // Two interfaces at least: more than 85 % of all light gets through, and what Fresnel reflects goes elsewhere.
  EXPECT_GT(found[0].lm, 85);
  EXPECT_LT(found[0].lm, 100 * 0.96 * 0.96);  // both faces take (n - 1)^2 / (n + 1)^2 = 3.9 % at least
  EXPECT_LT(found[1].lm - found[0].lm, 4);
}

// All light that leaves a source in a closed black box around lossless optics arrives.
TEST_F(Fixtures, LosslessOpticsLoseNothing) {
  auto source = cob(0.003, 100);
  auto d = plate();
  d.finish = UPS_FINISH_GLASS, d.finish_absorption_per_m = 0, d.exit_radius_m = 0.05, d.thickness_m = 0.012;
  d.to_fixture[11] = -0.01;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &source, nullptr));
  EXPECT_OK(ups_fixture_add_lens(fixture, &d, nullptr));
  place();
  cell(0.1, -1);
  EXPECT_OK(ups_scene_commit(scene));
  auto render = make(&ups_render_desc_init);
  render.method = UPS_METHOD_LIGHT_TRACING, render.iteration_count = 8, render.light_paths_per_iteration = 20000;
  ups_result* result = nullptr;
  EXPECT_OK(ups_render(scene, &render, &result));
  ups_result_info i{};
  i.struct_size = sizeof i;
  EXPECT_OK(ups_result_get_info(result, &i));
  ups_result_destroy(result);
  // What the disc, black, takes back of the light that the lens reflects is absorbed; the rest escapes. The balance of
  // these samples is exact but for rounding and for paths that roulette ends or lengthens.
  EXPECT_NEAR(i.emitted_flux_lm, 100, 0.01);
  EXPECT_NEAR(i.absorbed_flux_lm + i.escaped_flux_lm, 100, 0.2);
  EXPECT_LT(i.absorbed_flux_lm, 8);
}

// A source of a millimetre in the very middle of the scene, seen from far: shadow rays must not end behind its surface,
// however exact its own coordinates are. The emitter's polyhedron has I = flux / 4 pi but for what its facets cost.
TEST_F(Fixtures, SmallSourceInTheMiddleLightsWhatIsFar) {
  auto source = cob(0.001, 100);
  source.shape = UPS_EMITTER_SPHERE;
  EXPECT_OK(ups_fixture_add_emitter(fixture, &source, nullptr));
  place();
  const double positions[6] = {0, 0, -0.3, 0, 0, 0.3};
  const float up[6] = {0, 0, 1, 0, 0, -1};
  auto d = make(&ups_meter_desc_init);
  d.count = 2, d.positions_m = positions, d.normals = up;
  ups_sensor_id id{};
  EXPECT_OK(ups_scene_add_meters(scene, &d, &id));
  EXPECT_OK(ups_scene_commit(scene));
  auto render = make(&ups_render_desc_init);
  render.method = UPS_METHOD_PATH_TRACING, render.iteration_count = 256, render.seed = 3;
  ups_result* result = nullptr;
  EXPECT_OK(ups_render(scene, &render, &result));
  ups_meter_reading r[2]{};
  EXPECT_OK(ups_result_read_meters(result, id, r, 2));
  ups_result_destroy(result);
  const double expected = 100 / (4 * pi) / 0.09;
  for (const ups_meter_reading& reading : r)
    EXPECT_NEAR(double(reading.illuminance_lx), expected, 5 * double(reading.standard_error_lx) + 0.002 * expected);
}

// ---- errors ----

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
       {[](D& d) { d.finish_reflectance = 1.5f; }, {"reflectance_rgb[0] is 1.5"}},
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
       {[](D& d) { d.profile = UPS_REFLECTOR_CONE, d.focal_length_m = 0; }, {"depth_m is 0"}}});
}

TEST_F(Fixtures, LensFields) {
  using D = ups_lens_desc;
  expect_refused<D>(fixture, plate(), &ups_fixture_add_lens, "lens",
                    {{[](D& d) { d.radius_m = -1; }, {"radius_m is -1"}},
                     {[](D& d) { d.thickness_m = 0; }, {"thickness_m is 0"}},
                     {[](D& d) { d.exit_radius_m = 0.05; }, {"thickness_m is 0.003", "faces cross"}},
                     {[](D& d) { d.entry_radius_m = 0.02; }, {"entry_radius_m is 0.02", "rim"}},
                     {[](D& d) { d.entry_conic = NAN; }, {"entry_conic"}},
                     {[](D& d) { d.exit_coefficients[3] = INFINITY; }, {"exit_coefficients[3]"}},
                     {[](D& d) { d.finish = UPS_FINISH_OPAL; }, {"finish", "solid"}},
                     {[](D& d) { d.finish_ior = 0.5f; }, {"ior is 0.5"}},
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
  expect_refused<D>(fixture, good, &ups_fixture_add_part, "mesh",
                    {{[](D& d) { d.mesh = nullptr; }, {"mesh is NULL"}},
                     {[&](D& d) { d.mesh = &with_material; }, {"material is", "must be 0"}},
                     {[&](D& d) { d.mesh = &broken; }, {"indices: element 2 is 2"}},
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
}

}  // namespace
}  // namespace ups_test
