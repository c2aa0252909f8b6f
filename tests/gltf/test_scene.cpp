// Files that are right: where things end up, turned to +Z up, and what they are called.
#include <cmath>

#include "scene_builder.h"

namespace {

const json upward = {-0.7071068, 0, 0, 0.7071068};  // local +Z to glTF's +Y

class GoodFile : public ImportTest {
 protected:
  std::vector<double> meter_positions(uint32_t sensor) {
    std::vector<double> positions(3 * sensor_info(sensor).meter_count);
    EXPECT_EQ(ups_gltf_read_meters(imported, sensor, positions.data(), nullptr, positions.size() / 3), UPS_OK);
    return positions;
  }
  std::vector<float> meter_normals(uint32_t sensor) {
    std::vector<float> normals(3 * sensor_info(sensor).meter_count);
    EXPECT_EQ(ups_gltf_read_meters(imported, sensor, nullptr, normals.data(), normals.size() / 3), UPS_OK);
    return normals;
  }
  template <class T>
  static void expect_near(const std::vector<T>& found, const std::vector<double>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    for (size_t i = 0; i < found.size(); ++i) EXPECT_NEAR(found[i], expected[i], 1e-6) << i;
  }
  static json grid(const char* name) {
    json meters = {{"width_m", 4}, {"height_m", 2}, {"columns", 2}, {"rows", 2}};
    if (name) meters["name"] = name;
    return {{"ups", {{"meters", meters}}}};
  }
  static std::vector<double> point(const double (&m)[12], double x, double y, double z) {
    std::vector<double> result;
    for (int i = 0; i < 3; ++i) result.push_back(m[4 * i] * x + m[4 * i + 1] * y + m[4 * i + 2] * z + m[4 * i + 3]);
    return result;
  }
};

TEST_F(GoodFile, WorkPlaneFacesUp) {
  SceneBuilder builder;
  // glTF (10, 0.8, 5): 0.8 m high, 5 m to the south.
  builder.add_node({{"translation", {10, 0.8, 5}}, {"rotation", upward}, {"extras", grid("work plane")}});
  import(builder);
  const auto info = sensor_info(0);
  EXPECT_EQ(info.kind, UPS_GLTF_METERS);
  EXPECT_EQ(info.columns, 2u);
  EXPECT_EQ(info.rows, 2u);
  // Column 0 at local -X is west; row 0 at local -Y is glTF +Z, south. Columns run fastest.
  expect_near(meter_positions(0), {9, -5.5, 0.8, 11, -5.5, 0.8, 9, -4.5, 0.8, 11, -4.5, 0.8});
  expect_near(meter_normals(0), {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1});
  expect_near(scene.meters[0].positions, meter_positions(0));
  EXPECT_TRUE(scene.meters[0].tangents.empty());
  EXPECT_EQ(scene.meters[0].cell_size_m[0], 0);
}

TEST_F(GoodFile, GoniometersHangLikeLuminaires) {
  SceneBuilder builder;
  builder.add_node({{"name", "lamp"},
                    {"rotation", upward},
                    {"extras", {{"ups", {{"goniometer", {{"c_step_deg", 90}, {"gamma_deg", {0, 1, 90}}}}}}}}});
  builder.add_node({{"extras", {{"ups", {{"goniometer", {{"symmetry", "axial"}}}}}}}});
  import(builder);
  EXPECT_EQ(sensor_info(0).kind, UPS_GLTF_GONIOMETER);
  EXPECT_EQ(sensor_info(0).columns, 4u);
  EXPECT_EQ(sensor_info(0).rows, 3u);
  EXPECT_EQ(scene.goniometers[0].c_deg, (std::vector<float>{0, 90, 180, 270}));
  EXPECT_EQ(scene.goniometers[0].gamma_deg, (std::vector<float>{0, 1, 90}));
  // local -Z, the nadir, is down
  expect_near(point(scene.goniometers[0].desc.to_world, 0, 0, -1), {0, 0, -1});
  EXPECT_EQ(scene.goniometers[1].c_deg.size(), 1u);
  EXPECT_EQ(scene.goniometers[1].gamma_deg.size(), 73u);
  EXPECT_EQ(scene.goniometers[1].gamma_deg.back(), 180);
}

TEST_F(GoodFile, GroupIsOfAllThatTheNodeEmits) {
  SceneBuilder builder;
  builder.doc["extensions"]["KHR_lights_punctual"]["lights"] = json::array({{{"type", "point"}}});
  builder.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"extras", {{"ups", {{"group", 5}}}}}});
  builder.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  import(builder);
  EXPECT_EQ(scene.lights[0].group, 5u);
  EXPECT_EQ(scene.lights[1].group, 0u);
}

TEST_F(GoodFile, MetersWithoutRotationFaceSouth) {
  SceneBuilder builder;
  builder.add_node({{"extras", grid(nullptr)}});
  import(builder);
  expect_near(meter_normals(0), {0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1, 0});
  expect_near(meter_positions(0), {-1, 0, -0.5, 1, 0, -0.5, -1, 0, 0.5, 1, 0, 0.5});
  EXPECT_EQ(warnings(), "");
}

TEST_F(GoodFile, AreaMetersHaveCells) {
  SceneBuilder builder;
  json extras = grid("floor");
  extras["ups"]["meters"]["area"] = true;
  builder.add_node({{"rotation", upward}, {"extras", extras}});
  import(builder);
  expect_near(scene.meters[0].tangents, {1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0});
  EXPECT_FLOAT_EQ(scene.meters[0].cell_size_m[0], 2);
  EXPECT_FLOAT_EQ(scene.meters[0].cell_size_m[1], 1);
}

TEST_F(GoodFile, FreePoints) {
  SceneBuilder builder;
  const json meters = {{"points_m", {{1, 2, 3}, {0, 0, 0}}}, {"normals", {{0, 5, 0}, {0, 0, -2}}}};
  builder.add_node({{"translation", {0, 1, 0}}, {"extras", {{"ups", {{"meters", meters}}}}}});
  import(builder);
  expect_near(meter_positions(0), {1, -3, 3, 0, 0, 1});
  expect_near(meter_normals(0), {0, 0, 1, 0, 1, 0});
  EXPECT_EQ(sensor_info(0).columns, 0u);
  EXPECT_EQ(sensor_info(0).meter_count, 2u);
}

TEST_F(GoodFile, ScaleDoesNotMoveMetersApart) {
  SceneBuilder builder;
  builder.add_node({{"scale", {3, 3, 3}}, {"children", {1}}});
  builder.doc["nodes"].push_back({{"translation", {1, 0, 0}}, {"name", "desk"}, {"extras", grid(nullptr)}});
  import(builder);
  expect_near(meter_positions(0), {2, 0, -0.5, 4, 0, -0.5, 2, 0, 0.5, 4, 0, 0.5});
  EXPECT_TRUE(warned("node 1 \"desk\": its scale is ignored")) << warnings();
}

TEST_F(GoodFile, Names) {
  SceneBuilder builder;
  builder.doc["cameras"] = json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}});
  builder.add_node({{"extras", grid("Büro 1/2")}, {"name", "ignored"}});
  builder.add_node({{"extras", grid(nullptr)}, {"name", "desk"}});
  builder.add_node({{"extras", grid(nullptr)}});
  builder.add_node({{"extras", grid("desk")}});
  builder.add_node({{"camera", 0}, {"name", "desk"}});
  builder.add_node({{"camera", 0}});
  builder.add_node({{"extras", grid(nullptr)}});
  builder.add_node({{"camera", 0}, {"name", "view"}, {"extras", {{"ups", {{"illuminance_camera", true}}}}}});
  builder.add_node({{"extras", grid("view_illuminance")}});
  import(builder);
  uint32_t count = 0;
  ASSERT_EQ(ups_gltf_get_sensor_count(imported, &count), UPS_OK);
  ASSERT_EQ(count, 9u);
  const char* expected[] = {"B_ro_1_2",          "desk", "meters", "desk_2", "desk_3", "camera", "meters_2", "view",
                            "view_illuminance_2"};
  for (uint32_t i = 0; i < count; ++i) EXPECT_EQ(name_of(i), expected[i]);
  char small[3];
  size_t needed = 0;
  EXPECT_EQ(ups_gltf_get_sensor_name(imported, 0, small, sizeof small, &needed), UPS_ERROR_BUFFER_TOO_SMALL);
  EXPECT_EQ(needed, 9u);
  EXPECT_EQ(ups_gltf_get_sensor_name(imported, 9, small, sizeof small, &needed), UPS_ERROR_INVALID_ARGUMENT);
}

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

TEST_F(GoodFile, CameraSizes) {
  SceneBuilder builder;
  builder.doc["cameras"] = json::array(
      {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}, {"aspectRatio", 1.6}}}},
       {{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}}}},
       {{"type", "orthographic"}, {"orthographic", {{"xmag", 1}, {"ymag", 1}, {"znear", 0.1}, {"zfar", 9}}}}});
  builder.add_node({{"camera", 0}, {"translation", {0, 1.6, 4}}});
  builder.add_node({{"camera", 1}});
  builder.add_node(
      {{"camera", 0}, {"extras", {{"ups", {{"width", 640}, {"height", 480}, {"illuminance_camera", true}}}}}});
  builder.add_node({{"camera", 0}, {"extras", {{"ups", {{"height", 100}}}}}});
  builder.add_node({{"camera", 2}});
  import(builder);
  ASSERT_EQ(scene.cameras.size(), 4u);
  const uint32_t sizes[][2] = {{512, 320}, {512, 512}, {640, 480}, {160, 100}};
  for (uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(scene.cameras[i].width, sizes[i][0]);
    EXPECT_EQ(scene.cameras[i].height, sizes[i][1]);
    EXPECT_EQ(sensor_info(i).width, sizes[i][0]);
    EXPECT_EQ(sensor_info(i).illuminance, i == 2);
  }
  EXPECT_FLOAT_EQ(scene.cameras[0].vertical_fov_rad, 0.8f);
  expect_near(point(scene.cameras[0].to_world, 0, 0, -1), {0, -3, 1.6});  // it looks north
  expect_near(point(scene.cameras[0].to_world, 0, 1, 0), {0, -4, 2.6});   // up in the image is up
  EXPECT_TRUE(warned("only perspective cameras")) << warnings();
  EXPECT_EQ(name_of(3), "camera_4");

  ups_gltf_import_desc options;
  ups_gltf_import_desc_init(&options, sizeof options);
  options.camera_width = 20;
  options.camera_height = 10;
  desc = &options;
  import(builder);
  for (const auto& camera : scene.cameras) {
    EXPECT_EQ(camera.width, 20u);
    EXPECT_EQ(camera.height, 10u);
  }
}

TEST_F(GoodFile, PunctualLights) {
  SceneBuilder builder;
  builder.doc["extensions"]["KHR_lights_punctual"]["lights"] =
      json::array({{{"type", "point"}, {"intensity", 100}, {"color", {1, 0.5, 0}}},
                   {{"type", "spot"}, {"intensity", 50}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}},
                   {{"type", "directional"}, {"intensity", 80000}}});
  for (int i = 0; i < 3; ++i) {
    builder.add_node({{"translation", {0, 3, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  }
  import(builder);
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].kind, UPS_LIGHT_POINT);
  EXPECT_FLOAT_EQ(scene.lights[0].intensity_rgb[0], 100);
  EXPECT_FLOAT_EQ(scene.lights[0].intensity_rgb[1], 50);
  EXPECT_FLOAT_EQ(scene.lights[0].intensity_rgb[2], 0);
  EXPECT_EQ(scene.lights[1].kind, UPS_LIGHT_SPOT);
  EXPECT_FLOAT_EQ(scene.lights[1].inner_cone_rad, 0.2f);
  EXPECT_FLOAT_EQ(scene.lights[1].outer_cone_rad, 0.4f);
  EXPECT_EQ(scene.lights[2].kind, UPS_LIGHT_DIRECTIONAL);
  EXPECT_FLOAT_EQ(scene.lights[2].intensity_rgb[2], 80000);
  expect_near(point(scene.lights[0].to_world, 0, 0, -1), {0, 1, 3});  // local -Z without rotation is north
}

TEST_F(GoodFile, LuminairesTakeTheTiltFileBesideThem) {
  SceneBuilder builder;
  write("lamp.ies", "TILT=C:\\data\\HID.tlt");
  write("hid.TLT", "table");
  write("other.ies", "TILT=none.tlt");
  for (const json& luminaire : {json{{"file", "lamp.ies"}}, json{{"file", "lamp.ies"}, {"tilt_deg", 30}, {"lamp_set", 2}},
                                json{{"file", "other.ies"}}})
    builder.add_node({{"extras", {{"ups", {{"luminaire", luminaire}}}}}});
  builder.add_node({{"extensions", {{"EXT_lights_ies", {{"light", 0}}}}}});
  builder.doc["extensions"]["EXT_lights_ies"]["lights"] = json::array({{{"uri", "lamp.ies"}}});
  import(builder);
  ASSERT_EQ(scene.luminaires.size(), 4u);
  EXPECT_EQ(scene.luminaires[0].profile_bytes, "TILT=C:\\data\\HID.tlt+table");
  EXPECT_EQ(scene.luminaires[1].profile_bytes, "TILT=C:\\data\\HID.tlt+table@30#2");
  EXPECT_EQ(scene.luminaires[2].profile_bytes, "TILT=none.tlt");
  EXPECT_EQ(scene.luminaires[3].profile_bytes, scene.luminaires[0].profile_bytes);
}

TEST_F(GoodFile, TheTiltFileIsFoundBesideASceneNamedWithoutItsFolder) {
  SceneBuilder builder;
  write("lamp.ies", "TILT=HID.tlt");
  write("hid.tlt", "table");
  builder.add_node({{"extras", {{"ups", {{"luminaire", {{"file", "lamp.ies"}}}}}}}});
  const std::string text = builder.gltf();
  write("scene.bin", builder.bytes);
  const std::filesystem::path given = folder, before = std::filesystem::current_path();
  std::filesystem::current_path(given);
  folder.clear();
  EXPECT_EQ(import_text(text), UPS_OK) << error;
  std::filesystem::current_path(before);
  folder = given;
  ASSERT_EQ(scene.luminaires.size(), 1u);
  EXPECT_EQ(scene.luminaires[0].profile_bytes, "TILT=HID.tlt+table");
}

TEST_F(GoodFile, Luminaires) {
  SceneBuilder builder;
  write("spot light.ies", "profile");
  const json all = {{"file", "spot light.ies"},
                    {"flux_lm", 900},
                    {"colour_temperature_k", 2856},
                    {"opening", false},
                    {"dimming", 0.5}};
  builder.add_node({{"translation", {0, 3, 0}}, {"rotation", upward}, {"extras", {{"ups", {{"luminaire", all}}}}}});
  builder.add_node({{"extras", {{"ups", {{"luminaire", {{"file", "spot light.ies"}}}}}}}});
  const json red = {{"file", "spot light.ies"}, {"color", {0.75, 0.25, 0}}};
  builder.add_node({{"extras", {{"ups", {{"luminaire", red}}}}}});
  import(builder);
  ASSERT_EQ(scene.luminaires.size(), 3u);
  EXPECT_EQ(scene.luminaires[2].desc.color_rgb[0], 0.75f);
  EXPECT_EQ(scene.luminaires[2].desc.color_rgb[1], 0.25f);
  EXPECT_EQ(scene.luminaires[2].desc.color_rgb[2], 0);
  EXPECT_FLOAT_EQ(scene.luminaires[2].desc.intensity_scale, 1);
  const ups_luminaire_desc& first = scene.luminaires[0].desc;
  EXPECT_EQ(scene.luminaires[0].profile_bytes, "profile");
  EXPECT_FLOAT_EQ(first.flux_lm, 900);
  EXPECT_FLOAT_EQ(first.dimming, 0.5f);
  EXPECT_FLOAT_EQ(first.intensity_scale, 1);
  EXPECT_EQ(first.use_opening, 0);
  expect_near(point(first.to_world, 0, 0, -1), {0, 0, 2});  // nadir is down
  expect_near(point(first.to_world, 1, 0, 0), {1, 0, 3});   // C0 is east
  expect_near(point(first.to_world, 0, 1, 0), {0, 1, 3});   // C90 is north
  const ups_luminaire_desc& second = scene.luminaires[1].desc;
  EXPECT_LT(second.flux_lm, 0);
  EXPECT_EQ(second.use_opening, 1);
  EXPECT_EQ(second.color_rgb[2], 1);
  EXPECT_TRUE(warned("spot light.ies: recorded warning")) << warnings();

  // CIE illuminant A is a Planckian radiator of 2856 K: x, y = 0.4476, 0.4074 (CIE 15).
  const float* c = first.color_rgb;
  const double X = 0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2];
  const double Y = 0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2];
  const double Z = 0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2];
  EXPECT_NEAR(Y, 1, 1e-3);
  EXPECT_NEAR(X / (X + Y + Z), 0.4476, 2e-3);
  EXPECT_NEAR(Y / (X + Y + Z), 0.4074, 2e-3);
}

TEST_F(GoodFile, IesExtension) {
  SceneBuilder builder;
  write("lamp.ies", "from file");
  const std::string text = "from view";
  const int view = builder.add_view(text.data(), text.size());
  builder.doc["extensionsRequired"] = {"EXT_lights_ies"};
  builder.doc["extensions"]["EXT_lights_ies"]["lights"] =
      json::array({{{"uri", "lamp.ies"}},
                   {{"bufferView", view}, {"mimeType", "application/x-ies-lm-63"}},
                   {{"uri", "data:application/x-ies-lm-63;base64,ZnJvbSB1cmk="}}});
  const auto node = [&](const json& use) { builder.add_node({{"extensions", {{"EXT_lights_ies", use}}}}); };
  node({{"light", 0}, {"multiplier", 2}, {"color", {1, 0.5, 0.25}}});
  node({{"light", 1}});
  node({{"light", 2}, {"color", {0, 0, 0}}});
  import(builder);
  ASSERT_EQ(scene.luminaires.size(), 3u);
  EXPECT_EQ(scene.luminaires[0].profile_bytes, "from file");
  EXPECT_EQ(scene.luminaires[1].profile_bytes, "from view");
  EXPECT_EQ(scene.luminaires[2].profile_bytes, "from uri");
  const ups_luminaire_desc& d = scene.luminaires[0].desc;
  const float y = 0.2126f * d.color_rgb[0] + 0.7152f * d.color_rgb[1] + 0.0722f * d.color_rgb[2];
  EXPECT_EQ(d.use_opening, 0);
  for (int i = 0; i < 3; ++i) {  // what the core makes of it: scale * color / luminance(color)
    EXPECT_NEAR(d.intensity_scale * d.color_rgb[i] / y, std::vector<double>({2, 1, 0.5})[size_t(i)], 1e-5);
  }
  EXPECT_EQ(scene.luminaires[2].desc.intensity_scale, 0);
}

TEST_F(GoodFile, WhatIsSkippedIsNamed) {
  SceneBuilder builder;
  builder.add_square();
  builder.doc["extensionsUsed"] = {"KHR_materials_variants", "KHR_materials_ior"};
  builder.doc["animations"] = json::array({{{"channels", json::array()}, {"samplers", json::array()}}});
  builder.doc["skins"] = json::array({{{"joints", {0}}}});
  builder.doc["meshes"][0]["extras"]["ups"] = {{"model", "matte"}};
  builder.doc["scenes"].push_back({{"nodes", json::array()}});
  builder.add_node({{"mesh", 0}, {"skin", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", true}}}}}});
  import(builder);
  for (const char* word : {"KHR_materials_variants", "animations", "skin", "KHR_node_visibility", "meshes[0]",
                           "scene 0", "without a material"}) {
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
