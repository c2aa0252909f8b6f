// Valid files that other programs write and that tinygltf, or a hasty reader, would refuse.
#include "good_file.h"

namespace {

class ForeignFile : public GoodFile {
 protected:
  // A square node over the material.
  static SceneBuilder with_material(const json& material) {
    SceneBuilder builder;
    builder.add_square();
    builder.doc["meshes"][0]["primitives"][0]["material"] = 0;
    builder.doc["materials"] = json::array({material});
    builder.add_node({{"mesh", 0}});
    return builder;
  }
  ups_material_desc import_material(const json& material) {
    SceneBuilder builder = with_material(material);
    import(builder);
    return scene.materials.empty() ? ups_material_desc{} : scene.materials[0];
  }
  static json total_reflection(double metallic) {
    return {{"pbrMetallicRoughness",
             {{"baseColorFactor", {0.5, 0.25, 0, 1}}, {"metallicFactor", metallic}, {"roughnessFactor", 0.3}}},
            {"extensions", {{"KHR_materials_ior", {{"ior", 0}}}}}};
  }
  static void expect_metal(const ups_material_desc& d, double r, double g, double b) {
    EXPECT_EQ(d.model, UPS_MATERIAL_METAL);
    EXPECT_EQ(d.metallic, 0);
    EXPECT_FLOAT_EQ(d.roughness, 0.3f);
    EXPECT_FLOAT_EQ(d.reflectance_rgb[0], float(r));
    EXPECT_FLOAT_EQ(d.reflectance_rgb[1], float(g));
    EXPECT_FLOAT_EQ(d.reflectance_rgb[2], float(b));
    EXPECT_EQ(d.reflectance_texture.v, 0u);
    EXPECT_EQ(d.metallic_texture.v, 0u);
  }
  void expect_square() {
    ASSERT_EQ(scene.meshes.size(), 1u);
    expect_near(scene.meshes[0].positions, {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
    EXPECT_EQ(scene.meshes[0].indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
    EXPECT_EQ(warnings(), "");
  }
};

std::string base64(const std::string& bytes) {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t group = 0;
    for (size_t k = 0; k < 3; ++k) group = group << 8 | (i + k < bytes.size() ? uint8_t(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? digits[group >> (18 - 6 * k) & 63] : '=';
  }
  return text;
}

TEST_F(ForeignFile, IndexOfRefractionZeroReflectsAll) {
  expect_metal(import_material(total_reflection(0)), 1, 1, 1);
  EXPECT_EQ(warnings(), "");
  expect_metal(import_material(total_reflection(0.5)), 0.75, 0.625, 0.5);
  expect_metal(import_material(total_reflection(1)), 0.5, 0.25, 0);
  json specular = total_reflection(0);
  specular["extensions"]["KHR_materials_specular"] = {{"specularFactor", 0.5}};
  expect_metal(import_material(specular), 1, 1, 1);
  EXPECT_TRUE(warned("as KHR_materials_specular is skipped")) << warnings();
  json window = total_reflection(0);
  window["extensions"]["KHR_materials_transmission"] = {{"transmissionFactor", 1}};
  expect_metal(import_material(window), 1, 1, 1);
  EXPECT_TRUE(warned("none is transmitted")) << warnings();
  for (double ior : {-1.0, 0.5}) {
    json wrong = total_reflection(0);
    wrong["extensions"]["KHR_materials_ior"]["ior"] = ior;
    SceneBuilder builder = with_material(wrong);
    expect_failure(builder, UPS_ERROR_PARSE, {"material 0", "KHR_materials_ior", "ior"});
  }
}

TEST_F(ForeignFile, DataUrisOfAnyTypeAndLongerThanTheirBuffer) {
  SceneBuilder builder = with_material({{"extras", {{"ups", {{"model", "matte"}, {"reflectance", 0.5}}}}}});
  builder.gltf();
  const std::string padded = builder.bytes + std::string(3, '\0');
  std::string percent;
  for (const char c : builder.bytes) {
    char text[4];
    std::snprintf(text, sizeof text, "%%%02x", unsigned(uint8_t(c)));
    percent += text;
  }
  for (const std::string& uri :
       {"data:application/gltf-buffer;base64," + base64(builder.bytes),
        "data:application/gltf-buffer;base64," + base64(padded),
        "data:application/octet-stream;charset=binary;base64," + base64(builder.bytes),
        "data:;base64," + base64(builder.bytes), "data:application/gltf-buffer," + percent}) {
    builder.doc["buffers"][0]["uri"] = uri;
    ASSERT_EQ(import_text(builder.doc.dump()), UPS_OK) << error << uri.substr(0, 60);
    expect_square();
  }
}

TEST_F(ForeignFile, AccessorsWithoutABufferViewAreZeros) {
  SceneBuilder builder = with_material({{"extras", {{"ups", {{"model", "matte"}, {"reflectance", 0.5}}}}}});
  builder.doc["accessors"].push_back({{"componentType", 5126}, {"count", 4}, {"type", "VEC2"}});
  builder.doc["meshes"][0]["primitives"][0]["attributes"]["TEXCOORD_0"] = 2;
  import(builder);
  expect_square();
  expect_near(scene.meshes[0].uvs, std::vector<double>(8, 0.0));

  // Indices that are all the first vertex make triangles without area.
  const json indices = builder.doc["accessors"][1];
  builder.doc["accessors"][1].erase("bufferView");
  import(builder);
  EXPECT_TRUE(scene.meshes.empty());
  EXPECT_TRUE(warned("none of its 2 triangles has an area")) << warnings();

  // The same with sparse ones that make them the square's.
  const uint16_t places[5] = {1, 2, 3, 4, 5}, values[5] = {1, 2, 0, 2, 3};
  const int place_view = builder.add_view(places, sizeof places), value_view = builder.add_view(values, sizeof values);
  builder.doc["accessors"][1]["sparse"] = {{"count", 5},
                                           {"indices", {{"bufferView", place_view}, {"componentType", 5123}}},
                                           {"values", {{"bufferView", value_view}}}};
  import(builder);
  expect_square();
}

// As a product of matrices in single precision leaves it; a projection is none.
TEST_F(ForeignFile, MatricesWhoseLastRowIsRounded) {
  SceneBuilder builder = with_material({{"extras", {{"ups", {{"model", "matte"}, {"reflectance", 0.5}}}}}});
  json matrix = {2, 0, 0, 0, 0, 1, 0, 1e-7, 0, 0, 1, 0, 3, 0, 0, 1};
  for (const double w : {1.0000001, 0.999991}) {
    matrix[15] = w;
    builder.doc["nodes"][0]["matrix"] = matrix;
    import(builder);
    ASSERT_EQ(scene.instances.size(), 1u);
    expect_near(point(scene.instances[0].to_world, 1, 0, 0), {5 / w, 0, 0});
  }
  for (const auto& [place, value] : {std::pair(3, 0.1), {15, 1.1}, {15, 0.0}}) {
    json projection = matrix;
    projection[15] = 1;
    projection[size_t(place)] = value;
    builder.doc["nodes"][0]["matrix"] = projection;
    expect_failure(builder, UPS_ERROR_PARSE, {"node 0", "\"matrix\" must end in the row 0, 0, 0, 1"});
  }
}

TEST_F(ForeignFile, TexturesOfUnknownExtensionsLeaveTheFactor) {
  SceneBuilder builder = with_material(
      {{"pbrMetallicRoughness",
        {{"baseColorFactor", {0.5, 0.25, 0.125, 1}}, {"metallicFactor", 0}, {"baseColorTexture", {{"index", 0}}}}}});
  builder.doc["extensionsUsed"] = {"EXT_texture_webp"};
  builder.doc["images"] = json::array({{{"uri", "wood.webp"}}, {{"uri", "data:image/webp;base64,AAAA"}}});
  builder.doc["textures"] = json::array({{{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}}});
  import(builder);
  EXPECT_EQ(scene.materials[0].reflectance_texture.v, 0u);
  EXPECT_FLOAT_EQ(scene.materials[0].reflectance_rgb[1], 0.25f);
  EXPECT_TRUE(warned("material 0, texture 0: skipped")) << warnings();
  EXPECT_TRUE(warned("EXT_texture_webp; what it multiplies is taken alone")) << warnings();
  builder.doc["textures"] = json::array({{{"source", 7}}});
  expect_failure(builder, UPS_ERROR_PARSE, {"material 0, texture 0", "source", "2 images"});
}

}  // namespace
