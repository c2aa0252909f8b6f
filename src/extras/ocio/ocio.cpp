// The C boundary of ups_ocio.
#include "ups/ups_ocio.h"

#include <cmath>

#include "common/boundary.h"
#include "ocio/false_color.h"
#include "ocio/smooth.h"
#include "ocio/view.h"
#include "platform/numbers.h"

namespace {

using ups::extras::require;

constexpr uint32_t max_side = 16384;

ups::LastError last_error;

template <class Body>
ups_status guarded(Body&& body) {
  return ups::extras::guarded(last_error, [&] {
    const ups::platform::PointInNumbers point;
    body();
  });
}

void check_size(uint32_t width, uint32_t height) {
  require(width > 0 && height > 0 && width <= max_side && height <= max_side, "width and height must be 1 to 16384");
}

void check_finite(const float* values, size_t count, const std::string& name) {
  for (size_t i = 0; i < count; ++i)
    if (!std::isfinite(values[i]))
      throw ups::extras::Error(UPS_ERROR_INVALID_ARGUMENT, name + ": element " + std::to_string(i) + " is " +
                                                               std::to_string(values[i]) + "; it must be finite");
}

void check_luminance(const float* luminance_rgb, uint32_t width, uint32_t height) {
  require(luminance_rgb != nullptr, "luminance_rgb is NULL");
  check_size(width, height);
  check_finite(luminance_rgb, 3 * size_t(width) * height, "luminance_rgb");
}

void write_picture(const char* path, const ups_ocio_picture_desc& d) {
  require(path != nullptr, "path is NULL");
  require(std::isfinite(d.exposure) && d.exposure >= 0, "exposure must be finite and at least 0");
  require(d.smoothed == 0 || d.smoothed == 1, "smoothed must be 0 or 1");
  require(d.exposure_chosen == 0 || d.exposure_chosen == 1, "exposure_chosen must be 0 or 1");
  require(d.reserved == 0, "reserved must be 0");
  check_luminance(d.luminance_rgb, d.width, d.height);
  const bool chosen = d.exposure == 0 || d.exposure_chosen == 1;
  const double exposure = d.exposure > 0
                              ? d.exposure
                              : ups::ocio::choose_exposure(d.luminance_rgb, size_t(d.width) * d.height);
  ups::ocio::Picture picture = ups::ocio::view_of(d.luminance_rgb, d.width, d.height, exposure);
  ups::ocio::PngTexts texts = {{"Exposure", ups::ocio::exposure_text(exposure, chosen)}};
  if (d.smoothed == 1) {
    ups::ocio::draw_bottom_line(picture, ups::ocio::smoothed_words);
    texts.emplace_back("Comment", ups::ocio::smoothed_words);
  }
  ups::ocio::write_png(path, picture, texts);
}

template <class Desc>
Desc empty_desc() {
  Desc desc{};
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
    auto desc = empty_desc<ups_ocio_picture_desc>();
    desc.width = width, desc.height = height;
    desc.luminance_rgb = luminance_rgb;
    desc.exposure = exposure;
    write_picture(path, desc);
  });
}

ups_status ups_ocio_get_ev100(double exposure, double* out) {
  return guarded([&] {
    require(out != nullptr, "out is NULL");
    require(std::isfinite(exposure) && exposure > 0, "exposure must be finite and greater than 0");
    const double ev100 = ups::ocio::ev100_of(exposure);
    require(ev100 >= -100 && ev100 <= 100, "exposure leads beyond an ev100 of -100 or 100");
    *out = ev100;
  });
}

ups_status ups_ocio_get_exposure(double ev100, double* out) {
  return guarded([&] {
    require(out != nullptr, "out is NULL");
    require(std::isfinite(ev100) && ev100 >= -100 && ev100 <= 100, "ev100 must be within -100 and 100");
    *out = ups::ocio::exposure_of(ev100);
  });
}

void ups_ocio_picture_desc_init(ups_ocio_picture_desc* desc, uint32_t struct_size) {
  ups::extras::write_defaults(desc, struct_size, empty_desc<ups_ocio_picture_desc>());
}

ups_status ups_ocio_write_picture_png(const char* path, const ups_ocio_picture_desc* desc) {
  return guarded([&] {
    require(desc != nullptr, "desc is NULL");
    write_picture(path, ups::extras::read_desc(desc, empty_desc<ups_ocio_picture_desc>()));
  });
}

void ups_ocio_smooth_desc_init(ups_ocio_smooth_desc* desc, uint32_t struct_size) {
  ups::extras::write_defaults(desc, struct_size, empty_desc<ups_ocio_smooth_desc>());
}

ups_status ups_ocio_smooth(const ups_ocio_smooth_desc* desc, float* out_rgb) {
  return guarded([&] {
    require(desc != nullptr, "desc is NULL");
    require(out_rgb != nullptr, "out_rgb is NULL");
    const auto d = ups::extras::read_desc(desc, empty_desc<ups_ocio_smooth_desc>());
    require(d.reserved == 0, "reserved must be 0");
    check_luminance(d.luminance_rgb, d.width, d.height);
    require(d.standard_error_rgb != nullptr, "standard_error_rgb is NULL");
    const size_t pixels = size_t(d.width) * d.height;
    check_finite(d.standard_error_rgb, 3 * pixels, "standard_error_rgb");
    if (d.albedo_rgb) check_finite(d.albedo_rgb, 3 * pixels, "albedo_rgb");
    if (d.normal) check_finite(d.normal, 3 * pixels, "normal");
    if (d.depth) check_finite(d.depth, pixels, "depth");
    const std::vector<float> smoothed = ups::ocio::smooth(d);
    std::copy(smoothed.begin(), smoothed.end(), out_rgb);
  });
}

void ups_ocio_false_color_desc_init(ups_ocio_false_color_desc* desc, uint32_t struct_size) {
  ups::extras::write_defaults(desc, struct_size, empty_desc<ups_ocio_false_color_desc>());
}

ups_status ups_ocio_write_false_color_png(const char* path, const ups_ocio_false_color_desc* desc) {
  return guarded([&] {
    require(path != nullptr, "path is NULL");
    require(desc != nullptr, "desc is NULL");
    const ups_ocio_false_color_desc given = ups::extras::read_desc(desc, empty_desc<ups_ocio_false_color_desc>());
    require(given.values != nullptr, "values is NULL");
    check_size(given.columns, given.rows);
    // Within what its steps and their quotients can hold.
    const double lower = given.scale_min, upper = given.scale_max;
    require((std::abs(lower) <= 1e30 && std::abs(upper) <= 1e30 && upper - lower >= 1e-30 &&
             upper - lower >= 1e-9 * std::max(std::abs(lower), std::abs(upper))) ||
                (lower == 0 && upper == 0),
            "scale_max must be greater than scale_min by at least 1e-30 and a 1e-9th of the larger, both from -1e30 to "
            "1e30; or both 0");
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
