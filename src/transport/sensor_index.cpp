// See sensor_index.h: every meter's disc, or the pieces of its cell.
#include "transport/sensor_index.h"

#include "transport/walk.h"

namespace ups {

SensorIndex::SensorIndex(const Iteration& in, const std::shared_ptr<const DiscIndex>& before) {
  std::vector<DiscIndex::Disc> discs;
  for (uint32_t s = 0; s < in.scene.meter_sets.size(); ++s) {
    const MeterSet& set = in.scene.meter_sets[s];
    const bool cell = set.is_cell();
    const mis::Counts counts = in.meter_counts(s);
    if (cell ? !(counts.land > 0) : !in.merges_at(s)) continue;
    for (uint32_t i = 0; i < in.plan.visited_meters(in.number, set.meters.size()); ++i) {
      if (i % 4096 == 0 && in.stop.is_set()) {
        entries_.clear();
        return;
      }
      const uint32_t m = in.plan.visited_meter(in.number, i);
      const Meter& meter = set.meters[m];
      const double radius2 = cell ? 0 : in.meter_radius2(s, m);
      if (!cell && !(radius2 > 0)) continue;
      if (!cell) {
        entries_.push_back({s, m, 0, i, 3.14159265358979323846 * radius2, in.eta(radius2) / in.plan.meter_samples,
                            counts});
        discs.push_back({lifted(meter.p, meter.frame.n, meter.error), set.across() ? Vec3() : meter.frame.n,
                         in.plan.meter_discs[s].radius(m)});
      }
      for (uint32_t k = 0; cell && k < set.piece_count(m); ++k) {
        const Meter& piece = set.piece(m, k);
        const MeterSet::Extent extent = set.extent(m, k);
        entries_.push_back({s, m, k, i, set.area(m), 0, counts});
        discs.push_back({lifted(extent.center, piece.frame.n, piece.error), piece.frame.n, extent.radius * 1.0001f,
                         extent.reach * 1.0001f});
      }
    }
  }
  if (discs.empty()) return;
  discs_ = before && before->holds(discs) ? before : std::make_shared<const DiscIndex>(std::move(discs), in.stop);
}

}  // namespace ups
