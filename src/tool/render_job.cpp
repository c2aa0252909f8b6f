// See render_job.h: waits in short steps, so that the bar moves and Ctrl-C is seen.
#include "tool/render_job.h"

#include <cstdio>
#include <string_view>
#include <utility>

#include "tool/accuracy.h"
#include "tool/interrupt.h"
#include "tool/progress.h"

namespace ups::tool {

namespace {

constexpr uint32_t poll_interval_ms = 100;
constexpr double default_target_error = 0.02, default_time_s = 60;
constexpr uint32_t flux_paths = 65536;  // the report tells absorbed and escaped flux whatever the method

// What the core's messages have, and what the command line has for it.
constexpr std::pair<std::string_view, std::string_view> option_words[] = {
    {"time_limit_s", "--time"},
    {"iteration_count", "--iterations"},
    {"target_relative_error", "--target-error"},
    {"target_criterion", "--target-of"},
    {"memory_limit_bytes", "--memory-limit"},
    {"light_paths_per_iteration", "--light-paths"},
    {"max_path_length", "--max-path-length"},
    {"merge_radius_m", "--merge-radius"},
    {"radius_alpha", "--alpha"},
    {"glossy_alpha", "--glossy-alpha"},
    {"technique_images", "--technique-images"},
    {"techniques: ", "--techniques: "},
    {"0 allows them all", "without it all are"},
    {"perturbation: UPS_PERTURBATION_ACTUAL", "--perturbation: actual"},
    {"set method, ", "set --method, "},
    {"sample: iteration", "--sample: iteration"},
    {"scene and desc", "scene and options"}};

std::string in_options(std::string message) {
  for (const auto& [words, option] : option_words)
    for (size_t at = 0; (at = message.find(words, at)) != std::string::npos; at += option.size())
      message.replace(at, words.size(), option);
  return message;
}

void set_limits(ups_render_desc& desc) {
  if (desc.time_limit_s != 0 || desc.iteration_count != 0 || desc.target_relative_error != 0) return;
  desc.target_relative_error = float(default_target_error);
  desc.time_limit_s = default_time_s;
}

// When the target is reached, without one the next of those that are always told.
std::string foretell(const ups_job* job, double target) {
  if (target > 0) {
    const ups_prediction p = predict(job, target);
    return p.limited_by == UPS_LIMIT_UNKNOWN ? "" : prediction_text(target, p);
  }
  for (const double error : foretold_errors) {
    const ups_prediction p = predict(job, error);
    if (p.limited_by != UPS_LIMIT_UNKNOWN && p.seconds_low != p.seconds_high) return prediction_text(error, p);
  }
  return "";
}

// Waits for the job's end: OK, CANCELLED or OUT_OF_MEMORY, after which there may be results; throws any other error.
ups_status wait_for(ups_job* job, double target) {
  Progress progress;
  bool cancelled = false;
  for (;;) {
    const ups_status status = ups_job_wait(job, poll_interval_ms);
    if (status != UPS_TIMEOUT && status != UPS_CANCELLED) {
      progress.finish();
      if (status != UPS_ERROR_OUT_OF_MEMORY) check(status);
      return status;
    }
    ups_progress state{};
    state.struct_size = sizeof state;
    check(ups_job_poll(job, &state));
    progress.update(state, foretell(job, target));
    if (status == UPS_CANCELLED) {
      progress.finish();
      return status;
    }
    if (interruption() != 0 && !cancelled) {
      ups_job_cancel(job);
      cancelled = true;
    }
  }
}

}  // namespace

void check_options(ups_status status) {
  if (status == UPS_OK) return;
  const std::string message = in_options(without_functions(ups_last_error()));
  if (status == UPS_ERROR_INVALID_ARGUMENT) throw WrongUsage(message);
  throw Failure(message, status);
}

int Finished::exit_code() const { return complete ? exit_done : failure.empty() ? interruption() : exit_failed; }

Finished run_render(const ups_scene* scene, ups_render_desc desc) {
  set_limits(desc);
  desc.flux_paths = flux_paths;
  begin_interruptible_work();
  ups_job* started = nullptr;
  check_options(ups_job_start(scene, &desc, &started));
  const Job job(started);
  const ups_status end = wait_for(job.get(), desc.target_relative_error);
  const std::string failure =
      end == UPS_ERROR_OUT_OF_MEMORY ? in_options(without_functions(ups_last_error())) : std::string();
  ups_memory_estimate memory{};
  memory.struct_size = sizeof memory;
  ups_job_get_memory_estimate(job.get(), &memory);  // 0 where it was interrupted before
  ups_result* taken = nullptr;
  const ups_status status = ups_job_result(job.get(), &taken);
  if (status == UPS_ERROR_INVALID_STATE && !failure.empty()) throw Failure(failure);
  if (end == UPS_OK || status != UPS_ERROR_INVALID_STATE) check_options(status);
  return {Result(taken), end == UPS_OK, desc.target_relative_error, desc.time_limit_s, memory, failure};
}

void tell_interruption(const Finished& finished) {
  if (finished.complete) return;
  if (!finished.result) {
    std::fprintf(stderr, "ups: interrupted before the first iteration: there are no results\n");
    return;
  }
  ups_result_info info{};
  info.struct_size = sizeof info;
  check(ups_result_get_info(finished.result.get(), &info));
  std::fprintf(stderr, "ups: %s; the results are those of %u iterations\n",
               finished.failure.empty() ? "interrupted" : finished.failure.c_str(), info.iterations);
}

}  // namespace ups::tool
