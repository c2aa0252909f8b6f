// Decoding of bytes, and the parts of TextReader that are not worth inlining.
#include "photometry/text_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace photometry {
namespace {

// 1,000 or 12,345,678.
bool has_thousands_marks(std::string_view number) {
  if (!number.empty() && (number[0] == '-' || number[0] == '+')) number.remove_prefix(1);
  const size_t first = number.find(',');
  if (first == 0 || first > 3 || number[0] == '0') return false;
  for (size_t i = first; i < number.size(); i += 4) {
    if (number[i] != ',' || i + 4 > number.size()) return false;
    for (size_t k = 1; k < 4; ++k)
      if (!is_digit(number[i + k])) return false;
  }
  return true;
}

// What the commas of a text of numbers can be, line by line. Lines with other words tell nothing.
class Commas {
 public:
  void add(std::string_view line, size_t number);
  bool are_decimal() const;

 private:
  struct Place {
    size_t line = 0;
    std::string number;
  };
  void add_token(std::string_view token, size_t line);
  bool points_ = false, only_decimal_ = true, only_thousands_ = true;
  Place inner_, mixed_;  // the first number with a comma inside; the first in a line that also has blanks alone
};

void Commas::add(std::string_view line, size_t number) {
  constexpr std::string_view blanks(" \t\v\f;\0", 6);
  std::vector<std::string_view> tokens;
  for (size_t at = line.find_first_not_of(blanks); at != line.npos; at = line.find_first_not_of(blanks, at)) {
    const size_t end = std::min(line.find_first_of(blanks, at), line.size());
    tokens.push_back(line.substr(at, end - at));
    if (tokens.back().find_first_not_of("0123456789.,+-eE") != line.npos) return;
    at = end;
  }
  bool blank_alone = false;
  for (size_t i = 0; i < tokens.size(); ++i) {
    blank_alone |= i > 0 && tokens[i - 1].back() != ',' && tokens[i].front() != ',';
    add_token(tokens[i], number);
  }
  if (blank_alone && inner_.line == number && mixed_.line == 0) mixed_ = inner_;
}

void Commas::add_token(std::string_view token, size_t line) {
  points_ |= token.find('.') != token.npos;
  only_decimal_ &= token.front() != ',' && token.back() != ',';
  const size_t first = token.find_first_not_of(','), last = token.find_last_not_of(',');
  if (first == token.npos) return;
  token = token.substr(first, last - first + 1);
  const auto commas = std::count(token.begin(), token.end(), ',');
  double value;
  only_decimal_ &= commas < 2;
  only_thousands_ &= commas > 0 ? has_thousands_marks(token) : !(parse_number(token, value) && value >= 1000);
  if (commas > 0 && inner_.line != line) inner_ = {line, cut(token)};
}

bool Commas::are_decimal() const {
  const auto refuse = [](const Place& place, const char* why) {
    fail_at(place.line, "\"" + place.number + "\" has a comma inside, " + why);
  };
  if (inner_.line == 0) return false;
  if (!points_ && only_decimal_) {
    if (only_thousands_) refuse(inner_, "which may be decimal or a thousands mark, as in all numbers that have one");
    return true;
  }
  if (mixed_.line > 0)
    refuse(mixed_, points_ ? "while blanks part others of its line, and other numbers have decimal points"
                           : "while blanks part others of its line");
  return false;
}

}  // namespace

void append_utf8(std::string& out, uint32_t c) {
  if ((c >= 0xD800 && c < 0xE000) || c > 0x10FFFF) c = 0xFFFD;
  if (c < 0x80) {
    out += char(c);
    return;
  }
  const int more = c < 0x800 ? 1 : c < 0x10000 ? 2 : 3;
  constexpr uint32_t lead[] = {0, 0xC0, 0xE0, 0xF0};
  out += char(lead[more] | c >> 6 * more);
  for (int k = more - 1; k >= 0; --k) out += char(0x80 | (c >> 6 * k & 0x3F));
}

bool is_utf8(const void* bytes, size_t size) {
  const auto* s = static_cast<const unsigned char*>(bytes);
  for (size_t i = 0; i < size;) {
    const unsigned lead = s[i];
    const int more = lead < 0x80 ? 0 : lead < 0xc2 ? -1 : lead < 0xe0 ? 1 : lead < 0xf0 ? 2 : lead < 0xf5 ? 3 : -1;
    if (more < 0 || i + size_t(more) >= size) return false;
    for (int k = 1; k <= more; ++k) {
      const unsigned least = k > 1 ? 0x80 : lead == 0xe0 ? 0xa0 : lead == 0xf0 ? 0x90 : 0x80,
                     most = k > 1 ? 0xbf : lead == 0xed ? 0x9f : lead == 0xf4 ? 0x8f : 0xbf;
      if (s[i + size_t(k)] < least || s[i + size_t(k)] > most) return false;
    }
    i += size_t(more) + 1;
  }
  return true;
}

std::string decode_text(const void* bytes, size_t size) {
  const auto* s = static_cast<const unsigned char*>(bytes);
  std::string out;
  if (size >= 2 && ((s[0] == 0xFF && s[1] == 0xFE) || (s[0] == 0xFE && s[1] == 0xFF))) {
    const size_t low = s[0] == 0xFF ? 0 : 1;
    for (size_t i = 2; i + 1 < size; i += 2) {
      const uint32_t unit = uint32_t(s[i + low] | s[i + 1 - low] << 8);
      append_utf8(out, unit);  // no surrogate pairs: U+FFFD
    }
    return out;
  }
  if (size >= 3 && s[0] == 0xEF && s[1] == 0xBB && s[2] == 0xBF) s += 3, size -= 3;
  if (is_utf8(s, size)) return std::string(reinterpret_cast<const char*>(s), size);
  for (size_t i = 0; i < size; ++i) append_utf8(out, s[i]);
  return out;
}

bool TextReader::detect_decimal_commas() {
  Commas commas;
  const Mark start = mark();
  for (std::string_view line; next_line(line);) {
    const size_t end = line.find(end_of_text);
    commas.add(line.substr(0, end), line_);
    if (end != line.npos) break;
  }
  go_to(start);
  return decimal_commas_ = commas.are_decimal();
}

// False with an empty token at the end of the text, with the token where it is no number.
bool TextReader::next_number(double& value, std::string_view& token) {
  if (!next_token(token)) {
    token = {};
    return false;
  }
  if (parse_number(token, value)) return true;
  if (!decimal_commas_) return false;
  std::string with_point(token);
  std::replace(with_point.begin(), with_point.end(), ',', '.');
  return parse_number(with_point, value);
}

void TextReader::fail_number(std::string_view token, const std::string& name) const {
  if (token.empty()) fail_at(line_, "the file ends before " + name);
  fail_at(line_, "\"" + cut(token) + "\" is not a number; " + name + " is expected here");
}

double TextReader::number(const std::string& name) {
  std::string_view token;
  double value;
  if (!next_number(value, token)) fail_number(token, name);
  return value;
}

double TextReader::number(const char* name, size_t i, size_t n) {
  std::string_view token;
  double value;
  if (!next_number(value, token)) fail_number(token, name + std::to_string(i) + " of " + std::to_string(n));
  return value;
}

size_t TextReader::count(const std::string& name, size_t least) {
  const double value = number(name), most = double(Distribution::max_values);
  if (!(std::abs(value - std::round(value)) < 1e-6) || value < double(least) || value > most)
    fail_at(line_, name + " is " + shown(value) + "; it must be a whole number of at least " + std::to_string(least) +
                       (value > most ? " and no more than 4000000" : ""));
  return size_t(std::lround(value));
}

}  // namespace photometry
