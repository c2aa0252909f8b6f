// ups_statistics.h: percentiles, shares and ratios of meters.
#include <algorithm>
#include <cmath>

#include "api/render_handles.h"
#include "render/meter_ratios.h"
#include "scene/check.h"

using namespace ups;
using namespace ups::api;

namespace {

ups_interval interval_of(const Known& k, double most) {
  const auto end = [&](double v) { return std::clamp(v, 0.0, most); };
  if (k.interval.low == -1 && k.interval.high == -1) return {k.value, -1, -1};
  return {k.value, end(k.interval.low), end(k.interval.high)};
}

ups_interval interval_of(const Ratio& r) { return {r.value, r.interval.low, r.interval.high}; }

constexpr ups_interval unknown{-1, -1, -1};

}  // namespace

ups_status ups_result_get_meter_percentile(const ups_result* result, ups_sensor_id sensor, double share,
                                           ups_interval* out) {
  return guard(__func__, [&] {
    const MeterBatches& meters = meters_of(result, sensor).batches;
    require(out, "out");
    check::range(share, 0, 1, "share");
    *out = meters.count() == 0 ? unknown : interval_of(percentile(meters, share), INFINITY);
  });
}

ups_status ups_result_get_meter_share(const ups_result* result, ups_sensor_id sensor, double threshold_lx,
                                      ups_interval* out) {
  return guard(__func__, [&] {
    const MeterBatches& meters = meters_of(result, sensor).batches;
    require(out, "out");
    check::finite(threshold_lx, "threshold_lx");
    *out = meters.count() == 0 ? unknown : interval_of(share_above(meters, threshold_lx), 1);
  });
}

ups_status ups_result_get_meter_ratio(const ups_result* result, ups_sensor_id numerator, ups_sensor_id denominator,
                                      ups_interval* out) {
  return guard(__func__, [&] {
    const MeterBatches &a = meters_of(result, numerator).batches, &b = meters_of(result, denominator).batches;
    require(out, "out") = interval_of(ratio_of_means(a, b));
  });
}

ups_status ups_result_read_meter_ratios(const ups_result* result, ups_sensor_id numerator, ups_sensor_id denominator,
                                        ups_interval* out, size_t count) {
  return guard(__func__, [&] {
    const MeterSetReading *read[] = {&meters_of(result, numerator), &meters_of(result, denominator)};
    const MeterSet* sets[] = {&set_of(result, numerator), &set_of(result, denominator)};
    require(out, "out");
    for (size_t k = 0; k < 2; ++k)
      if (count != sets[k]->count())
        fail_argument("count is " + std::to_string(count) + "; the " + (k == 0 ? "numerator" : "denominator") +
                      " has " + std::to_string(sets[k]->count()) + " meters");
    std::fill(out, out + count, unknown);
    for (size_t k = 0; k < 2; ++k)
      if (read[k]->batches.count() != read[k]->meters.size()) return;
    for (size_t m = 0; m < read[0]->meters.size(); ++m) {
      const uint32_t number = sets[0]->number(m), other = sets[1]->index_of(number);
      if (other != none) out[number] = interval_of(ratio_at(read[0]->batches, m, read[1]->batches, other));
    }
  });
}
