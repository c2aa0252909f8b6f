// Meters, goniometers and cameras of files that are right: where they stand, turned to +Z up, their sizes, and what
// they are called.
#include "good_file.h"

namespace {

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

TEST_F(GoodFile, ObserversLookLikeCameras) {
  SceneBuilder builder;
  // Without rotation: glTF's -Z is north.
  builder.add_node({{"name", "node"},
                    {"translation", {1, 1.2, -2}},
                    {"extras", {{"ups", {{"observer", {{"name", "desk 1"}, {"metric", "ugr"}}}}}}}});
  builder.add_node({{"name", "door"}, {"extras", {{"ups", {{"observer", {{"position_index", "guth"}}}}}}}});
  builder.add_node({{"extras", {{"ups", {{"observer", {{"name", "desk 1"}}}}}}}});
  import(builder);
  EXPECT_EQ(sensor_info(0).kind, UPS_GLTF_OBSERVER);
  EXPECT_EQ(name_of(0), "desk 1");
  EXPECT_EQ(name_of(1), "door");
  EXPECT_EQ(name_of(2), "desk 1_2");
  ASSERT_EQ(scene.observers.size(), 3u);
  expect_near(point(scene.observers[0].to_world, 0, 0, 0), {1, 2, 1.2});
  expect_near(point(scene.observers[0].to_world, 0, 0, -1), {1, 3, 1.2});
  expect_near(point(scene.observers[0].to_world, 0, 1, 0), {1, 2, 2.2});
  EXPECT_EQ(scene.observers[0].position_index, UPS_POSITION_INDEX_TABLE);
  EXPECT_EQ(scene.observers[1].position_index, UPS_POSITION_INDEX_GUTH);
  double eye[3];
  float looks[3];
  EXPECT_EQ(ups_gltf_read_meters(imported, 0, eye, looks, 1), UPS_OK) << ups_gltf_last_error();
  EXPECT_NEAR(eye[1], 2, 1e-6);
  EXPECT_NEAR(looks[1], 1, 1e-6);
  EXPECT_EQ(ups_gltf_read_meters(imported, 0, eye, looks, 0), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(warnings(), "");
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

TEST_F(GoodFile, FootprintsAreDiscs) {
  SceneBuilder builder;
  json extras = grid("plane");
  extras["ups"]["meters"]["footprint_m"] = 0.01;
  builder.add_node({{"extras", extras}});
  builder.add_node({{"extras", {{"ups", {{"meters", {{"points_m", {{0, 0, 0}}}, {"footprint_m", 0.5}}}}}}}});
  import(builder);
  EXPECT_FLOAT_EQ(scene.meters[0].footprint_m, 0.01f);
  EXPECT_FLOAT_EQ(scene.meters[1].footprint_m, 0.5f);
  EXPECT_EQ(sensor_info(0).layout, UPS_GLTF_LAYOUT_GRID);
  EXPECT_FLOAT_EQ(sensor_info(0).cell_size_m[0], 2);
  EXPECT_FLOAT_EQ(sensor_info(0).cell_side[0], 1);
  EXPECT_EQ(sensor_info(1).layout, UPS_GLTF_LAYOUT_POINTS);
  EXPECT_EQ(sensor_info(1).cell_size_m[0], 0);
}

// 4 m x 3 m less the border: p = 0.43 m, 7 x 5 cells of 3/7 m x 0.4 m. With the column some are left out.
TEST_F(GoodFile, GridsOfTheStandard) {
  SceneBuilder builder;
  json area = {{"polygon_m", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}}};
  const auto add = [&](const json& words) {
    builder.add_node({{"name", "task"},
                      {"translation", {1, 0.75, 0}},
                      {"rotation", upward},
                      {"extras", {{"ups", {{"meters", words}}}}}});
  };
  add({{"en12464", area}});
  area["holes_m"] = json::array({json{{1.9, 1.4}, {2.1, 1.4}, {2.1, 1.6}, {1.9, 1.6}}});
  add({{"en12464", area}, {"area", true}, {"name", "around"}});
  area = {{"polygon_m", {{0, 0}, {4, 0}, {4, 3}, {0, 3}}}, {"border_m", 0}};
  add({{"en12464", area}, {"footprint_m", 0.02}});
  import(builder);
  EXPECT_EQ(sensor_info(0).layout, UPS_GLTF_LAYOUT_EN12464);
  EXPECT_EQ(sensor_info(0).columns, 7u);
  EXPECT_EQ(sensor_info(0).rows, 5u);
  EXPECT_EQ(sensor_info(0).meter_count, 35u);
  EXPECT_FLOAT_EQ(sensor_info(0).cell_size_m[0], 3 / 7.0f);
  const auto at = meter_positions(0);
  EXPECT_NEAR(at[0], 1 + 0.5 + 1.5 / 7, 1e-6);
  EXPECT_NEAR(at[1], 0.5 + 0.2, 1e-6);
  EXPECT_NEAR(at[2], 0.75, 1e-6);
  EXPECT_NEAR(meter_normals(0)[2], 1, 1e-6);
  EXPECT_TRUE(scene.meters[0].tangents.empty());
  EXPECT_EQ(sensor_info(1).columns, 0u) << "not all cells are there";
  EXPECT_LT(sensor_info(1).meter_count, 35u);
  EXPECT_GT(sensor_info(1).meter_count, 20u);
  EXPECT_FLOAT_EQ(scene.meters[1].cell_size_m[0], 3 / 7.0f);
  EXPECT_EQ(scene.meters[1].tangents.size(), 3 * sensor_info(1).meter_count);
  EXPECT_EQ(sensor_info(2).columns, 8u);  // p = 0.527 m
  EXPECT_EQ(sensor_info(2).rows, 6u);
}

TEST_F(GoodFile, Lines) {
  SceneBuilder builder;
  const json line = {{"from_m", {0, 0, 0}}, {"to_m", {4, 0, 2}}, {"count", 3}};
  json turned = line;
  turned["normal"] = {0, 2, 0};
  builder.add_node({{"extras", {{"ups", {{"meters", {{"line", line}}}}}}}});
  builder.add_node({{"extras", {{"ups", {{"meters", {{"line", turned}}}}}}}});
  import(builder);
  expect_near(meter_positions(0), {0, 0, 0, 2, -1, 0, 4, -2, 0});
  expect_near(meter_normals(0), {0, -1, 0, 0, -1, 0, 0, -1, 0});
  expect_near(meter_normals(1), {0, 0, 1, 0, 0, 1, 0, 0, 1});
  EXPECT_EQ(sensor_info(0).layout, UPS_GLTF_LAYOUT_LINE);
}

// A mesh of two primitives: one set, through both instances; the node's scale is the mesh's.
TEST_F(GoodFile, SurfacesAndLightmapsOfTheNodesMesh) {
  SceneBuilder builder;
  const json one = {{"attributes", {{"POSITION", builder.add_floats({0, 0, 0, 1, 0, 0, 0, 1, 0}, "VEC3", 3)},
                                    {"TEXCOORD_0", builder.add_floats({0, 0, 1, 0, 0, 1}, "VEC2", 2)}}}};
  builder.doc["meshes"] = json::array({json{{"primitives", json::array({one, one})}}});
  const auto add = [&](const json& words) {
    builder.add_node({{"name", "wall"}, {"mesh", 0}, {"scale", {2, 2, 2}}, {"extras", {{"ups", {{"meters", words}}}}}});
  };
  add({{"surface", true}});
  add({{"lightmap", {{"width", 32}, {"height", 16}}}, {"back", true}, {"name", "map"}});
  import(builder);
  ASSERT_EQ(scene.surface_meters.size(), 2u);
  EXPECT_EQ(scene.surface_meters[0].instances, (std::vector<uint32_t>{1, 2}));
  EXPECT_EQ(scene.surface_meters[0].width, 0u);
  EXPECT_FALSE(scene.surface_meters[0].back);
  EXPECT_EQ(sensor_info(0).layout, UPS_GLTF_LAYOUT_SURFACE);
  EXPECT_EQ(sensor_info(0).kind, UPS_GLTF_METERS);
  EXPECT_EQ(sensor_info(0).meter_count, 2u);
  EXPECT_EQ(scene.surface_meters[1].instances, (std::vector<uint32_t>{3, 4}));
  EXPECT_TRUE(scene.surface_meters[1].back);
  EXPECT_EQ(sensor_info(1).layout, UPS_GLTF_LAYOUT_LIGHTMAP);
  EXPECT_EQ(sensor_info(1).width, 32u);
  EXPECT_EQ(sensor_info(1).height, 16u);
  EXPECT_EQ(sensor_info(1).meter_count, 512u);
  double positions[6];
  EXPECT_EQ(ups_gltf_read_meters(imported, 0, positions, nullptr, 2), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(ups_gltf_last_error()).find("ups_scene_read_meter_places"), std::string::npos);
  EXPECT_FALSE(warned("scale")) << warnings();
}

TEST_F(GoodFile, MetersBearTheirKind) {
  const std::pair<const char*, ups_meter_kind> kinds[] = {{"planar", UPS_METER_PLANAR},
                                                          {"cylindrical", UPS_METER_CYLINDRICAL},
                                                          {"semicylindrical", UPS_METER_SEMICYLINDRICAL},
                                                          {"spherical", UPS_METER_SPHERICAL},
                                                          {"vector", UPS_METER_VECTOR}};
  SceneBuilder builder;
  for (const auto& [word, kind] : kinds)
    builder.add_node({{"extras", {{"ups", {{"meters", {{"points_m", {{0, 0, 0}}}, {"kind", word}}}}}}}});
  import(builder);
  for (uint32_t i = 0; i < std::size(kinds); ++i) {
    EXPECT_EQ(scene.meters[i].kind, kinds[i].second);
    EXPECT_EQ(sensor_info(i).meter_kind, kinds[i].second);
  }
}

TEST_F(GoodFile, ScaleDoesNotMoveMetersApart) {
  SceneBuilder builder;
  builder.add_node({{"scale", {3, 3, 3}}, {"children", {1}}});
  builder.doc["nodes"].push_back({{"translation", {1, 0, 0}}, {"name", "desk"}, {"extras", grid(nullptr)}});
  import(builder);
  expect_near(meter_positions(0), {2, 0, -0.5, 4, 0, -0.5, 2, 0, 0.5, 4, 0, 0.5});
  EXPECT_TRUE(warned("node 1 \"desk\": its scale is ignored")) << warnings();
}

// In a room that is mirrored they look where their mirror images do, and see what is there: told, as it is of fixtures.
TEST_F(GoodFile, EyesAreNotMirrored) {
  SceneBuilder builder;
  builder.doc["cameras"] = json::array({{{"type", "perspective"}, {"perspective", {{"yfov", 1}, {"znear", 0.1}}}}});
  builder.add_node({{"scale", {1, 1, -1}}, {"children", {1, 2}}});
  builder.doc["nodes"].push_back({{"name", "view"}, {"camera", 0}});
  builder.doc["nodes"].push_back({{"name", "desk"}, {"extras", {{"ups", {{"observer", json::object()}}}}}});
  builder.add_node({{"name", "plain"}, {"camera", 0}});
  import(builder);
  EXPECT_TRUE(warned("node 1 \"view\": a node above it mirrors, which a camera cannot be")) << warnings();
  EXPECT_TRUE(warned("node 2 \"desk\": a node above it mirrors, which an observer cannot be")) << warnings();
  EXPECT_FALSE(warned("node 3")) << warnings();
  ASSERT_EQ(scene.cameras.size(), 2u);
  ASSERT_EQ(scene.observers.size(), 1u);
  const auto expect_south = [](const double (&to_world)[12]) {
    expect_near(point(to_world, 0, 0, -1), {0, -1, 0});
    expect_near(point(to_world, 0, 1, 0), {0, 0, 1});
    expect_near(point(to_world, 1, 0, 0), {-1, 0, 0});  // west is right of who looks south
  };
  expect_south(scene.cameras[0].to_world);
  expect_south(scene.observers[0].to_world);
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

// One side left out: a fisheye's image is a square, a panorama's twice as wide as high, whatever the camera's aspect is.
TEST_F(GoodFile, ProjectionsAndLayers) {
  SceneBuilder builder;
  builder.doc["cameras"] = json::array(
      {{{"type", "perspective"}, {"perspective", {{"yfov", 0.8}, {"znear", 0.1}, {"aspectRatio", 1.6}}}}});
  const auto add = [&](const json& ups) { builder.add_node({{"camera", 0}, {"extras", {{"ups", ups}}}}); };
  add({{"projection", "perspective"}, {"height", 100}});
  add({{"projection", "equidistant"}, {"height", 100}, {"layers", {"depth", "albedo"}}});
  add({{"projection", "equisolid"}, {"width", 300}, {"height", 200}, {"layers", json::array()}});
  add({{"projection", "panorama"}, {"height", 100}, {"layers", {"albedo", "normal", "depth", "id"}}});
  import(builder);
  ASSERT_EQ(scene.cameras.size(), 4u);
  const uint32_t widths[] = {160, 100, 300, 200}, layers[] = {0, UPS_LAYER_DEPTH | UPS_LAYER_ALBEDO, 0, 15};
  for (uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(scene.cameras[i].projection, int32_t(i));  // UPS_PERSPECTIVE to UPS_PANORAMA
    EXPECT_EQ(scene.cameras[i].width, widths[i]);
    EXPECT_EQ(scene.cameras[i].layers, layers[i]);
    EXPECT_EQ(sensor_info(i).projection, int32_t(i));
    EXPECT_EQ(sensor_info(i).layers, layers[i]);
  }
  ups_gltf_import_desc options;
  ups_gltf_import_desc_init(&options, sizeof options);
  options.camera_layers = UPS_LAYER_NORMAL;
  desc = &options;
  import(builder);
  EXPECT_EQ(scene.cameras[1].layers, uint32_t(UPS_LAYER_DEPTH | UPS_LAYER_ALBEDO | UPS_LAYER_NORMAL));
  EXPECT_EQ(sensor_info(1).layers, uint32_t(UPS_LAYER_DEPTH | UPS_LAYER_ALBEDO));  // as the file says
}

}  // namespace
