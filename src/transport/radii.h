// Where merging starts: the radius r_1 of every pixel and every meter, from the scene alone and free of its unit.
#pragma once
#include "base/parallel.h"
#include "transport/plan.h"

namespace ups {

// Fills plan.pixel_radius and plan.meter_radius where the settings merge.
void choose_radii(const Snapshot& scene, const TransportSettings& settings, ThreadPool& pool, Plan& plan);

}  // namespace ups
