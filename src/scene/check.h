// Checks of what a program hands over. Each failure says which field (and element) it is, its value, and what would be
// right. Used by scene/description.cpp and by the API.
#pragma once
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/vec.h"

namespace ups::check {

// Shortest text that reads as the number again to people: 0.5, 1e+20, nan.
std::string text(double value);
inline std::string element(const std::string& field, size_t i) { return field + "[" + std::to_string(i) + "]"; }

// The message is put together even where all is well: not where there may be no memory, as in taking something back.
inline void require(bool ok, const std::string& message) {
  if (!ok) fail_argument(message);
}
// field names the whole field only; the text is put together only on failure.
void finite(double value, const std::string& field);
void range(double value, double low, double high, const std::string& field);
void at_least(double value, double low, const std::string& field);
void flag(int32_t value, const std::string& field);
void pointer(const void* p, const std::string& field);
// An enumeration whose values are 0 to last.
void enumeration(int32_t value, int32_t last, const std::string& field, const char* names);
void colour(const float (&rgb)[3], double low, double high, const std::string& field);
// A transform that can be inverted.
void transform(const double (&m)[12], const std::string& field);

// Arrays: what is `count` times `width` floats, `stride` bytes apart (0: tight).
struct Floats {
  const float* data;
  size_t count, width, stride;
  const float* at(size_t i) const {
    return reinterpret_cast<const float*>(reinterpret_cast<const char*>(data) + i * (stride ? stride : 4 * width));
  }
};
void all_finite(const Floats& floats, const std::string& field, const std::string& stride_field);

}  // namespace ups::check
