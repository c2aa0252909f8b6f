// What a Raytracer is made of: built in raytracer_build.cpp, asked in raytracer.cpp, which alone include it.
//
// A small scene is one index of all triangles, but for meshes that several instances share. A larger one has an index for
// each large mesh and for each group of the others (grouping.h), and an index of these above all. Which of them follows
// from meshes and instances alone, never from earlier builds: where two surfaces meet, the one that a ray hits depends on
// the order in which the index is searched. Parts are immutable; the builds of a scene share those that are the same.
#pragma once
#include <compare>
#include <map>
#include <memory>
#include <tuple>
#include <vector>

#include "geometry/box.h"
#include "geometry/raytracer.h"
#include "geometry/traced_mesh.h"

namespace ups {

// Of (|p| + longest edge): rounding of p, of the vertices, and of Embree's own distance to the plane (tests/geometry
// has boxes at several scales and offsets, and counts hits of the surface that a ray has just left).
inline constexpr float gamma_error = 16 * 0x1p-24f;

struct Raytracer::Impl {
  struct Placed {
    uint32_t traced, material;  // indices
    bool baked;
    Affine to_scene;
    double side;                      // -1: the transform mirrors, so that winding and front part
    NormalMatrix normals;             // of to_scene
    double most_stretch, least_stretch;  // of lengths from the traced mesh's frame to the scene's, at most and at least
    float error_offset, error_scale;  // error = gamma * (error_scale * (|p| + edge) + error_offset)
  };
  // An index of its own; geometry i is of meshes[i].
  struct Part {
    std::shared_ptr<embree::Device> device;
    std::vector<std::shared_ptr<const TracedMesh>> meshes;
    embree::Scene scene;
    Part(const std::shared_ptr<embree::Device>& d, bool finds_all) : device(d), scene(*d, finds_all) {}
  };
  struct Key;  // of what a traced mesh is made from
  using TracedMeshes = std::map<Key, std::shared_ptr<const TracedMesh>>;

  std::shared_ptr<embree::Device> device;
  bool finds_all = false;
  std::vector<SurfaceTexturing> texturing;
  embree::Holes holes;
  std::vector<std::shared_ptr<const TracedMesh>> traced;
  std::vector<Placed> placed;
  std::vector<std::shared_ptr<const Part>> parts;
  std::vector<std::vector<uint32_t>> members;  // of groups, whose ids at the top follow those of instances: instances
  std::unique_ptr<embree::Scene> top;
  size_t triangles = 0;
  Box bounds;
  // For the next build.
  TracedMeshes made_of;
  std::map<const Mesh*, Box> boxes;
  std::map<std::vector<std::shared_ptr<const TracedMesh>>, std::shared_ptr<const Part>> part_of;

  Triangle triangle(const Placed& instance, uint32_t primitive) const {
    Triangle t = traced[instance.traced]->triangle(primitive);
    if (!instance.baked)
      for (Vec3d& p : t.p) p = instance.to_scene.point(p);
    return t;
  }
  uint32_t instance_of(const RTCHit& hit) const {
    const uint32_t id = hit.instID[0];
    if (id == RTC_INVALID_GEOMETRY_ID) return hit.geomID;
    return id < placed.size() ? id : members[id - placed.size()][hit.geomID];
  }
  const Texture* bumps_of(const Placed& instance) const {
    return instance.material < texturing.size() ? texturing[instance.material].normal : nullptr;
  }
  static bool grazes(const Placed& instance, const Vec3& ng, const Vec3& d);
  void refine(const Vec3& ng, const Vec3& o, const Vec3& d, Hit& hit) const;
  Hit to_hit(const RTCHit& hit, float t, const Vec3& o, const Vec3& d) const;
  void place_on_revolution(const Placed& instance, const Revolution& revolution, SurfacePoint& point) const;
  static bool place_within(const Placed& instance, const Triangle& own, double low, double longest_edge,
                           SurfacePoint& point);
  void place_by_edges(const Placed& instance, double (&weights)[3], SurfacePoint& point) const;
  bool normal_at(const Placed& instance, const SurfacePoint& point, Vec3& out) const;
};

struct Raytracer::Impl::Key {
  const Mesh* mesh;
  bool has_holes, baked;
  Affine to_scene;  // where it is baked
  auto operator<=>(const Key& b) const {
    if (const auto order = std::tie(mesh, has_holes, baked) <=> std::tie(b.mesh, b.has_holes, b.baked); order != 0)
      return std::partial_ordering(order);
    for (int i = 0; baked && i < 12; ++i)
      if (const auto order = to_scene.m[i] <=> b.to_scene.m[i]; order != 0) return order;
    return std::partial_ordering::equivalent;
  }
};

}  // namespace ups
