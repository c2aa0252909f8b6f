// Hazard 8: rays that leave a surface hit it again, or slip through the edge between two triangles.
#include <gtest/gtest.h>

#include <random>

#include "../geometry/rig.h"
#include "base/warp.h"
#include "../support/figures.h"

namespace ups {
namespace {

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

// Not one ray leaves a closed room, hits the surface that it has just left, or is blocked on its way to what it hits.
// None among n says, at 95 %, that fewer than 3 / n do: 7.5e-6 for a room of the fast form, 3e-8 of the full one.
void expect_tight(const Rig& rig, const Vec3& start, size_t in_full = 100'000'000) {
  const Leaks leaks = walk_in_room(*rig.tracer, start, test::fast_or_full<size_t>(400'000, in_full), 11);
  test::measured("%zu rays: %zu escaped, %zu hit their own surface, %zu blocked", leaks.rays, leaks.escaped,
                 leaks.self_hits, leaks.blocked);
  EXPECT_EQ(leaks.escaped, 0u);
  EXPECT_EQ(leaks.self_hits, 0u);
  EXPECT_EQ(leaks.blocked, 0u);
}

void expect_tight_at_scale(float s) {
  expect_tight(Rig({box({-1.3f * s, -1.7f * s, -0.9f * s}, {1.1f * s, 1.9f * s, 1.3f * s})}, {{0, Affine()}}),
               {0.1f * s, 0.1f * s, 0.1f * s});
}
TEST(Hazard08, AClosedRoomIsTightInMillimetres) { expect_tight_at_scale(1e-3f); }
TEST(Hazard08, AClosedRoomIsTightInMetres) { expect_tight_at_scale(1); }
TEST(Hazard08, AClosedRoomIsTightInHundredsOfKilometres) { expect_tight_at_scale(1e5f); }

TEST(Hazard08, AClosedRoomIsTightWhenTilted) {
  expect_tight(Rig({box({-2, -3, -1}, {2, 3, 1})}, {{0, tilted(1, {0, 0, 0})}}), {0, 0, 0},
               30'000'000);
}

// At 3 km a float's steps are 0.24 mm.
TEST(Hazard08, AClosedRoomIsTightFarFromTheOrigin) {
  expect_tight(Rig({box({-2, -3, -1}, {2, 3, 1})}, {{0, tilted(1, {3000, -2000, 500})}}), {3000, -2000, 500},
               30'000'000);
}

TEST(Hazard08, AClosedRoomIsTightAsAnInstance) {
  // The second room is elsewhere: it only makes the first an instance.
  expect_tight(Rig({box({-2, -3, -1}, {2, 3, 1})}, {{0, tilted(1.5, {40, -30, 20})}, {0, tilted(1, {-40, 30, -20})}}),
               {40, -30, 20}, 10'000'000);
}

TEST(Hazard08, AClosedRoomIsTightWithLongThinTriangles) {
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
  expect_tight(Rig({room}, {{0, Affine()}}), {0, 0, 0}, 10'000'000);
}

}  // namespace
}  // namespace ups
