// What does a ray hit, and what is the surface like there? Embree finds the triangle; positions, normals and the error
// bound come from here, so that both walks of a path see the same point. Called by transport and by scene/prepare.
#include "geometry/raytracer.h"

#include <algorithm>
#include <limits>
#include <tuple>
#include <utility>

#include "base/per_thread.h"
#include "base/prefetch.h"
#include "geometry/raytracer_impl.h"

namespace ups {
namespace {

constexpr float min_side_cosine = 1e-3f;

}  // namespace

float SurfaceTexturing::alpha_at(const Vec2& uv) const { return alpha ? alpha->last(uv) * alpha_factor : alpha_factor; }

Raytracer::~Raytracer() = default;

// ---- rays ----

bool Raytracer::Impl::grazes(const Placed& instance, const Vec3& ng, const Vec3& d) {
  constexpr float grazing = 1e-3f;
  const Vec3 n = instance.baked ? ng : Vec3(normalize(instance.normals * Vec3d(ng)));
  const float along = dot(n, d);
  return along * along < grazing * grazing * dot(n, n);
}

// Embree's distance along a ray that runs nearly within the triangle's plane can be anything (its issue 387), and the
// barycentrics of a thin triangle off by centimetres: float areas of slivers. Does nothing to others.
void Raytracer::Impl::refine(const Vec3& ng, const Vec3& o, const Vec3& d, Hit& hit) const {
  const Placed& instance = placed[hit.instance];
  const TracedMesh& mesh = *traced[instance.traced];
  if (mesh.source->revolution || !(mesh.has_thin || grazes(instance, ng, d))) return;
  const Triangle met = triangle(instance, hit.primitive);
  double weights[3], t, sum = 0;
  constexpr double outside = 1e-2;  // beyond that the ray runs so close to the plane that no answer is better
  const bool told = meet_plane(met, Vec3d(o), Vec3d(d), weights, t) && t > 0 &&
                    std::all_of(weights, weights + 3, [](double w) { return w >= -outside && w <= 1 + outside; });
  if (!told) {
    const Vec3d named = met.sum({1.0 - hit.u - hit.v, double(hit.u), double(hit.v)});
    hit.t = std::max(float(dot(named - Vec3d(o), Vec3d(d))), std::numeric_limits<float>::min());
    return;
  }
  for (double& w : weights) sum += w = std::clamp(w, 0.0, 1.0);
  hit.t = float(t);
  hit.u = float(weights[1] / sum);
  hit.v = float(weights[2] / sum);
}

Hit Raytracer::Impl::to_hit(const RTCHit& from, float t, const Vec3& o, const Vec3& d) const {
  Hit hit;
  hit.t = t;
  hit.instance = instance_of(from);
  const TracedMesh& mesh = *traced[placed[hit.instance].traced];
  hit.primitive = mesh.primitive(from.primID);
  prefetch(mesh.source->indices.data() + 3 * size_t(hit.primitive));
  if (!mesh.facets.empty()) prefetch(mesh.facets.data() + hit.primitive);
  hit.u = from.u;
  hit.v = from.v;
  refine({from.Ng_x, from.Ng_y, from.Ng_z}, o, d, hit);
  return hit;
}

bool Raytracer::intersect(const Vec3& o, const Vec3& d, float tmax, Hit& hit) const {
  embree::QueryContext context;
  context.holes = &impl_->holes;
  RTCRayHit query;
  query.ray = embree::make_ray(o, d, tmax);
  query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(*impl_->top, context, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  hit = impl_->to_hit(query.hit, query.ray.tfar, o, d);
  return true;
}

namespace {

struct AllHits {
  embree::QueryContext context;  // first: Embree hands back a pointer to it
  std::vector<std::pair<RTCHit, float>> found;
  bool out_of_memory;
};

// Rejects what it notes, so that Embree goes on to the next.
void note_hit(const RTCFilterFunctionNArguments* args) {
  if (args->valid[0] != -1) return;
  AllHits& all = *reinterpret_cast<AllHits*>(args->context);
  try {
    all.found.emplace_back(*reinterpret_cast<const RTCHit*>(args->hit),
                           reinterpret_cast<const RTCRay*>(args->ray)->tfar);
  } catch (...) {  // must not pass through Embree, which would keep it to itself
    all.out_of_memory = true;
  }
  args->valid[0] = 0;
}

}  // namespace

void Raytracer::intersect_all(const Vec3& o, const Vec3& d, float tmax, std::vector<Hit>& out) const {
  static const PerThread<AllHits> kept;
  AllHits& all = kept.get();
  all.context = {};
  all.context.holes = &impl_->holes;
  all.found.clear();
  all.out_of_memory = false;
  RTCRayHit query;
  query.ray = embree::make_ray(o, d, tmax);
  query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(*impl_->top, all.context, query, &note_hit);
  if (all.out_of_memory) throw std::bad_alloc();
  const size_t first = out.size();
  for (const auto& [hit, t] : all.found) out.push_back(impl_->to_hit(hit, t, o, d));
  const auto order = [](const Hit& h) { return std::make_tuple(h.t, h.instance, h.primitive); };
  std::sort(out.begin() + ptrdiff_t(first), out.end(),
            [&](const Hit& a, const Hit& b) { return order(a) < order(b); });
  // Each sector of a band finds all hits of it.
  out.erase(std::unique(out.begin() + ptrdiff_t(first), out.end(),
                        [&](const Hit& a, const Hit& b) { return order(a) == order(b); }),
            out.end());
}

bool Raytracer::occluded(const Vec3& o, const Vec3& d, float tmax) const {
  embree::QueryContext context;
  context.holes = &impl_->holes;
  RTCRay ray = embree::make_ray(o, d, tmax);
  embree::occluded(*impl_->top, context, ray);
  return ray.tfar < 0;
}

bool Raytracer::visible(const SurfacePoint& a, const SurfacePoint& b) const {
  const Vec3 d = b.p - a.p;
  const Vec3 o = a.ray_origin(d), segment = b.ray_origin(-d) - o;
  const float distance = length(segment);
  if (!(distance > 0) || dot(segment, d) <= 0) return true;  // closer than their errors: nothing fits in between
  return !occluded(o, segment / distance, distance);
}

bool Raytracer::visible(const SurfacePoint& a, const Vec3& b, float b_error) const {
  const Vec3 o = a.ray_origin(b - a.p), segment = b - o;
  const float distance = length(segment);
  if (!(distance > b_error)) return true;
  return !occluded(o, segment / distance, distance - b_error);
}

// ---- surface points ----

// The shading normal from vertex normals and the normal texture; false where there is none to use.
bool Raytracer::Impl::normal_at(const Placed& instance, const SurfacePoint& point, Vec3& out) const {
  const Mesh& mesh = *traced[instance.traced]->source;
  const uint32_t* i = &mesh.indices[3 * size_t(point.primitive)];
  const Texture* bumps = bumps_of(instance);
  if (mesh.normals.empty() && !bumps) return false;
  Vec3d n(point.ng);
  if (!mesh.normals.empty()) {
    const Vec3 at = interpolate(mesh.normals[i[0]], mesh.normals[i[1]], mesh.normals[i[2]], point.u, point.v);
    n = instance.normals * Vec3d(at) * instance.side;
    const double size = length(n);
    if (!(size > 0)) return false;
    n = n / size;
    if (dot(n, Vec3d(point.ng)) < 0) n = -n;  // files whose winding and normals disagree
  }
  Vec3d tangent, bitangent;
  if (bumps && tangents_at(mesh, i, point, instance.to_scene, instance.side, triangle(instance, point.primitive), n,
                           tangent, bitangent)) {
    const Rgb texel = bumps->rgb(point.uv);
    const double scale = texturing[instance.material].normal_scale;
    n = tangent * ((2.0 * texel.r - 1) * scale) + bitangent * ((2.0 * texel.g - 1) * scale) + n * (2.0 * texel.b - 1);
    const double size = length(n);
    if (!(size > 0)) return false;
    n = n / size;
  }
  if (!(dot(n, Vec3d(point.ng)) > min_side_cosine)) return false;
  out = Vec3(n);
  return true;
}

// Of a surface of revolution; error and address are there.
void Raytracer::Impl::place_on_revolution(const Placed& instance, const Revolution& revolution,
                                          SurfacePoint& point) const {
  const RevolutionPoint at =
      point_at(revolution, point.primitive, double(point.u), double(point.v), double(point.error));
  const Vec3d n = instance.normals * at.n * instance.side;
  const double size = length(n);
  point.p = Vec3(instance.to_scene.point(at.p));
  point.ng = size > 0 ? Vec3(n / size) : Vec3(0, 0, 1);
  point.shading = Frame(point.ng);
}

// The normal of a triangle of its own frame; false at an edge, or without area. low: the least weight.
bool Raytracer::Impl::place_within(const Placed& instance, const Triangle& own, double low, double longest_edge,
                                   SurfacePoint& point) {
  const Vec3d area_normal = own.area_normal();
  if (!(low * instance.least_stretch * length(area_normal) > double(point.error) * longest_edge)) return false;
  point.ng = Vec3(normalize(instance.normals * area_normal * instance.side));
  return true;
}

// At an edge, or of a sliver, where such figures are too coarse. weights: of the vertices.
void Raytracer::Impl::place_by_edges(const Placed& instance, double (&weights)[3], SurfacePoint& point) const {
  const Triangle met = triangle(instance, point.primitive);
  const Vec3d area_normal = met.area_normal() * instance.side;
  const double area = length(area_normal);
  point.ng = area > 0 ? Vec3(area_normal / area) : Vec3(0, 0, 1);
  keep_off_edges(met, area, std::sqrt(met.longest_edge2()), double(point.error), weights);
  point.p = Vec3(met.sum(weights) / (weights[0] + weights[1] + weights[2]));
}

SurfacePoint Raytracer::surface_at(uint32_t instance, uint32_t primitive, float u, float v) const {
  const Impl::Placed& placed = impl_->placed[instance];
  const TracedMesh& traced = *impl_->traced[placed.traced];
  const Mesh& mesh = *traced.source;
  const Facet* facet = traced.facets.empty() ? nullptr : &traced.facets[primitive];
  const bool is_flat = facet && facet->is_flat;
  if (!mesh.normals.empty() && !is_flat)
    for (int k = 0; k < 3; ++k) prefetch(&mesh.normals[mesh.indices[3 * size_t(primitive) + k]]);
  const Triangle own = traced.triangle(primitive);  // in the frame of the traced mesh
  SurfacePoint point;
  point.instance = instance, point.primitive = primitive;
  point.u = u, point.v = v;
  point.material = placed.material;
  point.uv = uv_at(mesh, primitive, u, v);
  double weights[3] = {1 - double(u) - double(v), double(u), double(v)};
  const Vec3d named = own.sum(weights);
  point.p = Vec3(placed.baked ? named : placed.to_scene.point(named));
  const double longest_edge = facet ? double(facet->longest_edge) : std::sqrt(own.longest_edge2());
  const float extent = max_abs(point.p) + float(longest_edge * placed.most_stretch);
  point.error = gamma_error * (placed.error_scale * extent + placed.error_offset);
  if (mesh.revolution) {
    impl_->place_on_revolution(placed, *mesh.revolution, point);
    return point;
  }
  const double low = std::min({weights[0], weights[1], weights[2]}), inset = double(point.error);
  if (facet && low * double(facet->low_height) >= inset)
    point.ng = placed.side < 0 ? -facet->ng : facet->ng;
  else if (facet || !impl_->place_within(placed, own, low, longest_edge, point))
    impl_->place_by_edges(placed, weights, point);
  Vec3 n = point.ng;
  if (!is_flat || impl_->bumps_of(placed)) impl_->normal_at(placed, point, n);
  point.shading = Frame(n);
  return point;
}

SurfacePoint Raytracer::surface_at(const Hit& hit) const {
  return surface_at(hit.instance, hit.primitive, hit.u, hit.v);
}

Raytracer::Chart Raytracer::chart_at(const SurfacePoint& point) const {
  constexpr double least_area2 = 1e-100, most = 1e12;  // a mapping as steep as that says nothing in floats
  const Impl::Placed& placed = impl_->placed[point.instance];
  const Mesh& mesh = *impl_->traced[placed.traced]->source;
  if (mesh.uvs.empty() || mesh.revolution) return {};
  const Triangle triangle = impl_->triangle(placed, point.primitive);
  const Vec3d to_1 = triangle.p[1] - triangle.p[0], to_2 = triangle.p[2] - triangle.p[0], n = cross(to_1, to_2);
  const double area2 = length2(n);
  if (!(area2 > least_area2)) return {};
  const Vec3d along_1 = cross(to_2, n) / area2, along_2 = cross(n, to_1) / area2;  // gradients of the barycentrics
  const auto uv = [&](int k) { return mesh.uvs[mesh.indices[3 * size_t(point.primitive) + size_t(k)]]; };
  const auto gradient = [&](float Vec2::*c) {
    const double at_0 = double(uv(0).*c);
    return along_1 * (double(uv(1).*c) - at_0) + along_2 * (double(uv(2).*c) - at_0);
  };
  const Vec3d u = gradient(&Vec2::x), v = gradient(&Vec2::y);
  if (!(std::max(max_abs(u), max_abs(v)) < most)) return {};
  return {Vec3(u), Vec3(v)};
}

void Raytracer::each_triangle(const std::function<void(const Vec3d (&)[3])>& visit) const {
  for (const Impl::Placed& instance : impl_->placed) {
    const size_t count = impl_->traced[instance.traced]->source->triangle_count();
    for (uint32_t t = 0; t < count; ++t) visit(impl_->triangle(instance, t).p);
  }
}

size_t Raytracer::bytes() const {
  size_t sum = impl_->device->bytes() + impl_->placed.capacity() * sizeof(Impl::Placed);
  for (const auto& traced : impl_->traced) sum += traced->bytes();
  return sum;
}

size_t Raytracer::triangle_count() const { return impl_->triangles; }
Vec3 Raytracer::bounds_min() const { return Vec3(impl_->bounds.lower); }
Vec3 Raytracer::bounds_max() const { return Vec3(impl_->bounds.upper); }

}  // namespace ups
