// A drawing as a file. Called by all commands that draw.
#pragma once
#include <string>

#include "tool/drawing.h"

namespace ups::tool {

bool is_drawing_file(const std::string& path);  // by its extension: .svg, .png, .pdf
// Writes such a file, whole or not at all; throws what names it.
void write_drawing(const std::string& path, const Drawing& drawing, const Words& words);

}  // namespace ups::tool
