// A ray tracer that shares parts with an earlier one finds the hits, to the bit, of one that is built anew.
#include <gtest/gtest.h>

#include <bit>
#include <random>

#include "base/warp.h"
#include "geometry/grouping.h"
#include "rig.h"

namespace ups {
namespace {

// A bumpy sheet of 2 side^2 triangles, `size` wide.
std::shared_ptr<const Mesh> sheet(uint32_t side, float size, uint32_t seed) {
  Mesh m;
  const uint32_t n = side + 1;
  for (uint32_t y = 0; y < n; ++y)
    for (uint32_t x = 0; x < n; ++x)
      m.positions.push_back({size * (float(x) / float(side) - 0.5f), size * (float(y) / float(side) - 0.5f),
                             0.03f * size * std::sin(0.7f * float(x + seed)) * std::cos(0.9f * float(y))});
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const uint32_t a = y * n + x;
      m.indices.insert(m.indices.end(), {a, a + 1, a + n, a + 1, a + n + 1, a + n});
    }
  return std::make_shared<const Mesh>(std::move(m));
}

std::shared_ptr<const Mesh> shell() { return std::make_shared<const Mesh>(box({-10, -10, -10}, {10, 10, 10})); }

class Edited : public testing::Test {
 protected:
  float uniform() { return std::uniform_real_distribution<float>(0, 1)(rng); }
  Vec3 point() { return Vec3(uniform(), uniform(), uniform()) * 16.0f - Vec3(8, 8, 8); }
  Affine place() { return tilted(1, Vec3d(point())); }
  Affine upright(double z) { return affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, 0, z}); }
  void add(std::shared_ptr<const Mesh> mesh, const Affine& to_scene) {
    meshes.push_back(std::move(mesh));
    instances.push_back({uint32_t(meshes.size() - 1), to_scene, ++last_number});
  }
  std::unique_ptr<Raytracer> build(const Raytracer* earlier, int threads = 2) {
    ThreadPool pool(threads);
    return std::make_unique<Raytracer>(meshes, instances, texturing, pool, false, earlier);
  }
  // Rays from anywhere, and at vertices, where the hit of several triangles is as near.
  void expect_same(const Raytracer& a, const Raytracer& b) {
    int differing = 0, hits = 0;
    for (int k = 0; k < 20000; ++k) {
      const Vec3 o = point();
      Vec3 d = square_to_sphere({uniform(), uniform()});
      if (k & 1) {
        const Raytracer::Instance& i = instances[rng() % instances.size()];
        const std::vector<Vec3>& p = meshes[i.mesh]->positions;
        d = normalize(Vec3(i.to_scene.point(Vec3d(p[rng() % p.size()])) - Vec3d(o)));
      }
      Hit hit_a{}, hit_b{};
      const bool hits_a = a.intersect(o, d, infinity, hit_a), hits_b = b.intersect(o, d, infinity, hit_b);
      hits += hits_a;
      differing += hits_a != hits_b || a.occluded(o, d, 5) != b.occluded(o, d, 5) ||
                   (hits_a && (bits(hit_a) != bits(hit_b) || bits(a.surface_at(hit_a)) != bits(b.surface_at(hit_b))));
    }
    EXPECT_EQ(differing, 0);
    EXPECT_GT(hits, 15000);
    EXPECT_EQ(a.triangle_count(), b.triangle_count());
    EXPECT_EQ(bits(a.bounds_min()), bits(b.bounds_min()));
    EXPECT_EQ(bits(a.bounds_max()), bits(b.bounds_max()));
  }

  std::mt19937 rng{11};
  Meshes meshes;
  Instances instances;
  std::vector<SurfaceTexturing> texturing = std::vector<SurfaceTexturing>(1);
  uint32_t last_number = 0;

 private:
  static std::vector<uint32_t> bits(const Vec3& v) {
    return {std::bit_cast<uint32_t>(v.x), std::bit_cast<uint32_t>(v.y), std::bit_cast<uint32_t>(v.z)};
  }
  static std::vector<uint32_t> bits(const Hit& h) {
    return {h.instance, h.primitive, std::bit_cast<uint32_t>(h.t), std::bit_cast<uint32_t>(h.u),
            std::bit_cast<uint32_t>(h.v)};
  }
  static std::vector<uint32_t> bits(const SurfacePoint& s) {
    std::vector<uint32_t> all = bits(s.p);
    for (const Vec3& v : {s.ng, s.shading.n, s.shading.s})
      for (const uint32_t b : bits(v)) all.push_back(b);
    all.push_back(std::bit_cast<uint32_t>(s.error));
    return all;
  }
};

// Moved, removed, added, bent: each build shares with the one before, the last is compared with one that shares nothing.
class RandomEdits : public Edited {
 protected:
  void run(int edits) {
    auto edited = build(nullptr);
    for (int i = 0; i < edits; ++i) {
      const size_t k = 1 + rng() % (instances.size() - 1);  // the shell stays
      switch (rng() % 5) {
        case 0: instances.erase(instances.begin() + ptrdiff_t(k)); break;
        case 1: add(sheet(40, 1, rng() % 100), place()); break;
        case 2: meshes[instances[k].mesh] = sheet(60, 1, rng() % 100); break;
        default: instances[k].to_scene = place();
      }
      edited = build(edited.get(), 1 + i % 3);
    }
    for (const int threads : {1, 2, 3}) expect_same(*edited, *build(nullptr, threads));
  }
};

TEST_F(RandomEdits, OfAScenesOneIndex) {
  add(shell(), Affine());
  for (uint32_t i = 0; i < 20; ++i) add(sheet(40, 1, i), place());  // 64,000 triangles
  run(8);
}

TEST_F(RandomEdits, OfGroups) {
  add(shell(), Affine());
  for (uint32_t i = 0; i < 60; ++i) add(sheet(40, 1, i), place());  // 192,000
  run(25);
}

TEST_F(RandomEdits, OfLargeMeshes) {
  add(shell(), Affine());
  add(sheet(250, 9, 1), place());  // 125,000 each
  add(sheet(250, 7, 2), place());
  const auto shared = sheet(30, 1, 3);
  for (int i = 0; i < 4; ++i) add(shared, place());
  for (uint32_t i = 0; i < 20; ++i) add(sheet(40, 1, i), place());
  run(15);
}

// Some of the larger meshes have an index each, so that the others need no groups; which these are changes.
TEST_F(RandomEdits, OfMeshesLargeEnoughForAnIndexEach) {
  add(shell(), Affine());
  for (uint32_t i = 0; i < 12; ++i) add(sheet(50 + 10 * (i % 5), 3, i), place());  // 5,000 to 16,200; 114,200 in all
  run(20);
}

// From a scene of one index to groups and back.
TEST_F(RandomEdits, AcrossTheSizesOfAnIndex) {
  add(shell(), Affine());
  for (uint32_t i = 0; i < 28; ++i) add(sheet(40, 1, i), place());  // 89,600; at 98,304 groups begin
  auto edited = build(nullptr);
  for (int round = 0; round < 3; ++round) {
    for (uint32_t i = 0; i < 6; ++i) add(sheet(40, 1, i), place()), edited = build(edited.get());
    expect_same(*edited, *build(nullptr));
    instances.resize(instances.size() - 6);
    edited = build(edited.get());
    expect_same(*edited, *build(nullptr));
  }
}

// Who moves a large mesh builds none of it.
TEST_F(Edited, AMovedMeshStaysAsItIs) {
  add(shell(), Affine());
  add(sheet(300, 9, 1), upright(0));
  for (uint32_t i = 0; i < 20; ++i) add(sheet(40, 1, i), place());
  const auto first = build(nullptr);
  instances[1].to_scene = upright(0.5);
  const auto moved = build(first.get());
  EXPECT_EQ(moved->shared_parts(*first), meshes.size());
  expect_same(*moved, *build(nullptr));
  instances[5].to_scene = place();
  const auto small = build(moved.get());
  EXPECT_EQ(small->shared_parts(*moved), meshes.size() - 1);
  expect_same(*small, *build(nullptr));
}

// A mesh far from its own origin would lose digits where rays are taken there.
TEST_F(Edited, AMeshFarFromItsOriginKeepsItsPrecision) {
  auto far_mesh = std::make_shared<Mesh>(*sheet(300, 9, 1));
  for (Vec3& p : far_mesh->positions) p.x += 4096;
  add(shell(), Affine());
  add(far_mesh, affine({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-4096, 0, 0}));
  const auto tracer = build(nullptr);
  EXPECT_LT(tracer->surface_at(1, 77, 0.3f, 0.3f).error, 3e-5f);
  meshes[1] = sheet(300, 9, 1);
  instances[1].to_scene = Affine();
  EXPECT_LT(build(nullptr)->surface_at(1, 77, 0.3f, 0.3f).error, 3e-5f);
}

// ---- grouping ----

std::vector<Thing> things_of(size_t count, size_t triangles, float size, std::mt19937& rng) {
  std::uniform_real_distribution<double> uniform(-20, 20);
  std::vector<Thing> all;
  for (uint32_t i = 0; i < count; ++i) {
    const Vec3d at(uniform(rng), uniform(rng), uniform(rng) / 8), half(size / 2, size / 2, size / 2);
    all.push_back({{at - half, at + half}, triangles, i + 1});
  }
  return all;
}

size_t triangles_of(const std::vector<uint32_t>& group, const std::vector<Thing>& things) {
  size_t sum = 0;
  for (const uint32_t i : group) sum += things[i].triangles;
  return sum;
}

void expect_all_once(const Grouping& grouping, const std::vector<Thing>& things) {
  std::vector<int> seen(things.size());
  for (const uint32_t i : grouping.ungrouped) ++seen[i];
  for (const auto& group : grouping.groups) {
    EXPECT_FALSE(group.empty());
    EXPECT_TRUE(std::is_sorted(group.begin(), group.end()));
    for (const uint32_t i : group) ++seen[i];
    EXPECT_TRUE(group.size() == 1 || triangles_of(group, things) <= group_triangles);
  }
  for (const int times : seen) EXPECT_EQ(times, 1);
}

TEST(Grouping, HasEachThingOnceAndGroupsOfOnePlace) {
  std::mt19937 rng(5);
  auto things = things_of(2000, 500, 1, rng);
  things.push_back({{{-20, -20, -3}, {20, 20, -3}}, 2, 2001});  // the floor
  const Grouping grouping = group_by_place(things);
  expect_all_once(grouping, things);
  EXPECT_EQ(grouping.ungrouped, std::vector<uint32_t>{2000});
  EXPECT_LT(grouping.groups.size(), 200u);
  double volume = 0;
  for (const auto& group : grouping.groups) {
    Box box;
    for (const uint32_t i : group) box.grow(things[i].box.lower), box.grow(things[i].box.upper);
    const Vec3d size = box.upper - box.lower;
    volume += size.x * size.y * size.z;
  }
  EXPECT_LT(volume, 3 * 41.0 * 41 * 6);  // they overlap little
}

TEST(Grouping, OfThingsInOnePlaceOrLargerThanAGroup) {
  std::vector<Thing> same(300, {{{1, 1, 1}, {1, 1, 1}}, 1000, 0});
  for (uint32_t i = 0; i < same.size(); ++i) same[i].number = i + 1;
  expect_all_once(group_by_place(same), same);
  std::vector<Thing> large(3, {{{-1, -1, -1}, {1, 1, 1}}, 2 * group_triangles, 0});
  large.push_back({Box(), 5, 9});  // of a mesh that has no vertices
  expect_all_once(group_by_place(large), large);
  expect_all_once(group_by_place({}), {});
}

// Moved or removed, a thing changes few groups.
TEST(Grouping, KeepsTheGroupsOfOthers) {
  std::mt19937 rng(6);
  auto things = things_of(3000, 300, 0.5f, rng);
  const auto named = [](const Grouping& g, const std::vector<Thing>& of) {  // by number and place
    std::vector<std::vector<std::pair<uint32_t, double>>> all;
    for (const auto& group : g.groups) {
      auto& names = all.emplace_back();
      for (const uint32_t i : group) names.emplace_back(of[i].number, of[i].box.lower.x);
    }
    return all;
  };
  size_t most = 0;
  for (int round = 0; round < 100; ++round) {
    const auto before = named(group_by_place(things), things);
    const std::vector<Thing> then = things;
    const size_t k = rng() % things.size();
    if (round % 4 == 0)
      things.erase(things.begin() + ptrdiff_t(k));
    else
      things[k].box = things_of(1, 1, 0.5f, rng)[0].box;
    size_t changed = 0;
    const Grouping now = group_by_place(things);
    const auto names = named(now, things);
    for (size_t g = 0; g < names.size(); ++g)
      if (std::find(before.begin(), before.end(), names[g]) == before.end())
        changed += triangles_of(now.groups[g], things);
    most = std::max(most, changed);
  }
  EXPECT_LE(most, 4 * group_triangles);
}

}  // namespace
}  // namespace ups
