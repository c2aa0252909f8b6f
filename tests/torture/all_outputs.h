// What survive() does not look at otherwise: meters of all kinds, an observer, a goniometer and its profile's files, all
// layers of a camera and its images by technique, statistics of sets, the curve and what is predicted. None may hold a
// number that is not finite.
#pragma once
#include "../support/scene_builder.h"

namespace ups::test {

// Adds sensors at the first meter of a set to the scene, and renders a few iterations.
void read_all_outputs(Scene& scene, const Sensor& meters, RenderOptions options);

}  // namespace ups::test
