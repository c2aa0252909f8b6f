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
// 95 % of noise, of the mean of so many iterations: Student's t of the 16 batches that they are gathered in, or of as
// many as there are. Of an image or of meters so many that an iteration visits some of them the batches may be fewer
// still. -1: not known, as the standard error.
double noise_bound(double standard_error, uint32_t iterations);

inline constexpr double foretold_errors[] = {0.05, 0.02, 0.01, 0.005};

std::vector<PredictionReport> read_predictions(const ups_result* result);  // of foretold_errors; none is known: empty
std::vector<ups_curve_point> read_curve(const ups_result* result);

struct WorstMeter {
  std::string set;
  ups_largest_error error;
};
std::optional<WorstMeter> read_worst_meter(const LitScene& scene, const ups_result* result);

}  // namespace ups::report
