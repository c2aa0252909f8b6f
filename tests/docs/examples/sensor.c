/* Meters, cameras, goniometers, and edits of them. */
#include "example.h"

static ups_sensor_id meters(ups_scene *scene) {
  /* [ups_meter_desc_init ups_scene_add_meters] */
  const double at[6] = {1, 1, 0.75, 3, 1, 0.75}; /* m: two points at the height of a desk */
  const float up[6] = {0, 0, 1, 0, 0, 1};
  ups_meter_desc desc;
  ups_sensor_id meters;
  ups_meter_desc_init(&desc, sizeof desc); /* planar, points */
  desc.count = 2;
  desc.positions_m = at;
  desc.normals = up;
  check(ups_scene_add_meters(scene, &desc, &meters));
  /* [end] */

  /* [ups_scene_get_meters ups_scene_set_meters] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_meters(scene, meters, &desc)); /* its arrays are the scene's own */
  desc.kind = UPS_METER_CYLINDRICAL;
  desc.footprint_m = 0.1f; /* means over discs */
  check(ups_scene_set_meters(scene, meters, &desc));
  /* [end] */
  check(ups_scene_get_meters(scene, meters, &desc));
  expect(desc.kind == UPS_METER_CYLINDRICAL && desc.positions_m[3] == 3);
  return meters;
}

static ups_sensor_id surface(ups_scene *scene, ups_instance_id room) {
  /* [ups_surface_meters_desc_init ups_scene_add_surface_meters] */
  ups_surface_meters_desc desc;
  ups_sensor_id triangles;
  ups_surface_meters_desc_init(&desc, sizeof desc); /* the fronts */
  desc.instances = &room;
  desc.instance_count = 1;
  check(ups_scene_add_surface_meters(scene, &desc, &triangles)); /* meter i is triangle i */
  /* [end] */

  /* [ups_scene_get_surface_meters ups_scene_set_surface_meters] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_surface_meters(scene, triangles, &desc));
  desc.back = 1;
  check(ups_scene_set_surface_meters(scene, triangles, &desc));
  /* [end] */
  check(ups_scene_get_surface_meters(scene, triangles, &desc));
  expect(desc.back == 1 && desc.instance_count == 1);
  return triangles;
}

static ups_instance_id add_table(ups_scene *scene) {
  static const float corners[12] = {1, 1, 0.7f, 2, 1, 0.7f, 2, 2, 0.7f, 1, 2, 0.7f}, uvs[8] = {0, 0, 1, 0, 1, 1, 0, 1};
  static const uint32_t triangles[6] = {0, 1, 2, 0, 2, 3};
  ups_material_desc matte;
  ups_mesh_desc mesh;
  ups_instance_desc instance;
  ups_instance_id id;
  ups_material_desc_init(&matte, sizeof matte);
  ups_mesh_desc_init(&mesh, sizeof mesh);
  check(ups_scene_add_material(scene, &matte, &mesh.material));
  mesh.vertex_count = 4, mesh.triangle_count = 2;
  mesh.positions_m = corners, mesh.uvs = uvs, mesh.indices = triangles;
  ups_instance_desc_init(&instance, sizeof instance);
  check(ups_scene_add_mesh(scene, &mesh, &instance.mesh));
  check(ups_scene_add_instance(scene, &instance, &id));
  return id;
}

static void lightmap(ups_scene *scene) {
  const ups_instance_id table = add_table(scene);
  /* [ups_lightmap_desc_init ups_scene_add_lightmap] */
  ups_lightmap_desc desc;
  ups_sensor_id map;
  ups_lightmap_desc_init(&desc, sizeof desc);
  desc.instances = &table; /* its mesh has UVs */
  desc.instance_count = 1;
  desc.width = desc.height = 8; /* texels */
  check(ups_scene_add_lightmap(scene, &desc, &map));
  /* [end] */

  /* [ups_scene_get_lightmap ups_scene_set_lightmap] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_lightmap(scene, map, &desc));
  desc.width = desc.height = 4;
  check(ups_scene_set_lightmap(scene, map, &desc));
  /* [end] */
  check(ups_scene_commit(scene));

  /* [ups_scene_read_meter_places] */
  size_t count;
  check(ups_scene_read_meter_places(scene, map, NULL, 0, &count)); /* how many: its texels */
  ups_meter_place *places = malloc(count * sizeof *places);
  check(ups_scene_read_meter_places(scene, map, places, count, &count));
  double area_m2 = 0;
  for (size_t i = 0; i < count; ++i) area_m2 += places[i].area_m2; /* 0 where nothing lies in a texel */
  /* [end] */
  expect(count == 16 && near(area_m2, 1, 1e-5));
  free(places);
}

static void camera(ups_scene *scene) {
  /* [ups_camera_desc_init ups_scene_add_camera] */
  ups_camera_desc desc;
  ups_sensor_id camera;
  ups_camera_desc_init(&desc, sizeof desc); /* perspective, looking along local -Z */
  desc.width = 320;
  desc.height = 240;
  desc.vertical_fov_rad = 1;
  desc.to_world[11] = 2; /* from 2 m up straight down */
  check(ups_scene_add_camera(scene, &desc, &camera));
  /* [end] */

  /* [ups_scene_get_camera ups_scene_set_camera] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_camera(scene, camera, &desc));
  desc.projection = UPS_EQUIDISTANT;
  desc.layers = UPS_LAYER_DEPTH | UPS_LAYER_ID;
  check(ups_scene_set_camera(scene, camera, &desc));
  /* [end] */
  check(ups_scene_get_camera(scene, camera, &desc));
  expect(desc.projection == UPS_EQUIDISTANT && desc.width == 320);
}

static void goniometer(ups_scene *scene) {
  /* [ups_goniometer_desc_init ups_scene_add_goniometer] */
  ups_goniometer_desc desc;
  ups_sensor_id goniometer;
  ups_goniometer_desc_init(&desc, sizeof desc); /* planes every 15 degrees, gamma every 2.5 */
  desc.symmetry = UPS_SYMMETRY_AXIAL;
  desc.c_count = 1;
  check(ups_scene_add_goniometer(scene, &desc, &goniometer));
  /* [end] */

  /* [ups_scene_get_goniometer ups_scene_set_goniometer] */
  desc.struct_size = sizeof desc;
  check(ups_scene_get_goniometer(scene, goniometer, &desc));
  desc.gamma_count = 37; /* every 5 degrees */
  check(ups_scene_set_goniometer(scene, goniometer, &desc));
  /* [end] */
  check(ups_scene_get_goniometer(scene, goniometer, &desc));
  expect(desc.gamma_count == 37);
}

static void grid(void) {
  /* [ups_en12464_desc_init ups_en12464_grid] */
  const double corners_m[8] = {0, 0, 6, 0, 6, 4, 0, 4};
  ups_en12464_desc room;
  ups_en12464_info info;
  ups_en12464_point points[64];
  size_t count;
  ups_en12464_desc_init(&room, sizeof room); /* a border of 0.5 m */
  room.corners_m = corners_m;
  room.corner_count = 4;
  info.struct_size = sizeof info;
  check(ups_en12464_grid(&room, &info, points, 64, &count)); /* x and y of each; a task's height is the program's */
  /* [end] */
  expect(count == info.point_count && info.columns * info.rows == count);
  expect(points[0].x_m > 0.5 && info.cell_m[0] <= info.largest_spacing_m);
}

int main(void) {
  ups_context *context;
  ups_scene *scene;
  check(ups_context_create(NULL, &context));
  check(ups_scene_create(context, &scene));
  const ups_instance_id room = add_room(scene);
  add_downlight(context, scene, 2, 1.5);
  const ups_sensor_id set = meters(scene);
  const ups_sensor_id triangles = surface(scene, room);
  lightmap(scene);
  camera(scene);
  goniometer(scene);
  grid();
  /* [ups_scene_remove_sensor] */
  check(ups_scene_remove_sensor(scene, set)); /* any kind */
  /* [end] */
  expect(ups_scene_remove_sensor(scene, set) == UPS_ERROR_INVALID_ARGUMENT && triangles.v != 0);
  ups_scene_destroy(scene);
  ups_context_destroy(context);
  return 0;
}
