/* A room in sixty lines: a downlight, meters on a grid, lux. With the library installed:
 * cc small_room.c $(pkg-config --cflags --libs ups) -o small_room && ./small_room */
#include <stdio.h>
#include <stdlib.h>
#include <ups/ups.h>

static const char ies[] = "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 10 1 1 2 0 0 0\n1 1 20\n"
                          "0 10 20 30 40 50 60 70 80 90\n0\n1000 970 880 740 560 370 190 70 15 0\n";
static void check(ups_status status) {
  if (status == UPS_OK) return;
  fprintf(stderr, "%s\n", ups_last_error());
  exit(1);
}

int main(void) {
  static const float corners[] = {0, 0, 0,    4, 0, 0,    4, 3, 0,    0, 3, 0,       /* metres */
                                  0, 0, 2.6f, 4, 0, 2.6f, 4, 3, 2.6f, 0, 3, 2.6f};
  static const uint32_t faces[] = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5, /* seen from inside */
                                   1, 6, 2, 1, 5, 6, 2, 7, 3, 2, 6, 7, 3, 4, 0, 3, 7, 4};
  double places[12][3];
  float up[12][3] = {{0}};
  ups_meter_reading lux[12];
  ups_context *context; ups_scene *scene; ups_profile *profile; ups_result *result;
  ups_material_desc white; ups_mesh_desc mesh; ups_instance_desc room; ups_luminaire_desc lamp; ups_meter_desc grid;
  ups_render_desc render; ups_instance_id room_id; ups_luminaire_id lamp_id; ups_sensor_id meters;
  ups_meter_statistics all = {0};

  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  check(ups_profile_parse(context, ies, sizeof ies - 1, UPS_PROFILE_AUTO, &profile));
  ups_material_desc_init(&white, sizeof white), ups_mesh_desc_init(&mesh, sizeof mesh);
  ups_instance_desc_init(&room, sizeof room), ups_luminaire_desc_init(&lamp, sizeof lamp);
  ups_meter_desc_init(&grid, sizeof grid), ups_render_desc_init(&render, sizeof render);
  for (int i = 0; i < 3; ++i) white.reflectance_rgb[i] = 0.6f;
  check(ups_scene_add_material(scene, &white, &mesh.material));
  mesh.vertex_count = 8, mesh.positions_m = corners, mesh.triangle_count = 12, mesh.indices = faces;
  check(ups_scene_add_mesh(scene, &mesh, &room.mesh));
  check(ups_scene_add_instance(scene, &room, &room_id));
  lamp.profile = profile, lamp.to_world[3] = 2, lamp.to_world[7] = 1.5, lamp.to_world[11] = 2.5; /* 3x4, row-major */
  check(ups_scene_add_luminaire(scene, &lamp, &lamp_id));
  for (int i = 0; i < 12; ++i) {
    places[i][0] = i % 4 + 0.5, places[i][1] = i / 4 + 0.5, places[i][2] = 0.75;
    up[i][2] = 1;
  }
  all.struct_size = sizeof all;
  grid.count = 12, grid.positions_m = places[0], grid.normals = up[0];
  check(ups_scene_add_meters(scene, &grid, &meters));
  check(ups_scene_commit(scene));
  render.iteration_count = 256;
  check(ups_render(scene, &render, &result));
  check(ups_result_read_meters(result, meters, lux, 12));
  check(ups_result_get_meter_statistics(result, meters, &all));
  for (int i = 0; i < 12; ++i) printf("%6.1f +- %.1f lx\n", lux[i].illuminance_lx, lux[i].error_bound_lx);
  printf("UPS %u.%u.%u: mean %.6f lx\n", ups_version() / 10000, ups_version() / 100 % 100, ups_version() % 100,
         all.mean_lx);
  ups_result_destroy(result), ups_profile_destroy(profile), ups_scene_destroy(scene), ups_context_destroy(context);
  return 0;
}
