// Values as a picture in false colour with its labelled scale. Called by ocio.cpp.
#pragma once
#include "ocio/picture.h"
#include "ups/ups_ocio.h"

namespace ups::ocio {

struct Scale {
  double min, max, step;  // ticks at multiples of step
};
// Round ticks that hold the values: steps are 1, 2 or 5 times a power of ten, about five of them.
Scale round_scale(double min, double max);
std::string tick_label(double value, double step);
Color false_color(double fraction);  // 0 to 1
Picture false_color_picture(const ups_ocio_false_color_desc& desc);

}  // namespace ups::ocio
