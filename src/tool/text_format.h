// Texts of files and users on their way to a terminal. For the whole program.
#pragma once
#include <cstdio>
#include <string>

#include "report/text_format.h"
#include "tool/library.h"

namespace ups::tool {

// What would steer a terminal (control characters but the end of a line, marks of the writing direction) or is no UTF-8
// as \x1b, \u202e.
std::string printable(const std::string& text);
// The same for a JSON text: escapes that JSON knows, for what it leaves as it is.
std::string printable_json(const std::string& json);

// Control characters, and bytes that are no UTF-8, as _.
std::string one_line(std::string text);

// All that the program says goes through here, but for the bar of progress.
void put(std::FILE* stream, const std::string& text);
void put_error(const std::string& message);    // a line on standard error: "ups: error: ..."
void put_warning(const std::string& message);  // "ups: warning: ..."

}  // namespace ups::tool
