// The search for glass that emitters touch, as a part of a commit: kept to the memory's limit, cancelled, told of.
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <thread>

#include "things.h"

namespace ups {
namespace {

// An emitter that stands on glass, and a matte sheet away from both; of so many squares along a side.
Things on_glass(uint32_t of_glass, uint32_t of_matte) {
  Things t;
  t.box(t.material(UPS_MATERIAL_MATTE, 100), {0, 0, 1}, {1, 1, 2});
  t.sheet(t.material(UPS_MATERIAL_GLASS), of_glass, 1);
  t.sheet(t.material(UPS_MATERIAL_MATTE), of_matte, -1);
  return t;
}
constexpr uint32_t coarse = 4, fine = 200;  // whose index takes some kB, and some MB
constexpr float search_ends = 0.2f;  // of a commit's progress: what emitters touch is searched first
const Contact& only_contact(const Snapshot& s) { return s.contacts.at({UPS_SOURCE_INSTANCE, 1}); }

// The index of the search is refused within it, that of the scene after it, by the progress that there was; a search
// without the limit would go on to the scene's index. What was begun keeps no mesh.
TEST(Contacts, TheirSearchKeepsTheMemorysLimit) {
  for (const bool in_search : {true, false}) {
    const Things t = in_search ? on_glass(fine, coarse) : on_glass(coarse, fine);
    const auto users = [&] {
      long sum = 0;
      for (uint32_t mesh = 1; mesh <= 3; ++mesh) sum += t.description.meshes().shared(mesh).use_count();
      return sum;
    };
    const long before = users();
    ThreadPool pool(2);
    Monitor monitor;
    monitor.limit_memory(2 << 20);
    try {
      prepare(t.description, pool, nullptr, &monitor);
      ADD_FAILURE() << in_search;
    } catch (const Error& e) {
      EXPECT_EQ(e.status(), UPS_ERROR_OUT_OF_MEMORY) << e.what();
      EXPECT_NE(std::string(e.what()).find("memory_limit_bytes"), std::string::npos) << e.what();
    }
    EXPECT_EQ(monitor.fraction() < search_ends, in_search) << monitor.fraction();
    EXPECT_EQ(users(), before);
    EXPECT_TRUE(only_contact(*prepare(t.description, pool)).is_moved());
  }
}

// By a thread that waits for the first progress: a search that told of none, or went on, would end at a fifth or later.
// Where the thread came too late it is tried again.
TEST(Contacts, TheirSearchIsCancelled) {
  const Things t = on_glass(fine, coarse);
  ThreadPool pool(2);
  const auto expected = prepare(t.description, pool);
  bool within = false;
  for (int tries = 0; tries < 10 && !within; ++tries) {
    Monitor monitor;
    std::atomic<bool> ended{false};
    std::thread other([&] {
      while (!(monitor.fraction() > 0) && !ended) std::this_thread::yield();
      monitor.cancel();
    });
    bool cancelled = false;
    try {
      prepare(t.description, pool, nullptr, &monitor);
    } catch (const Cancelled&) {
      cancelled = true;
    }
    ended = true;
    other.join();
    within = cancelled && monitor.fraction() < search_ends;
  }
  EXPECT_TRUE(within);
  const auto again = prepare(t.description, pool);
  EXPECT_TRUE(only_contact(*again).is_moved());
  EXPECT_EQ(max_abs(only_contact(*again).shift - only_contact(*expected).shift), 0);
  EXPECT_TRUE(again->instances == expected->instances);
}

// A block of 1 m on z = 0 whose lower face is of two triangles, the other faces of 60 x 60 squares each.
void add_fine_block(Things& t, uint32_t material) {
  std::vector<float> p;
  std::vector<uint32_t> corners;
  const auto face = [&](const Vec3& at, const Vec3& a, const Vec3& b, uint32_t side) {
    const uint32_t first = uint32_t(p.size() / 3);
    for (uint32_t j = 0; j <= side; ++j)
      for (uint32_t i = 0; i <= side; ++i) {
        const Vec3 corner = at + a * (float(i) / float(side)) + b * (float(j) / float(side));
        p.insert(p.end(), {corner.x, corner.y, corner.z});
        const uint32_t k = first + j * (side + 1) + i, next = k + side + 1;
        if (i < side && j < side) corners.insert(corners.end(), {k, k + 1, next + 1, k, next + 1, next});
      }
  };
  const Vec3 x(1, 0, 0), y(0, 1, 0), z(0, 0, 1), none(0, 0, 0);
  face(none, x, z, 60), face(z, x, y, 60), face(x, y, z, 60), face(y, z, x, 60), face(none, z, y, 60);
  face(none, y, x, 1);
  ups_mesh_desc m{};
  m.vertex_count = uint32_t(p.size() / 3), m.triangle_count = uint32_t(corners.size() / 3);
  m.material.v = material;
  m.positions_m = p.data(), m.indices = corners.data();
  ups_instance_desc d{};
  d.mesh = t.description.add_mesh(m);
  d.to_world[0] = d.to_world[5] = d.to_world[10] = 1;
  t.description.add_instance(d);
}

// However many triangles there are beside the face that lies on another surface, and however it is scaled: shares are of
// areas in the scene, here of a slab of 1 x 1 x 0.004 m.
TEST(CloseSurfaces, AreFoundByArea) {
  for (const ups_material_model model : {UPS_MATERIAL_GLASS, UPS_MATERIAL_GLAZING}) {
    Things t;
    t.sheet(t.material(UPS_MATERIAL_MATTE), 1, 0);
    add_fine_block(t, t.material(model));
    const auto scene = t.build();
    if (model == UPS_MATERIAL_GLASS) {
      EXPECT_TRUE(scene->panes.is_touched_glass(1));
      continue;
    }
    ASSERT_EQ(scene->panes.on_surfaces.size(), 1u);
    EXPECT_EQ(scene->panes.on_surfaces[0].opaque, 0u);
    EXPECT_NEAR(scene->panes.on_surfaces[0].covered, 1 / 6.0, 0.03);
  }
  Things t;
  t.sheet(t.material(UPS_MATERIAL_MATTE), 1, 0);
  t.box(t.material(UPS_MATERIAL_GLAZING), {0, 0, 0}, {1, 1, 0.004});
  const auto scene = t.build();
  ASSERT_EQ(scene->panes.on_surfaces.size(), 1u);
  EXPECT_NEAR(scene->panes.on_surfaces[0].covered, 1 / 2.016, 0.01);
}

// A contact that is known holds as long as what was searched is the same: a mesh that is there twice is traced another
// way than one that is there once, and has other errors; one with holes may not be touched. As a build without an earlier
// one, to the bit.
TEST(Contacts, AreSearchedAgainWhereWhatTheyTouchIsTracedAnotherWay) {
  ThreadPool pool(2);
  const auto touching = [] {
    Things t;
    t.box(t.material(UPS_MATERIAL_MATTE), {-20, -20, -1}, {20, 20, 4});
    photometry::Opening opening;
    opening.shape = photometry::OpeningShape::rectangle;
    opening.size_m[0] = opening.size_m[1] = 0.3f;
    t.sheet(t.material(UPS_MATERIAL_DIFFUSER), 1, 1);
    t.downlight({0.3, 0.4, 1 + 5e-5}, opening, 100);
    return t;
  };
  const auto expect_as_fresh = [&](const Things& t, const std::shared_ptr<const Snapshot>& earlier, const char* what) {
    const auto after = prepare(t.description, pool, earlier), fresh = prepare(t.description, pool);
    ASSERT_EQ(after->contacts.size(), fresh->contacts.size()) << what;
    for (const auto& [key, contact] : fresh->contacts) {
      const Contact& c = after->contacts.at(key);
      EXPECT_EQ(c.touched, contact.touched) << what;
      EXPECT_EQ(max_abs(c.shift - contact.shift), 0) << what << ": " << c.shift.z << ", " << contact.shift.z;
    }
    EXPECT_EQ(after->warnings, fresh->warnings) << what;
    for (size_t e = 0; e < fresh->emitters.size(); ++e)
      EXPECT_EQ(max_abs(after->emitters[e].center() - fresh->emitters[e].center()), 0) << what;
  };
  {
    Things t = touching();
    const auto before = prepare(t.description, pool);
    ups_instance_desc twin{};
    twin.mesh.v = 2;
    twin.to_world[0] = twin.to_world[5] = twin.to_world[10] = 1;
    twin.to_world[3] = 10;
    t.description.add_instance(twin);
    expect_as_fresh(t, before, "a twin");
  }
  for (const bool hole : {true, false}) {
    Things t = touching();
    t.sheet(t.material(UPS_MATERIAL_GLAZING), 1, 3);  // so that the ray tracer stays as it is
    const auto before = prepare(t.description, pool);
    EXPECT_TRUE(before->contacts.begin()->second.is_moved());
    ups_material_desc changed = Things::desc(UPS_MATERIAL_DIFFUSER, hole ? 0.0f : 1.0f);
    changed.emits_both_sides = 1;
    if (hole) changed.alpha_mode = UPS_ALPHA_MASK, changed.alpha = 0;
    t.description.set_material({2}, changed);
    expect_as_fresh(t, before, hole ? "a hole" : "it shines");
  }
}

}  // namespace
}  // namespace ups
