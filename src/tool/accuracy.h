// What accuracy costs, read from a job or a result, and in words. Called by the render command, its bar and its report.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "tool/handles.h"

namespace ups::tool {

struct PredictionReport {
  double relative_error;
  ups_prediction prediction;
};
inline constexpr double foretold_errors[] = {0.05, 0.02, 0.01, 0.005};

ups_prediction predict(const ups_job* job, double relative_error);
ups_prediction predict(const ups_result* result, double relative_error);
std::vector<PredictionReport> read_predictions(const ups_result* result);  // of foretold_errors; none is known: empty
std::vector<ups_curve_point> read_curve(const ups_result* result);

struct WorstMeter {
  std::string set;
  ups_largest_error error;
};
std::optional<WorstMeter> read_worst_meter(const LoadedScene& scene, const ups_result* result);

// "2 % after 42 s (35 s to 55 s)"; "0.5 % never at this rate".
std::string prediction_text(double relative_error, const ups_prediction& prediction);
// What keeps a render from its target within its time limit; empty: nothing, or one of the two is 0.
std::string advice_text(double target, double time_limit_s, const ups_prediction& prediction,
                        const std::optional<WorstMeter>& worst);

}  // namespace ups::tool
