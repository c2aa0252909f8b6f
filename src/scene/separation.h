// Which column of a separated reading each emitter counts in (UPS_SEPARATE_*): one a source, or one a group. Made for a
// plan (transport) and for what results say of the columns (render).
#pragma once
#include <vector>

#include "scene/snapshot.h"
#include "ups/ups_render.h"

namespace ups {

struct Separation {
  std::vector<ups_source_info> columns;     // empty: nothing is told apart
  std::vector<uint32_t> column_of_emitter;  // by index in Snapshot::emitters; empty where columns is
};

Separation separate(const Snapshot& scene, ups_separation separation);

}  // namespace ups
