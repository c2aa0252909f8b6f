// Decoding of bytes, and the parts of TextReader that are not worth inlining.
#include "photometry/text_reader.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace photometry {
namespace {

bool is_utf8(const unsigned char* s, size_t size) {
  for (size_t i = 0; i < size;) {
    const int more = s[i] < 0x80 ? 0 : s[i] >> 5 == 6 ? 1 : s[i] >> 4 == 14 ? 2 : s[i] >> 3 == 30 ? 3 : -1;
    if (more < 0 || i + size_t(more) >= size) return false;
    for (int k = 1; k <= more; ++k)
      if (s[i + size_t(k)] >> 6 != 2) return false;
    i += size_t(more) + 1;
  }
  return true;
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
  const std::string_view rest = std::string_view(text_).substr(at_);
  bool any = false;
  size_t commas = 0;  // in the present token
  for (size_t i = 0; i < rest.size() && rest[i] != end_of_text; ++i) {
    const auto digit = [&](size_t k) { return k < rest.size() && rest[k] >= '0' && rest[k] <= '9'; };
    if (rest[i] == '.') return false;
    if (rest[i] == ',') {
      if (++commas > 1 || i == 0 || !digit(i - 1) || !digit(i + 1)) return false;
      any = true;
    } else if (is_separator(rest[i])) {
      commas = 0;
    }
  }
  return decimal_commas_ = any;
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
  fail_at(line_, "\"" + std::string(token.substr(0, 40)) + "\" is not a number; " + name + " is expected here");
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
