// Which triangles share an index? A scene too large for one index has its things grouped by place, so that who moves one
// thing has two groups to build and rays meet few groups. Asked by raytracer_build.cpp.
#pragma once
#include <cstdint>
#include <vector>

#include "geometry/box.h"

namespace ups {

inline constexpr size_t group_triangles = 1 << 14;  // of a group, at most, but for one thing that has more

struct Thing {
  Box box;
  size_t triangles;
  uint32_t number;  // that it keeps while others come and go; ascending
};

struct Grouping {
  std::vector<std::vector<uint32_t>> groups;  // indices of things, ascending
  std::vector<uint32_t> ungrouped;            // what spans the scene: as many triangles as a group's at most
};

// A function of the things alone: what a new scene is given an edited one has, too.
Grouping group_by_place(const std::vector<Thing>& things);

}  // namespace ups
