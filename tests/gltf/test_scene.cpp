// Meshes and nodes of files that are right: where things end up, turned to +Z up, how accessors and buffers are read,
// and which skipped things are named.
#include "good_file.h"

namespace {

TEST_F(GoodFile, MeshesAreSharedAndTurned) {
  SceneBuilder builder;
  builder.add_square();
  builder.add_node({{"mesh", 0}, {"translation", {1, 2, 3}}});
  builder.add_node({{"mesh", 0}, {"scale", {-2, 1, 1}}});
  import(builder);
  ASSERT_EQ(scene.meshes.size(), 1u);
  ASSERT_EQ(scene.instances.size(), 2u);
  EXPECT_EQ(scene.meshes[0].indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(scene.meshes[0].positions.size(), 12u);
  expect_near(point(scene.instances[0].to_world, 0, 0, 0), {1, -3, 2});
  expect_near(point(scene.instances[0].to_world, 0, 1, 0), {1, -3, 3});   // glTF +Y is up
  expect_near(point(scene.instances[0].to_world, 0, 0, -1), {1, -2, 2});  // glTF -Z is north
  expect_near(point(scene.instances[1].to_world, 1, 1, 0), {-2, 0, 1});
}

TEST_F(GoodFile, MaintenanceFactor) {
  SceneBuilder builder;
  builder.add_square();
  import(builder);
  EXPECT_EQ(scene.maintenance_factor, 1);
  builder.doc["scenes"][0]["extras"]["ups"]["maintenance_factor"] = 0.8;
  import(builder);
  EXPECT_EQ(scene.maintenance_factor, 0.8);
}

TEST_F(GoodFile, ParentsAndMatrices) {
  SceneBuilder builder;
  builder.add_square();
  builder.add_node(
      {{"rotation", {0, 0.7071067811865476, 0, 0.7071067811865476}}, {"children", {1}}});  // 90 deg about +Y
  builder.doc["nodes"].push_back({{"mesh", 0}, {"matrix", {2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 1}}});
  import(builder);
  ASSERT_EQ(scene.instances.size(), 1u);
  // Local (1,0,0) -> matrix (3,0,0) -> rotated (0,0,-3) -> turned (0,3,0).
  expect_near(point(scene.instances[0].to_world, 1, 0, 0), {0, 3, 0});
}

TEST_F(GoodFile, NestedAsDeepAsItLikes) {
  SceneBuilder builder;
  builder.add_square();
  const int depth = 50000;
  for (int i = 0; i < depth; ++i) builder.doc["nodes"].push_back({{"children", {i + 1}}});
  builder.doc["nodes"].push_back({{"mesh", 0}});
  builder.doc["scenes"][0]["nodes"] = {0};
  import(builder);
  EXPECT_EQ(scene.instances.size(), 1u);
}

TEST_F(GoodFile, ZeroScaleHides) {
  SceneBuilder builder;
  builder.add_square();
  builder.add_node({{"mesh", 0}, {"scale", {0, 0, 0}}});
  import(builder);
  EXPECT_TRUE(scene.instances.empty());
  EXPECT_TRUE(warned("scale of 0")) << warnings();
}

TEST_F(GoodFile, StripsFansPointsAndPlainVertices) {
  SceneBuilder builder;
  builder.add_square();
  json& primitives = builder.doc["meshes"][0]["primitives"];
  json primitive = primitives[0];
  primitive.erase("indices");
  for (int mode : {5, 6, 0}) {
    primitive["mode"] = mode;
    primitives.push_back(primitive);
  }
  builder.add_node({{"mesh", 0}});
  import(builder);
  ASSERT_EQ(scene.meshes.size(), 3u);
  EXPECT_EQ(scene.meshes[1].indices, (std::vector<uint32_t>{0, 1, 2, 1, 3, 2}));
  EXPECT_EQ(scene.meshes[2].indices, (std::vector<uint32_t>{1, 2, 0, 2, 3, 0}));
  EXPECT_TRUE(warned("primitive 3: points and lines are skipped")) << warnings();
}

// Two squares of one buffer, whose attributes bear the vertices' numbers; vertices 0 and 3 lie far away.
TEST_F(GoodFile, PrimitivesTakeTheVerticesThatTheyUse) {
  SceneBuilder builder;
  const std::vector<float> positions = {90, 0, 0, 0, 0, 0, 1, 0, 0, 90, 9, 0, 1, 1, 0,
                                        0,  1, 0, 2, 0, 0, 3, 0, 0, 3,  1, 0, 2, 1, 0};
  std::vector<float> normals, uvs, tangents;
  for (const float v : {0.f, 1.f, 2.f, 3.f, 4.f, 5.f, 6.f, 7.f, 8.f, 9.f}) {
    normals.insert(normals.end(), {v, 0, 1});
    uvs.insert(uvs.end(), {v, 2 * v});
    tangents.insert(tangents.end(), {1, 0, 0, v});
  }
  const json attributes = {{"POSITION", builder.add_floats(positions, "VEC3", 3)},
                           {"NORMAL", builder.add_floats(normals, "VEC3", 3)},
                           {"TEXCOORD_0", builder.add_floats(uvs, "VEC2", 2)},
                           {"TANGENT", builder.add_floats(tangents, "VEC4", 4)}};
  json primitives = json::array();
  for (const std::vector<uint16_t>& indices :
       {std::vector<uint16_t>{5, 1, 2, 5, 2, 4}, std::vector<uint16_t>{6, 7, 8, 6, 8, 9}})
    primitives.push_back(
        {{"attributes", attributes}, {"indices", builder.add_accessor<uint16_t>(indices, 5123, "SCALAR", 1)}});
  builder.doc["meshes"] = json::array({json{{"primitives", primitives}}});
  builder.add_node({{"mesh", 0}});
  import(builder);
  ASSERT_EQ(scene.meshes.size(), 2u);
  EXPECT_EQ(scene.meshes[0].positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}));
  EXPECT_EQ(scene.meshes[0].indices, (std::vector<uint32_t>{3, 0, 1, 3, 1, 2}));
  EXPECT_EQ(scene.meshes[0].normals, (std::vector<float>{1, 0, 1, 2, 0, 1, 4, 0, 1, 5, 0, 1}));
  EXPECT_EQ(scene.meshes[0].uvs, (std::vector<float>{1, 2, 2, 4, 4, 8, 5, 10}));
  EXPECT_EQ(scene.meshes[0].tangents, (std::vector<float>{1, 0, 0, 1, 1, 0, 0, 2, 1, 0, 0, 4, 1, 0, 0, 5}));
  EXPECT_EQ(scene.meshes[1].positions, (std::vector<float>{2, 0, 0, 3, 0, 0, 3, 1, 0, 2, 1, 0}));
  EXPECT_EQ(scene.meshes[1].indices, (std::vector<uint32_t>{0, 1, 2, 0, 2, 3}));
  EXPECT_EQ(scene.meshes[1].uvs, (std::vector<float>{6, 12, 7, 14, 8, 16, 9, 18}));
}

TEST_F(GoodFile, SparseAndQuantizedAccessors) {
  SceneBuilder builder;
  builder.add_square();
  const uint16_t index = 2;
  const float value[3] = {7, 8, 9};
  const int indices = builder.add_view(&index, sizeof index), values = builder.add_view(value, sizeof value);
  builder.doc["accessors"][0]["sparse"] = {{"count", 1},
                                           {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                           {"values", {{"bufferView", values}}}};
  const int normals =
      builder.add_accessor<int8_t>({0, 0, 127, 0, 0, 0, 127, 0, 0, 0, -128, 0, 0, 64, 0, 0}, 5120, "VEC3", 4);
  builder.doc["bufferViews"].back()["byteStride"] = 4;
  builder.doc["accessors"].back()["normalized"] = true;
  builder.doc["meshes"][0]["primitives"][0]["attributes"]["NORMAL"] = normals;
  builder.doc["extensionsRequired"] = {"KHR_mesh_quantization"};
  builder.add_node({{"mesh", 0}});
  import(builder);
  EXPECT_EQ(scene.meshes[0].positions, (std::vector<float>{0, 0, 0, 1, 0, 0, 7, 8, 9, 0, 1, 0}));
  expect_near(scene.meshes[0].normals, {0, 0, 1, 0, 0, 1, 0, 0, -1, 0, 64 / 127., 0});
}

TEST_F(GoodFile, BuffersInDataUriAndBinaryFile) {
  SceneBuilder builder;
  builder.bytes = std::string("\0\0\0\0\0\0\0\0\0\0\0\0", 12) + std::string("\0\0\x80\x3f\0\0\0\0\0\0\0\0", 12) +
                  std::string("\0\0\0\0\0\0\x80\x3f\0\0\0\0", 12);
  builder.doc["bufferViews"] = json::array({{{"buffer", 0}, {"byteLength", 36}}});
  builder.doc["accessors"] =
      json::array({{{"bufferView", 0}, {"componentType", 5126}, {"count", 3}, {"type", "VEC3"}}});
  builder.doc["meshes"] = json::array({{{"primitives", json::array({{{"attributes", {{"POSITION", 0}}}}})}}});
  builder.add_node({{"mesh", 0}});
  ASSERT_EQ(import_text(builder.glb(), "scene.glb"), UPS_OK) << error;
  const std::vector<float> triangle = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  EXPECT_EQ(scene.meshes.at(0).positions, triangle);
  builder.doc["buffers"] =
      json::array({{{"byteLength", 36},
                    {"uri", "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA"}}});
  ASSERT_EQ(import_text(builder.doc.dump()), UPS_OK) << error;
  EXPECT_EQ(scene.meshes.at(0).positions, triangle);
  // A name with blanks and other signs, percent-encoded, and a file longer than its byteLength.
  builder.doc["buffers"] = json::array({{{"byteLength", 36}, {"uri", "a%20b+c.bin"}}});
  write("a b+c.bin", builder.bytes + "tail");
  ASSERT_EQ(import_text(builder.doc.dump()), UPS_OK) << error;
  EXPECT_EQ(scene.meshes.at(0).positions, triangle);
}

TEST_F(GoodFile, NodesInNoSceneAreNamed) {
  SceneBuilder builder;
  builder.add_square();
  builder.add_node({{"mesh", 0}});
  builder.doc["nodes"].push_back({{"name", "lamp B"}, {"children", {2}}});
  builder.doc["nodes"].push_back({{"mesh", 0}});
  import(builder);
  EXPECT_EQ(scene.instances.size(), 1u);
  EXPECT_TRUE(warned("node 1 \"lamp B\" is in no scene and is skipped")) << warnings();
  EXPECT_FALSE(warned("node 2")) << "it goes with its parent";
}

TEST_F(GoodFile, WhatIsSkippedIsNamed) {
  SceneBuilder builder;
  builder.add_square();
  builder.doc["extensionsUsed"] = {"KHR_materials_variants", "KHR_materials_ior"};
  builder.doc["animations"] = json::array({{{"channels", json::array()}, {"samplers", json::array()}}});
  builder.doc["skins"] = json::array({{{"joints", {0}}}});
  builder.doc["meshes"][0]["extras"]["ups"] = {{"model", "matte"}};
  builder.doc["meshes"][0]["primitives"][0]["extras"]["ups"] = {{"model", "matte"}};
  const json light = {{"type", "point"}, {"uri", "lamp.ies"}, {"extras", {{"ups", {{"group", 1}}}}}};
  for (const char* extension : {"KHR_lights_punctual", "EXT_lights_ies"})
    builder.doc["extensions"][extension]["lights"] = json::array({light});
  builder.doc["scenes"].push_back({{"nodes", json::array()}});
  builder.add_node({{"mesh", 0}, {"skin", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", true}}}}}});
  import(builder);
  for (const char* word : {"KHR_materials_variants", "animations", "skin", "KHR_node_visibility",
                           "meshes[0]: extras.ups", "meshes[0].primitives[0]: extras.ups",
                           "KHR_lights_punctual light 0: extras.ups",
                           "EXT_lights_ies light 0: extras.ups", "scene 0", "without a material"}) {
    EXPECT_TRUE(warned(word)) << word << " is not in: " << warnings();
  }
  EXPECT_FALSE(warned("KHR_materials_ior"));
}

TEST_F(GoodFile, MeshesThatVanishAreNamed) {
  SceneBuilder builder;
  builder.add_square();
  json& meshes = builder.doc["meshes"];
  meshes.push_back({{"name", "empty"}, {"primitives", json::array()}});
  json strip = meshes[0];
  strip["name"] = "edge";
  strip["primitives"][0]["indices"] = builder.add_accessor<uint16_t>({0, 1}, 5123, "SCALAR", 1);
  strip["primitives"][0]["mode"] = 5;
  meshes.push_back(strip);
  json flat = meshes[0];
  flat["name"] = "flat";
  flat["primitives"][0]["attributes"]["POSITION"] = builder.add_floats({0, 0, 0, 1, 1, 1, 2, 2, 2, 3, 3, 3}, "VEC3", 3);
  meshes.push_back(flat);
  for (int mesh = 0; mesh < 4; ++mesh) builder.add_node({{"mesh", mesh}});
  import(builder);
  EXPECT_EQ(scene.instances.size(), 1u);
  EXPECT_TRUE(warned("mesh 1 \"empty\": skipped, it has no primitives")) << warnings();
  EXPECT_TRUE(warned("mesh 2 \"edge\", primitive 0: skipped, it has no triangle")) << warnings();
  EXPECT_TRUE(warned("mesh 3 \"flat\", primitive 0: skipped, none of its 2 triangles has an area")) << warnings();
  EXPECT_FALSE(warned("mesh 0")) << warnings();
}

}  // namespace
