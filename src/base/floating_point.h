// The floating-point environment that results are computed in: round to nearest, subnormal numbers kept, no traps. A
// host may have set another one on its thread (FE_UPWARD, flush to zero). Needs the standard library alone: included
// by the boundaries of the core and of the extras, and by every thread of the library.
//
// With UPS_FLOAT_TRAPS, of a build for tests, an invalid operation, a division by zero and an overflow end the program.
#pragma once
#include <cfenv>

namespace ups {

#ifdef UPS_FLOAT_TRAPS
inline constexpr int trapped = FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW;
#endif

// Sets the default environment; gives the host its own back, flags included.
class DefaultFloatingPoint {
 public:
  DefaultFloatingPoint() {
    std::fegetenv(&host_);
    std::fesetenv(FE_DFL_ENV);
#ifdef UPS_FLOAT_TRAPS
    feenableexcept(trapped);
#endif
  }
  ~DefaultFloatingPoint() { std::fesetenv(&host_); }
  DefaultFloatingPoint(const DefaultFloatingPoint&) = delete;
  DefaultFloatingPoint& operator=(const DefaultFloatingPoint&) = delete;

 private:
  std::fenv_t host_;
};

// While it lives nothing traps: tests of boxes, Embree's and ours, divide by zero and compare what is not a number, and
// mean it.
#ifdef UPS_FLOAT_TRAPS
class TrapsMasked {
 public:
  TrapsMasked() { std::feholdexcept(&before_); }
  ~TrapsMasked() { std::fesetenv(&before_); }
  TrapsMasked(const TrapsMasked&) = delete;
  TrapsMasked& operator=(const TrapsMasked&) = delete;

 private:
  std::fenv_t before_;
};
// While it lives our own code traps, which Embree calls where traps are masked.
class TrapsSet {
 public:
  TrapsSet() {
    std::feholdexcept(&before_);
    feenableexcept(trapped);
  }
  ~TrapsSet() { std::fesetenv(&before_); }
  TrapsSet(const TrapsSet&) = delete;
  TrapsSet& operator=(const TrapsSet&) = delete;

 private:
  std::fenv_t before_;
};
#else
struct TrapsMasked {
  TrapsMasked() {}
};
struct TrapsSet {
  TrapsSet() {}
};
#endif

}  // namespace ups
