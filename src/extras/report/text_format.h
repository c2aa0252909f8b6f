// printf into a string, and UTF-8. For the whole library and the program ups.
#pragma once
#include <algorithm>
#include <cstdint>
#include <cstdio>
#include <string>

namespace ups::report {

// However long the names in it are.
template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::string text(size_t(std::max(0, std::snprintf(nullptr, 0, pattern, values...))), '\0');
  std::snprintf(text.data(), text.size() + 1, pattern, values...);
  return text;
}

// The character of the UTF-8 sequence at this place, and how many bytes it has; 0: there is none.
struct Utf8 {
  size_t length;
  uint32_t code;
};
Utf8 utf8_at(const std::string& text, size_t at);

// To so many significant digits, without an exponent from 1e-4 to 1e16: 100, 12350, 0.00012.
std::string significant(double value, int digits);
std::string bound_text(double bound);  // two digits, rounded up: what lies within the bound lies within this
std::string duration_text(double seconds);
std::string version_number();  // "0.1.0", of the core

}  // namespace ups::report
