// The environment variable UPS_STABILITY=full: the sample counts that the acceptance of a hazard asks for.
#pragma once
#include <cstdlib>
#include <string>

namespace ups::test {

inline bool full() {
  const char* form = std::getenv("UPS_STABILITY");
  return form && std::string(form) == "full";
}
template <class T>
T fast_or_full(T fast, T in_full) {
  return full() ? in_full : fast;
}

}  // namespace ups::test
