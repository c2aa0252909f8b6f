// A rendered result, read in one call each through the public C API. Every failing call throws with the library's
// message, and so does a result that holds a non-finite value, left a sample out or has books of flux that do not
// close: no test can overlook any. Made by Scene (scene_builder.h).
#pragma once
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ups/ups.h"

namespace ups::test {

inline void check(ups_status status, const char* call) {
  if (status != UPS_OK)
    throw std::runtime_error(std::string(call) + ": " + ups_status_name(status) + ": " + ups_last_error());
}

struct Image {
  uint32_t width = 0, height = 0;
  std::vector<float> luminance, standard_error;  // rgb
  // lx; empty unless the camera has it
  std::vector<float> illuminance, illuminance_error, illuminance_bias, illuminance_bound;
  std::vector<float> bias, error_bound;          // of luminance
  std::vector<float> robust;                     // rgb
};

struct Sensor {
  ups_sensor_id id{0};
  uint32_t count = 0;              // meters
  uint32_t width = 0, height = 0;  // camera
  bool illuminance = false;
  uint32_t planes = 0, gammas = 0;  // goniometer
};

class Result {
 public:
  Result(ups_result* result, const std::vector<Sensor>& sensors) : result_(result, ups_result_destroy) {
    if (info().dropped_samples != 0) throw std::runtime_error("dropped samples: " + text(UPS_TEXT_DROPPED));
    if (text(UPS_TEXT_WARNINGS).find("does not close") != std::string::npos)
      throw std::runtime_error(text(UPS_TEXT_WARNINGS));
    for (const Sensor& s : sensors) {
      if (s.count > 0)
        readings(s);
      else if (s.planes > 0)
        intensities(s), goniometer_info(s);
      else
        image(s);
    }
  }

  const ups_result* get() const { return result_.get(); }
  ups_result_info info() const {
    ups_result_info i{};
    i.struct_size = sizeof i;
    check(ups_result_get_info(result_.get(), &i), "ups_result_get_info");
    require_finite({i.emitted_flux_lm, i.absorbed_flux_lm, i.escaped_flux_lm, i.elapsed_s,
                    i.flux_balance_standard_error_lm}, "result info");
    return i;
  }
  ups_sensor_choice choice(const Sensor& sensor) const {
    ups_sensor_choice c{};
    c.struct_size = sizeof c;
    check(ups_result_get_choice(result_.get(), sensor.id, &c), "ups_result_get_choice");
    return c;
  }
  std::vector<ups_meter_reading> readings(const Sensor& meters) const {
    std::vector<ups_meter_reading> out(meters.count);
    check(ups_result_read_meters(result_.get(), meters.id, out.data(), out.size()), "ups_result_read_meters");
    for (const auto& r : out)
      require_finite({r.illuminance_lx, r.standard_error_lx, r.bias_lx, r.error_bound_lx, r.direct_lx, r.indirect_lx},
                     "meter reading");
    return out;
  }
  std::vector<ups_vector_reading> vectors(const Sensor& meters) const {
    std::vector<ups_vector_reading> out(meters.count);
    check(ups_result_read_vectors(result_.get(), meters.id, out.data(), out.size()), "ups_result_read_vectors");
    for (const auto& r : out)
      for (int k = 0; k < 3; ++k)
        require_finite({r.vector_lx[k], r.standard_error_lx[k], r.error_bound_lx[k]}, "vector");
    return out;
  }
  std::vector<ups_vector_part_reading> vectors(const Sensor& meters, ups_light_part part) const {
    std::vector<ups_vector_part_reading> out(meters.count);
    check(ups_result_read_vector_part(result_.get(), meters.id, part, out.data(), out.size()),
          "ups_result_read_vector_part");
    for (const auto& r : out)
      for (int k = 0; k < 3; ++k)
        require_finite({r.vector_lx[k], r.standard_error_lx[k], r.bias_lx[k], r.error_bound_lx[k]}, "part of a vector");
    return out;
  }
  std::vector<ups_meter_part_reading> part(const Sensor& meters, ups_light_part part) const {
    std::vector<ups_meter_part_reading> out(meters.count);
    check(ups_result_read_meter_part(result_.get(), meters.id, part, out.data(), out.size()),
          "ups_result_read_meter_part");
    for (const auto& r : out)
      require_finite({r.illuminance_lx, r.standard_error_lx, r.bias_lx, r.error_bound_lx}, "part of a meter's reading");
    return out;
  }
  ups_observer_reading observer(const Sensor& eye) const {
    const ups_observer_reading r = open_ended_observer(eye);
    require_finite({r.ugr_high}, "observer");
    return r;
  }
  // Of which nothing may end the interval: ugr_high is infinite then.
  ups_observer_reading open_ended_observer(const Sensor& eye) const {
    ups_observer_reading r{};
    r.struct_size = sizeof r;
    check(ups_result_get_observer(result_.get(), eye.id, &r), "ups_result_get_observer");
    require_finite({r.ugr, r.ugr_standard_error, r.ugr_low, r.background_cd_m2,
                    r.background_standard_error_cd_m2, r.background_error_bound_cd_m2, r.ceiling_coverage, r.ggr,
                    r.ggr_low}, "observer");
    if (std::isnan(r.ugr_high) || std::isnan(r.ggr_high)) throw std::runtime_error("no number: end of a glare rating");
    return r;
  }
  std::vector<ups_glare_source> glare_sources(const Sensor& eye) const {
    return glare_sources(eye, observer(eye).source_count);
  }
  std::vector<ups_glare_source> glare_sources(const Sensor& eye, uint32_t count) const {
    std::vector<ups_glare_source> all(count);
    for (uint32_t i = 0; i < all.size(); ++i) {
      all[i].struct_size = sizeof all[i];
      check(ups_result_get_glare_source(result_.get(), eye.id, i, &all[i]), "ups_result_get_glare_source");
      const ups_glare_source& s = all[i];
      require_finite({s.luminance_cd_m2, s.solid_angle_sr, s.intensity_cd, s.distance_m, s.visible_share,
                      s.position_index, s.share}, "glare source");
    }
    return all;
  }
  std::vector<uint32_t> flags(const Sensor& meters) const {
    std::vector<uint32_t> out(meters.count);
    check(ups_result_read_meter_flags(result_.get(), meters.id, out.data(), out.size()), "ups_result_read_meter_flags");
    return out;
  }
  std::vector<ups_source_info> sources() const {
    uint32_t count = 0;
    check(ups_result_get_source_count(result_.get(), &count), "ups_result_get_source_count");
    std::vector<ups_source_info> all(count);
    for (uint32_t i = 0; i < count; ++i) {
      all[i].struct_size = sizeof all[i];
      check(ups_result_get_source(result_.get(), i, &all[i]), "ups_result_get_source");
    }
    return all;
  }
  std::vector<ups_meter_reading> readings_of_source(uint32_t source, const Sensor& meters) const {
    std::vector<ups_meter_reading> out(meters.count);
    check(ups_result_read_source_meters(result_.get(), source, meters.id, out.data(), out.size()),
          "ups_result_read_source_meters");
    return out;
  }
  std::vector<ups_intensity_reading> intensities(const Sensor& goniometer) const {
    std::vector<ups_intensity_reading> out(size_t(goniometer.planes) * goniometer.gammas);
    check(ups_result_read_goniometer(result_.get(), goniometer.id, out.data(), out.size()),
          "ups_result_read_goniometer");
    for (const auto& r : out)
      require_finite({r.intensity_cd, r.standard_error_cd, r.bias_cd, r.error_bound_cd}, "goniometer");
    return out;
  }
  ups_goniometer_info goniometer_info(const Sensor& goniometer) const {
    ups_goniometer_info i{};
    i.struct_size = sizeof i;
    check(ups_result_get_goniometer_info(result_.get(), goniometer.id, &i), "ups_result_get_goniometer_info");
    require_finite({i.flux_lm, i.flux_standard_error_lm, i.outside_flux_lm, i.emitted_flux_lm, i.absorbed_flux_lm,
                    i.light_output_ratio, i.light_output_ratio_standard_error, i.worst_relative_error_bound,
                    i.median_relative_error_bound}, "goniometer info");
    return i;
  }
  std::unique_ptr<ups_profile, decltype(&ups_profile_destroy)> goniometer_profile(const Sensor& goniometer) const {
    ups_profile* profile = nullptr;
    check(ups_result_get_goniometer_profile(result_.get(), goniometer.id, &profile),
          "ups_result_get_goniometer_profile");
    return {profile, ups_profile_destroy};
  }
  ups_goniometer_beam goniometer_beam(const Sensor& goniometer, float c_deg, float fraction) const {
    ups_goniometer_beam b{};
    b.struct_size = sizeof b;
    check(ups_result_get_goniometer_beam(result_.get(), goniometer.id, c_deg, fraction, &b),
          "ups_result_get_goniometer_beam");
    require_finite({b.angle_deg, b.standard_error_deg, b.bias_deg, b.low_deg, b.high_deg}, "beam");
    return b;
  }
  ups_meter_statistics statistics(const Sensor& meters) const {
    ups_meter_statistics s{};
    s.struct_size = sizeof s;
    check(ups_result_get_meter_statistics(result_.get(), meters.id, &s), "ups_result_get_meter_statistics");
    require_finite({s.mean_lx, s.min_lx, s.max_lx, s.uniformity, s.mean_standard_error_lx, s.mean_bias_lx,
                    s.mean_error_bound_lx, s.min_low_lx, s.min_high_lx, s.max_low_lx, s.max_high_lx, s.uniformity_low,
                    s.uniformity_high, s.percentile_5_lx, s.percentile_5_low_lx, s.percentile_5_high_lx},
                   "meter statistics");
    return s;
  }
  Image image(const Sensor& camera) const {
    const auto lux = [&](ups_channel channel) {
      return camera.illuminance ? read(camera, channel, 1) : std::vector<float>{};
    };
    return {camera.width, camera.height, read(camera, UPS_CHANNEL_LUMINANCE_RGB, 3),
            read(camera, UPS_CHANNEL_STANDARD_ERROR_RGB, 3), lux(UPS_CHANNEL_ILLUMINANCE),
            lux(UPS_CHANNEL_ILLUMINANCE_STANDARD_ERROR), lux(UPS_CHANNEL_ILLUMINANCE_BIAS),
            lux(UPS_CHANNEL_ILLUMINANCE_ERROR_BOUND),
            read(camera, UPS_CHANNEL_BIAS, 1), read(camera, UPS_CHANNEL_ERROR_BOUND, 1),
            read(camera, UPS_CHANNEL_ROBUST_RGB, 3)};
  }
  std::vector<float> technique(const Sensor& camera, uint32_t index, ups_contribution contribution) const {
    std::vector<float> out(3 * size_t(camera.width) * camera.height);
    check(ups_result_read_technique(result_.get(), camera.id, index, contribution, out.data(), 0,
                                    out.size() * sizeof(float)),
          "ups_result_read_technique");
    for (float v : out) require_finite({v}, "technique image");
    return out;
  }
  // Over all pixels and channels.
  double technique_mean(const Sensor& camera, uint32_t index, ups_contribution contribution) const {
    double sum = 0;
    for (float v : technique(camera, index, contribution)) sum += v;
    return sum / (3.0 * camera.width * camera.height);
  }
  std::vector<ups_technique_info> techniques(const Sensor& camera) const {
    uint32_t count = 0;
    check(ups_result_get_technique_count(result_.get(), camera.id, &count), "ups_result_get_technique_count");
    std::vector<ups_technique_info> all(count);
    for (uint32_t i = 0; i < count; ++i) {
      all[i].struct_size = sizeof all[i];
      check(ups_result_get_technique(result_.get(), camera.id, i, &all[i]), "ups_result_get_technique");
    }
    return all;
  }
  std::vector<float> read(const Sensor& camera, ups_channel channel, size_t components) const {
    std::vector<float> out(components * camera.width * camera.height);
    check(ups_result_read_image(result_.get(), camera.id, channel, out.data(), 0, out.size() * sizeof(float)),
          "ups_result_read_image");
    for (float v : out) require_finite({v}, "image");
    return out;
  }
  std::vector<ups_sample> largest_samples(const Sensor& s) const {
    size_t count = 0;
    check(ups_result_read_largest_samples(result_.get(), s.id, nullptr, 0, &count), "ups_result_read_largest_samples");
    std::vector<ups_sample> all(count);
    check(ups_result_read_largest_samples(result_.get(), s.id, all.data(), count, &count),
          "ups_result_read_largest_samples");
    for (const ups_sample& sample : all) require_finite({sample.value, sample.share}, "largest sample");
    return all;
  }
  std::string text(ups_result_text topic) const {
    size_t needed = 0;
    ups_result_get_text(result_.get(), topic, nullptr, 0, &needed);
    std::string out(needed, '\0');
    if (needed > 0)
      check(ups_result_get_text(result_.get(), topic, out.data(), needed, &needed), "ups_result_get_text");
    return out.c_str();
  }

 private:
  static void require_finite(std::initializer_list<double> values, const char* what) {
    for (double v : values)
      if (!std::isfinite(v)) throw std::runtime_error(std::string("not finite: ") + what);
  }
  std::unique_ptr<ups_result, decltype(&ups_result_destroy)> result_;
};

}  // namespace ups::test
