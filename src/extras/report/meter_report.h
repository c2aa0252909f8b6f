// What is told of sets of meters: statistics, percentiles, shares above thresholds, ratios. Gathered by findings.cpp.
#pragma once
#include <string>
#include <utility>
#include <vector>

#include "report/lit_scene.h"
#include "ups/ups_statistics.h"

namespace ups::report {

std::string kind_word(ups_meter_kind kind);  // "planar"

// What is asked of meters beside what is always told.
struct MeterQuestions {
  std::vector<double> above;                      // lx
  std::vector<std::pair<size_t, size_t>> ratios;  // of sets, by their places among the scene's sensors
};

struct IntervalAt {
  double at;  // the share of all meters, or a threshold, lx
  ups_interval interval;
};

struct MeterReport {
  size_t sensor;  // its place among the scene's
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

// set: its place among the scene's sensors.
MeterReport read_meter_report(const LitScene& scene, size_t set, const ups_result* result,
                              const MeterQuestions& questions);
std::vector<RatioReport> read_ratios(const LitScene& scene, const ups_result* result, const MeterQuestions& questions);

}  // namespace ups::report
