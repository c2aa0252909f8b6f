// The luminous intensity distribution of a set of rays, as if all of them started at one point. Called by the readers
// of ray files.
#pragma once
#include "photometry/photometry.h"

namespace photometry {

// Each ray's flux goes to the four nodes of a C-gamma grid about its direction, in proportion to the hat functions of
// bilinear interpolation there; a node's intensity is its flux over the solid-angle integral of its hat function. So
// the interpolated flux is the rays' flux, but for rounding. Steps of 1 to 30 degrees, as fine as leaves 30 rays a node
// on average. Throws std::invalid_argument where the intensities would not be finite.
Distribution far_field(const std::vector<Ray>& rays);

}  // namespace photometry
