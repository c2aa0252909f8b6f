// `extras.ups.meters` of a node: illuminance meters as a grid or free points, in other layouts (meter_layouts.cpp), and
// on the surfaces of the node's mesh.
#include <cmath>
#include <limits>

#include "gltf/import.h"
#include "gltf/meters.h"

namespace ups::gltf {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

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

// Cell centres of the rectangle in the local XY plane, facing local +Z: column 0 at -X, row 0 at -Y, columns fastest.
MeterData read_grid(const JsonReader& meters, const Affine& frame) {
  meters.allow_only({"width_m", "height_m", "columns", "rows", "kind", "area", "footprint_m", "name"});
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
  const Vector normal = frame.column(2);
  for (uint32_t row = 0; row < data.rows; ++row) {
    for (uint32_t column = 0; column < data.columns; ++column) {
      data.add(frame.point(
                   {(column + 0.5) * data.cell_width - 0.5 * width, (row + 0.5) * data.cell_height - 0.5 * height, 0}),
               normal);
    }
  }
  data.layout = UPS_GLTF_LAYOUT_GRID;
  data.cell_side = frame.column(0);
  data.area = meters.boolean("area", false);
  return data;
}

MeterData read_points(const JsonReader& meters, const Affine& frame) {
  meters.allow_only({"points_m", "normals", "kind", "footprint_m", "name"});
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

MeterData read_meters(const JsonReader& meters, const Affine& frame) {
  if (meters.has("points_m")) return read_points(meters, frame);
  if (meters.has("en12464")) return read_en12464(meters, frame);
  if (meters.has("line")) return read_line(meters, frame);
  return read_grid(meters, frame);
}

}  // namespace

void Importer::add_meters(const JsonReader& meters, const std::string& node_name, const Affine& frame) {
  MeterData data = read_meters(meters, frame);
  ups_meter_desc desc;
  ups_meter_desc_init(&desc, sizeof desc);
  desc.kind = kind_of(meters);
  desc.positions_m = data.positions.data();
  desc.normals = data.normals.data();
  desc.count = uint32_t(data.positions.size() / 3);
  desc.footprint_m = float(meters.number("footprint_m", 0, 0, unlimited));
  std::vector<float> tangents;
  if (data.area) {
    if (meters.has("footprint_m")) meters.fail("footprint_m", "does not go with \"area\": a mean is over one of them");
    const Vector& side = data.cell_side;
    for (uint32_t i = 0; i < desc.count; ++i) tangents.insert(tangents.end(), side.begin(), side.end());
    desc.tangents = tangents.data();
    desc.cell_size_m[0] = float(data.cell_width);
    desc.cell_size_m[1] = float(data.cell_height);
  }
  Sensor sensor{};
  check(ups_scene_add_meters(scene_, &desc, &sensor.info.sensor), meters.where());
  sensor.info.meter_count = desc.count;
  sensor.info.meter_kind = desc.kind;
  sensor.info.columns = data.columns;
  sensor.info.rows = data.rows;
  sensor.info.layout = data.layout;
  sensor.info.cell_size_m[0] = float(data.cell_width);
  sensor.info.cell_size_m[1] = float(data.cell_height);
  for (size_t k = 0; k < 3; ++k) sensor.info.cell_side[k] = float(data.cell_side[k]);
  sensor.positions_m = std::move(data.positions);
  sensor.normals = std::move(data.normals);
  keep_meters(std::move(sensor), meters, node_name);
}

void Importer::keep_meters(Sensor&& sensor, const JsonReader& meters, const std::string& node_name) {
  sensor.info.struct_size = sizeof sensor.info;
  sensor.info.kind = UPS_GLTF_METERS;
  std::string name = meters.text("name", "");
  if (name.empty()) name = node_name;
  sensor.name = unique_name(name.empty() ? "meters" : name, false, meters.where());
  sensors.push_back(std::move(sensor));
}

void Importer::add_surface_meters(const JsonReader& meters, const std::string& node_name) {
  const bool is_map = meters.has("lightmap");
  meters.allow_only({is_map ? "lightmap" : "surface", "back", "kind", "name"});
  const char* word = is_map ? "lightmap" : "surface";
  if (!is_map && !meters.boolean("surface", true)) meters.fail("surface", "must be true, or left out");
  if (kind_of(meters) != UPS_METER_PLANAR) meters.fail("kind", "must be planar: meters on a surface face away from it");
  if (node_instances_.empty()) meters.fail(word, "needs a mesh with triangles on the same node");
  Sensor sensor{};
  if (is_map) {
    for (const PlacedMesh& m : node_meshes_)
      if (!m.has_uvs) meters.fail(word, "needs texture coordinates (TEXCOORD) in every primitive of the node's mesh");
    const JsonReader size = *meters.object("lightmap");
    size.allow_only({"width", "height"});
    ups_lightmap_desc desc;
    ups_lightmap_desc_init(&desc, sizeof desc);
    desc.instances = node_instances_.data();
    desc.instance_count = uint32_t(node_instances_.size());
    desc.width = uint32_t(size.integer("width", desc.width, 1, 16384));
    desc.height = uint32_t(size.integer("height", desc.height, 1, 16384));
    desc.back = meters.boolean("back", false);
    check(ups_scene_add_lightmap(scene_, &desc, &sensor.info.sensor), size.where());
    sensor.info.layout = UPS_GLTF_LAYOUT_LIGHTMAP;
    sensor.info.width = desc.width;
    sensor.info.height = desc.height;
    sensor.info.meter_count = desc.width * desc.height;
  } else {
    ups_surface_meters_desc desc;
    ups_surface_meters_desc_init(&desc, sizeof desc);
    desc.instances = node_instances_.data();
    desc.instance_count = uint32_t(node_instances_.size());
    desc.back = meters.boolean("back", false);
    check(ups_scene_add_surface_meters(scene_, &desc, &sensor.info.sensor), meters.where());
    sensor.info.layout = UPS_GLTF_LAYOUT_SURFACE;
    for (const PlacedMesh& m : node_meshes_) sensor.info.meter_count += m.triangles;
  }
  keep_meters(std::move(sensor), meters, node_name);
}

}  // namespace ups::gltf
