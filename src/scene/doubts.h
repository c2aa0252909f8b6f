// What a scene may hold but hardly anyone means: triangles without area, lengths in another unit than metres. Asked at
// commit by scene/prepare, for warnings.
#pragma once
#include <cstdint>

#include "base/parallel.h"
#include "scene/snapshot.h"

namespace ups {

// Thinner than a float can tell at their length.
struct FlatTriangles {
  size_t count = 0, meshes = 0;
  uint32_t mesh = none, triangle = 0;  // the first; index in the snapshot
};
FlatTriangles find_flat_triangles(const Snapshot& scene, ThreadPool& pool);

// Illuminance, lx, where the light of luminaires and lights is brightest of what it meets first, from a few rays of
// each; < 0: there are none, or their light meets nothing. Emissive surfaces and directional lights do not count: what
// they give is the same whatever the unit of length.
double brightest_first_light_lx(const Snapshot& scene);

}  // namespace ups
