// One field a line, as EULUMDAT files have them: decimal commas, thousands marks (_), blanks, empty for 0. Used by
// eulumdat.cpp and by read.cpp, which recognises the format.
#pragma once
#include <cmath>

#include "photometry/text_reader.h"

namespace photometry {

// An empty field is 0. False where it is no finite number.
inline bool parse_eulumdat_number(std::string_view field, double& value) {
  std::string text(trimmed(field));
  text.erase(std::remove(text.begin(), text.end(), '_'), text.end());
  if (text.empty()) {
    value = 0;
    return true;
  }
  if (text.size() > 64) return false;
  if (text.find('.') == text.npos && std::count(text.begin(), text.end(), ',') == 1) text[text.find(',')] = '.';
  return parse_number(text, value) && std::isfinite(value);
}

class EulumdatText {
 public:
  explicit EulumdatText(std::string text) : in_(text.substr(0, text.find('\x1a'))) {}

  // `name` says what is expected, for the messages.
  std::string_view line(const char* name) {
    std::string_view text;
    if (!in_.next_line(text)) fail_at(in_.line(), std::string("the file ends before ") + name);
    return trimmed(text);
  }
  double number(const char* name) {
    const std::string_view text = line(name);
    double value = 0;
    if (!parse(text, value)) fail_number(text, name);
    return value;
  }
  // For what the light does not depend on: 0 with a warning. Still it tells how commas are meant elsewhere.
  double number_or_zero(const char* name, std::vector<std::string>& warnings) {
    const std::string_view text = line(name);
    double value = 0;
    if (parse(text, value)) return value;
    warnings.push_back(at_line(in_.line(), std::string(name) + " is \"" + cut(text) +
                                               "\", which is not a number; taken as not stated"));
    return 0;
  }
  size_t count(const char* name, size_t least, size_t most) {
    const double value = number(name);
    if (!(value >= double(least)) || value > double(most) || value != std::floor(value))
      fail_at(in_.line(), std::string(name) + " is " + shown(value) + "; it must be a whole number from " +
                              std::to_string(least) + " to " + std::to_string(most));
    return size_t(value);
  }
  // The `i`-th of `n` intensities or angles; `empty` tells an empty line.
  double element(const char* name, size_t i, size_t n, bool& empty) {
    std::string_view text;
    const auto what = [&] { return name + std::to_string(i) + " of " + std::to_string(n); };
    if (!in_.next_line(text)) fail_at(in_.line(), "the file ends before " + what());
    double value = 0;
    if (!parse(text, value)) fail_number(trimmed(text), what());
    empty = trimmed(text).empty();
    return value;
  }
  // Lines with anything on them from here to the end; the place is kept.
  size_t remaining() {
    const TextReader::Mark here = in_.mark();
    size_t n = 0;
    for (std::string_view text; in_.next_line(text);) n += !trimmed(text).empty();
    in_.go_to(here);
    return n;
  }
  // The next `n` lines without leaving the place; fewer at the end of the file.
  std::vector<std::string_view> peek(size_t n) {
    const TextReader::Mark here = in_.mark();
    std::vector<std::string_view> lines;
    for (std::string_view text; lines.size() < n && in_.next_line(text);) lines.push_back(trimmed(text));
    in_.go_to(here);
    return lines;
  }
  size_t at() const { return in_.line(); }
  // The number read last may well be thousands, as a flux or a size is, a ratio is not.
  void may_be_thousands() {
    if (!first_of_quantities_) first_of_quantities_ = last_;
  }
  // When all has been read: such commas are decimal where another comma of the file is for certain (0,98).
  void check_commas() const {
    if (first_of_quantities_ && !has_decimal_commas_) fail_comma(first_of_quantities_, ", as in all numbers that have one");
  }

 private:
  struct Comma {  // that may be either
    size_t line = 0;
    std::string field;
    explicit operator bool() const { return line > 0; }
  };
  [[noreturn]] static void fail_comma(const Comma& comma, const char* why) {
    fail_at(comma.line, "\"" + comma.field + "\" has a comma inside, which may be decimal or a thousands mark" + why);
  }
  [[noreturn]] void fail_number(std::string_view text, const std::string& name) const {
    fail_at(in_.line(), "\"" + cut(text) + "\" is not a number; " + name + " is expected here");
  }
  // A comma before three digits is decimal where all others may be; beside decimal points nobody can tell.
  bool parse(std::string_view text, double& value) {
    last_ = {};
    if (!parse_eulumdat_number(text, value)) return false;
    const std::string_view field = trimmed(text);
    if (looks_like_thousands(field)) last_ = {in_.line(), std::string(field)};
    has_points_ |= field.find('.') != field.npos && field.find(',') == field.npos;
    has_decimal_commas_ |= field.find(',') != field.npos && !last_;
    if (!first_) first_ = last_;
    if (has_points_ && first_) fail_comma(first_, ": other numbers have decimal points");
    return true;
  }
  static bool looks_like_thousands(std::string_view field) {
    const size_t comma = field.find(',');
    return comma >= 1 && comma <= 3 && field[0] != '0' && field.size() == comma + 4 &&
           std::all_of(field.begin(), field.end(), [](char c) { return c == ',' || is_digit(c); });
  }
  TextReader in_;
  bool has_points_ = false, has_decimal_commas_ = false;
  Comma last_, first_, first_of_quantities_;
};

}  // namespace photometry
