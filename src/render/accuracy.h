// What a render's accuracy has cost so far and will cost: the curve, the prediction, the worst meter. Kept by the job,
// copied into results.
#pragma once
#include <memory>
#include <vector>

#include "render/accumulator.h"
#include "render/prediction.h"

namespace ups {

// What the error is looked at of: cameras where no meters are there but observers' eyes, which are soon known.
bool by_pixels(const Snapshot& scene);
// An observer's eye is, as a meter, only where there is nothing else.
bool is_looked_at(const Snapshot& scene, size_t meter_set);
// By DEFAULT: the worst meter, else the mean.
ups_criterion resolve_criterion(ups_criterion criterion, const Snapshot& scene);
double error_by(ups_criterion criterion, const ErrorSummary& summary);  // -1: not known

struct Accuracy {
  std::vector<ups_curve_point> curve;
  std::shared_ptr<const Prediction> prediction;  // null: no error is known yet
  ups_largest_error largest{};                   // sensor 0: none is known
  double start_s = 0, elapsed_s = 0, seconds_per_iteration = 0;  // of iterations

  ups_prediction predict(double relative_error) const;
};

ups_curve_point curve_point(uint32_t iterations, double elapsed_s, const WorkCounts& work, const ErrorSummary& errors);
ups_largest_error largest_error(const Snapshot& scene, const ErrorSummary& errors);

}  // namespace ups
