// Triangles, surfaces of revolution, and rays. Embree (3.13 or 4) stays in this folder, behind embree.h.
// Positions are floats relative to the scene's origin; the caller subtracts it in double before building.
#pragma once
#include <cstdint>
#include <functional>
#include <memory>
#include <vector>

#include "base/parallel.h"
#include "base/stop.h"
#include "geometry/box.h"
#include "geometry/revolution.h"
#include "geometry/surface.h"
#include "geometry/texture.h"

namespace ups {

struct Mesh {  // object space
  std::vector<Vec3> positions, normals;  // normals: empty or one a vertex
  std::vector<Vec2> uvs;                 // empty or one a vertex
  std::vector<float> tangents;           // empty or 4 a vertex
  std::vector<uint32_t> indices;         // 3 a triangle
  uint32_t material_number = 0;          // as the program added it
  std::shared_ptr<const Revolution> revolution;  // where there is one it is traced; the triangles give the addresses
  size_t triangle_count() const { return indices.size() / 3; }
  size_t bytes() const;
  // Positions of the vertices that triangles have, once each in their order; the others may lie anywhere.
  template <class Visit>
  void each_used(const Visit& visit) const {
    std::vector<char> used(positions.size());
    for (const uint32_t i : indices) used[i] = 1;
    for (size_t i = 0; i < used.size(); ++i)
      if (used[i]) visit(positions[i]);
  }
};

Box bounding_box(const Mesh& mesh);  // of its surface as it is traced

// What the ray tracer must know of a material: holes and bumps.
struct SurfaceTexturing {
  const Texture* alpha = nullptr;   // may be null with blend/mask: then `alpha_factor` alone
  float alpha_factor = 1, alpha_cutoff = 0.5f;
  enum { opaque, mask, blend } alpha_mode = opaque;
  const Texture* normal = nullptr;
  float normal_scale = 1;
  float alpha_at(const Vec2& uv) const;
  // What is blended is there for every ray where there is anything: transport/encounter.h lets a share of the light by.
  bool is_hole_at(const Vec2& uv) const {
    const float at = alpha_at(uv);
    return alpha_mode == mask ? at < alpha_cutoff : !(at > 0);
  }
  bool may_have_holes() const {
    return alpha_mode == mask || (alpha_mode == blend && (alpha || !(alpha_factor > 0)));
  }
  bool operator==(const SurfaceTexturing&) const = default;
};

class Monitor;

class Raytracer {
 public:
  struct Instance {
    uint32_t mesh;
    Affine to_scene;      // object to the scene's own origin
    uint32_t number = 0;    // that it keeps while others come and go; ascending
    uint32_t material = 0;  // SurfacePoint::material
    bool operator==(const Instance&) const = default;
  };
  // texturing is indexed by Instance::material; its textures must outlive the ray tracer. A mesh has one material.
  // finds_all: intersect_all() may be asked, which costs the others a little.
  // earlier: what is the same in it is shared; null: none. Rays find the same with it and without.
  // Throws Error (OUT_OF_MEMORY, INTERNAL with Embree's message), and Cancelled where there is a monitor.
  Raytracer(const std::vector<std::shared_ptr<const Mesh>>& meshes, const std::vector<Instance>& instances,
            const std::vector<SurfaceTexturing>& texturing, ThreadPool& pool, bool finds_all = false,
            const Raytracer* earlier = nullptr, Monitor* monitor = nullptr);
  ~Raytracer();
  Raytracer(const Raytracer&) = delete;
  Raytracer& operator=(const Raytracer&) = delete;

  // Closest hit with 0 < t < tmax; d is unit. Safe from any thread.
  bool intersect(const Vec3& o, const Vec3& d, float tmax, Hit& hit) const;
  bool occluded(const Vec3& o, const Vec3& d, float tmax) const;
  // All hits with 0 < t < tmax, those of surfaces that lie on one another too; near ones first, then by instance.
  void intersect_all(const Vec3& o, const Vec3& d, float tmax, std::vector<Hit>& out) const;
  SurfacePoint surface_at(const Hit& hit) const;
  // The same point from its address, for stored vertices.
  SurfacePoint surface_at(uint32_t instance, uint32_t primitive, float u, float v) const;
  // Texture coordinates beside a surface point, as its triangle's plane and mapping go on: at p + d they are
  // uv + (dot(u, d), dot(v, d)). Zero where there is no mapping.
  struct Chart {
    Vec3 u, v;
  };
  Chart chart_at(const SurfacePoint& point) const;
  // True where the open segment between two surface points is free; both ends are shortened by their error bounds.
  bool visible(const SurfacePoint& a, const SurfacePoint& b) const;
  // From a surface point to a free point (meter, light): b_error is the free point's own error bound.
  bool visible(const SurfacePoint& a, const Vec3& b, float b_error) const;

  size_t triangle_count() const;  // instances expanded
  size_t bytes() const;           // without the meshes; with what is left of earlier ones that share parts
  size_t shared_parts(const Raytracer& earlier) const;  // meshes that both have, for tests
  // Vertices of each, in the scene's frame; of a surface of revolution those of its mesh.
  void each_triangle(const std::function<void(const Vec3d (&)[3])>& visit) const;
  Vec3 bounds_min() const;
  Vec3 bounds_max() const;

 private:
  friend class RaytracerBuild;
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

// Discs and balls in space, found by segments: meters' sensor index, what surrounds luminous openings. Every one
// crossed is reported once.
class DiscIndex {
 public:
  struct Disc {
    Vec3 center, normal;  // unit normal; (0, 0, 0) makes it a ball
    float radius;
    Vec3 reach{-1, -1, -1};  // of what is searched for on the disc, from its centre along each axis; < 0: all of it
  };
  explicit DiscIndex(std::vector<Disc> discs, const StopSignal& stop = {});  // empty where `stop` is set on the way
  ~DiscIndex();
  struct Crossing {
    uint32_t disc;
    float t;
  };
  // Appends all crossings with 0 <= t <= tmax of the disc's plane within its radius, both sides, sorted by disc. A ball
  // is crossed where the segment enters it, or at t = 0.
  void intersect_all(const Vec3& o, const Vec3& d, float tmax, std::vector<Crossing>& out) const;
  bool empty() const;
  size_t bytes() const;
  const Disc& disc(uint32_t i) const;
  bool holds(const std::vector<Disc>& discs) const;  // these, in this order

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace ups
