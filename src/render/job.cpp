// See job.h: what is asked for is checked, then the loop over iterations, its limits and progress.
#include "render/job.h"

#include <algorithm>
#include <cmath>
#include <new>

#include "base/error.h"
#include "base/monitor.h"
#include "base/thread.h"
#include "render/flux_pass.h"
#include "render/job_threads.h"
#include "scene/check.h"
#include "scene/scene_bytes.h"

namespace ups {

namespace {

// How far a render may run over its time limit.
double tolerance_s(double limit_s) { return std::max(0.1, 0.05 * limit_s); }

void check_desc(const ups_render_desc& d) {
  const auto check_finite = [](const std::string& name, double value, const char* noun) {
    if (!std::isfinite(value) || value < 0)
      fail_argument(name + ": " + check::text(value) + " is not a finite " + noun + " >= 0");
  };
  check_finite("time_limit_s", d.time_limit_s, "number of seconds");
  check_finite("target_relative_error", d.target_relative_error, "fraction");
  check_finite("merge_radius_m", d.merge_radius_m, "length");
  if (d.light_paths_per_iteration > (1u << 24)) fail_argument("light_paths_per_iteration: at most 16777216");
  if (std::isnan(d.radius_alpha) || d.radius_alpha < 0 || d.radius_alpha >= 1)
    fail_argument("radius_alpha: " + check::text(double(d.radius_alpha)) + " is not between 0 and 1 (0: 2/3)");
  if (std::isnan(d.glossy_alpha) || d.glossy_alpha < 0 || d.glossy_alpha > 1)
    fail_argument("glossy_alpha: " + check::text(double(d.glossy_alpha)) + " is not a GGX alpha between 0 and 1 (0: 0.2)");
  if (d.perturbation != UPS_PERTURBATION_VIRTUAL && d.perturbation != UPS_PERTURBATION_ACTUAL)
    fail_argument("perturbation: " + std::to_string(d.perturbation) + " is not a UPS_PERTURBATION_* value");
  if (d.technique_images > max_technique_edges)
    fail_argument("technique_images: " + std::to_string(d.technique_images) + " edges; at most " +
                  std::to_string(max_technique_edges));
  if (d.separation < UPS_SEPARATE_NOTHING || d.separation > UPS_SEPARATE_GROUPS)
    fail_argument("separation: " + std::to_string(d.separation) + " is not a UPS_SEPARATE_* value");
  if (d.reserved != 0) fail_argument("reserved is " + std::to_string(d.reserved) + "; it must be 0");
  if (d.reserved2 != 0) fail_argument("reserved2 is " + std::to_string(d.reserved2) + "; it must be 0");
  if (d.target_criterion < UPS_CRITERION_DEFAULT || d.target_criterion > UPS_CRITERION_MEDIAN)
    fail_argument("target_criterion: " + std::to_string(d.target_criterion) + " is not a UPS_CRITERION_* value");
  if (d.flux_paths > (1u << 24)) fail_argument("flux_paths: at most 16777216");
  check_priority(d.priority);
  if (d.techniques >= 2 * uint32_t(UPS_TECHNIQUE_MIRROR_SAMPLE))
    fail_argument("techniques: " + std::to_string(d.techniques) + " has bits that are no UPS_TECHNIQUE_*");
  if (d.time_limit_s == 0 && d.target_relative_error == 0 && d.iteration_count == 0)
    fail_argument("nothing would end this render: set time_limit_s, target_relative_error or iteration_count");
}

// Where light paths want more than is left.
std::string advice_of(const AllowedMemory& allowed) {
  return " by " + allowed.limit +
         ": fewer light_paths_per_iteration, a max_path_length, or more memory would be right";
}

}  // namespace

RenderJob::RenderJob(std::shared_ptr<const Snapshot> scene, const ups_render_desc& desc,
                     std::shared_ptr<ThreadPool> pool)
    : scene_(std::move(scene)), desc_(desc), pool_(std::move(pool)),
      queue_([this](const TallyQueue::Delivery& delivery) { add(delivery); }) {
  check_desc(desc_);
  method_ = choose_method(*scene_, desc_);
  if (desc_.perturbation == UPS_PERTURBATION_ACTUAL && !(method_.techniques & UPS_TECHNIQUE_MERGE) &&
      !(desc_.merge_radius_m > 0))
    fail_argument(
        "perturbation: UPS_PERTURBATION_ACTUAL needs the radius of merging: set merge_radius_m, or take a method that "
        "merges");
  if (!scene_->goniometers.empty() && scene_->cameras.empty() && scene_->meter_sets.empty() &&
      !settings_of(desc_, method_).traces_light() && desc_.time_limit_s == 0 && desc_.iteration_count == 0)
    fail_argument(
        "target_relative_error: it would never be met: the goniometer measures nothing without light paths, which "
        "methods lt and ups trace; set method, time_limit_s or iteration_count");
  if (scene_->cameras.empty() && scene_->meter_sets.empty() && scene_->goniometers.empty())
    throw Error(UPS_ERROR_INVALID_STATE,
                "the scene has no sensor: add a camera, meters or a goniometer before ups_scene_commit");
}

RenderJob::~RenderJob() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

void RenderJob::start() {
  allow_memory();
  thread_ = start_thread("job", [this] { run(); });
}

void RenderJob::run() {
  JobError error;
  try {
    iterate();
  } catch (...) {
    error.keep();
  }
  if (integrator_) integrator_->end();
  const std::lock_guard lock(mutex_);
  error_ = error.status;
  error_message_.swap(error.message);
  ended_s_ = elapsed();
  state_ = error.status != UPS_OK ? UPS_JOB_FAILED : stop_.is_cancelled() ? UPS_JOB_CANCELLED : UPS_JOB_FINISHED;
  changed_.notify_all();
}

// How much of the tolerance the work may use: what it is cut by may be seen late, and the result is yet to be read.
void RenderJob::set_deadline(double share_of_tolerance, double reserved_s) {
  if (!(desc_.time_limit_s > 0)) return;
  const double seconds = desc_.time_limit_s + share_of_tolerance * tolerance_s(desc_.time_limit_s) - reserved_s;
  if (seconds < 1e9) stop_.set_deadline(start_ + std::chrono::duration_cast<Clock::duration>(
                                                    std::chrono::duration<double>(seconds)));
}

void RenderJob::make_integrator() {
  TransportSettings settings = settings_of(desc_, method_);
  settings.memory = &memory_;
  integrator_ = std::make_unique<Integrator>(scene_, settings, *pool_, stop_);
}

void RenderJob::take_threads(ups_priority priority) {
  pool_ = JobThreads{pool_, desc_.thread_limit, priority}.take();
}

// What no pilot changes, and whether it may be.
std::pair<Plan, MemoryEstimate> RenderJob::plan_least() {
  const TransportSettings settings = settings_of(desc_, method_);
  Plan plan = make_plan(*scene_, settings);
  const MemoryEstimate least = least_memory(*scene_, settings, plan, desc_);
  allowed_ = allowed_memory(least.scene, desc_);
  return {std::move(plan), least};
}

void RenderJob::allow_memory() {
  const auto [plan, least] = plan_least();
  check_memory(least, allowed_, *scene_, plan, desc_);
  memory_.set(whole_bytes(allowed_.bytes - least.scene), advice_of(allowed_));  // of pilots
}

ups_memory_estimate RenderJob::estimate() {
  MemoryEstimate m = plan_least().second;
  if (m.peak() > allowed_.bytes) return in_bytes(m, allowed_);  // the render's pilots would not be reached
  memory_.set(whole_bytes(allowed_.bytes - m.scene), "");
  take_threads(UPS_PRIORITY_NORMAL);  // the caller's own stays as it is
  try {
    make_integrator();
    m = estimate_memory(*integrator_, desc_, double(memory_.peak()), stop_);
  } catch (const Error&) {
    if (memory_.wanted() <= memory_.peak()) throw;
    m.pilots = double(memory_.wanted());  // more than allowed, as the render's would
  }
  return in_bytes(m, allowed_);
}

ups_memory_estimate RenderJob::memory() const {
  const std::lock_guard lock(mutex_);
  if (!estimated_) throw Error(UPS_ERROR_INVALID_STATE, "the job is not prepared yet, or ended before it was");
  return *estimated_;
}

// The machine grants more memory than there is and ends the process that takes it.
void RenderJob::take_memory() {
  const MemoryEstimate m = estimate_memory(*integrator_, desc_, double(memory_.peak()), stop_);
  if (stop_.is_set()) return;
  {
    const std::lock_guard lock(mutex_);
    estimated_ = in_bytes(m, allowed_);
  }
  check_memory(m, allowed_, *scene_, integrator_->plan(), desc_);
  // Others may take a result, and the sums one more look at the errors. Arrays of light paths stay as large as they once
  // were, which from one iteration to the next may be larger than is estimated.
  const double meanwhile = m.scene + m.sums() + m.iteration + 2 * (m.reading + m.scratch);
  is_read_meanwhile_ = meanwhile + 1.5 * m.light_paths <= allowed_.bytes;
  const double left = allowed_.bytes - (is_read_meanwhile_ ? meanwhile : m.fixed_while_tracing());
  memory_.set(whole_bytes(left), advice_of(allowed_));
  queue_.set_most_bytes(whole_bytes(std::min(left - m.light_paths, double(TallyQueue::default_bytes))));
}

void RenderJob::prepare() {
  make_integrator();
  take_memory();
  if (stop_.is_set()) return;  // nothing is known of what it takes, and nothing will be rendered
  books_flux_ = integrator_->books_flux();
  auto glare = std::make_shared<std::vector<SeenGlare>>();
  if (!scene_->observers.empty()) {
    const GlareParts parts(*scene_, *pool_, stop_);
    for (const Observer& o : scene_->observers) glare->push_back(find_glare(*scene_, parts, o, *pool_, stop_));
  }
  glare_ = std::move(glare);
  auto sums = std::make_unique<Accumulator>(*scene_, integrator_->plan());
  queue_.read([&] {
    sums_ = std::move(sums);
    tell_selection(*integrator_, method_);
  });
  const Plan& plan = integrator_->plan();
  expected_ = reading_time(*scene_, plan, desc_.technique_images);
  tell_reading_time(expected_.look_s);
  const bool of_pixels = by_pixels(*scene_);
  const std::lock_guard lock(mutex_);
  estimate_.emplace(ProgressEstimate::Limits{desc_.time_limit_s, double(desc_.iteration_count),
                                             desc_.target_relative_error,
                                             of_pixels ? plan.camera_subsets : plan.meter_subsets, of_pixels});
  estimate_->start(elapsed());
}

// The clock decides how many iterations there are, and nothing else: one that is cut off leaves no trace.
void RenderJob::iterate() {
  take_threads(desc_.priority);
  set_deadline(0.7, 0);  // a first iteration is worth what is left when a cut is seen late
  prepare();
  if (!sums_) return;
  const bool has_light_paths = books_flux_ || !(scene_->emitters.flux_lm() > 0);
  FluxPass flux(*scene_, *pool_, desc_.seed, has_light_paths ? 0 : uint32_t(desc_.flux_paths), desc_.time_limit_s);
  TallyQueue::Delivery next;
  for (uint32_t i = 0; i < 0xfffffff0u; ++i) {
    if (!integrator_->run(i, stop_, next.tally)) break;
    if (flux.is_due(elapsed())) flux.trace_part(stop_, next.flux);
    deliver(next);
    tell_flux(flux);
    if (is_at_end(flux.reserved_s())) break;
    set_deadline(0.5, flux.reserved_s() + reading_s_);
  }
  next = {};
  next.has_iteration = false, next.is_last = true;
  trace_flux(flux, next.flux);
  deliver(next);
}

// After the iterations, as much as the time limit leaves.
void RenderJob::trace_flux(FluxPass& flux, WorkCounts& counts) {
  set_deadline(0.5, reading_s_);
  while (!flux.is_done() && !stop_.is_set()) {
    if (desc_.time_limit_s > 0 && elapsed() + flux.seconds_of_part() + reading_s_ > desc_.time_limit_s) return;
    flux.trace_part(stop_, counts);
    tell_flux(flux);
  }
}

void RenderJob::tell_flux(const FluxPass& flux) {
  const std::lock_guard lock(mutex_);
  estimate_->set_rest(flux.seconds_left(), elapsed());
}

// An iteration counts once a result has it: who polls one and takes a result at once gets that one.
void RenderJob::deliver(TallyQueue::Delivery& delivery) {
  delivery.elapsed_s = elapsed();
  const double elapsed_s = delivery.elapsed_s;
  const bool has_iteration = delivery.has_iteration, has_flux = delivery.flux.light_paths > 0;
  queue_.deliver(delivery, stop_, [&] {
    const std::lock_guard lock(mutex_);
    if (has_iteration || has_flux) elapsed_ = elapsed_s;
    if (has_iteration) estimate_->add_iterations(++iterations_, elapsed_);
  });
}

void RenderJob::add(const TallyQueue::Delivery& delivery) {
  if (delivery.has_iteration) {
    sums_->add(delivery.tally);
    iterated_s_ = sums_elapsed_ = delivery.elapsed_s;
  } else if (delivery.flux.light_paths > 0) {
    sums_elapsed_ = delivery.elapsed_s;
  }
  flux_.add(delivery.flux);
  if (delivery.is_last ? is_last_look_wanted() : is_look_due()) try_to_look();
}

// What a look has taken tells what the result will; no less than expected, as its memory may have to be found first.
void RenderJob::tell_reading_time(double look_s) {
  look_s_ = look_s;
  const double slower = expected_.look_s > 0 ? std::clamp(look_s / expected_.look_s, 1.0, 4.0) : 1;
  reading_s_ = std::min(slower * expected_.result_s, 0.5 * desc_.time_limit_s);
}

// A look at many meters may take seconds, in which no deadline is asked.
bool RenderJob::is_look_due() const {
  {
    const std::lock_guard lock(mutex_);
    if (sums_->iterations() < estimate_->next_look()) return false;
  }
  return !(desc_.time_limit_s > 0) || elapsed() + look_s_ + (has_looked_ ? reading_s_.load() : 0) <= desc_.time_limit_s;
}

// At the end, when it can stop nothing any more: so that what is told of the error is not that of long ago.
bool RenderJob::is_last_look_wanted() const {
  {
    const std::lock_guard lock(mutex_);
    if (stop_.is_cancelled() || !estimate_->is_last_look_old(sums_->iterations())) return false;
  }
  return !(desc_.time_limit_s > 0) ||
         elapsed() + look_s_ + reading_s_ <= desc_.time_limit_s + 0.8 * tolerance_s(desc_.time_limit_s);
}

// One that a cancel breaks off, or that finds no memory, is left out: the sums are whole.
void RenderJob::try_to_look() {
  try {
    look_at_error();
  } catch (const Cancelled&) {
  } catch (const std::bad_alloc&) {
    const std::lock_guard lock(mutex_);
    estimate_->leave_out_look(sums_->iterations());
  }
}

void RenderJob::look_at_error() {
  const uint32_t n = sums_->iterations();
  const auto begin = Clock::now();
  ErrorSummary e = sums_->summarize(&stop_);
  tell_reading_time(std::chrono::duration<double>(Clock::now() - begin).count());
  has_looked_ = true;
  const ups_criterion criterion = resolve_criterion(desc_.target_criterion, *scene_);
  const double error = error_by(criterion, e);
  const ups_largest_error largest = largest_error(*scene_, e);
  const ups_curve_point point = curve_point(n, iterated_s_, sums_->work(), e);
  std::shared_ptr<const Prediction> prediction = accuracy_.prediction;  // that only this function changes
  if (error >= 0) {
    auto next = prediction ? std::make_shared<Prediction>(*prediction)
                           : std::make_shared<Prediction>(criterion, integrator_->settings().radius_alpha);
    next->add_look({double(n), iterated_s_, error}, std::move(e.meters));
    prediction = std::move(next);
  }
  const std::lock_guard lock(mutex_);
  if (e.median >= 0) accuracy_.curve.push_back(point);  // before all else: it may find no memory
  worst_ = e.worst, median_ = e.median;
  accuracy_.prediction = std::move(prediction);
  accuracy_.largest = largest;
  estimate_->add_look(n, error, accuracy_.prediction.get());
}

Accuracy RenderJob::accuracy() const {
  const std::lock_guard lock(mutex_);
  Accuracy a = accuracy_;
  if (!estimate_) return a;
  a.start_s = estimate_->start_s();
  a.elapsed_s = elapsed_;
  a.seconds_per_iteration = estimate_->seconds_per_iteration();
  return a;
}

// reserved_s: of what is left to do after the iterations. One that the limit would cut off is not begun.
bool RenderJob::is_at_end(double reserved_s) const {
  const std::lock_guard lock(mutex_);
  if (desc_.iteration_count && iterations_ >= desc_.iteration_count) return true;
  if (desc_.target_relative_error > 0 && estimate_->target_is_met()) return true;
  if (!(desc_.time_limit_s > 0)) return false;
  const double left = desc_.time_limit_s - reserved_s - reading_s_ - elapsed_, one = estimate_->seconds_per_iteration();
  return left < 0.5 * one || left + 0.3 * tolerance_s(desc_.time_limit_s) < one;
}

ups_progress RenderJob::progress() const {
  const std::lock_guard lock(mutex_);
  ups_progress p{};
  p.struct_size = sizeof p;
  p.state = state_;
  p.iterations_done = iterations_;
  p.elapsed_s = state_ == UPS_JOB_RUNNING ? elapsed() : ended_s_;
  p.worst_relative_error = worst_;
  p.median_relative_error = median_;
  p.fraction = estimate_ ? float(estimate_->fraction()) : 0;
  p.remaining_s = estimate_ ? estimate_->remaining_s() : -1;
  if (state_ != UPS_JOB_RUNNING) {
    p.remaining_s = 0;
    if (state_ == UPS_JOB_FINISHED) p.fraction = 1;
  }
  return p;
}

ups_status RenderJob::wait(uint32_t timeout_ms, std::string& message) const {
  std::unique_lock lock(mutex_);
  const auto done = [&] { return state_ != UPS_JOB_RUNNING; };
  if (!changed_.wait_for(lock, std::chrono::milliseconds(timeout_ms), done)) return UPS_TIMEOUT;
  message = error_message_;
  return state_ == UPS_JOB_FAILED ? error_ : state_ == UPS_JOB_CANCELLED ? UPS_CANCELLED : UPS_OK;
}

std::shared_ptr<const RenderResult> RenderJob::result() const {
  if (!is_read_meanwhile_ && progress().state == UPS_JOB_RUNNING)
    throw Error(UPS_ERROR_OUT_OF_MEMORY, allowed_.limit + " leaves no room for a result while the job renders: take it "
                                             "after its end, or allow more memory");
  return queue_.read([this] { return read(); });
}

PathReplay RenderJob::replay(const ups_sample& sample) {
  desc_.seed = sample.seed;
  allow_memory();
  take_threads(UPS_PRIORITY_NORMAL);
  make_integrator();
  return ups::replay(*integrator_, sample, stop_);
}

}  // namespace ups
