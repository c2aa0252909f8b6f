// A scene as reports and maps see it: what the core has of it, with the names that people gave its parts. Filled by the
// program from a scene file, by the C API from what its caller says.
#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "report/handles.h"

namespace ups::report {

enum class SensorKind { camera, meters, goniometer, observer };

// How a set of meters lies, as in ups_gltf_layout. What a program lists is points, on a grid where they have columns.
enum class MeterLayout { points, grid, en12464, line, surface, lightmap };

struct SensorInfo {
  SensorKind kind = SensorKind::meters;
  ups_sensor_id sensor{};
  uint32_t width = 0, height = 0;   // camera: pixels; lightmap: texels
  bool illuminance = false;         // camera: it has UPS_CHANNEL_ILLUMINANCE
  uint32_t meter_count = 0;         // meters
  uint32_t columns = 0, rows = 0;   // meters on a grid, columns fastest; 0: free points. Goniometer: planes, angles
  MeterLayout layout = MeterLayout::points;
  ups_meter_kind meter_kind = UPS_METER_PLANAR;
  ups_projection projection = UPS_PERSPECTIVE;
  uint32_t layers = 0;              // camera: UPS_LAYER_* that it was asked for
};

struct SensorEntry {
  SensorInfo info;
  std::string name;
};

struct SourceWords {
  std::string name, file;  // file: photometric; empty: none
};

struct LitScene {
  const ups_scene* scene = nullptr;  // committed
  std::vector<SensorEntry> sensors;
  std::function<SourceWords(ups_source_kind, uint32_t id)> source_words;
  // What people call the "material 3" of a message, by noun and number; empty: as it is. May be empty itself.
  std::function<std::string(std::string_view, uint32_t)> part_words;
  std::vector<std::string> warnings;  // for people, beside those of the result, each once
};

// Where an observer's eye is, and the direction that it looks along.
struct Eye {
  double at_m[3], along[3];
};
Eye eye_of(const LitScene& scene, const SensorEntry& observer);

// What the scene tells of a sensor by itself; of a grid, whether it is one. name: of people, or empty: "meters 1".
SensorEntry sensor_entry(const ups_scene* scene, ups_sensor_id sensor, const std::string& name);

// Of what renders that tell sources apart and ratings of glare name: a source's name, or "group_3".
std::string source_name(const LitScene& scene, ups_source_kind kind, uint32_t id);

ups_scene_info info_of(const LitScene& scene);

// What the library tells, with sensors and parts of the scene by their names.
std::string for_people(const LitScene& scene, std::string line);

}  // namespace ups::report
