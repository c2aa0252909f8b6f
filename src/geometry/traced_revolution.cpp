// Surfaces of revolution as Embree's user geometry: a primitive is a sector of a band, so that its box is small; a ray
// that enters the box is tried against the whole band, so that none slips through between two sectors.
#include <limits>

#include "geometry/traced_mesh.h"

namespace ups {
namespace {

// About as wide as long, so that boxes overlap little; round ones are kept narrower, so that little of a box is empty.
uint32_t sector_count(const RevolutionBand& band) {
  constexpr double least_flat = 4, least_round = 16, most = 256;
  const double least = band.from_z == band.to_z ? least_flat : least_round;
  const double aspect = 3.14159265 * (band.from_r + band.to_r) / band.length();
  return 4 * uint32_t(std::ceil(std::clamp(aspect, least, most) / 4));
}

void bounds(const RTCBoundsFunctionArguments* args) {
  const TracedMesh& mesh = *static_cast<const TracedMesh*>(args->geometryUserPtr);
  const Revolution& shape = *mesh.source->revolution;
  const TracedMesh::Piece& piece = mesh.pieces[args->primID];
  const RevolutionHull h = hull(shape, shape.bands[piece.band], piece.sector, piece.sectors);
  RTCBounds& out = *args->bounds_o;
  out.lower_x = out.lower_y = out.lower_z = INFINITY;
  out.upper_x = out.upper_y = out.upper_z = -INFINITY;
  // Floats next to the doubles, on the outer side.
  const auto below = [](double v) { return std::nextafter(float(v), -INFINITY); };
  const auto above = [](double v) { return std::nextafter(float(v), INFINITY); };
  for (const Vec3d& corner : h.p) {
    const Vec3d p = mesh.to_frame.point(corner);
    out.lower_x = std::min(out.lower_x, below(p.x)), out.upper_x = std::max(out.upper_x, above(p.x));
    out.lower_y = std::min(out.lower_y, below(p.y)), out.upper_y = std::max(out.upper_y, above(p.y));
    out.lower_z = std::min(out.lower_z, below(p.z)), out.upper_z = std::max(out.upper_z, above(p.z));
  }
}

bool hit_band(const void* geometry, uint32_t primitive, const RTCRay& ray, double near, RevolutionHit& hit) {
  const TracedMesh& mesh = *static_cast<const TracedMesh*>(geometry);
  const Revolution& shape = *mesh.source->revolution;
  const Vec3d o = mesh.from_frame.point({ray.org_x, ray.org_y, ray.org_z});
  const Vec3d d = mesh.from_frame.vector({ray.dir_x, ray.dir_y, ray.dir_z});
  return intersect(shape, shape.bands[mesh.pieces[primitive].band], o, d, near, ray.tfar, hit);
}

// By a mask. Curved parts have no UVs: it cuts all of one or nothing.
bool is_cut_out(const void* geometry, const embree::PlainContext* context) {
  const TracedMesh& mesh = *static_cast<const TracedMesh*>(geometry);
  const SurfaceTexturing* t = mesh.has_holes ? embree::holes_of(context, mesh) : nullptr;
  return t && t->alpha_mode == SurfaceTexturing::mask && t->alpha_at(Vec2()) < t->alpha_cutoff;
}

// Does the query's own filter, if it has one, let the hit stand?
bool stands(const RTCIntersectFunctionNArguments* args, RTCRayHit& query) {
  const RTCFilterFunctionN filter = embree::filter_of(args->context);
  if (!filter) return true;
  int valid = -1;
  RTCFilterFunctionNArguments asked;
  asked.valid = &valid;
  asked.geometryUserPtr = args->geometryUserPtr;
  asked.context = args->context;
  asked.ray = reinterpret_cast<RTCRayN*>(&query.ray);
  asked.hit = reinterpret_cast<RTCHitN*>(&query.hit);
  asked.N = 1;
  filter(&asked);
  return valid == -1;
}

void intersect_one(const RTCIntersectFunctionNArguments* args) {
  if (args->valid[0] != -1) return;
  const TrapsSet traps;
  if (is_cut_out(args->geometryUserPtr, args->context)) return;
  RTCRayHit& query = *reinterpret_cast<RTCRayHit*>(args->rayhit);
  const RTCRayHit before = query;
  RevolutionHit hit;
  for (double near = before.ray.tnear; hit_band(args->geometryUserPtr, args->primID, before.ray, near, hit);
       near = hit.t) {
    query.ray.tfar = float(hit.t);
    query.hit.primID = hit.primitive;
    query.hit.geomID = args->geomID;
    query.hit.instID[0] = args->context->instID[0];
    query.hit.u = hit.u, query.hit.v = hit.v;
    if (stands(args, query)) return;
    query = before;
  }
}

void occlude_one(const RTCOccludedFunctionNArguments* args) {
  if (args->valid[0] != -1) return;
  const TrapsSet traps;
  if (is_cut_out(args->geometryUserPtr, args->context)) return;
  RTCRay& ray = *reinterpret_cast<RTCRay*>(args->ray);
  RevolutionHit hit;
  if (hit_band(args->geometryUserPtr, args->primID, ray, ray.tnear, hit))
    ray.tfar = -std::numeric_limits<float>::infinity();
}

}  // namespace

void cut_into_pieces(TracedMesh& mesh) {
  const Revolution& shape = *mesh.source->revolution;
  for (uint32_t band = 0; band < shape.bands.size(); ++band) {
    const uint32_t sectors = sector_count(shape.bands[band]);
    for (uint32_t sector = 0; sector < sectors; ++sector) mesh.pieces.push_back({band, sector, sectors});
  }
}

RTCGeometry make_revolution_geometry(embree::Device& device, const TracedMesh& mesh) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_USER);
  device.check();
  void* readable = const_cast<TracedMesh*>(&mesh);  // which comes back to readers alone
  rtcSetGeometryUserPrimitiveCount(geometry, unsigned(mesh.pieces.size()));
  rtcSetGeometryUserData(geometry, readable);
  rtcSetGeometryBoundsFunction(geometry, &bounds, readable);
  rtcSetGeometryIntersectFunction(geometry, &intersect_one);
  rtcSetGeometryOccludedFunction(geometry, &occlude_one);
  return geometry;
}

}  // namespace ups
