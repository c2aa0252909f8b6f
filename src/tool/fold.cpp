// The tables of fold.h, by Unicode's blocks Latin-1 Supplement and Latin Extended-A.
#include "tool/fold.h"

#include <cstdint>
#include <iterator>

#include "common/glyphs.h"

namespace ups::tool {
namespace {

// clang-format off
constexpr const char* letters[] = {  // U+00C0 to U+017F
    "A", "A", "A", "A", "A", "A", "AE", "C", "E", "E", "E", "E", "I", "I", "I", "I",
    "D", "N", "O", "O", "O", "O", "O", "x", "O", "U", "U", "U", "U", "Y", "Th", "ss",
    "a", "a", "a", "a", "a", "a", "ae", "c", "e", "e", "e", "e", "i", "i", "i", "i",
    "d", "n", "o", "o", "o", "o", "o", "/", "o", "u", "u", "u", "u", "y", "th", "y",
    "A", "a", "A", "a", "A", "a", "C", "c", "C", "c", "C", "c", "C", "c", "D", "d",
    "D", "d", "E", "e", "E", "e", "E", "e", "E", "e", "E", "e", "G", "g", "G", "g",
    "G", "g", "G", "g", "H", "h", "H", "h", "I", "i", "I", "i", "I", "i", "I", "i",
    "I", "i", "IJ", "ij", "J", "j", "K", "k", "k", "L", "l", "L", "l", "L", "l", "L",
    "l", "L", "l", "N", "n", "N", "n", "N", "n", "'n", "Ng", "ng", "O", "o", "O", "o",
    "O", "o", "OE", "oe", "R", "r", "R", "r", "R", "r", "S", "s", "S", "s", "S", "s",
    "S", "s", "T", "t", "T", "t", "T", "t", "U", "u", "U", "u", "U", "u", "U", "u",
    "U", "u", "U", "u", "W", "w", "Y", "y", "Y", "Z", "z", "Z", "z", "Z", "z", "s",
};
// clang-format on
static_assert(std::size(letters) == 0x180 - 0xc0);

std::string folded(uint32_t code) {
  if (code >= 0xc0 && code < 0x180) return letters[code - 0xc0];
  if (code >= 0x300 && code < 0x370) return "";      // combining accents
  if (code >= 0x2010 && code <= 0x2015) return "-";  // hyphens and dashes
  if (code == 0x2018 || code == 0x2019) return "'";  // single quotes
  if (code == 0xb5 || code == 0x3bc) return "u";     // micro
  if (code == 0xb2 || code == 0xb3) return code == 0xb2 ? "2" : "3";
  if (code == 0xa9 || code == 0xae) return code == 0xa9 ? "(c)" : "(R)";
  if (code == 0xa0) return " ";  // no-break
  if (code == 0xb0) return {extras::degree_sign};
  if (code == 0xb1) return "+-";
  if (code == 0x2026) return "...";
  if (code == 0x2122) return "TM";
  return "?";
}

}  // namespace

std::string folded(const std::string& utf8) {
  std::string out;
  for (size_t i = 0; i < utf8.size();) {
    const uint8_t lead = uint8_t(utf8[i++]);
    if (lead < 0x80) {
      out += char(lead);
      continue;
    }
    uint32_t code = lead >= 0xf0 ? lead & 0x07u : lead >= 0xe0 ? lead & 0x0fu : lead & 0x1fu;
    const size_t length = lead >= 0xf0 ? 4 : lead >= 0xe0 ? 3 : lead >= 0xc0 ? 2 : 1, first = i;
    while (i < utf8.size() && (uint8_t(utf8[i]) & 0xc0) == 0x80) code = code << 6 | (uint8_t(utf8[i++]) & 0x3fu);
    out += i - first + 1 == length && length > 1 ? folded(code) : "?";
  }
  return out;
}

}  // namespace ups::tool
