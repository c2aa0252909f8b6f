// See sensor_index.h: every meter's disc or cell.
#include "transport/sensor_index.h"

#include "transport/walk.h"

namespace ups {

SensorIndex::SensorIndex(const Iteration& in, ThreadPool& pool) {
  std::vector<DiscIndex::Disc> discs;
  for (uint32_t s = 0; s < in.scene.meter_sets.size(); ++s) {
    const MeterSet& set = in.scene.meter_sets[s];
    const bool cell = set.is_cell();
    const mis::Counts counts = in.meter_counts(s);
    if (cell ? !(counts.land > 0) : !in.merges_at(s)) continue;
    const float half_diagonal = 0.5f * std::sqrt(set.cell_width * set.cell_width + set.cell_height * set.cell_height);
    for (uint32_t i = 0; i < in.plan.visited_meters(in.number, set.meters.size()); ++i) {
      const uint32_t m = in.plan.visited_meter(in.number, i);
      const Meter& meter = set.meters[m];
      const double radius2 = cell ? 0 : in.meter_radius2(s, m);
      if (!cell && !(radius2 > 0)) continue;
      const double area = cell ? double(set.cell_area()) : 3.14159265358979323846 * radius2;
      entries_.push_back({s, m, i, area, in.eta(radius2) / in.plan.meter_samples, counts});
      const float radius = cell ? half_diagonal * 1.0001f : in.plan.meter_discs[s].radius(m);
      discs.push_back({lifted(meter.p, meter.frame.n, meter.error),
                       set.across() ? Vec3() : meter.frame.n, radius});
    }
  }
  if (!discs.empty()) discs_ = std::make_unique<DiscIndex>(std::move(discs), pool);
}

}  // namespace ups
