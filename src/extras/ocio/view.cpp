// Luminance for the eye: exposure chosen from the image, then OpenColorIO's built-in view. The only file that includes
// OpenColorIO.
#include "ocio/view.h"

#include <OpenColorIO/OpenColorIO.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "common/boundary.h"

namespace ups::ocio {

namespace {

namespace OCIO = OCIO_NAMESPACE;

constexpr double mid_grey = 0.26;  // which the view shows as sRGB 117, an 18 % grey
constexpr double low_percentile = 0.05, high_percentile = 0.95;

OCIO::TransformRcPtr builtin(const char* style, OCIO::TransformDirection direction) {
  auto transform = OCIO::BuiltinTransform::Create();
  transform->setStyle(style);
  transform->setDirection(direction);
  return transform;
}

// Made once and kept until the process ends: where memory runs out as one is made, OpenColorIO can end the process.
// Without its cache, which would keep the processor of every exposure as long.
const OCIO::Config& raw_config() {
  static const auto* const config = [] {
    const OCIO::ConfigRcPtr made = OCIO::Config::CreateRaw()->createEditableCopy();
    made->setProcessorCacheFlags(OCIO::PROCESSOR_CACHE_OFF);
    return new OCIO::ConstConfigRcPtr(made);
  }();
  return **config;
}

// Linear Rec.709 to an sRGB display through the ACES output transform for SDR video.
OCIO::ConstCPUProcessorRcPtr make_view(double exposure) {
  auto scale = OCIO::ExposureContrastTransform::Create();
  scale->setStyle(OCIO::EXPOSURE_CONTRAST_LINEAR);
  scale->setExposure(std::log2(exposure));
  auto group = OCIO::GroupTransform::Create();
  group->appendTransform(scale);
  group->appendTransform(builtin("UTILITY - ACES-AP1_to_LINEAR-REC709_BFD", OCIO::TRANSFORM_DIR_INVERSE));
  group->appendTransform(builtin("ACEScg_to_ACES2065-1", OCIO::TRANSFORM_DIR_FORWARD));
  group->appendTransform(
      builtin("ACES-OUTPUT - ACES2065-1_to_CIE-XYZ-D65 - SDR-VIDEO_1.0", OCIO::TRANSFORM_DIR_FORWARD));
  group->appendTransform(builtin("DISPLAY - CIE-XYZ-D65_to_sRGB", OCIO::TRANSFORM_DIR_FORWARD));
  const auto processor = raw_config().getProcessor(group);
  return processor->getOptimizedCPUProcessor(OCIO::BIT_DEPTH_F32, OCIO::BIT_DEPTH_UINT8, OCIO::OPTIMIZATION_DEFAULT);
}

}  // namespace

double ev100_of(double exposure) { return std::log2(8 * mid_grey) - std::log2(exposure); }  // their ratio may overflow
double exposure_of(double ev100) { return 8 * mid_grey / std::exp2(ev100); }

std::string exposure_text(double exposure, bool chosen) {
  char text[160];
  std::snprintf(text, sizeof text, "EV100 %.2f: %.4g cd/m2 is shown as an 18 %% grey%s", ev100_of(exposure),
                mid_grey / exposure,
                chosen ? ", the geometric mean of the image between its 5th and 95th percentile" : "");
  return text;
}

double choose_exposure(const float* rgb, size_t pixel_count) {
  std::vector<double> luminance;
  for (size_t i = 0; i < pixel_count; ++i) {
    const double y = 0.2126 * rgb[3 * i] + 0.7152 * rgb[3 * i + 1] + 0.0722 * rgb[3 * i + 2];
    if (y > 0) luminance.push_back(y);
  }
  if (luminance.empty()) return 1;
  std::sort(luminance.begin(), luminance.end());
  const size_t begin = size_t(low_percentile * double(luminance.size()));
  const size_t end = std::max(begin + 1, size_t(std::ceil(high_percentile * double(luminance.size()))));
  double sum = 0;
  for (size_t i = begin; i < end; ++i) sum += std::log(luminance[i]);
  return mid_grey / std::exp(sum / double(end - begin));
}

Picture view_of(const float* rgb, uint32_t width, uint32_t height, double exposure) {
  extras::ask_for_memory(extras::ample_bytes + size_t(width) * height * 64);
  try {
    Picture picture(width, height, {0, 0, 0});
    // Negative values have no colour; the view transform must not see them.
    std::vector<float> source(size_t(width) * height * 3);
    for (size_t i = 0; i < source.size(); ++i) source[i] = std::max(rgb[i], 0.f);
    const OCIO::PackedImageDesc from(source.data(), width, height, 3);
    OCIO::PackedImageDesc to(picture.rgb.data(), width, height, OCIO::CHANNEL_ORDERING_RGB, OCIO::BIT_DEPTH_UINT8,
                             OCIO::AutoStride, OCIO::AutoStride, OCIO::AutoStride);
    const TrapsMasked masked;  // OpenColorIO makes infinities, and means it
    make_view(exposure)->apply(from, to);
    return picture;
  } catch (const OCIO::Exception& e) {
    if (extras::tells_of_memory(e)) throw std::bad_alloc();
    throw extras::Error(UPS_ERROR_UNSUPPORTED, std::string("OpenColorIO: ") + e.what());
  }
}

}  // namespace ups::ocio
