// What the writers of photometric files share: keywords as lines of text, sizes as few digits.
#pragma once
#include "photometry/text_reader.h"

namespace photometry {

// The first keyword of that name (capitals), or "".
inline std::string keyword_value(const std::vector<Keyword>& keywords, std::string_view name) {
  for (const Keyword& k : keywords)
    if (k.name == name) return k.value;
  return {};
}

// Without what would end or hide a line.
inline std::string one_line(std::string text) {
  for (char& c : text)
    if ((c >= 0 && c < ' ') || c == '\x7f') c = ' ';
  return text;
}

// The number of fewest digits that is the same float.
inline double shorter(float value) {
  char text[32];
  double out = value;
  parse_number(std::string_view(text, size_t(std::to_chars(text, text + sizeof text, value).ptr - text)), out);
  return out;
}

// Adds a warning where the flux or the peak of the file that was written of the photometry parts from its own by more
// than 0.1 %.
void check_written(const Photometry& photometry, const std::string& text, std::vector<std::string>& warnings);

}  // namespace photometry
