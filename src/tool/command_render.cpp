// ups render: loads a scene, renders it as a job that Ctrl-C can stop, prints and writes what it found.
#include <cstdio>

#include "tool/commands.h"
#include "tool/handles.h"
#include "tool/interrupt.h"
#include "tool/output.h"
#include "tool/progress.h"
#include "tool/report.h"

namespace ups::tool {

namespace {

constexpr uint32_t poll_interval_ms = 100;
constexpr double default_target_error = 0.02, default_time_s = 60;

ups_render_desc with_limits(ups_render_desc desc) {
  if (desc.time_limit_s == 0 && desc.iteration_count == 0 && desc.target_relative_error == 0) {
    desc.target_relative_error = float(default_target_error);
    desc.time_limit_s = default_time_s;
  }
  return desc;
}

// Waits for the job's end. False where it was interrupted.
bool wait_for(ups_job* job) {
  Progress progress;
  bool cancelled = false;
  for (;;) {
    const ups_status status = ups_job_wait(job, poll_interval_ms);
    if (status != UPS_TIMEOUT && status != UPS_CANCELLED) {
      progress.finish();
      check(status);
      return true;
    }
    ups_progress state{};
    state.struct_size = sizeof state;
    check(ups_job_poll(job, &state));
    progress.update(state);
    if (status == UPS_CANCELLED) {
      progress.finish();
      return false;
    }
    if (interrupted() && !cancelled) {
      ups_job_cancel(job);
      cancelled = true;
    }
  }
}

}  // namespace

int render(const RenderOptions& options) {
  install_interrupt_handler();
  if (!options.out.empty()) prepare_folder(options.out);
  const LoadedScene scene = load_scene(options.scene, options.threads, options.width, options.height);
  if (scene.sensors.empty()) {
    throw Failure(options.scene + ": there is nothing to render; add a camera, or meters in a node's extras.ups");
  }
  const ups_render_desc desc = with_limits(options.desc);
  begin_interruptible_work();
  ups_job* started = nullptr;
  check(ups_job_start(scene.scene.get(), &desc, &started));
  const Job job(started);
  const bool complete = wait_for(job.get());

  ups_result* taken = nullptr;
  const ups_status status = ups_job_result(job.get(), &taken);
  if (!complete && status == UPS_ERROR_INVALID_STATE) {
    std::fprintf(stderr, "ups: interrupted before the first iteration: there are no results\n");
    return exit_interrupted;
  }
  check(status);
  const Result result(taken);
  Report report = make_report(options.scene, scene, result.get());
  Written written;
  if (!options.out.empty()) written = write_outputs(options.out, scene, result.get());
  report.warnings.insert(report.warnings.end(), written.warnings.begin(), written.warnings.end());
  std::fputs((options.json ? to_json(report) : to_text(report)).c_str(), stdout);
  for (const std::string& error : written.errors) std::fprintf(stderr, "ups: error: %s\n", error.c_str());
  if (!complete) {
    std::fprintf(stderr, "ups: interrupted; the results are those of %u iterations\n", report.info.iterations);
  }
  if (!written.errors.empty()) return exit_failed;
  return complete ? exit_done : exit_interrupted;
}

}  // namespace ups::tool
