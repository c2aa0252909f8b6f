// See picture.h. The exposure is that of the image as it was rendered, so that smoothing changes nothing but the noise.
#include "tool/picture.h"

#include "tool/output.h"

namespace ups::tool {

namespace {

double exposure_of(const std::vector<float>& luminance, const SensorEntry& camera, const PictureOptions& options) {
  double exposure = 0;
  check(options.ev100 ? ups_ocio_get_exposure(*options.ev100, &exposure)
                      : ups_ocio_choose_exposure(luminance.data(), camera.info.width, camera.info.height, &exposure),
        ups_ocio_last_error);
  return exposure;
}

// Of the mean, bright specks included: their errors are as large as they are, so they are averaged away, and their
// light is kept, which UPS_CHANNEL_ROBUST_RGB lacks.
std::vector<float> smoothed(const SensorEntry& camera, const ups_result* result) {
  const auto read = [&](ups_channel channel) { return read_image(result, camera, channel); };
  std::vector<float> image = read(UPS_CHANNEL_LUMINANCE_RGB);
  const auto error = read(UPS_CHANNEL_STANDARD_ERROR_RGB), albedo = read(UPS_CHANNEL_ALBEDO_RGB),
             normal = read(UPS_CHANNEL_NORMAL), depth = read(UPS_CHANNEL_DEPTH);
  ups_ocio_smooth_desc desc;
  ups_ocio_smooth_desc_init(&desc, sizeof desc);
  desc.width = camera.info.width;
  desc.height = camera.info.height;
  desc.luminance_rgb = image.data();
  desc.standard_error_rgb = error.data();
  desc.albedo_rgb = albedo.data();
  desc.normal = normal.data();
  desc.depth = depth.data();
  check(ups_ocio_smooth(&desc, image.data()), ups_ocio_last_error);
  return image;
}

}  // namespace

void add_exposures(const LoadedScene& scene, const ups_result* result, const PictureOptions& options, Report& report) {
  size_t next = 0;
  for (const SensorEntry& sensor : scene.sensors) {
    if (sensor.info.kind != SensorKind::camera) continue;
    CameraReport& camera = report.cameras[next++];
    const auto luminance = read_image(result, sensor, UPS_CHANNEL_LUMINANCE_RGB);
    double ev100 = 0;
    // Too dark to be shown: there is no exposure, and all else is kept.
    if (ups_ocio_get_ev100(exposure_of(luminance, sensor, options), &ev100) != UPS_OK) continue;
    camera.picture = {ev100, options.ev100.has_value(), options.smooth};
  }
}

void write_picture(const std::string& path, const SensorEntry& camera, const ups_result* result,
                   const PictureOptions& options) {
  const auto luminance = read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB);
  const std::vector<float> shown = options.smooth ? smoothed(camera, result) : luminance;
  ups_ocio_picture_desc desc;
  ups_ocio_picture_desc_init(&desc, sizeof desc);
  desc.width = camera.info.width;
  desc.height = camera.info.height;
  desc.smoothed = options.smooth;
  desc.luminance_rgb = shown.data();
  desc.exposure = exposure_of(luminance, camera, options);
  desc.exposure_chosen = !options.ev100;
  check(ups_ocio_write_picture_png(path.c_str(), &desc), ups_ocio_last_error);
}

}  // namespace ups::tool
