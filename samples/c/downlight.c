/* A downlight from a handful of numbers, four times in a room: a COB disc, a parabolic reflector, a frosted cover if
 * asked for; the light on a grid of meters, in lux.
 *
 *   downlight_c [iterations] [frosted]
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <ups/ups.h>

enum { COLUMNS = 6, ROWS = 4, METERS = COLUMNS * ROWS };
static const float room_m[3] = {4.8f, 3.2f, 2.6f};

static void check(ups_status status) {
  if (status == UPS_OK) return;
  fprintf(stderr, "%s: %s\n", ups_status_name(status), ups_last_error());
  exit(1);
}

/* The fixture's origin is the COB; light goes along local -Z. */
static ups_fixture *make_downlight(ups_context *context, int frosted) {
  ups_fixture *fixture;
  ups_fixture_emitter_desc cob;
  ups_reflector_desc cup;
  ups_lens_desc cover;
  check(ups_fixture_create(context, &fixture));

  ups_fixture_emitter_desc_init(&cob, sizeof cob);
  cob.radius_m = 0.0045;
  cob.flux_lm = 1000;
  check(ups_fixture_add_emitter(fixture, &cob, NULL));

  ups_reflector_desc_init(&cup, sizeof cup); /* a paraboloid of specular aluminium with its focus at the origin */
  cup.focal_length_m = 0.004;
  cup.inner_radius_m = 0.008; /* twice the focal length: the hole lies at the COB's height */
  cup.aperture_radius_m = 0.025;
  check(ups_fixture_add_reflector(fixture, &cup, NULL));

  if (frosted) {
    ups_lens_desc_init(&cover, sizeof cover); /* flat faces: a plate */
    cover.finish = UPS_FINISH_FROSTED_PMMA;
    cover.radius_m = 0.026;
    cover.thickness_m = 0.002;
    /* The reflector ends at z = f - r^2 / 4f = -35.06 mm. */
    cover.to_fixture[11] = -0.0351;
    check(ups_fixture_add_lens(fixture, &cover, NULL));
  }
  return fixture;
}

/* One quad of the room's box: bit 0, 1, 2 of a corner says whether it is at the far x, y, z. */
static void add_quad(ups_scene *scene, const int quad[4], float reflectance) {
  static const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  float positions[12];
  ups_material_desc material;
  ups_mesh_desc mesh;
  ups_instance_desc instance;
  ups_instance_id id;
  ups_material_desc_init(&material, sizeof material);
  for (int i = 0; i < 3; ++i) material.reflectance_rgb[i] = reflectance;
  for (int c = 0; c < 4; ++c)
    for (int axis = 0; axis < 3; ++axis)
      positions[3 * c + axis] = (quad[c] >> axis & 1) ? room_m[axis] : 0.0f;
  ups_mesh_desc_init(&mesh, sizeof mesh);
  mesh.vertex_count = 4;
  mesh.triangle_count = 2;
  mesh.positions_m = positions;
  mesh.indices = indices;
  check(ups_scene_add_material(scene, &material, &mesh.material));
  ups_instance_desc_init(&instance, sizeof instance);
  check(ups_scene_add_mesh(scene, &mesh, &instance.mesh));
  check(ups_scene_add_instance(scene, &instance, &id));
}

static void add_room(ups_scene *scene) {
  static const int quads[6][4] = {{0, 1, 3, 2}, {4, 6, 7, 5}, {0, 4, 5, 1}, {1, 5, 7, 3}, {3, 7, 6, 2}, {2, 6, 4, 0}};
  static const float reflectances[6] = {0.2f, 0.8f, 0.5f, 0.5f, 0.5f, 0.5f};
  for (int i = 0; i < 6; ++i) add_quad(scene, quads[i], reflectances[i]);
}

/* Cells at the height of a table, looking up. */
static ups_sensor_id add_meters(ups_scene *scene) {
  double positions[METERS * 3];
  float normals[METERS * 3] = {0}, tangents[METERS * 3] = {0};
  ups_meter_desc desc;
  ups_sensor_id id;
  for (int i = 0; i < METERS; ++i) {
    positions[3 * i] = (i % COLUMNS + 0.5) * room_m[0] / COLUMNS;
    positions[3 * i + 1] = (i / COLUMNS + 0.5) * room_m[1] / ROWS;
    positions[3 * i + 2] = 0.75;
    normals[3 * i + 2] = tangents[3 * i] = 1;
  }
  ups_meter_desc_init(&desc, sizeof desc);
  desc.count = METERS;
  desc.positions_m = positions;
  desc.normals = normals;
  desc.tangents = tangents;
  desc.cell_size_m[0] = room_m[0] / COLUMNS;
  desc.cell_size_m[1] = room_m[1] / ROWS;
  check(ups_scene_add_meters(scene, &desc, &id));
  return id;
}

int main(int argc, char **argv) {
  const int frosted = argc > 2 && strcmp(argv[2], "frosted") == 0;
  ups_context *context;
  ups_scene *scene;
  ups_fixture *fixture;
  ups_fixture_id placed;
  ups_fixture_instance_desc placement;
  ups_result *result;
  ups_sensor_id meters;
  ups_render_desc render;
  ups_meter_reading readings[METERS];
  ups_meter_statistics statistics;
  ups_result_info info;
  double on_meters;
  int wrong;

  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  add_room(scene);
  fixture = make_downlight(context, frosted);
  for (int i = 0; i < 4; ++i) {
    ups_fixture_instance_desc_init(&placement, sizeof placement);
    placement.to_world[3] = room_m[0] * (i % 2 ? 0.75 : 0.25);
    placement.to_world[7] = room_m[1] * (i / 2 ? 0.75 : 0.25);
    placement.to_world[11] = room_m[2] - 0.02;
    check(ups_scene_add_fixture(scene, fixture, &placement, &placed));
  }
  ups_fixture_destroy(fixture);
  meters = add_meters(scene);
  check(ups_scene_commit(scene));

  ups_render_desc_init(&render, sizeof render);
  render.iteration_count = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 32;
  check(ups_render(scene, &render, &result));
  check(ups_result_read_meters(result, meters, readings, METERS));
  statistics.struct_size = sizeof statistics;
  check(ups_result_get_meter_statistics(result, meters, &statistics));
  info.struct_size = sizeof info;
  check(ups_result_get_info(result, &info));

  printf("Four downlights of 1000 lm; illuminance at 0.75 m, lx\n");
  for (int row = ROWS - 1; row >= 0; --row) {
    for (int column = 0; column < COLUMNS; ++column) {
      const ups_meter_reading *r = &readings[row * COLUMNS + column];
      printf("%6.1f +- %-5.1f", r->illuminance_lx, r->error_bound_lx);
    }
    printf("\n");
  }
  on_meters = statistics.mean_lx * room_m[0] * room_m[1];
  printf("mean %.1f lx, uniformity %.2f; %.0f of %.0f lm cross the plane downwards\n", statistics.mean_lx,
         statistics.uniformity, on_meters, info.emitted_flux_lm);

  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  /* Light is neither lost nor made: some of it reaches the plane, and what the floor sends back cannot double it. */
  wrong = info.emitted_flux_lm < 3999 || info.emitted_flux_lm > 4001 || on_meters < 1000 || on_meters > 4500;
  if (wrong) fprintf(stderr, "the downlights do not give what they should\n");
  return wrong;
}
