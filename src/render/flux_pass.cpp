// See flux_pass.h.
#include "render/flux_pass.h"

#include <bit>

#include "transport/light_pass.h"

namespace ups {

namespace {

// Of many paths there are more parts: one may take a long time.
constexpr uint32_t few_parts = 32, least_paths_of_part = 1024, most_paths_of_part = 4096;

}  // namespace

FluxPass::FluxPass(const Snapshot& scene, ThreadPool& pool, uint64_t seed, uint32_t paths, double limit_s)
    : scene_(scene), pool_(pool), limit_s_(limit_s) {
  settings_.seed = seed;
  if (paths == 0) return;
  const uint32_t all = std::bit_ceil(paths);
  paths_of_part_ = std::clamp(all / few_parts, least_paths_of_part, most_paths_of_part);
  paths_of_part_ = std::min(paths_of_part_, std::max(1u, all / batch_count));
  parts_ = all / paths_of_part_;
}

void FluxPass::trace_part(const StopSignal& stop, WorkCounts& counts) {
  const auto start = StopSignal::Clock::now();
  if (!plan_) {
    plan_ = make_plan(scene_, settings_);
    plan_->light_paths = paths_of_part_;
  }
  IterationTally tally;
  Iteration in = Iteration::of_pilot(scene_, *plan_, settings_, done_, stop, Stream::flux);
  in.light_visit = {done_ % batch_count, done_ / batch_count};  // batches may have rays of their own of a file
  LightPass().trace(in, SensorIndex(in), pool_, tally);
  if (stop.is_set()) return;
  tally.work.flux.settle(in.light_visit.batch, paths_of_part_);
  counts.add(tally.work);
  ++done_;
  seconds_ += std::chrono::duration<double>(StopSignal::Clock::now() - start).count();
}

}  // namespace ups
