// See all_outputs.h.
#include "all_outputs.h"

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
  read_curve(result);
}

}  // namespace ups::test
