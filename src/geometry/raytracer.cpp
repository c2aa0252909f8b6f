// What does a ray hit, and what is the surface like there? Embree finds the triangle; positions, normals and the error
// bound come from here, so that both walks of a path see the same point. Called by transport and by scene/prepare.
#include "geometry/raytracer.h"

#include <cstring>
#include <limits>

#include "base/rng.h"
#include "geometry/embree.h"

namespace ups {
namespace {

// Of (|p| + longest edge): rounding of p, of the vertices, and of Embree's own distance to the plane (tests/geometry
// has boxes at several scales and offsets, and counts hits of the surface that a ray has just left).
constexpr float gamma_error = 16 * 0x1p-24f;
// A triangle lower than this share of its longest edge can be "hit" far from where it is (Embree issue 387).
constexpr double thin_share = 1e-3;
// Embree takes rays into an instance's frame in float. Where that would lose many digits the instance is baked: a
// transform that stretches one way more than another by max_stretch, or a translation beyond max_reach times the
// scene's extent.
constexpr double max_stretch = 4, max_reach = 4;
constexpr float min_side_cosine = 1e-3f;

struct Triangle {
  Vec3d p[3];
  Vec3d area_normal() const { return cross(p[1] - p[0], p[2] - p[0]); }
  double longest_edge2() const { return std::max({length2(p[1] - p[0]), length2(p[2] - p[1]), length2(p[0] - p[2])}); }
  Vec3d at(double u, double v) const { return p[0] * (1 - u - v) + p[1] * u + p[2] * v; }
};

// A mesh as Embree holds it: in the scene's frame where baked, else in its own.
struct Geometry {
  const Mesh* mesh = nullptr;
  const SurfaceTexturing* texturing = nullptr;
  std::vector<Vec3> positions;       // one more than used: Embree reads 16 bytes at a time
  bool complete = true;              // every triangle has an area; else these are the ones that do:
  std::vector<uint32_t> primitives;  // their numbers in the mesh
  std::vector<uint32_t> indices;     // their vertices
  bool has_thin = false;

  uint32_t primitive(uint32_t embree_primitive) const {
    return complete ? embree_primitive : primitives[embree_primitive];
  }
  Triangle triangle(uint32_t primitive) const {
    const uint32_t* i = &mesh->indices[3 * size_t(primitive)];
    return {{Vec3d(positions[i[0]]), Vec3d(positions[i[1]]), Vec3d(positions[i[2]])}};
  }
};

Vec3 interpolate(const Vec3& a, const Vec3& b, const Vec3& c, float u, float v) {
  return a * (1 - u - v) + b * u + c * v;
}

Vec2 uv_at(const Mesh& mesh, uint32_t primitive, float u, float v) {
  if (mesh.uvs.empty()) return {};
  const uint32_t* i = &mesh.indices[3 * size_t(primitive)];
  const Vec2 &a = mesh.uvs[i[0]], &b = mesh.uvs[i[1]], &c = mesh.uvs[i[2]];
  const float w = 1 - u - v;
  return {w * a.x + u * b.x + v * c.x, w * a.y + u * b.y + v * c.y};
}

// ---- holes and false hits: Embree's filter ----

uint64_t bits_of(float a, float b) {
  uint32_t x, y;
  std::memcpy(&x, &a, 4);
  std::memcpy(&y, &b, 4);
  return uint64_t(x) << 32 | y;
}

bool is_hole(const Geometry& geometry, uint32_t primitive, const RTCRay& ray, float u, float v) {
  const SurfaceTexturing& t = *geometry.texturing;
  const float texel = t.alpha ? t.alpha->last(uv_at(*geometry.mesh, primitive, u, v)) : 1.0f;
  const float alpha = texel * t.alpha_factor;
  if (t.alpha_mode == SurfaceTexturing::mask) return alpha < t.alpha_cutoff;
  // Blended: let a share of the rays through; the same ray always decides the same way.
  uint64_t h = hash_combine(bits_of(ray.org_x, ray.org_y), bits_of(ray.org_z, ray.dir_x));
  h = hash_combine(hash_combine(h, bits_of(ray.dir_y, ray.dir_z)), primitive);
  return to_unit_float(uint32_t(h >> 32)) >= alpha;
}

// Where the line o + t d meets the triangle's plane, in double: weights of the three vertices.
bool meet_plane(const Triangle& triangle, const Vec3d& o, const Vec3d& d, double (&weights)[3], double& t) {
  const Vec3d e1 = triangle.p[1] - triangle.p[0], e2 = triangle.p[2] - triangle.p[0], from = o - triangle.p[0];
  const Vec3d across = cross(d, e2), normal = cross(from, e1);  // Moeller, Trumbore 1997
  const double det = dot(e1, across);
  if (det == 0) return false;
  weights[1] = dot(from, across) / det;
  weights[2] = dot(d, normal) / det;
  weights[0] = 1 - weights[1] - weights[2];
  t = dot(e2, normal) / det;
  return std::isfinite(t) && std::isfinite(weights[0]);
}

// A true hit has t between those of the vertices, and the line passes the triangle within rounding. Hits of thin
// triangles by near-parallel rays can fail both.
bool is_false_hit(const Triangle& triangle, const RTCRay& ray) {
  const Vec3d o(ray.org_x, ray.org_y, ray.org_z), d(ray.dir_x, ray.dir_y, ray.dir_z);
  const double size = length(d);
  double near = INFINITY, far = -INFINITY, reach = 0;
  for (const Vec3d& p : triangle.p) {
    const double t = dot(p - o, d) / size;
    near = std::min(near, t), far = std::max(far, t);
    reach = std::max(reach, length(p - o));
  }
  const double tolerance = 0x1p-18 * reach, distance = ray.tfar * size;
  if (distance < near - tolerance || distance > far + tolerance) return true;
  double weights[3], t;
  if (!meet_plane(triangle, o, d, weights, t)) return true;
  const Vec3d normal = triangle.area_normal();
  const double area = length(normal), cosine = std::abs(dot(normal, d)) / (area * size);
  for (int i = 0; i < 3; ++i) {
    const double height = area / length(triangle.p[(i + 2) % 3] - triangle.p[(i + 1) % 3]);
    if (-weights[i] * height * cosine > tolerance) return true;
  }
  return false;
}

void filter(const RTCFilterFunctionNArguments* args) {
  if (args->valid[0] != -1) return;
  const Geometry& geometry = *static_cast<const Geometry*>(args->geometryUserPtr);
  const RTCRay& ray = *reinterpret_cast<const RTCRay*>(args->ray);
  const RTCHit& hit = *reinterpret_cast<const RTCHit*>(args->hit);
  const uint32_t primitive = geometry.primitive(hit.primID);
  const bool reject = (geometry.has_thin && is_false_hit(geometry.triangle(primitive), ray)) ||
                      (geometry.texturing && is_hole(geometry, primitive, ray, hit.u, hit.v));
  if (reject) args->valid[0] = 0;
}

// ---- building ----

// Triangles without area have no normal: they stay out of Embree.
void sort_out_triangles(Geometry& geometry) {
  const size_t count = geometry.mesh->triangle_count();
  for (size_t i = 0; i < count; ++i) {
    const Triangle triangle = geometry.triangle(uint32_t(i));
    const double area2 = length2(triangle.area_normal()), edge2 = triangle.longest_edge2();
    if (area2 > 0) {
      if (area2 < thin_share * thin_share * edge2 * edge2) geometry.has_thin = true;
      geometry.primitives.push_back(uint32_t(i));
    }
  }
  geometry.complete = geometry.primitives.size() == count;
  if (geometry.complete) {
    geometry.primitives = {};
    return;
  }
  for (const uint32_t p : geometry.primitives)
    for (int k = 0; k < 3; ++k) geometry.indices.push_back(geometry.mesh->indices[3 * size_t(p) + size_t(k)]);
}

std::unique_ptr<Geometry> make_geometry(const Mesh& mesh, const std::vector<SurfaceTexturing>& texturing,
                                        const Affine* bake) {
  auto geometry = std::make_unique<Geometry>();
  geometry->mesh = &mesh;
  if (mesh.material < texturing.size() && texturing[mesh.material].alpha_mode != SurfaceTexturing::opaque)
    geometry->texturing = &texturing[mesh.material];
  geometry->positions.reserve(mesh.positions.size() + 1);
  for (const Vec3& p : mesh.positions) geometry->positions.push_back(bake ? Vec3(bake->point(Vec3d(p))) : p);
  geometry->positions.emplace_back();
  sort_out_triangles(*geometry);
  return geometry;
}

void attach_triangles(embree::Device& device, embree::Scene& scene, Geometry& geometry, uint32_t id) {
  const std::vector<uint32_t>& indices = geometry.complete ? geometry.mesh->indices : geometry.indices;
  if (indices.empty()) return;
  RTCGeometry triangles = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  device.check();
  rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, geometry.positions.data(), 0,
                             sizeof(Vec3), geometry.positions.size() - 1);
  rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices.data(), 0,
                             3 * sizeof(uint32_t), indices.size() / 3);
  rtcSetGeometryUserData(triangles, &geometry);
  if (geometry.texturing || geometry.has_thin) {
    rtcSetGeometryIntersectFilterFunction(triangles, &filter);
    rtcSetGeometryOccludedFilterFunction(triangles, &filter);
  }
  scene.attach(triangles, id);
}

// Largest over smallest stretch, at most: product of the Frobenius norms of the matrix and its inverse.
double stretch(const Affine& m) {
  double forward = 0, cofactor = 0;
  for (int c = 0; c < 3; ++c) {
    forward += length2(m.column(c));
    cofactor += length2(cross(m.column((c + 1) % 3), m.column((c + 2) % 3)));
  }
  const double det = std::abs(m.determinant());
  return det > 0 ? std::sqrt(forward * cofactor) / (3 * det) : std::numeric_limits<double>::infinity();
}

// Largest coordinate of a mesh after a transform, at most: that of its transformed box.
double extent(const Mesh& mesh, const Affine& m) {
  Vec3 lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};
  for (const Vec3& p : mesh.positions) {
    lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
    upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
  }
  if (mesh.positions.empty()) return 0;
  const Vec3 half = (upper - lower) * 0.5f;
  double reach = max_abs(m.point(Vec3d(lower + half)));
  for (int c = 0; c < 3; ++c) reach += max_abs(m.column(c)) * double(half[c]);
  return reach;
}

std::vector<bool> choose_baked(const std::vector<std::shared_ptr<const Mesh>>& meshes,
                               const std::vector<Raytracer::Instance>& instances) {
  std::vector<size_t> uses(meshes.size());
  double scene_extent = 0;
  for (const auto& i : instances) {
    ++uses[i.mesh];
    scene_extent = std::max(scene_extent, extent(*meshes[i.mesh], i.to_scene));
  }
  std::vector<bool> baked;
  for (const auto& i : instances)
    baked.push_back(uses[i.mesh] == 1 || stretch(i.to_scene) > max_stretch ||
                    max_abs(i.to_scene.column(3)) > max_reach * scene_extent);
  return baked;
}

}  // namespace

struct Raytracer::Impl {
  struct Placed {
    uint32_t geometry;
    bool baked;
    Affine to_scene;
    double side;                      // -1: the transform mirrors, so that winding and front part
    float error_offset, error_scale;  // error = gamma * (error_scale * (|p| + edge) + error_offset)
  };
  const std::vector<SurfaceTexturing>* texturing;
  std::vector<std::unique_ptr<Geometry>> geometries;
  std::vector<Placed> placed;
  embree::Device device;
  std::vector<std::unique_ptr<embree::Scene>> instanced;
  std::unique_ptr<embree::Scene> top;
  size_t triangles = 0;
  Vec3d lower{INFINITY, INFINITY, INFINITY}, upper{-INFINITY, -INFINITY, -INFINITY};

  Triangle triangle(const Placed& instance, uint32_t primitive) const {
    Triangle t = geometries[instance.geometry]->triangle(primitive);
    if (!instance.baked)
      for (Vec3d& p : t.p) p = instance.to_scene.point(p);
    return t;
  }
  void grow_bounds(const Placed& instance) {
    const Geometry& geometry = *geometries[instance.geometry];
    for (size_t i = 0; i + 1 < geometry.positions.size(); ++i) {
      const Vec3d q(geometry.positions[i]), p = instance.baked ? q : instance.to_scene.point(q);
      lower = {std::min(lower.x, p.x), std::min(lower.y, p.y), std::min(lower.z, p.z)};
      upper = {std::max(upper.x, p.x), std::max(upper.y, p.y), std::max(upper.z, p.z)};
    }
  }
  void place_baked(const Mesh& mesh, uint32_t id, Placed instance) {
    instance.geometry = uint32_t(geometries.size());
    instance.baked = true;
    instance.error_offset = 0, instance.error_scale = 1;
    geometries.push_back(make_geometry(mesh, *texturing, &instance.to_scene));
    attach_triangles(device, *top, *geometries.back(), id);
    placed.push_back(instance);
  }
  void place_instanced(RTCScene scene, uint32_t geometry, uint32_t id, Placed instance) {
    instance.geometry = geometry;
    instance.baked = false;
    // Embree takes rays to the object's frame in float: it loses digits of the translation, and more where stretched.
    const Affine& m = instance.to_scene;
    instance.error_scale = float(2 * std::max(1.0, stretch(m)));
    instance.error_offset = instance.error_scale * float(max_abs(m.column(3)));
    float columns[12];
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 3; ++r) columns[3 * c + r] = float(m.m[4 * r + c]);
    RTCGeometry geometry_handle = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE);
    device.check();
    rtcSetGeometryInstancedScene(geometry_handle, scene);
    rtcSetGeometryTransform(geometry_handle, 0, RTC_FORMAT_FLOAT3X4_COLUMN_MAJOR, columns);
    top->attach(geometry_handle, id);
    placed.push_back(instance);
  }
  // Embree's barycentrics of a thin triangle can be off by centimetres: float areas of slivers. Does nothing to others.
  void refine(const Vec3& o, const Vec3& d, Hit& hit) const {
    const Placed& instance = placed[hit.instance];
    if (!geometries[instance.geometry]->has_thin) return;
    double weights[3], t, sum = 0;
    if (!meet_plane(triangle(instance, hit.primitive), Vec3d(o), Vec3d(d), weights, t) || !(t > 0)) return;
    constexpr double outside = 1e-2;  // beyond that the ray runs so close to the plane that no answer is better
    for (const double w : weights)
      if (w < -outside || w > 1 + outside) return;
    for (double& w : weights) sum += w = std::clamp(w, 0.0, 1.0);
    hit.t = float(t);
    hit.u = float(weights[1] / sum);
    hit.v = float(weights[2] / sum);
  }
  bool normal_at(const Placed& instance, const SurfacePoint& point, const Triangle& triangle, Vec3& out) const;
};

Raytracer::Raytracer(const std::vector<std::shared_ptr<const Mesh>>& meshes, const std::vector<Instance>& instances,
                     const std::vector<SurfaceTexturing>& texturing, int thread_count)
    : impl_(std::make_unique<Impl>()) {
  Impl& impl = *impl_;
  impl.texturing = &texturing;
  impl.top = std::make_unique<embree::Scene>(impl.device);
  tbb::task_arena arena(thread_count > 0 ? thread_count : tbb::task_arena::automatic);
  const std::vector<bool> baked = choose_baked(meshes, instances);
  std::vector<std::pair<RTCScene, uint32_t>> shared(meshes.size());  // a mesh's own scene, and its geometry
  for (size_t i = 0; i < instances.size(); ++i) {
    const Instance& instance = instances[i];
    const Mesh& mesh = *meshes[instance.mesh];
    Impl::Placed placed{};
    placed.to_scene = instance.to_scene;
    placed.side = instance.to_scene.determinant() < 0 ? -1 : 1;
    if (baked[i]) {
      impl.place_baked(mesh, uint32_t(i), placed);
    } else {
      auto& [scene, geometry] = shared[instance.mesh];
      if (!scene) {
        geometry = uint32_t(impl.geometries.size());
        impl.geometries.push_back(make_geometry(mesh, texturing, nullptr));
        impl.instanced.push_back(std::make_unique<embree::Scene>(impl.device));
        attach_triangles(impl.device, *impl.instanced.back(), *impl.geometries.back(), 0);
        impl.instanced.back()->commit(arena);
        scene = *impl.instanced.back();
      }
      impl.place_instanced(scene, geometry, uint32_t(i), placed);
    }
    impl.grow_bounds(impl.placed.back());
    impl.triangles += mesh.triangle_count();
  }
  impl.top->commit(arena);
}

Raytracer::~Raytracer() = default;

// ---- rays ----

bool Raytracer::intersect(const Vec3& o, const Vec3& d, float tmax, Hit& hit) const {
  embree::QueryContext context;
  embree::init(context);
  RTCRayHit query;
  query.ray = embree::make_ray(o, d, tmax);
  query.hit.geomID = query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  embree::intersect(*impl_->top, context, query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return false;
  const bool baked = query.hit.instID[0] == RTC_INVALID_GEOMETRY_ID;
  hit.t = query.ray.tfar;
  hit.instance = baked ? query.hit.geomID : query.hit.instID[0];
  hit.primitive = impl_->geometries[impl_->placed[hit.instance].geometry]->primitive(query.hit.primID);
  hit.u = query.hit.u;
  hit.v = query.hit.v;
  impl_->refine(o, d, hit);
  return true;
}

bool Raytracer::occluded(const Vec3& o, const Vec3& d, float tmax) const {
  embree::QueryContext context;
  embree::init(context);
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

namespace {

// Tangent and bitangent of the texture's u axis and of its upward direction, which is -v in glTF.
bool tangents_at(const Mesh& mesh, const uint32_t* i, const SurfacePoint& point, const Affine& to_scene, double side,
                 const Triangle& triangle, const Vec3d& n, Vec3d& tangent, Vec3d& bitangent) {
  double handedness;
  if (!mesh.tangents.empty()) {
    const auto get = [&](uint32_t k) {
      const float* t = &mesh.tangents[4 * size_t(k)];
      return Vec3(t[0], t[1], t[2]);
    };
    tangent = to_scene.vector(Vec3d(interpolate(get(i[0]), get(i[1]), get(i[2]), point.u, point.v)));
    handedness = side * (mesh.tangents[4 * size_t(i[0]) + 3] < 0 ? -1 : 1);
  } else if (!mesh.uvs.empty()) {
    const Vec2 &a = mesh.uvs[i[0]], &b = mesh.uvs[i[1]], &c = mesh.uvs[i[2]];
    const double u1 = double(b.x) - a.x, v1 = double(b.y) - a.y, u2 = double(c.x) - a.x, v2 = double(c.y) - a.y;
    const double det = u1 * v2 - u2 * v1;
    if (det == 0) return false;
    const Vec3d e1 = triangle.p[1] - triangle.p[0], e2 = triangle.p[2] - triangle.p[0];
    tangent = (e1 * v2 - e2 * v1) / det;
    handedness = dot(cross(n, tangent), (e2 * u1 - e1 * u2) / det) > 0 ? -1 : 1;
  } else {
    return false;
  }
  tangent = tangent - n * dot(tangent, n);
  const double size = length(tangent);
  if (!(size > 0)) return false;
  tangent = tangent / size;
  bitangent = cross(n, tangent) * handedness;
  return true;
}

}  // namespace

// The shading normal from vertex normals and the normal texture; false where there is none to use.
bool Raytracer::Impl::normal_at(const Placed& instance, const SurfacePoint& point, const Triangle& triangle,
                                Vec3& out) const {
  const Mesh& mesh = *geometries[instance.geometry]->mesh;
  const uint32_t* i = &mesh.indices[3 * size_t(point.primitive)];
  const Texture* bumps = mesh.material < texturing->size() ? (*texturing)[mesh.material].normal : nullptr;
  if (mesh.normals.empty() && !bumps) return false;
  Vec3d n(point.ng);
  if (!mesh.normals.empty()) {
    const Vec3 at = interpolate(mesh.normals[i[0]], mesh.normals[i[1]], mesh.normals[i[2]], point.u, point.v);
    n = instance.to_scene.normal(Vec3d(at)) * instance.side;
    const double size = length(n);
    if (!(size > 0)) return false;
    n = n / size;
    if (dot(n, Vec3d(point.ng)) < 0) n = -n;  // files whose winding and normals disagree
  }
  Vec3d tangent, bitangent;
  if (bumps && tangents_at(mesh, i, point, instance.to_scene, instance.side, triangle, n, tangent, bitangent)) {
    const Rgb texel = bumps->rgb(point.uv);
    const double scale = (*texturing)[mesh.material].normal_scale;
    n = tangent * ((2.0 * texel.r - 1) * scale) + bitangent * ((2.0 * texel.g - 1) * scale) + n * (2.0 * texel.b - 1);
    const double size = length(n);
    if (!(size > 0)) return false;
    n = n / size;
  }
  if (!(dot(n, Vec3d(point.ng)) > min_side_cosine)) return false;
  out = Vec3(n);
  return true;
}

namespace {

// The point of a triangle, kept off its edges by `inset`: right at an edge rounding would put it behind the next wall.
Vec3d point_on(const Triangle& triangle, double area, double u, double v, double inset) {
  double weights[3] = {1 - u - v, u, v}, sum = 0;
  for (int i = 0; i < 3; ++i) {
    const double needed = inset * length(triangle.p[(i + 2) % 3] - triangle.p[(i + 1) % 3]);
    if (weights[i] * area < needed && needed < 0.125 * area) weights[i] = needed / area;
    sum += weights[i];
  }
  return (triangle.p[0] * weights[0] + triangle.p[1] * weights[1] + triangle.p[2] * weights[2]) / sum;
}

}  // namespace

SurfacePoint Raytracer::surface_at(uint32_t instance, uint32_t primitive, float u, float v) const {
  const Impl::Placed& placed = impl_->placed[instance];
  const Mesh& mesh = *impl_->geometries[placed.geometry]->mesh;
  const Triangle triangle = impl_->triangle(placed, primitive);
  SurfacePoint point;
  point.instance = instance, point.primitive = primitive;
  point.u = u, point.v = v;
  point.material = mesh.material;
  point.uv = uv_at(mesh, primitive, u, v);
  const Vec3d area_normal = triangle.area_normal() * placed.side;
  const double area = length(area_normal);
  point.ng = area > 0 ? Vec3(area_normal / area) : Vec3(0, 0, 1);
  const float extent = max_abs(Vec3(triangle.at(u, v))) + float(std::sqrt(triangle.longest_edge2()));
  point.error = gamma_error * (placed.error_scale * extent + placed.error_offset);
  point.p = Vec3(point_on(triangle, area, u, v, double(point.error)));
  Vec3 n = point.ng;
  impl_->normal_at(placed, point, triangle, n);
  point.shading = Frame(n);
  return point;
}

SurfacePoint Raytracer::surface_at(const Hit& hit) const {
  return surface_at(hit.instance, hit.primitive, hit.u, hit.v);
}

size_t Raytracer::triangle_count() const { return impl_->triangles; }
Vec3 Raytracer::bounds_min() const { return Vec3(impl_->lower); }
Vec3 Raytracer::bounds_max() const { return Vec3(impl_->upper); }

}  // namespace ups
