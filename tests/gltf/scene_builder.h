// Small glTF files, written into a folder of the test's own, and imported. Called by the tests of the importer.
#pragma once
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstring>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "recorded_core.h"
#include "ups/ups_gltf.h"

using nlohmann::json;

struct ups_context {};

class SceneBuilder {
 public:
  json doc = {{"asset", {{"version", "2.0"}}}, {"scene", 0}, {"scenes", json::array({{{"nodes", json::array()}}})}};
  std::string bytes;  // of buffer 0

  // An accessor over its own buffer view; returns its index.
  template <class T>
  int add_accessor(const std::vector<T>& values, int component_type, const char* type, size_t components) {
    const int view = add_view(values.data(), values.size() * sizeof(T));
    doc["accessors"].push_back({{"bufferView", view},
                                {"componentType", component_type},
                                {"count", values.size() / components},
                                {"type", type}});
    return int(doc["accessors"].size()) - 1;
  }
  int add_floats(const std::vector<float>& values, const char* type, size_t components) {
    return add_accessor(values, 5126, type, components);
  }
  int add_view(const void* data, size_t size) {
    bytes.resize((bytes.size() + 3) / 4 * 4, '\0');
    doc["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", bytes.size()}, {"byteLength", size}});
    bytes.append(static_cast<const char*>(data), size);
    return int(doc["bufferViews"].size()) - 1;
  }
  // A unit square in the local XY plane as mesh 0, without a material of its own.
  void add_square() {
    const int positions = add_floats({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0}, "VEC3", 3);
    const int indices = add_accessor<uint16_t>({0, 1, 2, 0, 2, 3}, 5123, "SCALAR", 1);
    const json primitive = {{"attributes", {{"POSITION", positions}}}, {"indices", indices}};
    doc["meshes"].push_back({{"name", "square"}, {"primitives", json::array({primitive})}});
  }
  // A node of the scene; returns its index.
  int add_node(const json& node) {
    doc["nodes"].push_back(node);
    const int index = int(doc["nodes"].size()) - 1;
    doc["scenes"][0]["nodes"].push_back(index);
    return index;
  }

  std::string gltf() {
    if (!bytes.empty()) doc["buffers"] = json::array({{{"uri", "scene.bin"}, {"byteLength", bytes.size()}}});
    return doc.dump();
  }
  std::string glb() {
    if (!bytes.empty()) doc["buffers"] = json::array({{{"byteLength", bytes.size()}}});
    std::string text = doc.dump(), data = bytes;
    text.resize((text.size() + 3) / 4 * 4, ' ');
    data.resize((data.size() + 3) / 4 * 4, '\0');
    const auto number = [](size_t value) {
      const uint32_t v = uint32_t(value);
      return std::string(reinterpret_cast<const char*>(&v), 4);
    };
    return "glTF" + number(2) + number(12 + 8 + text.size() + 8 + data.size()) + number(text.size()) + "JSON" + text +
           number(data.size()) + std::string("BIN\0", 4) + data;
  }
};

class ImportTest : public testing::Test {
 protected:
  void SetUp() override {
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string("ups-gltf-") + std::to_string(::getpid()) + "-" + info->name();
    for (char& c : name) c = c == '/' ? '-' : c;
    folder = std::filesystem::path(testing::TempDir()) / name;
    std::filesystem::create_directories(folder);
  }
  void TearDown() override {
    ups_gltf_import_destroy(imported);
    EXPECT_EQ(living_profiles(), 0);
    EXPECT_EQ(living_fixtures(), 0);
    std::filesystem::remove_all(folder);
  }

  void write(const std::string& name, const std::string& text) {
    std::ofstream(folder / name, std::ios::binary).write(text.data(), std::streamsize(text.size()));
  }
  ups_status import_text(const std::string& text, const char* name = "scene.gltf") {
    write(name, text);
    ups_gltf_import_destroy(imported);
    imported = nullptr;
    scene = {};
    const ups_status status = ups_gltf_import_file(&context, (folder / name).c_str(), desc, &scene, &imported);
    error = status == UPS_OK ? "" : ups_gltf_last_error();
    return status;
  }
  // As .gltf with its buffer beside it. Success is expected.
  void import(SceneBuilder& builder) {
    const std::string text = builder.gltf();
    write("scene.bin", builder.bytes);
    ASSERT_EQ(import_text(text), UPS_OK) << error;
  }
  // Failure is expected, with a message that names the file and holds all words.
  void expect_failure(SceneBuilder& builder, ups_status status, std::initializer_list<const char*> words) {
    const std::string text = builder.gltf();
    write("scene.bin", builder.bytes);
    EXPECT_EQ(import_text(text), status) << error;
    expect_words(words);
  }
  void expect_words(std::initializer_list<const char*> words) {
    EXPECT_NE(error.find("scene.gl"), std::string::npos) << error;
    for (const char* word : words) EXPECT_NE(error.find(word), std::string::npos) << word << " is not in: " << error;
  }
  std::string warnings() {
    size_t needed = 0;
    EXPECT_EQ(ups_gltf_get_warnings(imported, nullptr, 0, &needed), UPS_OK);
    std::string text(needed, '\0');
    EXPECT_EQ(ups_gltf_get_warnings(imported, text.data(), needed, &needed), UPS_OK);
    text.resize(needed - 1);
    return text;
  }
  bool warned(const std::string& words) { return warnings().find(words) != std::string::npos; }
  std::string name_of(uint32_t sensor) {
    char text[100] = "";
    size_t needed = 0;
    EXPECT_EQ(ups_gltf_get_sensor_name(imported, sensor, text, sizeof text, &needed), UPS_OK);
    return text;
  }
  ups_gltf_sensor_info sensor_info(uint32_t sensor) {
    ups_gltf_sensor_info info{};
    info.struct_size = sizeof info;
    EXPECT_EQ(ups_gltf_get_sensor(imported, sensor, &info), UPS_OK);
    return info;
  }

  std::filesystem::path folder;
  ups_context context;
  ups_scene scene;
  ups_gltf_import* imported = nullptr;
  const ups_gltf_import_desc* desc = nullptr;
  std::string error;
};
