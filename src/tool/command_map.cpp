// ups map: a drawing of a meter table or an image that an earlier render wrote.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>
#include <string_view>

#include "platform/files.h"
#include "platform/paths.h"
#include "tool/commands.h"
#include "report/drawing_file.h"
#include "tool/exr_file.h"
#include "tool/inputs.h"
#include "report/map_data.h"
#include "tool/profile_file.h"
#include "tool/report.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

constexpr std::string_view byte_order_mark = "\xEF\xBB\xBF";  // as spreadsheets write before UTF-8

std::string read_whole(const std::string& path) {
  const auto file = platform::open_to_read(path);
  if (!file) throw Failure("cannot read '" + path + "': " + platform::why_not_open(path));
  std::ostringstream text;
  text << file.rdbuf();
  std::string all = text.str();
  if (all.starts_with(byte_order_mark)) all.erase(0, byte_order_mark.size());
  return all;
}

std::vector<std::string> fields_of(const std::string& line) {
  std::vector<std::string> fields;
  std::istringstream from(line);
  for (std::string field; std::getline(from, field, ',');) fields.push_back(field);
  if (!fields.empty() && !fields.back().empty() && fields.back().back() == '\r') fields.back().pop_back();
  return fields;
}

class MeterTable {
 public:
  explicit MeterTable(const std::string& path) : path_(path) {
    std::istringstream lines(read_whole(path));
    std::string line;
    if (!std::getline(lines, line)) throw Failure(path + ": is empty; it must be a table of meters");
    header_ = fields_of(line);
    const char* needed[] = {"x_m", "y_m", "z_m", "nx", "ny", "nz", "illuminance_lx"};
    size_t columns[7];
    for (size_t k = 0; k < 7; ++k) columns[k] = column(needed[k], true);
    const size_t bound = column("error_bound_lx", false), area = column("area_m2", false);
    is_vector = column("vector_x_lx", false) < header_.size();
    for (size_t number = 2; std::getline(lines, line); ++number) {
      if (line.empty() || line == "\r") continue;
      const std::vector<std::string> fields = fields_of(line);
      const auto read = [&](size_t k) { return value(fields, k, number); };
      MeterPoint p{};
      for (size_t k = 0; k < 3; ++k) p.position_m[k] = read(columns[k]), p.normal[k] = read(columns[3 + k]);
      p.illuminance_lx = read(columns[6]);
      p.error_bound_lx = bound == header_.size() ? -1 : read(bound);
      if (area < header_.size()) p.area_m2 = read(area);
      const bool has_place = p.normal[0] != 0 || p.normal[1] != 0 || p.normal[2] != 0;
      if (has_place) points.push_back(p);  // a triangle without area has none
    }
    if (points.empty()) throw Failure(path + ": holds no meter");
  }

  std::vector<MeterPoint> points;
  bool is_vector = false;  // illuminances are lengths of light vectors

 private:
  size_t column(const char* name, bool needed) const {
    const auto found = std::find(header_.begin(), header_.end(), name);
    if (found == header_.end() && needed)
      throw Failure(path_ + ": has no column '" + name + "'; a table of meters by `ups render --out` is read");
    return size_t(found - header_.begin());
  }

  double value(const std::vector<std::string>& fields, size_t column, size_t line) const {
    double number = 0;
    if (column < fields.size()) {
      const std::string& field = fields[column];
      const auto parsed = std::from_chars(field.data(), field.data() + field.size(), number);
      if (parsed.ec == std::errc() && parsed.ptr == field.data() + field.size() && std::isfinite(number)) return number;
    }
    const std::string where = path_ + ", line " + std::to_string(line) + ": ";
    if (fields.size() < header_.size())
      throw Failure(where + "has " + std::to_string(fields.size()) + " of the " + std::to_string(header_.size()) +
                    " fields that the first line names");
    throw Failure(where + "'" + header_[column] + "' is no number");
  }

  const std::string& path_;
  std::vector<std::string> header_;
};

// Of a grid of a single row or column, whose steps are even; 0: they are none.
uint32_t columns_of_line(const std::vector<MeterPoint>& points) {
  if (points.front().area_m2 > 0) return 0;  // triangles of a surface
  const double last = double(points.size() - 1);
  double step[3] = {}, length2 = 0;
  for (size_t k = 0; k < 3 && last > 0; ++k) {
    step[k] = (points.back().position_m[k] - points.front().position_m[k]) / last;
    length2 += step[k] * step[k];
  }
  for (size_t i = 0; i < points.size(); ++i) {
    double off2 = 0;
    for (size_t k = 0; k < 3; ++k)
      off2 += std::pow(points[i].position_m[k] - points.front().position_m[k] - double(i) * step[k], 2);
    if (off2 > 1e-4 * length2) return 0;  // a hundredth of a step
  }
  return std::abs(step[0]) >= std::hypot(step[1], step[2]) ? uint32_t(points.size()) : 1;
}

MapData map_of_table(const MapOptions& options, const std::string& title) {
  const MeterTable table(options.file);
  const std::vector<MeterPoint>& points = table.points;
  std::optional<LoadedScene> scene;
  if (!options.scene.empty()) scene = load_scene(options.scene, {.allow_outside = options.allow_outside});
  std::vector<double> positions;
  for (const MeterPoint& p : points) positions.insert(positions.end(), p.position_m, p.position_m + 3);
  uint32_t columns = columns_of(positions.data(), points.size());
  if (columns == 0) columns = columns_of_line(points);
  std::optional<MapData> data = meter_map(title, points, columns, scene ? &*scene : nullptr);
  if (!data)
    throw Failure(options.file + ": its meters lie on one line or in no plane, or are too many on no lattice; there is "
                                 "no map of them");
  data->summary = summary_of(points);
  if (table.is_vector) data->quantity = quantity_of(UPS_METER_VECTOR);
  return std::move(*data);
}

// Empty where the file has none.
std::vector<float> plane_or_none(const ExrFile& file, const std::string& name) {
  return file.has(name) ? file.channel(name) : std::vector<float>();
}

// As the image's header tells it.
SensorInfo camera_of(const ExrFile& file) {
  SensorInfo camera;
  camera.width = file.width(), camera.height = file.height();
  const std::string projection = file.attribute("projection");
  for (const ups_projection p : {UPS_EQUIDISTANT, UPS_EQUISOLID})
    if (projection == projection_word(p)) camera.projection = p;
  return camera;
}

MapData map_of_image(const MapOptions& options, const std::string& title) {
  const ExrFile file(options.file);
  const SensorInfo camera = camera_of(file);
  if (options.illuminance) {
    if (!file.has("illuminance.Y"))
      throw Failure(options.file + ": has no illuminance; it must be of a camera with \"illuminance_camera\": true");
    return image_map(title, "Illuminance", "lx", within_image(camera, file.channel("illuminance.Y")),
                     plane_or_none(file, "error_bound.illuminance.Y"), file.width(), file.height());
  }
  if (file.has("R") && file.has("G") && file.has("B")) {
    const std::vector<float> r = file.channel("R"), g = file.channel("G"), b = file.channel("B");
    std::vector<float> rgb;
    for (size_t i = 0; i < r.size(); ++i) rgb.insert(rgb.end(), {r[i], g[i], b[i]});
    return image_map(title, "Luminance", "cd/m\u00b2", within_image(camera, luminance_of(rgb)),
                     plane_or_none(file, "error_bound.Y"), file.width(), file.height());
  }
  if (!file.has("Y")) throw Failure(options.file + ": has neither R, G and B nor Y");
  std::vector<float> lux = file.channel("Y");
  const std::vector<float> valid = plane_or_none(file, "valid");  // of a lightmap: which texels there are
  for (size_t i = 0; i < valid.size(); ++i)
    if (valid[i] == 0) lux[i] = -1;
  return image_map(title, "Illuminance", "lx", lux, plane_or_none(file, "error_bound.Y"), file.width(), file.height(),
                   plane_or_none(file, "area"));
}

}  // namespace

int map(const MapOptions& options) {
  const std::string title = options.title.empty() ? platform::stem_of(options.file) : options.title;
  const std::string extension = lower_extension(options.file);
  if (extension != ".csv" && extension != ".exr")
    throw Failure(options.file + ": must be a .csv table of meters or a .exr image by `ups render --out`");
  if (extension == ".csv" && options.illuminance)
    throw WrongUsage("--illuminance: goes with a .exr image of a camera; " + options.file + " is a table");
  if (extension == ".exr" && !options.scene.empty())
    throw WrongUsage("--scene: goes with a .csv table of meters; " + options.file + " is an image");
  const MapData data = extension == ".csv" ? map_of_table(options, title) : map_of_image(options, title);
  const bool lux = data.unit == "lx";
  if (lux && options.style.luminance_threshold > 0)
    throw WrongUsage("--map-threshold-luminance: " + options.file + " is shown in lux; take --map-threshold");
  if (!lux && options.style.threshold > 0)
    throw WrongUsage("--map-threshold: " + options.file + " is shown in cd/m2; take --map-threshold-luminance, or of a "
                     "camera with \"illuminance_camera\": true --illuminance");
  if (lux && options.style.luminance_high > 0)
    throw WrongUsage("--map-range-luminance: " + options.file + " is shown in lux; take --map-range");
  MapStyle style = lux ? options.style : of_luminance(options.style);
  if (!lux && !(style.high > 0)) style.low = options.style.low, style.high = options.style.high;  // of what there is
  std::vector<Output> outputs;
  for (const std::string& path : options.out) outputs.emplace_back("OUT", path);
  if (!options.scene.empty()) spare_inputs(options.scene, outputs);
  const Drawing drawing = map_drawing(data, style);
  for (const std::string& path : options.out) write_drawing(path, drawing, map_words(data, style));
  return exit_done;
}

}  // namespace ups::tool
