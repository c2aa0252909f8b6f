// Meters where light has an edge that photons tell too late: close to where glass begins, right below it. Asked at
// commit by scene/prepare.
#pragma once
#include "base/parallel.h"
#include "scene/snapshot.h"

namespace ups {

struct GlassEdges {
  size_t beside = 0;    // meters within edge_width of where glass begins that is within glass_height of them
  size_t touching = 0;  // meters with glass right on them
};
inline constexpr float edge_width = 0.01f, glass_height = 0.05f;  // m

// Of points that look one way; none elsewhere.
GlassEdges find_glass_edges(const Snapshot& scene, const MeterSet& meters, ThreadPool& pool);

}  // namespace ups
