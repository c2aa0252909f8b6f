// See page.h: numbers as texts.
#include <cmath>
#include <cstdlib>

#include "report/page.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

// "-0", which rounding makes of small negative numbers, is 0.
std::string fixed(double value, int decimals) {
  const std::string text = format("%.*f", decimals, value);
  return text.find_first_of("123456789") == std::string::npos && text[0] == '-' ? text.substr(1) : text;
}

// Four digits: 499.6 lx is not 500 lx.
int lux_decimals(double value) { return value >= 1000 ? 0 : value >= 100 ? 1 : value >= 10 ? 2 : 3; }

}  // namespace

std::string end_text(double end, int side, std::string (*text)(double)) {
  constexpr double of_floats = 1e-6;  // 0.6 as a float is no more than 0.6
  const std::string nearest = text(end);
  const double shown = std::strtod(nearest.c_str(), nullptr);
  if (!std::isfinite(end) || side * (shown - end) >= -of_floats * std::abs(end)) return nearest;
  const size_t point = nearest.find('.');
  const int decimals = point == std::string::npos ? 0 : int(nearest.size() - point - 1);
  return fixed(shown + side * std::pow(10, -decimals), decimals);
}

std::string lux(double value) {
  return std::isfinite(value) ? fixed(value, lux_decimals(std::abs(value))) : "not known";
}

std::string ratio(double value) { return std::isfinite(value) ? fixed(value, 3) : "not known"; }

std::string one_decimal(double value) { return fixed(value, 1); }

std::string interval(double low, double high, std::string (*text)(double)) {
  if (low < 0 || high < 0) return {};
  const std::string from = end_text(low, -1, text), to = end_text(high, 1, text);
  return from == to ? from : from + " to " + to;
}

std::string rating_interval(double low, double high) {
  if (low == -1 || high == -1) return {};
  return end_text(low, -1, one_decimal) + " to " + end_text(high, 1, one_decimal);
}

std::string with_interval(double value, double low, double high, std::string (*text)(double)) {
  if (!std::isfinite(value) || value < 0) return {};
  const std::string range = interval(low, high, text);
  return text(value) + (range.empty() ? "" : " <span class=\"i\">" + range + "</span>");
}

std::string beside(double value, double required, std::string (*text)(double)) {
  return beside(value, required, text(value));
}

std::string beside(double value, double required, std::string written) {
  if (!std::isfinite(value)) return written;
  const auto side = [&](double v) { return (v > required) - (v < required); };
  for (int decimals = 0; decimals <= 9 && side(std::strtod(written.c_str(), nullptr)) != side(value); ++decimals)
    if (const std::string finer = fixed(value, decimals); finer.size() >= written.size()) written = finer;
  return written;
}

std::string counted(size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace ups::report
