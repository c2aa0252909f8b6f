// What drawing_svg.cpp has of drawing_cairo.cpp.
#pragma once
#include <string>

#include "report/drawing.h"

namespace ups::report {

// As Cairo writes it: without title and words, letters as outlines, ids that depend on what was drawn before.
std::string to_svg_elements(const Drawing& drawing);

// UTF-8 that Cairo and XML take: what they do not is '?'.
std::string writable(const std::string& text);

}  // namespace ups::report
