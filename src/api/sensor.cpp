// ups_sensor.h: cameras and meters.
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
