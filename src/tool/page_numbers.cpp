// See page.h: numbers, dates and commands as texts.
#include <cmath>
#include <cstdlib>
#include <ctime>

#include "tool/page.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

// "-0", which rounding makes of small negative numbers, is 0.
std::string fixed(double value, int decimals) {
  const std::string text = format("%.*f", decimals, value);
  return text.find_first_of("123456789") == std::string::npos && text[0] == '-' ? text.substr(1) : text;
}

// For a shell.
std::string quoted(const std::string& word) {
  constexpr const char* plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-./=:,+@%";
  if (!word.empty() && word.find_first_not_of(plain) == std::string::npos) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
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

std::string date_text() {
  std::time_t now = std::time(nullptr);
  if (const char* epoch = std::getenv("SOURCE_DATE_EPOCH")) {
    char* end = nullptr;
    const long long seconds = std::strtoll(epoch, &end, 10);
    if (end != epoch && *end == '\0' && seconds >= 0) now = std::time_t(seconds);
  }
  const std::tm* parts = std::gmtime(&now);
  char text[64];
  if (!parts || std::strftime(text, sizeof text, "%Y-%m-%d %H:%M UTC", parts) == 0) return {};
  return text;
}

std::string command_text(const std::vector<std::string>& arguments, const ups_result_info& info) {
  const auto is_of = [](const std::string& word, const char* option) {
    return word == option || word.compare(0, std::string(option).size() + 1, std::string(option) + "=") == 0;
  };
  std::string text = "ups";
  for (size_t i = 0; i < arguments.size(); ++i) {
    const std::string& word = arguments[i];
    bool left_out = false;
    for (const char* option : {"--time", "--target-error", "--iterations", "--seed"})
      left_out = left_out || is_of(word, option);
    if (!left_out)
      text.append(" ").append(quoted(word));
    else if (word.find('=') == std::string::npos)
      ++i;  // its value
  }
  return text + " --iterations " + std::to_string(info.iterations) + " --seed " + std::to_string(info.seed);
}

}  // namespace ups::tool
