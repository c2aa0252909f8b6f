// Absorbed and escaped flux where the method traces no light paths: light paths of their own, a few after each
// iteration, so that a time limit and a cancel hold for them too. Run by the job.
#pragma once
#include <algorithm>
#include <optional>

#include "base/parallel.h"
#include "base/stop.h"
#include "scene/snapshot.h"
#include "transport/plan.h"
#include "transport/tally.h"

namespace ups {

class FluxPass {
 public:
  // paths: rounded up to a power of two; 0: there is nothing to do. limit_s: of the render; 0: none.
  FluxPass(const Snapshot& scene, ThreadPool& pool, uint64_t seed, uint32_t paths, double limit_s);
  bool is_done() const { return done_ == parts_; }
  // Between iterations; a time limit is theirs but for a fifth.
  bool is_due(double elapsed_s) const {
    return !is_done() && (!(limit_s_ > 0) || seconds_ + seconds_of_part() <= share_of_time * elapsed_s);
  }
  // Adds the next part to `counts`; leaves it out where `stop` was set on the way.
  void trace_part(const StopSignal& stop, WorkCounts& counts);
  double seconds_of_part() const { return done_ > 0 ? seconds_ / done_ : 0; }
  double seconds_left() const { return seconds_of_part() * (parts_ - done_); }
  // What iterations leave it of the time limit.
  double reserved_s() const {
    return std::min(seconds_left(), std::max(0.0, share_of_time * limit_s_ - seconds_));
  }

 private:
  static constexpr double share_of_time = 0.2;
  const Snapshot& scene_;
  ThreadPool& pool_;
  TransportSettings settings_{.method = {}};
  std::optional<Plan> plan_;  // none before the first part
  uint32_t parts_ = 0, done_ = 0, paths_of_part_ = 0;
  double limit_s_, seconds_ = 0;
};

}  // namespace ups
