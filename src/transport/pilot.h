// A few iterations of few paths, which say how noisy sets of techniques would be and are thrown away.
#pragma once
#include <functional>
#include <vector>

#include "transport/selection.h"

namespace ups {

// By unit.
struct Measured {
  std::vector<double> visited;              // pixels or meters
  std::vector<double> reading;              // of a visit, summed over these: lx; of a camera what eye paths found
  std::vector<double> variance;             // of a visit, summed over the pixels or meters that are visited
  std::vector<double> independent;          // the same, had its samples not been stratified
  std::vector<double> landed;               // of that, by what lands on meters, which all their eye paths share
  std::vector<std::vector<double>> excess;  // of each set of techniques over `independent`
  std::vector<double> eye_share;            // of all eye paths
  std::vector<double> light, caustic;       // what was found, and by photons of caustics
  std::vector<double> focused;              // the largest part of one meter's reading that is caustic beyond chance
  WorkCounts light_work, all;
};

inline constexpr uint32_t pilot_rounds = 3, pilot_paths = 1u << 12;

// From row to row of an image of which one pixel of `subsets` is visited: so that these lie far apart in all directions.
uint32_t spread_shift(uint32_t subsets);
// A few sensors' iterations as they will be, by few light paths.
Plan pilot_plan(const Snapshot& scene, const Plan& plan, const TransportSettings& settings);
// False once `stop` is set.
bool run_pilot(const Snapshot& scene, const Plan& plan, const TransportSettings& settings, const StopSignal& stop,
               const TraceIteration& trace, const Moments& moments, Measured& out);

}  // namespace ups
