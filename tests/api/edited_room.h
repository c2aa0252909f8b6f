// A room with one of everything, for tests of edits: its ids, a render of it as bits, and a copy made from its getters.
#pragma once
#include <cmath>
#include <cstring>
#include <map>

#include "fixture.h"

namespace ups_test {

struct Readings {
  std::vector<float> image;
  std::vector<std::vector<ups_meter_reading>> meters;
  bool operator==(const Readings& b) const {
    if (meters.size() != b.meters.size() || image.size() != b.image.size()) return false;
    for (size_t i = 0; i < meters.size(); ++i)
      if (meters[i].size() != b.meters[i].size() ||
          std::memcmp(meters[i].data(), b.meters[i].data(), meters[i].size() * sizeof(ups_meter_reading)) != 0)
        return false;
    return std::memcmp(image.data(), b.image.data(), image.size() * sizeof(float)) == 0;
  }
};

template <class Desc>
Desc sized() {
  Desc d{};
  d.struct_size = sizeof d;
  return d;
}

template <class Desc>
void place(Desc& d, double x, double y, double z, double angle = 0) {
  const double c = std::cos(angle), s = std::sin(angle);
  const double m[12] = {c, 0, s, x, 0, 1, 0, y, -s, 0, c, z};
  std::memcpy(d.to_world, m, sizeof m);
}

class EditedRoom {
 public:
  explicit EditedRoom(ups_context* context) : context_(context) {
    EXPECT_OK(ups_scene_create(context, &scene));
    furnish();
  }
  // Built anew from what the getters tell of another; its ids are others. context: null: the other's.
  struct Copied {};
  EditedRoom(const EditedRoom& from, Copied, ups_context* context = nullptr)
      : context_(context ? context : from.context_) {
    EXPECT_OK(ups_scene_create(context_, &scene));
    copy(from);
  }
  ~EditedRoom() { ups_scene_destroy(scene); }
  EditedRoom(const EditedRoom&) = delete;
  EditedRoom& operator=(const EditedRoom&) = delete;

  void furnish() {
    const float texels[4] = {0, 1, 1, 0.25f};
    auto t = make(&ups_texture_desc_init);
    t.width = t.height = 2, t.channel_count = 1, t.texels = texels;
    EXPECT_OK(ups_scene_add_texture(scene, &t, &texture));
    auto m = make(&ups_material_desc_init);
    wall = add(m);
    m.reflectance_rgb[1] = 0.2f;
    red = add(m);
    m.model = UPS_MATERIAL_MIRROR;
    mirror = add(m);
    m.model = UPS_MATERIAL_MATTE, m.luminance_cd_m2[0] = m.luminance_cd_m2[1] = m.luminance_cd_m2[2] = 300;
    lamp = add(m);
    room = add_instance(add_box(wall, -0.01f, 4), 0, 0, 0);
    box = add_box(red, -0.3f, 0.3f);
    first = add_instance(box, 1, 1, 0.31);
    second = add_instance(box, 3, 1, 0.31);
    plate = add_sheet(mirror, 1, 0.8f);
    glossy = add_instance(plate, 2, 3, 0.5);
    panel = add_instance(add_sheet(lamp, 2, 0.4f), 0.5, 0.5, 2);
    add_luminaires();
    add_sensors();
  }

  ups_material_id add(const ups_material_desc& d) {
    ups_material_id id{};
    EXPECT_OK(ups_scene_add_material(scene, &d, &id));
    return id;
  }
  ups_mesh_id add_box(ups_material_id material, float low, float high) {
    float p[24];
    for (int i = 0; i < 8; ++i)
      for (int k = 0; k < 3; ++k) p[3 * i + k] = (i >> k & 1) ? high : low;
    static const uint32_t indices[36] = {0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6, 0, 1, 5, 0, 5, 4,
                                         2, 6, 7, 2, 7, 3, 0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5};
    auto d = make(&ups_mesh_desc_init);
    d.vertex_count = 8, d.triangle_count = 12, d.positions_m = p, d.indices = indices, d.material = material;
    ups_mesh_id id{};
    EXPECT_OK(ups_scene_add_mesh(scene, &d, &id));
    return id;
  }
  // side * side squares in the plane z = 0, with UVs; faces up.
  ups_mesh_id add_sheet(ups_material_id material, uint32_t side, float size) {
    std::vector<float> p, uv;
    std::vector<uint32_t> indices;
    const uint32_t n = side + 1;
    for (uint32_t i = 0; i < n * n; ++i) {
      const float u = float(i % n) / float(side), v = float(i / n) / float(side);
      p.insert(p.end(), {u * size, v * size, 0});
      uv.insert(uv.end(), {u, v});
    }
    for (uint32_t i = 0; i < side * side; ++i) {
      const uint32_t a = i / side * n + i % side;
      indices.insert(indices.end(), {a, a + 1, a + n, a + 1, a + n + 1, a + n});
    }
    auto d = make(&ups_mesh_desc_init);
    d.vertex_count = n * n, d.triangle_count = 2 * side * side, d.material = material;
    d.positions_m = p.data(), d.uvs = uv.data(), d.indices = indices.data();
    ups_mesh_id id{};
    EXPECT_OK(ups_scene_add_mesh(scene, &d, &id));
    return id;
  }
  ups_instance_id add_instance(ups_mesh_id mesh, double x, double y, double z) {
    auto d = make(&ups_instance_desc_init);
    d.mesh = mesh;
    place(d, x, y, z);
    ups_instance_id id{};
    EXPECT_OK(ups_scene_add_instance(scene, &d, &id));
    return id;
  }

  // Of the scene as committed.
  Readings render() const {
    auto d = make(&ups_render_desc_init);
    d.method = UPS_METHOD_UPS, d.iteration_count = 2, d.seed = 7, d.light_paths_per_iteration = 256;
    ups_result* result = nullptr;
    EXPECT_OK(ups_render(scene, &d, &result));
    Readings out;
    if (!result) return out;
    out.image.resize(3 * 8 * 8);
    EXPECT_OK(ups_result_read_image(result, camera, UPS_CHANNEL_LUMINANCE_RGB, out.image.data(), 0,
                                    out.image.size() * sizeof(float)));
    for (const auto& [id, count] : {std::pair(meters, size_t(2)), std::pair(surface, size_t(12))}) {
      out.meters.emplace_back(count);
      EXPECT_OK(ups_result_read_meters(result, id, out.meters.back().data(), count));
    }
    ups_result_destroy(result);
    return out;
  }

  ups_scene* scene = nullptr;
  ups_texture_id texture{};
  ups_material_id wall{}, red{}, mirror{}, lamp{};
  ups_mesh_id box{}, plate{};
  ups_instance_id room{}, first{}, second{}, glossy{}, panel{};
  ups_luminaire_id opening{}, point{}, spot{}, sun{};
  ups_sensor_id camera{}, meters{}, surface{};

 private:
  // Numbers count from 1; what was removed is left out.
  template <class Id, class Desc, class Add>
  std::map<uint32_t, Id> copy_all(const EditedRoom& from, Id any,
                                  ups_status (*get)(const ups_scene*, Id, Desc*), const Add& add) {
    std::map<uint32_t, Id> copied{{0, Id{}}};
    Desc d = sized<Desc>();
    for (uint32_t number = 1; number < 300; ++number) {
      const Id id{(any.v & 0xff000000) | number};
      if (get(from.scene, id, &d) == UPS_OK) EXPECT_OK(add(id, d, &copied[id.v]));
    }
    return copied;
  }
  void copy(const EditedRoom& from) {
    const auto textures = copy_all(from, from.texture, &ups_scene_get_texture,
                                   [&](ups_texture_id id, ups_texture_desc& d, ups_texture_id* out) {
      std::vector<float> texels(d.width * d.height * d.channel_count);
      EXPECT_OK(ups_scene_read_texture(from.scene, id, texels.data(), texels.size(), nullptr));
      d.texels = texels.data();
      return ups_scene_add_texture(scene, &d, out);
    });
    const auto materials = copy_all(from, from.wall, &ups_scene_get_material,
                                    [&](ups_material_id, ups_material_desc& d, ups_material_id* out) {
      for (ups_texture_id* t : {&d.reflectance_texture, &d.roughness_texture, &d.metallic_texture, &d.normal_texture,
                                &d.alpha_texture})
        *t = textures.at(t->v);
      return ups_scene_add_material(scene, &d, out);
    });
    const auto meshes = copy_all(from, from.box, &ups_scene_get_mesh,
                                 [&](ups_mesh_id, ups_mesh_desc& d, ups_mesh_id* out) {
      d.material = materials.at(d.material.v);
      return ups_scene_add_mesh(scene, &d, out);
    });
    const auto instances = copy_all(from, from.room, &ups_scene_get_instance,
                                    [&](ups_instance_id, ups_instance_desc& d, ups_instance_id* out) {
      d.mesh = meshes.at(d.mesh.v);
      return ups_scene_add_instance(scene, &d, out);
    });
    copy_luminaires(from);
    auto c = sized<ups_camera_desc>();
    EXPECT_OK(ups_scene_get_camera(from.scene, from.camera, &c));
    EXPECT_OK(ups_scene_add_camera(scene, &c, &camera));
    auto m = sized<ups_meter_desc>();
    EXPECT_OK(ups_scene_get_meters(from.scene, from.meters, &m));
    EXPECT_OK(ups_scene_add_meters(scene, &m, &meters));
    auto s = sized<ups_surface_meters_desc>();
    EXPECT_OK(ups_scene_get_surface_meters(from.scene, from.surface, &s));
    const ups_instance_id measured = instances.at(s.instances[0].v);
    s.instances = &measured;
    EXPECT_OK(ups_scene_add_surface_meters(scene, &s, &surface));
    double factor = 0;
    EXPECT_OK(ups_scene_get_maintenance_factor(from.scene, &factor));
    EXPECT_OK(ups_scene_set_maintenance_factor(scene, factor));
  }
  // In the order of their numbers, which lights and luminaires share.
  void copy_luminaires(const EditedRoom& from) {
    for (uint32_t number = 1; number < 100; ++number) {
      const ups_luminaire_id id{(from.opening.v & 0xff000000) | number};
      auto l = sized<ups_luminaire_desc>();
      auto light = sized<ups_light_desc>();
      ups_luminaire_id out{};
      float dimming = 0;
      if (ups_scene_get_dimming(from.scene, id, &dimming) != UPS_OK) continue;
      if (ups_scene_get_light(from.scene, id, &light) == UPS_OK) {
        EXPECT_OK(ups_scene_add_light(scene, &light, &out));
        EXPECT_OK(ups_scene_set_dimming(scene, out, dimming));
        continue;
      }
      ups_profile* profile = nullptr;
      EXPECT_OK(ups_scene_get_luminaire(from.scene, id, &l));
      EXPECT_OK(ups_scene_get_luminaire_profile(from.scene, id, &profile));
      l.profile = profile;
      EXPECT_OK(ups_scene_add_luminaire(scene, &l, &out));
      ups_profile_destroy(profile);
    }
  }
  void add_luminaires() {
    const float c = 0, gamma[3] = {0, 60, 90}, intensity[3] = {900, 400, 0};
    auto p = make(&ups_profile_desc_init);
    p.c_count = 1, p.gamma_count = 3, p.c_deg = &c, p.gamma_deg = gamma, p.intensity_cd = intensity;
    p.opening_shape = UPS_OPENING_RECTANGLE, p.opening_m[0] = p.opening_m[1] = 0.5f;
    ups_profile* profile = nullptr;
    EXPECT_OK(ups_profile_create(context_, &p, &profile));
    auto l = make(&ups_luminaire_desc_init);
    l.profile = profile;
    place(l, 2, 2, 3.5);
    EXPECT_OK(ups_scene_add_luminaire(scene, &l, &opening));
    l.use_opening = 0;
    place(l, 1, 3, 3);
    EXPECT_OK(ups_scene_add_luminaire(scene, &l, &point));
    ups_profile_destroy(profile);
    auto light = make(&ups_light_desc_init);
    light.kind = UPS_LIGHT_SPOT;
    for (float& v : light.intensity_rgb) v = 200;
    place(light, 3, 3, 3, 0.2);
    EXPECT_OK(ups_scene_add_light(scene, &light, &spot));
    light.kind = UPS_LIGHT_DIRECTIONAL;
    place(light, 0, 0, 0, 0.5);
    EXPECT_OK(ups_scene_add_light(scene, &light, &sun));
  }
  void add_sensors() {
    auto c = make(&ups_camera_desc_init);
    c.width = c.height = 8;
    place(c, 2, 2, 3.4);
    EXPECT_OK(ups_scene_add_camera(scene, &c, &camera));
    const double positions[6] = {1, 2, 0.8, 3, 2.5, 0.8};
    const float normals[6] = {0, 0, 1, 0, 0, 1};
    auto m = make(&ups_meter_desc_init);
    m.count = 2, m.positions_m = positions, m.normals = normals;
    EXPECT_OK(ups_scene_add_meters(scene, &m, &meters));
    auto s = make(&ups_surface_meters_desc_init);
    s.instance_count = 1, s.instances = &first;
    EXPECT_OK(ups_scene_add_surface_meters(scene, &s, &surface));
  }

  ups_context* context_;
};

}  // namespace ups_test
