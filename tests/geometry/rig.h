// Meshes and a ray tracer over them, in a few lines.
#pragma once
#include "geometry/raytracer.h"

namespace ups {

using Meshes = std::vector<std::shared_ptr<const Mesh>>;
using Instances = std::vector<Raytracer::Instance>;
inline constexpr float infinity = std::numeric_limits<float>::infinity();

inline void add_quad(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const uint32_t i = uint32_t(mesh.positions.size());
  for (const Vec3& p : {a, b, c, d}) mesh.positions.push_back(p);
  for (const uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(i + k);
}

// Front sides (counter-clockwise) face outwards.
inline Mesh box(const Vec3& lo, const Vec3& hi) {
  Mesh m;
  const auto p = [&](int x, int y, int z) { return Vec3(x ? hi.x : lo.x, y ? hi.y : lo.y, z ? hi.z : lo.z); };
  add_quad(m, p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0));
  add_quad(m, p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1));
  add_quad(m, p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1));
  add_quad(m, p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0));
  add_quad(m, p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0));
  add_quad(m, p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1));
  return m;
}

inline Affine affine(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& t) {
  Affine a;
  for (int r = 0; r < 3; ++r) a.m[4 * r] = x[r], a.m[4 * r + 1] = y[r], a.m[4 * r + 2] = z[r], a.m[4 * r + 3] = t[r];
  return a;
}

inline Affine tilted(double scale, const Vec3d& t) {
  const Vec3d z = normalize(Vec3d(0.3, -0.5, 0.8)), x = normalize(cross(Vec3d(0, 1, 0), z)), y = cross(z, x);
  return affine(x * scale, y * scale, z * scale, t);
}

struct Rig {
  Meshes meshes;
  std::vector<SurfaceTexturing> texturing;
  std::unique_ptr<Raytracer> tracer;
  Rig(std::vector<Mesh> list, const Instances& instances,
      std::vector<SurfaceTexturing> t = std::vector<SurfaceTexturing>(1))
      : texturing(std::move(t)) {
    for (Mesh& m : list) meshes.push_back(std::make_shared<Mesh>(std::move(m)));
    ThreadPool pool(2);
    tracer = std::make_unique<Raytracer>(meshes, instances, texturing, pool);
  }
};

}  // namespace ups
