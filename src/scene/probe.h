// What does the emitters' light meet first? Asked at commit.
#pragma once
#include "base/parallel.h"
#include "scene/snapshot.h"

namespace ups {

// Where light of an emitter meets a surface first; numbers of its own for each i.
struct FirstLight {
  double flux = 0;          // 0: nothing was emitted
  double intensity_cd = 0;  // of the whole emitter, towards where it went
  Vec3 origin, direction;
  float lift = 0;  // of the origin off the emitter
  bool hit = false;
  SurfacePoint surface;
};
FirstLight first_light(const Snapshot& scene, const Emitter& emitter, uint32_t i);

// Of all emitters but directional ones, whose flux is that of the whole scene's disc.
double lamps_lm(const EmitterSet& emitters);

// Of more than `most` emitters the strong ones, and every other that stands for the rest; else all. In order.
std::vector<uint32_t> some_emitters(const EmitterSet& emitters, size_t most);

// The share of an emitter's flux that meets a surface with a diffuse or glossy lobe first, or none at all: what is left
// goes to mirrors and clear glass, where next-event estimation cannot pick it up. From a fixed set of directions.
float exposed_share(const Snapshot& scene, const Emitter& emitter);

// How small the patches are that an emitter's light meets first, straight or by way of a flat mirror, of the emitter for
// which they are smallest: the integral of E^2 over their area times the area that they can light, over the squared flux
// (of the sun's, that which the mirror reflects); from a fixed set of rays. About 2 in a room that is lit evenly. Eye
// paths that scatter find such a patch by chance alone, once in about so many.
// probes: by emitter; what they know is not found again, and what is found is added to them.
float first_light_concentration(const Snapshot& scene, std::vector<EmitterProbe>& probes, ThreadPool& pool);

}  // namespace ups
