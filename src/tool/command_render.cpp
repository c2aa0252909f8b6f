// ups render: loads a scene, renders it as a job that Ctrl-C can stop, prints and writes what it found.
#include <optional>

#include "common/atomic_file.h"
#include "tool/commands.h"
#include "tool/handles.h"
#include "tool/interrupt.h"
#include "tool/output.h"
#include "tool/page.h"
#include "tool/render_job.h"
#include "tool/report.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

void take_verdicts(const Targets& targets, Report& report) {
  report.targets = judge(targets, report);
  for (const TargetArea& area : targets.areas) report.area_names.push_back(area.name);
}

}  // namespace

int render(const RenderOptions& options) {
  install_interrupt_handler();
  if (!options.out.empty()) prepare_folder(options.out);
  std::optional<Targets> targets;
  if (!options.targets.empty()) targets = read_targets(options.targets);
  const LoadedScene scene =
      load_scene(options.scene, {options.threads, options.width, options.height, options.allow_outside});
  if (scene.sensors.empty()) {
    throw Failure(options.scene + ": there is nothing to render; add a camera, or meters in a node's extras.ups");
  }
  if (targets) check_names(*targets, scene);
  const Finished finished = run_render(scene.scene.get(), options.desc);
  tell_interruption(finished);
  if (!finished.result) return exit_interrupted;
  Report report = make_report(options.scene, scene, finished.result.get(), options.questions);
  report.memory = finished.memory;
  const std::string advice =
      finished.target > 0 ? advice_text(finished.target, finished.time_limit_s,
                                        predict(finished.result.get(), finished.target), report.worst_meter)
                          : "";
  if (!advice.empty()) report.advice.push_back(advice);
  report.target_error = finished.target;
  if (targets) take_verdicts(*targets, report);
  Written written;
  if (!options.out.empty()) written = write_outputs(options.out, scene, finished.result.get(), options.map);
  append_once(report.warnings, written.warnings);
  if (options.report)
    attempt(written, options.out + "/report.html", [&](const std::string& path) {
      const std::string page = report_page({scene, finished.result.get(), report, targets ? &*targets : nullptr,
                                            options.map, options.out, command_text(options.arguments, report.info), date_text()});
      extras::write_file(path, page.data(), page.size());
    });
  put(stdout, options.json ? to_json(report) : to_text(report));
  for (const std::string& error : written.errors) put_error(error);
  return written.errors.empty() ? finished.exit_code() : exit_failed;
}

}  // namespace ups::tool
