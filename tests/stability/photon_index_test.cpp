// Does a query of the photon index find the photons within the radius, each once, however buckets collide?
#include <gtest/gtest.h>

#include <set>

#include "../support/figures.h"
#include "base/rng.h"
#include "transport/photon_index.h"

namespace {

using namespace ups;

Vec3 random_point(uint32_t i, float scale, float offset) {
  const auto bits = philox({i, 0, 0, 0}, {42, 0});
  return {to_unit_float(bits[0]) * scale + offset, to_unit_float(bits[1]) * scale + offset,
          to_unit_float(bits[2]) * scale};
}

void compare(const std::vector<StoredPhoton>& photons, float radius, const std::vector<Vec3>& queries) {
  const PhotonIndex index(LightPaths::of(photons), radius);
  size_t found_any = 0;
  for (const Vec3& q : queries) {
    std::multiset<uint32_t> found, expected;
    index.query(q, radius, [&](const PhotonIndex::Photon& f, float) { found.insert(f.place); });
    for (const StoredPhoton& f : photons)
      if (length2(f.p - q) < radius * radius) expected.insert(f.vertex);
    ASSERT_EQ(found, expected);
    found_any += found.size();
  }
  test::measured("%zu queries among %zu photons: the sets of brute force, %zu in all", queries.size(), photons.size(),
                 found_any);
  EXPECT_GT(found_any, 0u);
}

// 60 photons make 64 buckets: cells of one query share buckets often.
TEST(Hazard23, CellsThatShareABucketCountOnce) {
  for (float offset : {-0.5f, 1000.0f}) {
    std::vector<StoredPhoton> photons;
    std::vector<Vec3> queries;
    for (uint32_t i = 0; i < 60; ++i)
      if (i % 7 != 0) photons.push_back({random_point(i, 1, offset), i});
    for (uint32_t i = 0; i < 500; ++i) queries.push_back(random_point(1000 + i, 1, offset));
    compare(photons, 0.11f, queries);
  }
}

// Of a crowd each k-th of all its cells' photons is looked at: those that the k starts find are all, each once.
TEST(Hazard22, TheStartsOfACrowdShareItsPhotons) {
  std::vector<StoredPhoton> photons;
  for (uint32_t i = 0; i < 1000; ++i) photons.push_back({random_point(i, 0.4f, -0.2f), i});
  const PhotonIndex index(LightPaths::of(photons), 0.1f);
  std::multiset<uint32_t> expected, found;
  index.query({0, 0, 0.2f}, 0.1f, [&](const PhotonIndex::Photon& f, float) { expected.insert(f.place); });
  constexpr uint32_t stride = 7;
  for (uint32_t first = 0; first < stride; ++first) {
    PhotonIndex::Query q;
    index.ask({0, 0, 0.2f}, 0.1f, q);
    index.find_rows(q);
    q.stride = stride, q.first = first;
    uint64_t visited = 0;
    index.visit(q, [&](const PhotonIndex::Photon& f, float) { found.insert(f.place), ++visited; });
    EXPECT_LE(visited, q.candidates / stride + 1);
  }
  EXPECT_GT(expected.size(), 20u);
  EXPECT_EQ(found, expected);
}

// Coplanar photons, queried in their plane and a step of a float beside it.
TEST(Hazard24, FlatPhotonsAreNotLostToRounding) {
  std::vector<StoredPhoton> photons;
  std::vector<Vec3> queries;
  for (uint32_t i = 0; i < 2000; ++i) {
    photons.push_back({random_point(i, 1, 0), i});
    photons.back().p.z = 0.75f;
  }
  for (uint32_t i = 0; i < 300; ++i) {
    Vec3 q = random_point(5000 + i, 1, 0);
    q.z = i % 3 == 0 ? 0.75f : std::nextafter(0.75f, i % 3 == 1 ? 0.0f : 1.0f);
    queries.push_back(q);
  }
  compare(photons, 0.05f, queries);
}

// Far from the origin, a radius of a few steps of a float; one photon; and clusters with nothing in between.
TEST(Hazard24, SparsePhotonsAreNotLostToRounding) {
  for (const float offset : {0.0f, 1000.0f})
    for (const uint32_t count : {1u, 2u, 40u})
      for (const float radius : {2e-4f, 0.02f}) {
        std::vector<StoredPhoton> photons;
        std::vector<Vec3> queries;
        for (uint32_t i = 0; i < count; ++i) {
          photons.push_back({random_point(i, radius, offset + float(i % 2)), i});
          for (uint32_t k = 0; k < 100; ++k)
            queries.push_back(photons[i].p + (random_point(100 * i + k, 2, 0) - Vec3(1, 1, 1)) * radius);
        }
        compare(photons, radius, queries);
      }
}

TEST(Hazard24, AnEmptyIndexFindsNothing) {
  const auto fail = [](const PhotonIndex::Photon&, float) { FAIL(); };
  PhotonIndex().query({0, 0, 0}, 1.0f, fail);
  PhotonIndex(LightPaths(), 1.0f).query({0, 0, 0}, 1.0f, fail);
}

// What is cut off is of no use, but may be asked.
TEST(Hazard24, AnIndexThatIsStoppedFindsNothing) {
  const std::vector<StoredPhoton> photons(100);
  StopSignal stop;
  stop.cancel();
  PhotonIndex index(LightPaths::of(photons), 1.0f, stop);
  EXPECT_TRUE(index.empty());
  index.query({0, 0, 0}, 1.0f, [](const PhotonIndex::Photon&, float) { FAIL(); });
}

}  // namespace
