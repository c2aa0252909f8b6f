// The floating-point environment that results are computed in: round to nearest, subnormal numbers kept, no traps. A
// host may have set another one on its thread (FE_UPWARD, flush to zero). Needs the standard library alone: included
// by the boundaries of the core and of the extras, and by every thread of the library.
#pragma once
#include <cfenv>

namespace ups {

// Sets the default environment; gives the host its own back, flags included.
class DefaultFloatingPoint {
 public:
  DefaultFloatingPoint() {
    std::fegetenv(&host_);
    std::fesetenv(FE_DFL_ENV);
  }
  ~DefaultFloatingPoint() { std::fesetenv(&host_); }
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

 private:
  std::fenv_t host_;
};

}  // namespace ups
