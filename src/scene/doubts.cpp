// See doubts.h.
#include "scene/doubts.h"

#include <algorithm>
#include <cmath>

#include "scene/probe.h"

namespace ups {

namespace {

bool is_flat(const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3d p(a), u = Vec3d(b) - p, v = Vec3d(c) - p, w = v - u;
  return length(cross(u, v)) <= 0x1p-24 * std::max({dot(u, u), dot(v, v), dot(w, w)});
}

}  // namespace

FlatTriangles find_flat_triangles(const Snapshot& scene, ThreadPool& pool) {
  std::vector<FlatTriangles> found(scene.meshes.size());
  parallel_for(pool, found.size(), [&](size_t m) {
    const Mesh& mesh = *scene.meshes[m];
    for (uint32_t t = 0; t < mesh.triangle_count(); ++t) {
      const uint32_t* v = &mesh.indices[3 * size_t(t)];
      if (!is_flat(mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]])) continue;
      if (found[m].count++ == 0) found[m].triangle = t;
    }
  });
  FlatTriangles all;
  for (uint32_t m = 0; m < found.size(); ++m) {
    if (found[m].count == 0) continue;
    if (all.meshes++ == 0) all.mesh = m, all.triangle = found[m].triangle;
    all.count += found[m].count;
  }
  return all;
}

double brightest_first_light_lx(const Snapshot& scene) {
  constexpr uint32_t rays = 16;
  constexpr size_t most = 256;
  double brightest = -1;
  for (const uint32_t e : some_emitters(scene.emitters, most)) {
    const Emitter& emitter = scene.emitters[e];
    if (emitter.kind() == EmitterKind::area || emitter.is_directional()) continue;
    for (uint32_t i = 0; i < rays; ++i) {
      const FirstLight light = first_light(scene, emitter, i);
      if (!(light.flux > 0) || !light.hit) continue;
      const double distance2 = double(length2(light.surface.p - light.origin));
      const double lx = light.intensity_cd * double(std::abs(dot(light.direction, light.surface.ng))) / distance2;
      brightest = std::max(brightest, lx);
    }
  }
  return brightest;
}

}  // namespace ups
