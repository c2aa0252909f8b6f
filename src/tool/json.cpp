// Reports as JSON, the program's contract with scripts.
#include <cmath>

#include "platform/memory.h"
#include "tool/goniometer_report.h"
#include "tool/info_report.h"
#include "tool/json_values.h"
#include "tool/text_format.h"

namespace ups::tool {

namespace {

std::string dump(const ordered_json& json) {
  return printable_json(json.dump(2, ' ', false, ordered_json::error_handler_t::replace)) + "\n";
}

// Before the first look at the error nothing is known but that more samples are wanted.
ordered_json predictions_json(const std::vector<PredictionReport>& predictions) {
  ordered_json all = ordered_json::array();
  for (const double error : foretold_errors)
    if (predictions.empty())
      all.push_back({{"relative_error", error}, {"seconds", -1}, {"low", -1}, {"high", -1}, {"limited_by", "noise"}});
  for (const PredictionReport& p : predictions)
    all.push_back({{"relative_error", number(p.relative_error)},
                   {"seconds", number(p.prediction.seconds)},
                   {"low", number(p.prediction.seconds_low)},
                   {"high", number(p.prediction.seconds_high)},
                   {"limited_by", p.prediction.limited_by == UPS_LIMIT_BIAS ? "bias" : "noise"}});
  return all;
}

ordered_json worst_meter_json(const WorstMeter& worst) {
  const ups_largest_error& e = worst.error;
  return {{"meters", worst.set},
          {"index", e.index},
          {"position_m", {number(e.position_m[0]), number(e.position_m[1]), number(e.position_m[2])}},
          {"relative_error", number(e.relative_error)},
          {"bias_share", number(e.bias_share)}};
}

// What was foretold, and the most that the program had resident, writing of files not yet among it.
ordered_json memory_json(const ups_memory_estimate& m) {
  return {{"scene_bytes", m.scene_bytes},   {"working_bytes", m.working_bytes}, {"light_bytes", m.light_bytes},
          {"result_bytes", m.result_bytes}, {"peak_bytes", m.peak_bytes},       {"allowed_bytes", m.allowed_bytes},
          {"resident_bytes", platform::peak_resident_bytes()}};
}

ordered_json samples_json(const std::vector<SampleReport>& samples) {
  ordered_json all = ordered_json::array();
  for (const SampleReport& s : samples)
    all.push_back({{"address", s.address},
                   {"sensor", s.sensor},
                   {"index", s.sample.index},
                   {"value", number(double(s.sample.value))},
                   {"share", number(double(s.sample.share))}});
  return all;
}

ordered_json targets_json(const Report& report) {
  ordered_json all = ordered_json::array();
  for (const TargetVerdict& v : report.targets)
    all.push_back({{"area", report.area_names[v.area]},
                   {v.quantity == "ugr" ? "observer" : "meters", v.subject},
                   {"quantity", v.quantity},
                   {"required", number(v.required)},
                   {"value", number(v.value)},
                   {"low", number(v.low)},
                   {"high", number(v.high)},
                   {"verdict", judgement_word(v.judgement)}});
  return all;
}

ordered_json observer_json(const ObserverReport& observer) {
  const ups_observer_reading& r = observer.reading;
  ordered_json sources = ordered_json::array();
  for (const auto& [name, s] : observer.sources)
    sources.push_back({{"source", name},
                       {"share", number(s.share)},
                       {"luminance_cd_m2", number(s.luminance_cd_m2)},
                       {"solid_angle_sr", number(s.solid_angle_sr)},
                       {"intensity_cd", number(s.intensity_cd)},
                       {"distance_m", number(s.distance_m)},
                       {"visible_share", number(s.visible_share)},
                       {"position_index", number(s.position_index)},
                       {"small", (s.flags & UPS_GLARE_FLAG_SMALL) != 0},
                       {"large", (s.flags & UPS_GLARE_FLAG_LARGE) != 0}});
  const bool rated = !(r.flags & (UPS_OBSERVER_NO_SOURCE | UPS_OBSERVER_NO_BACKGROUND));
  ordered_json all = {{"ugr", number(r.ugr)},
                      {"ugr_standard_error", number(r.ugr_standard_error)},
                      {"ugr_low", number(r.ugr_low)},
                      {"ugr_high", std::isinf(r.ugr_high) ? ordered_json() : ordered_json(number(r.ugr_high))},
                      {"background_cd_m2", number(r.background_cd_m2)},
                      {"background_standard_error_cd_m2", number(r.background_standard_error_cd_m2)},
                      {"background_error_bound_cd_m2", number(r.background_error_bound_cd_m2)},
                      {"rated", rated},
                      {"sources", sources}};
  if (r.ceiling_coverage > 0)
    all.update({{"ceiling_coverage", number(r.ceiling_coverage)},
                {"ggr", number(r.ggr)},
                {"ggr_low", number(r.ggr_low)},
                {"ggr_high", number(r.ggr_high)}});
  return all;
}

}  // namespace

std::string to_json(const RenderReport& report) {
  const ups_result_info& info = report.info;
  ordered_json cameras = ordered_json::object(), convergence = ordered_json::array();
  for (const CameraReport& camera : report.cameras) {
    cameras[camera.name] = {{"width", camera.width},
                            {"height", camera.height},
                            {"projection", projection_word(camera.projection)},
                            {"mean_luminance_cd_m2", number(camera.mean_luminance_cd_m2)}};
    if (camera.picture)
      cameras[camera.name].update({{"exposure_ev100", number(camera.picture->ev100)},
                                   {"exposure", camera.picture->given ? "given" : "chosen"},
                                   {"smoothed", camera.picture->smoothed}});
  }
  ordered_json goniometers = ordered_json::object(), sources = ordered_json::object();
  for (const GoniometerReport& g : report.goniometers)
    goniometers[g.name] = {{"flux_lm", number(g.info.flux_lm)},
                           {"flux_standard_error_lm", number(g.info.flux_standard_error_lm)},
                           {"outside_flux_lm", number(g.info.outside_flux_lm)},
                           {"light_output_ratio", number(g.info.light_output_ratio)},
                           {"light_output_ratio_standard_error", number(g.info.light_output_ratio_standard_error)},
                           {"median_relative_error_bound", number(g.info.median_relative_error_bound)},
                           {"worst_relative_error_bound", number(g.info.worst_relative_error_bound)}};
  for (const SourceReport& source : report.sources) sources[source.name] = {{"flux_lm", number(source.flux_lm)}};
  ordered_json choices = ordered_json::object();
  constexpr const char* photons[] = {"none", "caustic", "all"};  // UPS_PHOTONS_*
  for (const ChoiceReport& c : report.choices)
    choices[c.name] = {{"techniques", c.techniques},
                       {"light_paths", c.choice.light_paths_per_iteration},
                       {"photons", photons[c.choice.photons]},
                       {"predicted_gain", number(c.choice.predicted_gain)}};
  for (const ups_curve_point& point : report.convergence) {
    convergence.push_back({{"time_s", number(point.elapsed_s)},
                           {"iterations", point.iterations},
                           {"median_relative_error", number(point.median_relative_error)},
                           {"p95_relative_error", number(point.p95_relative_error)},
                           {"worst_relative_error", number(point.worst_relative_error)},
                           {"mean_relative_error", number(point.mean_relative_error)},
                           {"bias_share", number(point.bias_share)},
                           {"rays", point.rays},
                           {"light_paths", point.light_paths},
                           {"eye_paths", point.eye_paths},
                           {"bytes", point.resident_bytes}});
  }
  ordered_json all = {{"scene", report.scene},
               {"method", method_word(info.method)},
               {"techniques", report.techniques},
               {"choice", choices},
               {"effects", report.effects},
               {"iterations", info.iterations},
               {"time_s", number(info.elapsed_s)},
               {"threads", info.threads},
               {"seed", info.seed},
               {"maintenance_factor", number(info.maintenance_factor)},
               {"flux",
                {{"emitted_lm", number(info.emitted_flux_lm)},
                 {"absorbed_lm", number(info.absorbed_flux_lm)},
                 {"escaped_lm", number(info.escaped_flux_lm)},
                 {"balance_standard_error_lm", number(info.flux_balance_standard_error_lm)}}},
               {"dropped_samples", info.dropped_samples},
               {"work",
                {{"rays", info.rays},
                 {"eye_paths", info.eye_paths},
                 {"light_paths", info.light_paths},
                 {"connections", info.connections},
                 {"merges", info.merges}}},
               {"memory", memory_json(report.memory)},
               {"meters", meters_json(report.meters)},
               {"cameras", cameras},
               {"convergence", convergence},
               {"prediction", predictions_json(report.predictions)},
               {"advice", report.advice},
               {"largest_samples", samples_json(report.largest_samples)},
               {"warnings", report.warnings}};
  if (!report.ratios.empty()) all["ratios"] = ratios_json(report.ratios);
  all["observers"] = ordered_json::object();
  for (const ObserverReport& observer : report.observers) all["observers"][observer.name] = observer_json(observer);
  if (!report.goniometers.empty()) all["goniometers"] = goniometers;
  if (!report.targets.empty()) all["targets"] = targets_json(report);
  if (!report.sources.empty()) all["sources"] = sources;
  if (report.worst_meter) all["largest_error"] = worst_meter_json(*report.worst_meter);
  return dump(all);
}

std::string to_json(const PathReport& report) {
  constexpr const char* events[] = {"start", "end", "scattered", "mirrored", "refracted"};  // UPS_EVENT_*
  ordered_json vertices = ordered_json::array(), contributions = ordered_json::array();
  for (const ups_path_vertex& v : report.vertices)
    vertices.push_back({{"walk", v.walk},
                        {"event", events[v.event]},
                        {"position_m", v.position_m},
                        {"normal", v.normal},
                        {"throughput", number(double(v.throughput))},
                        {"pdf", number(double(v.pdf))},
                        {"pdf_reverse", number(double(v.pdf_reverse))},
                        {"survival", number(double(v.survival))}});
  for (const ups_path_contribution& c : report.contributions)
    contributions.push_back({{"value", number(double(c.value))},
                             {"weight", number(double(c.weight))},
                             {"technique", technique_name(c.technique)},
                             {"edges", c.edges},
                             {"light_vertices", c.light_vertices},
                             {"walk", c.walk},
                             {"from_m", c.from_m},
                             {"to_m", c.to_m}});
  return dump({{"scene", report.scene},
               {"sample", report.address},
               {"value", number(report.info.value)},
               {"vertices", vertices},
               {"contributions", contributions},
               {"text", report.text}});
}

std::string to_json(const Comparison& comparison) {
  const ChannelErrors& c = comparison.channels;
  return dump({{"rmse", number(comparison.rmse)},
               {"relative_mse", number(comparison.relative_mse)},
               {"mean_a", number(comparison.mean_a)},
               {"mean_b", number(comparison.mean_b)},
               {"worst_pixel", {comparison.worst_x, comparison.worst_y}},
               {"channels",
                {{"mse", number(c.mse)},
                 {"relative_mse", number(c.relative_mse)},
                 {"trimmed_mse", number(c.trimmed_mse)},
                 {"noise_a", number(c.noise_a)},
                 {"noise_b", number(c.noise_b)},
                 {"relative_noise_b", number(c.relative_noise_b)},
                 {"trimmed_noise_b", number(c.trimmed_noise_b)}}}});
}

namespace {

ordered_json beam_json(const ups_profile_beam& beam) {
  return {{"peak_cd", number(beam.peak_cd)},
          {"peak_deg", number(beam.peak_deg)},
          {"from_deg", number(beam.from_deg)},
          {"to_deg", number(beam.to_deg)},
          {"angle_deg", number(beam.angle_deg)}};
}

ordered_json beams_json(const ups_profile_beam (&beam)[2]) {
  return {{"c0_c180", beam_json(beam[0])}, {"c90_c270", beam_json(beam[1])}};
}

// Measured: with the 95 % interval of each angle.
ordered_json beams_json(const ups_profile_beam (&beam)[2], const ups_goniometer_beam (&measured)[2]) {
  ordered_json json = beams_json(beam);
  int plane = 0;
  for (ordered_json& of_plane : json) {
    const ups_goniometer_beam& b = measured[plane++];
    of_plane.update({{"standard_error_deg", number(b.standard_error_deg)},
                     {"low_deg", number(b.low_deg)},
                     {"high_deg", number(b.high_deg)}});
  }
  return json;
}

// axis: of what has one, a cylinder or a line.
ordered_json opening_json(const ups_profile_info& info) {
  ordered_json opening = {{"shape", shape_word(info.opening_shape)}, {"size_m", array_json(info.opening_m)}};
  if (const char* axis = opening_axis_word(info); *axis) opening["axis"] = axis;
  return opening;
}

ordered_json lamp_sets_json(const ProfileReport& report) {
  ordered_json sets = ordered_json::array();
  for (const LampSetReport& set : report.lamp_sets) {
    sets.push_back({{"count", set.info.count},
                    {"type", set.type},
                    {"flux_lm", number(set.info.flux_lm)},
                    {"input_power_w", number(set.info.input_power_w)},
                    {"colour_temperature_k", number(set.info.colour_temperature_k)},
                    {"colour_rendering_index", number(set.info.colour_rendering_index)},
                    {"colour", set.colour},
                    {"colour_rendering", set.rendering},
                    {"chosen", set.info.chosen == 1}});
  }
  return sets;
}

ordered_json profile_json(const ProfileReport& report) {
  const ups_profile_info& info = report.info;
  ordered_json zones = ordered_json::array(), keywords = ordered_json::array(), luminance = ordered_json::array();
  for (size_t i = 0; i < zones_deg.size(); ++i) {
    zones.push_back({{"from_deg", number(zones_deg[i][0])},
                     {"to_deg", number(zones_deg[i][1])},
                     {"flux_lm", number(report.zonal_flux_lm[i])}});
  }
  for (const auto& [name, value] : report.keywords) keywords.push_back({{"name", name}, {"value", value}});
  for (size_t i = 0; report.has_luminance() && i < luminance_c_deg.size(); ++i) {
    luminance.push_back({{"c_deg", number(luminance_c_deg[i])},
                         {"gamma_deg", array_json(luminance_gamma_deg)},
                         {"luminance_cd_m2", array_json(report.luminance_cd_m2[i])}});
  }
  return {{"file", report.file},
          {"kind", "photometry"},
          {"format", report.format},
          {"flux_lm", number(info.flux_lm)},
          {"interpolated_flux_lm", number(info.interpolated_flux_lm)},
          {"down_flux_lm", number(info.down_flux_lm)},
          {"up_flux_lm", number(info.up_flux_lm)},
          {"zonal_flux", zones},
          {"rated_flux_lm", number(info.rated_flux_lm)},
          {"light_output_ratio", number(report.info.light_output_ratio)},
          {"input_power_w", number(info.input_power_w)},
          {"efficacy_lm_per_w", number(report.efficacy_lm_per_w())},
          {"peak_cd", number(info.peak_cd)},
          {"peak_c_deg", number(info.peak_c_deg)},
          {"peak_gamma_deg", number(info.peak_gamma_deg)},
          {"beam", beams_json(report.beam)},
          {"field", beams_json(report.field)},
          {"symmetry", symmetry_word(info.symmetry)},
          {"opening", opening_json(info)},
          {"luminance", luminance},
          {"photometric_type", info.photometric_type == UPS_PHOTOMETRIC_A   ? "A"
                               : info.photometric_type == UPS_PHOTOMETRIC_B ? "B"
                                                                            : "C"},
          {"ray_count", info.ray_count},
          {"lamp_set_count", info.lamp_set_count},
          {"lamp_sets", lamp_sets_json(report)},
          {"c_count", info.c_count},
          {"gamma_count", info.gamma_count},
          {"keywords", keywords},
          {"warnings", report.warnings}};
}

const char* layout_word(MeterLayout layout) {
  static constexpr const char* words[] = {"points", "grid", "en12464", "line", "surface", "lightmap"};
  return words[int(layout)];
}

ordered_json scene_json(const SceneReport& report) {
  const ups_scene_info& info = report.info;
  const bool has_geometry = info.bounds_min_m[0] <= info.bounds_max_m[0];
  ordered_json sensors = ordered_json::array();
  for (const SensorEntry& sensor : report.sensors) {
    constexpr const char* kinds[] = {"camera", "meters", "goniometer", "observer"};  // SensorKind
    sensors.push_back({{"name", sensor.name}, {"kind", kinds[int(sensor.info.kind)]}});
    if (sensor.info.kind == SensorKind::camera) {
      sensors.back().update({{"width", sensor.info.width},
                             {"height", sensor.info.height},
                             {"projection", projection_word(sensor.info.projection)}});
    } else if (sensor.info.kind != SensorKind::observer) {
      sensors.back().update(
          {{"count", sensor.info.meter_count}, {"columns", sensor.info.columns}, {"rows", sensor.info.rows}});
      if (sensor.info.kind == SensorKind::meters) sensors.back()["layout"] = layout_word(sensor.info.layout);
    }
  }
  return {{"file", report.file},
          {"kind", "scene"},
          {"triangles", info.triangle_count},
          {"bounds_min_m", has_geometry ? array_json(info.bounds_min_m) : ordered_json()},
          {"bounds_max_m", has_geometry ? array_json(info.bounds_max_m) : ordered_json()},
          {"luminaires", info.luminaire_count},
          {"lights", info.light_count},
          {"emitting_instances", info.emissive_instance_count},
          {"emitted_lm", number(info.emitted_flux_lm)},
          {"meters", info.meter_count},
          {"pixels", info.pixel_count},
          {"sensors", sensors},
          {"effects", report.effects},
          {"techniques", report.techniques},
          {"warnings", report.warnings}};
}

}  // namespace

std::string to_json(const Measurement& m) {
  const ups_result_info& render = m.render.info;
  const ups_goniometer_info& info = m.info();
  const ups_profile_info& profile = m.profile.info;
  return dump({{"scene", m.render.scene},
               {"goniometer", m.render.goniometers[0].name},
               {"method", method_word(render.method)},
               {"iterations", render.iterations},
               {"time_s", number(render.elapsed_s)},
               {"threads", render.threads},
               {"seed", render.seed},
               {"grid",
                {{"c_count", info.c_count},
                 {"gamma_count", info.gamma_count},
                 {"symmetry", symmetry_word(profile.symmetry)}}},
               {"flux",
                {{"emitted_lm", number(info.emitted_flux_lm)},
                 {"absorbed_lm", number(info.absorbed_flux_lm)},
                 {"out_lm", number(info.flux_lm)},
                 {"out_standard_error_lm", number(info.flux_standard_error_lm)},
                 {"outside_gamma_lm", number(info.outside_flux_lm)},
                 {"interpolated_lm", number(profile.interpolated_flux_lm)},
                 {"band_rule_lm", number(profile.flux_lm)},
                 {"residual_lm", number(m.residual_lm())},
                 {"balance_standard_error_lm", number(render.flux_balance_standard_error_lm)}}},
               {"light_output_ratio", number(info.light_output_ratio)},
               {"light_output_ratio_standard_error", number(info.light_output_ratio_standard_error)},
               {"peak",
                {{"intensity_cd", number(m.peak.intensity_cd)},
                 {"standard_error_cd", number(m.peak.standard_error_cd)},
                 {"error_bound_cd", number(m.peak.error_bound_cd)},
                 {"low_cd", number(m.peak_interval.low)},
                 {"high_cd", number(m.peak_interval.high)},
                 {"c_deg", number(profile.peak_c_deg)},
                 {"gamma_deg", number(profile.peak_gamma_deg)}}},
               {"beam", beams_json(m.profile.beam, m.beam)},
               {"field", beams_json(m.profile.field, m.field)},
               {"errors",
                {{"median_relative_error_bound", number(info.median_relative_error_bound)},
                 {"worst_relative_error_bound", number(info.worst_relative_error_bound)},
                 {"worst_c_deg", number(m.worst.c_deg)},
                 {"worst_gamma_deg", number(m.worst.gamma_deg)},
                 {"worst_relative_blur", number(m.worst.relative_blur)}}},
               {"dropped_samples", render.dropped_samples},
               {"warnings", m.render.warnings}});
}

std::string to_json(const std::vector<InfoEntry>& entries) {
  ordered_json files = ordered_json::array();
  for (const InfoEntry& entry : entries) {
    ordered_json file = entry.profile ? profile_json(*entry.profile)
                        : entry.scene ? scene_json(*entry.scene)
                                      : ordered_json{{"file", entry.file}};
    if (entry.sheet) file["data_sheet"] = sheet_json(*entry.sheet);
    if (!entry.error.empty()) file["error"] = entry.error;
    files.push_back(file);
  }
  return dump({{"files", files}});
}

}  // namespace ups::tool
