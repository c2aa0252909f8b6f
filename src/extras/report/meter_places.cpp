// See meter_places.h.
#include "report/meter_places.h"

#include <algorithm>
#include <cmath>

namespace ups::report {
namespace {

// As they were added: the commit may have rounded them. Normals of any length became ones of length 1.
void read_points(const LitScene& scene, const SensorEntry& meters, MeterPlaces& places) {
  ups_meter_desc desc;
  ups_meter_desc_init(&desc, sizeof desc);
  check(ups_scene_get_meters(scene.scene, meters.info.sensor, &desc));
  if (desc.count != meters.info.meter_count)
    throw Failure("meters " + meters.name + ": they were changed after the scene was committed");
  places.positions.assign(desc.positions_m, desc.positions_m + 3 * size_t(desc.count));
  places.normals.assign(desc.normals, desc.normals + 3 * size_t(desc.count));
  for (size_t i = 0; i < places.normals.size(); i += 3) {
    float* n = &places.normals[i];
    const double length = std::hypot(double(n[0]), double(n[1]), double(n[2]));
    if (std::abs(length - 1) < 1e-6) continue;
    for (int k = 0; k < 3; ++k) n[k] = float(double(n[k]) / length);
  }
}

}  // namespace

MeterPlaces meter_places(const LitScene& scene, const SensorEntry& meters) {
  const SensorInfo& info = meters.info;
  const size_t count = info.meter_count;
  const bool lightmap = info.layout == MeterLayout::lightmap;
  MeterPlaces places;
  if (lightmap || info.layout == MeterLayout::surface) {
    places.positions.resize(3 * count);
    places.normals.resize(3 * count);
    places.surfaces = read_array<ups_meter_place>([&](ups_meter_place* to, size_t capacity, size_t* needed) {
      return ups_scene_read_meter_places(scene.scene, info.sensor, to, capacity, needed);
    });
    if (places.surfaces.size() != count)
      throw Failure("meters " + meters.name + ": they were changed after the scene was committed");
    for (size_t i = 0; i < count; ++i) {
      std::copy_n(places.surfaces[i].position_m, 3, &places.positions[3 * i]);
      std::copy_n(places.surfaces[i].normal, 3, &places.normals[3 * i]);
    }
  } else {
    read_points(scene, meters, places);
  }
  for (size_t i = 0; i < count; ++i)
    if (!lightmap || places.surfaces[i].valid) places.listed.push_back(i);
  return places;
}

}  // namespace ups::report
