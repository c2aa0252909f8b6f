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

// What lets light through and scatters it, such as a diffuser, within reach of what no light goes through: what goes
// through there starts behind that.
struct SheetOnSurface {
  uint32_t instance, opaque;
  float covered;     // share of its area
  float resolved_m;  // farther apart they are told apart
};
std::vector<SheetOnSurface> find_sheets_on_surfaces(const Snapshot& scene, ThreadPool& pool, const Monitor* monitor);

// Solids of glass a face of which lies on what no light goes through, and shines not: what a ray beyond the face would
// start behind.
std::vector<uint32_t> find_touched_glass(const Snapshot& scene, ThreadPool& pool, Monitor& monitor);
bool stops_light(const Snapshot& scene, uint32_t instance);  // of such a surface

// What no light goes through and lies in the very plane of another such surface of another material, that faces the same
// way, as a rug that is drawn on the floor: rounding decides which of them a ray meets. Not what stands on a floor, whose
// lower face looks down.
struct Overlaid {
  uint32_t instance = 0, beneath = none;
  float resolved_m = 0;  // apart by so much they are told apart
};
std::vector<Overlaid> find_overlaid(const Snapshot& scene, ThreadPool& pool, const Monitor* monitor);

// Solids of glass most of which is thinner than what a refracted ray starts off the surface: it would start behind them.
std::vector<uint32_t> find_thin_glass(const Snapshot& scene, ThreadPool& pool);

}  // namespace ups
