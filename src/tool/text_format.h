// printf into a string, and texts of files and users on their way to a terminal. For the whole program.
#pragma once
#include <algorithm>
#include <cstdint>
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

// The character of the UTF-8 sequence at this place, and how many bytes it has; 0: there is none.
struct Utf8 {
  size_t length;
  uint32_t code;
};
Utf8 utf8_at(const std::string& text, size_t at);

// What would steer a terminal (control characters but the end of a line, marks of the writing direction) or is no UTF-8
// as \x1b, \u202e.
std::string printable(const std::string& text);
// The same for a JSON text: escapes that JSON knows, for what it leaves as it is.
std::string printable_json(const std::string& json);

// All that the program says goes through here, but for the bar of progress.
void put(std::FILE* stream, const std::string& text);
void put_error(const std::string& message);    // a line on standard error: "ups: error: ..."
void put_warning(const std::string& message);  // "ups: warning: ..."

}  // namespace ups::tool
