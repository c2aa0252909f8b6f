// See flux_pass.h.
#include "render/flux_pass.h"

#include <algorithm>
#include <bit>

#include "transport/light_pass.h"

namespace ups {

namespace {

constexpr uint32_t most_parts = 32, least_paths_of_part = 1024;  // of more than the batches

}  // namespace

FluxPass::FluxPass(const Snapshot& scene, ThreadPool& pool, uint64_t seed, uint32_t paths)
    : scene_(scene), pool_(pool), seed_(seed) {
  if (paths == 0) return;
  const uint32_t all = std::bit_ceil(paths);
  parts_ = std::clamp(all / least_paths_of_part, std::min(all, batch_count), most_parts);
  paths_of_part_ = all / parts_;
}

void FluxPass::trace_part(const StopSignal& stop, WorkCounts& counts) {
  const auto start = StopSignal::Clock::now();
  TransportSettings s{.method = {}};
  s.seed = seed_;
  Plan plan = make_plan(scene_, s);
  plan.light_paths = paths_of_part_;
  IterationTally tally;
  Iteration in = Iteration::of_pilot(scene_, plan, s, done_, stop, Stream::flux);
  in.light_visit = {done_ % batch_count, done_ / batch_count};  // batches may have rays of their own of a file
  LightPass().trace(in, SensorIndex(in), pool_, tally);
  if (stop.is_set()) return;
  tally.work.flux.settle(in.light_visit.batch, paths_of_part_);
  counts.add(tally.work);
  ++done_;
  seconds_ += std::chrono::duration<double>(StopSignal::Clock::now() - start).count();
}

}  // namespace ups
