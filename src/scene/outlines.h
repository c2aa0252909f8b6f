// What lies beneath a plane as a plan shows it: the edges of surfaces that are seen from the plane. Called by api.
#pragma once
#include <vector>

#include "scene/snapshot.h"
#include "ups/ups_scene.h"

namespace ups {

// point, normal: in the program's frame, normal not zero; depth: m, > 0.
std::vector<ups_segment> outlines(const Snapshot& scene, const Vec3d& point, const Vec3d& normal, double depth);

}  // namespace ups
