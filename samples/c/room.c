/* The smallest whole program: an empty room, one downlight, 8 x 6 illuminance meters; the light on each, in lux.
 *
 *   room_c [iterations]        more iterations, smaller errors; with very few the error is not known: -1
 */
#include <stdio.h>
#include <stdlib.h>
#include <ups/ups.h>

enum { COLUMNS = 8, ROWS = 6, METERS = COLUMNS * ROWS };
static const float room_m[3] = {4.0f, 3.0f, 2.6f};

static void check(ups_status status) {
  if (status == UPS_OK) return;
  fprintf(stderr, "%s: %s\n", ups_status_name(status), ups_last_error());
  exit(1);
}

static ups_material_id add_matte(ups_scene *scene, float reflectance) {
  ups_material_desc desc;
  ups_material_id id;
  ups_material_desc_init(&desc, sizeof desc);
  desc.reflectance_rgb[0] = desc.reflectance_rgb[1] = desc.reflectance_rgb[2] = reflectance;
  check(ups_scene_add_material(scene, &desc, &id));
  return id;
}

/* Some quads of the room's box, four corners each: bit 0, 1, 2 of a corner says whether it is at the far x, y, z. */
static void add_quads(ups_scene *scene, ups_material_id material, const int (*quads)[4], uint32_t count) {
  float positions[4 * 4 * 3];
  uint32_t indices[4 * 6];
  static const uint32_t corners[6] = {0, 1, 2, 0, 2, 3};
  ups_mesh_desc mesh;
  ups_instance_desc instance;
  ups_instance_id instance_id;
  for (uint32_t q = 0; q < count; ++q) {
    for (uint32_t c = 0; c < 4; ++c)
      for (uint32_t axis = 0; axis < 3; ++axis)
        positions[(4 * q + c) * 3 + axis] = (quads[q][c] >> axis & 1) ? room_m[axis] : 0.0f;
    for (uint32_t i = 0; i < 6; ++i) indices[6 * q + i] = 4 * q + corners[i];
  }
  ups_mesh_desc_init(&mesh, sizeof mesh);
  mesh.vertex_count = 4 * count;
  mesh.triangle_count = 2 * count;
  mesh.positions_m = positions;
  mesh.indices = indices;
  mesh.material = material;
  ups_instance_desc_init(&instance, sizeof instance);
  check(ups_scene_add_mesh(scene, &mesh, &instance.mesh));
  check(ups_scene_add_instance(scene, &instance, &instance_id));
}

static void add_room(ups_scene *scene) {
  static const int floor[1][4] = {{0, 1, 3, 2}};
  static const int ceiling[1][4] = {{4, 6, 7, 5}};
  static const int walls[4][4] = {{0, 4, 5, 1}, {1, 5, 7, 3}, {3, 7, 6, 2}, {2, 6, 4, 0}};
  add_quads(scene, add_matte(scene, 0.2f), floor, 1);
  add_quads(scene, add_matte(scene, 0.8f), ceiling, 1);
  add_quads(scene, add_matte(scene, 0.5f), walls, 4);
}

/* From a table of intensities; ups_profile_parse reads photometric files instead. */
static void add_downlight(ups_context *context, ups_scene *scene) {
  static const float c_deg[1] = {0};
  static const float gamma_deg[10] = {0, 10, 20, 30, 40, 50, 60, 70, 80, 90};
  static const float intensity_cd[10] = {1000, 970, 880, 740, 560, 370, 190, 70, 15, 0};
  ups_profile_desc desc;
  ups_profile *profile;
  ups_luminaire_desc luminaire;
  ups_luminaire_id id;
  ups_profile_desc_init(&desc, sizeof desc);
  desc.c_count = 1;
  desc.gamma_count = 10;
  desc.c_deg = c_deg;
  desc.gamma_deg = gamma_deg;
  desc.intensity_cd = intensity_cd;
  check(ups_profile_create(context, &desc, &profile));
  ups_luminaire_desc_init(&luminaire, sizeof luminaire);
  luminaire.profile = profile;
  luminaire.to_world[3] = room_m[0] / 2;
  luminaire.to_world[7] = room_m[1] / 2;
  luminaire.to_world[11] = room_m[2] - 0.1;
  check(ups_scene_add_luminaire(scene, &luminaire, &id));
  ups_profile_destroy(profile);
}

/* On a grid at the height of a table, looking up. */
static ups_sensor_id add_meters(ups_scene *scene) {
  double positions[METERS * 3];
  float normals[METERS * 3];
  ups_meter_desc desc;
  ups_sensor_id id;
  for (int i = 0; i < METERS; ++i) {
    positions[3 * i] = (i % COLUMNS + 0.5) * room_m[0] / COLUMNS;
    positions[3 * i + 1] = (i / COLUMNS + 0.5) * room_m[1] / ROWS;
    positions[3 * i + 2] = 0.75;
    normals[3 * i] = normals[3 * i + 1] = 0;
    normals[3 * i + 2] = 1;
  }
  ups_meter_desc_init(&desc, sizeof desc);
  desc.count = METERS;
  desc.positions_m = positions;
  desc.normals = normals;
  check(ups_scene_add_meters(scene, &desc, &id));
  return id;
}

int main(int argc, char **argv) {
  ups_context *context;
  ups_scene *scene;
  ups_result *result;
  ups_sensor_id meters;
  ups_render_desc render;
  ups_meter_reading readings[METERS];
  ups_meter_statistics statistics;
  int dark = 0;

  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  add_room(scene);
  add_downlight(context, scene);
  meters = add_meters(scene);
  check(ups_scene_commit(scene));

  ups_render_desc_init(&render, sizeof render);
  render.iteration_count = argc > 1 ? (uint32_t)strtoul(argv[1], NULL, 10) : 32;
  check(ups_render(scene, &render, &result));
  check(ups_result_read_meters(result, meters, readings, METERS));
  statistics.struct_size = sizeof statistics;
  check(ups_result_get_meter_statistics(result, meters, &statistics));

  printf("Illuminance at 0.75 m, lx\n");
  for (int row = ROWS - 1; row >= 0; --row) {
    for (int column = 0; column < COLUMNS; ++column) {
      const ups_meter_reading *r = &readings[row * COLUMNS + column];
      printf("%6.1f +- %-5.1f", r->illuminance_lx, r->error_bound_lx);
      dark += !(r->illuminance_lx > 0);
    }
    printf("\n");
  }
  printf("mean %.1f lx, uniformity %.2f\n", statistics.mean_lx, statistics.uniformity);

  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  if (dark) fprintf(stderr, "%d meters got no light\n", dark);
  return dark != 0;
}
