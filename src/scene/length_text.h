// Lengths and other numbers in warnings.
#pragma once
#include <cstdio>
#include <cstdlib>
#include <string>

#include "scene/check.h"

namespace ups {

// Two digits are enough for people.
inline std::string short_text(double value) {
  char buffer[32];
  std::snprintf(buffer, sizeof buffer, "%.1e", value);
  return check::text(std::strtod(buffer, nullptr));
}
// 0.1 mm, 4 km.
inline std::string length_text(double m) {
  return m < 0.0995 ? short_text(m * 1000) + " mm" : m < 1000 ? short_text(m) + " m" : short_text(m / 1000) + " km";
}

}  // namespace ups
