// Where does a point stand that is no surface's own: off which surface? And what does the emitters'
// light meet first? Asked at commit by scene/prepare, for meters, cameras and luminaires.
#pragma once
#include "base/parallel.h"
#include "scene/snapshot.h"

namespace ups {

// Rounding of a free point, as for surface points.
inline float free_error(const Vec3& p) { return 16 * 0x1p-24f * max_abs(p); }

// How far p may be from where it should be, and from a surface that it lies on: p + n * 2 * error is in front of both.
float error_at(const Snapshot& scene, const Vec3& p, const Vec3& n);
// The same for a rectangle about p.
float error_at(const Snapshot& scene, const Vec3& p, const Vec3& n, const Vec3& half_a, const Vec3& half_b);
// A point of a surface that lies in the plane of a wall, too, as on an edge or in a corner: moved to the wall's front by
// what rounding makes, so that light from that side reaches it.
Vec3 off_walls(const Snapshot& scene, const Vec3& p, const Frame& frame);
// A source without extent that lies on a surface shines from that side of it to which nearly all of its light goes, or
// where that meets more.
struct SourcePlace {
  Vec3 p;
  float into_surface;  // share of the light that goes to the other side, of what is opaque
};
SourcePlace off_surfaces(const Snapshot& scene, const Vec3& p, const Emitter& emitter);  // an emitter at p

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

// Does the surface of an instance that emits lie in the plane of another's? Which of the two a ray meets is a matter of
// rounding.
bool lies_in_another(const Snapshot& scene, const Emitter& emitter, uint32_t instance);

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
