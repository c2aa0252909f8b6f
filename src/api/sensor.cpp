// ups_sensor.h: cameras, meters and goniometers.
#include "api/desc.h"
#include "api/handles.h"

using namespace ups;
using namespace ups::api;

void ups_camera_desc_init(ups_camera_desc* desc, uint32_t struct_size) {
  ups_camera_desc d{};
  d.projection = UPS_PERSPECTIVE;
  d.width = d.height = 512;
  d.to_world[0] = d.to_world[5] = d.to_world[10] = 1;
  d.vertical_fov_rad = pi / 3;
  write_defaults(desc, struct_size, d);
}

void ups_meter_desc_init(ups_meter_desc* desc, uint32_t struct_size) {
  write_defaults(desc, struct_size, ups_meter_desc{});
}

void ups_goniometer_desc_init(ups_goniometer_desc* desc, uint32_t struct_size) {
  ups_goniometer_desc d{};
  d.c_count = 24;
  d.gamma_count = 73;
  d.to_world[0] = d.to_world[5] = d.to_world[10] = 1;
  write_defaults(desc, struct_size, d);
}

ups_status ups_scene_add_goniometer(ups_scene* scene, const ups_goniometer_desc* desc, ups_sensor_id* out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = scene->description.add_goniometer(read_desc(desc, &ups_goniometer_desc_init));
  });
}

ups_status ups_scene_add_camera(ups_scene* scene, const ups_camera_desc* desc, ups_sensor_id* out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = scene->description.add_camera(read_desc(desc, &ups_camera_desc_init));
  });
}

ups_status ups_scene_add_meters(ups_scene* scene, const ups_meter_desc* desc, ups_sensor_id* out) {
  return guard(__func__, [&] {
    require(scene, "scene");
    require(out, "out");
    *out = scene->description.add_meters(read_desc(desc, &ups_meter_desc_init));
  });
}
