// Texts for people: a list of messages, a line each; numbers with a point, whatever the host's locale is.
#pragma once
#include <charconv>
#include <cstdint>
#include <string>
#include <vector>

namespace ups {

inline std::string lines(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& line : list) text += line + "\n";
  return text;
}

// As printf's %g with so many digits, at most 17.
inline std::string short_number(double value, int digits) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, value, std::chars_format::general, digits).ptr};
}

// "luminaire 3", "luminaires 3 and 4", "luminaires 3, 4, 5 and 17 more". ids: not empty.
inline std::string listed(const std::string& noun, const std::vector<uint32_t>& ids) {
  constexpr size_t shown = 3;
  std::string text = noun + (ids.size() > 1 ? "s " : " ") + std::to_string(ids[0]);
  for (size_t i = 1; i < ids.size() && i < shown; ++i)
    text += (i + 1 == ids.size() ? " and " : ", ") + std::to_string(ids[i]);
  return ids.size() > shown ? text + " and " + std::to_string(ids.size() - shown) + " more" : text;
}

}  // namespace ups
