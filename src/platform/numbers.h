// What C libraries have under several names.
#pragma once

namespace ups::platform {

// log |Gamma(x)| on any thread: of many systems std::lgamma() writes a global.
double log_gamma(double x);

}  // namespace ups::platform
