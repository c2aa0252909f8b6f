// Meters as discs that light paths cross: photons are merged at a point meter's disc, counted on a cell. The sensors
// are stored and the photons stream by, so meters that float in the air catch what no surface stores.
#pragma once
#include <memory>
#include <vector>

#include "scene/snapshot.h"
#include "transport/iteration.h"

namespace ups {

class SensorIndex {
 public:
  SensorIndex() = default;
  // The meters that the iteration visits. Holds point meters where merging is on and cells where landing is on.
  // before: of an earlier iteration, taken over where its discs are the same; may be null.
  explicit SensorIndex(const Iteration& in, const std::shared_ptr<const DiscIndex>& before = nullptr);

  struct Entry {
    uint32_t set, meter;
    uint32_t piece;      // of a cell: MeterSet::piece
    uint32_t visited;    // running number of the meter among those of its set that the iteration visits
    double area = 0;     // of a whole cell, of a point's disc
    double eta = 0;      // N area / Ke: a disc merges once for all eye paths of its meter; 0: a cell
    mis::Counts counts;
  };
  const std::shared_ptr<const DiscIndex>& discs() const { return discs_; }
  bool empty() const { return entries_.empty(); }
  const Entry& entry(uint32_t disc) const { return entries_[disc]; }
  void crossings(const Vec3& o, const Vec3& d, float tmax, std::vector<DiscIndex::Crossing>& out) const {
    discs_->intersect_all(o, d, tmax, out);
  }

 private:
  std::vector<Entry> entries_;
  std::shared_ptr<const DiscIndex> discs_;
};

}  // namespace ups
