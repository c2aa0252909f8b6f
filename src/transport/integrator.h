// One iteration of Unified Path Sampling, in reading order: light pass, photon index, eye pass. Called by render/job.
#pragma once
#include <atomic>
#include <memory>

#include "base/parallel.h"
#include "transport/plan.h"
#include "transport/tally.h"

namespace ups {

inline constexpr uint32_t batch_count = 16;  // interleaved, independently scrambled; see render/accumulator.h

class Integrator {
 public:
  // Traces a pilot; once `stop` is set only run() returning false is to be expected of it.
  Integrator(std::shared_ptr<const Snapshot> scene, const TransportSettings& settings, ThreadPool& pool,
             const std::atomic<bool>& stop);
  const Plan& plan() const { return plan_; }
  const TransportSettings& settings() const { return settings_; }
  const Snapshot& scene() const { return *scene_; }
  // False where `stop` was set on the way: the tally is then incomplete. The same bits for any number of threads.
  bool run(uint32_t iteration, const std::atomic<bool>& stop, IterationTally& tally) const;

 private:
  float largest_radius(const std::vector<std::vector<float>>& radii, double factor) const;
  std::shared_ptr<const Snapshot> scene_;
  TransportSettings settings_;
  ThreadPool& pool_;
  Plan plan_;
};

}  // namespace ups
