// What accuracy costs, read from a result. Called by findings.cpp and the program.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "report/lit_scene.h"

namespace ups::report {

struct PredictionReport {
  double relative_error;
  ups_prediction prediction;
};
inline constexpr double foretold_errors[] = {0.05, 0.02, 0.01, 0.005};

std::vector<PredictionReport> read_predictions(const ups_result* result);  // of foretold_errors; none is known: empty
std::vector<ups_curve_point> read_curve(const ups_result* result);

struct WorstMeter {
  std::string set;
  ups_largest_error error;
};
std::optional<WorstMeter> read_worst_meter(const LitScene& scene, const ups_result* result);

}  // namespace ups::report
