// UPS for C++17: renders and commits on the library's own threads. See ups.hpp.
#ifndef UPS_HPP_JOB_HPP
#define UPS_HPP_JOB_HPP

#include <chrono>
#include <cmath>

#include "result.hpp"

namespace ups {
inline namespace v0_1 {

// What Scene::start and Scene::start_commit give; any thread. Its destructor cancels and waits for the end.
class Job : public Handle<ups_job> {
 public:
  using Handle::Handle;

  // At once, whatever goes on.
  ups_progress poll() const { return detail::sized<ups_progress>(ups_job_poll, get()); }
  // UPS_OK, UPS_CANCELLED, or UPS_TIMEOUT where it goes on; a job that failed throws its error. Less than 0 ms: 0; more
  // than 2^32 - 1: so many.
  template <typename Rep, typename Period>
  ups_status wait(std::chrono::duration<Rep, Period> timeout) const {
    const double ms = std::ceil(std::chrono::duration<double, std::milli>(timeout).count());
    return check(ups_job_wait(get(), ms >= UINT32_MAX ? UINT32_MAX : ms > 0 ? static_cast<std::uint32_t>(ms) : 0));
  }
  // To the end: UPS_OK or UPS_CANCELLED.
  ups_status wait() const {
    ups_status status;
    do status = wait(std::chrono::hours(1));
    while (status == UPS_TIMEOUT);
    return status;
  }
  void cancel() noexcept { ups_job_cancel(get()); }  // asks; returns at once

  // ---- of a render alone
  // What is there after the last whole iteration.
  Result result() const { return Result(detail::value<ups_result *>(ups_job_result, get())); }
  ups_prediction get_prediction(double relative_error) const {
    return detail::sized<ups_prediction>(ups_job_get_prediction, get(), relative_error);
  }
  ups_memory_estimate get_memory_estimate() const {
    return detail::sized<ups_memory_estimate>(ups_job_get_memory_estimate, get());
  }
  std::vector<ups_curve_point> curve() const {
    return detail::all<ups_curve_point>(ups_job_get_curve_count, ups_job_get_curve_point, get());
  }
  ups_largest_error get_largest_error() const {
    return detail::sized<ups_largest_error>(ups_job_get_largest_error, get());
  }
};

}  // namespace v0_1
}  // namespace ups

#endif
