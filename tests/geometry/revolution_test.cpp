// Surfaces of revolution: hits, normals and addresses against closed forms in double; solids of them do not leak,
// alone, tilted, far away and as instances; a point's address leads back to it; all hits of a ray are found, once.
#include <gtest/gtest.h>

#include <random>

#include "base/parallel.h"
#include "base/warp.h"
#include "geometry/raytracer.h"
#include "photometry/optics.h"

namespace ups {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

// As src/api makes a part of a fixture: the triangles for the addresses, the bands for the rays.
std::shared_ptr<const Mesh> round_mesh(const optics::Profile& profile, const optics::Tolerance& tolerance) {
  const optics::Mesh from = optics::tessellate(profile, tolerance);
  auto mesh = std::make_shared<Mesh>();
  for (size_t i = 0; i < from.positions.size(); i += 3)
    mesh->positions.push_back({from.positions[i], from.positions[i + 1], from.positions[i + 2]});
  mesh->indices = from.indices;
  auto shape = std::make_shared<Revolution>();
  shape->columns = from.columns, shape->margin = 1e-10 * optics::largest_radius(profile);
  uint32_t triangle = 0;
  for (const optics::Band& b : from.bands) {
    shape->bands.push_back(
        {b.from.r, b.from.z, b.to.r, b.to.z, b.square_r, b.square_z, b.linear, b.bulge, triangle});
    triangle += from.columns * (b.from.r == 0 || b.to.r == 0 ? 1 : 2);
  }
  EXPECT_EQ(triangle, mesh->triangle_count());
  mesh->revolution = std::move(shape);
  return mesh;
}

constexpr optics::Tolerance coarse{0.02, 0.3};  // of shapes of some decimetres: triangles would be far off

Affine placed(double angle, const Vec3d& t) {  // turned about x
  Affine a;
  a.m[5] = a.m[10] = std::cos(angle), a.m[6] = -std::sin(angle), a.m[9] = std::sin(angle);
  a.m[3] = t.x, a.m[7] = t.y, a.m[11] = t.z;
  return a;
}

struct Rig {
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<SurfaceTexturing> texturing;
  std::unique_ptr<Raytracer> tracer;
  Rig(std::shared_ptr<const Mesh> mesh, const std::vector<Affine>& places, const SurfaceTexturing& t = {})
      : meshes{std::move(mesh)}, texturing{t} {
    std::vector<Raytracer::Instance> instances;
    for (const Affine& a : places) instances.push_back({0, a});
    ThreadPool pool(2);
    tracer = std::make_unique<Raytracer>(meshes, instances, texturing, pool, true);
  }
};

struct Truth {
  double t;
  Vec3d n;
};

// One mesh, traced alone and as one of two instances, hit by rays from everywhere. `truth` has a ray of the shape's own
// frame (misses: t is infinite). Rays that pass an edge within 1e-6 of the size may go either way.
template <class Exact>
void expect_hits(const std::shared_ptr<const Mesh>& mesh, const Exact& truth) {
  const Affine here = placed(0.7, {0.3, -0.2, 0.5}), elsewhere = placed(-0.4, {3, 2, 1});
  std::mt19937 rng(5);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (const auto& places : {std::vector{here}, std::vector{here, elsewhere}}) {
    const Rig rig(mesh, places);
    int hits = 0, differ = 0;
    for (int i = 0; i < 20000; ++i) {
      const Vec3d own_o(0.6 * uniform(rng), 0.6 * uniform(rng), 0.6 * uniform(rng));
      const Vec3 o(here.point(own_o)), d = normalize(Vec3(uniform(rng), uniform(rng), uniform(rng)));
      Affine back = placed(-0.7, {});  // the inverse rotation
      const Truth exact = truth(back.vector(Vec3d(o) - here.column(3)), back.vector(Vec3d(d)));
      Hit hit;
      const bool met = rig.tracer->intersect(o, d, 2, hit) && hit.instance == 0;
      EXPECT_EQ(rig.tracer->occluded(o, d, 2), rig.tracer->intersect(o, d, 2, hit));
      if (met != (exact.t < 2) || (met && std::abs(hit.t - exact.t) > 1e-4)) {
        ++differ;  // at an edge, or grazing
        continue;
      }
      if (!met) continue;
      ++hits;
      const SurfacePoint point = rig.tracer->surface_at(hit);
      EXPECT_LT(length(Vec3d(point.p) - (Vec3d(o) + Vec3d(d) * exact.t)),
                3e-6 / std::max(0.01, std::abs(dot(exact.n, back.vector(Vec3d(d))))));
      EXPECT_LT(length(Vec3d(point.ng) - here.vector(exact.n)), 2e-4);  // what a quadric may differ from its profile
      EXPECT_EQ(dot(point.ng, point.shading.n), dot(point.ng, point.ng));
    }
    EXPECT_GT(hits, 500);
    EXPECT_LE(differ, 5);
  }
}

TEST(Revolution, ConeIsHitWhereItIs) {
  const double r0 = 0.1, r1 = 0.3, depth = 0.4, k = (r1 - r0) / depth;
  expect_hits(round_mesh(optics::cone(r0, r1, depth), coarse), [=](const Vec3d& o, const Vec3d& d) {
    const double a = d.x * d.x + d.y * d.y - k * k * d.z * d.z, c = r0 - k * o.z;
    const double b = o.x * d.x + o.y * d.y + k * d.z * c, root = b * b - a * (o.x * o.x + o.y * o.y - c * c);
    Truth out{INFINITY, {}};
    if (root < 0) return out;
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-b + sign * std::sqrt(root)) / a;
      const Vec3d p = o + d * t;
      if (!(t > 0 && t < out.t && p.z <= 0 && p.z >= -depth)) continue;
      const double r = std::hypot(p.x, p.y);
      out = {t, normalize(Vec3d(-p.x / r, -p.y / r, -k))};
    }
    return out;
  });
}

TEST(Revolution, ParaboloidIsHitWhereItIs) {
  const double f = 0.1, rim = 0.3;
  expect_hits(round_mesh(optics::paraboloid(f, 0, rim), coarse), [=](const Vec3d& o, const Vec3d& d) {
    const double a = d.x * d.x + d.y * d.y, b = o.x * d.x + o.y * d.y + 2 * f * d.z;
    const double root = b * b - a * (o.x * o.x + o.y * o.y + 4 * f * (o.z - f));
    Truth out{INFINITY, {}};
    if (root < 0) return out;
    for (const double sign : {-1.0, 1.0}) {
      const double t = (-b + sign * std::sqrt(root)) / a;
      const Vec3d p = o + d * t;
      if (t > 0 && t < out.t && std::hypot(p.x, p.y) <= rim) out = {t, normalize(Vec3d(-p.x, -p.y, -2 * f))};
    }
    return out;
  });
}

TEST(Revolution, SphereIsHitWhereItIs) {
  const double r = 0.25;
  expect_hits(round_mesh(optics::sphere(r), coarse), [=](const Vec3d& o, const Vec3d& d) {
    const double b = dot(o, d), root = b * b - dot(o, o) + r * r;
    if (root < 0) return Truth{INFINITY, {}};
    const double t = -b - std::sqrt(root) > 0 ? -b - std::sqrt(root) : -b + std::sqrt(root);
    return t > 0 ? Truth{t, normalize(o + d * t)} : Truth{INFINITY, {}};
  });
}

// An asphere off its axis' pole is no quadric: many bands, and still the profile's own surface.
TEST(Revolution, SplineIsHitWhereItIs) {
  const std::vector<optics::Point> points{{0, 0}, {0.1, -0.02}, {0.2, -0.09}, {0.25, -0.2}, {0.26, -0.35}};
  const optics::Profile profile = optics::polyline(points, true);
  const Rig rig(round_mesh(profile, coarse), {Affine()});
  for (const optics::Section& section : profile.sections)
    for (int i = 1; i < 40; ++i) {  // from beside each point, along its normal
      const optics::ProfilePoint p = section.at(i / 40.0);
      const Vec3d turned(std::cos(0.1 * i), std::sin(0.1 * i), 0);
      const Vec3d at = turned * p.r + Vec3d(0, 0, p.z), n = turned * p.normal_r + Vec3d(0, 0, p.normal_z);
      Hit hit;
      ASSERT_TRUE(rig.tracer->intersect(Vec3(at + n * 0.01), Vec3(-n), 0.1f, hit));
      EXPECT_NEAR(double(hit.t), 0.01, 1e-7);
      const SurfacePoint point = rig.tracer->surface_at(hit);
      // kept off the end of a band by its error; the quadric's own is 1e-7 of 0.26 m
      EXPECT_LT(length(Vec3d(point.p) - at), double(point.error) + 3e-8);
      EXPECT_LT(length(Vec3d(point.ng) - n), 1.1e-4);
    }
}

// Diffuse walks, a fifth of them grazing, inside a closed solid: none leaves it, neighbours see each other.
void expect_tight(const Rig& rig, const Affine& frame, const Vec3d& start, size_t count) {
  std::mt19937 rng(11);
  std::uniform_real_distribution<float> uniform(0, 1);
  size_t escaped = 0, blocked = 0, rays = 0;
  while (rays < count) {
    Hit hit;
    const Vec3 first = square_to_sphere({uniform(rng), uniform(rng)});
    if (!rig.tracer->intersect(Vec3(frame.point(start)), first, infinity, hit)) {
      ++escaped, ++rays;
      continue;
    }
    SurfacePoint point = rig.tracer->surface_at(hit);
    for (int bounce = 0; bounce < 50; ++bounce, ++rays) {
      Vec3 local = square_to_cosine_hemisphere({uniform(rng), uniform(rng)});
      if (bounce % 5 == 0) local = normalize(Vec3(local.x, local.y, local.z * 1e-2f));
      if (local.z < 1e-6f) continue;
      const Vec3 d = Frame(-point.ng).to_world(local);  // the front is outside
      if (!rig.tracer->intersect(point.ray_origin(d), d, infinity, hit)) {
        ++escaped;
        break;
      }
      const SurfacePoint next = rig.tracer->surface_at(hit);
      blocked += !rig.tracer->visible(point, next);
      point = next;
    }
  }
  EXPECT_EQ(escaped, 0u);
  EXPECT_EQ(blocked, 0u);
}

TEST(Revolution, SolidsAreTight) {
  const optics::Face convex{0.2, -0.5, {}}, aspheric{0.4, 0, {0.3, 0, 0, 0}};
  const auto lens = round_mesh(optics::lens(convex, aspheric, 0.15, 0.12), coarse);
  const auto can = round_mesh(optics::cylinder(0.2, 0.3), coarse);
  for (const auto& [mesh, start] : {std::pair{lens, Vec3d(0, 0, -0.06)}, std::pair{can, Vec3d()}})
    for (const Affine& frame : {Affine(), placed(0.6, {0.1, 0.2, 0.3}), placed(0.6, {30, -20, 5})}) {
      expect_tight(Rig(mesh, {frame}), frame, start, 40'000);
      expect_tight(Rig(mesh, {frame, placed(0.2, {-3, 1, 2})}), frame, start, 40'000);
    }
}

// Light that grazes the inside of a sphere goes on by chords of 2 R sin(angle): triangles under interpolated normals
// send it into their neighbours, or past them.
TEST(Revolution, GrazingLightKeepsItsChords) {
  const double r = 0.25, angle = 0.02, chord = 2 * r * std::sin(angle);
  const Rig rig(round_mesh(optics::sphere(r), coarse), {Affine()});
  SurfacePoint point;
  Vec3 o(0.2499999f, 0, 0), d(float(-std::sin(angle)), float(std::cos(angle)), 0);
  for (int bounce = 0; bounce < 15; ++bounce) {
    Hit hit;
    ASSERT_TRUE(rig.tracer->intersect(o, d, infinity, hit));
    point = rig.tracer->surface_at(hit);
    ASSERT_LT(point.error, 5e-7f);
    // A ray starts 2 errors off the surface: its chord is longer by that over the sine, and so is each one after it.
    ASSERT_NEAR(double(hit.t), chord, (bounce + 2) * 4 * double(point.error) / angle) << bounce;
    ASSERT_NEAR(double(length(point.p)), r, 1e-7);
    d = normalize(d - point.ng * (2 * dot(d, point.ng)));
    o = point.ray_origin(d);
  }
}

TEST(Revolution, AllHitsAreFoundOnce) {
  const auto ball = round_mesh(optics::sphere(0.25), coarse);
  std::mt19937 rng(3);
  std::uniform_real_distribution<float> uniform(-1, 1);
  for (const auto& places : {std::vector{Affine()}, std::vector{Affine(), placed(0, {3, 0, 0})},
                             std::vector{Affine(), placed(0.3, {}), placed(0, {9, 0, 0})}}) {
    const Rig rig(ball, places);
    const size_t balls = places.size() == 3 ? 2 : 1;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 o = normalize(Vec3(uniform(rng), uniform(rng), uniform(rng)));
      const Vec3 d = normalize(Vec3(uniform(rng), uniform(rng), uniform(rng)) * 0.14f - o);  // meets the ball
      const double half = std::sqrt(0.0625 - length2(cross(Vec3d(o), Vec3d(d)))), middle = -dot(Vec3d(o), Vec3d(d));
      std::vector<Hit> hits;
      rig.tracer->intersect_all(o, d, 2, hits);
      ASSERT_EQ(hits.size(), 2 * balls);
      for (size_t k = 0; k < hits.size(); ++k)
        EXPECT_NEAR(double(hits[k].t), middle + (k < balls ? -half : half), 1e-5);
    }
  }
}

// Without UVs a mask cuts all of a part or nothing.
TEST(Revolution, MaskCutsAndBlendIsThereForEachRay) {
  const auto ball = round_mesh(optics::sphere(0.25), coarse);
  const Vec3 o(0.01f, 0.02f, 1), d(0, 0, -1);
  const auto expect = [&](bool there, const SurfaceTexturing& t) {
    for (const auto& places : {std::vector{Affine()}, std::vector{Affine(), placed(0, {3, 0, 0})}}) {
      const Rig rig(ball, places, t);
      Hit hit;
      std::vector<Hit> hits;
      EXPECT_EQ(rig.tracer->intersect(o, d, 2, hit), there);
      EXPECT_EQ(rig.tracer->occluded(o, d, 2), there);
      rig.tracer->intersect_all(o, d, 2, hits);
      EXPECT_EQ(hits.size(), there ? 2u : 0u);
    }
  };
  const Texture faint(1, 1, 4, {1, 1, 1, 0.3f});
  SurfaceTexturing t;
  t.alpha_mode = SurfaceTexturing::mask;
  expect(true, t);
  t.alpha_factor = 0.4f;
  expect(false, t);
  t.alpha_cutoff = 0.25f;
  expect(true, t);
  t.alpha = &faint;
  expect(false, t);
  t.alpha_mode = SurfaceTexturing::blend;
  expect(true, t);
}

TEST(Revolution, AddressesLeadBackToTheirPoints) {
  const auto mesh = round_mesh(optics::lens({0.2, 0, {}}, {}, 0.15, 0.1), coarse);
  const Rig rig(mesh, {Affine()});
  std::mt19937 rng(7);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int i = 0; i < 5000; ++i) {
    const uint32_t primitive = uint32_t(rng() % mesh->triangle_count());
    const Vec2 uv = square_to_triangle({uniform(rng), uniform(rng)});
    const SurfacePoint point = rig.tracer->surface_at(0, primitive, uv.x, uv.y);
    Hit hit;
    ASSERT_TRUE(rig.tracer->intersect(point.p + point.ng * 1e-4f, -point.ng, 1e-3f, hit));
    EXPECT_NEAR(double(hit.t), 1e-4, 1e-6);
    const SurfacePoint again = rig.tracer->surface_at(hit);
    EXPECT_LT(length(again.p - point.p), 1e-6f);
    EXPECT_LT(length(again.ng - point.ng), 1e-4f);
    const uint32_t* v = &mesh->indices[3 * size_t(primitive)];  // the triangle is near, if not there
    const Vec3 flat = mesh->positions[v[0]] * (1 - uv.x - uv.y) + mesh->positions[v[1]] * uv.x +
                      mesh->positions[v[2]] * uv.y;
    EXPECT_LT(length(flat - point.p), 0.03f);
  }
}

}  // namespace
}  // namespace ups
