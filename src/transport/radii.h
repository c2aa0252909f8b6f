// Where merging starts: the radius r_1 of every pixel and every meter, from the scene alone and free of its unit.
#pragma once
#include "base/parallel.h"
#include "transport/light_pass.h"
#include "transport/plan.h"

namespace ups {

// Fills plan.pixel_radius, plan.meter_radius and plan.walk_radius where the settings merge; with nothing useful once
// `stop` is set.
void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool, const std::atomic<bool>& stop,
                  Plan& plan);

// The parts for meters. Largest discs: limited by spacing, walls and the scene's size; 0 for cells.
std::vector<float> largest_disc_radii(const Snapshot& scene, const MeterSet& set, ThreadPool& pool);
// Shrinks them by what `passes` passes of pilot photons found on discs of those radii.
void fit_disc_radii(const Snapshot& scene, const SensorIndex& sensors, const std::vector<std::vector<PilotPaths::Crossing>>& crossings,
                    uint32_t passes, std::vector<std::vector<float>>& radii);

}  // namespace ups
