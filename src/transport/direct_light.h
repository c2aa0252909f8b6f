// Light of emitters without extent that reaches point meters straight, or by way of one flat mirror, is no matter of
// chance: one shadow ray each finds it, once a render. It is next-event estimation at the meter's own point (k = 1, 2),
// which no other technique makes then.
#pragma once
#include <vector>

#include "base/parallel.h"
#include "transport/iteration.h"
#include "transport/tally.h"

namespace ups {

class DirectLight {
 public:
  DirectLight(const Snapshot& scene, const Plan& plan, const TransportSettings& settings);
  // Finds it for the meters that the iteration visits, where that has not been done.
  void find(const Iteration& in, ThreadPool& pool, WorkCounts& work);
  // Adds it to what the iteration found.
  void add(const Iteration& in, IterationTally& tally) const;
  size_t bytes() const;
  // All light straight from the emitters of plan.exact to every point meter is found here.
  bool finds_all() const { return !meters_.empty() && emitters_.size() + images_.size() <= most_; }
  // Light of an emitter of plan.exact that would bring at least so much, unoccluded, is found here; and of an image.
  float found_from(size_t set, uint32_t meter) const {
    return meters_.empty() || meters_[set].empty() ? INFINITY : meters_[set][meter].found_from;
  }
  float image_found_from(size_t set, uint32_t meter) const { return images_.empty() ? INFINITY : found_from(set, meter); }

 private:
  struct OfMeter {
    double lx = 0, mirrored = 0;  // mirrored: of lx
    float found_from = 0, rounding = 0;  // found_from 0: all is
    bool is_found = false;
  };
  struct OfColumn {
    double lx = 0, mirrored = 0;
  };
  void find(const Iteration& in, size_t set, uint32_t meter, WorkCounts& work);

  size_t most_ = 0;  // of a meter: its strongest
  std::vector<uint32_t> emitters_, images_;
  std::vector<std::vector<OfMeter>> meters_;      // empty sets: cells
  std::vector<std::vector<OfColumn>> separated_;  // a meter by a column, column fastest
};

}  // namespace ups
