// Absorbed and escaped flux where the method traces no light paths: light paths of their own, a few after each
// iteration, so that a time limit and a cancel hold for them too. Run by the job.
#pragma once
#include "base/parallel.h"
#include "base/stop.h"
#include "scene/snapshot.h"
#include "transport/tally.h"

namespace ups {

class FluxPass {
 public:
  // paths: rounded up to a power of two; 0: there is nothing to do.
  FluxPass(const Snapshot& scene, ThreadPool& pool, uint64_t seed, uint32_t paths);
  bool is_done() const { return done_ == parts_; }
  // Adds the next part to `counts`; leaves it out where `stop` was set on the way.
  void trace_part(const StopSignal& stop, WorkCounts& counts);
  double seconds_left() const { return done_ > 0 ? seconds_ / done_ * (parts_ - done_) : 0; }

 private:
  const Snapshot& scene_;
  ThreadPool& pool_;
  const uint64_t seed_;
  uint32_t parts_ = 0, done_ = 0, paths_of_part_ = 0;
  double seconds_ = 0;
};

}  // namespace ups
