// See findings.h: gathering a render's numbers, words for methods and techniques.
#include "report/findings.h"

#include <algorithm>
#include <cmath>

namespace ups::report {

namespace {

struct Bit {
  uint32_t bit;
  const char* name;
};

// The C names, lower case, without prefix.
constexpr Bit technique_names[] = {{UPS_TECHNIQUE_EMITTER_HIT, "emitter_hit"},
                                   {UPS_TECHNIQUE_LIGHT_SAMPLE, "light_sample"},
                                   {UPS_TECHNIQUE_CONNECT, "connect"},
                                   {UPS_TECHNIQUE_SENSOR_CONNECT, "sensor_connect"},
                                   {UPS_TECHNIQUE_MERGE, "merge"},
                                   {UPS_TECHNIQUE_SENSOR_HIT, "sensor_hit"},
                                   {UPS_TECHNIQUE_MIRROR_SAMPLE, "mirror_sample"}};
constexpr Bit effect_names[] = {{UPS_EFFECT_SPECULAR_REFLECTION, "specular_reflection"},
                                {UPS_EFFECT_TRANSMISSION, "transmission"},
                                {UPS_EFFECT_CAUSTICS, "caustics"},
                                {UPS_EFFECT_GLOSSY, "glossy"},
                                {UPS_EFFECT_INTERREFLECTION, "interreflection"},
                                {UPS_EFFECT_COLOUR, "colour"},
                                {UPS_EFFECT_TEXTURES, "textures"}};

template <size_t N>
std::vector<std::string> names_of(uint32_t bits, const Bit (&names)[N]) {
  std::vector<std::string> result;
  for (const Bit& name : names) {
    if (bits & name.bit) result.emplace_back(name.name);
  }
  return result;
}

}  // namespace

std::string technique_name(uint32_t bit) {
  const std::vector<std::string> names = names_of(bit, technique_names);
  return names.empty() ? "" : names[0];
}

uint32_t technique_bit(const std::string& name) {
  for (const Bit& technique : technique_names)
    if (name == technique.name) return technique.bit;
  return 0;
}

namespace {

// Of the image, in pixels: of a fisheye the image circle, cut at the sides where the image is narrower.
double lit_area(const SensorInfo& camera) {
  const double width = camera.width, height = camera.height, r = 0.5 * height, half = std::min(0.5 * width, r);
  if (camera.projection != UPS_EQUIDISTANT && camera.projection != UPS_EQUISOLID) return width * height;
  return 2 * (half * std::sqrt(r * r - half * half) + r * r * std::asin(half / r));
}

double mean_luminance(const SensorInfo& camera, const std::vector<float>& rgb) {
  double sum = 0;
  for (size_t i = 0; i + 2 < rgb.size(); i += 3) sum += 0.2126 * rgb[i] + 0.7152 * rgb[i + 1] + 0.0722 * rgb[i + 2];
  return sum / lit_area(camera);
}

}  // namespace

std::vector<float> read_image(const ups_result* result, const SensorEntry& camera, ups_channel channel) {
  const bool one = channel == UPS_CHANNEL_ILLUMINANCE || channel == UPS_CHANNEL_ILLUMINANCE_STANDARD_ERROR ||
                   channel == UPS_CHANNEL_ILLUMINANCE_BIAS || channel == UPS_CHANNEL_ILLUMINANCE_ERROR_BOUND ||
                   channel == UPS_CHANNEL_BIAS || channel == UPS_CHANNEL_ERROR_BOUND ||
                   channel == UPS_CHANNEL_DEPTH || channel == UPS_CHANNEL_ID;
  const size_t channels = one ? 1 : 3;
  std::vector<float> pixels(size_t(camera.info.width) * camera.info.height * channels);
  check(ups_result_read_image(result, camera.info.sensor, channel, pixels.data(), 0, pixels.size() * sizeof(float)));
  return pixels;
}

std::string method_word(ups_method method) {
  switch (method) {
    case UPS_METHOD_UPS:
      return "ups";
    case UPS_METHOD_PATH_TRACING:
      return "pt";
    case UPS_METHOD_LIGHT_TRACING:
      return "lt";
    case UPS_METHOD_BIDIRECTIONAL:
      return "bpt";
    case UPS_METHOD_PPM:
      return "ppm";
    case UPS_METHOD_SPPM:
      return "sppm";
    case UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING:
      return "bpm";
    default:
      return "auto";
  }
}

namespace {

ObserverReport observer_report(const LitScene& scene, const SensorEntry& sensor, const ups_result* result) {
  ObserverReport observer{sensor.name, sized<ups_observer_reading>(), {}};
  check(ups_result_get_observer(result, sensor.info.sensor, &observer.reading));
  for (uint32_t i = 0; i < observer.reading.source_count; ++i) {
    auto source = sized<ups_glare_source>();
    check(ups_result_get_glare_source(result, sensor.info.sensor, i, &source));
    observer.sources.push_back({source_name(scene, source.kind, source.id), source});
  }
  return observer;
}

void add_sensor(Report& report, const LitScene& scene, size_t at, const ups_result* result,
                const MeterQuestions& questions) {
  const SensorEntry& sensor = scene.sensors[at];
  if (sensor.info.kind != SensorKind::goniometer) {
    auto choice = sized<ups_sensor_choice>();
    check(ups_result_get_choice(result, sensor.info.sensor, &choice));
    report.choices.push_back({sensor.name, choice, names_of(choice.techniques, technique_names)});
  }
  if (sensor.info.kind == SensorKind::meters) {
    report.meters.push_back(read_meter_report(scene, at, result, questions));
  } else if (sensor.info.kind == SensorKind::goniometer) {
    GoniometerReport goniometer{sensor.name, sized<ups_goniometer_info>()};
    check(ups_result_get_goniometer_info(result, sensor.info.sensor, &goniometer.info));
    report.goniometers.push_back(goniometer);
  } else if (sensor.info.kind == SensorKind::observer) {
    report.observers.push_back(observer_report(scene, sensor, result));
  } else {
    const auto pixels = read_image(result, sensor, UPS_CHANNEL_LUMINANCE_RGB);
    report.cameras.push_back({at, sensor.name, sensor.info.width, sensor.info.height, sensor.info.projection,
                              mean_luminance(sensor.info, pixels), {}});
  }
}

}  // namespace

std::vector<SourceEntry> sources_of(const LitScene& scene, const ups_result* result) {
  uint32_t count = 0;
  check(ups_result_get_source_count(result, &count));
  std::vector<SourceEntry> sources(count);
  for (uint32_t i = 0; i < count; ++i) {
    ups_source_info& info = sources[i].info = sized<ups_source_info>();
    check(ups_result_get_source(result, i, &info));
    sources[i].name = source_name(scene, info.kind, info.id);
  }
  return sources;
}

Report make_report(const std::string& scene_name, const LitScene& scene, const ups_result* result,
                   const MeterQuestions& questions) {
  Report report{};
  report.scene = scene_name;
  report.info.struct_size = sizeof report.info;
  check(ups_result_get_info(result, &report.info));
  report.techniques = names_of(report.info.techniques, technique_names);
  report.effects = names_of(report.info.effects, effect_names);
  const auto text = [&](ups_result_text topic) {
    return lines_of(read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_result_get_text(result, topic, to, capacity, needed);
    }));
  };
  append_once(report.warnings, scene.warnings);
  for (const auto& lines : {text(UPS_TEXT_WARNINGS), text(UPS_TEXT_DROPPED)})
    for (const std::string& line : lines)
      if (!is_told(report.warnings, line)) append_once(report.warnings, {for_people(scene, line)});
  for (size_t i = 0; i < scene.sensors.size(); ++i) add_sensor(report, scene, i, result, questions);
  report.ratios = read_ratios(scene, result, questions);
  for (const SourceEntry& source : sources_of(scene, result))
    report.sources.push_back({source.name, source.info.flux_lm});
  report.convergence = read_curve(result);
  report.predictions = read_predictions(result);
  report.worst_meter = read_worst_meter(scene, result);
  return report;
}

void take_verdicts(const Targets& targets, Report& report) {
  report.targets = judge(targets, report);
  for (const TargetArea& area : targets.areas) report.area_names.push_back(area.name);
}

}  // namespace ups::report
