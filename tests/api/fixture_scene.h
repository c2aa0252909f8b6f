// A scene that holds nothing, an empty fixture, parts that are right, and the flux that a render sends through cells.
// Called by the tests of fixtures.
#pragma once
#include <utility>

#include "fixture.h"

namespace ups_test {

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
    d.light_paths_per_iteration = 12000;
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
  // Beside `relative`, what triangles cost, at most 0.5 %: five standard errors, from 16 batches, of at most 0.07 %
  // each (P(|t_15| > 5) = 0.02 %), so that an error of 1 % is found in 97 cases of 100 and more.
  static void expect_flux(const Flux& found, double expected, double relative) {
    EXPECT_LE(relative, 0.005);
    EXPECT_GT(found.standard_error, 0);
    EXPECT_LE(found.standard_error, 0.0007 * expected);
    EXPECT_NEAR(found.lm, expected, 5 * found.standard_error + relative * expected);
  }

  ups_fixture* fixture = nullptr;
};

}  // namespace ups_test
