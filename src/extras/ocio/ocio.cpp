// The C boundary of ups_ocio.
#include "ups/ups_ocio.h"

#include <cmath>

#include "common/boundary.h"
#include "ocio/false_color.h"
#include "ocio/view.h"

namespace {

using ups::extras::require;

constexpr uint32_t max_side = 16384;

ups::LastError last_error;

template <class Body>
ups_status guarded(Body&& body) {
  return ups::extras::guarded(last_error, body);
}

void check_size(uint32_t width, uint32_t height) {
  require(width > 0 && height > 0 && width <= max_side && height <= max_side, "width and height must be 1 to 16384");
}

void check_luminance(const float* luminance_rgb, uint32_t width, uint32_t height) {
  require(luminance_rgb != nullptr, "luminance_rgb is NULL");
  check_size(width, height);
  for (size_t i = 0; i < 3 * size_t(width) * height; ++i)
    if (!std::isfinite(luminance_rgb[i]))
      throw ups::extras::Error(UPS_ERROR_INVALID_ARGUMENT, "luminance_rgb: element " + std::to_string(i) + " is " +
                                                               std::to_string(luminance_rgb[i]) +
                                                               "; it must be finite");
}

ups_ocio_false_color_desc default_desc() {
  ups_ocio_false_color_desc desc{};
  desc.struct_size = sizeof desc;
  return desc;
}

}  // namespace

ups_status ups_ocio_choose_exposure(const float* luminance_rgb, uint32_t width, uint32_t height, double* out) {
  return guarded([&] {
    require(out != nullptr, "out is NULL");
    check_luminance(luminance_rgb, width, height);
    *out = ups::ocio::choose_exposure(luminance_rgb, size_t(width) * height);
  });
}

ups_status ups_ocio_write_png(const char* path, const float* luminance_rgb, uint32_t width, uint32_t height,
                              double exposure) {
  return guarded([&] {
    require(path != nullptr, "path is NULL");
    require(std::isfinite(exposure) && exposure >= 0, "exposure must be finite and at least 0");
    check_luminance(luminance_rgb, width, height);
    if (exposure == 0) exposure = ups::ocio::choose_exposure(luminance_rgb, size_t(width) * height);
    ups::ocio::write_png(path, ups::ocio::view_of(luminance_rgb, width, height, exposure));
  });
}

void ups_ocio_false_color_desc_init(ups_ocio_false_color_desc* desc, uint32_t struct_size) {
  ups::extras::write_defaults(desc, struct_size, default_desc());
}

ups_status ups_ocio_write_false_color_png(const char* path, const ups_ocio_false_color_desc* desc) {
  return guarded([&] {
    require(path != nullptr, "path is NULL");
    require(desc != nullptr, "desc is NULL");
    const ups_ocio_false_color_desc given = ups::extras::read_desc(desc, default_desc());
    require(given.values != nullptr, "values is NULL");
    check_size(given.columns, given.rows);
    require(std::isfinite(given.scale_min) && std::isfinite(given.scale_max) &&
                (given.scale_max > given.scale_min || (given.scale_max == 0 && given.scale_min == 0)),
            "scale_max must be greater than scale_min, or both 0");
    ups::ocio::write_png(path, ups::ocio::false_color_picture(given));
  });
}

ups_status ups_ocio_write_pixels_png(const char* path, const uint8_t* rgb, uint32_t width, uint32_t height) {
  return guarded([&] {
    require(path != nullptr, "path is NULL");
    require(rgb != nullptr, "rgb is NULL");
    check_size(width, height);
    ups::ocio::Picture picture(width, height, {0, 0, 0});
    std::copy(rgb, rgb + picture.rgb.size(), picture.rgb.begin());
    ups::ocio::write_png(path, picture);
  });
}

const char* ups_ocio_last_error(void) { return last_error.get(); }
