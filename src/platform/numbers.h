// What C libraries have under several names.
#pragma once

namespace ups::platform {

// log |Gamma(x)| on any thread: of many systems std::lgamma() writes a global.
double log_gamma(double x);

// As long as it lives this thread's printf() and strtod() have a point in numbers, whatever the host's locale is.
// Making one throws std::bad_alloc.
class PointInNumbers {
 public:
  PointInNumbers();
  ~PointInNumbers();
  PointInNumbers(const PointInNumbers&) = delete;
  PointInNumbers& operator=(const PointInNumbers&) = delete;

 private:
  void* before_;  // the system's
};

}  // namespace ups::platform
