// The names of what emits: those of the nodes, for the columns of tables.
#include "good_file.h"

namespace {

class SourceNames : public GoodFile {
 protected:
  std::string name(ups_source_kind kind, uint32_t id) {
    char text[300] = "";
    size_t needed = 0;
    EXPECT_EQ(ups_gltf_get_source_name(imported, kind, id, text, sizeof text, &needed), UPS_OK) << kind << " " << id;
    EXPECT_EQ(needed, std::strlen(text) + 1);
    return text;
  }
  std::string luminaire(uint32_t id) { return name(UPS_SOURCE_LUMINAIRE, id); }
  std::string instance(uint32_t id) { return name(UPS_SOURCE_INSTANCE, id); }
};

json lamp(const char* node_name) {
  json node = {{"extras", {{"ups", {{"luminaire", {{"file", "a.ies"}}}}}}}};
  if (node_name) node["name"] = node_name;
  return node;
}

TEST_F(SourceNames, OfNodesEachOnce) {
  write("a.ies", "good");
  SceneBuilder builder;
  builder.add_node(lamp("desk lamp"));
  builder.add_node(lamp("desk lamp"));
  builder.add_node(lamp(nullptr));
  builder.add_node(lamp("\u00fcber/1"));
  builder.add_node(lamp("desk lamp_standard_error"));  // its column would be that of desk_lamp's error
  builder.add_node(lamp(nullptr));
  import(builder);
  const char* expected[] = {"desk_lamp", "desk_lamp_2", "luminaire_1", "_ber_1", "desk_lamp_standard_error_2",
                            "luminaire_2"};
  for (uint32_t i = 0; i < 6; ++i) EXPECT_EQ(luminaire(i + 1), expected[i]);
}

TEST_F(SourceNames, FilesOfLuminairesAreThoseThatTheSceneNames) {
  write("a.ies", "good");
  SceneBuilder builder;
  builder.doc["extensions"]["EXT_lights_ies"]["lights"] =
      json::array({{{"uri", "a.ies"}}, {{"uri", "data:application/octet-stream;base64,Z29vZA=="}}});
  builder.add_node(lamp("desk"));
  for (const int light : {0, 1}) builder.add_node({{"extensions", {{"EXT_lights_ies", {{"light", light}}}}}});
  import(builder);
  const char* expected[] = {"a.ies", "a.ies", ""};  // the last lies within the scene file
  for (uint32_t i = 0; i < 3; ++i) {
    char text[300] = "";
    size_t needed = 0;
    EXPECT_EQ(ups_gltf_get_source_file(imported, UPS_SOURCE_LUMINAIRE, i + 1, text, sizeof text, &needed), UPS_OK);
    EXPECT_STREQ(text, expected[i]) << i;
  }
  size_t needed = 0;
  EXPECT_EQ(ups_gltf_get_source_file(imported, UPS_SOURCE_LUMINAIRE, 4, nullptr, 0, &needed),
            UPS_ERROR_INVALID_ARGUMENT);
}

TEST_F(SourceNames, OfEmittingSurfacesAndFixtures) {
  SceneBuilder builder;
  builder.add_square();
  builder.doc["materials"] = json::array({{{"emissiveFactor", {1, 1, 1}}}, json::object()});
  json& primitives = builder.doc["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  primitives[0]["material"] = 1;  // does not emit, so it takes no name
  primitives[1]["material"] = 0;
  builder.add_node({{"mesh", 0}, {"name", "panel"}});
  builder.add_node({{"mesh", 0}});
  const json emitter = {{"emitter", {{"shape", "disc"}, {"radius_m", 0.01}, {"flux_lm", 100}}}};
  const json mirror = {{"reflector", {{"profile", "cone"}}}};
  const json fixture = {{"parts", json::array({emitter, mirror, emitter})}};
  builder.add_node({{"name", "spot"}, {"extras", {{"ups", {{"fixture", fixture}}}}}});
  import(builder);
  ASSERT_EQ(scene.instances.size(), 4u);
  EXPECT_EQ(instance(2), "panel");
  EXPECT_EQ(instance(4), "instance_1");
  EXPECT_EQ(instance(recorded_part_instance(1, 1)), "spot");
  EXPECT_EQ(instance(recorded_part_instance(1, 3)), "spot_2");
  size_t needed = 0;
  for (const auto& [kind, id] : {std::pair<ups_source_kind, uint32_t>{UPS_SOURCE_INSTANCE, 1},
                                 {UPS_SOURCE_INSTANCE, recorded_part_instance(1, 2)},
                                 {UPS_SOURCE_LUMINAIRE, 2},
                                 {UPS_SOURCE_GROUP, 0}}) {
    EXPECT_EQ(ups_gltf_get_source_name(imported, kind, id, nullptr, 0, &needed), UPS_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(ups_gltf_last_error()).find("source"), std::string::npos);
  }
  EXPECT_EQ(ups_gltf_get_source_name(nullptr, UPS_SOURCE_INSTANCE, 2, nullptr, 0, &needed), UPS_ERROR_INVALID_ARGUMENT);
}

// What messages of the core call "material 1" and the like, by the words of the importer's own messages.
TEST_F(SourceNames, PlacesOfParts) {
  write("a.ies", "good");
  SceneBuilder builder;
  builder.add_square();
  builder.doc["materials"] = json::array({{{"name", "Tiles"}}, json::object()});
  json& primitives = builder.doc["meshes"][0]["primitives"];
  primitives.push_back(primitives[0]);
  for (int i : {0, 1}) primitives[size_t(i)]["material"] = i;
  builder.add_node({{"mesh", 0}, {"name", "wall"}});
  builder.add_node(lamp("desk lamp"));
  const json emitter = {{"emitter", {{"shape", "disc"}, {"radius_m", 0.01}, {"flux_lm", 100}}}};
  builder.add_node({{"name", "spot"}, {"extras", {{"ups", {{"fixture", {{"parts", json::array({emitter})}}}}}}}});
  import(builder);
  const auto place = [&](ups_gltf_part part, uint32_t id) {
    char text[300] = "";
    size_t needed = 0;
    EXPECT_EQ(ups_gltf_get_place(imported, part, id, text, sizeof text, &needed), UPS_OK) << part << " " << id;
    EXPECT_EQ(needed, std::strlen(text) + 1);
    return std::string(text);
  };
  EXPECT_EQ(place(UPS_GLTF_PART_MATERIAL, 1), "material 0 \"Tiles\"");
  EXPECT_EQ(place(UPS_GLTF_PART_MATERIAL, 0x3000002), "material 1") << "an id's number counts";
  EXPECT_EQ(place(UPS_GLTF_PART_MESH, 2).substr(0, 6), "mesh 0");
  const std::string wall = place(UPS_GLTF_PART_INSTANCE, 1), number = wall.substr(0, wall.find(' ', 5));
  EXPECT_EQ(wall, number + " \"wall\", primitive 0");
  EXPECT_EQ(place(UPS_GLTF_PART_INSTANCE, 2), number + " \"wall\", primitive 1");
  EXPECT_NE(place(UPS_GLTF_PART_LUMINAIRE, 1).find("\"desk lamp\""), std::string::npos);
  EXPECT_NE(place(UPS_GLTF_PART_FIXTURE, 1).find("\"spot\""), std::string::npos);
  EXPECT_NE(place(UPS_GLTF_PART_INSTANCE, recorded_part_instance(1, 1)).find("\"spot\", part 0"), std::string::npos);
  size_t needed = 0;
  for (const auto& [part, id] : {std::pair<ups_gltf_part, uint32_t>{UPS_GLTF_PART_MATERIAL, 3}, {-1, 1}, {5, 1}})
    EXPECT_EQ(ups_gltf_get_place(imported, part, id, nullptr, 0, &needed), UPS_ERROR_INVALID_ARGUMENT) << part;
  EXPECT_EQ(ups_gltf_get_place(nullptr, UPS_GLTF_PART_MATERIAL, 1, nullptr, 0, &needed), UPS_ERROR_INVALID_ARGUMENT);
}

TEST_F(SourceNames, LongNamesAreCut) {
  write("a.ies", "good");
  SceneBuilder builder;
  for (int i = 0; i < 2; ++i) builder.add_node(lamp(std::string(5000, 'n').c_str()));
  import(builder);
  EXPECT_LE(luminaire(1).size(), 200u);
  EXPECT_EQ(luminaire(2), luminaire(1) + "_2");
}

}  // namespace
