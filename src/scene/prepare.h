// From what a program has added to what rendering reads: places everything about the scene's centre, builds the ray
// tracer, emitters and sensors, and finds the effects the scene can show. Called by ups_scene_commit.
#pragma once
#include <memory>

#include "base/monitor.h"
#include "base/parallel.h"
#include "scene/description.h"
#include "scene/snapshot.h"

namespace ups {

// Throws Error; the message names ids of the API. Renders that run keep the snapshot they started from.
//
// earlier: an earlier build of the same scene, or null. What depends on nothing that has changed since is shared:
//   part                                  depends on
//   origin, extent                        the power of two of the bounds of all
//   tables of a material                  its description, its textures
//   index of a mesh or group              mesh, transform, origin, whether it has holes; with flat emitters `extent`
//   the ray tracer above                  those of all instances; whether glass nests, or an emitter touches some
//   what emitters touch                   their placement, that of glass around them; extent, radius
//   media, panes                          ray tracer, materials; panes: what emits, radius
//   place and error of an emitter         its own placement; ray tracer, radius
//   its exposed share, concentration      the same; materials
//   emitters, light tree                  always built; an emissive instance that stays the same is shared
//   a meter set                           its description; ray tracer, radius
//   media of meters and cameras           the same; materials
//   effects                               always found
//   searched warnings                     of surfaces: ray tracer, materials; of light: emitters' placement, too
// All that is found is a function of the description alone, so that the bits are those of a build without `earlier`.
// monitor: null, or told of the progress; throws Cancelled.
std::shared_ptr<const Snapshot> prepare(const Description& description, ThreadPool& pool,
                                        const std::shared_ptr<const Snapshot>& earlier = nullptr,
                                        Monitor* monitor = nullptr);

}  // namespace ups
