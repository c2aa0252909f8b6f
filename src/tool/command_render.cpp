// ups render: loads a scene, renders it as a job that Ctrl-C can stop, prints and writes what it found.
#include <algorithm>
#include <iterator>
#include <optional>

#include "common/atomic_file.h"
#include "platform/files.h"
#include "platform/paths.h"
#include "report/page.h"
#include "tool/accuracy.h"
#include "tool/commands.h"
#include "tool/handles.h"
#include "tool/interrupt.h"
#include "tool/output.h"
#include "tool/page_words.h"
#include "tool/picture.h"
#include "tool/render_job.h"
#include "tool/report.h"
#include "tool/targets_file.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

size_t set_of(const LoadedScene& scene, const std::string& name) {
  std::string names;
  for (size_t i = 0; i < scene.sensors.size(); ++i) {
    const SensorEntry& sensor = scene.sensors[i];
    if (sensor.info.kind != SensorKind::meters) continue;
    if (sensor.name == name) return i;
    names += (names.empty() ? "" : ", ") + sensor.name;
  }
  throw WrongUsage("--ratio: the scene has no meters of the name " + name + "; it has " +
                (names.empty() ? "none" : names));
}

MeterQuestions questions_of(const RenderOptions& options, const LoadedScene& scene) {
  MeterQuestions questions{options.above, {}};
  for (const auto& [numerator, denominator] : options.ratios)
    questions.ratios.emplace_back(set_of(scene, numerator), set_of(scene, denominator));
  return questions;
}

RenderReport report_of(const RenderOptions& options, const LoadedScene& scene, const Finished& finished,
                       const MeterQuestions& questions, const std::optional<Targets>& targets) {
  const ups_result* result = finished.result.get();
  RenderReport report{make_report(options.scene, scene, result, questions), {}, {}, finished.memory};
  report.largest_samples = read_largest_samples(scene, result);
  if (!report.largest_samples.empty())
    report.replay = replay_text(options.arguments, options.scene, report.largest_samples[0].address);
  add_exposures(scene, result, options.picture, report);
  const std::string advice = finished.target > 0
                                 ? advice_text(finished.target, finished.time_limit_s,
                                               predict(result, finished.target), report.worst_meter)
                                 : "";
  if (!advice.empty()) report.advice.push_back(advice);
  report.target_error = finished.target;
  if (targets) take_verdicts(*targets, report);
  return report;
}

// Warnings of what was asked for and has no effect: options of files that nothing writes, of images that nobody takes.
std::vector<std::string> idle_options(const RenderOptions& options, const LoadedScene& scene) {
  std::vector<std::string> idle;
  const auto tell = [&](bool is_asked, const char* option, const char* why) {
    if (is_asked) idle.push_back(std::string(option) + " has no effect: " + why);
  };
  if (options.out.empty()) {
    constexpr const char* no_files = "without --out no file is written";
    tell(options.desc.technique_images > 0, "--technique-images", no_files);
    tell(options.desc.separation != UPS_SEPARATE_NOTHING, "--separate", no_files);
    tell(options.picture.smooth, "--smooth", no_files);
    tell(options.picture.ev100.has_value(), "--exposure", no_files);
    tell(options.map != MapStyle(), "--map-...", no_files);
  }
  const bool has_camera = std::any_of(scene.sensors.begin(), scene.sensors.end(), [](const SensorEntry& s) {
    return s.info.kind == SensorKind::camera;
  });
  tell(options.width > 0 && !has_camera, "--size", "the scene has no camera");
  return idle;
}

// The pictures on it are the files that were written; none where one could not be.
std::string page_of(const RenderOptions& options, const LoadedScene& scene, const ups_result* result,
                    const Report& report, const Targets* targets, const Written& written) {
  const auto picture = [&](size_t sensor) {
    const std::string base = platform::joined(options.out, scene.sensors[sensor].name), path = base + ".png";
    const auto is_it = [&](const std::string& failed) { return failed == path || failed == base; };
    if (std::any_of(written.failed.begin(), written.failed.end(), is_it)) return std::vector<uint8_t>();
    auto file = platform::open_to_read(path);
    return std::vector<uint8_t>{std::istreambuf_iterator<char>(file), {}};
  };
  const std::string title = platform::stem_of(options.scene);
  return report_page({scene, result, report, targets, options.map, title,
                      command_text(options.arguments, report.info), date_text(), picture});
}

}  // namespace

int render(const RenderOptions& options) {
  install_interrupt_handler();
  if (!options.out.empty()) prepare_folder(options.out);
  std::optional<Targets> targets;
  if (!options.targets.empty()) targets = read_targets(options.targets);
  const LoadedScene scene =
      load_scene(options.scene, {options.threads, options.width, options.height, options.allow_outside,
                                 options.picture.smooth ? layers_that_steer_smoothing : 0});
  if (scene.sensors.empty()) {
    throw Failure(options.scene + ": there is nothing to render; add a camera, or meters in a node's extras.ups");
  }
  if (!options.out.empty()) prepare_files(options, scene);
  if (targets) check_names(*targets, scene);
  const MeterQuestions questions = questions_of(options, scene);
  const Finished finished = run_render(scene.scene, options.desc);
  tell_interruption(finished);
  if (!finished.result) return finished.exit_code();
  RenderReport report = report_of(options, scene, finished, questions, targets);
  Written written;
  if (!options.out.empty())
    written = write_outputs(options.out, scene, finished.result.get(), options.map, options.picture);
  append_once(report.warnings, written.warnings);
  append_once(report.warnings, idle_options(options, scene));
  if (options.report)
    attempt(written, options.out + "/report.html", [&](const std::string& path) {
      const std::string page =
          page_of(options, scene, finished.result.get(), report, targets ? &*targets : nullptr, written);
      extras::write_file(path, page.data(), page.size());
    });
  put(stdout, options.json ? to_json(report) : to_text(report));
  for (const std::string& error : written.errors) put_error(error);
  return written.errors.empty() ? finished.exit_code() : exit_failed;
}

}  // namespace ups::tool
