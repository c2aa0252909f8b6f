// See accuracy.h.
#include "tool/accuracy.h"

#include "tool/text_format.h"

namespace ups::tool {

namespace {

std::string error_text(double relative_error) { return format("%.3g %%", 100 * relative_error); }

}  // namespace

ups_prediction predict(const ups_job* job, double relative_error) {
  auto p = sized<ups_prediction>();
  check(ups_job_get_prediction(job, relative_error, &p));
  return p;
}

ups_prediction predict(const ups_result* result, double relative_error) {
  auto p = sized<ups_prediction>();
  check(ups_result_get_prediction(result, relative_error, &p));
  return p;
}

std::string prediction_text(double relative_error, const ups_prediction& p) {
  const std::string error = error_text(relative_error);
  if (p.seconds < 0 && p.seconds_low < 0) return error + " never at this rate";
  const std::string high = p.seconds_high < 0 ? "never" : duration_text(p.seconds_high);
  if (p.seconds < 0) return error + " perhaps never at this rate, not before " + duration_text(p.seconds_low);
  if (p.seconds_low == p.seconds_high) return error + " after " + duration_text(p.seconds);
  return error + " after " + duration_text(p.seconds) + " (" + duration_text(p.seconds_low) + " to " + high + ")";
}

std::string advice_text(double target, double time_limit_s, const ups_prediction& p,
                        const std::optional<WorstMeter>& worst) {
  if (!(target > 0) || !(time_limit_s > 0) || p.limited_by == UPS_LIMIT_UNKNOWN) return {};
  if (p.seconds >= 0 && p.seconds <= time_limit_s) return {};
  const char* limit = p.limited_by == UPS_LIMIT_BIAS
                          ? "bias of merging, which falls slowly: a smaller merge radius may take less"
                          : "noise";
  const std::string limit_text = duration_text(time_limit_s);
  const bool nearly = p.seconds >= 0 && duration_text(p.seconds) == limit_text;
  std::string text = "within " + limit_text + " the target is " + (nearly ? "just " : "") +
                     "out of reach: at this rate " +
                     prediction_text(target, p) + ", limited by " + limit;
  if (!worst) return text;
  const ups_largest_error& e = worst->error;
  return text + format("; meter %u of %s, at (%.6g, %.6g, %.6g), has the largest error, %s", e.index,
                       worst->set.c_str(), e.position_m[0], e.position_m[1], e.position_m[2],
                       error_text(e.relative_error).c_str());
}

}  // namespace ups::tool
