// Where a plane cuts the scene's surfaces. Called by api.
#pragma once
#include <vector>

#include "scene/snapshot.h"
#include "ups/ups_scene.h"

namespace ups {

// point, normal: in the program's frame, normal not zero.
std::vector<ups_segment> section(const Snapshot& scene, const Vec3d& point, const Vec3d& normal);

}  // namespace ups
