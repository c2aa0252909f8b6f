// See map_data.h.
#include "report/map_data.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "report/map_field.h"
#include "report/meter_places.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

using Vector = std::array<double, 3>;

double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
double length(const Vector& v) { return std::sqrt(dot(v.data(), v.data())); }
Vector cross(const double* a, const double* b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Vector between(const MeterPoint& a, const MeterPoint& b) {
  return {b.position_m[0] - a.position_m[0], b.position_m[1] - a.position_m[1], b.position_m[2] - a.position_m[2]};
}
// False where it has no length.
bool make_unit(Vector& v) {
  const double l = length(v);
  if (!(l > 0) || !std::isfinite(l)) return false;
  for (double& c : v) c /= l;
  return true;
}
void copy(const Vector& from, double* to) { std::copy(from.begin(), from.end(), to); }

// Of the farthest two points; 0 where all are one.
Vector longest_of(const std::vector<MeterPoint>& points, double& extent) {
  Vector best{};
  extent = 0;
  for (const MeterPoint& p : points) {
    const Vector v = between(points.front(), p);
    if (length(v) > extent) extent = length(v), best = v;
  }
  return best;
}

bool lies_across(const std::vector<MeterPoint>& points, const Vector& normal, double extent) {
  return std::all_of(points.begin(), points.end(), [&](const MeterPoint& p) {
    return std::abs(dot(between(points.front(), p).data(), normal.data())) <= 1e-4 * extent + 1e-9;
  });
}

// Towards who looks: the meters' own where they share it and lie across it, else up, else the points' own. A grid
// may have a single row or cell.
std::optional<Vector> normal_of(const std::vector<MeterPoint>& points, bool is_grid) {
  double extent;
  const Vector longest = longest_of(points, extent);
  constexpr double least = 1e-9;  // m, below which there is no map
  if (points.size() > 1 && extent < least) return std::nullopt;
  Vector mean{};
  for (const MeterPoint& p : points)
    for (int k = 0; k < 3; ++k) mean[size_t(k)] += p.normal[k];
  if (Vector own = mean; is_grid && make_unit(own) && lies_across(points, own, extent)) return own;
  if (!(extent > 0)) return std::nullopt;
  Vector widest{};
  for (const MeterPoint& p : points) {
    const Vector across = cross(longest.data(), between(points.front(), p).data());
    if (length(across) > length(widest)) widest = across;
  }
  if (!(length(widest) > 1e-3 * extent * extent)) return std::nullopt;  // on one line
  const Vector up{0, 0, 1};
  make_unit(widest);
  if (dot(widest.data(), up.data()) < -1e-6)
    for (double& c : widest) c = -c;
  for (Vector normal : {mean, up, widest})
    if (make_unit(normal) && lies_across(points, normal, extent)) return normal;
  return std::nullopt;
}

void set_axes(MapPlane& plane, const Vector& right) {
  copy(right, plane.right);
  copy(cross(plane.normal, plane.right), plane.up);
}

// North up, or up up.
void set_upright_axes(MapPlane& plane) {
  const bool level = std::abs(plane.normal[2]) > 0.9;
  const Vector towards = level ? Vector{0, 1, 0} : Vector{0, 0, 1};
  Vector right = cross(towards.data(), plane.normal);
  if (!make_unit(right)) right = {1, 0, 0};
  set_axes(plane, right);
}

// As the grid lies: columns to the right, rows upwards. True where its rows run the other way round and are to be turned:
// as they are read on a page, from the top. Where meters look downwards, it is the plane that is turned: a plan is seen
// from above. row_0_below: rows are not turned; the drawing is a mirror image then, of what lies beneath all the same.
bool set_grid_axes(MapPlane& plane, const std::vector<MeterPoint>& points, uint32_t columns, bool row_0_below) {
  Vector right = between(points[0], points[columns - 1]), up = between(points[0], points[points.size() - columns]);
  if (columns == 1) right = cross(up.data(), plane.normal);  // of a single cell too: no direction
  if (!make_unit(right)) {
    set_upright_axes(plane);
    return false;
  }
  set_axes(plane, right);
  if (!(dot(up.data(), plane.up) < 0)) return false;
  if (plane.normal[2] > 0.5 || (plane.normal[2] > -0.5 && up[2] < 0)) {
    if (!row_0_below) return true;
    for (double& c : plane.up) c = -c;
    return false;
  }
  for (double& c : plane.normal) c = -c;  // seen from behind
  set_axes(plane, right);
  return false;
}

std::vector<MeterPoint> with_rows_turned(const std::vector<MeterPoint>& points, uint32_t columns) {
  std::vector<MeterPoint> out;
  for (size_t end = points.size(); end > 0; end -= columns)
    out.insert(out.end(), points.begin() + ptrdiff_t(end - columns), points.begin() + ptrdiff_t(end));
  return out;
}

std::vector<MapValue> values_of(const std::vector<MeterPoint>& points, const MapPlane& plane) {
  std::vector<MapValue> values;
  for (const MeterPoint& p : points) values.push_back({plane.flat(p.position_m), p.illuminance_lx, p.error_bound_lx});
  return values;
}

// Turned so that a lattice of points lies along the axes, where there is one.
void turn_to_lattice(MapPlane& plane, MapData& data, const std::vector<MeterPoint>& points) {
  if (MapField(data).lattice() || points.size() > 20000) return;
  Place nearest{0, 0};
  for (const MapValue& v : data.values) {
    const Place d{v.at.x - data.values[0].at.x, v.at.y - data.values[0].at.y};
    const double l = std::hypot(d.x, d.y);
    if (l > 0 && (l < std::hypot(nearest.x, nearest.y) || (nearest.x == 0 && nearest.y == 0))) nearest = d;
  }
  const double quarter = std::acos(0.0), raw = std::atan2(nearest.y, nearest.x);
  const double angle = raw - quarter * std::round(raw / quarter);
  MapPlane turned = plane;
  Vector right;
  for (size_t k = 0; k < 3; ++k) right[k] = std::cos(angle) * plane.right[k] + std::sin(angle) * plane.up[k];
  set_axes(turned, right);
  MapData other = data;
  other.values = values_of(points, turned);
  if (!MapField(other).lattice()) return;
  plane = turned;
  data.values = std::move(other.values);
}

MapData map_of_image(const std::string& name, const std::string& quantity, const std::string& unit,
                     const std::vector<float>& values, const std::vector<float>& bounds, uint32_t columns,
                     uint32_t rows, const std::vector<float>& weights, bool of_camera) {
  MapData data;
  data.title = name;
  data.quantity = quantity;
  data.unit = unit;
  data.is_image = true;
  data.of_camera = of_camera;
  const auto is_good = [](float value) { return std::isfinite(value) && value >= 0; };
  double sum = 0, good = 0, least = INFINITY, most = 0;
  for (size_t i = 0; i < values.size(); ++i) {
    const float value = values[i];
    if (!is_good(value)) continue;
    const double weight = weights.empty() ? 1 : double(weights[i]);
    sum += weight * double(value), good += weight;
    least = std::min(least, double(value)), most = std::max(most, double(value));
  }
  // Of a large one blocks of pixels: more than the drawing's own could not be seen.
  constexpr uint64_t most_side = 2048;
  const uint64_t block = (std::max(columns, rows) + most_side - 1) / most_side;
  data.columns = uint32_t((columns + block - 1) / block);
  data.rows = uint32_t((rows + block - 1) / block);
  for (uint32_t row = 0; row < data.rows; ++row) {
    for (uint32_t column = 0; column < data.columns; ++column) {
      double block_sum = 0, bound_sum = 0, count = 0, bounded = 0;
      for (uint64_t y = row * block; y < std::min<uint64_t>((row + 1) * block, rows); ++y) {
        for (uint64_t x = column * block; x < std::min<uint64_t>((column + 1) * block, columns); ++x) {
          const size_t pixel = size_t(rows - 1 - y) * columns + x;
          if (!is_good(values[pixel])) continue;
          block_sum += double(values[pixel]), ++count;
          if (!bounds.empty() && is_good(bounds[pixel])) bound_sum += double(bounds[pixel]), ++bounded;
        }
      }
      data.values.push_back({{column + 0.5, row + 0.5}, count > 0 ? block_sum / count : -1,
                             count > 0 && bounded == count ? bound_sum / count : -1});  // of a mean: no larger
    }
  }
  data.summary = good > 0 ? summary_text(sum / good, -1, least, most, -1, unit, of_camera) : "no pixel is known";
  return data;
}

}  // namespace

std::optional<MapData> meter_map(const std::string& name, const std::vector<MeterPoint>& points, uint32_t columns,
                                 const LitScene* scene, bool row_0_below) {
  if (points.empty() || (columns > 0 && points.size() % columns != 0)) return std::nullopt;
  const std::optional<Vector> normal = normal_of(points, columns > 0);
  if (!normal) return std::nullopt;
  MapPlane plane{};
  std::copy(points[0].position_m, points[0].position_m + 3, plane.origin);
  copy(*normal, plane.normal);
  MapData data;
  data.title = name;
  data.quantity = "Illuminance";
  data.unit = "lx";
  if (columns > 0) {
    data.columns = columns;
    data.rows = uint32_t(points.size()) / columns;
    const bool turned = set_grid_axes(plane, points, columns, row_0_below);
    data.values = values_of(turned ? with_rows_turned(points, columns) : points, plane);
  } else {
    set_upright_axes(plane);
    data.values = values_of(points, plane);
    turn_to_lattice(plane, data, points);
  }
  if (MapField(data).box().empty()) return std::nullopt;
  const bool level = std::abs(plane.normal[2]) > 0.9;
  const double towards[3] = {0, level ? 1.0 : 0.0, level ? 0.0 : 1.0};
  const Place arrow = plane.direction(towards);
  if (level || arrow.y < 0.999 * std::hypot(arrow.x, arrow.y)) {  // an upright wall needs none
    data.north_x = arrow.x, data.north_y = arrow.y;
    data.north = level ? "N" : "up";
  }
  if (scene) add_room(data, plane, *scene);
  return data;
}

std::optional<MapData> meter_map(const SensorEntry& meters, const LitScene& scene, const ups_result* result) {
  const MeterLayout layout = meters.info.layout;
  if (layout == MeterLayout::surface || layout == MeterLayout::lightmap) return std::nullopt;
  const size_t count = meters.info.meter_count;
  const MeterPlaces places = meter_places(scene, meters);
  std::vector<ups_meter_reading> readings(count);
  check(ups_result_read_meters(result, meters.info.sensor, readings.data(), count));
  std::vector<MeterPoint> points(count);
  for (size_t i = 0; i < count; ++i) {
    for (size_t k = 0; k < 3; ++k) {
      points[i].position_m[k] = places.positions[3 * i + k];
      points[i].normal[k] = double(places.normals[3 * i + k]);
    }
    points[i].illuminance_lx = double(readings[i].illuminance_lx);
    points[i].error_bound_lx = double(readings[i].error_bound_lx);
  }
  const bool of_file = layout == MeterLayout::grid || layout == MeterLayout::en12464;  // else as a program lists them
  std::optional<MapData> data = meter_map(meters.name, points, meters.info.columns, &scene, of_file);
  if (!data) return data;
  data->quantity = quantity_of(meters.info.meter_kind);
  auto s = sized<ups_meter_statistics>();
  check(ups_result_get_meter_statistics(result, meters.info.sensor, &s));
  data->summary =
      summary_text(s.mean_lx, s.mean_error_bound_lx, s.min_lx, s.max_lx, s.worst_relative_error_bound, "lx");
  return data;
}

const char* quantity_of(ups_meter_kind kind) {
  static constexpr const char* quantities[] = {"Illuminance",           "Cylindrical illuminance",
                                               "Semicylindrical illuminance", "Hemispherical illuminance",
                                               "Spherical illuminance", "Length of the light vector"};
  return quantities[kind];
}

uint32_t columns_of(const double* positions_m, size_t count) {
  if (count < 4) return 0;
  const auto between_points = [&](size_t a, size_t b) {
    const double *p = positions_m + 3 * a, *q = positions_m + 3 * b;
    return Vector{q[0] - p[0], q[1] - p[1], q[2] - p[2]};
  };
  const Vector step = between_points(0, 1);
  const double tiny = 1e-4 * length(step) * double(std::min<size_t>(count, 2500));  // at most a quarter of a step
  const auto differ = [&](const Vector& a, const Vector& b) {
    return length({a[0] - b[0], a[1] - b[1], a[2] - b[2]}) > tiny;
  };
  size_t columns = 2;
  while (columns < count && length(between_points(columns - 1, columns)) < 1.5 * length(step) &&
         !differ(between_points(columns - 1, columns), step))
    ++columns;
  if (columns == count || count % columns != 0) return 0;
  const Vector row = between_points(0, columns);
  if (std::abs(dot(step.data(), row.data())) > 1e-4 * length(step) * length(row)) return 0;  // no cells of a map
  for (size_t i = 0; i < count; ++i) {
    const double c = double(i % columns), r = double(i / columns);
    Vector expected;
    for (size_t k = 0; k < 3; ++k) expected[k] = c * step[k] + r * row[k];
    if (differ(between_points(0, i), expected)) return 0;
  }
  return uint32_t(columns);
}

std::vector<float> within_image(const SensorInfo& camera, std::vector<float> values) {
  if (camera.projection != UPS_EQUIDISTANT && camera.projection != UPS_EQUISOLID) return values;
  const double r = 0.5 * camera.height;
  for (size_t i = 0; i < values.size(); ++i) {
    const double x = std::abs(double(i % camera.width) + 0.5 - 0.5 * camera.width) + 0.5,
                 y = std::abs(double(i / camera.width) + 0.5 - r) + 0.5;
    if (x * x + y * y > r * r) values[i] = -1;  // where the circle crosses it, its part beyond counts as black
  }
  return values;
}

MapData image_map(const std::string& name, const std::string& quantity, const std::string& unit,
                  const std::vector<float>& values, const std::vector<float>& bounds, uint32_t columns, uint32_t rows) {
  return map_of_image(name, quantity, unit, values, bounds, columns, rows, {}, true);
}

MapData image_map(const std::string& name, const std::string& quantity, const std::string& unit,
                  const std::vector<float>& values, const std::vector<float>& bounds, uint32_t columns, uint32_t rows,
                  const std::vector<float>& weights) {
  return map_of_image(name, quantity, unit, values, bounds, columns, rows, weights, false);
}

MapStyle of_luminance(MapStyle style) {
  style.threshold = style.luminance_threshold;
  style.low = style.luminance_low, style.high = style.luminance_high;
  return style;
}

std::vector<float> luminance_of(const std::vector<float>& rgb) {
  std::vector<float> y(rgb.size() / 3);
  for (size_t i = 0; i < y.size(); ++i)
    y[i] = 0.2126f * rgb[3 * i] + 0.7152f * rgb[3 * i + 1] + 0.0722f * rgb[3 * i + 2];
  return y;
}

std::string summary_of(const std::vector<MeterPoint>& points) {
  const auto is_known = [](const MeterPoint& p) { return std::isfinite(p.illuminance_lx) && p.illuminance_lx >= 0; };
  const bool by_area = std::any_of(points.begin(), points.end(), [](const MeterPoint& p) { return p.area_m2 > 0; });
  double sum = 0, known = 0, min = INFINITY, max = -INFINITY, worst = 0;
  for (const MeterPoint& p : points) {
    if (!is_known(p)) continue;
    const double weight = by_area ? p.area_m2 : 1;
    sum += weight * p.illuminance_lx, known += weight;
    min = std::min(min, p.illuminance_lx), max = std::max(max, p.illuminance_lx);
  }
  if (known == 0) return "no value is known";
  const double mean = sum / known;
  for (const MeterPoint& p : points) {  // relative as a render's are: of at least 5 % of the mean
    if (!is_known(p)) continue;
    const double of = std::max(p.illuminance_lx, 0.05 * mean);
    worst = p.error_bound_lx < 0 || worst < 0 ? -1 : std::max(worst, of > 0 ? p.error_bound_lx / of : 0);
  }
  return summary_text(mean, -1, min, max, worst, "lx");
}

std::string summary_text(double mean, double mean_bound, double min, double max, double worst_relative_bound,
                         const std::string& unit, bool of_camera) {
  if (mean < 0) return "no value is known";
  std::string text = "mean " + significant(mean, 4);
  if (mean_bound >= 0) text += " \u00b1 " + bound_text(mean_bound);
  text += " " + unit + ", min " + significant(min, 4) + ", max " + significant(max, 4) + " " + unit;
  if (unit == "lx" && !of_camera && mean > 0) text += format(", U0 %.3f", min / mean);
  if (worst_relative_bound >= 0)
    text += ", 95 % bound of the worst value " + bound_text(100 * worst_relative_bound) + " %";
  return text;
}

}  // namespace ups::report
