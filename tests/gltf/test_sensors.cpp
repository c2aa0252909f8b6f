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

}  // namespace
