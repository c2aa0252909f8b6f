// What a render found, as numbers to print: gathered once, printed as JSON or for people. Called by the render command.
#pragma once
#include <string>
#include <vector>

#include "tool/accuracy.h"
#include "tool/handles.h"
#include "tool/meter_report.h"
#include "tool/sample_address.h"
#include "tool/targets.h"

namespace ups::tool {

struct ChoiceReport {
  std::string name;  // of a camera, a set of meters or an observer
  ups_sensor_choice choice;
  std::vector<std::string> techniques;
};

struct CameraReport {
  std::string name;
  uint32_t width, height;
  double mean_luminance_cd_m2;
};

struct GoniometerReport {
  std::string name;
  ups_goniometer_info info;
};

struct GlareSourceReport {
  std::string name;  // of its node
  ups_glare_source source;
};

struct ObserverReport {
  std::string name;
  ups_observer_reading reading;
  std::vector<GlareSourceReport> sources;
};

struct SourceReport {
  std::string name;  // of its node, or "group_3"
  double flux_lm;
};

struct Report {
  std::string scene;
  ups_result_info info;
  std::vector<std::string> techniques, effects, warnings;
  std::vector<ChoiceReport> choices;
  std::vector<MeterReport> meters;
  std::vector<RatioReport> ratios;
  std::vector<CameraReport> cameras;
  std::vector<GoniometerReport> goniometers;
  std::vector<ObserverReport> observers;
  std::vector<SourceReport> sources;  // empty without --separate
  std::vector<ups_curve_point> convergence;
  std::vector<PredictionReport> predictions;
  std::optional<WorstMeter> worst_meter;
  std::vector<std::string> advice;
  std::vector<SampleReport> largest_samples;
  ups_memory_estimate memory{};
  double target_error = 0;  // that the render was to stop at; 0: none
  std::vector<TargetVerdict> targets;
  std::vector<std::string> area_names;  // of the targets' areas
};

Report make_report(const std::string& scene_path, const LoadedScene& scene, const ups_result* result,
                   const MeterQuestions& questions = {});
std::string version_number();  // "0.1.0"
std::string percent_text(double fraction);  // "1.25 %"; "unknown" below 0
std::string method_word(ups_method method);  // as in --method
std::string technique_name(uint32_t bit);         // the other way round
uint32_t technique_bit(const std::string& name);  // UPS_TECHNIQUE_* of "merge" and the like; 0: there is none

std::string to_text(const Report& report);
std::string to_json(const Report& report);

// A sample traced again.
struct PathReport {
  std::string scene, address;
  ups_path_info info;
  std::vector<ups_path_vertex> vertices;
  std::vector<ups_path_contribution> contributions;
  std::string text;
};
std::string to_json(const PathReport& report);

// Means over all pixels and channels of squared differences and of squared standard errors; -1: not known. trimmed: of
// the pixels without the thousandth that differs most. relative: each pixel divided as for relative_mse.
struct ChannelErrors {
  double mse, relative_mse, trimmed_mse;
  double noise_a, noise_b, relative_noise_b, trimmed_noise_b;
};

struct Comparison {
  double rmse, relative_mse, mean_a, mean_b;
  uint32_t worst_x, worst_y;
  ChannelErrors channels;
};
std::string to_json(const Comparison& comparison);

}  // namespace ups::tool
