// See all_outputs.h.
#include "all_outputs.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "../support/meter_response.h"

namespace ups::test {

namespace {

constexpr uint32_t all_layers = UPS_LAYER_ALBEDO | UPS_LAYER_NORMAL | UPS_LAYER_DEPTH | UPS_LAYER_ID;

void require_finite(std::initializer_list<double> values, const char* what) {
  for (const double v : values)
    if (!std::isfinite(v)) throw std::runtime_error(std::string("not finite: ") + what);
}

void read_camera(const Result& result, const Sensor& camera) {
  for (const ups_channel channel : {UPS_CHANNEL_PATH_INTEGRATION_RGB, UPS_CHANNEL_DENSITY_ESTIMATION_RGB,
                                    UPS_CHANNEL_ALBEDO_RGB, UPS_CHANNEL_NORMAL})
    result.read(camera, channel, 3);
  for (const ups_channel channel : {UPS_CHANNEL_DEPTH, UPS_CHANNEL_ID}) result.read(camera, channel, 1);
  for (uint32_t i = 0; i < result.techniques(camera).size(); ++i)
    for (const ups_contribution contribution : {UPS_CONTRIBUTION_WEIGHTED, UPS_CONTRIBUTION_UNWEIGHTED})
      result.technique(camera, i, contribution);
}

void read_curve(const Result& result) {
  uint32_t count = 0;
  check(ups_result_get_curve_count(result.get(), &count), "ups_result_get_curve_count");
  for (uint32_t i = 0; i < count; ++i) {
    ups_curve_point c{};
    c.struct_size = sizeof c;
    check(ups_result_get_curve_point(result.get(), i, &c), "ups_result_get_curve_point");
    require_finite({c.elapsed_s, c.median_relative_error, c.p95_relative_error, c.worst_relative_error,
                    c.mean_relative_error, c.bias_share}, "curve");
  }
  size_t needed = 0;
  check(ups_result_read_convergence(result.get(), nullptr, 0, &needed), "ups_result_read_convergence");
  std::vector<ups_convergence_point> points(needed);
  check(ups_result_read_convergence(result.get(), points.data(), needed, &needed), "ups_result_read_convergence");
  for (const auto& c : points)
    require_finite({c.elapsed_s, c.median_relative_error, c.p95_relative_error, c.worst_relative_error, c.bias_share},
                   "convergence");
  for (const double error : {0.05, 0.001}) {
    ups_prediction p{};
    p.struct_size = sizeof p;
    check(ups_result_get_prediction(result.get(), error, &p), "ups_result_get_prediction");
    require_finite({p.seconds, p.seconds_low, p.seconds_high, p.iterations}, "prediction");
  }
  ups_largest_error e{};
  e.struct_size = sizeof e;
  const ups_status status = ups_result_get_largest_error(result.get(), &e);
  if (status != UPS_ERROR_INVALID_STATE) check(status, "ups_result_get_largest_error");  // none is known
  require_finite({e.relative_error}, "largest error");
}

void read_statistics(const Result& result, const Sensor& set, const Sensor& other) {
  const auto read = [](ups_status status, const ups_interval& i, const char* what) {
    check(status, what);
    require_finite({i.value, i.low, i.high}, what);
  };
  ups_interval i{};
  for (const double share : {0.0, 0.5, 1.0})
    read(ups_result_get_meter_percentile(result.get(), set.id, share, &i), i, "ups_result_get_meter_percentile");
  for (const double lx : {0.0, 1e-6, 500.0})
    read(ups_result_get_meter_share(result.get(), set.id, lx, &i), i, "ups_result_get_meter_share");
  for (const auto& [a, b] : {std::pair{set, other}, std::pair{other, set}})
    read(ups_result_get_meter_ratio(result.get(), a.id, b.id, &i), i, "ups_result_get_meter_ratio");
  std::vector<ups_interval> by_meter(other.count);
  check(ups_result_read_meter_ratios(result.get(), other.id, other.id, by_meter.data(), by_meter.size()),
        "ups_result_read_meter_ratios");
  for (const ups_interval& ratio : by_meter) require_finite({ratio.value, ratio.low, ratio.high}, "ratio");
}

// Its angles, and the photometric files of its profile, where any light leaves the scene.
void read_goniometer(const Result& result, const Sensor& goniometer) {
  double most = 0;
  for (const ups_intensity_reading& r : result.intensities(goniometer)) most = std::max(most, double(r.intensity_cd));
  for (const float fraction : {0.1f, 0.5f}) result.goniometer_beam(goniometer, 0, fraction);
  if (!(most > 0)) return;
  const auto profile = result.goniometer_profile(goniometer);
  for (const ups_profile_format format : {UPS_PROFILE_IES_LM63, UPS_PROFILE_EULUMDAT}) {
    size_t needed = 0;
    check(ups_profile_write(profile.get(), format, nullptr, 0, &needed), "ups_profile_write");
    std::string file(needed, 0);
    check(ups_profile_write(profile.get(), format, file.data(), file.size(), &needed), "ups_profile_write");
    for (const char* word : {"nan", "inf", "NaN", "Inf"})
      if (file.find(word) != std::string::npos) throw std::runtime_error("not finite: a photometric file");
  }
}

}  // namespace

void read_all_outputs(Scene& scene, const Sensor& meters, RenderOptions options) {
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  const ups_meter_place place = scene.places(meters).at(0);
  const P3 p{place.position_m[0], place.position_m[1], place.position_m[2]},
      n{double(place.normal[0]), double(place.normal[1]), double(place.normal[2])},
      level = std::abs(n.z) < 0.99 ? P3{n.x, n.y, 0} : P3{1, 0, 0};
  const Sensor camera = scene.add_camera(p, n, 8, 8, 1.5, true, UPS_PERSPECTIVE, all_layers);
  const Sensor eye = scene.add_observer(p, level);
  std::vector<Sensor> sets;
  for (const ups_meter_kind kind : all_kinds) {
    scene.set_meter_kind(kind);
    sets.push_back(scene.add_meters({p}, normalize(level)));
  }
  scene.set_meter_kind(UPS_METER_PLANAR);
  const Sensor goniometer = scene.add_goniometer(4, 19);
  options.technique_images = 4;
  const Result result = scene.render(options);
  for (size_t k = 0; k < sets.size(); ++k) {
    if (all_kinds[k] != UPS_METER_VECTOR) continue;
    result.vectors(sets[k]);
    for (const ups_light_part part : {UPS_LIGHT_PART_DIRECT, UPS_LIGHT_PART_INDIRECT}) result.vectors(sets[k], part);
  }
  result.glare_sources(eye, result.open_ended_observer(eye).source_count);
  read_camera(result, camera);
  for (const Sensor& sensor : {camera, sets[0]}) result.largest_samples(sensor);
  read_statistics(result, meters, sets[0]);
  read_goniometer(result, goniometer);
  read_curve(result);
}

}  // namespace ups::test
