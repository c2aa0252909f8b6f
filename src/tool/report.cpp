// See report.h: gathering a render's numbers, words for methods and techniques, and the report for people.
#include "tool/report.h"

#include <algorithm>
#include <cmath>

#include "tool/output.h"
#include "tool/tables.h"
#include "tool/text_format.h"

namespace ups::tool {

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
                                   {UPS_TECHNIQUE_SENSOR_HIT, "sensor_hit"}};
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

constexpr float told_share = 0.2f;  // of a reading that a single sample makes: a bright speck

// Of the image, in pixels: of a fisheye the image circle, cut at the sides where the image is narrower.
double lit_area(const ups_gltf_sensor_info& camera) {
  const double width = camera.width, height = camera.height, r = 0.5 * height, half = std::min(0.5 * width, r);
  if (camera.projection != UPS_EQUIDISTANT && camera.projection != UPS_EQUISOLID) return width * height;
  return 2 * (half * std::sqrt(r * r - half * half) + r * r * std::asin(half / r));
}

double mean_luminance(const ups_gltf_sensor_info& camera, const std::vector<float>& rgb) {
  double sum = 0;
  for (size_t i = 0; i + 2 < rgb.size(); i += 3) sum += 0.2126 * rgb[i] + 0.7152 * rgb[i + 1] + 0.0722 * rgb[i + 2];
  return sum / lit_area(camera);
}

std::string joined(const std::vector<std::string>& words) {
  std::string result;
  for (const std::string& word : words) result += (result.empty() ? "" : ", ") + word;
  return result.empty() ? "none" : result;
}

}  // namespace

std::string percent_text(double fraction) { return fraction < 0 ? "unknown" : format("%.2f %%", 100 * fraction); }

std::string version_number() {
  const uint32_t v = ups_version();
  return std::to_string(v / 10000) + "." + std::to_string(v / 100 % 100) + "." + std::to_string(v % 100);
}

const char* projection_word(ups_projection projection) {
  constexpr const char* words[] = {"perspective", "equidistant", "equisolid", "panorama"};  // UPS_PERSPECTIVE, ...
  return words[projection];
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

ObserverReport observer_report(const LoadedScene& scene, const SensorEntry& sensor, const ups_result* result) {
  ObserverReport observer{sensor.name, {}, {}};
  observer.reading.struct_size = sizeof observer.reading;
  check(ups_result_get_observer(result, sensor.info.sensor, &observer.reading));
  for (uint32_t i = 0; i < observer.reading.source_count; ++i) {
    ups_glare_source source{};
    source.struct_size = sizeof source;
    check(ups_result_get_glare_source(result, sensor.info.sensor, i, &source));
    observer.sources.push_back({source_name(scene, source.kind, source.id), source});
  }
  return observer;
}

std::string observer_text(const ObserverReport& observer) {
  const ups_observer_reading& r = observer.reading;
  std::string text = "observer " + printable(observer.name) + ": ";
  if (r.flags & UPS_OBSERVER_NO_SOURCE)
    text += "no UGR, as no source of glare is visible";
  else if (r.flags & UPS_OBSERVER_NO_BACKGROUND)
    text += "no UGR, as no indirect light was found";
  else
    text += format("UGR %.1f", r.ugr) +
            (r.ugr_low == -1 || r.ugr_high == -1 ? "" : format(" (%.1f to %.1f)", r.ugr_low, r.ugr_high));
  if (r.ceiling_coverage > 0)
    text += format(", GGR %.1f (CIE 147: large sources over %.0f %% of the ceiling)", r.ggr, 100 * r.ceiling_coverage);
  text += r.background_cd_m2 < 0 ? ", background unknown" : format(", background %.4g cd/m^2", r.background_cd_m2);
  if (observer.sources.empty()) return text + "\n";
  const GlareSourceReport& worst = observer.sources[0];
  return text + format(", %u sources, the worst %s with %.0f %%\n", r.source_count, worst.name.c_str(),
                       100 * worst.source.share);
}

}  // namespace

Report make_report(const std::string& scene_path, const LoadedScene& scene, const ups_result* result,
                   const MeterQuestions& questions) {
  Report report{};
  report.scene = scene_path;
  report.info.struct_size = sizeof report.info;
  check(ups_result_get_info(result, &report.info));
  report.techniques = names_of(report.info.techniques, technique_names);
  report.effects = names_of(report.info.effects, effect_names);
  append_once(report.warnings, scene.warnings);
  const auto text = [&](ups_result_text topic) {
    return lines_of(read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_result_get_text(result, topic, to, capacity, needed);
    }));
  };
  append_once(report.warnings, text(UPS_TEXT_WARNINGS));
  append_once(report.warnings, text(UPS_TEXT_DROPPED));
  for (const SensorEntry& sensor : scene.sensors) {
    if (sensor.info.kind != UPS_GLTF_GONIOMETER) {
      ups_sensor_choice choice{};
      choice.struct_size = sizeof choice;
      check(ups_result_get_choice(result, sensor.info.sensor, &choice));
      report.choices.push_back({sensor.name, choice, names_of(choice.techniques, technique_names)});
    }
    if (sensor.info.kind == UPS_GLTF_METERS) {
      report.meters.push_back(read_meter_report(result, sensor, questions));
    } else if (sensor.info.kind == UPS_GLTF_GONIOMETER) {
      GoniometerReport goniometer{sensor.name, {}};
      goniometer.info.struct_size = sizeof goniometer.info;
      check(ups_result_get_goniometer_info(result, sensor.info.sensor, &goniometer.info));
      report.goniometers.push_back(goniometer);
    } else if (sensor.info.kind == UPS_GLTF_OBSERVER) {
      report.observers.push_back(observer_report(scene, sensor, result));
    } else {
      const auto pixels = read_image(result, sensor, UPS_CHANNEL_LUMINANCE_RGB);
      report.cameras.push_back({sensor.name, sensor.info.width, sensor.info.height, sensor.info.projection,
                                mean_luminance(sensor.info, pixels)});
    }
  }
  report.ratios = read_ratios(scene, result, questions);
  for (const SourceEntry& source : sources_of(scene, result))
    report.sources.push_back({source.name, source.info.flux_lm});
  report.convergence = read_curve(result);
  report.predictions = read_predictions(result);
  report.worst_meter = read_worst_meter(scene, result);
  report.largest_samples = read_largest_samples(scene, result);
  return report;
}

std::string to_text(const Report& report) {
  const ups_result_info& info = report.info;
  std::string text = format("%s: method %s, %u iterations in %.2f s on %d threads, seed %llu\n", report.scene.c_str(),
                            method_word(info.method).c_str(), info.iterations, info.elapsed_s, info.threads,
                            static_cast<unsigned long long>(info.seed));
  text += "effects: " + joined(report.effects) + "\ntechniques: " + joined(report.techniques) + "\n";
  text += format("flux: emitted %.6g lm, absorbed %.6g lm, escaped %.6g lm\n", info.emitted_flux_lm,
                 info.absorbed_flux_lm, info.escaped_flux_lm);
  if (info.maintenance_factor != 1) text += format("maintenance factor: %g\n", info.maintenance_factor);
  for (const MeterReport& meters : report.meters) text += to_text(meters);
  for (const RatioReport& ratio : report.ratios) text += to_text(ratio);
  for (const ObserverReport& observer : report.observers) text += observer_text(observer);
  for (const CameraReport& camera : report.cameras) {
    text += format("camera %s: %u x %u, %s, mean luminance %.6g cd/m^2\n", camera.name.c_str(), camera.width,
                   camera.height, projection_word(camera.projection), camera.mean_luminance_cd_m2);
  }
  for (const GoniometerReport& g : report.goniometers) {
    text += format("goniometer %s: flux %.6g lm +- %.2g, light output ratio %s, median error %s, worst %s\n",
                   g.name.c_str(), g.info.flux_lm, g.info.flux_standard_error_lm,
                   percent_text(g.info.light_output_ratio).c_str(),
                   percent_text(g.info.median_relative_error_bound).c_str(),
                   percent_text(g.info.worst_relative_error_bound).c_str());
  }
  for (const SourceReport& source : report.sources)
    text += format("source %s: %.6g lm\n", source.name.c_str(), source.flux_lm);
  for (const PredictionReport& p : report.predictions)
    text += format("accuracy: %s, limited by %s\n", prediction_text(p.relative_error, p.prediction).c_str(),
                   p.prediction.limited_by == UPS_LIMIT_BIAS ? "bias" : "noise");
  if (!report.largest_samples.empty() && report.largest_samples[0].sample.share > told_share) {
    const SampleReport& s = report.largest_samples[0];
    text += format("largest sample: %s of its reading; look into it: ups replay %s --sample %s\n",
                   percent_text(double(s.sample.share)).c_str(), report.scene.c_str(), s.address.c_str());
  }
  for (const std::string& advice : report.advice) text += "advice: " + advice + "\n";
  for (const std::string& warning : report.warnings) text += "warning: " + warning + "\n";
  return text;
}

}  // namespace ups::tool
