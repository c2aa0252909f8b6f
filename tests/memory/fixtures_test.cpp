// Fixtures are placed, moved and removed whole or not at all, whichever allocation fails, and a texture is set so.
#include <optional>

#include "sweep.h"
#include "ups/ups_fixture.h"

using namespace ups::test;

namespace {

class MemoryOfFixtures : public testing::Test {
 protected:
  MemoryOfFixtures() {
    begin_watch();
    scene_.emplace(1);
    const ups_instance_id room = scene_->add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
    auto instance = make_desc<ups_instance_desc>(ups_instance_desc_init);
    check(ups_scene_get_instance(scene(), room, &instance), "ups_scene_get_instance");
    first_mesh_ = instance.mesh;
    check(ups_fixture_create(scene_->context(), &fixture_), "ups_fixture_create");
    auto cob = make_desc<ups_fixture_emitter_desc>(ups_fixture_emitter_desc_init);
    cob.radius_m = 0.01, cob.flux_lm = 100;
    check(ups_fixture_add_emitter(fixture_, &cob, nullptr), "ups_fixture_add_emitter");
    for (const double radius : {0.03, 0.04}) {
      auto cone = make_desc<ups_reflector_desc>(ups_reflector_desc_init);
      cone.profile = UPS_REFLECTOR_CONE;
      cone.inner_radius_m = 0.5 * radius, cone.aperture_radius_m = radius, cone.depth_m = 0.03;
      cone.finish = UPS_FINISH_SPECULAR_ALUMINIUM;
      check(ups_fixture_add_reflector(fixture_, &cone, nullptr), "ups_fixture_add_reflector");
    }
    none_ = state();
  }
  ~MemoryOfFixtures() override { ups_fixture_destroy(fixture_); }

  struct State {
    uint64_t triangles, meshes;  // meshes: with or without an instance
    double flux_lm, lowest_m;
    bool operator==(const State&) const = default;
  };
  State state() {
    check(ups_scene_commit(scene()), "ups_scene_commit");
    auto info = make_desc<ups_scene_info>([](ups_scene_info* i, uint32_t size) { i->struct_size = size; });
    check(ups_scene_get_info(scene(), &info), "ups_scene_get_info");
    return {info.triangle_count, meshes(), info.emitted_flux_lm, info.bounds_min_m[2]};
  }
  uint64_t meshes() {
    uint64_t count = 0;
    for (ups_mesh_id id = first_mesh_;; ++id.v) {
      auto d = make_desc<ups_mesh_desc>(ups_mesh_desc_init);
      if (ups_scene_get_mesh(scene(), id, &d) == UPS_OK)
        ++count;
      else if (!std::strstr(ups_last_error(), "was removed"))
        return count;
    }
  }
  ups_fixture_id place() {
    ups_fixture_id id{};
    check(ups_scene_add_fixture(scene(), fixture_, &desc_, &id), "ups_scene_add_fixture");
    return id;
  }
  void remove(ups_fixture_id id) { check(ups_scene_remove_fixture(scene(), id), "ups_scene_remove_fixture"); }
  ups_scene* scene() { return scene_->get(); }

  std::optional<Scene> scene_;
  ups_fixture* fixture_ = nullptr;
  ups_mesh_id first_mesh_{};
  ups_fixture_instance_desc desc_ = make_desc<ups_fixture_instance_desc>(ups_fixture_instance_desc_init);
  State none_;
};

TEST_F(MemoryOfFixtures, AreRemovedWholeOrNotAtAll) {
  for (const bool shared : {false, true})  // whether another has the parts as well
    for (const long count : {1L, all_after}) {
      bool failing = true;
      for (long k = 1; failing; ++k) {
        const ups_fixture_id first = place(), second = shared ? place() : ups_fixture_id{};
        bool is_there = true;
        const Call removed = [&] {
          const ups_status status = ups_scene_remove_fixture(scene(), first);
          is_there = status != UPS_OK;
          return status;
        };
        failing = try_failing(removed, k, count);
        if (is_there) remove(first);
        // What a count that is off would do to the next ones.
        const ups_fixture_id again[2] = {place(), place()};
        if (shared) remove(second);
        for (const ups_fixture_id id : again) remove(id);
        ASSERT_EQ(state(), none_) << "after the failure of allocation " << k;
      }
    }
}

TEST_F(MemoryOfFixtures, ArePlacedWholeOrNotAtAll) {
  for (const bool shared : {false, true}) {  // whether another has the parts already
    const ups_fixture_id other = shared ? place() : ups_fixture_id{};
    const State before = state();
    for (const long count : {1L, all_after}) {
      bool failing = true;
      for (long k = 1; failing; ++k) {
        ups_fixture_id id{};
        const Call placed = [&] { return ups_scene_add_fixture(scene(), fixture_, &desc_, &id); };
        failing = try_failing(placed, k, count);
        if (id.v) remove(id);
        ASSERT_EQ(state(), before) << "after the failure of allocation " << k;
      }
    }
    if (shared) remove(other);
    EXPECT_EQ(state(), none_);
  }
}

TEST_F(MemoryOfFixtures, AreMovedWholeOrNotAtAll) {
  const ups_fixture_id id = place();
  const State before = state();
  auto moved = desc_;
  moved.dimming = 0.5f;
  moved.to_world[11] = -1;
  for (const long count : {1L, all_after}) {
    bool failing = true;
    for (long k = 1; failing; ++k) {
      bool is_moved = false;
      const Call move = [&] {
        const ups_status status = ups_scene_set_fixture(scene(), id, &moved);
        is_moved = status == UPS_OK;
        return status;
      };
      failing = try_failing(move, k, count);
      ASSERT_EQ(state() != before, is_moved) << "after the failure of allocation " << k;
      if (is_moved) check(ups_scene_set_fixture(scene(), id, &desc_), "ups_scene_set_fixture");
    }
  }
}

// A texture that its material refuses, without memory for going back.
TEST_F(MemoryOfFixtures, ATextureThatIsRefusedStaysAsItWas) {
  auto d = make_desc<ups_material_desc>(ups_material_desc_init);
  const ups_texture_id texture = d.normal_texture = scene_->add_texture(2, 2, std::vector<float>(12, 0.5f));
  scene_->add(box({1, 1, 1}, {1.1, 1.1, 1.1}), d);
  const float grey[4] = {0.5f, 0.5f, 0.5f, 0.5f};
  auto one_channel = make_desc<ups_texture_desc>(ups_texture_desc_init);
  one_channel.width = one_channel.height = 2, one_channel.channel_count = 1, one_channel.texels = grey;
  bool failing = true;
  for (long k = 1; failing; ++k) {
    fail_memory(k, all_after);
    const ups_status status = ups_scene_set_texture(scene(), texture, &one_channel);
    failing = end_of_failing() >= k;
    EXPECT_NE(status, UPS_OK);
    auto now = make_desc<ups_texture_desc>(ups_texture_desc_init);
    check(ups_scene_get_texture(scene(), texture, &now), "ups_scene_get_texture");
    ASSERT_EQ(now.channel_count, 3u) << "after the failure of allocation " << k;
  }
}

}  // namespace
