// See job.h: what a result is read from, and what it says beside its values.
#include <algorithm>

#include "base/error.h"
#include "base/text.h"
#include "render/dropped_text.h"
#include "render/flux_balance.h"
#include "render/glare_warnings.h"
#include "render/job.h"
#include "render/radius_notice.h"
#include "render/reading_warnings.h"
#include "scene/check.h"
#include "scene/description.h"
#include "scene/searched.h"

namespace ups {

std::shared_ptr<const RenderResult> RenderJob::read() const {
  if (!sums_ || sums_->iterations() == 0) {
    const ups_job_state state = progress().state;
    if (state == UPS_JOB_CANCELLED || state == UPS_JOB_FAILED)
      throw Error(UPS_ERROR_INVALID_STATE, std::string("the job ") +
                                               (state == UPS_JOB_FAILED ? "failed" : "was cancelled") +
                                               " before its first iteration was done: there is no result");
    if (state == UPS_JOB_FINISHED)
      throw Error(UPS_ERROR_INVALID_STATE, "time_limit_s: " + check::text(desc_.time_limit_s) +
                                               " s were over before the first iteration was done");
    throw Error(UPS_ERROR_INVALID_STATE, "no whole iteration is done yet: wait for ups_progress.iterations_done > 0");
  }
  auto r = std::make_shared<RenderResult>();
  r->info = read_info();
  WorkCounts all = sums_->work();
  all.add(flux_);
  r->dropped = dropped_text(*integrator_, all);
  for (size_t c = 0; c < scene_->cameras.size(); ++c) r->images.push_back(sums_->read_image_and_techniques(c));
  for (size_t s = 0; s < scene_->meter_sets.size(); ++s) r->meter_sets.push_back(sums_->read_meters_and_sources(s));
  for (size_t c = 0; c < r->images.size(); ++c)
    r->largest_samples.push_back(sums_->largest_samples(c, r->images[c], desc_.seed));
  for (size_t s = 0; s < r->meter_sets.size(); ++s)
    r->largest_samples.push_back(sums_->largest_samples(s, r->meter_sets[s], desc_.seed));
  r->sources = integrator_->plan().separation.columns;
  r->scene = scene_;
  r->glare = glare_;
  r->choices = integrator_->selection().sensors;
  for (size_t g = 0; g < scene_->goniometers.size(); ++g) {
    r->goniometers.push_back(sums_->read_goniometer(g));
    r->goniometers.back().info.absorbed_flux_lm = r->info.absorbed_flux_lm;
  }
  r->accuracy = accuracy();
  r->warnings = notices_ + lines(known_warnings(*scene_)) + lines(scene_->warnings) + lines(method_.warnings);
  add_warnings(*r);
  r->effects = scene_->effects.text;
  r->techniques = method_.text;
  return r;
}

// The render's own light paths, or those of a pass of their own.
const WorkCounts& RenderJob::books() const { return books_flux_ ? sums_->work() : flux_; }

ups_result_info RenderJob::read_info() const {
  const WorkCounts& w = sums_->work();
  ups_result_info i{};
  i.struct_size = sizeof i;
  i.iterations = sums_->iterations();
  i.elapsed_s = sums_elapsed_;
  i.rays = w.rays;
  i.light_paths = w.light_paths;
  i.eye_paths = w.eye_paths;
  i.merges = w.merges;
  i.connections = w.connections;
  const WorkCounts& light = books();
  const bool known = light.light_paths > 0 || !(scene_->emitters.flux_lm() > 0);
  const double n = double(std::max<uint64_t>(1, light.light_paths));
  i.emitted_flux_lm = scene_->emitters.flux_lm();
  i.absorbed_flux_lm = known ? light.flux.absorbed / n : -1;
  i.escaped_flux_lm = known ? light.flux.escaped / n : -1;
  i.flux_balance_standard_error_lm = !known ? -1 : flux_balance(light, i.emitted_flux_lm).standard_error;
  i.maintenance_factor = scene_->maintenance_factor;
  i.revision = scene_->described->revision();
  i.seed = desc_.seed;
  for (size_t d = 0; d < flux_.dropped.size(); ++d) i.dropped_samples += w.dropped[d] + flux_.dropped[d];
  i.method = method_.method;
  i.techniques = method_.techniques;
  i.effects = scene_->effects.effects;
  i.threads = pool_->thread_count();
  return i;
}

// What the readings themselves cannot say.
void RenderJob::add_warnings(RenderResult& r) const {
  for (size_t c = 0; c < r.images.size(); ++c)
    if (const size_t n = sums_->unvisited_pixels(c))
      r.warnings += "camera " + std::to_string(scene_->camera_ids[c]) +
                    ": the render ended before eye paths were traced for " + std::to_string(n) + " of its " +
                    std::to_string(r.images[c].width * size_t(r.images[c].height)) +
                    " pixels; they show the mean of their neighbours\n";
  for (size_t s = 0; s < r.meter_sets.size(); ++s)
    if (const size_t n = sums_->unvisited_meters(s))
      r.warnings += "meters " + std::to_string(scene_->meter_set_ids[s]) + ": the render ended before " +
                    std::to_string(n) + " of its " + std::to_string(r.meter_sets[s].meters.size()) +
                    " meters were looked at; their readings are -1, and the set's statistics are of the others\n";
  for (size_t g = 0; g < scene_->goniometer_ids.size(); ++g)
    if (const std::string what = sums_->goniometer_asymmetry(g); !what.empty())
      r.warnings += "goniometer " + std::to_string(scene_->goniometer_ids[g]) + ": " + what +
                    ", so the light has not the symmetry that was asked for: what it measures is a mean over " +
                    "directions that differ\n";
  for (size_t o = 0; o < scene_->observers.size(); ++o)
    r.warnings += glare_warnings(*scene_, scene_->observer_ids[o], (*glare_)[o]);
  r.warnings += radius_notice(*integrator_, sums_->iterations());
  if (desc_.merge_radius_m > 0)
    for (size_t c = 0; c < r.images.size(); ++c) r.warnings += blur_notice(scene_->camera_ids[c], r.images[c]);
  r.warnings += crowd_notice(sums_->work());
  const double emitted = scene_->emitters.flux_lm();
  r.warnings += leaning_notice(books(), sums_->work(), emitted);
  r.warnings += importance_warning(importance_balance(sums_->work().importance));
  if (!(emitted > 0)) return;
  r.warnings += length_notice(desc_.max_path_length, books_flux_ ? books() : WorkCounts{}, emitted);
  if (books().light_paths > 0) r.warnings += flux_warning(flux_balance(books(), emitted), emitted);
  for (size_t s = 0; s < r.meter_sets.size(); ++s)
    if (r.meter_sets[s].statistics.mean_lx == 0)
      r.warnings += "meters " + std::to_string(scene_->meter_set_ids[s]) +
                    ": no light has reached them; they are dark, or this method has not found their light\n";
    else
      r.warnings += reading_warnings(scene_->meter_set_ids[s], scene_->meter_sets[s], r.meter_sets[s]);
}

}  // namespace ups
