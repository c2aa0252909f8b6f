// The luminous intensity distribution of a set of rays, as if all of them started at one point. Called by the readers
// of ray files.
#pragma once
#include "photometry/photometry.h"

namespace photometry {

struct FarField {
  Distribution distribution;
  double noise;  // relative standard error of a node's intensity, as a mean over the flux
};

// Each ray's flux goes to the four nodes of a C-gamma grid about its direction, in proportion to the hat functions of
// bilinear interpolation there; a node's intensity is its flux over the solid-angle integral of its hat function. So
// the interpolated flux is the rays' flux, but for rounding.
//
// The grid follows the rays: bands of gamma of equal flux with steps at the edges of the light (angle_nodes.h). Rays
// that show no dependence on C beyond their noise are averaged over it, with about 1000 a band; others get evenly
// spaced planes, or planes that follow the rays where these are all to one side, with about 100 a node. `rays` is not
// empty. Throws std::invalid_argument where the intensities would not be finite.
FarField far_field(const std::vector<Ray>& rays);

}  // namespace photometry
