// Where merging starts: the radius r_1 of every pixel and the discs of meters, from the scene alone and free of its
// unit.
#pragma once
#include <algorithm>
#include <vector>

#include "base/parallel.h"
#include "base/stop.h"
#include "transport/plan.h"

namespace ups {

// Fills plan.pixel_radius and plan.walk_radius where the settings merge, and plan.meter_discs, but of meters that the
// first iteration does not visit how far they see; with nothing useful once `stop` is set. share: plan.light_paths, over
// those of the render.
void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool, const StopSignal& stop,
                  double share, Plan& plan);
// How far the meters see that a later iteration is the first to visit. So a million meters are no long wait before the
// first iteration.
void look_around_meters(const Snapshot& scene, ThreadPool& pool, const StopSignal& stop, uint32_t iteration,
                        Plan& plan);

// Reorders v, which is not empty.
template <class T>
T median(std::vector<T>& v) {
  const auto middle = v.begin() + ptrdiff_t(v.size() / 2);
  std::nth_element(v.begin(), middle, v.end());
  return *middle;
}

}  // namespace ups
