// See accuracy.h.
#include "render/accuracy.h"

#include <algorithm>

#include "platform/memory.h"

namespace ups {

bool by_pixels(const Snapshot& scene) {
  return !scene.cameras.empty() && scene.meter_sets.size() == scene.observers.size();
}

bool is_looked_at(const Snapshot& scene, size_t meter_set) {
  return scene.meter_sets.size() == scene.observers.size() ||
         std::none_of(scene.observers.begin(), scene.observers.end(),
                      [=](const Observer& o) { return o.meter_set == meter_set; });
}

ups_criterion resolve_criterion(ups_criterion criterion, const Snapshot& scene) {
  const bool nodes = scene.meter_sets.empty() && scene.cameras.empty();
  if (nodes) return UPS_CRITERION_MEAN;
  if (criterion != UPS_CRITERION_DEFAULT) return criterion;
  return by_pixels(scene) ? UPS_CRITERION_MEAN : UPS_CRITERION_WORST;
}

double error_by(ups_criterion criterion, const ErrorSummary& s) {
  switch (criterion) {
    case UPS_CRITERION_P95: return s.p95;
    case UPS_CRITERION_MEAN: return s.mean;
    case UPS_CRITERION_MEDIAN: return s.median;
    default: return s.worst;
  }
}

ups_prediction Accuracy::predict(double relative_error) const {
  ups_prediction p{sizeof p, UPS_LIMIT_UNKNOWN, -1, -1, -1, -1};
  if (!prediction) return p;
  const Prediction::Expected e = prediction->expect(relative_error);
  p.limited_by = e.by_bias ? UPS_LIMIT_BIAS : UPS_LIMIT_NOISE;
  if (e.reached) {
    p.seconds = p.seconds_low = p.seconds_high = e.reached->elapsed_s;
    p.iterations = e.iterations;
    return p;
  }
  const auto seconds = [&](double iterations) {
    const double s = std::max(elapsed_s, start_s + iterations * seconds_per_iteration);
    return iterations < 0 || s > prediction_horizon_s ? -1 : s;
  };
  p.seconds = seconds(e.iterations);
  p.seconds_low = seconds(e.low);
  p.seconds_high = seconds(e.high);
  p.iterations = p.seconds < 0 ? -1 : e.iterations;
  return p;
}

ups_curve_point curve_point(uint32_t iterations, double elapsed_s, const WorkCounts& work, const ErrorSummary& e) {
  ups_curve_point p{};
  p.struct_size = sizeof p;
  p.iterations = iterations;
  p.elapsed_s = elapsed_s;
  p.median_relative_error = e.median;
  p.p95_relative_error = e.p95;
  p.worst_relative_error = e.worst;
  p.mean_relative_error = e.mean;
  p.bias_share = e.bias_share;
  p.rays = work.rays;
  p.light_paths = work.light_paths;
  p.eye_paths = work.eye_paths;
  p.resident_bytes = platform::resident_bytes();
  return p;
}

ups_largest_error largest_error(const Snapshot& scene, const ErrorSummary& e) {
  ups_largest_error l{};
  l.struct_size = sizeof l;
  if (!e.worst_place) return l;
  const auto [set, meter, error] = *e.worst_place;
  l.sensor.v = scene.meter_set_ids[set] | scene.tag->bits();
  l.index = scene.meter_sets[set].number(meter);
  l.relative_error = e.worst;
  l.bias_share = error.error() > 0 ? error.bias / error.error() : 0;
  const Vec3d position = Vec3d(scene.meter_sets[set].meters[meter].p) + scene.origin;
  l.position_m[0] = position.x, l.position_m[1] = position.y, l.position_m[2] = position.z;
  return l;
}

}  // namespace ups
