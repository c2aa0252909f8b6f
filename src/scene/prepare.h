// From what a program has added to what rendering reads: places everything about the scene's centre, builds the ray
// tracer, emitters and sensors, and finds the effects the scene can show. Called by ups_scene_commit.
#pragma once
#include <memory>

#include "base/parallel.h"
#include "scene/description.h"
#include "scene/snapshot.h"

namespace ups {

// Throws Error; the message names ids of the API. Renders that run keep the snapshot they started from.
std::shared_ptr<const Snapshot> prepare(const Description& description, ThreadPool& pool);

}  // namespace ups
