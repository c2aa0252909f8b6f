// What comes and goes in any order, with commits between, leaves a scene like one that never had what is gone: the same
// bits. Numbers of things that are gone stay unused, tables of a commit are dense: here the two part.
#include <array>

#include "edited_room.h"

namespace ups_test {
namespace {

class Removal : public Api, public testing::WithParamInterface<uint32_t> {
 protected:
  struct Material {
    ups_material_id id;
    ups_texture_id texture;  // or of value 0
  };
  struct Mesh {
    ups_mesh_id id;
    ups_material_id material;
  };
  struct Instance {
    ups_instance_id id;
    ups_mesh_id mesh;
  };
  size_t random(size_t below) { return size_t((state_ = state_ * 1664525u + 1013904223u) >> 8) % below; }
  double between(double low, double high) { return low + (high - low) * double(random(1 << 20)) / (1 << 20); }
  template <class Things>
  auto& any(Things& things) { return things[random(things.size())]; }
  // One that nobody uses is removed; nothing happens where the one that is drawn is in use.
  template <class Thing, class User, class Id, class Remove>
  void remove_unused(std::vector<Thing>& things, const std::vector<User>& users, Id User::* used, const Remove& remove) {
    if (things.empty()) return;
    const size_t k = random(things.size());
    for (const User& user : users)
      if ((user.*used).v == things[k].id.v) return;
    EXPECT_OK(remove(room.scene, things[k].id));
    things.erase(things.begin() + ptrdiff_t(k));
  }

  void add_texture() {
    std::array<float, 4> texels;
    for (float& t : texels) t = float(between(0, 0.9));
    auto d = make(&ups_texture_desc_init);
    d.width = d.height = 2, d.channel_count = 1, d.texels = texels.data();
    textures.emplace_back();
    EXPECT_OK(ups_scene_add_texture(room.scene, &d, &textures.back().id));
  }
  void add_material() {
    auto d = make(&ups_material_desc_init);
    d.model = any(models);
    for (float& r : d.reflectance_rgb) r = float(between(0.1, 0.8));
    if (random(4) == 0) d.luminance_cd_m2[1] = float(between(1, 500));
    if (!textures.empty() && random(2)) d.reflectance_texture = any(textures).id;
    materials.push_back({room.add(d), d.reflectance_texture});
  }
  void set_material() {
    if (materials.empty()) return;
    Material& m = any(materials);
    auto d = sized<ups_material_desc>();
    EXPECT_OK(ups_scene_get_material(room.scene, m.id, &d));
    d.reflectance_texture = textures.empty() || random(2) ? ups_texture_id{} : any(textures).id;
    EXPECT_OK(ups_scene_set_material(room.scene, m.id, &d));
    m.texture = d.reflectance_texture;
  }
  void add_mesh() {
    if (materials.empty()) return;
    const ups_material_id material = any(materials).id;
    const auto size = float(between(0.1, 0.6));
    meshes.push_back({random(2) ? room.add_sheet(material, 1 + uint32_t(random(6)), size)
                                : room.add_box(material, -size / 2, size / 2), material});
  }
  void add_instance() {
    if (meshes.empty()) return;
    const ups_mesh_id mesh = any(meshes).id;
    instances.push_back({room.add_instance(mesh, between(0.4, 3.6), between(0.4, 3.6), between(0.4, 3)), mesh});
  }
  void set_instance() {
    if (instances.empty()) return;
    Instance& i = any(instances);
    auto d = sized<ups_instance_desc>();
    EXPECT_OK(ups_scene_get_instance(room.scene, i.id, &d));
    place(d, between(0.4, 3.6), between(0.4, 3.6), between(0.4, 3), between(0, 6));
    d.mesh = i.mesh = any(meshes).id;
    EXPECT_OK(ups_scene_set_instance(room.scene, i.id, &d));
  }
  void add_light() {
    auto d = make(&ups_light_desc_init);
    d.kind = random(2) ? UPS_LIGHT_SPOT : UPS_LIGHT_POINT;
    for (float& v : d.intensity_rgb) v = float(between(1, 300));
    place(d, between(0.4, 3.6), between(0.4, 3.6), between(2, 3.8), between(0, 1));
    lights.emplace_back();
    EXPECT_OK(ups_scene_add_light(room.scene, &d, &lights.back()));
  }
  void remove_light() {
    if (lights.empty()) return;
    const size_t k = random(lights.size());
    EXPECT_OK(ups_scene_remove_luminaire(room.scene, lights[k]));
    lights.erase(lights.begin() + ptrdiff_t(k));
  }
  void remove_instance() {
    if (instances.empty()) return;
    const size_t k = random(instances.size());
    EXPECT_OK(ups_scene_remove_instance(room.scene, instances[k].id));
    instances.erase(instances.begin() + ptrdiff_t(k));
  }
  void meters_come_and_go() {
    auto d = sized<ups_meter_desc>();
    EXPECT_OK(ups_scene_get_meters(room.scene, room.meters, &d));
    ups_sensor_id id{};
    EXPECT_OK(ups_scene_add_meters(room.scene, &d, &id));
    EXPECT_OK(ups_scene_commit(room.scene));
    EXPECT_OK(ups_scene_remove_sensor(room.scene, id));
  }
  // Things come a little oftener than they go, what holds others with them.
  void edit() {
    switch (random(16)) {
      case 0: return add_texture();
      case 1: return remove_unused(textures, materials, &Material::texture, ups_scene_remove_texture);
      case 2: return add_material();
      case 3: return set_material();
      case 4: return remove_unused(materials, meshes, &Mesh::material, ups_scene_remove_material);
      case 5: case 6: return add_mesh();
      case 7: return remove_unused(meshes, instances, &Instance::mesh, ups_scene_remove_mesh);
      case 8: case 9: case 10: return add_instance();
      case 11: return set_instance();
      case 12: return remove_instance();
      case 13: return add_light();
      case 14: return remove_light();
      default: return meters_come_and_go();
    }
  }
  void compare() {
    EXPECT_OK(ups_scene_commit(room.scene));
    EditedRoom copy(room, EditedRoom::Copied{});
    EXPECT_OK(ups_scene_commit(copy.scene));
    EXPECT_TRUE(room.render() == copy.render());
  }

  struct Texture {
    ups_texture_id id;
  };
  EditedRoom room{context};
  std::vector<Texture> textures;
  std::vector<Material> materials;
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<ups_luminaire_id> lights;
  const std::array<ups_material_model, 4> models{UPS_MATERIAL_MATTE, UPS_MATERIAL_PLASTIC, UPS_MATERIAL_GLAZING,
                                                 UPS_MATERIAL_MIRROR};

 private:
  uint32_t state_ = 7919 * GetParam() + 1;
};

TEST_P(Removal, LeavesTheSceneThatNeverHadIt) {
  for (int round = 0; round < 6; ++round) {
    SCOPED_TRACE(round);
    for (int i = 0; i < 60; ++i) {
      edit();
      if (random(4) == 0) EXPECT_OK(ups_scene_commit(room.scene));
    }
    compare();
    if (HasFailure()) return;
  }
}

TEST_P(Removal, OfAllThatCameLeavesTheSceneAsItWas) {
  EXPECT_OK(ups_scene_commit(room.scene));
  const Readings before = room.render();
  for (int i = 0; i < 200; ++i) {
    edit();
    if (random(4) == 0) EXPECT_OK(ups_scene_commit(room.scene));
  }
  while (!lights.empty()) remove_light();
  while (!instances.empty()) remove_instance();
  while (!meshes.empty()) remove_unused(meshes, instances, &Instance::mesh, ups_scene_remove_mesh);
  while (!materials.empty()) remove_unused(materials, meshes, &Mesh::material, ups_scene_remove_material);
  while (!textures.empty()) remove_unused(textures, materials, &Material::texture, ups_scene_remove_texture);
  EXPECT_OK(ups_scene_commit(room.scene));
  EXPECT_TRUE(room.render() == before);
}

INSTANTIATE_TEST_SUITE_P(Seeds, Removal, testing::Range(1u, 4u));

}  // namespace
}  // namespace ups_test
