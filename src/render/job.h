// When and how long: runs iterations until a limit, the target or a cancel, and publishes what there is. Called by api.
#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/parallel.h"
#include "render/accumulator.h"
#include "render/method.h"

namespace ups {

// A finished or intermediate result; immutable.
struct RenderResult {
  ups_result_info info{};
  std::vector<uint32_t> camera_ids, meter_set_ids, goniometer_ids;
  std::vector<GoniometerReading> goniometers;
  std::shared_ptr<const Snapshot> scene;  // has the goniometers' grids
  std::vector<ImageReading> images;
  std::vector<MeterSetReading> meter_sets;
  std::vector<ups_source_info> sources;  // columns of MeterSetReading::separated
  std::vector<ups_convergence_point> convergence;
  std::string warnings, effects, techniques, dropped;
};

class RenderJob {
 public:
  // Throws Error for a desc that cannot run. pool_owner keeps the pool alive.
  RenderJob(std::shared_ptr<const Snapshot> scene, const ups_render_desc& desc, std::shared_ptr<ThreadPool> pool);
  ~RenderJob();  // cancels and joins

  void start();
  void cancel() { stop_.store(true); }
  ups_progress progress() const;
  // OK, TIMEOUT, CANCELLED or the job's error; message gets the error's text.
  ups_status wait(uint32_t timeout_ms, std::string& message) const;
  // Throws INVALID_STATE before the first whole iteration.
  std::shared_ptr<const RenderResult> result() const;

 private:
  void run();
  void iterate();
  bool at_end(double elapsed) const;
  void check_error(double elapsed);
  void count_flux();
  void add_warnings(RenderResult& result) const;

  std::shared_ptr<const Snapshot> scene_;
  ups_render_desc desc_;
  std::shared_ptr<ThreadPool> pool_;
  MethodChoice method_;
  std::unique_ptr<Integrator> integrator_;
  std::atomic<bool> stop_{false};
  std::chrono::steady_clock::time_point start_{};
  std::thread thread_;

  mutable std::mutex mutex_;  // guards all below
  mutable std::condition_variable changed_;
  std::unique_ptr<Accumulator> sums_;
  ups_job_state state_ = UPS_JOB_RUNNING;
  ups_status error_ = UPS_OK;
  std::string error_message_;
  double elapsed_ = 0;
  ErrorSummary last_error_;
  uint32_t next_check_ = batch_count, passes_below_target_ = 0;
  std::vector<ups_convergence_point> convergence_;
  double absorbed_lm_ = -1, escaped_lm_ = -1;
};

}  // namespace ups
