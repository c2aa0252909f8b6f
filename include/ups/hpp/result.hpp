// UPS for C++17: what a render has found, ups_render.h, ups_statistics.h and ups_glare.h. See ups.hpp.
#ifndef UPS_HPP_RESULT_HPP
#define UPS_HPP_RESULT_HPP

#include "profile.hpp"

namespace ups {
inline namespace v0_1 {

// Floats a pixel of a UPS_CHANNEL_*: 3 or 1.
constexpr std::size_t floats_per_pixel(ups_channel channel) noexcept {
  switch (channel) {
    case UPS_CHANNEL_LUMINANCE_RGB:
    case UPS_CHANNEL_STANDARD_ERROR_RGB:
    case UPS_CHANNEL_PATH_INTEGRATION_RGB:
    case UPS_CHANNEL_DENSITY_ESTIMATION_RGB:
    case UPS_CHANNEL_ROBUST_RGB:
    case UPS_CHANNEL_ALBEDO_RGB:
    case UPS_CHANNEL_NORMAL: return 3;
    default: return 1;
  }
}

struct ImageSize {
  std::uint32_t width, height;
};

struct GoniometerAngles {
  std::vector<float> c_deg, gamma_deg;
};

// Immutable, any thread. Methods that fill a span copy nothing else; it must have as many elements as C's count or size
// says. Those that return an array of meters ask the set's statistics how many there are.
class Result : public Handle<ups_result> {
 public:
  using Handle::Handle;

  ups_result_info get_info() const { return detail::sized<ups_result_info>(ups_result_get_info, get()); }
  std::string get_text(ups_result_text topic) const { return detail::text(ups_result_get_text, get(), topic); }
  ups_sensor_choice get_choice(ups_sensor_id sensor) const {
    return detail::sized<ups_sensor_choice>(ups_result_get_choice, get(), sensor);
  }

  // ---- meters
  void read_meters(ups_sensor_id sensor, Span<ups_meter_reading> out) const {
    check(ups_result_read_meters(get(), sensor, out.data(), out.size()));
  }
  std::vector<ups_meter_reading> read_meters(ups_sensor_id sensor) const {
    return of_meters<ups_meter_reading>(ups_result_read_meters, sensor, get(), sensor);
  }
  // The result's own, until it is destroyed: none of a temporary, which ends before its view.
  Span<const ups_meter_reading> view_meters(ups_sensor_id sensor) const & {
    const ups_meter_reading* readings;
    std::size_t count;
    check(ups_result_view_meters(get(), sensor, &readings, &count));
    return {readings, count};
  }
  Span<const ups_meter_reading> view_meters(ups_sensor_id sensor) const && = delete;
  void read_vectors(ups_sensor_id sensor, Span<ups_vector_reading> out) const {
    check(ups_result_read_vectors(get(), sensor, out.data(), out.size()));
  }
  std::vector<ups_vector_reading> read_vectors(ups_sensor_id sensor) const {
    return of_meters<ups_vector_reading>(ups_result_read_vectors, sensor, get(), sensor);
  }
  void read_meter_part(ups_sensor_id sensor, ups_light_part part, Span<ups_meter_part_reading> out) const {
    check(ups_result_read_meter_part(get(), sensor, part, out.data(), out.size()));
  }
  std::vector<ups_meter_part_reading> read_meter_part(ups_sensor_id sensor, ups_light_part part) const {
    return of_meters<ups_meter_part_reading>(ups_result_read_meter_part, sensor, get(), sensor, part);
  }
  void read_vector_part(ups_sensor_id sensor, ups_light_part part, Span<ups_vector_part_reading> out) const {
    check(ups_result_read_vector_part(get(), sensor, part, out.data(), out.size()));
  }
  std::vector<ups_vector_part_reading> read_vector_part(ups_sensor_id sensor, ups_light_part part) const {
    return of_meters<ups_vector_part_reading>(ups_result_read_vector_part, sensor, get(), sensor, part);
  }
  void read_meter_flags(ups_sensor_id sensor, Span<std::uint32_t> out) const {
    check(ups_result_read_meter_flags(get(), sensor, out.data(), out.size()));
  }
  std::vector<std::uint32_t> read_meter_flags(ups_sensor_id sensor) const {
    return of_meters<std::uint32_t>(ups_result_read_meter_flags, sensor, get(), sensor);
  }
  ups_meter_statistics get_meter_statistics(ups_sensor_id sensor) const {
    return detail::sized<ups_meter_statistics>(ups_result_get_meter_statistics, get(), sensor);
  }
  ups_interval get_meter_percentile(ups_sensor_id sensor, double share) const {
    return detail::value<ups_interval>(ups_result_get_meter_percentile, get(), sensor, share);
  }
  ups_interval get_meter_share(ups_sensor_id sensor, double threshold_lx) const {
    return detail::value<ups_interval>(ups_result_get_meter_share, get(), sensor, threshold_lx);
  }
  ups_interval get_meter_ratio(ups_sensor_id numerator, ups_sensor_id denominator) const {
    return detail::value<ups_interval>(ups_result_get_meter_ratio, get(), numerator, denominator);
  }
  std::vector<ups_interval> read_meter_ratios(ups_sensor_id numerator, ups_sensor_id denominator) const {
    return of_meters<ups_interval>(ups_result_read_meter_ratios, numerator, get(), numerator, denominator);
  }

  // ---- sources apart: with ups_render_desc.separation
  std::vector<ups_source_info> sources() const {
    return detail::all<ups_source_info>(ups_result_get_source_count, ups_result_get_source, get());
  }
  void read_source_meters(std::uint32_t source, ups_sensor_id sensor, Span<ups_meter_reading> out) const {
    check(ups_result_read_source_meters(get(), source, sensor, out.data(), out.size()));
  }
  std::vector<ups_meter_reading> read_source_meters(std::uint32_t source, ups_sensor_id sensor) const {
    return of_meters<ups_meter_reading>(ups_result_read_source_meters, sensor, get(), source, sensor);
  }

  // ---- images: row 0 is the top, rows without gaps
  void read_image(ups_sensor_id camera, ups_channel channel, Span<float> out) const {
    detail::expect(out.size(), view_image(camera, channel).size(), "out");
    check(ups_result_read_image(get(), camera, channel, out.data(), 0, out.size() * sizeof(float)));
  }
  std::vector<float> read_image(ups_sensor_id camera, ups_channel channel) const {
    const auto own = view_image(camera, channel);
    return {own.begin(), own.end()};
  }
  // width, height: those that the camera had when it was rendered, else INVALID_ARGUMENT.
  std::vector<float> read_image(ups_sensor_id camera, ups_channel channel, std::uint32_t width,
                                std::uint32_t height) const {
    const ImageSize own = image_size(camera);
    detail::expect(width, own.width, "width");
    detail::expect(height, own.height, "height");
    return read_image(camera, channel);
  }
  ImageSize image_size(ups_sensor_id camera) const {
    const float *pixels;
    ImageSize size;
    check(ups_result_view_image(get(), camera, UPS_CHANNEL_LUMINANCE_RGB, &pixels, &size.width, &size.height));
    return size;
  }
  // The result's own, as view_meters; floats_per_pixel(channel) a pixel.
  Span<const float> view_image(ups_sensor_id camera, ups_channel channel) const & {
    const float *pixels;
    std::uint32_t width, height;
    check(ups_result_view_image(get(), camera, channel, &pixels, &width, &height));
    return {pixels, std::size_t{width} * height * floats_per_pixel(channel)};
  }
  Span<const float> view_image(ups_sensor_id camera, ups_channel channel) const && = delete;
  std::vector<ups_technique_info> techniques(ups_sensor_id camera) const {
    return detail::all<ups_technique_info>(ups_result_get_technique_count, ups_result_get_technique, get(), camera);
  }
  // 3 floats a pixel.
  void read_technique(ups_sensor_id camera, std::uint32_t index, ups_contribution contribution,
                      Span<float> out) const {
    check(ups_result_read_technique(get(), camera, index, contribution, out.data(), 0, out.size() * sizeof(float)));
  }

  // ---- goniometers
  ups_goniometer_info get_goniometer_info(ups_sensor_id sensor) const {
    return detail::sized<ups_goniometer_info>(ups_result_get_goniometer_info, get(), sensor);
  }
  GoniometerAngles get_goniometer_angles(ups_sensor_id sensor) const {
    const ups_goniometer_info info = get_goniometer_info(sensor);
    GoniometerAngles out{std::vector<float>(info.c_count), std::vector<float>(info.gamma_count)};
    check(ups_result_get_goniometer_angles(get(), sensor, out.c_deg.data(), out.c_deg.size(), out.gamma_deg.data(),
                                           out.gamma_deg.size()));
    return out;
  }
  // Gamma fastest.
  std::vector<ups_intensity_reading> read_goniometer(ups_sensor_id sensor) const {
    const ups_goniometer_info info = get_goniometer_info(sensor);
    std::vector<ups_intensity_reading> out(std::size_t{info.c_count} * info.gamma_count);
    check(ups_result_read_goniometer(get(), sensor, out.data(), out.size()));
    return out;
  }
  ups_goniometer_beam get_goniometer_beam(ups_sensor_id sensor, float c_deg, float fraction) const {
    return detail::sized<ups_goniometer_beam>(ups_result_get_goniometer_beam, get(), sensor, c_deg, fraction);
  }
  Profile get_goniometer_profile(ups_sensor_id sensor) const {
    return Profile(detail::value<ups_profile *>(ups_result_get_goniometer_profile, get(), sensor));
  }

  // ---- glare
  ups_observer_reading get_observer(ups_sensor_id observer) const {
    return detail::sized<ups_observer_reading>(ups_result_get_observer, get(), observer);
  }
  // The worst first.
  std::vector<ups_glare_source> glare_sources(ups_sensor_id observer) const {
    std::vector<ups_glare_source> out(get_observer(observer).source_count);
    for (std::uint32_t i = 0; i < out.size(); ++i)
      out[i] = detail::sized<ups_glare_source>(ups_result_get_glare_source, get(), observer, i);
    return out;
  }

  // ---- what accuracy cost, and will cost
  std::vector<ups_curve_point> curve() const {
    return detail::all<ups_curve_point>(ups_result_get_curve_count, ups_result_get_curve_point, get());
  }
  std::vector<ups_convergence_point> read_convergence() const {
    return detail::list<ups_convergence_point>(ups_result_read_convergence, get());
  }
  ups_prediction get_prediction(double relative_error) const {
    return detail::sized<ups_prediction>(ups_result_get_prediction, get(), relative_error);
  }
  ups_largest_error get_largest_error() const {
    return detail::sized<ups_largest_error>(ups_result_get_largest_error, get());
  }
  // For Scene::replay.
  std::vector<ups_sample> read_largest_samples(ups_sensor_id sensor) const {
    return detail::list<ups_sample>(ups_result_read_largest_samples, get(), sensor);
  }

 private:
  // `function` takes the arguments, then an array with an element for each meter of the set.
  template <typename T, typename Function, typename... Arguments>
  std::vector<T> of_meters(Function function, ups_sensor_id set, Arguments... arguments) const {
    std::vector<T> out(get_meter_statistics(set).count);
    check(function(arguments..., out.data(), out.size()));
    return out;
  }
};

}  // namespace v0_1
}  // namespace ups

#endif
