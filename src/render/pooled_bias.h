// What meters beside each other tell of the bias of their discs: most of what one of them says alone is noise.
#pragma once
#include <vector>

#include "render/meter_rings.h"

namespace ups {

// Of a set's meters, in its order, in which neighbours follow each other; before their biases are pooled.
std::vector<NeighbourCurvature> neighbour_curvatures(const std::vector<MeterRings::Photons>& photons);

// What is to be expected of a meter's bias when the neighbours' curvature is known; its own where that is beyond doubt.
void pool_bias(MeterRings::Photons& photons, const NeighbourCurvature& neighbours);

}  // namespace ups
