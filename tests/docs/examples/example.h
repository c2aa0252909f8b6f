/* What the examples share: checks, and a small room to light. What stands between [function] and [end] in them is shown
 * in the documentation of that function; each program checks what it gets, and ctest runs it. */
#ifndef UPS_EXAMPLE_H
#define UPS_EXAMPLE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <ups/ups.h>

/* Ends the program where a call failed, with the library's message. */
static inline void check(ups_status status) {
  if (status >= 0) return;
  fprintf(stderr, "%s: %s\n", ups_status_name(status), ups_last_error());
  exit(1);
}

#define expect(condition)                                                      \
  do {                                                                         \
    if (!(condition)) {                                                        \
      fprintf(stderr, "%s:%d: not so: %s\n", __FILE__, __LINE__, #condition); \
      exit(1);                                                                 \
    }                                                                          \
  } while (0)

static inline int near(double value, double wanted, double tolerance) { return fabs(value - wanted) <= tolerance; }

/* 4 m x 3 m, 2.5 m high, every surface matte of reflectance 0.5. */
static inline ups_instance_id add_room(ups_scene *scene) {
  static const float corners[24] = {0, 0, 0, 4, 0, 0, 0, 3, 0, 4, 3, 0, 0, 0, 2.5f, 4, 0, 2.5f, 0, 3, 2.5f, 4, 3, 2.5f};
  static const uint32_t triangles[36] = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                         1, 5, 7, 1, 7, 3, 3, 7, 6, 3, 6, 2, 2, 6, 4, 2, 4, 0};
  ups_material_desc matte;
  ups_mesh_desc mesh;
  ups_instance_desc instance;
  ups_instance_id id;
  ups_material_desc_init(&matte, sizeof matte);
  matte.reflectance_rgb[0] = matte.reflectance_rgb[1] = matte.reflectance_rgb[2] = 0.5f;
  ups_mesh_desc_init(&mesh, sizeof mesh);
  check(ups_scene_add_material(scene, &matte, &mesh.material));
  mesh.vertex_count = 8, mesh.triangle_count = 12, mesh.positions_m = corners, mesh.indices = triangles;
  ups_instance_desc_init(&instance, sizeof instance);
  check(ups_scene_add_mesh(scene, &mesh, &instance.mesh));
  check(ups_scene_add_instance(scene, &instance, &id));
  return id;
}

/* Round, 1000 cd straight down, with an opening of 0.2 m. */
static inline ups_profile *make_downlight(ups_context *context) {
  static const float c_deg[1] = {0}, gamma_deg[4] = {0, 30, 60, 90}, intensity_cd[4] = {1000, 800, 300, 0};
  ups_profile_desc desc;
  ups_profile *profile;
  ups_profile_desc_init(&desc, sizeof desc);
  desc.c_count = 1, desc.gamma_count = 4, desc.c_deg = c_deg, desc.gamma_deg = gamma_deg;
  desc.intensity_cd = intensity_cd, desc.opening_shape = UPS_OPENING_DISC;
  desc.opening_m[0] = desc.opening_m[1] = 0.2f;
  check(ups_profile_create(context, &desc, &profile));
  return profile;
}

/* Such a downlight beneath the ceiling. */
static inline ups_luminaire_id add_downlight(ups_context *context, ups_scene *scene, double x, double y) {
  ups_luminaire_desc desc;
  ups_luminaire_id id;
  ups_profile *profile = make_downlight(context);
  ups_luminaire_desc_init(&desc, sizeof desc);
  desc.profile = profile;
  desc.to_world[3] = x, desc.to_world[7] = y, desc.to_world[11] = 2.45;
  check(ups_scene_add_luminaire(scene, &desc, &id));
  ups_profile_destroy(profile);
  return id;
}

/* 2 x 2 meters of a kind at the height of a desk; normals up. */
enum { METERS = 4 };
static inline ups_sensor_id add_grid(ups_scene *scene, ups_meter_kind kind) {
  double at[3 * METERS];
  float up[3 * METERS] = {0};
  ups_meter_desc desc;
  ups_sensor_id id;
  for (int i = 0; i < METERS; ++i) {
    at[3 * i] = 0.5 + 2 * (i % 2), at[3 * i + 1] = 1 + i / 2, at[3 * i + 2] = 0.75;
    up[3 * i + 2] = 1;
  }
  ups_meter_desc_init(&desc, sizeof desc);
  desc.kind = kind, desc.count = METERS, desc.positions_m = at, desc.normals = up;
  check(ups_scene_add_meters(scene, &desc, &id));
  return id;
}

/* From a wall's middle into the room, 24 x 18 pixels. */
static inline ups_sensor_id add_view(ups_scene *scene, uint32_t layers) {
  static const double from_wall[12] = {1, 0, 0, 2, 0, 0, -1, 0.1, 0, 1, 0, 1.4};
  ups_camera_desc desc;
  ups_sensor_id id;
  ups_camera_desc_init(&desc, sizeof desc);
  desc.width = 24, desc.height = 18, desc.vertical_fov_rad = 1.2f, desc.layers = layers;
  memcpy(desc.to_world, from_wall, sizeof from_wall);
  check(ups_scene_add_camera(scene, &desc, &id));
  return id;
}

#endif
