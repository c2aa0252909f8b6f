// See numbers.h. The C library's own writes no global here.
#include "platform/numbers.h"

#include <locale.h>

#include <cmath>
#include <string>

namespace ups::platform {

double log_gamma(double x) { return std::lgamma(x); }

namespace {

struct Before {
  int per_thread;  // of _configthreadlocale()
  std::string numeric;
};

}  // namespace

PointInNumbers::PointInNumbers() {
  const char* numeric = setlocale(LC_NUMERIC, nullptr);
  const auto before = new Before{0, numeric ? numeric : "C"};  // which may throw: first
  before->per_thread = _configthreadlocale(_ENABLE_PER_THREAD_LOCALE);
  before_ = before;
  setlocale(LC_NUMERIC, "C");
}

PointInNumbers::~PointInNumbers() {
  const Before* before = static_cast<Before*>(before_);
  setlocale(LC_NUMERIC, before->numeric.c_str());
  _configthreadlocale(before->per_thread);
  delete before;
}

}  // namespace ups::platform
