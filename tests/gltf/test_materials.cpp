// How materials of glTF and of `extras.ups` become the core's.
#include <cmath>

#include "scene_builder.h"

namespace {

class MaterialTest : public ImportTest {
 protected:
  ups_material_desc import_material(const json& material) {
    SceneBuilder builder;
    builder.doc["materials"] = json::array({material});
    import(builder);
    return scene.materials.empty() ? ups_material_desc{} : scene.materials[0];
  }
  ups_material_desc import_extras(const json& ups) { return import_material({{"extras", {{"ups", ups}}}}); }
  static void expect_rgb(const float (&found)[3], double r, double g, double b) {
    EXPECT_NEAR(found[0], r, 1e-6);
    EXPECT_NEAR(found[1], g, 1e-6);
    EXPECT_NEAR(found[2], b, 1e-6);
  }
  static json transmissive(const json& extensions, double roughness) {
    json material = {{"pbrMetallicRoughness",
                      {{"baseColorFactor", {0.5, 1, 0.25, 1}}, {"metallicFactor", 0}, {"roughnessFactor", roughness}}}};
    material["extensions"] = extensions;
    material["extensions"]["KHR_materials_transmission"]["transmissionFactor"] = 1;
    return material;
  }
};

TEST_F(MaterialTest, MetallicRoughness) {
  const json color = {0.8, 0.6, 0.4, 1};
  const auto pbr = [&](double metallic, double roughness) {
    return json{{"pbrMetallicRoughness",
                 {{"baseColorFactor", color}, {"metallicFactor", metallic}, {"roughnessFactor", roughness}}}};
  };
  auto d = import_material(pbr(0, 0.3));
  EXPECT_EQ(d.model, UPS_MATERIAL_PLASTIC);
  EXPECT_FLOAT_EQ(d.roughness, 0.3f);
  EXPECT_FLOAT_EQ(d.metallic, 0);
  EXPECT_FLOAT_EQ(d.ior, 1.5f);
  expect_rgb(d.reflectance_rgb, 0.8, 0.6, 0.4);
  d = import_material(pbr(0.25, 0.3));
  EXPECT_EQ(d.model, UPS_MATERIAL_PLASTIC);
  EXPECT_FLOAT_EQ(d.metallic, 0.25f);
  d = import_material(pbr(1, 0.3));
  EXPECT_EQ(d.model, UPS_MATERIAL_METAL);
  EXPECT_FLOAT_EQ(d.metallic, 0);
  EXPECT_EQ(d.ior_k_rgb[0], 0);
  d = import_material(json::object());  // glTF's defaults
  EXPECT_EQ(d.model, UPS_MATERIAL_METAL);
  EXPECT_FLOAT_EQ(d.roughness, 1);
  expect_rgb(d.reflectance_rgb, 1, 1, 1);
  json with_ior = pbr(0, 0.3);
  with_ior["extensions"]["KHR_materials_ior"]["ior"] = 1.8;
  EXPECT_FLOAT_EQ(import_material(with_ior).ior, 1.8f);
}

TEST_F(MaterialTest, ThinGlazing) {
  const auto d = import_material(transmissive({{"KHR_materials_ior", {{"ior", 1.5}}}}, 0));
  EXPECT_EQ(d.model, UPS_MATERIAL_GLAZING);
  // A clear pane of index 1.5 transmits (1 - 0.04) / (1 + 0.04) at normal incidence.
  const double clear = 0.96 / 1.04;
  expect_rgb(d.transmittance_rgb, 0.5 * clear, clear, 0.25 * clear);
  EXPECT_EQ(warnings(), "");
  import_material(transmissive(json::object(), 0.5));
  EXPECT_TRUE(warned("roughnessFactor")) << warnings();
}

TEST_F(MaterialTest, GlassWithAbsorption) {
  const auto d = import_material(
      transmissive({{"KHR_materials_volume",
                     {{"thicknessFactor", 0.01}, {"attenuationDistance", 2}, {"attenuationColor", {1, 0.5, 0.25}}}}},
                   0.1));
  EXPECT_EQ(d.model, UPS_MATERIAL_GLASS);
  EXPECT_FLOAT_EQ(d.roughness, 0.1f);
  EXPECT_FLOAT_EQ(d.ior, 1.5f);
  expect_rgb(d.absorption_per_m_rgb, 0, std::log(2) / 2, std::log(4) / 2);
  const auto thin = import_material(transmissive({{"KHR_materials_volume", {{"thicknessFactor", 0}}}}, 0));
  EXPECT_EQ(thin.model, UPS_MATERIAL_GLAZING);
  const auto clear = import_material(transmissive({{"KHR_materials_volume", {{"thicknessFactor", 1}}}}, 0));
  expect_rgb(clear.absorption_per_m_rgb, 0, 0, 0);
}

TEST_F(MaterialTest, Emission) {
  const auto d = import_material({{"emissiveFactor", {1, 0.5, 0}},
                                  {"doubleSided", true},
                                  {"extensions", {{"KHR_materials_emissive_strength", {{"emissiveStrength", 4000}}}}}});
  expect_rgb(d.luminance_cd_m2, 4000, 2000, 0);
  EXPECT_EQ(d.emits_both_sides, 1);
  EXPECT_EQ(import_material({{"emissiveFactor", {1, 1, 1}}}).emits_both_sides, 0);
}

TEST_F(MaterialTest, Alpha) {
  const json pbr = {{"baseColorFactor", {1, 1, 1, 0.25}}};
  auto d = import_material({{"alphaMode", "MASK"}, {"alphaCutoff", 0.3}, {"pbrMetallicRoughness", pbr}});
  EXPECT_EQ(d.alpha_mode, UPS_ALPHA_MASK);
  EXPECT_FLOAT_EQ(d.alpha, 0.25f);
  EXPECT_FLOAT_EQ(d.alpha_cutoff, 0.3f);
  d = import_material({{"alphaMode", "BLEND"}, {"pbrMetallicRoughness", pbr}});
  EXPECT_EQ(d.alpha_mode, UPS_ALPHA_BLEND);
  d = import_material({{"pbrMetallicRoughness", pbr}});
  EXPECT_EQ(d.alpha_mode, UPS_ALPHA_OPAQUE);
  EXPECT_FLOAT_EQ(d.alpha, 1);
}

TEST_F(MaterialTest, ExtrasModels) {
  auto d = import_extras({{"model", "matte"}, {"reflectance", {0.1, 0.2, 0.3}}});
  EXPECT_EQ(d.model, UPS_MATERIAL_MATTE);
  expect_rgb(d.reflectance_rgb, 0.1, 0.2, 0.3);
  d = import_extras({{"model", "plastic"}, {"reflectance", 0.4}, {"roughness", 0.2}, {"ior", 1.6}});
  EXPECT_EQ(d.model, UPS_MATERIAL_PLASTIC);
  expect_rgb(d.reflectance_rgb, 0.4, 0.4, 0.4);
  EXPECT_FLOAT_EQ(d.roughness, 0.2f);
  EXPECT_FLOAT_EQ(d.ior, 1.6f);
  d = import_extras({{"model", "metal"}, {"ior", {1.1, 1.2, 1.3}}, {"k", 7}, {"roughness", 0.1}});
  EXPECT_EQ(d.model, UPS_MATERIAL_METAL);
  expect_rgb(d.ior_rgb, 1.1, 1.2, 1.3);
  expect_rgb(d.ior_k_rgb, 7, 7, 7);
  d = import_extras({{"model", "metal"}, {"reflectance", 0.9}});
  expect_rgb(d.reflectance_rgb, 0.9, 0.9, 0.9);
  expect_rgb(d.ior_k_rgb, 0, 0, 0);
  d = import_extras({{"model", "mirror"}, {"reflectance", 0.95}});
  EXPECT_EQ(d.model, UPS_MATERIAL_MIRROR);
  d = import_extras({{"model", "glass"}, {"ior", 1.33}, {"absorption_per_m", {0.1, 0, 0}}});
  EXPECT_EQ(d.priority, 0);
  EXPECT_EQ(import_extras({{"model", "glass"}, {"priority", -3}}).priority, -3);
  EXPECT_EQ(d.model, UPS_MATERIAL_GLASS);
  EXPECT_FLOAT_EQ(d.ior, 1.33f);
  expect_rgb(d.absorption_per_m_rgb, 0.1, 0, 0);
  d = import_extras({{"model", "glazing"}, {"transmittance", 0.8}});
  EXPECT_EQ(d.model, UPS_MATERIAL_GLAZING);
  expect_rgb(d.transmittance_rgb, 0.8, 0.8, 0.8);
  EXPECT_FLOAT_EQ(d.ior, 1.52f);
  d = import_extras({{"model", "glazing"}});
  EXPECT_LT(d.transmittance_rgb[0], 0);
  d = import_extras({{"model", "diffuser"}, {"reflectance", 0.3}, {"transmittance", {0.7, 0.6, 0.5}}});
  EXPECT_EQ(d.model, UPS_MATERIAL_DIFFUSER);
  expect_rgb(d.transmittance_rgb, 0.7, 0.6, 0.5);
}

// Angles of both tables together: each stays what it is.
TEST_F(MaterialTest, PanesByAngle) {
  const auto t = json::array({{0, 0.8}, {60, 0.6}, {90, 0}}), r = json::array({{0, 0.1}, {80, 0.5}, {90, 1}});
  auto d = import_extras({{"model", "glazing"}, {"transmittance_by_angle", t}, {"ior", 1.6}});
  EXPECT_LT(d.transmittance_rgb[0], 0);
  EXPECT_EQ(d.pane_angle_count, 3u);
  EXPECT_EQ(scene.panes.back().angle, (std::vector<float>{0, 60, 90}));
  EXPECT_EQ(scene.panes.back().transmittance, (std::vector<float>{0.8f, 0.6f, 0}));
  EXPECT_TRUE(scene.panes.back().reflectance.empty());
  d = import_extras({{"model", "glazing"}, {"transmittance_by_angle", t}, {"reflectance_by_angle", r}});
  EXPECT_EQ(scene.panes.back().angle, (std::vector<float>{0, 60, 80, 90}));
  EXPECT_EQ(scene.panes.back().transmittance, (std::vector<float>{0.8f, 0.6f, 0.2f, 0}));
  EXPECT_EQ(scene.panes.back().reflectance, (std::vector<float>{0.1f, 0.4f, 0.5f, 1}));
}

TEST_F(MaterialTest, ExtrasReplaceScatteringAlone) {
  const auto d = import_material({{"pbrMetallicRoughness", {{"baseColorFactor", {0.9, 0.9, 0.9, 0.5}}}},
                                  {"alphaMode", "BLEND"},
                                  {"emissiveFactor", {1, 1, 1}},
                                  {"extras", {{"ups", {{"model", "matte"}, {"reflectance", 0.2}}}}}});
  EXPECT_EQ(d.model, UPS_MATERIAL_MATTE);
  expect_rgb(d.reflectance_rgb, 0.2, 0.2, 0.2);
  expect_rgb(d.luminance_cd_m2, 1, 1, 1);
  EXPECT_EQ(d.alpha_mode, UPS_ALPHA_BLEND);
  EXPECT_FLOAT_EQ(d.alpha, 0.5f);
}

TEST_F(MaterialTest, OtherExtrasAreIgnored) {
  for (const json& extras : {json(3), json("note"), json::array({1}), json{{"other", {{"model", 1}}}}}) {
    import_material({{"extras", extras}});
    EXPECT_EQ(warnings(), "");
  }
}

// 2 x 1 pixels: (255, 188, 0, 255), (0, 51, 255, 128), as PNG with 4 channels.
constexpr const char* png =
    "data:image/png;base64,"
    "iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAAEUlEQVR4nGP4v4fhP4Px/wYAFTcEbTVrAQ0AAAAA"
    "SUVORK5CYII=";

// Before: the texture was left out without a word, so that glass scattered as its factor alone says, which may be 1.
TEST_F(MaterialTest, GlassKeepsItsRoughnessTexture) {
  SceneBuilder builder;
  builder.doc["images"] = json::array({{{"uri", png}}});
  builder.doc["textures"] = json::array({{{"source", 0}}});
  builder.add_square();
  builder.doc["meshes"][0]["primitives"][0]["material"] = 0;
  builder.add_node({{"mesh", 0}});
  json glass = transmissive({{"KHR_materials_volume", {{"thicknessFactor", 0.01}}}}, 1);
  glass["pbrMetallicRoughness"]["metallicRoughnessTexture"] = {{"index", 0}};
  builder.doc["materials"] = json::array({glass});
  import(builder);
  const ups_material_desc& d = scene.materials[0];
  EXPECT_EQ(d.model, UPS_MATERIAL_GLASS);
  EXPECT_NE(d.roughness_texture.v, 0u);
  EXPECT_EQ(d.reflectance_texture.v, 0u);
}

TEST_F(MaterialTest, Textures) {
  SceneBuilder builder;
  builder.doc["images"] = json::array({{{"uri", png}}});
  builder.doc["textures"] = json::array({{{"source", 0}}});
  const json info = {{"index", 0}};
  builder.add_square();
  builder.doc["meshes"][0]["primitives"][0]["material"] = 0;
  builder.add_node({{"mesh", 0}});
  builder.doc["materials"] =
      json::array({{{"alphaMode", "MASK"},
                    {"pbrMetallicRoughness", {{"baseColorTexture", info}, {"metallicRoughnessTexture", info}}},
                    {"normalTexture", {{"index", 0}, {"scale", 0.5}}}},
                   {{"pbrMetallicRoughness", {{"baseColorTexture", info}, {"metallicFactor", 0}}}}});
  import(builder);
  const ups_material_desc& d = scene.materials[0];
  EXPECT_EQ(d.model, UPS_MATERIAL_PLASTIC);  // metallic varies
  EXPECT_FLOAT_EQ(d.metallic, 1);
  EXPECT_FLOAT_EQ(d.normal_scale, 0.5f);
  const auto texels = [&](ups_texture_id id) { return scene.textures.at(id.v - 1).texels; };
  const auto expect_texels = [&](ups_texture_id id, const std::vector<double>& expected) {
    const auto found = texels(id);
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-5) << i;
  };
  const double g = std::pow((188 / 255. + 0.055) / 1.055, 2.4), g2 = std::pow((51 / 255. + 0.055) / 1.055, 2.4);
  EXPECT_EQ(d.alpha_texture.v, d.reflectance_texture.v);
  expect_texels(d.reflectance_texture, {1, g, 0, 1, 0, g2, 1, 128 / 255.});
  expect_texels(d.roughness_texture, {188 / 255., 51 / 255.});
  expect_texels(d.metallic_texture, {0, 1});
  expect_texels(d.normal_texture, {1, 188 / 255., 0, 0, 51 / 255., 1});
  expect_texels(scene.materials[1].reflectance_texture, {1, g, 0, 0, g2, 1});
  EXPECT_EQ(scene.materials[1].alpha_texture.v, 0u);
  EXPECT_EQ(scene.textures.size(), 5u);  // each use once
  EXPECT_EQ(scene.textures[0].width, 2u);
  EXPECT_TRUE(warned("no TEXCOORD_0")) << warnings();
}

TEST_F(MaterialTest, EmissiveTextureOfNothingEmitsNothing) {
  const json texture = {{"index", 0}};
  const json strong = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 9}}}};
  const json off = {{"KHR_materials_emissive_strength", {{"emissiveStrength", 0}}}};
  for (const json& material :
       {json{{"emissiveTexture", texture}},
        json{{"emissiveTexture", texture}, {"emissiveFactor", {0, 0, 0}}, {"extensions", strong}},
        json{{"emissiveTexture", texture}, {"emissiveFactor", {1, 1, 1}}, {"extensions", off}}}) {
    const auto d = import_material(material);
    expect_rgb(d.luminance_cd_m2, 0, 0, 0);
    EXPECT_EQ(warnings(), "");
  }
}

}  // namespace
