// A drawing as a file. Called by the C API and by all commands that draw.
#pragma once
#include <string>

#include "report/drawing.h"

namespace ups::report {

std::string lower_extension(const std::string& file);  // with its dot, ".svg"
bool is_drawing_file(const std::string& path);         // by its extension: .svg, .png, .pdf
// Writes such a file, whole or not at all; throws what names it. zoom: pixels a unit, of a PNG; 2: 192 an inch.
void write_drawing(const std::string& path, const Drawing& drawing, const Words& words, double zoom = 2);

}  // namespace ups::report
