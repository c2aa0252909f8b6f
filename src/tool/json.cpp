// Reports as JSON, the program's contract with scripts. The only file of the program that includes nlohmann/json.
#include <cmath>
#include <nlohmann/json.hpp>

#include "tool/report.h"

namespace ups::tool {

namespace {

using nlohmann::ordered_json;

// JSON has no NaN: a number that is not known is -1.
double number(double value) { return std::isfinite(value) ? value : -1; }

std::string dump(const ordered_json& json) {
  return json.dump(2, ' ', false, ordered_json::error_handler_t::replace) + "\n";
}

}  // namespace

std::string to_json(const Report& report) {
  const ups_result_info& info = report.info;
  ordered_json meters = ordered_json::object(), cameras = ordered_json::object(), convergence = ordered_json::array();
  for (const MeterReport& set : report.meters) {
    const ups_meter_statistics& s = set.statistics;
    meters[set.name] = {{"mean_lx", number(s.mean_lx)},
                        {"min_lx", number(s.min_lx)},
                        {"max_lx", number(s.max_lx)},
                        {"uniformity", number(s.uniformity)},
                        {"mean_standard_error_lx", number(s.mean_standard_error_lx)},
                        {"worst_relative_error_bound", number(s.worst_relative_error_bound)}};
  }
  for (const CameraReport& camera : report.cameras) {
    cameras[camera.name] = {{"width", camera.width},
                            {"height", camera.height},
                            {"mean_luminance_cd_m2", number(camera.mean_luminance_cd_m2)}};
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
  for (const ups_convergence_point& point : report.convergence) {
    convergence.push_back({{"time_s", number(point.elapsed_s)},
                           {"iterations", point.iterations},
                           {"median_relative_error", number(point.median_relative_error)},
                           {"p95_relative_error", number(point.p95_relative_error)},
                           {"worst_relative_error", number(point.worst_relative_error)}});
  }
  ordered_json all = {{"scene", report.scene},
               {"method", method_word(info.method)},
               {"techniques", report.techniques},
               {"effects", report.effects},
               {"iterations", info.iterations},
               {"time_s", number(info.elapsed_s)},
               {"threads", info.threads},
               {"seed", info.seed},
               {"flux",
                {{"emitted_lm", number(info.emitted_flux_lm)},
                 {"absorbed_lm", number(info.absorbed_flux_lm)},
                 {"escaped_lm", number(info.escaped_flux_lm)}}},
               {"dropped_samples", info.dropped_samples},
               {"work",
                {{"rays", info.rays},
                 {"eye_paths", info.eye_paths},
                 {"light_paths", info.light_paths},
                 {"connections", info.connections},
                 {"merges", info.merges}}},
               {"meters", meters},
               {"cameras", cameras},
               {"convergence", convergence},
               {"warnings", report.warnings}};
  if (!report.goniometers.empty()) all["goniometers"] = goniometers;
  if (!report.sources.empty()) all["sources"] = sources;
  return dump(all);
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

}  // namespace ups::tool
