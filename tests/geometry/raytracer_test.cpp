// Rays and surface points: closed rooms do not leak and surfaces do not hit themselves at any scale or place;
// positions, normals and sides agree with double arithmetic; instances, mirrors, holes and useless triangles behave.
#include <gtest/gtest.h>

#include <random>

#include "base/warp.h"
#include "geometry/raytracer.h"

namespace ups {
namespace {

using Meshes = std::vector<std::shared_ptr<const Mesh>>;
using Instances = std::vector<Raytracer::Instance>;
constexpr float infinity = std::numeric_limits<float>::infinity();

void add_quad(Mesh& mesh, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const uint32_t i = uint32_t(mesh.positions.size());
  for (const Vec3& p : {a, b, c, d}) mesh.positions.push_back(p);
  for (const uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(i + k);
}

// Front sides (counter-clockwise) face outwards.
Mesh box(const Vec3& lo, const Vec3& hi) {
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

Affine affine(const Vec3d& x, const Vec3d& y, const Vec3d& z, const Vec3d& t) {
  Affine a;
  for (int r = 0; r < 3; ++r) a.m[4 * r] = x[r], a.m[4 * r + 1] = y[r], a.m[4 * r + 2] = z[r], a.m[4 * r + 3] = t[r];
  return a;
}

Affine tilted(double scale, const Vec3d& t) {
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

struct Leaks {
  size_t rays = 0, escaped = 0, self_hits = 0, blocked = 0;
};

// Diffuse walks in a closed room. A self-hit is a hit of the plane that the ray has just left. Every edge is also tried
// as a shadow ray between its ends, which must be free.
Leaks walk_in_room(const Raytracer& tracer, const Vec3& start, size_t count, uint32_t seed) {
  std::mt19937 rng(seed);
  std::uniform_real_distribution<float> uniform(0, 1);
  Leaks leaks;
  Hit hit;
  while (leaks.rays < count) {
    const Vec3 d0 = square_to_sphere({uniform(rng), uniform(rng)});
    if (!tracer.intersect(start, d0, infinity, hit)) {
      ++leaks.escaped, ++leaks.rays;
      continue;
    }
    SurfacePoint point = tracer.surface_at(hit);
    Vec3 arrived = d0;
    for (int bounce = 0; bounce < 50; ++bounce) {
      ++leaks.rays;
      const Vec3 n = dot(arrived, point.ng) > 0 ? -point.ng : point.ng;
      Vec3 local = square_to_cosine_hemisphere({uniform(rng), uniform(rng)});
      if (bounce % 5 == 0) local = normalize(Vec3(local.x, local.y, local.z * 1e-3f));  // grazing
      if (local.z < 1e-6f) continue;  // walks reject such edges: they have no side
      const Vec3 d = Frame(n).to_world(local);
      if (!tracer.intersect(point.ray_origin(d), d, infinity, hit)) {
        ++leaks.escaped;
        break;
      }
      const SurfacePoint next = tracer.surface_at(hit);
      if (std::abs(dot(next.p - point.p, point.ng)) < 4 * point.error && std::abs(dot(next.ng, point.ng)) > 0.999f) {
        ++leaks.self_hits;
        break;
      }
      leaks.blocked += !tracer.visible(point, next);
      point = next, arrived = d;
    }
  }
  return leaks;
}

void expect_tight(const Rig& rig, const Vec3& start, size_t rays) {
  const Leaks leaks = walk_in_room(*rig.tracer, start, rays, 11);
  EXPECT_EQ(leaks.escaped, 0u);
  EXPECT_EQ(leaks.self_hits, 0u);
  EXPECT_EQ(leaks.blocked, 0u);
}

TEST(ClosedRoom, IsTightAtThreeScales) {
  for (const float s : {1e-3f, 1.0f, 1e5f})
    expect_tight(Rig({box({-1.3f * s, -1.7f * s, -0.9f * s}, {1.1f * s, 1.9f * s, 1.3f * s})}, {{0, Affine()}}),
                 {0.1f * s, 0.1f * s, 0.1f * s}, 400'000);
}

TEST(ClosedRoom, IsTightWhenTilted) {
  expect_tight(Rig({box({-2, -3, -1}, {2, 3, 1})}, {{0, tilted(1, {0, 0, 0})}}), {0, 0, 0}, 400'000);
}

// At 3 km a float's steps are 0.24 mm.
TEST(ClosedRoom, IsTightFarFromTheOrigin) {
  expect_tight(Rig({box({-2, -3, -1}, {2, 3, 1})}, {{0, tilted(1, {3000, -2000, 500})}}), {3000, -2000, 500}, 400'000);
}

TEST(ClosedRoom, IsTightAsAnInstance) {
  // The second room is elsewhere: it only makes the first an instance.
  expect_tight(Rig({box({-2, -3, -1}, {2, 3, 1})}, {{0, tilted(1.5, {40, -30, 20})}, {0, tilted(1, {-40, 30, -20})}}),
               {40, -30, 20}, 400'000);
}

TEST(ClosedRoom, IsTightWithLongThinTriangles) {
  Mesh room = box({-20, -3, -1}, {20, 3, 1});
  room.indices.resize(6);  // the floor stays; ceiling and walls are cut into strips of 40 m x 5 mm and less
  const auto strips = [&](const Vec3& a, const Vec3& along, const Vec3& across, int n) {
    for (int i = 0; i < n; ++i) {
      const float f0 = float(i) / float(n), f1 = float(i + 1) / float(n);
      add_quad(room, a + across * f0, a + along + across * f0, a + along + across * f1, a + across * f1);
    }
  };
  strips({-20, -3, 1}, {40, 0, 0}, {0, 6, 0}, 1200);
  strips({-20, -3, -1}, {40, 0, 0}, {0, 0, 2}, 400);
  strips({-20, 3, -1}, {40, 0, 0}, {0, 0, 2}, 400);
  strips({-20, -3, -1}, {0, 6, 0}, {0, 0, 2}, 400);
  strips({20, -3, -1}, {0, 6, 0}, {0, 0, 2}, 400);
  expect_tight(Rig({room}, {{0, Affine()}}), {0, 0, 0}, 200'000);
}

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

TEST(Holes, MaskCutsAndBlendThins) {
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
  texturing[0] = {};
  texturing[0].alpha_mode = SurfaceTexturing::blend;
  texturing[0].alpha_factor = 0.3f;
  const Rig blend({mesh}, {{0, Affine()}}, texturing);
  std::mt19937 rng(9);
  std::uniform_real_distribution<float> uniform(0.05f, 0.95f);
  int hits = 0;
  const int n = 20000;
  for (int i = 0; i < n; ++i) {
    const Vec3 o(2 * uniform(rng), uniform(rng), 1);
    const bool stopped = blend.tracer->occluded(o, {0, 0, -1}, infinity);
    EXPECT_EQ(stopped, blend.tracer->intersect(o, {0, 0, -1}, infinity, hit));
    hits += stopped;
  }
  EXPECT_NEAR(hits, 0.3 * n, 5 * std::sqrt(0.3 * 0.7 * n));  // 5 sigma: false alarm 6e-7, seed fixed
}

TEST(Degenerate, TrianglesWithoutAreaAreLeftOut) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0.5f, 0, 0}};
  mesh.indices = {0, 1, 3, 0, 0, 1, 0, 1, 2, 2, 2, 2};
  const Rig rig({mesh}, {{0, Affine()}});
  Hit hit;
  ASSERT_TRUE(rig.tracer->intersect({0.2f, 0.2f, 1}, {0, 0, -1}, infinity, hit));
  EXPECT_EQ(hit.primitive, 2u);
  EXPECT_NEAR(hit.t, 1, 1e-6f);
  for (uint32_t primitive = 0; primitive < 4; ++primitive) {
    const SurfacePoint point = rig.tracer->surface_at(0, primitive, 0.25f, 0.25f);
    EXPECT_TRUE(is_finite(point.p) && is_finite(point.ng) && is_finite(point.shading.n));
    EXPECT_TRUE(is_finite(point.shading.s) && is_finite(point.shading.t) && std::isfinite(point.error));
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

// A long thin triangle and a ray that runs almost within its plane, past it: no hit may be reported far away from it.
TEST(FalseHits, NearParallelRaysStayOnTheTriangle) {
  std::mt19937 rng(21);
  std::uniform_real_distribution<float> uniform(-1, 1);
  int hits = 0;
  for (int k = 0; k < 300; ++k) {
    Mesh mesh;
    const Vec3 along = normalize(Vec3(uniform(rng), uniform(rng), uniform(rng)));
    const Vec3 aside = normalize(cross(along, Vec3(0.3f, 0.5f, uniform(rng))));
    const Vec3 a(uniform(rng), uniform(rng), uniform(rng));
    mesh.positions = {a, a + along, a + along * 0.5f + aside * 1e-5f};
    mesh.indices = {0, 1, 2};
    const Rig rig({mesh}, {{0, Affine()}});
    for (int j = 0; j < 300; ++j) {
      const Vec3 target = a + along * (0.5f + 0.5f * uniform(rng));
      const Vec3 d =
          normalize(along + Vec3(uniform(rng), uniform(rng), uniform(rng)) * std::pow(10.0f, 4 * uniform(rng) - 4));
      const Vec3 o = target - d * 2.0f;
      Hit hit;
      if (!rig.tracer->intersect(o, d, infinity, hit)) continue;
      ++hits;
      EXPECT_LT(length(o + d * hit.t - rig.tracer->surface_at(hit).p), 1.01f) << "t = " << hit.t;
      EXPECT_LT(hit.t, 4.0f);
    }
  }
  EXPECT_GT(hits, 100);
}

}  // namespace
}  // namespace ups
