// Sets of meters as JSON.
#include "tool/json_values.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

ordered_json interval_json(const ups_interval& i) {
  return {{"value", number(i.value)}, {"low", number(i.low)}, {"high", number(i.high)}};
}

}  // namespace

ordered_json meters_json(const std::vector<MeterReport>& sets) {
  ordered_json all = ordered_json::object();
  for (const MeterReport& set : sets) {
    const ups_meter_statistics& s = set.statistics;
    ordered_json meters = {{"kind", set.kind},
                           {"mean_lx", number(s.mean_lx)},
                           {"min_lx", number(s.min_lx)},
                           {"max_lx", number(s.max_lx)},
                           {"uniformity", number(s.uniformity)},
                           {"mean_standard_error_lx", number(s.mean_standard_error_lx)},
                           {"mean_error_bound_lx", number(s.mean_error_bound_lx)},
                           {"min_low_lx", number(s.min_low_lx)},
                           {"min_high_lx", number(s.min_high_lx)},
                           {"max_low_lx", number(s.max_low_lx)},
                           {"max_high_lx", number(s.max_high_lx)},
                           {"percentile_5_lx", number(s.percentile_5_lx)},
                           {"uniformity_low", number(s.uniformity_low)},
                           {"uniformity_high", number(s.uniformity_high)},
                           {"diversity", number(s.diversity)},
                           {"diversity_low", number(s.diversity_low)},
                           {"diversity_high", number(s.diversity_high)},
                           {"worst_relative_error_bound", number(s.worst_relative_error_bound)}};
    for (const IntervalAt& p : set.percentiles)
      meters["percentiles_lx"][format("%g", 100 * p.at)] = interval_json(p.interval);
    for (const IntervalAt& a : set.above) meters["share_above"][format("%.9g", a.at)] = interval_json(a.interval);
    all[set.name] = meters;
  }
  return all;
}

ordered_json ratios_json(const std::vector<RatioReport>& ratios) {
  ordered_json all = ordered_json::object();
  for (const RatioReport& r : ratios) {
    ordered_json& ratio = all[r.numerator + "/" + r.denominator] = interval_json(r.ratio);
    if (r.points > 0)
      ratio["meter_by_meter"] = {
          {"count", r.points}, {"least", interval_json(r.least)}, {"greatest", interval_json(r.greatest)}};
  }
  return all;
}

}  // namespace ups::tool
