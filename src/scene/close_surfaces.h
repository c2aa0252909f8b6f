// Surfaces that are closer to each other than rays are lifted off them: panes that lie on others, glass without room for
// a ray in it. By points of each instance.
#pragma once
#include <cstdint>
#include <vector>

#include "base/monitor.h"
#include "base/parallel.h"
#include "scene/snapshot.h"

namespace ups {

// The ray tracer must find all hits. By so many points that what is smaller than a tenth of a pane may be missed.
std::vector<PaneOnSurface> find_panes_on_surfaces(const Snapshot& scene, ThreadPool& pool, Monitor& monitor);

// Solids of glass a face of which lies on what no light goes through, and shines not: what a ray beyond the face would
// start behind.
std::vector<uint32_t> find_touched_glass(const Snapshot& scene, ThreadPool& pool, Monitor& monitor);
bool stops_light(const Snapshot& scene, uint32_t instance);  // of such a surface

// Solids of glass most of which is thinner than what a refracted ray starts off the surface: it would start behind them.
std::vector<uint32_t> find_thin_glass(const Snapshot& scene, ThreadPool& pool);

}  // namespace ups
