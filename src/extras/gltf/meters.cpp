// `extras.ups.meters` of a node: a grid or free points of illuminance meters.
#include <cmath>
#include <limits>

#include "gltf/import.h"

namespace ups::gltf {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr int64_t max_meters = 16777216;  // ups_meter_desc

ups_meter_kind kind_of(const JsonReader& meters) {
  const std::string kind = meters.text("kind", "planar");
  if (kind == "planar") return UPS_METER_PLANAR;
  if (kind == "cylindrical") return UPS_METER_CYLINDRICAL;
  if (kind == "semicylindrical") return UPS_METER_SEMICYLINDRICAL;
  if (kind == "hemispherical") return UPS_METER_HEMISPHERICAL;
  if (kind == "spherical") return UPS_METER_SPHERICAL;
  if (kind == "vector") return UPS_METER_VECTOR;
  meters.fail("kind", "must be planar, cylindrical, semicylindrical, hemispherical, spherical or vector");
}

struct MeterData {
  std::vector<double> positions;
  std::vector<float> normals, tangents;  // tangents: cells only
  double cell_width = 0, cell_height = 0;
  uint32_t columns = 0, rows = 0;  // 0: points

  void add(const Vector& position, const Vector& normal) {
    const double size = length(normal);
    positions.insert(positions.end(), position.begin(), position.end());
    for (double n : normal) normals.push_back(float(n / size));
  }
};

// Cell centres of the rectangle in the local XY plane, facing local +Z: column 0 at -X, row 0 at -Y, columns fastest.
MeterData read_grid(const JsonReader& meters, const Affine& frame) {
  meters.allow_only({"width_m", "height_m", "columns", "rows", "kind", "area", "name"});
  for (const char* key : {"width_m", "height_m", "columns", "rows"}) {
    if (!meters.has(key)) meters.fail(key, "is missing: a grid needs width_m, height_m, columns and rows");
  }
  const double width = meters.number("width_m", 0, 0, unlimited), height = meters.number("height_m", 0, 0, unlimited);
  if (!(width > 0)) meters.fail("width_m", "must be greater than 0");
  if (!(height > 0)) meters.fail("height_m", "must be greater than 0");
  MeterData data;
  data.columns = uint32_t(meters.integer("columns", 0, 1, max_meters));
  data.rows = uint32_t(meters.integer("rows", 0, 1, max_meters));
  const uint64_t count = uint64_t(data.columns) * data.rows;
  if (count > uint64_t(max_meters)) meters.fail("columns", "times \"rows\" must not exceed 16777216");
  data.cell_width = width / data.columns;
  data.cell_height = height / data.rows;
  const Vector normal = frame.column(2), tangent = frame.column(0);
  for (uint32_t row = 0; row < data.rows; ++row) {
    for (uint32_t column = 0; column < data.columns; ++column) {
      data.add(frame.point(
                   {(column + 0.5) * data.cell_width - 0.5 * width, (row + 0.5) * data.cell_height - 0.5 * height, 0}),
               normal);
    }
  }
  if (meters.boolean("area", false)) {
    for (uint64_t i = 0; i < count; ++i) {
      for (double t : tangent) data.tangents.push_back(float(t));
    }
  }
  return data;
}

MeterData read_points(const JsonReader& meters, const Affine& frame) {
  meters.allow_only({"points_m", "normals", "kind", "name"});
  const std::vector<Rgb> points = meters.triples("points_m");
  const std::vector<Rgb> normals = meters.triples("normals");
  if (points.empty() || points.size() > size_t(max_meters)) {
    meters.fail("points_m", "must hold from 1 to 16777216 points");
  }
  if (meters.has("normals") && normals.size() != points.size()) {
    meters.fail("normals", "has " + std::to_string(normals.size()) + " elements, \"points_m\" has " +
                               std::to_string(points.size()));
  }
  MeterData data;
  for (size_t i = 0; i < points.size(); ++i) {
    const Vector normal = normals.empty() ? Vector{0, 0, 1} : normals[i];
    if (!(length(normal) > 0)) meters.fail("normals", "element " + std::to_string(i) + " has length 0");
    data.add(frame.point(points[i]), frame.direction(normal));
  }
  return data;
}

}  // namespace

void Importer::add_meters(const JsonReader& meters, const std::string& node_name, const Affine& frame) {
  const bool is_points = meters.has("points_m");
  MeterData data = is_points ? read_points(meters, frame) : read_grid(meters, frame);
  ups_meter_desc desc;
  ups_meter_desc_init(&desc, sizeof desc);
  desc.kind = kind_of(meters);
  desc.positions_m = data.positions.data();
  desc.normals = data.normals.data();
  desc.count = uint32_t(data.positions.size() / 3);
  if (!data.tangents.empty()) {
    desc.tangents = data.tangents.data();
    desc.cell_size_m[0] = float(data.cell_width);
    desc.cell_size_m[1] = float(data.cell_height);
  }
  Sensor sensor{};
  check(ups_scene_add_meters(scene_, &desc, &sensor.info.sensor), meters.where());
  sensor.info.struct_size = sizeof sensor.info;
  sensor.info.kind = UPS_GLTF_METERS;
  sensor.info.meter_count = desc.count;
  sensor.info.meter_kind = desc.kind;
  sensor.info.columns = data.columns;
  sensor.info.rows = data.rows;
  sensor.positions_m = std::move(data.positions);
  sensor.normals = std::move(data.normals);
  std::string name = meters.text("name", "");
  if (name.empty()) name = node_name;
  sensor.name = unique_name(name.empty() ? "meters" : name, false, meters.where());
  sensors.push_back(std::move(sensor));
}

}  // namespace ups::gltf
