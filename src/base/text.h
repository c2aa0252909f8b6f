// Texts for people: a list of messages, a line each. Used by render and api.
#pragma once
#include <string>
#include <vector>

namespace ups {

inline std::string lines(const std::vector<std::string>& list) {
  std::string text;
  for (const std::string& line : list) text += line + "\n";
  return text;
}

}  // namespace ups
