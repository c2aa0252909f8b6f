// See handles.h.
#include "report/handles.h"

#include <algorithm>
#include <string_view>

namespace ups::report {

bool is_told(const std::vector<std::string>& lines, const std::string& line) {
  const size_t colon = line.find(": ");
  const bool of_luminaire =
      colon != std::string::npos && (line.rfind("luminaire ", 0) == 0 || line.rfind("luminaires ", 0) == 0);
  const std::string rest = of_luminaire ? line.substr(colon) : "";
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& told) {
    return told == line || (of_luminaire && told.size() > rest.size() &&
                            told.compare(told.size() - rest.size(), rest.size(), rest) == 0);
  });
}

std::string without_functions(const std::string& message) {
  constexpr std::string_view prefix = "ups_", end = ": ";
  std::string result;
  for (size_t i = 0; i < message.size();) {
    const bool first = i == 0 || (i >= end.size() && message.compare(i - end.size(), end.size(), end) == 0);
    if (first && message.compare(i, prefix.size(), prefix) == 0) {
      const size_t after =
          std::min(message.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_", i), message.size());
      if (message.compare(after, end.size(), end) == 0) {
        i = after + end.size();
        continue;
      }
    }
    result += message[i++];
  }
  return result;
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

void append_once(std::vector<std::string>& to, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (!is_told(to, line)) to.push_back(line);
  }
}

}  // namespace ups::report
