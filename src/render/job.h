// When and how long: runs iterations until a limit, the target or a cancel, and publishes what there is. Called by api.
#pragma once
#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "base/parallel.h"
#include "base/stop.h"
#include "render/accumulator.h"
#include "render/accuracy.h"
#include "render/memory_estimate.h"
#include "render/method.h"
#include "render/progress.h"
#include "render/reading_time.h"
#include "render/replay.h"
#include "render/tally_queue.h"
#include "transport/glare.h"

namespace ups {

// A finished or intermediate result; immutable.
struct RenderResult {
  ups_result_info info{};
  std::shared_ptr<const Snapshot> scene;   // has the sensors' ids and the goniometers' grids
  std::vector<ups_sensor_choice> choices;  // of cameras, meter sets, goniometers
  std::vector<GoniometerReading> goniometers;
  std::vector<ImageReading> images;
  std::vector<MeterSetReading> meter_sets;
  std::vector<ups_source_info> sources;  // columns of MeterSetReading::separated
  std::vector<std::vector<ups_sample>> largest_samples;  // of cameras, then of meter sets; sensors by their numbers
  std::shared_ptr<const std::vector<SeenGlare>> glare;   // of observers
  Accuracy accuracy;
  std::string warnings, effects, techniques, dropped;
};

class FluxPass;

class RenderJob {
 public:
  // Throws Error for a desc that cannot run. pool_owner keeps the pool alive.
  RenderJob(std::shared_ptr<const Snapshot> scene, const ups_render_desc& desc, std::shared_ptr<ThreadPool> pool);
  ~RenderJob();  // cancels and joins

  // A warning of its results; before start().
  void add_notice(const std::string& text) { notices_ += text + "\n"; }
  // Throws Error where it is clear that too much memory is wanted.
  void start();
  // In place of start(): what it would take; of a pilot that wants more than is allowed, what it wanted at least.
  ups_memory_estimate estimate();
  ups_memory_estimate memory() const;  // the same of a job that was started; throws INVALID_STATE while it prepares
  void cancel() { stop_.cancel(); }
  ups_progress progress() const;  // waits for nothing, as cancel()
  Accuracy accuracy() const;      // neither
  // OK, TIMEOUT, CANCELLED or the job's error; message gets the error's text.
  ups_status wait(uint32_t timeout_ms, std::string& message) const;
  // Throws INVALID_STATE before the first whole iteration. Others go on meanwhile, but for who wants a result too.
  std::shared_ptr<const RenderResult> result() const;
  // Instead of start(), within the same memory: one sample of the render again. sensor: its number.
  PathReplay replay(const ups_sample& sample);

 private:
  using Clock = StopSignal::Clock;
  void run();
  void iterate();
  std::pair<Plan, MemoryEstimate> plan_least();
  void allow_memory();
  void take_threads(ups_priority priority);
  void make_integrator();
  void take_memory();
  void prepare();
  void set_deadline(double share_of_tolerance, double reserved_s);
  void trace_flux(FluxPass& flux, WorkCounts& counts);
  void tell_flux(const FluxPass& flux);
  void tell_reading_time(double look_s);
  void deliver(TallyQueue::Delivery& delivery);
  bool is_at_end(double reserved_s) const;
  double elapsed() const { return std::chrono::duration<double>(Clock::now() - start_).count(); }
  // With the sums held.
  void add(const TallyQueue::Delivery& delivery);
  bool is_look_due() const;
  bool is_last_look_wanted() const;
  void try_to_look();
  void look_at_error();
  std::shared_ptr<const RenderResult> read() const;
  const WorkCounts& books() const;
  ups_result_info read_info() const;
  void add_warnings(RenderResult& result) const;

  std::shared_ptr<const Snapshot> scene_;
  ups_render_desc desc_;
  std::shared_ptr<ThreadPool> pool_;
  std::string notices_;
  MethodChoice method_;
  AllowedMemory allowed_;
  MemoryBudget memory_;  // of light paths
  std::atomic<bool> is_read_meanwhile_{true};  // memory allows it
  std::unique_ptr<Integrator> integrator_;
  std::shared_ptr<const std::vector<SeenGlare>> glare_;  // made before the sums are
  StopSignal stop_;
  ReadingTime expected_;
  // What the next look at the error will take, about: a guess until there was one. Of the time limit, kept for reading
  // what was found. Looks of any thread write them.
  std::atomic<double> look_s_ = 0, reading_s_ = 0;
  bool has_looked_ = false;
  const Clock::time_point start_ = Clock::now();
  std::thread thread_;

  mutable TallyQueue queue_;  // of what the next ones sum up
  std::unique_ptr<Accumulator> sums_;
  WorkCounts flux_;
  bool books_flux_ = false;  // the render's own light paths do
  double iterated_s_ = 0, sums_elapsed_ = 0;  // when the last iteration came, and the last of all that is in them

  mutable std::mutex mutex_;  // guards all below; never held for long
  mutable std::condition_variable changed_;
  ups_job_state state_ = UPS_JOB_RUNNING;
  ups_status error_ = UPS_OK;
  std::string error_message_;
  uint32_t iterations_ = 0;  // traced; the sums may not have the last ones yet
  double elapsed_ = 0;   // when an iteration, or books of flux, were delivered last
  double ended_s_ = 0;   // when the job was over
  float worst_ = -1, median_ = -1;  // relative errors
  std::optional<ups_memory_estimate> estimated_;
  Accuracy accuracy_;               // but for its times
  std::optional<ProgressEstimate> estimate_;  // none before the first iteration begins
};

}  // namespace ups
