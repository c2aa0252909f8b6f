// Where merging starts: the radius r_1 of every pixel and every meter, from the scene alone and free of its unit.
#pragma once
#include <algorithm>
#include <vector>

#include "base/parallel.h"
#include "transport/light_pass.h"
#include "transport/plan.h"

namespace ups {

// Fills plan.pixel_radius, plan.meter_radius and plan.walk_radius where the settings merge; with nothing useful once
// `stop` is set.
void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool,
                  const std::atomic<bool>& stop, Plan& plan);

// Reorders v, which is not empty.
inline float median(std::vector<float>& v) {
  const auto middle = v.begin() + ptrdiff_t(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

// The parts for meters. spacing: median distance of a meter of the set to its nearest neighbour; infinite where there
// is none, 0 for cells, where photons are counted, not merged.
float meter_spacing(const MeterSet& set);
// Limited by spacing, walls and the scene's size; 0 for cells.
std::vector<float> largest_disc_radii(const Snapshot& scene, const MeterSet& set, float spacing, ThreadPool& pool);
// Shrinks them by what `passes` passes of pilot photons found on discs of those radii.
void fit_disc_radii(const Snapshot& scene, const SensorIndex& sensors,
                    const std::vector<std::vector<PilotPaths::Crossing>>& crossings, uint32_t passes,
                    const std::vector<float>& spacings, std::vector<std::vector<float>>& radii);

}  // namespace ups
