/* The least that uses every part of the installed library: a lamp above a floor, one meter; prints version and lux. */
#include <stdio.h>
#include <ups/ups.h>

#define CHECK(call)                                                                       \
  do {                                                                                    \
    if ((call) != UPS_OK) {                                                               \
      fprintf(stderr, "%s:%d: %s: %s\n", __FILE__, __LINE__, #call, ups_last_error());     \
      return 1;                                                                           \
    }                                                                                     \
  } while (0)

int main(void) {
  static const float positions[12] = {-5, -5, 0, 5, -5, 0, 5, 5, 0, -5, 5, 0};
  static const uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  static const double meter_position[3] = {0, 0, 0.5};
  static const float up[3] = {0, 0, 1};
  ups_context *context;
  ups_scene *scene;
  ups_result *result;
  ups_material_desc material;
  ups_mesh_desc mesh;
  ups_instance_desc instance;
  ups_light_desc light;
  ups_meter_desc meter;
  ups_render_desc render;
  ups_meter_reading reading;
  ups_instance_id instance_id;
  ups_luminaire_id light_id;
  ups_sensor_id sensor;
  const uint32_t version = ups_version();

  CHECK(ups_context_create(NULL, &context));
  CHECK(ups_scene_create(context, &scene));
  ups_material_desc_init(&material, sizeof material);
  ups_mesh_desc_init(&mesh, sizeof mesh);
  CHECK(ups_scene_add_material(scene, &material, &mesh.material));
  mesh.vertex_count = 4;
  mesh.triangle_count = 2;
  mesh.positions_m = positions;
  mesh.indices = indices;
  ups_instance_desc_init(&instance, sizeof instance);
  CHECK(ups_scene_add_mesh(scene, &mesh, &instance.mesh));
  CHECK(ups_scene_add_instance(scene, &instance, &instance_id));
  ups_light_desc_init(&light, sizeof light);
  light.kind = UPS_LIGHT_POINT;
  light.intensity_rgb[0] = light.intensity_rgb[1] = light.intensity_rgb[2] = 400;
  light.to_world[11] = 2.5; /* 2 m above the meter: 400 cd / (2 m)^2 = 100 lx, as the floor below reflects away */
  CHECK(ups_scene_add_light(scene, &light, &light_id));
  ups_meter_desc_init(&meter, sizeof meter);
  meter.count = 1;
  meter.positions_m = meter_position;
  meter.normals = up;
  CHECK(ups_scene_add_meters(scene, &meter, &sensor));
  CHECK(ups_scene_commit(scene));
  ups_render_desc_init(&render, sizeof render);
  render.iteration_count = 16;
  CHECK(ups_render(scene, &render, &result));
  CHECK(ups_result_read_meters(result, sensor, &reading, 1));
  printf("UPS %u.%u.%u: %.3f lx\n", (unsigned)(version / 10000), (unsigned)(version / 100 % 100),
         (unsigned)(version % 100), reading.illuminance_lx);
  ups_result_destroy(result);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  /* The lamp is a point: what it sends straight to the meter is exact up to float rounding. */
  if (!(reading.illuminance_lx > 99.9f && reading.illuminance_lx < 100.1f)) {
    fprintf(stderr, "expected 100 lx\n");
    return 1;
  }
  return 0;
}
