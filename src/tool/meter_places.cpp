// See meter_places.h.
#include "tool/meter_places.h"

#include <algorithm>

namespace ups::tool {

MeterPlaces meter_places(const LoadedScene& scene, uint32_t index) {
  const ups_gltf_sensor_info& info = scene.sensors[index].info;
  const size_t count = info.meter_count;
  const bool lightmap = info.layout == UPS_GLTF_LAYOUT_LIGHTMAP;
  MeterPlaces places;
  places.positions.resize(3 * count);
  places.normals.resize(3 * count);
  if (lightmap || info.layout == UPS_GLTF_LAYOUT_SURFACE) {
    places.surfaces = read_array<ups_meter_place>([&](ups_meter_place* to, size_t capacity, size_t* needed) {
      return ups_scene_read_meter_places(scene.scene.get(), info.sensor, to, capacity, needed);
    });
    for (size_t i = 0; i < count; ++i) {
      std::copy_n(places.surfaces[i].position_m, 3, &places.positions[3 * i]);
      std::copy_n(places.surfaces[i].normal, 3, &places.normals[3 * i]);
    }
  } else {
    check(ups_gltf_read_meters(scene.import_result.get(), index, places.positions.data(), places.normals.data(), count),
          ups_gltf_last_error);
  }
  for (size_t i = 0; i < count; ++i)
    if (!lightmap || places.surfaces[i].valid) places.listed.push_back(i);
  return places;
}

}  // namespace ups::tool
