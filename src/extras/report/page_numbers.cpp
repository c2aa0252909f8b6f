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

int lux_decimals(double value) { return value >= 100 ? 0 : value >= 10 ? 1 : value >= 1 ? 2 : 3; }

}  // namespace

std::string lux(double value) {
  return std::isfinite(value) ? fixed(value, lux_decimals(std::abs(value))) : "not known";
}

std::string ratio(double value) { return std::isfinite(value) ? fixed(value, 3) : "not known"; }

std::string interval(double low, double high, std::string (*text)(double)) {
  if (low < 0 || high < 0) return {};
  const std::string from = text(low), to = text(high);
  return from == to ? from : from + " to " + to;
}

std::string with_interval(double value, double low, double high, std::string (*text)(double)) {
  if (!std::isfinite(value) || value < 0) return {};
  const std::string range = interval(low, high, text);
  return text(value) + (range.empty() ? "" : " <span class=\"i\">" + range + "</span>");
}

std::string beside(double value, double required, std::string (*text)(double)) {
  if (!std::isfinite(value)) return text(value);
  std::string written = text(value);
  const auto side = [&](double v) { return (v > required) - (v < required); };
  for (int decimals = 0; decimals <= 9 && side(std::strtod(written.c_str(), nullptr)) != side(value); ++decimals)
    if (const std::string finer = fixed(value, decimals); finer.size() >= written.size()) written = finer;
  return written;
}

std::string counted(size_t count, const char* one, const char* many) {
  return std::to_string(count) + " " + (count == 1 ? one : many);
}

}  // namespace ups::report
