// What accuracy costs, in words. Called by the render command and its bar.
#pragma once
#include <optional>
#include <string>

#include "report/accuracy.h"
#include "tool/library.h"

namespace ups::tool {

ups_prediction predict(const ups_job* job, double relative_error);
ups_prediction predict(const ups_result* result, double relative_error);

// "2 % after 42 s (35 s to 55 s)"; "0.5 % never at this rate".
std::string prediction_text(double relative_error, const ups_prediction& prediction);
// What keeps a render from its target within its time limit; empty: nothing, or one of the two is 0.
std::string advice_text(double target, double time_limit_s, const ups_prediction& prediction,
                        const std::optional<WorstMeter>& worst);

}  // namespace ups::tool
