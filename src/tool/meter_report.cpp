// See meter_report.h.
#include "tool/meter_report.h"

#include <algorithm>

#include "tool/accuracy.h"
#include "tool/report.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

std::string interval_text(const ups_interval& i, const char* number) {
  if (i.low < 0) return "";
  const std::string both = std::string(" (") + number + " to " + number + ")";
  return format(both.c_str(), i.low, i.high);
}

std::string kind_word(ups_meter_kind kind) {
  static constexpr const char* words[] = {"planar", "cylindrical", "semicylindrical", "hemispherical", "spherical",
                                          "vector"};
  return words[kind];
}

const ups_gltf_sensor_info& set_of(const LoadedScene& scene, const std::string& name) {
  std::string names;
  for (const SensorEntry& sensor : scene.sensors) {
    if (sensor.info.kind != UPS_GLTF_METERS) continue;
    if (sensor.name == name) return sensor.info;
    names += (names.empty() ? "" : ", ") + sensor.name;
  }
  throw Failure("--ratio: the scene has no meters of the name " + name + "; it has " +
                (names.empty() ? "none" : names));
}

// Meter by meter, least and greatest: of cylindrical over horizontal ones the modelling index.
void read_points(const ups_result* result, const ups_gltf_sensor_info& a, const ups_gltf_sensor_info& b,
                 RatioReport& r) {
  if (a.meter_count != b.meter_count) return;
  std::vector<ups_interval> points(a.meter_count);
  check(ups_result_read_meter_ratios(result, a.sensor, b.sensor, points.data(), points.size()));
  std::erase_if(points, [](const ups_interval& i) { return i.value < 0; });
  if (points.empty()) return;
  const auto [least, greatest] = std::minmax_element(
      points.begin(), points.end(), [](const ups_interval& i, const ups_interval& j) { return i.value < j.value; });
  r.points = points.size(), r.least = *least, r.greatest = *greatest;
}

}  // namespace

MeterReport read_meter_report(const ups_result* result, const SensorEntry& set, const MeterQuestions& questions) {
  MeterReport meters{set.name, kind_word(set.info.meter_kind), {}, {}, {}};
  meters.statistics.struct_size = sizeof meters.statistics;
  check(ups_result_get_meter_statistics(result, set.info.sensor, &meters.statistics));
  for (const double share : {0.05, 0.5, 0.95}) {
    IntervalAt p{share, {}};
    check(ups_result_get_meter_percentile(result, set.info.sensor, share, &p.interval));
    meters.percentiles.push_back(p);
  }
  for (const double threshold : questions.above) {
    IntervalAt a{threshold, {}};
    check(ups_result_get_meter_share(result, set.info.sensor, threshold, &a.interval));
    meters.above.push_back(a);
  }
  return meters;
}

std::vector<RatioReport> read_ratios(const LoadedScene& scene, const ups_result* result,
                                     const MeterQuestions& questions) {
  std::vector<RatioReport> ratios;
  for (const auto& [numerator, denominator] : questions.ratios) {
    RatioReport r{numerator, denominator, {}};
    const ups_gltf_sensor_info &a = set_of(scene, numerator), &b = set_of(scene, denominator);
    check(ups_result_get_meter_ratio(result, a.sensor, b.sensor, &r.ratio));
    read_points(result, a, b, r);
    ratios.push_back(r);
  }
  return ratios;
}

std::string to_text(const MeterReport& meters) {
  const ups_meter_statistics& s = meters.statistics;
  const std::string kind = meters.kind == "planar" ? "" : " (" + meters.kind + ")";
  std::string text =
      format("meters %s%s: mean %.6g lx, min %.6g lx, max %.6g lx, uniformity %.3f%s, diversity %.3f%s, "
             "worst error %s\n",
             meters.name.c_str(), kind.c_str(), s.mean_lx, s.min_lx, s.max_lx, s.uniformity,
             interval_text({s.uniformity, s.uniformity_low, s.uniformity_high}, "%.3f").c_str(), s.diversity,
             interval_text({s.diversity, s.diversity_low, s.diversity_high}, "%.3f").c_str(),
             percent_text(s.worst_relative_error_bound).c_str());
  for (const IntervalAt& a : meters.above)
    text += format("meters %s: %.4g %% at least %.6g lx%s\n", meters.name.c_str(), 100 * a.interval.value, a.at,
                   interval_text({0, 100 * a.interval.low, 100 * a.interval.high}, "%.4g").c_str());
  return text;
}

std::string to_text(const RatioReport& r) {
  std::string text = format("ratio %s / %s: %.4g%s", r.numerator.c_str(), r.denominator.c_str(), r.ratio.value,
                            interval_text(r.ratio, "%.4g").c_str());
  if (r.points > 0)
    text += format("; meter by meter from %.4g%s to %.4g%s", r.least.value, interval_text(r.least, "%.4g").c_str(),
                   r.greatest.value, interval_text(r.greatest, "%.4g").c_str());
  return text + "\n";
}

}  // namespace ups::tool
