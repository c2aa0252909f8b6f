// What is told of sets of meters: statistics, percentiles, shares above thresholds, ratios. Gathered by report.cpp.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "tool/handles.h"
#include "ups/ups_statistics.h"

namespace ups::tool {

// What the command line asks of meters beside what is always told.
struct MeterQuestions {
  std::vector<double> above;                                // lx
  std::vector<std::pair<std::string, std::string>> ratios;  // names of sets
};

struct IntervalAt {
  double at;  // the share of all meters, or a threshold, lx
  ups_interval interval;
};

struct MeterReport {
  std::string name, kind;
  ups_meter_statistics statistics;
  std::vector<IntervalAt> percentiles, above;
};

struct RatioReport {
  std::string numerator, denominator;
  ups_interval ratio;  // of the means
  // Of sets of as many meters: the ratio meter by meter, least and greatest. Without meters to compare: points == 0.
  size_t points = 0;
  ups_interval least{-1, -1, -1}, greatest{-1, -1, -1};
};

MeterReport read_meter_report(const ups_result* result, const SensorEntry& set, const MeterQuestions& questions);
// Throws Failure where a name is no set of meters.
std::vector<RatioReport> read_ratios(const LoadedScene& scene, const ups_result* result,
                                     const MeterQuestions& questions);
std::string to_text(const MeterReport& meters);
std::string to_text(const RatioReport& ratio);

}  // namespace ups::tool
