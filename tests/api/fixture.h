// A context and a scene with one of everything, for tests of the C API.
#pragma once
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "ups/ups.h"

namespace ups_test {

template <class Desc>
Desc make(void (*init)(Desc*, uint32_t)) {
  Desc d;
  init(&d, uint32_t(sizeof d));
  return d;
}

// The call must fail so, and its message must hold every one of `words`.
inline void expect_error(ups_status status, ups_status expected, const std::vector<std::string>& words) {
  EXPECT_EQ(status, expected) << ups_status_name(status) << ": " << ups_last_error();
  for (const std::string& word : words)
    EXPECT_NE(std::string(ups_last_error()).find(word), std::string::npos)
        << "'" << word << "' not in: " << ups_last_error();
}

#define EXPECT_OK(call) EXPECT_EQ((call), UPS_OK) << ups_last_error()

class Api : public testing::Test {
 protected:
  Api() {
    auto d = make(&ups_context_desc_init);
    d.thread_count = 2;
    EXPECT_OK(ups_context_create(&d, &context));
    EXPECT_OK(ups_scene_create(context, &scene));
    const auto profile_desc = uniform_profile();
    EXPECT_OK(ups_profile_create(context, &profile_desc, &profile));
    EXPECT_OK(ups_scene_add_texture(scene, &texture_desc(), &texture));
    const auto material_desc = make(&ups_material_desc_init);
    EXPECT_OK(ups_scene_add_material(scene, &material_desc, &material));
    const auto mesh_desc = quad();
    EXPECT_OK(ups_scene_add_mesh(scene, &mesh_desc, &mesh));
    auto instance_desc = make(&ups_instance_desc_init);
    instance_desc.mesh = mesh;
    EXPECT_OK(ups_scene_add_instance(scene, &instance_desc, &instance));
  }
  ~Api() override {
    ups_profile_destroy(profile);
    ups_scene_destroy(scene);
    ups_context_destroy(context);
  }

  // One candela in all directions.
  ups_profile_desc uniform_profile() {
    auto d = make(&ups_profile_desc_init);
    d.c_count = 1, d.gamma_count = 2;
    d.c_deg = c_deg, d.gamma_deg = gamma_deg, d.intensity_cd = intensity_cd;
    return d;
  }
  const ups_texture_desc& texture_desc() {
    texture_desc_ = make(&ups_texture_desc_init);
    texture_desc_.width = 2, texture_desc_.height = 2, texture_desc_.channel_count = 3;
    texture_desc_.texels = texels;
    return texture_desc_;
  }
  ups_mesh_desc quad() {
    auto d = make(&ups_mesh_desc_init);
    d.vertex_count = 4, d.triangle_count = 2;
    d.material = material;
    d.positions_m = positions, d.indices = indices;
    return d;
  }
  ups_meter_desc meters() {
    auto d = make(&ups_meter_desc_init);
    d.count = 2;
    d.positions_m = meter_positions, d.normals = meter_normals, d.tangents = meter_tangents;
    return d;
  }

  float c_deg[2] = {0, 90}, gamma_deg[2] = {0, 180}, intensity_cd[4] = {1, 1, 1, 1};
  float texels[12] = {0, 0.1f, 0.2f, 0.3f, 0.4f, 0.5f, 0.6f, 0.7f, 0.8f, 0.9f, 1, 1};
  float positions[12] = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  float normals[12] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1}, uvs[8] = {}, tangents[16] = {};
  uint32_t indices[6] = {0, 1, 2, 0, 2, 3};
  double meter_positions[6] = {0.5, 0.5, 0, 0.5, 0.5, 1};
  float meter_normals[6] = {0, 0, 1, 0, 0, -2}, meter_tangents[6] = {1, 0, 0, 1, 0, 0};

  ups_context* context = nullptr;
  ups_scene* scene = nullptr;
  ups_profile* profile = nullptr;
  ups_texture_id texture{};
  ups_material_id material{};
  ups_mesh_id mesh{};
  ups_instance_id instance{};

 private:
  ups_texture_desc texture_desc_{};
};

}  // namespace ups_test
