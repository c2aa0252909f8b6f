// What a program removed from a scene takes no memory, however much came and went.
#include <gtest/gtest.h>

#include "failing_memory.h"
#include "rooms.h"
#include "ups/ups_fixture.h"

using namespace ups::test;

namespace {

class MemoryOfEdits : public testing::Test {
 protected:
  MemoryOfEdits() : scene_(1), profile_(table_profile(scene_.context(), 0.3f)) {
    add_box(scene_);
    check(ups_scene_commit(scene_.get()), "ups_scene_commit");
  }
  // One of each kind; returns how many numbers that took.
  int add() {
    auto d = make_desc<ups_material_desc>(ups_material_desc_init);
    d.reflectance_texture = textures_.emplace_back(scene_.add_texture(2, 2, std::vector<float>(12, 0.5f)));
    instances_.push_back(scene_.add(box({1, 1, 1}, {1.1, 1.1, 1.1}), d));
    auto light = make_desc<ups_light_desc>(ups_light_desc_init);
    light.to_world[3] = light.to_world[7] = light.to_world[11] = 0.5;
    check(ups_scene_add_light(scene_.get(), &light, &lights_.emplace_back()), "ups_scene_add_light");
    auto luminaire = make_desc<ups_luminaire_desc>(ups_luminaire_desc_init);
    luminaire.profile = profile_.get();
    check(ups_scene_add_luminaire(scene_.get(), &luminaire, &lights_.emplace_back()), "ups_scene_add_luminaire");
    const double at[3] = {3, 3, 1};
    const float up[3] = {0, 0, 1};
    auto meters = make_desc<ups_meter_desc>(ups_meter_desc_init);
    meters.count = 1, meters.positions_m = at, meters.normals = up;
    check(ups_scene_add_meters(scene_.get(), &meters, &sensors_.emplace_back()), "ups_scene_add_meters");
    return 7;
  }
  void remove_all() {
    ups_scene* s = scene_.get();
    for (const ups_sensor_id id : sensors_) check(ups_scene_remove_sensor(s, id), "ups_scene_remove_sensor");
    for (const ups_luminaire_id id : lights_) check(ups_scene_remove_luminaire(s, id), "ups_scene_remove_luminaire");
    for (const ups_instance_id id : instances_) {
      auto instance = make_desc<ups_instance_desc>(ups_instance_desc_init);
      auto mesh = make_desc<ups_mesh_desc>(ups_mesh_desc_init);
      check(ups_scene_get_instance(s, id, &instance), "ups_scene_get_instance");
      check(ups_scene_get_mesh(s, instance.mesh, &mesh), "ups_scene_get_mesh");
      check(ups_scene_remove_instance(s, id), "ups_scene_remove_instance");
      check(ups_scene_remove_mesh(s, instance.mesh), "ups_scene_remove_mesh");
      check(ups_scene_remove_material(s, mesh.material), "ups_scene_remove_material");
    }
    for (const ups_texture_id id : textures_) check(ups_scene_remove_texture(s, id), "ups_scene_remove_texture");
    sensors_ = {}, lights_ = {}, instances_ = {}, textures_ = {};
    check(ups_scene_commit(s), "ups_scene_commit");
  }

  Scene scene_;
  decltype(table_profile(nullptr, 0)) profile_;
  std::vector<ups_texture_id> textures_;
  std::vector<ups_instance_id> instances_;
  std::vector<ups_luminaire_id> lights_;
  std::vector<ups_sensor_id> sensors_;
};

// In batches, which are committed: snapshots keep nothing either.
TEST_F(MemoryOfEdits, WhatIsRemovedGivesItsMemoryBack) {
  add();
  remove_all();
  const long before = bytes_allocated();
  long numbers = 0;
  for (int batch = 0; batch < 40; ++batch) {
    for (int i = 0; i < 100; ++i) numbers += add();
    if (batch % 10 == 0) check(ups_scene_commit(scene_.get()), "ups_scene_commit");
    remove_all();
  }
  // Two tables of pages, that of the description and that of its last commit, and what their vectors have in reserve.
  EXPECT_LT(bytes_allocated() - before, numbers);
}

TEST_F(MemoryOfEdits, FixturesGiveTheirMemoryBack) {
  ups_fixture* fixture = nullptr;
  check(ups_fixture_create(scene_.context(), &fixture), "ups_fixture_create");
  auto cob = make_desc<ups_fixture_emitter_desc>(ups_fixture_emitter_desc_init);
  cob.radius_m = 0.01, cob.flux_lm = 100;
  check(ups_fixture_add_emitter(fixture, &cob, nullptr), "ups_fixture_add_emitter");
  const auto d = make_desc<ups_fixture_instance_desc>(ups_fixture_instance_desc_init);
  const auto place_and_remove = [&](int times) {
    std::vector<ups_fixture_id> ids;
    for (int i = 0; i < times; ++i)
      check(ups_scene_add_fixture(scene_.get(), fixture, &d, &ids.emplace_back()), "ups_scene_add_fixture");
    for (const ups_fixture_id id : ids) check(ups_scene_remove_fixture(scene_.get(), id), "ups_scene_remove_fixture");
    check(ups_scene_commit(scene_.get()), "ups_scene_commit");
  };
  place_and_remove(1);
  const long before = bytes_allocated();
  for (int batch = 0; batch < 20; ++batch) place_and_remove(100);
  EXPECT_LT(bytes_allocated() - before, 4 * 2000) << "of each a fixture, an instance, a mesh and a material";
  ups_fixture_destroy(fixture);
}

// The handle of a commit that is done keeps nothing of what it built.
TEST_F(MemoryOfEdits, ADoneCommitsJobKeepsNothingThatIsRemoved) {
  add(), remove_all();
  const long before = bytes_allocated();
  instances_.push_back(scene_.add(icosphere({2, 2, 1}, 0.5, 6), matte(0.5)));
  ups_job* job = nullptr;
  check(ups_scene_start_commit(scene_.get(), &job), "ups_scene_start_commit");
  EXPECT_EQ(ups_job_wait(job, 60000), UPS_OK) << ups_last_error();
  EXPECT_GT(bytes_allocated() - before, 1 << 20);
  remove_all();
  EXPECT_LT(bytes_allocated() - before, 1 << 18);
  ups_job_destroy(job);
}

}  // namespace
