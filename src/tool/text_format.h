// printf into a string. For the whole program.
#pragma once
#include <algorithm>
#include <cstdio>
#include <string>

namespace ups::tool {

// However long the names in it are.
template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::string text(size_t(std::max(0, std::snprintf(nullptr, 0, pattern, values...))), '\0');
  std::snprintf(text.data(), text.size() + 1, pattern, values...);
  return text;
}

}  // namespace ups::tool
