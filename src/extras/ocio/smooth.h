// Luminance images with less noise, to be looked at. Called by ocio.cpp.
#pragma once
#include <vector>

#include "ups/ups_ocio.h"

namespace ups::ocio {

// As ups_ocio_smooth documents; the desc is right.
std::vector<float> smooth(const ups_ocio_smooth_desc& desc);

}  // namespace ups::ocio
