// Luminance images as pictures: exposure and view transform. Called by ocio.cpp.
#pragma once
#include "ocio/picture.h"

namespace ups::ocio {

double choose_exposure(const float* luminance_rgb, size_t pixel_count);  // as ups_ocio_choose_exposure documents
Picture view_of(const float* luminance_rgb, uint32_t width, uint32_t height, double exposure);

}  // namespace ups::ocio
