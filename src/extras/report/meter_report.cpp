// See meter_report.h.
#include "report/meter_report.h"

#include "report/intervals.h"

namespace ups::report {
std::string kind_word(ups_meter_kind kind) {
  static constexpr const char* words[] = {"planar", "cylindrical", "semicylindrical", "hemispherical", "spherical",
                                          "vector"};
  return words[kind];
}

namespace {

// Meter by meter, the least and greatest true ratio: of cylindrical over horizontal ones the modelling index.
void read_points(const ups_result* result, const SensorInfo& a, const SensorInfo& b, RatioReport& r) {
  if (a.meter_count != b.meter_count) return;
  std::vector<ups_interval> points(a.meter_count);
  check(ups_result_read_meter_ratios(result, a.sensor, b.sensor, points.data(), points.size()));
  std::erase_if(points, [](const ups_interval& i) { return i.value < 0; });
  if (points.empty()) return;
  auto info = sized<ups_result_info>();
  check(ups_result_get_info(result, &info));
  r.points = points.size();
  const auto visits = uint32_t(std::min<uint64_t>(info.iterations, info.eye_paths / a.meter_count));  // at most
  r.least = least_of(points, visits), r.greatest = greatest_of(points, visits);
}

}  // namespace

MeterReport read_meter_report(const LitScene& scene, size_t at, const ups_result* result,
                              const MeterQuestions& questions) {
  const SensorEntry& set = scene.sensors[at];
  MeterReport meters{at, set.name, kind_word(set.info.meter_kind), sized<ups_meter_statistics>(), {}, {}};
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

std::vector<RatioReport> read_ratios(const LitScene& scene, const ups_result* result, const MeterQuestions& questions) {
  std::vector<RatioReport> ratios;
  for (const auto& [numerator, denominator] : questions.ratios) {
    const SensorEntry &a = scene.sensors[numerator], &b = scene.sensors[denominator];
    RatioReport r{a.name, b.name, {}};
    check(ups_result_get_meter_ratio(result, a.info.sensor, b.info.sensor, &r.ratio));
    read_points(result, a.info, b.info, r);
    ratios.push_back(r);
  }
  return ratios;
}

}  // namespace ups::report
