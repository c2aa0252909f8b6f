// Luminance images as pictures: exposure and view transform. Called by ocio.cpp.
#pragma once
#include "ocio/picture.h"

namespace ups::ocio {

inline constexpr char smoothed_words[] = "smoothed for display";

double ev100_of(double exposure);  // as ups_ocio_get_ev100 documents; and its inverse
double exposure_of(double ev100);
std::string exposure_text(double exposure, bool chosen);  // for people; chosen: as choose_exposure() does
double choose_exposure(const float* luminance_rgb, size_t pixel_count);  // as ups_ocio_choose_exposure documents
Picture view_of(const float* luminance_rgb, uint32_t width, uint32_t height, double exposure);

}  // namespace ups::ocio
