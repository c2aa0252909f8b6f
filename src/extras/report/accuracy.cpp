// See accuracy.h.
#include "report/accuracy.h"

namespace ups::report {

std::vector<PredictionReport> read_predictions(const ups_result* result) {
  std::vector<PredictionReport> all;
  for (const double error : foretold_errors) {
    auto p = sized<ups_prediction>();
    check(ups_result_get_prediction(result, error, &p));
    if (p.limited_by != UPS_LIMIT_UNKNOWN) all.push_back({error, p});
  }
  return all;
}

std::vector<ups_curve_point> read_curve(const ups_result* result) {
  uint32_t count = 0;
  check(ups_result_get_curve_count(result, &count));
  std::vector<ups_curve_point> all(count, sized<ups_curve_point>());
  for (uint32_t i = 0; i < count; ++i) check(ups_result_get_curve_point(result, i, &all[i]));
  return all;
}

std::optional<WorstMeter> read_worst_meter(const LitScene& scene, const ups_result* result) {
  auto error = sized<ups_largest_error>();
  const ups_status status = ups_result_get_largest_error(result, &error);
  if (status == UPS_ERROR_INVALID_STATE) return {};  // too short a render, or no meters
  check(status);
  for (const SensorEntry& sensor : scene.sensors)
    if (sensor.info.sensor.v == error.sensor.v) return WorstMeter{sensor.name, error};
  return {};
}

}  // namespace ups::report
