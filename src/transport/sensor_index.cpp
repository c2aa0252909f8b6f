// See sensor_index.h: every meter's disc or cell at the radius of this iteration.
#include "transport/sensor_index.h"

#include "transport/walk.h"

namespace ups {

SensorIndex::SensorIndex(const Snapshot& scene, const Plan& plan, const TransportSettings& settings, uint32_t iteration,
                         ThreadPool& pool) {
  std::vector<DiscIndex::Disc> discs;
  const double factor = Plan::radius2_factor(plan.meter_pass(iteration), settings.radius_alpha),
               walk_radius2 = plan.walk_radius2(iteration, settings.radius_alpha);
  for (uint32_t s = 0; s < scene.meter_sets.size(); ++s) {
    const MeterSet& set = scene.meter_sets[s];
    const bool cell = set.is_cell();
    if (!settings.has(cell ? UPS_TECHNIQUE_SENSOR_HIT : UPS_TECHNIQUE_MERGE)) continue;
    const float half_diagonal = 0.5f * std::sqrt(set.cell_width * set.cell_width + set.cell_height * set.cell_height);
    for (uint32_t i = 0; i < plan.visited_meters(iteration, set.meters.size()); ++i) {
      const uint32_t m = plan.visited_meter(iteration, i);
      const Meter& meter = set.meters[m];
      const double r = plan.meter_radius.empty() ? 0.0 : plan.meter_radius[s][m];
      const double radius2 = plan.radius2(r, factor);
      if (!cell && !(radius2 > 0)) continue;
      const double eta = cell ? 0.0 : eta_of(plan, settings, radius2) / plan.meter_samples;
      entries_.push_back({s, m, i, cell ? 0.0 : radius2, eta, meter_counts(plan, settings, cell, walk_radius2)});
      const float radius = cell ? half_diagonal * 1.0001f : float(std::sqrt(radius2));
      discs.push_back({lifted(meter.p, meter.frame.n, meter.error), meter.frame.n, radius});
    }
  }
  if (!discs.empty()) discs_ = std::make_unique<DiscIndex>(std::move(discs), pool);
}

}  // namespace ups
