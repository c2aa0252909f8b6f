// Whose light is swallowed at once? A luminaire a hair above the ceiling, within a wall or its own housing, or close to
// a surface that it faces, lights nothing of the room, which is seldom meant. Asked at commit by scene/prepare.
#pragma once
#include <cstdint>
#include <vector>

#include "base/parallel.h"
#include "base/vec.h"
#include "scene/snapshot.h"

namespace ups {

struct SwallowedLight {
  enum Kind {
    no,
    in_gap,   // it meets an opaque surface within a gap that is nothing beside the luminaire and the room
    shut_in,  // it stays in a narrow space
  } kind = no;
  uint32_t instance = none;  // what it meets first, by index
  bool from_behind = false;
  float gap_m = 0;  // in_gap: between source and surface
  Vec3 extent_m;    // shut_in: of the space
};

// By index of the emitter. The same for any number of threads.
std::vector<SwallowedLight> find_swallowed_light(const Snapshot& scene, ThreadPool& pool);

}  // namespace ups
