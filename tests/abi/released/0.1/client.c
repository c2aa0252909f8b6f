/* A program of the first 0.1, compiled with the header beside it and never again with a newer one: a room of a
 * luminaire, meters, a camera and an observer, rendered as a job. Behind every struct that the library fills stand bytes
 * that it must not touch. The first meter's direct light is 900 cd / (2 m)^2. */
#include <stdio.h>
#include <string.h>
#include <ups/ups.h>

#define CHECK(call)                                                                  \
  do {                                                                               \
    const ups_status status = (call);                                                \
    if (status != UPS_OK) {                                                          \
      fprintf(stderr, "%d: %s: %s\n", __LINE__, #call, ups_last_error());            \
      return 1;                                                                      \
    }                                                                                \
  } while (0)
#define EXPECT(condition)                                                \
  do {                                                                   \
    if (!(condition)) {                                                  \
      fprintf(stderr, "%d: expected %s\n", __LINE__, #condition);        \
      return 1;                                                          \
    }                                                                    \
  } while (0)
#define GUARDED(type, name) \
  struct {                  \
    type v;                 \
    unsigned char end[256]; \
  } name;                   \
  memset(&name, 0xA5, sizeof name)

static int is_untouched(const unsigned char *end) {
  int touched = 0;
  for (int i = 0; i < 256; ++i) touched += end[i] != 0xA5;
  return touched == 0;
}

/* A box of 4 x 4 x 3 m, seen from inside. */
static int add_room(ups_scene *scene) {
  static const float corners[24] = {0, 0, 0, 4, 0, 0, 0, 4, 0, 4, 4, 0, 0, 0, 3, 4, 0, 3, 0, 4, 3, 4, 4, 3};
  static const uint32_t triangles[36] = {0, 1, 3, 0, 3, 2, 4, 6, 7, 4, 7, 5, 0, 4, 5, 0, 5, 1,
                                         1, 5, 7, 1, 7, 3, 3, 7, 6, 3, 6, 2, 2, 6, 4, 2, 4, 0};
  GUARDED(ups_material_desc, material);
  GUARDED(ups_mesh_desc, mesh);
  GUARDED(ups_instance_desc, instance);
  ups_instance_id instance_id;
  ups_material_desc_init(&material.v, sizeof material.v);
  material.v.reflectance_rgb[0] = material.v.reflectance_rgb[1] = material.v.reflectance_rgb[2] = 0.5f;
  ups_mesh_desc_init(&mesh.v, sizeof mesh.v);
  CHECK(ups_scene_add_material(scene, &material.v, &mesh.v.material));
  mesh.v.vertex_count = 8;
  mesh.v.triangle_count = 12;
  mesh.v.positions_m = corners;
  mesh.v.indices = triangles;
  ups_instance_desc_init(&instance.v, sizeof instance.v);
  CHECK(ups_scene_add_mesh(scene, &mesh.v, &instance.v.mesh));
  CHECK(ups_scene_add_instance(scene, &instance.v, &instance_id));
  EXPECT(is_untouched(material.end) && is_untouched(mesh.end) && is_untouched(instance.end));
  return 0;
}

static int add_luminaire(ups_context *context, ups_scene *scene) {
  static const float c_deg[1] = {0}, gamma_deg[3] = {0, 60, 90}, intensity_cd[3] = {900, 450, 0};
  GUARDED(ups_profile_desc, table);
  GUARDED(ups_luminaire_desc, luminaire);
  ups_luminaire_id id;
  ups_profile_desc_init(&table.v, sizeof table.v);
  table.v.c_count = 1;
  table.v.gamma_count = 3;
  table.v.c_deg = c_deg;
  table.v.gamma_deg = gamma_deg;
  table.v.intensity_cd = intensity_cd;
  ups_luminaire_desc_init(&luminaire.v, sizeof luminaire.v);
  CHECK(ups_profile_create(context, &table.v, (ups_profile **)&luminaire.v.profile));
  luminaire.v.to_world[3] = luminaire.v.to_world[7] = 2;
  luminaire.v.to_world[11] = 2.5;
  CHECK(ups_scene_add_luminaire(scene, &luminaire.v, &id));
  EXPECT(is_untouched(table.end) && is_untouched(luminaire.end));
  ups_profile_destroy((ups_profile *)luminaire.v.profile);
  return 0;
}

static int add_sensors(ups_scene *scene, ups_sensor_id *meters, ups_sensor_id *camera, ups_sensor_id *observer) {
  static const double positions[6] = {2, 2, 0.5, 1, 1, 0.5};
  static const float normals[6] = {0, 0, 1, 0, 0, 1};
  static const double view[12] = {1, 0, 0, 2, 0, 0, -1, 0.5, 0, 1, 0, 1.2};
  GUARDED(ups_meter_desc, meter);
  GUARDED(ups_camera_desc, picture);
  GUARDED(ups_observer_desc, eye);
  ups_meter_desc_init(&meter.v, sizeof meter.v);
  meter.v.count = 2;
  meter.v.positions_m = positions;
  meter.v.normals = normals;
  CHECK(ups_scene_add_meters(scene, &meter.v, meters));
  ups_camera_desc_init(&picture.v, sizeof picture.v);
  picture.v.width = picture.v.height = 4;
  memcpy(picture.v.to_world, view, sizeof view);
  CHECK(ups_scene_add_camera(scene, &picture.v, camera));
  ups_observer_desc_init(&eye.v, sizeof eye.v);
  memcpy(eye.v.to_world, view, sizeof view);
  CHECK(ups_scene_add_observer(scene, &eye.v, observer));
  EXPECT(is_untouched(meter.end) && is_untouched(picture.end) && is_untouched(eye.end));
  return 0;
}

static int render(const ups_scene *scene, ups_result **result) {
  GUARDED(ups_render_desc, desc);
  GUARDED(ups_progress, progress);
  ups_job *job;
  ups_render_desc_init(&desc.v, sizeof desc.v);
  desc.v.iteration_count = 32;
  CHECK(ups_job_start(scene, &desc.v, &job));
  CHECK(ups_job_wait(job, 60000));
  progress.v.struct_size = sizeof progress.v;
  CHECK(ups_job_poll(job, &progress.v));
  EXPECT(progress.v.state == UPS_JOB_FINISHED && progress.v.struct_size == sizeof progress.v);
  CHECK(ups_job_result(job, result));
  ups_job_destroy(job);
  EXPECT(is_untouched(desc.end) && is_untouched(progress.end));
  return 0;
}

static int read_result(const ups_result *result, ups_sensor_id meters, ups_sensor_id camera, ups_sensor_id observer) {
  GUARDED(ups_result_info, info);
  GUARDED(ups_observer_reading, rating);
  GUARDED(ups_meter_statistics, statistics);
  struct {
    ups_meter_reading v[2];
    unsigned char end[256];
  } readings;
  float pixels[4 * 4 * 3];
  memset(&readings, 0xA5, sizeof readings);
  info.v.struct_size = sizeof info.v;
  CHECK(ups_result_get_info(result, &info.v));
  CHECK(ups_result_read_meters(result, meters, readings.v, 2));
  statistics.v.struct_size = sizeof statistics.v;
  CHECK(ups_result_get_meter_statistics(result, meters, &statistics.v));
  rating.v.struct_size = sizeof rating.v;
  CHECK(ups_result_get_observer(result, observer, &rating.v));
  CHECK(ups_result_read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB, pixels, 0, sizeof pixels));
  EXPECT(is_untouched(info.end) && is_untouched(readings.end));
  EXPECT(is_untouched(statistics.end) && is_untouched(rating.end));
  EXPECT(readings.v[0].direct_lx > readings.v[1].direct_lx && readings.v[1].indirect_lx > 0 && pixels[0] > 0);
  printf("%.2f lx direct\n", readings.v[0].direct_lx);
  return 0;
}

int main(void) {
  ups_context *context;
  ups_scene *scene;
  ups_result *result = NULL;
  ups_sensor_id meters, camera, observer;
  CHECK(ups_context_create(NULL, &context));
  CHECK(ups_scene_create(context, &scene));
  if (add_room(scene) || add_luminaire(context, scene) || add_sensors(scene, &meters, &camera, &observer)) return 1;
  CHECK(ups_scene_commit(scene));
  if (render(scene, &result) || read_result(result, meters, camera, observer)) return 1;
  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
