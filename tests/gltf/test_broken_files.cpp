// Files that are wrong: the importer must say what, where and what would be right, and neither crash nor leak.
#include <cmath>
#include <functional>
#include <random>

#include "scene_builder.h"

namespace {

class BrokenFile : public ImportTest {
 protected:
  SceneBuilder square() {
    SceneBuilder builder;
    builder.add_square();
    builder.add_node({{"mesh", 0}, {"name", "floor"}});
    return builder;
  }
  SceneBuilder with_material(const json& material) {
    SceneBuilder builder = square();
    builder.doc["materials"] = json::array({material});
    return builder;
  }
  SceneBuilder with_extras(const json& ups) {
    SceneBuilder builder;
    builder.add_node({{"name", "desk"}, {"extras", {{"ups", ups}}}});
    return builder;
  }
};

TEST_F(BrokenFile, NoSuchFile) {
  EXPECT_EQ(ups_gltf_import_file(&context, (folder / "none.gltf").c_str(), nullptr, &scene, &imported), UPS_ERROR_IO);
  EXPECT_NE(std::string(ups_gltf_last_error()).find("none.gltf"), std::string::npos);
  EXPECT_EQ(imported, nullptr);
}

TEST_F(BrokenFile, AFolderIsNoFile) {
  EXPECT_EQ(ups_gltf_import_file(&context, folder.c_str(), nullptr, &scene, &imported), UPS_ERROR_IO);
}

TEST_F(BrokenFile, NullArguments) {
  EXPECT_EQ(ups_gltf_import_file(nullptr, "a", nullptr, &scene, &imported), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_gltf_import_file(&context, nullptr, nullptr, &scene, &imported), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_gltf_import_file(&context, "a", nullptr, nullptr, &imported), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_gltf_import_file(&context, "a", nullptr, &scene, nullptr), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_gltf_get_sensor_count(nullptr, nullptr), UPS_ERROR_INVALID_ARGUMENT);
  ups_gltf_import_destroy(nullptr);
}

TEST_F(BrokenFile, FieldsOfALaterVersionMustBeZero) {
  struct {
    ups_gltf_import_desc options;
    char future[16];
  } longer;
  std::memset(&longer, 0xff, sizeof longer);
  ups_gltf_import_desc_init(&longer.options, uint32_t(sizeof longer));  // leaves 0 in what it does not know
  desc = &longer.options;
  SceneBuilder builder;
  import(builder);
  longer.future[5] = 1;
  EXPECT_EQ(import_text(builder.gltf()), UPS_ERROR_UNSUPPORTED);
  EXPECT_NE(error.find("struct_size is " + std::to_string(sizeof longer)), std::string::npos) << error;
}

TEST_F(BrokenFile, BadJson) {
  EXPECT_EQ(import_text("{\"asset\":\n {\"version\" \"2.0\"}}"), UPS_ERROR_PARSE);
  expect_words({"line 2"});
  EXPECT_EQ(import_text(""), UPS_ERROR_PARSE);
  EXPECT_EQ(import_text("[]"), UPS_ERROR_PARSE);
  EXPECT_EQ(import_text("{}"), UPS_ERROR_PARSE);
  expect_words({"asset"});
}

TEST_F(BrokenFile, DeeplyNestedJson) {
  const std::string deep = std::string(100000, '[') + std::string(100000, ']');
  EXPECT_EQ(import_text("{\"asset\":{\"version\":\"2.0\"},\"extras\":" + deep + "}"), UPS_ERROR_PARSE);
  expect_words({"nested"});
}

TEST_F(BrokenFile, OldVersion) {
  SceneBuilder builder = square();
  builder.doc["asset"]["version"] = "1.0";
  expect_failure(builder, UPS_ERROR_UNSUPPORTED, {"1.0", "2.0"});
}

TEST_F(BrokenFile, UnknownRequiredExtension) {
  SceneBuilder builder = square();
  builder.doc["extensionsRequired"] = {"KHR_draco_mesh_compression"};
  expect_failure(builder, UPS_ERROR_UNSUPPORTED, {"KHR_draco_mesh_compression", "requires"});
}

TEST_F(BrokenFile, MissingBuffer) {
  SceneBuilder builder = square();
  EXPECT_EQ(import_text(builder.gltf()), UPS_ERROR_IO);
  expect_words({"buffer 0", "scene.bin"});
}

TEST_F(BrokenFile, ShortBuffer) {
  SceneBuilder builder = square();
  const std::string text = builder.gltf();
  write("scene.bin", "abc");
  EXPECT_EQ(import_text(text), UPS_ERROR_PARSE);
  expect_words({"buffer 0", "scene.bin", "3 bytes"});
}

TEST_F(BrokenFile, BufferInBadBase64) {
  for (const char* uri : {"data:application/octet-stream;base64,AAAA", "data:application/octet-stream;base64,",
                          "data:image/webp;base64,AAAA", "data:"}) {
    SceneBuilder builder = square();
    builder.gltf();
    builder.doc["buffers"][0]["uri"] = uri;
    EXPECT_EQ(import_text(builder.doc.dump()), UPS_ERROR_PARSE) << uri;
    expect_words({"buffer 0"});
  }
}

TEST_F(BrokenFile, TruncatedBinaryFileAtEveryLength) {
  const std::string whole = square().glb();
  ASSERT_EQ(import_text(whole, "scene.glb"), UPS_OK) << error;
  for (size_t length = 0; length < whole.size(); ++length) {
    ASSERT_NE(import_text(whole.substr(0, length), "scene.glb"), UPS_OK) << length;
  }
  expect_words({"truncated"});
}

TEST_F(BrokenFile, ThatCannotBeReadToItsEnd) {
  if (!std::filesystem::exists("/proc/self/mem")) GTEST_SKIP() << "no such file here";
  EXPECT_EQ(ups_gltf_import_file(&context, "/proc/self/mem", nullptr, &scene, &imported), UPS_ERROR_IO);
  const std::string message = ups_gltf_last_error();
  EXPECT_NE(message.find("cannot read the file '/proc/self/mem'"), std::string::npos) << message;
}

// Of another kind: the first member of a handle says what it is.
TEST_F(BrokenFile, ThatIsNoImportIsRefused) {
  const void* zeros[8] = {};
  auto* wrong = reinterpret_cast<ups_gltf_import*>(zeros);
  uint32_t count = 7;
  EXPECT_EQ(ups_gltf_get_sensor_count(wrong, &count), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(count, 7u);
  ups_gltf_import_destroy(wrong);  // stays
}

TEST_F(BrokenFile, BinaryFileWhoseHeaderIsTooShort) {
  std::string bytes = square().glb();
  for (const char length : {0, 12, 19}) {
    bytes.replace(8, 4, {length, 0, 0, 0});
    EXPECT_EQ(import_text(bytes, "scene.glb"), UPS_ERROR_PARSE);
    expect_words({"bad .glb", "bytes, less than"});
  }
}

TEST_F(BrokenFile, VersionThatIsNotReadYet) {
  SceneBuilder later = square(), too_late = square();
  later.doc["asset"]["version"] = too_late.doc["asset"]["version"] = "2.5";
  import(later);
  too_late.doc["asset"]["minVersion"] = "2.5";
  expect_failure(too_late, UPS_ERROR_UNSUPPORTED, {"asset.minVersion", "2.5"});
}

TEST_F(BrokenFile, NanVertex) {
  SceneBuilder builder = square();
  const float nan = std::nanf("");
  std::memcpy(&builder.bytes[7 * 4], &nan, 4);  // vertex 2, y
  expect_failure(builder, UPS_ERROR_PARSE, {"mesh 0 \"square\"", "POSITION", "accessor 0", "element 2", "finite"});
}

TEST_F(BrokenFile, IndexOutOfRange) {
  SceneBuilder builder = square();
  builder.bytes[48 + 2 * 5] = 77;
  expect_failure(builder, UPS_ERROR_PARSE, {"mesh 0 \"square\", primitive 0", "index 77", "accessor 1", "4 vertices"});
}

TEST_F(BrokenFile, AccessorPastItsView) {
  SceneBuilder builder = square();
  builder.doc["accessors"][0]["count"] = 5;
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "5 elements", "48 bytes"});
  builder.doc["accessors"][0]["count"] = 9007199254740991;  // 2^53 - 1
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0"});
  builder.doc["accessors"][0]["count"] = 4;
  builder.doc["accessors"][0]["byteOffset"] = 4;
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "offset 4"});
  builder.doc["accessors"][0]["byteOffset"] = -4;
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "byteOffset"});
}

TEST_F(BrokenFile, NumbersWithoutAnUpperLimitShowNone) {
  SceneBuilder builder = square();
  builder.doc["accessors"][0]["count"] = 0;
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "\"count\" must be a whole number at least 1"});
  EXPECT_EQ(error.find("e+18"), std::string::npos) << error;
}

TEST_F(BrokenFile, ViewPastItsBuffer) {
  SceneBuilder builder = square();
  builder.doc["bufferViews"][0]["byteOffset"] = 50;
  expect_failure(builder, UPS_ERROR_PARSE, {"buffer view 0", "past buffer 0"});
  builder.doc["bufferViews"][0]["byteOffset"] = 9007199254740991;
  expect_failure(builder, UPS_ERROR_PARSE, {"buffer view 0"});
  builder.doc["bufferViews"][0]["buffer"] = 3;
  expect_failure(builder, UPS_ERROR_PARSE, {"buffer view 0", "buffer", "out of range"});
}

TEST_F(BrokenFile, IndicesOfOtherArrays) {
  for (const char* path :
       {"/meshes/0/primitives/0/indices", "/meshes/0/primitives/0/attributes/POSITION",
        "/meshes/0/primitives/0/material", "/accessors/0/bufferView", "/nodes/0/mesh", "/nodes/0/camera"}) {
    for (const json& value : {json(99), json(-2), json("0"), json(0.5)}) {
      SceneBuilder builder = square();
      builder.doc[json::json_pointer(path)] = value;
      expect_failure(builder, UPS_ERROR_PARSE, {std::strrchr(path, '/') + 1});
    }
  }
}

TEST_F(BrokenFile, WrongAccessorKinds) {
  SceneBuilder builder = square();
  builder.doc["accessors"][0]["type"] = "VEC2";
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "VEC3"});
  builder = square();
  builder.doc["accessors"][1]["componentType"] = 5126;
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 1"});
  builder = square();
  builder.doc["accessors"][0]["componentType"] = 5130;
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "5130"});
}

TEST_F(BrokenFile, SparseAccessorWithoutBytes) {
  SceneBuilder builder = square();
  auto& accessor = builder.doc["accessors"][0];
  accessor.erase("bufferView");
  accessor["count"] = 4000000000u;
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "too large"});
}

TEST_F(BrokenFile, SparseIndexOutOfRange) {
  SceneBuilder builder = square();
  const uint16_t index = 4;
  const float value[3] = {};
  const int indices = builder.add_view(&index, sizeof index), values = builder.add_view(value, sizeof value);
  builder.doc["accessors"][0]["sparse"] = {{"count", 1},
                                           {"indices", {{"bufferView", indices}, {"componentType", 5123}}},
                                           {"values", {{"bufferView", values}}}};
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "sparse", "index 4"});
  json& sparse = builder.doc["accessors"][0]["sparse"];
  const json good = sparse;
  sparse["values"]["bufferView"] = 17;
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "sparse", "17"});
  for (const char* part : {"indices", "values"})
    for (const json& offset : {json("x"), json(-1), json(1e300)}) {
      sparse = good;
      sparse[part]["byteOffset"] = offset;
      expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "sparse", part, "byteOffset"});
    }
  for (const json& count : {json(1.9), json(0)}) {
    sparse = good;
    sparse["count"] = count;
    expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "sparse", "count"});
  }
}

TEST_F(BrokenFile, NodesThatAreNoTree) {
  SceneBuilder builder = square();
  builder.doc["nodes"].push_back({{"children", {1}}, {"name", "snake"}});
  builder.doc["nodes"][0]["children"] = {1};
  expect_failure(builder, UPS_ERROR_PARSE, {"node 1 \"snake\"", "tree"});
  builder = square();
  builder.doc["nodes"][0]["children"] = {8};
  expect_failure(builder, UPS_ERROR_PARSE, {"node 0 \"floor\"", "children", "node 8"});
  builder = square();
  builder.doc["scene"] = 4;
  expect_failure(builder, UPS_ERROR_PARSE, {"scene 4"});
  builder.doc["scene"] = 4294967296;  // and not 0
  expect_failure(builder, UPS_ERROR_PARSE, {"scene"});
  for (const json& node : {json("0"), json(0.5), json(nullptr)}) {  // what follows would be lost
    builder = square();
    builder.doc["scenes"][0]["nodes"] = {0, node};
    expect_failure(builder, UPS_ERROR_PARSE, {"scene 0", "nodes", "whole numbers"});
  }
}

TEST_F(BrokenFile, BadNodeTransforms) {
  for (const auto& [key, value] : std::initializer_list<std::pair<const char*, json>>{
           {"translation", {1, 2}}, {"rotation", {0, 0, 0, 0}}, {"scale", {1}}, {"matrix", {1, 2, 3}}}) {
    SceneBuilder builder = square();
    builder.doc["nodes"][0][key] = value;
    expect_failure(builder, UPS_ERROR_PARSE, {"node 0 \"floor\"", key});
  }
  // tinygltf takes what is no array of numbers for left out (before: a model in mm stayed a thousand times as large).
  for (const auto& [key, value] : std::initializer_list<std::pair<const char*, json>>{
           {"scale", 0.001}, {"translation", json::array({"1", 2, 3})}, {"rotation", "none"}, {"matrix", {{"a", 1}}}}) {
    SceneBuilder builder = square();
    builder.doc["nodes"][0][key] = value;
    expect_failure(builder, UPS_ERROR_PARSE, {"node 0 \"floor\"", key, "must be an array"});
  }
  SceneBuilder builder = square();
  builder.doc["nodes"][0]["matrix"] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  builder.doc["nodes"][0]["translation"] = {0, 3, 0};
  expect_failure(builder, UPS_ERROR_PARSE, {"node 0 \"floor\"", "translation", "beside a matrix"});
  builder = square();
  builder.doc["nodes"][0]["scale"] = {1e200, 1e200, 1e200};
  expect_failure(builder, UPS_ERROR_PARSE, {"node 0 \"floor\"", "1e+99"});
}

TEST_F(BrokenFile, MembersOfTheWrongKind) {
  SceneBuilder builder = square();
  builder.doc["accessors"][0]["normalized"] = 1;
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 0", "normalized", "true or false"});
  builder = square();
  builder.doc["meshes"][0]["primitives"][0]["mode"] = "5";
  expect_failure(builder, UPS_ERROR_PARSE, {"primitive 0", "mode", "whole number"});
  builder = square();
  builder.doc["scene"] = "1";
  expect_failure(builder, UPS_ERROR_PARSE, {"scene", "whole number"});
  builder = square();
  builder.doc["scenes"][0]["nodes"] = 0;
  expect_failure(builder, UPS_ERROR_PARSE, {"scene 0", "nodes", "array"});
}

TEST_F(BrokenFile, MembersOfTheWrongLengthOrMissing) {
  SceneBuilder builder = with_material({{"name", "lamp"}, {"emissiveFactor", {1, 1}}});
  expect_failure(builder, UPS_ERROR_PARSE, {"material 0 \"lamp\"", "emissiveFactor", "3"});
  builder = square();
  builder.doc["accessors"][1].erase("componentType");
  expect_failure(builder, UPS_ERROR_PARSE, {"accessor 1", "componentType", "missing"});
}

TEST_F(BrokenFile, EmissiveTextureIsNotLeftOut) {
  SceneBuilder builder =
      with_material({{"name", "lamp"}, {"emissiveFactor", {0, 1, 0}}, {"emissiveTexture", {{"index", 0}}}});
  expect_failure(builder, UPS_ERROR_UNSUPPORTED, {"material 0 \"lamp\"", "emissiveTexture"});
}

TEST_F(BrokenFile, MissingTextureImage) {
  SceneBuilder builder = with_material({{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}});
  expect_failure(builder, UPS_ERROR_PARSE, {"material 0", "index"});
  builder.doc["textures"] = json::array({{{"source", 0}}});
  builder.doc["images"] = json::array({{{"uri", "wood.png"}}});
  expect_failure(builder, UPS_ERROR_IO, {"material 0", "image 0", "wood.png"});
  write("wood.png", "no image");
  expect_failure(builder, UPS_ERROR_PARSE, {"image 0", "PNG or JPEG"});
  builder.doc["images"][0] = {{"bufferView", 0}, {"mimeType", "image/png"}};
  builder.doc["bufferViews"][0]["byteLength"] = 4000;
  expect_failure(builder, UPS_ERROR_PARSE, {"image 0", "buffer view 0", "past buffer 0"});
}

struct BadExtras {
  const char* name;
  json ups;
  std::initializer_list<const char*> words;
};

TEST_F(BrokenFile, MaterialExtras) {
  const BadExtras cases[] = {
      {"unknown model", {{"model", "velvet"}}, {"model", "matte"}},
      {"no model", {{"reflectance", 0.5}}, {"model"}},
      {"unknown key", {{"model", "matte"}, {"reflectence", 0.5}}, {"reflectence", "allowed"}},
      {"key of another model", {{"model", "matte"}, {"roughness", 0.5}}, {"roughness", "reflectance"}},
      {"above 1", {{"model", "matte"}, {"reflectance", 1.5}}, {"reflectance", "from 0 to 1"}},
      {"two numbers", {{"model", "matte"}, {"reflectance", {0.5, 0.5}}}, {"reflectance"}},
      {"a word", {{"model", "matte"}, {"reflectance", "grey"}}, {"reflectance"}},
      {"index and reflectance", {{"model", "metal"}, {"reflectance", 0.5}, {"ior", 1}, {"k", 3}}, {"reflectance", "k"}},
      {"index without k", {{"model", "metal"}, {"ior", 1}}, {"k"}},
      {"creates light", {{"model", "diffuser"}, {"reflectance", 0.6}, {"transmittance", 0.5}}, {"transmittance"}},
      {"ior below 1", {{"model", "glass"}, {"ior", 0.5}}, {"ior"}},
      {"priority of half", {{"model", "glass"}, {"priority", 0.5}}, {"priority"}},
      {"priority of a pane", {{"model", "glazing"}, {"priority", 1}}, {"priority"}},
      {"a table and a number",
       {{"model", "glazing"}, {"transmittance", 0.5}, {"transmittance_by_angle", {{0, 0.5}, {90, 0}}}},
       {"transmittance", "transmittance_by_angle"}},
      {"a table that falls", {{"model", "glazing"}, {"transmittance_by_angle", {{0, 1}, {60, 0.5}, {50, 0.4}, {90, 0}}}},
       {"transmittance_by_angle", "element 2", "ascend"}},
      {"a table up to 80", {{"model", "glazing"}, {"transmittance_by_angle", {{0, 1}, {80, 0.5}}}}, {"90 degrees"}},
      {"no pairs", {{"model", "glazing"}, {"transmittance_by_angle", {0, 1}}}, {"element 0", "[degrees, share]"}},
      {"reflectance alone", {{"model", "glazing"}, {"reflectance_by_angle", {{0, 0}, {90, 1}}}},
       {"reflectance_by_angle", "transmittance_by_angle"}},
      {"no object", 3, {"object"}}};
  for (const BadExtras& c : cases) {
    SCOPED_TRACE(c.name);
    SceneBuilder builder = with_material({{"name", "wall"}, {"extras", {{"ups", c.ups}}}});
    expect_failure(builder, UPS_ERROR_PARSE, c.words);
    expect_words({"material 0 \"wall\"", "extras.ups"});
  }
}

TEST_F(BrokenFile, NodeExtras) {
  const json grid = {{"width_m", 4}, {"height_m", 3}, {"columns", 2}, {"rows", 2}};
  const auto changed = [&](const char* key, const json& value) {
    json copy = grid;
    copy[key] = value;
    return json{{"meters", copy}};
  };
  const BadExtras cases[] = {
      {"unknown key", {{"metres", 1}}, {"metres", "allowed"}},
      {"unknown meter key", changed("colums", 4), {"colums"}},
      {"no columns", {{"meters", {{"width_m", 4}, {"height_m", 3}, {"rows", 2}}}}, {"columns"}},
      {"no width", changed("width_m", 0), {"width_m"}},
      {"half a column", changed("columns", 2.5), {"columns", "whole"}},
      {"too many", changed("columns", 16777216), {"columns", "16777216"}},
      {"unknown kind", changed("kind", "round"), {"kind", "planar"}},
      {"area of points", {{"meters", {{"points_m", {{0, 0, 0}}}, {"area", true}}}}, {"area"}},
      {"fewer normals", {{"meters", {{"points_m", {{0, 0, 0}, {1, 0, 0}}}, {"normals", {{0, 0, 1}}}}}}, {"normals"}},
      {"null normal", {{"meters", {{"points_m", {{0, 0, 0}}}, {"normals", {{0, 0, 0}}}}}}, {"normals", "element 0"}},
      {"no points", {{"meters", {{"points_m", json::array()}}}}, {"points_m"}},
      {"footprint of a cell",
       {{"meters", {{"width_m", 4}, {"height_m", 3}, {"columns", 2}, {"rows", 2}, {"area", true}, {"footprint_m", 1}}}},
       {"footprint_m", "area"}},
      {"negative footprint", changed("footprint_m", -1), {"footprint_m"}},
      {"no polygon", {{"meters", {{"en12464", {{"border_m", 0.2}}}}}}, {"meters.en12464", "polygon_m", "missing"}},
      {"no corner", {{"meters", {{"en12464", {{"polygon_m", {{0, 0}, {1, 2, 3}}}}}}}}, {"polygon_m", "element 1", "[x, y]"}},
      {"holes of numbers",
       {{"meters", {{"en12464", {{"polygon_m", {{0, 0}, {4, 0}, {4, 4}}}, {"holes_m", {1, 2}}}}}}},
       {"holes_m", "corners"}},
      {"unknown word of a grid", {{"meters", {{"en12464", {{"polygon", 1}}}}}}, {"polygon", "allowed"}},
      {"negative border",
       {{"meters", {{"en12464", {{"polygon_m", {{0, 0}, {4, 0}, {4, 4}}}, {"border_m", -1}}}}}}, {"border_m"}},
      {"line without count", {{"meters", {{"line", {{"from_m", {0, 0, 0}}, {"to_m", {1, 0, 0}}}}}}}, {"count", "missing"}},
      {"line without end", {{"meters", {{"line", {{"from_m", {0, 0, 0}}, {"count", 4}}}}}}, {"to_m", "missing"}},
      {"line of a point",
       {{"meters", {{"line", {{"from_m", {1, 0, 0}}, {"to_m", {1, 0, 0}}, {"count", 4}}}}}}, {"to_m", "two ends"}},
      {"surface without mesh", {{"meters", {{"surface", true}}}}, {"surface", "mesh"}},
      {"no surface", {{"meters", {{"surface", false}}}}, {"surface", "true"}},
      {"cylinders on a surface", {{"meters", {{"surface", true}, {"kind", "cylindrical"}}}}, {"kind", "planar"}},
      {"lightmap without mesh", {{"meters", {{"lightmap", {{"width", 4}}}}}}, {"lightmap", "mesh"}},
      {"size without camera", {{"width", 640}}, {"width", "camera"}},
      {"projection without camera", {{"projection", "panorama"}}, {"projection", "camera"}},
      {"no file", {{"luminaire", {{"flux_lm", 900}}}}, {"file"}},
      {"negative dimming", {{"luminaire", {{"file", "a.ies"}, {"dimming", -1}}}}, {"dimming"}},
      {"flux beyond a float", {{"luminaire", {{"file", "a.ies"}, {"flux_lm", 1e300}}}}, {"flux_lm", "from 0 to 3.4"}},
      {"too cold", {{"luminaire", {{"file", "a.ies"}, {"colour_temperature_k", 500}}}}, {"colour_temperature_k"}},
      {"black", {{"luminaire", {{"file", "a.ies"}, {"color", {0, 0, 0}}}}}, {"color"}},
      {"negative colour", {{"luminaire", {{"file", "a.ies"}, {"color", {1, -1, 0}}}}}, {"color"}},
      {"two colours",
       {{"luminaire", {{"file", "a.ies"}, {"color", {1, 1, 0}}, {"colour_temperature_k", 3000}}}},
       {"color", "colour_temperature_k"}},
      {"unknown luminaire key", {{"luminaire", {{"file", "a.ies"}, {"flux", 9}}}}, {"flux"}}};
  write("a.ies", "good");
  for (const BadExtras& c : cases) {
    SCOPED_TRACE(c.name);
    SceneBuilder builder = with_extras(c.ups);
    expect_failure(builder, UPS_ERROR_PARSE, c.words);
    expect_words({"node 0 \"desk\"", "extras.ups"});
  }
}

TEST_F(BrokenFile, WordsOfCameras) {
  const BadExtras cases[] = {
      {"unknown projection", {{"projection", "fisheye"}}, {"projection", "equidistant", "panorama"}},
      {"projection by number", {{"projection", 1}}, {"projection"}},
      {"unknown layer", {{"layers", {"depth", "motion"}}}, {"layers", "albedo, normal, depth, id"}},
      {"layer by number", {{"layers", {4}}}, {"layers"}},
      {"layers in one text", {{"layers", "depth"}}, {"layers", "array"}}};
  for (const BadExtras& c : cases) {
    SCOPED_TRACE(c.name);
    SceneBuilder builder = with_extras(c.ups);
    builder.doc["cameras"] = json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}});
    builder.doc["nodes"][0]["camera"] = 0;
    expect_failure(builder, UPS_ERROR_PARSE, c.words);
    expect_words({"node 0 \"desk\""});
  }
}

TEST_F(BrokenFile, MeterKindThatTheCoreRefuses) {
  SceneBuilder builder = with_extras(
      {{"meters", {{"width_m", 4}, {"height_m", 3}, {"columns", 2}, {"rows", 2}, {"kind", "hemispherical"}}}});
  expect_failure(builder, UPS_ERROR_UNSUPPORTED, {"node 0 \"desk\"", "recorded core"});
}

TEST_F(BrokenFile, AreasThatTheCoreRefuses) {
  const auto area = [this](const json& polygon, const json& holes) {
    return with_extras({{"meters", {{"en12464", {{"polygon_m", polygon}, {"holes_m", holes}}}}}});
  };
  const json room = {{0, 0}, {4, 0}, {4, 4}, {0, 4}}, none = json::array();
  SceneBuilder crossing = area({{0, 0}, {4, 4}, {4, 0}, {0, 4}}, none);
  expect_failure(crossing, UPS_ERROR_INVALID_ARGUMENT, {"node 0 \"desk\"", "meters.en12464", "cross"});
  SceneBuilder outside = area(room, json::array({json{{5, 5}, {6, 5}, {6, 6}}}));
  expect_failure(outside, UPS_ERROR_INVALID_ARGUMENT, {"node 0 \"desk\"", "hole 0", "outside"});
  SceneBuilder narrow = area({{0, 0}, {4, 0}, {4, 0.9}, {0, 0.9}}, none);
  expect_failure(narrow, UPS_ERROR_INVALID_ARGUMENT, {"node 0 \"desk\"", "border of 0.5 m"});
  SceneBuilder unmapped = with_extras({{"meters", {{"lightmap", {{"width", 4}}}}}});
  unmapped.doc["nodes"][0]["mesh"] = 0;
  unmapped.add_square();
  expect_failure(unmapped, UPS_ERROR_PARSE, {"node 0 \"desk\"", "lightmap", "TEXCOORD"});
}

TEST_F(BrokenFile, NamesThatNoFileCanBear) {
  const json one_point = {{"points_m", {{0, 0, 1}}}};
  const std::string fits(200, 'n'), too_long(201, 'n');
  SceneBuilder builder;
  builder.add_node({{"name", fits}, {"extras", {{"ups", {{"meters", one_point}}}}}});
  import(builder);
  builder.doc["nodes"][0]["name"] = too_long;
  expect_failure(builder, UPS_ERROR_PARSE, {"node 0", "201 bytes", "200"});

  json named = one_point;
  named["name"] = too_long;
  SceneBuilder meters = with_extras({{"meters", named}});
  expect_failure(meters, UPS_ERROR_PARSE, {"node 0 \"desk\"", "201 bytes", "200"});

  SceneBuilder camera;
  camera.doc["cameras"] = json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 1}}}}});
  camera.add_node({{"name", too_long}, {"camera", 0}});
  expect_failure(camera, UPS_ERROR_PARSE, {"node 0", "201 bytes", "200"});

  // The number that makes a name unique counts too.
  SceneBuilder twice;
  for (int i = 0; i < 2; ++i) twice.add_node({{"name", fits}, {"extras", {{"ups", {{"meters", one_point}}}}}});
  expect_failure(twice, UPS_ERROR_PARSE, {"node 1", "202 bytes", "200"});
}

TEST_F(BrokenFile, MissingOrRefusedPhotometricFile) {
  SceneBuilder builder = with_extras({{"luminaire", {{"file", "lamp.ies"}}}});
  expect_failure(builder, UPS_ERROR_IO, {"node 0 \"desk\"", "lamp.ies"});
  write("lamp.ies", refused_profile);
  expect_failure(builder, UPS_ERROR_UNSUPPORTED, {"node 0 \"desk\"", "lamp.ies", "recorded core: no such format"});

  SceneBuilder extension;
  extension.add_node({{"extensions", {{"EXT_lights_ies", {{"light", 0}}}}}});
  expect_failure(extension, UPS_ERROR_PARSE, {"node 0", "light"});
  extension.doc["extensions"]["EXT_lights_ies"]["lights"] = json::array({{{"uri", "none.ies"}}});
  expect_failure(extension, UPS_ERROR_IO, {"node 0", "none.ies"});
  extension.doc["extensions"]["EXT_lights_ies"]["lights"] = json::array({{{"bufferView", 0}}});
  expect_failure(extension, UPS_ERROR_PARSE, {"node 0", "buffer view 0"});
}

TEST_F(BrokenFile, SkyIsNotBuilt) {
  SceneBuilder builder = square();
  builder.doc["scenes"][0]["extras"]["ups"]["sky"] = {{"cie_type", 5}};
  expect_failure(builder, UPS_ERROR_UNSUPPORTED, {"scene 0", "sky", "not built"});
  builder.doc["scenes"][0]["extras"]["ups"] = {{"sun", 1}};
  expect_failure(builder, UPS_ERROR_PARSE, {"scene 0", "sun", "sky"});
}

TEST_F(BrokenFile, MaintenanceFactorIsAShare) {
  SceneBuilder builder = square();
  for (const json& wrong : {json(1.2), json(-0.1), json("0.8")}) {
    builder.doc["scenes"][0]["extras"]["ups"]["maintenance_factor"] = wrong;
    expect_failure(builder, UPS_ERROR_PARSE, {"scene 0", "maintenance_factor"});
  }
  builder.doc["scenes"][0]["extras"]["ups"]["maintenance_factor"] = 0;
  expect_failure(builder, UPS_ERROR_INVALID_ARGUMENT, {"scene 0", "maintenance_factor"});
}

// Whatever bytes are there, the importer ends with a status. Sanitizers turn a stray read into a failure.
TEST_F(BrokenFile, RandomBytesChanged) {
  SceneBuilder builder = with_material({{"name", "m"}, {"extras", {{"ups", {{"model", "matte"}}}}}});
  builder.add_node({{"extras", {{"ups", {{"meters", {{"points_m", {{0, 0, 1}}}}}}}}}});
  const std::string whole = builder.glb();
  std::mt19937 random(1);
  int failures = 0;
  for (int i = 0; i < 2000; ++i) {
    std::string changed = whole;
    for (int k = 0; k < 1 + i % 3; ++k) changed[random() % changed.size()] = char(random());
    if (import_text(changed, "scene.glb") != UPS_OK) {
      ++failures;
      ASSERT_FALSE(error.empty());
    }
  }
  EXPECT_GT(failures, 1000);  // most bytes matter
}

}  // namespace
