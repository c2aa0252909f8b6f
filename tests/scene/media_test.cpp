// The order of media, which meshes are solids, and the stack that a walk carries.
#include "scene/media.h"

#include <gtest/gtest.h>

namespace ups {
namespace {

TEST(MediaStack, TheStrongestIsOnTop) {
  MediaStack stack;
  EXPECT_EQ(stack.top(), none);
  for (const uint32_t m : {5u, 2u, 7u, 2u}) stack.add(m);
  EXPECT_EQ(stack.top(), 2u);
  stack.set_open(1);
  EXPECT_EQ(stack.top(), 1u);
  stack.set_open(3);
  stack.remove(2);
  stack.remove(4);  // not there
  EXPECT_EQ(stack.top(), 3u);
  stack.set_open(none);
  stack.remove(5);
  EXPECT_EQ(stack.top(), 7u);
  stack.remove(7);
  EXPECT_TRUE(stack == MediaStack());
}

TEST(MediaStack, ForgetsTheWeakestBeyondItsCapacity) {
  MediaStack stack;
  for (uint32_t m = 20; m > 8; --m) stack.add(m);
  for (uint32_t m = 9; m < 9 + MediaStack::capacity; ++m) {
    EXPECT_EQ(stack.top(), m);
    stack.remove(m);
  }
  EXPECT_EQ(stack.top(), none);
}

struct Solids {
  std::vector<std::shared_ptr<const Mesh>> meshes;
  std::vector<Raytracer::Instance> instances;
  std::vector<Material> materials;
  std::vector<SurfaceTexturing> texturing;

  uint32_t glass(float ior, int32_t priority = 0) {
    Material m;
    m.model = MaterialModel::glass;
    m.ior = ior, m.priority = priority;
    materials.push_back(m);
    texturing.emplace_back();
    return uint32_t(materials.size() - 1);
  }
  // A unit cube, or what `triangles` of its 12 leave, placed as a cube of another size.
  void cube(uint32_t material, double x, double size, size_t triangles = 12) {
    Mesh m;
    for (int k = 0; k < 8; ++k) m.positions.push_back(Vec3(float(k & 1), float(k >> 1 & 1), float(k >> 2)));
    m.indices = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                 2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    m.indices.resize(3 * triangles);
    Affine place;
    const double rows[12] = {size, 0, 0, x, 0, size, 0, 0, 0, 0, size, 0};
    std::copy(std::begin(rows), std::end(rows), place.m);
    instances.push_back({uint32_t(meshes.size()), place, 0, material});
    meshes.push_back(std::make_shared<Mesh>(std::move(m)));
  }
  // The winding of an instance's mesh.
  void turn(size_t i) {
    edit(i, [](Mesh& m) {
      for (size_t t = 0; t < m.indices.size(); t += 3) std::swap(m.indices[t + 1], m.indices[t + 2]);
    });
  }
  // The surface of a hollow around the middle, the same but smaller and turned.
  void add_shell(size_t i, float size) {
    edit(i, [&](Mesh& m) {
      const Vec3 middle(0.5f, 0.5f, 0.5f);
      const auto first = uint32_t(m.positions.size());
      const std::vector<uint32_t> outer = m.indices;
      for (uint32_t v = 0; v < first; ++v) m.positions.push_back(middle + (m.positions[v] - middle) * size);
      for (size_t t = 0; t < outer.size(); t += 3)
        for (const size_t k : {t, t + 2, t + 1}) m.indices.push_back(first + outer[k]);
    });
  }
  // Each triangle with its back.
  void double_sheets(size_t i) {
    edit(i, [](Mesh& m) {
      const std::vector<uint32_t> front = m.indices;
      for (size_t t = 0; t < front.size(); t += 3)
        for (const size_t k : {t, t + 2, t + 1}) m.indices.push_back(front[k]);
    });
  }
  template <class Change>
  void edit(size_t i, const Change& change) {
    auto mesh = std::make_shared<Mesh>(*meshes[instances[i].mesh]);
    change(*mesh);
    meshes[instances[i].mesh] = mesh;
  }
  Media rank() const { return rank_media(meshes, instances, materials, texturing); }
};

TEST(Media, ByPriorityThenByVolume) {
  Solids s;
  const uint32_t a = s.glass(1.5f), b = s.glass(1.3f), strong = s.glass(1.7f, 2), weak = s.glass(1.6f, -1);
  s.cube(a, 0, 3);
  s.cube(weak, 0.1, 0.5);
  s.cube(b, 0.2, 2);
  s.cube(strong, 0.3, 4);
  s.cube(b, 0.4, 1, 10);  // open: weaker than any solid of its priority
  const Media media = s.rank();
  EXPECT_TRUE(media.nest);
  EXPECT_EQ(media.of_instance, (std::vector<uint32_t>{2, 4, 1, 0, 3}));
  EXPECT_NEAR(media.by_rank[2].volume, 27, 1e-9);
  EXPECT_TRUE(media.by_rank[3].is_open());
}

TEST(Media, ASolidMayBeInsideOut) {
  Solids s;
  const uint32_t a = s.glass(1.5f);
  s.cube(a, 0, 1);
  s.cube(a, 2, 3);
  s.turn(1);
  s.cube(a, 6, -2);  // mirrored, which turns its front with it
  s.cube(a, 9, -1);
  s.turn(3);
  s.cube(a, 11, 1, 10);  // open
  s.turn(4);
  const Media media = s.rank();
  EXPECT_EQ(media.inside_out, (std::vector<bool>{false, true, false, true, false}));
  EXPECT_NEAR(media.by_rank[media.of_instance[1]].volume, 27, 1e-9);
  EXPECT_NEAR(media.by_rank[media.of_instance[3]].volume, 1, 1e-9);
  EXPECT_TRUE(media.by_rank[media.of_instance[4]].is_open());
  for (const uint32_t turned : {0u, 1u})
    EXPECT_EQ(media.leaves(turned, {1, 0, 0}, {1, 0, 0}), turned == 0);
}

TEST(Media, HollowsAndDoubledSheetsAreNotInsideOut) {
  Solids s;
  const uint32_t a = s.glass(1.5f);
  s.cube(a, 0, 1);
  s.add_shell(0, 0.5f);
  s.cube(a, 2, 1, 2);
  s.double_sheets(1);
  const Media media = s.rank();
  EXPECT_TRUE(media.inside_out.empty());
  EXPECT_NEAR(media.by_rank[media.of_instance[0]].volume, 1 - 0.125, 1e-6);
  s.turn(0);
  EXPECT_EQ(s.rank().inside_out, (std::vector<bool>{true, false})) << "with its hollow";
}

TEST(Media, NestWhereBoxesMeet) {
  Solids apart;
  const uint32_t a = apart.glass(1.5f), b = apart.glass(1.5f);
  apart.cube(a, 0, 1);
  apart.cube(b, 1.1, 1);
  apart.cube(a, 2.2, 1);
  const Media media = apart.rank();
  EXPECT_FALSE(media.nest);
  EXPECT_EQ(media.of_instance, (std::vector<uint32_t>{0, 1, 0})) << "told by their materials alone";
  Solids touching = apart;
  touching.cube(b, 3.2, 1);
  EXPECT_TRUE(touching.rank().nest);
  EXPECT_TRUE(touching.rank().by_rank[touching.rank().of_instance[3]].meets_others);
  EXPECT_FALSE(touching.rank().by_rank[touching.rank().of_instance[0]].meets_others);
  Solids open;
  open.cube(open.glass(1.5f), 0, 1, 8);
  open.cube(0, 0.5, 1, 8);
  EXPECT_FALSE(open.rank().nest) << "open surfaces alone";
  Solids gas;
  gas.cube(gas.glass(1), 0, 1);
  EXPECT_TRUE(gas.rank().nest) << "the index of air is no boundary";
}

// Cubes 1 m apart whose meshes hold each other's vertices; a tube stays open, whatever lies far away.
TEST(Media, VerticesThatNoTriangleHasAreNothing) {
  Solids s;
  for (const float other : {2.0f, -2.0f}) {
    s.cube(s.glass(1.5f), other > 0 ? 0 : 2, 1);
    s.edit(s.instances.size() - 1, [&](Mesh& m) {
      for (size_t v = 0; v < 8; ++v) m.positions.push_back(m.positions[v] + Vec3(other, 0, 0));
    });
  }
  EXPECT_FALSE(s.rank().nest);
  Solids tube;
  tube.cube(tube.glass(1), 0, 1, 8);
  tube.edit(0, [](Mesh& m) {
    m.positions.insert(m.positions.begin(), Vec3(1e6f, 0, 0));
    for (uint32_t& index : m.indices) ++index;
  });
  EXPECT_TRUE(tube.rank().by_rank.at(0).is_open());
}

// Faces that lie on one another are all found.
TEST(Media, AllHitsOfFacesThatCoincide) {
  Solids s;
  const uint32_t a = s.glass(1.5f);
  s.cube(a, 0, 1);
  s.cube(a, 1, 1);
  s.cube(a, 1, 0.5);
  ThreadPool pool(1);
  const Raytracer tracer(s.meshes, s.instances, s.texturing, pool, true);
  std::vector<Hit> hits;
  tracer.intersect_all({0.5f, 0.2f, 0.3f}, {1, 0, 0}, INFINITY, hits);
  ASSERT_EQ(hits.size(), 5u);
  std::vector<uint32_t> instances;
  for (const Hit& h : hits) instances.push_back(h.instance);
  EXPECT_EQ(instances, (std::vector<uint32_t>{0, 1, 2, 2, 1}));
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(hits[size_t(i)].t, 0.5f, 1e-6f);
}

}  // namespace
}  // namespace ups
