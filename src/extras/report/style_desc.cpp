// See descs.h: how maps look, and sensors by their names.
#include <algorithm>
#include <cmath>

#include "report/descs.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

using extras::require;

constexpr double most_pixels = 16384;  // a side; Cairo takes twice as many

bool is_flag(int32_t value) { return value == 0 || value == 1; }

bool is_threshold(double value) { return std::isfinite(value) && value >= 0; }

void check(const ups_report_style_desc& d) {
  require(d.scale == UPS_REPORT_SCALE_LINEAR || d.scale == UPS_REPORT_SCALE_LOGARITHMIC,
          "style: scale must be UPS_REPORT_SCALE_LINEAR or UPS_REPORT_SCALE_LOGARITHMIC");
  require(d.colours >= UPS_REPORT_COLOURS_VIRIDIS && d.colours <= UPS_REPORT_COLOURS_GREY,
          "style: colours must be one of UPS_REPORT_COLOURS_*");
  require(is_flag(d.isolines) && is_flag(d.numbers) && is_flag(d.cells),
          "style: isolines, numbers and cells must be 0 or 1");
  require((d.low == 0 && d.high == 0) || is_range(d.low, d.high),
          "style: low must be 0 or at least 1e-12, high 1e-9 to 1e12 and greater by a millionth or more, or both 0");
  require(d.scale == UPS_REPORT_SCALE_LINEAR || d.high == 0 || d.low > 0,
          "style: low must be greater than 0 where the scale is logarithmic");
  require(is_threshold(d.threshold_lx), "style: threshold_lx must be finite and at least 0");
  require(is_threshold(d.threshold_cd_m2), "style: threshold_cd_m2 must be finite and at least 0");
  require(d.width >= 150 && d.width <= 4000, "style: width must be 150 to 4000 units of 1/96 inch");
  require(d.height >= 300 && d.height <= 4000, "style: height must be 300 to 4000 units of 1/96 inch");
  require(d.zoom >= 0.1 && d.zoom <= 8 && d.zoom * std::max(d.width, d.height) <= most_pixels,
          "style: zoom must be 0.1 to 8, and width and height times zoom at most 16384 pixels");
}

}  // namespace

ups_report_style_desc style_defaults() {
  const MapStyle map;
  ups_report_style_desc desc{};
  desc.struct_size = sizeof desc;
  desc.isolines = desc.numbers = 1;
  desc.width = map.width;
  desc.height = map.most_height;
  desc.zoom = 2;
  return desc;
}

Style style_of(const ups_report_style_desc* given) {
  const ups_report_style_desc d = extras::read_desc(given, style_defaults());
  check(d);
  Style style{{}, d.zoom};
  style.map.scale = d.scale == UPS_REPORT_SCALE_LOGARITHMIC ? MapScale::logarithmic : MapScale::linear;
  constexpr MapColours colours[] = {MapColours::viridis, MapColours::cividis, MapColours::grey};
  style.map.colours = colours[d.colours];
  style.map.low = style.map.luminance_low = d.low, style.map.high = style.map.luminance_high = d.high;
  style.map.threshold = d.threshold_lx;
  style.map.luminance_threshold = d.threshold_cd_m2;
  style.map.isolines = d.isolines == 1;
  style.map.numbers = d.numbers == 1;
  style.map.cells = d.cells == 1;
  style.map.width = d.width;
  style.map.most_height = d.height;
  return style;
}

void require_array(const void* array, uint32_t count, const char* name) {
  if (!array && count > 0) throw Failure(std::string(name) + " is NULL, but its count is " + std::to_string(count));
}

namespace {

// A page of two states of a scene would contradict itself.
void require_committed(const ups_scene* scene, const ups_result* result) {
  int32_t dirty = 0;
  report::check(ups_scene_is_dirty(scene, &dirty));
  if (dirty)
    throw Failure("scene has edits that are not committed, which its results know nothing of: commit it first, or wait "
                  "for the commit that runs",
                  UPS_ERROR_INVALID_STATE);
  if (!result) return;
  auto of_scene = sized<ups_scene_info>();
  auto of_result = sized<ups_result_info>();
  report::check(ups_scene_get_info(scene, &of_scene));
  report::check(ups_result_get_info(result, &of_result));
  if (of_scene.revision != of_result.revision)
    throw Failure("result is not of the scene as it was committed last, but as it was before or of another: render it",
                  UPS_ERROR_INVALID_STATE);
}

}  // namespace

LitScene lit_scene_of(const ups_scene* scene, const ups_result* result, const ups_report_sensor* sensors,
                      uint32_t count) {
  require_array(sensors, count, "sensors");
  require_committed(scene, result);
  LitScene lit;
  lit.scene = scene;
  for (uint32_t i = 0; i < count; ++i) {
    const ups_report_sensor& s = sensors[i];
    const std::string where = "sensors[" + std::to_string(i) + "]: ";
    if (s.reserved != 0) throw Failure(where + "reserved must be 0");
    for (const SensorEntry& before : lit.sensors)
      if (before.info.sensor.v == s.sensor.v) throw Failure(where + "is named twice, as '" + before.name + "' before");
    try {
      lit.sensors.push_back(sensor_entry(scene, s.sensor, text_of(s.name)));
    } catch (const Failure& e) {
      throw Failure(where + e.what(), e.status());
    }
  }
  lit.source_words = [](ups_source_kind kind, uint32_t id) {
    constexpr uint32_t number_bits = 0xffffff;
    const char* what = kind == UPS_SOURCE_INSTANCE ? "instance " : "luminaire ";
    return SourceWords{what + std::to_string(id & number_bits), ""};
  };
  lit.warnings = lines_of(read_text([&](char* to, size_t capacity, size_t* needed) {
    return ups_scene_get_text(scene, UPS_SCENE_TEXT_WARNINGS, to, capacity, needed);
  }));
  for (std::string& line : lit.warnings) line = for_people(lit, line);
  return lit;
}

}  // namespace ups::report
