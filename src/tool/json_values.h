// Numbers and arrays in the program's JSON, and its parts that have files of their own. Included by those that write
// JSON, with inputs_json.cpp all of the program that includes nlohmann/json.
#pragma once
#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "tool/data_sheet.h"
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

template <class Values>
ordered_json array_json(const Values& values) {
  ordered_json array = ordered_json::array();
  for (const auto value : values) array.push_back(number(value));
  return array;
}

ordered_json sheet_json(const DataSheet& sheet);                   // json_data_sheet.cpp
ordered_json meters_json(const std::vector<MeterReport>& sets);     // json_meters.cpp
ordered_json ratios_json(const std::vector<RatioReport>& ratios);

}  // namespace ups::tool
