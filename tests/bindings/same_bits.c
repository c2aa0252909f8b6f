/* Writes what a render of one small scene found, as it lies in memory: the file that bindings are held against, whose
 * renders of the same scene and seed must have the same bits.
 *
 *   same_bits FILE       35 meter readings, then the 24 x 16 image, 3 floats a pixel
 */
#include <stdio.h>
#include <stdlib.h>
#include <ups/ups.h>

enum { METERS = 35, WIDTH = 24, HEIGHT = 16 };

static void check(ups_status status) {
  if (status == UPS_OK) return;
  fprintf(stderr, "%s: %s\n", ups_status_name(status), ups_last_error());
  exit(1);
}

/* A box of 4 x 3 x 2.5 m, a little glossy, and a plate in it that casts a shadow. */
static void add_surfaces(ups_scene *scene) {
  static const float positions[] = {0, 0, 0,    4, 0, 0,    4, 3, 0,    0, 3, 0,    0, 0, 2.5f, 4, 0, 2.5f,
                                    4, 3, 2.5f, 0, 3, 2.5f, 1, 1, 1.5f, 2, 1, 1.5f, 2, 2, 1.5f, 1, 2, 1.5f};
  static const uint32_t indices[] = {0, 1, 2, 0, 2, 3, 4, 6, 5, 4, 7, 6, 0, 5, 1, 0, 4, 5, 1, 6, 2, 1, 5, 6,
                                     2, 7, 3, 2, 6, 7, 3, 4, 0, 3, 7, 4, 8, 9, 10, 8, 10, 11};
  ups_material_desc material;
  ups_mesh_desc mesh;
  ups_instance_desc instance;
  ups_instance_id id;
  ups_material_desc_init(&material, sizeof material);
  material.model = UPS_MATERIAL_PLASTIC;
  material.reflectance_rgb[0] = 0.5f;
  material.reflectance_rgb[1] = 0.6f;
  material.reflectance_rgb[2] = 0.7f;
  material.roughness = 0.4f;
  ups_mesh_desc_init(&mesh, sizeof mesh);
  mesh.vertex_count = sizeof positions / sizeof *positions / 3;
  mesh.triangle_count = sizeof indices / sizeof *indices / 3;
  mesh.positions_m = positions;
  mesh.indices = indices;
  check(ups_scene_add_material(scene, &material, &mesh.material));
  ups_instance_desc_init(&instance, sizeof instance);
  check(ups_scene_add_mesh(scene, &mesh, &instance.mesh));
  check(ups_scene_add_instance(scene, &instance, &id));
}

static void add_luminaire(ups_context *context, ups_scene *scene) {
  static const float c_deg[] = {0}, gamma_deg[] = {0, 30, 60, 90}, intensity_cd[] = {1000, 740, 190, 0};
  ups_profile_desc desc;
  ups_profile *profile;
  ups_luminaire_desc luminaire;
  ups_luminaire_id id;
  ups_profile_desc_init(&desc, sizeof desc);
  desc.c_count = 1;
  desc.gamma_count = 4;
  desc.c_deg = c_deg;
  desc.gamma_deg = gamma_deg;
  desc.intensity_cd = intensity_cd;
  check(ups_profile_create(context, &desc, &profile));
  ups_luminaire_desc_init(&luminaire, sizeof luminaire);
  luminaire.profile = profile;
  luminaire.to_world[3] = 2;
  luminaire.to_world[7] = 1.5;
  luminaire.to_world[11] = 2.4;
  check(ups_scene_add_luminaire(scene, &luminaire, &id));
  ups_profile_destroy(profile);
}

static ups_sensor_id add_meters(ups_scene *scene) {
  double positions[3 * METERS];
  float normals[3 * METERS] = {0};
  ups_meter_desc desc;
  ups_sensor_id id;
  for (int i = 0; i < METERS; ++i) {
    positions[3 * i] = (i % 7 + 0.5) * 4 / 7;
    positions[3 * i + 1] = (i / 7 + 0.5) * 3 / 5;
    positions[3 * i + 2] = 0.75;
    normals[3 * i + 2] = 1;
  }
  ups_meter_desc_init(&desc, sizeof desc);
  desc.count = METERS;
  desc.positions_m = positions;
  desc.normals = normals;
  check(ups_scene_add_meters(scene, &desc, &id));
  return id;
}

/* From one end of the box along +X, +Z up. */
static ups_sensor_id add_camera(ups_scene *scene) {
  static const double to_world[12] = {0, 0, -1, 0.5, -1, 0, 0, 1.5, 0, 1, 0, 1.25};
  ups_camera_desc desc;
  ups_sensor_id id;
  ups_camera_desc_init(&desc, sizeof desc);
  desc.width = WIDTH;
  desc.height = HEIGHT;
  for (int i = 0; i < 12; ++i) desc.to_world[i] = to_world[i];
  check(ups_scene_add_camera(scene, &desc, &id));
  return id;
}

int main(int argc, char **argv) {
  static ups_meter_reading readings[METERS];
  static float image[3 * WIDTH * HEIGHT];
  ups_context *context;
  ups_scene *scene;
  ups_render_desc render;
  ups_result *result;
  ups_sensor_id meters, camera;
  FILE *file;

  if (argc != 2) return 2;
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  add_surfaces(scene);
  add_luminaire(context, scene);
  meters = add_meters(scene);
  camera = add_camera(scene);
  check(ups_scene_commit(scene));
  ups_render_desc_init(&render, sizeof render);
  render.method = UPS_METHOD_UPS;
  render.iteration_count = 8;
  render.seed = 20;
  check(ups_render(scene, &render, &result));
  check(ups_result_read_meters(result, meters, readings, METERS));
  check(ups_result_read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB, image, 0, sizeof image));
  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);

  file = fopen(argv[1], "wb");
  if (!file || fwrite(readings, sizeof readings, 1, file) != 1 || fwrite(image, sizeof image, 1, file) != 1 ||
      fclose(file) != 0) {
    fprintf(stderr, "same_bits: cannot write %s\n", argv[1]);
    return 1;
  }
  return 0;
}
