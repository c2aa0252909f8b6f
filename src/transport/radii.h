// Where merging starts: the radius r_1 of every pixel and every meter, from the scene alone and free of its unit.
#pragma once
#include <algorithm>
#include <vector>

#include "base/parallel.h"
#include "base/stop.h"
#include "transport/light_pass.h"
#include "transport/plan.h"

namespace ups {

// Fills plan.pixel_radius and plan.walk_radius where the settings merge, and plan.meter_radius of the meters that the
// first iteration visits; with nothing useful once `stop` is set. share: plan.light_paths, over those of the render.
void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool, const StopSignal& stop,
                  double share, Plan& plan);
// Fills plan.meter_radius of the meters that a later iteration is the first to visit. So a million meters are no long
// wait before the first iteration.
void choose_meter_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool,
                        const StopSignal& stop, uint32_t iteration, Plan& plan);

// Reorders v, which is not empty.
inline float median(std::vector<float>& v) {
  const auto middle = v.begin() + ptrdiff_t(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

// Median distance of a meter of the set to its nearest neighbour; infinite where there is none, 0 for cells, where
// photons are counted, not merged.
float meter_spacing(const MeterSet& set);
// The parts for the meters that an iteration visits, in place. Limited by spacing, walls and the scene's size.
void set_largest_disc_radii(const Snapshot& scene, ThreadPool& pool, const StopSignal& stop, uint32_t iteration,
                            Plan& plan);
// Shrinks them by what `passes` passes of pilot photons, `share` of a render's, found on discs of those radii.
void fit_disc_radii(const Snapshot& scene, const SensorIndex& sensors,
                    const std::vector<std::vector<PilotPaths::Crossing>>& crossings, uint32_t passes,
                    double share, uint32_t iteration, Plan& plan);

}  // namespace ups
