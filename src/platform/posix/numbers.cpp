// See numbers.h.
#include "platform/numbers.h"

#include <math.h>

namespace ups::platform {

double log_gamma(double x) {
  int sign;
  return lgamma_r(x, &sign);
}

}  // namespace ups::platform
