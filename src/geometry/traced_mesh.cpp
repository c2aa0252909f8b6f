// See traced_mesh.h.
#include "geometry/traced_mesh.h"

namespace ups {

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

Vec2 uv_at(const Mesh& mesh, uint32_t primitive, float u, float v) {
  if (mesh.uvs.empty()) return {};
  const uint32_t* i = &mesh.indices[3 * size_t(primitive)];
  const Vec2 &a = mesh.uvs[i[0]], &b = mesh.uvs[i[1]], &c = mesh.uvs[i[2]];
  const float w = 1 - u - v;
  return {w * a.x + u * b.x + v * c.x, w * a.y + u * b.y + v * c.y};
}

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

void keep_off_edges(const Triangle& triangle, double area, double longest_edge, double inset, double (&weights)[3]) {
  for (int i = 0; i < 3; ++i)
    if (weights[i] * area < inset * longest_edge) {
      const double needed = inset * length(triangle.p[(i + 2) % 3] - triangle.p[(i + 1) % 3]);
      if (weights[i] * area < needed && needed < 0.125 * area) weights[i] = needed / area;
    }
}

namespace {

Affine inverse(const Affine& m) {
  const double det = m.determinant();
  Affine out;
  for (int r = 0; r < 3; ++r) {
    const Vec3d row = cross(m.column((r + 1) % 3), m.column((r + 2) % 3)) / det;
    out.m[4 * r] = row.x, out.m[4 * r + 1] = row.y, out.m[4 * r + 2] = row.z;
    out.m[4 * r + 3] = -dot(row, m.column(3));
  }
  return out;
}

// A triangle lower than this share of its longest edge can be "hit" far from where it is (Embree issue 387).
constexpr double thin_share = 1e-3;

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
  const TrapsSet traps;
  const TracedMesh& mesh = *static_cast<const TracedMesh*>(args->geometryUserPtr);
  const RTCRay& ray = *reinterpret_cast<const RTCRay*>(args->ray);
  const RTCHit& hit = *reinterpret_cast<const RTCHit*>(args->hit);
  const uint32_t primitive = mesh.primitive(hit.primID);
  const SurfaceTexturing* holes = mesh.has_holes ? embree::holes_of(args->context, mesh) : nullptr;
  const bool reject = (mesh.has_thin && is_false_hit(mesh.triangle(primitive), ray)) ||
                      (holes && holes->is_hole_at(uv_at(*mesh.source, primitive, hit.u, hit.v)));
  if (reject) args->valid[0] = 0;
}

// Triangles without area have no normal: they stay out of Embree.
void sort_out_triangles(TracedMesh& mesh) {
  const size_t count = mesh.source->triangle_count();
  for (size_t i = 0; i < count; ++i) {
    const Triangle triangle = mesh.triangle(uint32_t(i));
    const double area2 = length2(triangle.area_normal()), edge2 = triangle.longest_edge2();
    if (area2 > 0) {
      if (area2 < thin_share * thin_share * edge2 * edge2) mesh.has_thin = true;
      mesh.primitives.push_back(uint32_t(i));
    }
  }
  mesh.complete = mesh.primitives.size() == count;
  if (mesh.complete) {
    mesh.primitives = std::vector<uint32_t>();
    return;
  }
  for (const uint32_t p : mesh.primitives)
    for (int k = 0; k < 3; ++k) mesh.indices.push_back(mesh.source->indices[3 * size_t(p) + size_t(k)]);
}

constexpr size_t triangles_of_block = 4096;

// Normals of a mesh that agree with a triangle's own but for their rounding in files.
bool is_flat(const Mesh& mesh, const uint32_t* i, const Vec3d& ng, const NormalMatrix& normals) {
  constexpr double rounding = 1e-6;
  for (int k = 0; k < 3 && !mesh.normals.empty(); ++k) {
    const Vec3d n = normals * Vec3d(mesh.normals[i[k]]);
    const double size = length(n), along = dot(n, ng);
    if (!(size > 0) || !(length(n - ng * along) <= rounding * size)) return false;
  }
  return true;
}

// normals: what the mesh's are turned by.
Facet facet_of(const TracedMesh& mesh, uint32_t primitive, const NormalMatrix& normals) {
  const Triangle triangle = mesh.triangle(primitive);
  const Vec3d area_normal = triangle.area_normal();
  const double area = length(area_normal), edge = std::sqrt(triangle.longest_edge2());
  if (!(area > 0)) return {Vec3(0, 0, 1), float(edge), 0, false};
  const Vec3d ng = area_normal / area;
  return {Vec3(ng), float(edge), float(area / edge * (1 - 0x1p-20)),
          is_flat(*mesh.source, &mesh.source->indices[3 * size_t(primitive)], ng, normals)};
}

}  // namespace

RTCGeometry make_geometry(embree::Device& device, const TracedMesh& mesh) {
  if (mesh.source->revolution) return make_revolution_geometry(device, mesh);
  const std::vector<uint32_t>& indices = mesh.complete ? mesh.source->indices : mesh.indices;
  if (indices.empty()) return nullptr;
  RTCGeometry triangles = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  device.check();
  rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, mesh.positions.data(), 0,
                             sizeof(Vec3), mesh.positions.size() - 1);
  rtcSetSharedGeometryBuffer(triangles, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, indices.data(), 0,
                             3 * sizeof(uint32_t), indices.size() / 3);
  rtcSetGeometryUserData(triangles, const_cast<TracedMesh*>(&mesh));  // which comes back to readers alone
  if (mesh.has_holes || mesh.has_thin) {
    rtcSetGeometryIntersectFilterFunction(triangles, &filter);
    rtcSetGeometryOccludedFilterFunction(triangles, &filter);
  }
  return triangles;
}

std::shared_ptr<const TracedMesh> make_traced_mesh(std::shared_ptr<const Mesh> source, bool has_holes,
                                                   const Affine* bake, ThreadPool& pool) {
  auto traced = std::make_shared<TracedMesh>();
  const Mesh& mesh = *source;
  traced->source = std::move(source);
  traced->has_holes = has_holes;
  traced->positions.reserve(mesh.positions.size() + 1);
  {
    const TrapsMasked masked;  // vertices that no triangle has may lie anywhere
    for (const Vec3& p : mesh.positions) traced->positions.push_back(bake ? Vec3(bake->point(Vec3d(p))) : p);
  }
  traced->positions.emplace_back();
  if (mesh.revolution) {
    if (bake) traced->to_frame = *bake, traced->from_frame = inverse(*bake);
    cut_into_pieces(*traced);
    return traced;
  }
  sort_out_triangles(*traced);
  if (!bake) return traced;
  const NormalMatrix normals(*bake);
  traced->facets.resize(mesh.triangle_count());
  pool.for_blocks(mesh.triangle_count(), triangles_of_block, [&](size_t, size_t begin, size_t end) {
    for (size_t i = begin; i < end; ++i) traced->facets[i] = facet_of(*traced, uint32_t(i), normals);
  });
  return traced;
}

}  // namespace ups
