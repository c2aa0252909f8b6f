// What meters beside each other tell of the bias of merging: most of what one of them says alone is noise.
#pragma once
#include <vector>

#include "render/meter_rings.h"
#include "render/spread.h"

namespace ups {

// Of a meter, estimated by itself. mean_radius2: of its disc, m2; 0: without one.
struct OwnBias {
  Spread bias;
  double lx, mean_radius2;
  double scale() const { return mean_radius2 > 0 ? lx * mean_radius2 : lx; }
  bool is_beyond_doubt() const { return std::abs(bias.mean) > 2 * bias.standard_error; }
};

// Of a set's meters, in its order, in which neighbours follow each other.
std::vector<NeighbourCurvature> neighbour_curvatures(const std::vector<OwnBias>& meters);

// What is to be expected of a meter's bias when the neighbours' curvature is known; its own where that is beyond doubt.
Spread pooled_bias(const OwnBias& own, const NeighbourCurvature& neighbours);

}  // namespace ups
