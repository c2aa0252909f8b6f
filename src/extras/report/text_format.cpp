// See text_format.h.
#include "report/text_format.h"

#include <cmath>
#include <cstdlib>

#include "ups/ups_base.h"

namespace ups::report {

Utf8 utf8_at(const std::string& text, size_t at) {
  constexpr Utf8 none{0, 0};
  const auto byte = [&](size_t i) { return i < text.size() ? uint8_t(text[i]) : uint8_t(0); };
  const uint8_t lead = byte(at);
  if (lead < 0x80) return {1, lead};
  const size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : 2;
  if (lead < 0xc2 || lead > 0xf4) return none;
  for (size_t i = 1; i < length; ++i)
    if ((byte(at + i) & 0xc0) != 0x80) return none;
  uint32_t code = lead & (0xffu >> (length + 1));
  for (size_t i = 1; i < length; ++i) code = code << 6 | (byte(at + i) & 0x3fu);
  const bool overlong = (length == 3 && code < 0x800) || (length == 4 && code < 0x10000);
  return overlong || (code >= 0xd800 && code <= 0xdfff) || code > 0x10ffff ? none : Utf8{length, code};
}

std::string significant(double value, int digits) {
  const std::string scientific = format("%.*e", digits - 1, value);  // rounded: 9.99 may become 1.0e+01
  const int exponent = std::atoi(scientific.c_str() + scientific.find('e') + 1);
  if (!std::isfinite(value) || exponent < -4 || exponent > 15) return format("%.*g", digits, value);
  const double rounded = std::strtod(scientific.c_str(), nullptr);
  std::string text = format("%.*f", std::max(0, digits - 1 - exponent), rounded);
  if (text.find('.') != std::string::npos) text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text;
}

std::string bound_text(double bound) {
  constexpr double of_floats = 1e-6;  // 0.6 as a float is no more than 0.6
  const std::string text = significant(bound, 2);
  const double shown = std::strtod(text.c_str(), nullptr);
  if (!std::isfinite(bound) || shown >= bound * (1 - of_floats)) return text;
  return significant(shown + std::pow(10, std::floor(std::log10(bound)) - 1), 2);
}

std::string duration_text(double seconds) {
  char text[32];
  if (seconds < 9.95) {
    std::snprintf(text, sizeof text, "%.2g s", seconds);
  } else if (seconds < 99.5) {
    std::snprintf(text, sizeof text, "%.0f s", seconds);
  } else if (seconds < 597) {
    std::snprintf(text, sizeof text, "%.2g min", seconds / 60);
  } else if (seconds < 5400) {
    std::snprintf(text, sizeof text, "%.0f min", seconds / 60);
  } else {
    std::snprintf(text, sizeof text, "%.1f h", seconds / 3600);
  }
  return text;
}

std::string version_number() {
  const uint32_t v = ups_version();
  return std::to_string(v / 10000) + "." + std::to_string(v / 100 % 100) + "." + std::to_string(v % 100);
}

}  // namespace ups::report
