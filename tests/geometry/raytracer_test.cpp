// Surface points: positions, normals and sides agree with double arithmetic; instances, mirrors, holes and useless
// triangles behave. Leaks, surfaces that hit themselves and false hits: tests/stability.
#include <gtest/gtest.h>

#include <random>

#include "base/warp.h"
#include "rig.h"

namespace ups {
namespace {

TEST(SurfacePoint, AgreesWithDoubleArithmetic) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Mesh mesh;
  for (int i = 0; i < 300; ++i)
    mesh.positions.push_back({uniform(rng), uniform(rng), uniform(rng)}), mesh.indices.push_back(uint32_t(i));
  const Affine a = affine({1.1, 0.2, 0}, {-0.3, 0.9, 0.1}, {0.05, 0, 1.3}, {12, -7, 3}), b = tilted(0.5, {-9, 4, 2});
  const Rig rig({mesh}, {{0, a}, {0, b}});
  for (uint32_t k = 0; k < 2000; ++k) {
    const uint32_t instance = k & 1, primitive = (k / 2) % 100;
    const Vec2 uv = square_to_triangle({0.5f + 0.5f * uniform(rng), 0.5f + 0.5f * uniform(rng)});
    const SurfacePoint point = rig.tracer->surface_at(instance, primitive, uv.x, uv.y);
    Vec3d p[3];
    for (uint32_t c = 0; c < 3; ++c) p[c] = (instance ? b : a).point(Vec3d(mesh.positions[3 * primitive + c]));
    const Vec3d expected = p[0] * (1.0 - uv.x - uv.y) + p[1] * double(uv.x) + p[2] * double(uv.y);
    EXPECT_LT(length(Vec3d(point.p) - expected), double(point.error));
    EXPECT_LT(point.error, 1e-4f);
    const Vec3d n = normalize(cross(p[1] - p[0], p[2] - p[0]));
    EXPECT_LT(length(Vec3d(point.ng) - n), 1e-6);
    EXPECT_EQ(point.instance, instance);
    EXPECT_EQ(point.primitive, primitive);
  }
}

// Texture coordinates go on beside a point as the triangle is mapped: of one instance, which is baked, of several, mirrored.
TEST(SurfacePoint, ChartsTellTheMappingBesideIt) {
  std::mt19937 rng(4);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Mesh mesh;
  for (uint32_t i = 0; i < 300; ++i) {
    mesh.positions.push_back({uniform(rng), uniform(rng), uniform(rng)}), mesh.indices.push_back(i);
    mesh.uvs.push_back({10 * uniform(rng), 10 * uniform(rng)});
  }
  const Affine a = tilted(0.5, {-9, 4, 2}), mirrored = affine({-1, 0, 0}, {0, 2, 0}, {0, 0, 1}, {3, -6, 0});
  const Rig alone({mesh}, {{0, mirrored}}), several({mesh}, {{0, a}, {0, mirrored}});
  for (const Rig* rig : {&alone, &several})
    for (uint32_t k = 0; k < 400; ++k) {
      const uint32_t instance = rig == &several ? k & 1 : 0, primitive = (k / 2) % 100;
      const SurfacePoint from = rig->tracer->surface_at(instance, primitive, 0.2f, 0.3f),
                         to = rig->tracer->surface_at(instance, primitive, 0.4f, 0.15f);
      const Raytracer::Chart chart = rig->tracer->chart_at(from);
      const Vec3 way = to.p - from.p;
      EXPECT_NEAR(from.uv.x + dot(chart.u, way), to.uv.x, 1e-2f);
      EXPECT_NEAR(from.uv.y + dot(chart.v, way), to.uv.y, 1e-2f);
      EXPECT_NEAR(dot(chart.u, from.ng), 0, 1e-3f * length(chart.u));
    }
  Mesh bare = mesh;
  bare.uvs.clear();
  const Rig rig({bare}, {{0, a}});
  EXPECT_EQ(length(rig.tracer->chart_at(rig.tracer->surface_at(0, 0, 0.2f, 0.3f)).u), 0);
}

TEST(Instances, AreWhatBakedCopiesAre) {
  const Mesh mesh = box({-1, -2, -0.5f}, {1, 2, 0.5f});
  const std::vector<Affine> places = {tilted(1, {5, 0, 0}), tilted(0.3, {-3, 2, 1}),
                                      affine({-1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -6, 0})};
  const Rig instanced({mesh}, {{0, places[0]}, {0, places[1]}, {0, places[2]}});
  const Rig baked({mesh, mesh, mesh}, {{0, places[0]}, {1, places[1]}, {2, places[2]}});
  EXPECT_EQ(instanced.tracer->triangle_count(), 36u);
  EXPECT_LT(length(instanced.tracer->bounds_max() - baked.tracer->bounds_max()), 1e-5f);
  EXPECT_LT(length(instanced.tracer->bounds_min() - baked.tracer->bounds_min()), 1e-5f);
  std::mt19937 rng(5);
  std::uniform_real_distribution<float> uniform(0, 1);
  int hits = 0, differing = 0;
  for (int k = 0; k < 60000; ++k) {
    const Vec3 o(14 * uniform(rng) - 7, 14 * uniform(rng) - 7, 14 * uniform(rng) - 7);
    const Vec3 d = square_to_sphere({uniform(rng), uniform(rng)});
    Hit a, b;
    const bool hit_a = instanced.tracer->intersect(o, d, infinity, a),
               hit_b = baked.tracer->intersect(o, d, infinity, b);
    EXPECT_EQ(hit_a, instanced.tracer->occluded(o, d, infinity));
    if (hit_a != hit_b || (hit_a && (a.instance != b.instance || a.primitive != b.primitive))) {
      ++differing;  // a silhouette or a diagonal within rounding
      continue;
    }
    if (!hit_a) continue;
    ++hits;
    const SurfacePoint p = instanced.tracer->surface_at(a), q = baked.tracer->surface_at(b);
    EXPECT_LT(length(p.p - q.p), 1e-4f);
    EXPECT_LT(length(p.ng - q.ng), 1e-5f);
  }
  EXPECT_GT(hits, 1500);
  EXPECT_LE(differing, 6);
}

// Of whatever size the mesh is drawn.
TEST(Instances, AreMetAtAnyScale) {
  for (const double scale : {1e-18, 1e-13, 1e-7, 1e-3, 1e3, 1e7, 1e13, 1e18}) {
    const float size = float(1 / scale);
    const Vec3d x(scale, 0, 0), y(0, scale, 0), z(0, 0, scale);
    const Rig rig({box({-size, -size, -size}, {size, size, size})},
                  {{0, affine(x, y, z, {5, 0, 0})}, {0, affine(x, y, z, {-5, 0, 0})}});
    for (uint32_t i = 0; i < 2; ++i) {
      Hit hit;
      ASSERT_TRUE(rig.tracer->intersect(Vec3(i == 0 ? 5 : -5, 0.1f, 3), Vec3(0, 0, -1), infinity, hit)) << scale;
      EXPECT_EQ(hit.instance, i);
      EXPECT_NEAR(rig.tracer->surface_at(hit).p.z, 1, 1e-4) << scale;
    }
  }
}

TEST(Sides, MirroringKeepsTheOutsideOutside) {
  const Affine mirror = affine({-2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {10, 0, 0}),
               plain = affine({2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-10, 0, 0});
  Mesh mesh = box({-1, -1, -1}, {1, 1, 1});
  for (const Vec3& p : mesh.positions) mesh.normals.push_back(normalize(p));
  for (const bool shared : {false, true}) {
    const Rig rig = shared ? Rig({mesh}, {{0, mirror}, {0, plain}}) : Rig({mesh, mesh}, {{0, mirror}, {1, plain}});
    for (uint32_t instance = 0; instance < 2; ++instance)
      for (uint32_t primitive = 0; primitive < 12; ++primitive) {
        const SurfacePoint point = rig.tracer->surface_at(instance, primitive, 0.3f, 0.3f);
        const Vec3 outwards = point.p - Vec3(instance == 0 ? 10 : -10, 0, 0);
        EXPECT_GT(dot(point.ng, outwards), 0);
        EXPECT_GT(dot(point.shading.n, outwards), 0);
        EXPECT_GT(dot(point.shading.n, point.ng), 0);
      }
  }
}

TEST(ShadingNormal, FollowsVertexNormalsAndTheNormalTexture) {
  Mesh mesh;
  add_quad(mesh, {0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0});
  mesh.uvs = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};  // upright image: v runs down
  const Texture right(1, 1, 3, {0.8f, 0.5f, 0.9f}), up(1, 1, 3, {0.5f, 0.8f, 0.9f});
  for (const bool tangents : {false, true}) {
    if (tangents)
      for (int i = 0; i < 4; ++i) mesh.tangents.insert(mesh.tangents.end(), {1, 0, 0, 1});
    for (const Texture* texture : {&right, &up}) {
      std::vector<SurfaceTexturing> texturing(1);
      texturing[0].normal = texture;
      texturing[0].normal_scale = 0.5f;
      const Rig rig({mesh}, {{0, Affine()}}, texturing);
      const Vec3 expected = normalize(texture == &right ? Vec3(0.3f, 0, 0.8f) : Vec3(0, 0.3f, 0.8f));
      EXPECT_LT(length(rig.tracer->surface_at(0, 0, 0.2f, 0.3f).shading.n - expected), 1e-5f);
    }
  }
  mesh.normals = {{0, 0, 1}, {1, 0, 1}, {1, 0, 1}, {0, 0, 1}};
  const Rig smooth({mesh}, {{0, Affine()}});
  EXPECT_LT(length(smooth.tracer->surface_at(0, 0, 0.5f, 0).shading.n - normalize(Vec3(0.5f, 0, 1))), 1e-6f);
  for (Vec3& n : mesh.normals) n = {1, 0, 0};  // useless: within the surface
  const Rig useless({mesh}, {{0, Affine()}});
  EXPECT_EQ(useless.tracer->surface_at(0, 0, 0.5f, 0).shading.n.z, 1);
}

// Normals of files that are a triangle's own but for rounding are not worth looking at; others are kept.
TEST(ShadingNormal, IsTheTrianglesOwnWhereItsVerticesSaySo) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {3, 0.5f, 1}, {0.2f, 2, -1}};
  mesh.indices = {0, 1, 2};
  const Vec3 ng = Vec3(normalize(cross(Vec3d(mesh.positions[1]), Vec3d(mesh.positions[2]))));
  const Frame frame(ng);
  for (const float tilt : {0.0f, 2e-7f, 1e-4f})
    for (const float side : {1.0f, -1.0f}) {
      mesh.normals.assign(3, (ng + frame.s * tilt) * side);
      const SurfacePoint point = Rig({mesh}, {{0, Affine()}}).tracer->surface_at(0, 0, 0.3f, 0.3f);
      const float lean = length(point.shading.n - point.ng);
      if (tilt < 1e-6f) EXPECT_EQ(lean, 0);
      else EXPECT_NEAR(lean, tilt, 0.01f * tilt);
    }
}

TEST(Holes, MaskCutsAndBlendIsThereForEachRay) {
  Mesh mesh;
  add_quad(mesh, {0, 0, 0}, {2, 0, 0}, {2, 1, 0}, {0, 1, 0});
  mesh.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  const Texture alpha(2, 1, 4, {1, 1, 1, 0.0f, 1, 1, 1, 1.0f});  // left half clear, centres at u = 0.25 and 0.75
  std::vector<SurfaceTexturing> texturing(1);
  texturing[0].alpha = &alpha;
  texturing[0].alpha_mode = SurfaceTexturing::mask;
  const Rig mask({mesh}, {{0, Affine()}}, texturing);
  Hit hit;
  EXPECT_FALSE(mask.tracer->intersect({0.5f, 0.5f, 1}, {0, 0, -1}, infinity, hit));
  EXPECT_FALSE(mask.tracer->occluded({0.5f, 0.5f, 1}, {0, 0, -1}, infinity));
  EXPECT_TRUE(mask.tracer->intersect({1.5f, 0.5f, 1}, {0, 0, -1}, infinity, hit));
  EXPECT_TRUE(mask.tracer->occluded({1.5f, 0.5f, 1}, {0, 0, -1}, infinity));
  texturing[0].alpha_mode = SurfaceTexturing::blend;
  texturing[0].alpha_factor = 0.3f;
  const Rig blend({mesh}, {{0, Affine()}}, texturing);
  EXPECT_FALSE(blend.tracer->intersect({0.5f, 0.5f, 1}, {0, 0, -1}, infinity, hit)) << "where nothing is";
  for (float x = 1.25f; x < 1.8f; x += 0.0625f) {
    EXPECT_TRUE(blend.tracer->intersect({x, 0.5f, 1}, {0, 0, -1}, infinity, hit)) << x;
    EXPECT_TRUE(blend.tracer->occluded({x, 0.5f, 1}, {0, 0, -1}, infinity)) << x;
  }
}

TEST(Degenerate, TrianglesWithoutAreaAreLeftOut) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5f, 0, 0}};
  mesh.indices = {0, 1, 3, 0, 0, 1, 0, 1, 2, 2, 2, 2};
  mesh.positions.push_back({});  // a point at the origin, where errors are 0
  mesh.indices.insert(mesh.indices.end(), {4, 4, 4});
  for (const bool shared : {false, true}) {  // baked, and in its own frame
    const Rig rig({mesh}, shared ? std::vector<Raytracer::Instance>{{0, Affine()}, {0, tilted(1, {5, 0, 0})}}
                                 : std::vector<Raytracer::Instance>{{0, Affine()}});
    Hit hit;
    ASSERT_TRUE(rig.tracer->intersect({0.2f, 0.2f, 1}, {0, 0, -1}, infinity, hit));
    EXPECT_EQ(hit.primitive, 2u);
    EXPECT_NEAR(hit.t, 1, 1e-6f);
    for (uint32_t primitive = 0; primitive < 5; ++primitive) {
      const SurfacePoint point = rig.tracer->surface_at(0, primitive, 0.25f, 0.25f);
      EXPECT_TRUE(is_finite(point.p) && is_finite(point.ng) && is_finite(point.shading.n));
      EXPECT_TRUE(is_finite(point.shading.s) && is_finite(point.shading.t) && std::isfinite(point.error));
    }
  }
  mesh.indices = {0, 1, 3, 0, 0, 1};
  const Rig nothing({mesh}, {{0, Affine()}});
  EXPECT_FALSE(nothing.tracer->occluded({0.2f, 0, 1}, {0, 0, -1}, infinity));
}

TEST(Empty, SceneHasNoHitsAndNoBounds) {
  const Rig rig({}, {});
  Hit hit;
  EXPECT_FALSE(rig.tracer->intersect({0, 0, 0}, {0, 0, 1}, infinity, hit));
  EXPECT_FALSE(rig.tracer->occluded({0, 0, 0}, {0, 0, 1}, infinity));
  EXPECT_EQ(rig.tracer->triangle_count(), 0u);
  EXPECT_GT(rig.tracer->bounds_min().x, rig.tracer->bounds_max().x);
}

}  // namespace
}  // namespace ups
