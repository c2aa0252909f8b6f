// ups_render.h: what accuracy has cost and will cost, of jobs and of results.
#include <algorithm>
#include <cmath>

#include "api/desc.h"
#include "api/render_handles.h"
#include "scene/check.h"

using namespace ups;
using namespace ups::api;

namespace {

Accuracy accuracy_of(const ups_job* job) { return render_of(job).accuracy(); }

ups_prediction predict(const Accuracy& accuracy, double relative_error) {
  if (!std::isfinite(relative_error) || relative_error <= 0)
    fail_argument("relative_error: " + check::text(relative_error) + " is not a finite number > 0, such as 0.01");
  return accuracy.predict(relative_error);
}

const ups_curve_point& point_of(const Accuracy& accuracy, uint32_t index) {
  if (index >= accuracy.curve.size())
    fail_argument("index is " + std::to_string(index) + "; there are " + std::to_string(accuracy.curve.size()) +
                  " points");
  return accuracy.curve[index];
}

const ups_largest_error& largest_of(const Accuracy& accuracy) {
  if (accuracy.largest.sensor.v == 0)
    throw Error(UPS_ERROR_INVALID_STATE,
                "no error of a meter is known: there are none, or the first look at their errors is yet to come");
  return accuracy.largest;
}

}  // namespace

ups_status ups_job_get_prediction(const ups_job* job, double relative_error, ups_prediction* prediction) {
  return guard(__func__, [&] { write_info(prediction, predict(accuracy_of(job), relative_error), "prediction"); });
}

ups_status ups_job_get_curve_count(const ups_job* job, uint32_t* out) {
  return guard(__func__, [&] { require(out, "out") = uint32_t(accuracy_of(job).curve.size()); });
}

ups_status ups_job_get_curve_point(const ups_job* job, uint32_t index, ups_curve_point* point) {
  return guard(__func__, [&] { write_info(point, point_of(accuracy_of(job), index), "point"); });
}

ups_status ups_job_get_largest_error(const ups_job* job, ups_largest_error* error) {
  return guard(__func__, [&] { write_info(error, largest_of(accuracy_of(job)), "error"); });
}

ups_status ups_result_get_prediction(const ups_result* result, double relative_error, ups_prediction* prediction) {
  return guard(__func__,
               [&] { write_info(prediction, predict(data_of(result).accuracy, relative_error), "prediction"); });
}

ups_status ups_result_get_curve_count(const ups_result* result, uint32_t* out) {
  return guard(__func__, [&] { require(out, "out") = uint32_t(data_of(result).accuracy.curve.size()); });
}

ups_status ups_result_get_curve_point(const ups_result* result, uint32_t index, ups_curve_point* point) {
  return guard(__func__, [&] { write_info(point, point_of(data_of(result).accuracy, index), "point"); });
}

ups_status ups_result_get_largest_error(const ups_result* result, ups_largest_error* error) {
  return guard(__func__, [&] { write_info(error, largest_of(data_of(result).accuracy), "error"); });
}

ups_status ups_result_read_convergence(const ups_result* result, ups_convergence_point* points, size_t capacity,
                                       size_t* needed) {
  return guard(__func__, [&] {
    const auto& all = data_of(result).accuracy.curve;
    copy_array(all.size(), points, capacity, needed, "points", [&](size_t i) {
      const ups_curve_point& p = all[i];
      return ups_convergence_point{p.elapsed_s,           p.iterations,           0,           p.median_relative_error,
                                   p.p95_relative_error, p.worst_relative_error, p.bias_share};
    });
  });
}
