// The disc index against every disc tested in turn, in long double; few discs and many take different ways.
#include <gtest/gtest.h>

#include <random>

#include "geometry/raytracer.h"

namespace ups {
namespace {

using Discs = std::vector<DiscIndex::Disc>;

Vec3 random_direction(std::mt19937& rng) {
  std::normal_distribution<float> normal;
  return normalize(Vec3(normal(rng), normal(rng), normal(rng)));
}

Discs random_discs(size_t count, float scale, const Vec3& offset, std::mt19937& rng) {
  std::uniform_real_distribution<float> uniform(-1, 1);
  Discs discs;
  for (size_t i = 0; i < count; ++i) {
    Vec3 n = random_direction(rng);
    if (i % 3 == 0) n = {0, 0, 1};  // flat boxes, as a grid of meters has
    if (i % 4 == 1) n = {};         // a ball
    discs.push_back({offset + Vec3(uniform(rng), uniform(rng), uniform(rng)) * scale, n, scale * 0.3f});
  }
  return discs;
}

// As above; of a ball, by the nearest point of the segment.
long double ball_margin(const DiscIndex::Disc& ball, const Vec3& o, const Vec3& d, float tmax) {
  using V = Vec3T<long double>;
  const V to_center = V(ball.center) - V(o);
  const long double t = std::clamp(dot(to_center, V(d)), 0.0L, static_cast<long double>(tmax));
  return (ball.radius - length(V(d) * t - to_center)) / ball.radius;
}

// How far inside (> 0) or outside all of a crossing's conditions the line is; near 0 rounding decides.
long double margin(const DiscIndex::Disc& disc, const Vec3& o, const Vec3& d, float tmax) {
  using V = Vec3T<long double>;
  if (length2(disc.normal) == 0) return ball_margin(disc, o, d, tmax);
  const V n(disc.normal), c(disc.center);
  const long double divisor = dot(V(d), n);
  if (divisor == 0) return -1;
  const long double t = dot(c - V(o), n) / divisor;
  const long double beside = length(V(o) + V(d) * t - c);
  return std::min({t, tmax - t, disc.radius - beside}) / disc.radius;
}

// The segment's direction is a unit vector to a float's digits, which the nearest point to a ball's centre shows.
long double undecidable(const DiscIndex::Disc& disc) { return length2(disc.normal) == 0 ? 1e-6L : 1e-9L; }

void compare(size_t count, float scale, const Vec3& offset) {
  std::mt19937 rng(7);
  std::uniform_real_distribution<float> uniform(-1.5f, 1.5f);
  const Discs discs = random_discs(count, scale, offset, rng);
  const DiscIndex index(discs);
  std::vector<DiscIndex::Crossing> found;
  size_t crossings = 0, undecided = 0;
  const int segments = count > 4 ? 3000 : 60000;
  for (int k = 0; k < segments; ++k) {
    const Vec3 o = offset + Vec3(uniform(rng), uniform(rng), uniform(rng)) * scale;
    Vec3 d = random_direction(rng);
    if (k % 5 == 0) d = normalize(Vec3(d.x, d.y, d.z * 1e-3f));  // nearly within the flat discs
    const float tmax = k % 7 == 0 ? std::numeric_limits<float>::infinity() : scale * std::abs(uniform(rng));
    found.clear();
    index.intersect_all(o, d, tmax, found);
    size_t next = 0;
    for (uint32_t i = 0; i < discs.size(); ++i) {
      const bool reported = next < found.size() && found[next].disc == i;
      if (reported) ++next;
      const long double m = margin(discs[i], o, d, tmax);
      if (std::abs(m) < undecidable(discs[i])) {
        ++undecided;
        continue;
      }
      ASSERT_EQ(reported, m > 0) << "disc " << i << ", segment " << k << ", margin " << double(m);
      crossings += reported;
    }
    ASSERT_EQ(next, found.size()) << "not sorted, or a disc twice";
  }
  EXPECT_GT(crossings, 500u);
  EXPECT_LE(undecided, crossings / 1000);
}

TEST(DiscIndex, FewDiscs) { compare(4, 1, {0, 0, 0}); }
TEST(DiscIndex, ManyDiscs) { compare(400, 1, {0, 0, 0}); }
TEST(DiscIndex, SmallAndOffCentre) { compare(400, 1e-3f, {0.5f, -0.25f, 1}); }
TEST(DiscIndex, Huge) { compare(400, 1e5f, {0, 0, 0}); }

TEST(DiscIndex, CrossingsKeepWhatWasFoundBefore) {
  Discs discs;
  for (int i = 0; i < 8; ++i) discs.push_back({{0, 0, float(i)}, {0, 0, 1}, 1});
  const DiscIndex index(discs);
  std::vector<DiscIndex::Crossing> found{{99, -1.0f}};
  index.intersect_all({0.1f, 0.2f, 5}, {0, 0, -1}, 2, found);  // both ends lie on discs: they count
  ASSERT_EQ(found.size(), 4u);
  EXPECT_EQ(found[0].disc, 99u);
  EXPECT_EQ(found[1].disc, 3u);
  EXPECT_EQ(found[3].disc, 5u);
  EXPECT_EQ(found[3].t, 0);
  EXPECT_FALSE(index.empty());
  EXPECT_TRUE(DiscIndex({}).empty());
}

TEST(DiscIndex, BallsAreCrossedWhereTheyAreEntered) {
  for (const size_t count : {size_t(1), size_t(20)}) {
    Discs balls;
    for (size_t i = 0; i < count; ++i) balls.push_back({{0, 0, float(3 * i)}, {}, 1});
    const DiscIndex index(balls);
    std::vector<DiscIndex::Crossing> found;
    index.intersect_all({0, 0, -2}, {0, 0, 1}, 2, found);
    ASSERT_EQ(found.size(), 1u);
    EXPECT_FLOAT_EQ(found[0].t, 1);
    index.intersect_all({0, 0, 0.5f}, {0, 0, 1}, 1, found);  // from inside
    ASSERT_EQ(found.size(), 2u);
    EXPECT_EQ(found[1].t, 0);
    index.intersect_all({0, 0, -2}, {0, 0, -1}, 9, found);      // behind
    index.intersect_all({0, 0, -2}, {0, 0, 1}, 0.9f, found);    // ends before it
    index.intersect_all({1.01f, 0, -2}, {0, 0, 1}, 90, found);  // beside
    EXPECT_EQ(found.size(), 2u);
  }
}

TEST(DiscIndex, OneThatIsStoppedFindsNothing) {
  Discs discs;
  for (int i = 0; i < 10000; ++i) discs.push_back({{0, 0, float(i)}, {0, 0, 1}, 1});
  StopSignal stop;
  stop.cancel();
  const DiscIndex index(discs, stop);
  EXPECT_TRUE(index.empty());
  std::vector<DiscIndex::Crossing> found;
  index.intersect_all({0, 0, -1}, {0, 0, 1}, 1e6f, found);
  EXPECT_TRUE(found.empty());
}

}  // namespace
}  // namespace ups
