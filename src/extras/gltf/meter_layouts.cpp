// See meters.h: the grid of EN 12464-1 within a polygon, and points along a line.
#include <limits>

#include "gltf/meters.h"

namespace ups::gltf {

namespace {

// Corners [x, y] of an outline, appended; returns how many.
uint32_t read_outline(const JsonReader& area, const char* key, const Json& outline, std::vector<double>& corners) {
  if (!outline.is_array()) area.fail(key, "must be a list of corners [x, y]");
  for (size_t i = 0; i < outline.items.size(); ++i) {
    const Json& corner = outline.items[i];
    if (!corner.is_array() || corner.items.size() != 2 || corner.items[0].kind != Json::Kind::number ||
        corner.items[1].kind != Json::Kind::number)
      area.fail(key, "element " + std::to_string(i) + " must be a corner [x, y], two numbers");
    corners.push_back(corner.items[0].number);
    corners.push_back(corner.items[1].number);
  }
  return uint32_t(outline.items.size());
}

struct Area {
  std::vector<double> corners, hole_corners;
  std::vector<uint32_t> hole_counts;
};

Area read_area(const JsonReader& words) {
  words.allow_only({"polygon_m", "holes_m", "border_m"});
  const Json* polygon = words.json().find("polygon_m");
  if (!polygon) words.fail("polygon_m", "is missing: the area is a polygon of corners [x, y]");
  Area area;
  read_outline(words, "polygon_m", *polygon, area.corners);
  for (const Json& hole : words.array("holes_m"))
    area.hole_counts.push_back(read_outline(words, "holes_m", hole, area.hole_corners));
  return area;
}

[[noreturn]] void fail(ups_status status, const std::string& where) {
  throw extras::Error(status, where + ": " + ups_last_error());
}

}  // namespace

MeterData read_en12464(const JsonReader& meters, const Affine& frame) {
  meters.allow_only({"en12464", "kind", "area", "footprint_m", "name"});
  const JsonReader words = *meters.object("en12464");
  const Area area = read_area(words);
  ups_en12464_desc desc;
  ups_en12464_desc_init(&desc, sizeof desc);
  desc.corners_m = area.corners.data();
  desc.corner_count = uint32_t(area.corners.size() / 2);
  desc.hole_corners_m = area.hole_corners.data();
  desc.hole_corner_counts = area.hole_counts.data();
  desc.hole_count = uint32_t(area.hole_counts.size());
  desc.border_m = words.number("border_m", desc.border_m, 0, std::numeric_limits<double>::infinity());
  size_t count = 0;
  ups_status status = ups_en12464_grid(&desc, nullptr, nullptr, 0, &count);
  if (status != UPS_OK) fail(status, words.where());
  std::vector<ups_en12464_point> points(count);
  ups_en12464_info info{};
  info.struct_size = sizeof info;
  status = ups_en12464_grid(&desc, &info, points.data(), count, nullptr);
  if (status != UPS_OK) fail(status, words.where());
  MeterData data;
  data.layout = UPS_GLTF_LAYOUT_EN12464;
  data.area = meters.boolean("area", false);
  data.cell_width = info.cell_m[0], data.cell_height = info.cell_m[1];
  data.cell_side = frame.column(0);
  if (count == size_t(info.columns) * info.rows) data.columns = info.columns, data.rows = info.rows;
  for (const ups_en12464_point& p : points) data.add(frame.point({p.x_m, p.y_m, 0}), frame.column(2));
  return data;
}

// Both ends are points; facing local +Z unless the line has a normal.
MeterData read_line(const JsonReader& meters, const Affine& frame) {
  meters.allow_only({"line", "kind", "footprint_m", "name"});
  const JsonReader line = *meters.object("line");
  line.allow_only({"from_m", "to_m", "count", "normal"});
  constexpr double unlimited = std::numeric_limits<double>::infinity();
  const auto ends = {"from_m", "to_m"};
  std::vector<std::vector<double>> at;
  for (const char* key : ends) {
    const auto point = line.numbers(key, 3, -unlimited, unlimited);
    if (!point) line.fail(key, "is missing: a line goes from \"from_m\" to \"to_m\" in \"count\" points");
    at.push_back(*point);
  }
  if (!line.has("count")) line.fail("count", "is missing: it says how many points the line has");
  const int64_t count = line.integer("count", 0, 2, max_meters);
  const auto up = line.numbers("normal", 3, -unlimited, unlimited);
  const Vector normal = up ? Vector{(*up)[0], (*up)[1], (*up)[2]} : Vector{0, 0, 1};
  if (!(length(normal) > 0)) line.fail("normal", "has length 0; it must point somewhere");
  if (at[0] == at[1]) line.fail("to_m", "is the same as \"from_m\"; a line has two ends");
  MeterData data;
  data.layout = UPS_GLTF_LAYOUT_LINE;
  for (int64_t i = 0; i < count; ++i) {
    const double t = double(i) / double(count - 1);
    Vector p;
    for (size_t k = 0; k < 3; ++k) p[k] = at[0][k] * (1 - t) + at[1][k] * t;
    data.add(frame.point(p), frame.direction(normal));
  }
  return data;
}

}  // namespace ups::gltf
