// Where does a point stand that is no surface's own: off which surface? Asked at commit by scene/prepare, for meters and
// sources.
#pragma once
#include "scene/snapshot.h"

namespace ups {

// Rounding of a free point, as for surface points.
inline float free_error(const Vec3& p) { return 16 * 0x1p-24f * max_abs(p); }

// How far p may be from where it should be, and from a surface that it lies on: p + n * 2 * error is in front of both.
float error_at(const Snapshot& scene, const Vec3& p, const Vec3& n);
// The same for a rectangle about p.
float error_at(const Snapshot& scene, const Vec3& p, const Vec3& n, const Vec3& half_a, const Vec3& half_b);
// Does most of such a rectangle lie on what lets no light by?
bool lies_on_opaque(const Snapshot& scene, const Vec3& p, const Vec3& n, const Vec3& half_a, const Vec3& half_b);
// A point of a surface that lies in the plane of a wall, too, as on an edge or in a corner: moved to the wall's front by
// what rounding makes, so that light from that side reaches it.
Vec3 off_walls(const Snapshot& scene, const Vec3& p, const Frame& frame);
// A source without extent that lies on a surface shines from that side of it to which nearly all of its light goes, or
// where that meets more.
struct SourcePlace {
  Vec3 p;
  float into_surface;  // share of the light that goes to the other side, of what is opaque
};
// At least, off a surface: shadow rays end this much before it at most, see segment_free (transport/encounter.h).
float least_source_lift(const Snapshot& scene);
SourcePlace off_surfaces(const Snapshot& scene, const Vec3& p, const Emitter& emitter);  // an emitter at p
// Does the light of an emitter on a plane through p, with normal n, belong to the plane's other side? By that rule.
bool shines_behind(const Snapshot& scene, const Emitter& emitter, const Vec3& p, const Vec3& n, float lift);
// From p towards u, beyond `least`: a way of `lift`, or half of that to what is met before twice as much.
float room_for(const Snapshot& scene, const Vec3& p, const Vec3& u, float least, float lift);

// Does the surface of an instance that emits lie in the plane of another's? Which of the two a ray meets is a matter of
// rounding.
bool lies_in_another(const Snapshot& scene, const Emitter& emitter, uint32_t instance);

// Another surface that so much of an instance's light starts behind, and lights something there, that it is worth
// telling, as it lies closer to the instance than rays start off that; none: there is no such.
uint32_t starts_beyond(const Snapshot& scene, const Emitter& emitter, uint32_t instance);

}  // namespace ups
