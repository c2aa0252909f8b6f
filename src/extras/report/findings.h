// What a render found, as numbers to print: gathered once, put onto the page, or printed by the program.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "report/accuracy.h"
#include "report/meter_report.h"
#include "report/targets.h"

namespace ups::report {

struct ChoiceReport {
  std::string name;  // of a camera, a set of meters or an observer
  ups_sensor_choice choice;
  std::vector<std::string> techniques;
};

struct CameraReport {
  size_t sensor;  // its place among the scene's
  std::string name;
  uint32_t width, height;
  ups_projection projection;
  double mean_luminance_cd_m2;  // of a fisheye: over its image circle
  struct Picture {
    double ev100;
    bool given, smoothed;
    bool told = true;  // that is, its exposure
  };
  std::optional<Picture> picture;
};

struct GoniometerReport {
  std::string name;
  ups_goniometer_info info;
};

struct GlareSourceReport {
  std::string name;
  ups_glare_source source;
};

struct ObserverReport {
  std::string name;
  ups_observer_reading reading;
  std::vector<GlareSourceReport> sources;
};

// What a render that tells sources apart has of each; empty of others.
struct SourceEntry {
  ups_source_info info;
  std::string name;  // or "group_1"
};
std::vector<SourceEntry> sources_of(const LitScene& scene, const ups_result* result);

struct SourceReport {
  std::string name;  // or "group_3"
  double flux_lm;
};

struct Report {
  std::string scene;  // its file, or what else people know it by; may be empty
  ups_result_info info;
  std::vector<std::string> techniques, effects, warnings;
  std::vector<ChoiceReport> choices;
  std::vector<MeterReport> meters;
  std::vector<RatioReport> ratios;
  std::vector<CameraReport> cameras;
  std::vector<GoniometerReport> goniometers;
  std::vector<ObserverReport> observers;
  std::vector<SourceReport> sources;  // empty where they were not told apart
  std::vector<ups_curve_point> convergence;
  std::vector<PredictionReport> predictions;
  std::optional<WorstMeter> worst_meter;
  std::vector<std::string> advice;
  double target_error = 0;  // that the render was to stop at; 0: none
  std::vector<TargetVerdict> targets;
  std::vector<std::string> area_names;  // of the targets' areas
};

Report make_report(const std::string& scene_name, const LitScene& scene, const ups_result* result,
                   const MeterQuestions& questions = {});
// Of the targets; the page and the program tell of it.
void take_verdicts(const Targets& targets, Report& report);
std::string technique_name(uint32_t bit);         // "merge" and the like
uint32_t technique_bit(const std::string& name);  // the other way round, UPS_TECHNIQUE_*; 0: there is none
std::string method_word(ups_method method);
// RGB channels: 3 floats a pixel; others: 1. Row 0 at the top.
std::vector<float> read_image(const ups_result* result, const SensorEntry& camera, ups_channel channel);

}  // namespace ups::report
