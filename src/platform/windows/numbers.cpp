// See numbers.h. The C library's own writes no global here.
#include "platform/numbers.h"

#include <cmath>

namespace ups::platform {

double log_gamma(double x) { return std::lgamma(x); }

}  // namespace ups::platform
