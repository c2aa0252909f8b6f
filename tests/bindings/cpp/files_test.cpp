// The extras of ups.hpp: glTF, OpenEXR, maps and the report.
#include <unistd.h>

#include <cstdio>
#include <fstream>
#include <iterator>

#include "room.h"
#include "ups/ups_exr.hpp"
#include "ups/ups_gltf.hpp"
#include "ups/ups_report.hpp"

namespace {

std::string in_temporary_folder(const char *name) {
  return testing::TempDir() + "ups_hpp_" + std::to_string(::getpid()) + "_" + name;
}

TEST(Exr, IsWrittenAndRead) {
  const std::string path = in_temporary_folder("image.exr");
  const std::vector<float> lux = {1, 2, 3, 4, 5, 6};
  const ups_exr_channel channels[] = {{"Y", lux.data(), 0, 0}};
  const ups_exr_attribute attributes[] = {{"unit.Y", "lx"}};
  ups::exr_write(path, 3, 2, channels, attributes);
  const ups::ExrImage image(path);
  std::remove(path.c_str());
  EXPECT_EQ(image.width(), 3u);
  EXPECT_EQ(image.height(), 2u);
  EXPECT_EQ(image.channel_names(), std::vector<std::string>{"Y"});
  EXPECT_EQ(image.get_attribute("unit.Y"), "lx");
  EXPECT_EQ(image.read_channel("Y"), lux);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"Z"}, [&] { image.read_channel("Z"); });
  expect_error(UPS_ERROR_IO, {path}, [&] { ups::ExrImage again(path); });
  const std::string cut = path + std::string("\0.png", 5);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"NUL"}, [&] { ups::exr_write(cut, 3, 2, channels, attributes); });
  EXPECT_FALSE(std::ifstream(path).good());
}

std::string read_text(const std::string &path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

TEST(Report, WritesMapAndPage) {
  Room room;
  ups::Scene &scene = room.scene;
  const ups_sensor_id meters = room.meters;
  scene.commit();
  const ups::Result result = scene.render(Room::few());
  const std::string map = in_temporary_folder("map.svg"), html = in_temporary_folder("page.html");
  ups::ReportStyleDesc style;
  style.threshold_lx = 1;
  ups::ReportMapDesc desk;
  desk.scene = scene.get();
  desk.result = result.get();
  desk.sensor = meters;
  desk.title = "desk";
  desk.style = &style;
  ups::report_write_map(map, desk);
  EXPECT_NE(read_text(map).find("Illuminance: desk"), std::string::npos);
  const ups_report_sensor sensors[] = {{meters, 0, "desk"}};
  ups::ReportPageDesc page;
  page.scene = scene.get();
  page.result = result.get();
  page.sensors = sensors;
  page.sensor_count = 1;
  page.title = "Study";
  ups::report_write_page(html, page);
  EXPECT_NE(read_text(html).find("<h1>Study</h1>"), std::string::npos);
  std::remove(map.c_str());
  std::remove(html.c_str());
  page.target_relative_error = -1;
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"target_relative_error"}, [&] { ups::report_write_page(html, page); });
  EXPECT_FALSE(std::ifstream(html).good());
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {".png, .svg or .pdf"}, [&] { ups::report_write_map("map.gif", desk); });
}

TEST(Gltf, FillsAScene) {
  const std::string path = in_temporary_folder("scene.gltf");
  std::ofstream(path) << R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
    "extensionsUsed": ["KHR_lights_punctual"],
    "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 100}]}},
    "cameras": [{"type": "perspective", "perspective": {"yfov": 0.8, "znear": 0.1}}],
    "nodes": [{"name": "lamp", "translation": [0, 2, 0], "extensions": {"KHR_lights_punctual": {"light": 0}}},
              {"name": "view", "camera": 0}]})";
  ups::Context context(two_threads());
  ups::Scene scene(context);
  ups::GltfImportDesc desc;
  desc.camera_width = desc.camera_height = 4;
  const ups::GltfImport import(context, path, scene, desc);
  const auto sensors = import.sensors();
  ASSERT_EQ(sensors.size(), 1u);
  EXPECT_EQ(sensors[0].width, 4u);
  EXPECT_EQ(import.get_sensor_name(0), "view");
  EXPECT_EQ(scene.get_camera(sensors[0].sensor).height, 4u);
  scene.commit();
  const auto sources = scene.sources();
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_EQ(import.get_source_name(sources[0].kind, sources[0].id), "lamp");
  EXPECT_NE(import.get_place(UPS_GLTF_PART_LUMINAIRE, sources[0].id).find("\"lamp\""), std::string::npos);
  EXPECT_EQ(import.get_source_file(sources[0].kind, sources[0].id), "");
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {}, [&] { import.read_meters(0); });
  std::remove(path.c_str());
  expect_error(UPS_ERROR_IO, {path}, [&] { ups::GltfImport again(context, path, scene); });
}

}  // namespace
