// See job.h: what is asked for is checked, then the loop over iterations, its limits, progress, and the result.
#include "render/job.h"

#include <unistd.h>

#include <algorithm>
#include <cmath>

#include "base/error.h"
#include "base/text.h"
#include "base/thread.h"
#include "render/radius_notice.h"
#include "transport/light_pass.h"

namespace ups {

namespace {

constexpr uint32_t flux_paths = 65536;  // of the separate pass that books flux for methods without light paths

void check(const ups_render_desc& d) {
  if (!(d.time_limit_s >= 0) || !std::isfinite(d.time_limit_s))
    fail_argument("time_limit_s: " + std::to_string(d.time_limit_s) + " is not a finite number of seconds >= 0");
  if (!(d.target_relative_error >= 0) || !std::isfinite(d.target_relative_error))
    fail_argument("target_relative_error: " + std::to_string(d.target_relative_error) +
                  " is not a finite fraction >= 0");
  if (!(d.merge_radius_m >= 0) || !std::isfinite(d.merge_radius_m))
    fail_argument("merge_radius_m: " + std::to_string(d.merge_radius_m) + " is not a finite length >= 0");
  if (d.light_paths_per_iteration > (1u << 24)) fail_argument("light_paths_per_iteration: at most 16777216");
  if (!(d.radius_alpha >= 0) || d.radius_alpha >= 1)
    fail_argument("radius_alpha: " + std::to_string(d.radius_alpha) + " is not between 0 and 1 (0: 2/3)");
  if (!(d.glossy_alpha >= 0) || d.glossy_alpha > 1)
    fail_argument("glossy_alpha: " + std::to_string(d.glossy_alpha) + " is not a GGX alpha between 0 and 1 (0: 0.2)");
  if (d.perturbation != UPS_PERTURBATION_VIRTUAL && d.perturbation != UPS_PERTURBATION_ACTUAL)
    fail_argument("perturbation: " + std::to_string(d.perturbation) + " is not a UPS_PERTURBATION_* value");
  if (d.technique_images > max_technique_edges)
    fail_argument("technique_images: " + std::to_string(d.technique_images) + " edges; at most " +
                  std::to_string(max_technique_edges));
  if (d.separation < UPS_SEPARATE_NOTHING || d.separation > UPS_SEPARATE_GROUPS)
    fail_argument("separation: " + std::to_string(d.separation) + " is not a UPS_SEPARATE_* value");
  if (d.reserved != 0) fail_argument("reserved is " + std::to_string(d.reserved) + "; it must be 0");
  if (d.techniques >= 64)
    fail_argument("techniques: " + std::to_string(d.techniques) + " has bits that are no UPS_TECHNIQUE_*");
  if (d.time_limit_s == 0 && d.target_relative_error == 0 && d.iteration_count == 0)
    fail_argument("nothing would end this render: set time_limit_s, target_relative_error or iteration_count");
}

// Linux grants more memory than there is and ends the process that takes it.
void check_memory(const Snapshot& scene, uint32_t technique_edges, size_t columns) {
  // Sums, batches and one iteration's tally (accumulator.h, tally.h); of a technique those and what is read out.
  const double bytes_per_pixel = 320 + 96.0 * (technique_edges ? technique_count(technique_edges) + 1 : 0);
  double pixels = 0;
  for (const Camera& c : scene.cameras) pixels += c.pixel_count();
  double meters = 0;
  for (const MeterSet& set : scene.meter_sets) meters += double(set.meters.size());
  double nodes = 0;
  for (const Goniometer& g : scene.goniometers) nodes += double(g.node_count());
  constexpr double bytes_per_reading = 320;  // sums by batch, one iteration's tally, and the reading
  const double needed = pixels * bytes_per_pixel + (meters * double(columns) + nodes) * bytes_per_reading;
  const double there = double(sysconf(_SC_PHYS_PAGES)) * double(sysconf(_SC_PAGESIZE));
  if (needed > there)
    throw Error(UPS_ERROR_OUT_OF_MEMORY,
                "the cameras' images, the meters' separate readings and the goniometers need " +
                    std::to_string(int64_t(needed / 1e9)) + " GB while they are rendered, the machine has " +
                    std::to_string(int64_t(there / 1e9)));
}

}  // namespace

RenderJob::RenderJob(std::shared_ptr<const Snapshot> scene, const ups_render_desc& desc,
                     std::shared_ptr<ThreadPool> pool)
    : scene_(std::move(scene)), desc_(desc), pool_(std::move(pool)) {
  check(desc_);
  method_ = choose_method(*scene_, desc_);
  if (desc_.perturbation == UPS_PERTURBATION_ACTUAL && !(method_.techniques & UPS_TECHNIQUE_MERGE) &&
      !(desc_.merge_radius_m > 0))
    fail_argument(
        "perturbation: UPS_PERTURBATION_ACTUAL needs the radius of merging: set merge_radius_m, or take a method that "
        "merges");
  check_memory(*scene_, desc_.technique_images, separate(*scene_, desc_.separation).columns.size());
  if (scene_->cameras.empty() && scene_->meter_sets.empty() && scene_->goniometers.empty())
    throw Error(UPS_ERROR_INVALID_STATE,
                "the scene has no sensor: add a camera, meters or a goniometer before ups_scene_commit");
}

RenderJob::~RenderJob() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

void RenderJob::start() {
  thread_ = start_thread("job", [this] { run(); });
}

void RenderJob::run() {
  ups_status status = UPS_OK;
  std::string message;
  constexpr const char* short_text = "out of memory";  // fits into a string that allocates nothing
  const auto keep = [&](ups_status code, const char* text) {
    status = code;
    try {
      message = text;
    } catch (const std::bad_alloc&) {
      message = short_text;
    }
  };
  try {
    iterate();
    count_flux();
  } catch (const Error& e) {
    keep(e.status(), e.what());
  } catch (const std::bad_alloc&) {
    keep(UPS_ERROR_OUT_OF_MEMORY, short_text);
  } catch (const std::exception& e) {
    keep(UPS_ERROR_INTERNAL, e.what());
  }
  const std::lock_guard lock(mutex_);
  error_ = status;
  error_message_.swap(message);
  state_ = status != UPS_OK ? UPS_JOB_FAILED : stop_.load() ? UPS_JOB_CANCELLED : UPS_JOB_FINISHED;
  changed_.notify_all();
}

void RenderJob::iterate() {
  start_ = std::chrono::steady_clock::now();
  integrator_ = std::make_unique<Integrator>(scene_, settings_of(desc_, method_), *pool_, stop_);
  {
    const std::lock_guard lock(mutex_);
    sums_ = std::make_unique<Accumulator>(*scene_, integrator_->plan());
  }
  IterationTally tally;
  for (uint32_t i = 0; i < 0xfffffff0u; ++i) {
    if (!integrator_->run(i, stop_, tally)) return;
    const std::lock_guard lock(mutex_);
    sums_->add(tally);
    elapsed_ = std::chrono::duration<double>(std::chrono::steady_clock::now() - start_).count();
    if (i + 1 >= next_check_) check_error(elapsed_);
    if (at_end(elapsed_)) return;
  }
}

// At 16, 20, 25 ... iterations. Two successive passes guard against stopping on a lucky look.
void RenderJob::check_error(double elapsed) {
  const uint32_t n = sums_->iterations();
  next_check_ = std::max(n + 1, uint32_t(std::ceil(n * 1.25)));
  last_error_ = sums_->summarize();
  if (last_error_.median < 0) return;
  convergence_.push_back(
      {elapsed, n, 0, last_error_.median, last_error_.p95, last_error_.worst, last_error_.bias_share});
  const float error = scene_->meter_sets.empty() ? last_error_.mean : last_error_.worst;
  passes_below_target_ = error <= desc_.target_relative_error ? passes_below_target_ + 1 : 0;
}

bool RenderJob::at_end(double elapsed) const {
  const uint32_t n = sums_->iterations();
  if (desc_.iteration_count && n >= desc_.iteration_count) return true;
  if (desc_.target_relative_error > 0 && passes_below_target_ >= 2 && n >= 2 * batch_count) return true;
  // Stop where the limit is nearer than half an iteration: the mean overrun is nothing.
  return desc_.time_limit_s > 0 && elapsed + 0.5 * elapsed / n >= desc_.time_limit_s;
}

// Absorbed and escaped flux: from the render's own light paths, or from a pass of their own.
void RenderJob::count_flux() {
  WorkCounts work;
  {
    const std::lock_guard lock(mutex_);
    work = sums_->work();
  }
  if (work.light_paths == 0 && scene_->emitters.flux_lm() > 0) {
    TransportSettings s;
    s.seed = desc_.seed;
    Plan plan;
    plan.light_paths = flux_paths;
    IterationTally tally;
    const SensorIndex no_sensors(*scene_, plan, s, 0, *pool_);
    trace_light_paths({*scene_, plan, s, 0, 0, 0, 1.0, 0.0, false, stop_, Stream::flux}, no_sensors, *pool_, tally);
    if (stop_.load()) return;  // incomplete; both stay unknown
    work = tally.work;
  }
  const double n = double(std::max<uint64_t>(1, work.light_paths));
  const std::lock_guard lock(mutex_);
  absorbed_lm_ = work.absorbed_lm / n;
  escaped_lm_ = work.escaped_lm / n;
}

ups_progress RenderJob::progress() const {
  const std::lock_guard lock(mutex_);
  ups_progress p{};
  p.struct_size = sizeof p;
  p.state = state_;
  p.iterations_done = sums_ ? sums_->iterations() : 0;
  p.elapsed_s = elapsed_;
  p.worst_relative_error = last_error_.worst;
  p.median_relative_error = last_error_.median;
  p.remaining_s = -1;
  const double n = p.iterations_done;
  const auto consider = [&](double fraction, double remaining) {
    p.fraction = std::max(p.fraction, float(std::clamp(fraction, 0.0, 1.0)));
    p.remaining_s = p.remaining_s < 0 ? remaining : std::min(p.remaining_s, remaining);
  };
  if (n > 0) {
    if (desc_.time_limit_s > 0) consider(elapsed_ / desc_.time_limit_s, std::max(0.0, desc_.time_limit_s - elapsed_));
    if (desc_.iteration_count)
      consider(n / desc_.iteration_count, elapsed_ / n * std::max(0.0, desc_.iteration_count - n));
    const double error = scene_->meter_sets.empty() ? last_error_.mean : last_error_.worst;
    if (desc_.target_relative_error > 0 && error > 0) {
      const double share = std::pow(desc_.target_relative_error / error, 2);  // noise^2 falls as 1 / n
      if (share < 1) consider(share, elapsed_ * (1 / share - 1));
    }
  }
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
  const std::lock_guard lock(mutex_);
  if (!sums_ || sums_->iterations() == 0)
    throw Error(UPS_ERROR_INVALID_STATE, "no whole iteration is done yet: wait for ups_progress.iterations_done > 0");
  auto r = std::make_shared<RenderResult>();
  const WorkCounts& w = sums_->work();
  ups_result_info& i = r->info;
  i.struct_size = sizeof i;
  i.iterations = sums_->iterations();
  i.elapsed_s = elapsed_;
  i.rays = w.rays;
  i.light_paths = w.light_paths;
  i.eye_paths = w.eye_paths;
  i.merges = w.merges;
  i.connections = w.connections;
  i.emitted_flux_lm = scene_->emitters.flux_lm();
  i.absorbed_flux_lm = absorbed_lm_;
  i.escaped_flux_lm = escaped_lm_;
  i.seed = desc_.seed;
  for (size_t d = 0; d < w.dropped.size(); ++d) {
    i.dropped_samples += w.dropped[d];
    if (w.dropped[d])
      r->dropped += std::string(drop_names[d]) + ": " + std::to_string(w.dropped[d]) + " samples were not finite\n";
  }
  i.method = method_.method;
  i.techniques = method_.techniques;
  i.effects = scene_->effects.effects;
  i.threads = pool_->thread_count();
  r->camera_ids = scene_->camera_ids;
  r->meter_set_ids = scene_->meter_set_ids;
  for (size_t c = 0; c < scene_->cameras.size(); ++c) r->images.push_back(sums_->read_image_and_techniques(c));
  for (size_t s = 0; s < scene_->meter_sets.size(); ++s) r->meter_sets.push_back(sums_->read_meters_and_sources(s));
  r->sources = integrator_->plan().separation.columns;
  r->scene = scene_;
  r->goniometer_ids = scene_->goniometer_ids;
  for (size_t g = 0; g < scene_->goniometers.size(); ++g) {
    r->goniometers.push_back(sums_->read_goniometer(g));
    r->goniometers.back().info.absorbed_flux_lm = absorbed_lm_;
  }
  r->convergence = convergence_;
  r->warnings = lines(scene_->warnings) + lines(method_.warnings);
  add_warnings(*r);
  r->effects = scene_->effects.text;
  r->techniques = method_.text;
  return r;
}

// What the readings themselves cannot say.
void RenderJob::add_warnings(RenderResult& r) const {
  for (size_t c = 0; c < r.images.size(); ++c)
    if (const size_t n = sums_->unvisited_pixels(c))
      r.warnings += "camera " + std::to_string(r.camera_ids[c]) +
                    ": the render ended before eye paths were traced for " + std::to_string(n) + " of its " +
                    std::to_string(r.images[c].width * size_t(r.images[c].height)) +
                    " pixels; they show the mean of their neighbours\n";
  for (size_t g = 0; g < r.goniometer_ids.size(); ++g)
    if (const std::string what = sums_->goniometer_asymmetry(g); !what.empty())
      r.warnings += "goniometer " + std::to_string(r.goniometer_ids[g]) + ": " + what +
                    ", so the light has not the symmetry that was asked for: what it measures is a mean over " +
                    "directions that differ\n";
  r.warnings += radius_notice(*integrator_, sums_->iterations());
  if (!(scene_->emitters.flux_lm() > 0)) return;
  for (size_t s = 0; s < r.meter_sets.size(); ++s)
    if (!(r.meter_sets[s].statistics.mean_lx > 0))
      r.warnings += "meters " + std::to_string(r.meter_set_ids[s]) +
                    ": no light has reached them; they are dark, or this method has not found their light\n";
}

}  // namespace ups
