// What the readers of descs share. Included by scene/description*.cpp alone.
#pragma once
#include <algorithm>
#include <string>
#include <vector>

#include "scene/check.h"

namespace ups {

inline Affine to_affine(const double (&m)[12]) {
  Affine a;
  std::copy(std::begin(m), std::end(m), a.m);
  return a;
}
inline void copy_transform(const Affine& from, double (&to)[12]) { std::copy(from.m, from.m + 12, to); }

inline void check_count(uint32_t value, uint32_t low, uint32_t high, const char* field) {
  if (value < low || value > high)
    fail_argument(std::string(field) + " is " + std::to_string(value) + "; it must be " + std::to_string(low) + " to " +
                  std::to_string(high));
}

inline void check_reserved(uint32_t value, const char* field = "reserved") {
  check::require(value == 0, std::string(field) + " is " + std::to_string(value) + "; it must be 0");
}

inline std::vector<Vec3> read_vectors(const check::Floats& floats) {
  std::vector<Vec3> out;
  out.reserve(floats.count);
  for (size_t i = 0; i < floats.count; ++i) out.emplace_back(floats.at(i)[0], floats.at(i)[1], floats.at(i)[2]);
  return out;
}

}  // namespace ups
