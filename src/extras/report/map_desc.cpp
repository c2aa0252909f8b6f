// See descs.h: the map of a sensor or of plain numbers.
#include <algorithm>
#include <cmath>

#include "report/descs.h"
#include "report/findings.h"
#include "report/map_data.h"

namespace ups::report {
namespace {

using extras::require;

constexpr uint32_t most_meters = 4000000;
constexpr const char* luminance_unit = "cd/m\u00b2";

[[noreturn]] void fail_flat(const std::string& what) {
  throw Failure(what + " lie on one line or in no plane, or are too many on no lattice: there is no map of them",
                UPS_ERROR_UNSUPPORTED);
}

bool wants_illuminance(const ups_report_map_desc& d) { return d.quantity == UPS_REPORT_QUANTITY_ILLUMINANCE; }

MapData camera_map(const ups_report_map_desc& d, const SensorEntry& camera) {
  const uint32_t width = camera.info.width, height = camera.info.height;
  const auto read = [&](ups_channel channel) { return read_image(d.result, camera, channel); };
  if (!wants_illuminance(d))
    return image_map(camera.name, "Luminance", luminance_unit,
                     within_image(camera.info, luminance_of(read(UPS_CHANNEL_LUMINANCE_RGB))),
                     read(UPS_CHANNEL_ERROR_BOUND), width, height);
  if (!camera.info.illuminance)
    throw Failure(camera.name + " has no illuminance: set ups_camera_desc.illuminance to 1, or take its luminance");
  return image_map(camera.name, "Illuminance", "lx", within_image(camera.info, read(UPS_CHANNEL_ILLUMINANCE)),
                   read(UPS_CHANNEL_ILLUMINANCE_ERROR_BOUND), width, height);
}

MapData meters_map(const ups_report_map_desc& d, const SensorEntry& meters, const LitScene& scene) {
  if (d.quantity == UPS_REPORT_QUANTITY_LUMINANCE)
    throw Failure("quantity is luminance, but " + meters.name + " are meters, of illuminance");
  if (meters.info.layout == MeterLayout::surface || meters.info.layout == MeterLayout::lightmap)
    throw Failure(meters.name + " lie on surfaces of instances: there is no map of them", UPS_ERROR_UNSUPPORTED);
  if (meters.info.meter_count > most_meters)
    throw Failure(meters.name + ": " + std::to_string(meters.info.meter_count) + " meters are more than the " +
                      std::to_string(most_meters) + " that a map is drawn of",
                  UPS_ERROR_UNSUPPORTED);
  std::optional<MapData> data = meter_map(meters, scene, d.result);
  if (!data) fail_flat(meters.name);
  return std::move(*data);
}

MapData sensor_map(const ups_report_map_desc& d) {
  require(d.scene != nullptr, "scene is NULL: a map of a sensor needs it");
  require(!d.positions_m && !d.normals && !d.values && !d.error_bounds && d.count == 0 && d.columns == 0,
          "result and numbers are given both: a map is of a sensor in a result, or of numbers without one");
  LitScene scene = lit_scene_of(d.scene, d.result, d.sensors, d.sensor_count);
  const auto named = std::find_if(scene.sensors.begin(), scene.sensors.end(),
                                  [&](const SensorEntry& s) { return s.info.sensor.v == d.sensor.v; });
  const SensorEntry entry = named != scene.sensors.end() ? *named : sensor_entry(d.scene, d.sensor, "");
  if (entry.info.kind == SensorKind::camera) return camera_map(d, entry);
  if (entry.info.kind == SensorKind::meters) return meters_map(d, entry, scene);
  throw Failure(entry.name + " is neither meters nor a camera: there is no map of it");
}

std::vector<MeterPoint> points_of(const ups_report_map_desc& d) {
  std::vector<MeterPoint> points(d.count);
  for (size_t i = 0; i < points.size(); ++i) {
    MeterPoint& p = points[i];
    for (size_t k = 0; k < 3; ++k) {
      p.position_m[k] = d.positions_m[3 * i + k];
      p.normal[k] = d.normals ? double(d.normals[3 * i + k]) : k == 2 ? 1 : 0;
      if (!std::isfinite(p.position_m[k]))
        throw Failure("positions_m: element " + std::to_string(3 * i + k) + " must be finite");
      if (!std::isfinite(p.normal[k]))
        throw Failure("normals: element " + std::to_string(3 * i + k) + " must be finite");
    }
    const double length = std::hypot(p.normal[0], p.normal[1], p.normal[2]);
    if (!(length > 0)) throw Failure("normals: that of point " + std::to_string(i) + " has no length");
    for (double& c : p.normal) c /= length;
    p.illuminance_lx = double(d.values[i]);
    p.error_bound_lx = d.error_bounds && std::isfinite(d.error_bounds[i]) ? double(d.error_bounds[i]) : -1;
  }
  return points;
}

// Each point must be nearer to its own place in the grid from the first to the last than to any other.
void check_grid(const MapData& data) {
  const Place first = data.values.front().at, last = data.values.back().at;
  const double x = data.columns > 1 ? (last.x - first.x) / (data.columns - 1) : 0,
               y = data.rows > 1 ? (last.y - first.y) / (data.rows - 1) : 0,
               near_x = 0.5 * std::abs(x != 0 ? x : y), near_y = 0.5 * std::abs(y != 0 ? y : x);
  for (size_t i = 0; i < data.values.size(); ++i) {
    const Place& at = data.values[i].at;
    const double column = double(i % data.columns), row = double(i / data.columns);
    if (std::abs(at.x - first.x - column * x) > near_x || std::abs(at.y - first.y - row * y) > near_y)
      throw Failure("columns is " + std::to_string(data.columns) +
                    ", but the points are no such grid row by row; 0: it is found out");
  }
}

MapData points_map(const ups_report_map_desc& d) {
  require(d.quantity != UPS_REPORT_QUANTITY_LUMINANCE, "quantity is luminance, but points have illuminance");
  require(d.count <= most_meters, "count must be at most 4,000,000");
  require(d.columns == 0 || d.count % d.columns == 0, "count is no multiple of columns");
  const std::vector<MeterPoint> points = points_of(d);
  LitScene scene;
  if (d.scene) scene = lit_scene_of(d.scene, nullptr, d.sensors, d.sensor_count);
  const uint32_t columns = d.columns > 0 ? d.columns : columns_of(d.positions_m, d.count);
  std::optional<MapData> data = meter_map("", points, columns, d.scene ? &scene : nullptr);
  if (!data) fail_flat("the points");
  if (d.columns > 0) check_grid(*data);
  data->summary = summary_of(points);
  return std::move(*data);
}

MapData numbers_map(const ups_report_map_desc& d) {
  require(d.sensor.v == 0, "sensor is set, but result is NULL");
  require_array(d.sensors, d.sensor_count, "sensors");
  require(d.values != nullptr, "values is NULL: a map is of a sensor in a result, or of numbers");
  require(d.count > 0, "count must be at least 1");
  if (d.positions_m) return points_map(d);
  require(!d.normals, "normals are given, but positions_m is NULL");
  require(!d.scene, "scene is given, but an image has no plan beneath it");
  require(d.columns > 0 && d.count % d.columns == 0, "count must be a multiple of columns, the width of an image");
  const std::vector<float> values(d.values, d.values + d.count);
  std::vector<float> bounds;
  if (d.error_bounds) bounds.assign(d.error_bounds, d.error_bounds + d.count);
  const bool lux = wants_illuminance(d);
  return image_map("", lux ? "Illuminance" : "Luminance", lux ? "lx" : luminance_unit, values, bounds, d.columns,
                   d.count / d.columns, {});
}

}  // namespace

ups_report_map_desc map_defaults() {
  ups_report_map_desc desc{};
  desc.struct_size = sizeof desc;
  return desc;
}

Map map_of(const ups_report_map_desc& d) {
  require(d.quantity >= UPS_REPORT_QUANTITY_AUTO && d.quantity <= UPS_REPORT_QUANTITY_LUMINANCE,
          "quantity must be one of UPS_REPORT_QUANTITY_*");
  Map map{{}, style_of(d.style)};
  map.data = d.result ? sensor_map(d) : numbers_map(d);
  if (d.title) map.data.title = d.title;
  if (map.data.unit != "lx") map.style.map = of_luminance(map.style.map);
  return map;
}

}  // namespace ups::report
