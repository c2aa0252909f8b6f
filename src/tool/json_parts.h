// What the files that write JSON share. Included by json*.cpp alone.
#pragma once
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tool/report.h"

namespace ups::tool {

using nlohmann::ordered_json;

// JSON has no NaN: a number that is not known is -1.
inline double number(double value) { return std::isfinite(value) ? value : -1; }

// A float as the shortest decimal that means it, not as the double beside it.
inline double number(float value) {
  char text[32];
  double result = value;
  std::from_chars(text, std::to_chars(text, text + sizeof text, value).ptr, result);
  return number(result);
}

ordered_json meters_json(const std::vector<MeterReport>& sets);
ordered_json ratios_json(const std::vector<RatioReport>& ratios);

}  // namespace ups::tool
