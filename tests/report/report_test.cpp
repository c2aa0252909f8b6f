// The C API of maps and the page, as a program uses it that builds its scene by calls: an L-shaped room, no glTF.
#include "ups/ups_report.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <cmath>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include "../support/german_locale.h"
#include "ups/ups.h"

namespace {

// A folder of this process, as ctest runs these tests beside each other; removed with all in it at the end.
struct Folder {
  const std::filesystem::path path =
      std::filesystem::path(testing::TempDir()) / ("ups-report-" + std::to_string(::getpid()));
  Folder() { std::filesystem::create_directories(path); }
  ~Folder() {
    std::error_code error;
    std::filesystem::remove_all(path, error);
  }
};

std::string path_of(const std::string& name) {
  static const Folder folder;
  return (folder.path / name).string();
}

std::string read(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

bool has(const std::string& text, const std::string& words) { return text.find(words) != std::string::npos; }

// By one iteration; the caller owns it.
ups_result* render_once(const ups_scene* scene) {
  ups_render_desc desc;
  ups_render_desc_init(&desc, sizeof desc);
  desc.iteration_count = 1;
  ups_result* result = nullptr;
  EXPECT_EQ(ups_render(scene, &desc, &result), UPS_OK) << ups_last_error();
  return result;
}

// 4 m x 5 m without the quarter beyond x = 2, y = 3; 2.6 m high; two downlights, EN 12464-1's points, a wall's grid,
// an observer, a camera with illuminance, surface meters and a goniometer.
class LRoom {
 public:
  static const LRoom& lit() {
    static const LRoom room;
    return room;
  }
  ups_context* context = nullptr;
  ups_scene* scene = nullptr;
  ups_result* result = nullptr;
  ups_sensor_id points{}, wall{}, eye{}, camera{}, surface{}, goniometer{};
  uint32_t lamps[2] = {};
  uint32_t point_count = 0;

 private:
  LRoom() {
    check(ups_context_create(nullptr, &context));
    check(ups_scene_create(context, &scene));
    add_walls();
    add_lamps();
    add_meters();
    add_others();
    check(ups_scene_commit(scene));
    ups_render_desc desc;
    ups_render_desc_init(&desc, sizeof desc);
    desc.iteration_count = 8, desc.light_paths_per_iteration = 4096;
    check(ups_render(scene, &desc, &result));
  }
  ~LRoom() {
    ups_result_destroy(result);
    ups_scene_destroy(scene);
    ups_context_destroy(context);
  }

  static void check(ups_status status) { ASSERT_EQ(status, UPS_OK) << ups_last_error(); }

  void add_walls() {
    const float at[6][2] = {{0, 0}, {4, 0}, {4, 3}, {2, 3}, {2, 5}, {0, 5}};
    std::vector<float> corners;
    for (const float z : {0.f, 2.6f})
      for (const auto& p : at) corners.insert(corners.end(), {p[0], p[1], z});
    std::vector<uint32_t> triangles = {0, 1, 2, 0, 2, 3, 0, 3, 5, 3, 4, 5, 6, 8, 7, 6, 9, 8, 6, 11, 9, 9, 11, 10};
    for (uint32_t i = 0; i < 6; ++i) {
      const uint32_t j = (i + 1) % 6;
      triangles.insert(triangles.end(), {i, i + 6, j, j, i + 6, j + 6});
    }
    ups_material_desc matte;
    ups_material_desc_init(&matte, sizeof matte);
    for (float& r : matte.reflectance_rgb) r = 0.6f;
    ups_mesh_desc mesh;
    ups_mesh_desc_init(&mesh, sizeof mesh);
    check(ups_scene_add_material(scene, &matte, &mesh.material));
    mesh.vertex_count = 12, mesh.triangle_count = uint32_t(triangles.size() / 3);
    mesh.positions_m = corners.data(), mesh.indices = triangles.data();
    ups_instance_desc instance;
    ups_instance_desc_init(&instance, sizeof instance);
    check(ups_scene_add_mesh(scene, &mesh, &instance.mesh));
    check(ups_scene_add_instance(scene, &instance, &room_));
  }

  void add_lamps() {
    const float c_deg[1] = {0}, gamma_deg[4] = {0, 30, 60, 90}, intensity_cd[4] = {1000, 800, 300, 0};
    ups_profile_desc desc;
    ups_profile_desc_init(&desc, sizeof desc);
    desc.c_count = 1, desc.gamma_count = 4, desc.c_deg = c_deg, desc.gamma_deg = gamma_deg;
    desc.intensity_cd = intensity_cd, desc.opening_shape = UPS_OPENING_DISC;
    desc.opening_m[0] = desc.opening_m[1] = 0.2f;
    ups_profile* profile = nullptr;
    check(ups_profile_create(context, &desc, &profile));
    const double at[2][2] = {{2.5, 1.5}, {1, 4}};
    for (int i = 0; i < 2; ++i) {
      ups_luminaire_desc lamp;
      ups_luminaire_desc_init(&lamp, sizeof lamp);
      lamp.profile = profile;
      lamp.to_world[3] = at[i][0], lamp.to_world[7] = at[i][1], lamp.to_world[11] = 2.5;
      ups_luminaire_id id;
      check(ups_scene_add_luminaire(scene, &lamp, &id));
      lamps[i] = id.v;
    }
    ups_profile_destroy(profile);
  }

  ups_sensor_id add(const std::vector<double>& at, const std::vector<float>& normals) {
    ups_meter_desc desc;
    ups_meter_desc_init(&desc, sizeof desc);
    desc.count = uint32_t(at.size() / 3), desc.positions_m = at.data(), desc.normals = normals.data();
    ups_sensor_id id{};
    check(ups_scene_add_meters(scene, &desc, &id));
    return id;
  }

  void add_meters() {
    const double outline[12] = {0, 0, 4, 0, 4, 3, 2, 3, 2, 5, 0, 5};
    ups_en12464_desc desc;
    ups_en12464_desc_init(&desc, sizeof desc);
    desc.corner_count = 6, desc.corners_m = outline;
    ups_en12464_point grid[400];
    size_t count = 0;
    check(ups_en12464_grid(&desc, nullptr, grid, 400, &count));
    point_count = uint32_t(count);
    std::vector<double> at;
    std::vector<float> normals;
    for (size_t i = 0; i < count; ++i) {
      at.insert(at.end(), {grid[i].x_m, grid[i].y_m, 0.75});
      normals.insert(normals.end(), {0, 0, 3});  // of any length
    }
    points = add(at, normals);
    at.clear(), normals.clear();
    for (int row = 0; row < 4; ++row)
      for (int column = 0; column < 6; ++column) {
        at.insert(at.end(), {0.5 + 0.5 * column, 0.01, 0.5 + 0.5 * row});
        normals.insert(normals.end(), {0, 1, 0});
      }
    wall = add(at, normals);
  }

  void add_others() {
    const double from_corner[12] = {1, 0, 0, 1, 0, 0, -1, 0.3, 0, 1, 0, 1.2};
    ups_observer_desc observer;
    ups_observer_desc_init(&observer, sizeof observer);
    std::memcpy(observer.to_world, from_corner, sizeof from_corner);
    check(ups_scene_add_observer(scene, &observer, &eye));
    ups_camera_desc view;
    ups_camera_desc_init(&view, sizeof view);
    view.width = 12, view.height = 9, view.vertical_fov_rad = 1.2f, view.illuminance = 1;
    std::memcpy(view.to_world, from_corner, sizeof from_corner);
    check(ups_scene_add_camera(scene, &view, &camera));
    ups_surface_meters_desc on_walls;
    ups_surface_meters_desc_init(&on_walls, sizeof on_walls);
    on_walls.instance_count = 1, on_walls.instances = &room_;
    check(ups_scene_add_surface_meters(scene, &on_walls, &surface));
    ups_goniometer_desc far;
    ups_goniometer_desc_init(&far, sizeof far);
    check(ups_scene_add_goniometer(scene, &far, &goniometer));
  }

  ups_instance_id room_{};
};

struct MapDesc : ups_report_map_desc {
  MapDesc() { ups_report_map_desc_init(this, sizeof(ups_report_map_desc)); }
  explicit MapDesc(ups_sensor_id of) : MapDesc() {
    scene = LRoom::lit().scene, result = LRoom::lit().result, sensor = of;
  }
};
struct StyleDesc : ups_report_style_desc {
  StyleDesc() { ups_report_style_desc_init(this, sizeof(ups_report_style_desc)); }
};

std::string drawn(const ups_report_map_desc& desc, const std::string& name) {
  EXPECT_EQ(ups_report_write_map(path_of(name).c_str(), &desc), UPS_OK) << ups_report_last_error();
  return read(path_of(name));
}

// Fails with this status and these words, and leaves no file.
void expect_no_map(const ups_report_map_desc& desc, ups_status status, const std::string& words,
                   const std::string& name = "none.svg") {
  EXPECT_EQ(ups_report_write_map(path_of(name).c_str(), &desc), status) << words;
  EXPECT_TRUE(has(ups_report_last_error(), words)) << ups_report_last_error();
  EXPECT_FALSE(std::ifstream(path_of(name)).good());
}

uint32_t side_of(const std::string& png, size_t at) {
  uint32_t side = 0;
  for (size_t i = at; i < at + 4; ++i) side = side << 8 | uint8_t(png[i]);
  return side;
}

TEST(ReportMap, OfMetersInThreeFormats) {
  const ups_report_sensor eye{LRoom::lit().eye, 0, "desk <1>"};
  MapDesc desc(LRoom::lit().points);
  desc.title = "L-room ä";
  desc.sensors = &eye, desc.sensor_count = 1;
  const std::string svg = drawn(desc, "l.svg"), png = drawn(desc, "l.png"), pdf = drawn(desc, "l.pdf");
  EXPECT_TRUE(has(svg, "<title id=\"ititle\">Illuminance: L-room ä</title>")) << svg.substr(0, 600);
  EXPECT_TRUE(has(svg, "lines at")) << "a lattice with gaps was found";
  EXPECT_TRUE(has(svg, ", U0 0."));
  EXPECT_EQ(png.substr(0, 8), "\x89PNG\r\n\x1a\n");
  EXPECT_EQ(pdf.substr(0, 5), "%PDF-");
  StyleDesc style;
  style.zoom = 1, style.width = 400;
  desc.style = &style;
  const std::string small = drawn(desc, "small.png");
  EXPECT_LE(side_of(small, 16), 400u);
  EXPECT_GT(side_of(png, 16), side_of(small, 16));
}

TEST(ReportMap, OfAWallAndOfACamera) {
  EXPECT_TRUE(has(drawn(MapDesc(LRoom::lit().wall), "wall.svg"), "Illuminance: meters 2"));
  MapDesc view(LRoom::lit().camera);
  EXPECT_TRUE(has(drawn(view, "view.svg"), "Luminance, cd/m\u00b2: camera 4"));
  view.quantity = UPS_REPORT_QUANTITY_ILLUMINANCE;
  EXPECT_TRUE(has(drawn(view, "view.svg"), "Illuminance, lx: camera 4"));
}

TEST(ReportMap, OfNumbers) {
  std::vector<double> at;
  std::vector<float> lx, bounds;
  for (int row = 0; row < 4; ++row)
    for (int column = 0; column < 6; ++column) {
      at.insert(at.end(), {1.0 * column, 1.0 * row, 0.8});
      lx.push_back(100.f + 10.f * float(column)), bounds.push_back(2);
    }
  MapDesc desc;
  desc.positions_m = at.data(), desc.values = lx.data(), desc.error_bounds = bounds.data(), desc.count = 24;
  StyleDesc style;
  style.threshold_lx = 121;
  desc.style = &style;
  EXPECT_TRUE(has(drawn(desc, "points.svg"), "Of 24 values, 121 lx is met at 12, not sure at 4, not met at 8."));
  const std::string plain = drawn(desc, "plain.pdf"), found_out = drawn(desc, "points.svg");
  desc.columns = 6;
  EXPECT_TRUE(drawn(desc, "points.svg") == found_out);
  desc.columns = 4;  // rows for columns
  expect_no_map(desc, UPS_ERROR_INVALID_ARGUMENT, "columns is 4, but the points are no such grid");
  desc.columns = 0;
  desc.scene = LRoom::lit().scene;
  EXPECT_GT(drawn(desc, "plan.pdf").size(), plain.size()) << "the plan beneath";
  MapDesc image;
  lx[0] = NAN, lx[1] = -1;  // not known
  image.values = lx.data(), image.count = 24, image.columns = 6;
  EXPECT_TRUE(has(drawn(image, "image.svg"), "mean 126.8 cd/m\u00b2, min 100, max 150"));
}

TEST(ReportMap, HasAPointInNumbersWhateverTheLocale) {
  MapDesc desc(LRoom::lit().points);
  const std::string before = drawn(desc, "locale.svg");
  const ups::test::GermanLocale german(LC_ALL);
  if (!german.is_set()) GTEST_SKIP() << "no German locale: samples/setup.sh test installs what it is made of";
  EXPECT_TRUE(drawn(desc, "locale.svg") == before);
  EXPECT_TRUE(german.is_set()) << "the caller's own is back";
}

TEST(ReportMap, IsTheSameOnManyThreads) {
  const MapDesc desc(LRoom::lit().points), view(LRoom::lit().camera);
  const std::string map = drawn(desc, "one.svg"), image = drawn(view, "one.png");
  std::vector<std::thread> threads;
  std::vector<std::string> maps(4), images(4);
  for (size_t i = 0; i < maps.size(); ++i)
    threads.emplace_back([&, i] {
      maps[i] = drawn(desc, std::to_string(i) + ".svg");
      images[i] = drawn(view, std::to_string(i) + ".png");
    });
  for (std::thread& thread : threads) thread.join();
  for (size_t i = 0; i < maps.size(); ++i) EXPECT_TRUE(maps[i] == map && images[i] == image) << i;
}

TEST(ReportMap, RefusesWhatItCannotDraw) {
  const LRoom& room = LRoom::lit();
  expect_no_map(MapDesc(room.surface), UPS_ERROR_UNSUPPORTED, "lie on surfaces");
  expect_no_map(MapDesc(room.goniometer), UPS_ERROR_INVALID_ARGUMENT, "neither meters nor a camera");
  expect_no_map(MapDesc(room.points), UPS_ERROR_INVALID_ARGUMENT, "must end in .png, .svg or .pdf", "none.gif");
  expect_no_map(MapDesc(ups_sensor_id{12345}), UPS_ERROR_INVALID_ARGUMENT, "not a sensor of the scene");
  expect_no_map(MapDesc(), UPS_ERROR_INVALID_ARGUMENT, "values is NULL");
  MapDesc both(room.points);
  both.count = 1;
  expect_no_map(both, UPS_ERROR_INVALID_ARGUMENT, "given both");
  MapDesc dark(room.points);
  dark.quantity = UPS_REPORT_QUANTITY_LUMINANCE;
  expect_no_map(dark, UPS_ERROR_INVALID_ARGUMENT, "are meters, of illuminance");
  const double line[9] = {0, 0, 0, 1, 0, 0, 3, 0, 0};
  const float lx[3] = {1, 2, 3};
  MapDesc flat;
  flat.positions_m = line, flat.values = lx, flat.count = 3;
  expect_no_map(flat, UPS_ERROR_UNSUPPORTED, "on one line");
  const double point[6] = {0, 0, 0, 1e-320, 0, 0};  // a metre of paper would be more than there are floats
  MapDesc tiny;
  tiny.positions_m = point, tiny.values = lx, tiny.count = 2, tiny.columns = 2;
  StyleDesc verdicts;
  verdicts.threshold_lx = 1;
  tiny.style = &verdicts;
  expect_no_map(tiny, UPS_ERROR_UNSUPPORTED, "the points");
  const ups_report_sensor twice[2] = {{room.eye, 0, "a"}, {room.eye, 0, "b"}};
  MapDesc named(room.points);
  named.sensors = twice, named.sensor_count = 2;
  expect_no_map(named, UPS_ERROR_INVALID_ARGUMENT, "sensors[1]: is named twice");
  EXPECT_EQ(ups_report_write_map(nullptr, &named), UPS_ERROR_INVALID_ARGUMENT);
  const MapDesc good(room.points);
  EXPECT_EQ(ups_report_write_map("no such folder/a.svg", &good), UPS_ERROR_IO);
}

TEST(ReportMap, RefusesAStyleOutOfRange) {
  MapDesc desc(LRoom::lit().points);
  const auto expect_wrong = [&](auto change, const std::string& words) {
    StyleDesc style;
    change(style);
    desc.style = &style;
    expect_no_map(desc, UPS_ERROR_INVALID_ARGUMENT, words);
  };
  expect_wrong([](StyleDesc& s) { s.scale = 2; }, "scale must be");
  expect_wrong([](StyleDesc& s) { s.colours = -1; }, "colours must be");
  expect_wrong([](StyleDesc& s) { s.cells = 2; }, "must be 0 or 1");
  expect_wrong([](StyleDesc& s) { s.low = 5, s.high = 5; }, "greater by a millionth");
  expect_wrong([](StyleDesc& s) { s.low = 1, s.high = 1 + 1e-15; }, "greater by a millionth");
  expect_wrong([](StyleDesc& s) { s.low = 1, s.high = INFINITY; }, "greater by a millionth");
  expect_wrong([](StyleDesc& s) { s.high = 5, s.scale = UPS_REPORT_SCALE_LOGARITHMIC; }, "scale is logarithmic");
  expect_wrong([](StyleDesc& s) { s.threshold_lx = NAN; }, "threshold_lx");
  expect_wrong([](StyleDesc& s) { s.width = 10; }, "width must be");
  expect_wrong([](StyleDesc& s) { s.zoom = 0; }, "zoom must be");
  expect_wrong([](StyleDesc& s) { s.width = 4001; }, "width must be");
  expect_wrong([](StyleDesc& s) { s.width = 4000, s.zoom = 8; }, "16384 pixels");
  expect_wrong([](StyleDesc& s) { s.struct_size = 0; }, "struct_size");
}

class ReportPage : public testing::Test {
 protected:
  ReportPage() {
    const LRoom& room = LRoom::lit();
    ups_report_page_desc_init(&page, sizeof page);
    page.scene = room.scene, page.result = room.result;
    page.sensors = sensors, page.sensor_count = 6;
  }
  void expect_no_page(ups_status status, const std::string& words) {
    EXPECT_EQ(ups_report_write_page(path_of("none.html").c_str(), &page), status) << words;
    EXPECT_TRUE(has(ups_report_last_error(), words)) << ups_report_last_error();
    EXPECT_FALSE(std::ifstream(path_of("none.html")).good());
  }
  std::string written() {
    EXPECT_EQ(ups_report_write_page(path_of("page.html").c_str(), &page), UPS_OK) << ups_report_last_error();
    return read(path_of("page.html"));
  }

  const ups_report_sensor sensors[6] = {{LRoom::lit().points, 0, "work plane"}, {LRoom::lit().wall, 0, nullptr},
                                        {LRoom::lit().eye, 0, "desk"},          {LRoom::lit().camera, 0, "view"},
                                        {LRoom::lit().surface, 0, "surfaces"},  {LRoom::lit().goniometer, 0, nullptr}};
  ups_report_page_desc page;
};

TEST_F(ReportPage, TellsAllOfTheRoom) {
  const ups_report_source source{UPS_SOURCE_LUMINAIRE, LRoom::lit().lamps[0], "lamp <one>", "spot & co.ies"};
  const double thresholds[1] = {100};
  const ups_report_ratio ratio{LRoom::lit().wall, LRoom::lit().points};
  page.sources = &source, page.source_count = 1;
  page.thresholds_lx = thresholds, page.threshold_count = 1;
  page.ratios = &ratio, page.ratio_count = 1;
  page.title = "Study & hall", page.scene_name = "plan 7", page.repeat = "press \"again\"", page.date = "2 May";
  page.targets_json = R"({"areas": [{"name": "Desk", "meters": "work*", "mean_lx": 1, "uniformity": 0.999},
                                    {"meters": "meters 2", "min_lx": 0.1}, {"observers": "desk", "ugr": 40}]})";
  const std::string html = written();
  for (const char* words :
       {"<title>Lighting report: Study &amp; hall</title>", "plan 7", "press &quot;again&quot;", "2 May", "work plane",
        "meters 2", "lamp &lt;one&gt;", "spot &amp; co.ies", "luminaire 2", "surfaces", "At least 100 lx", "not met",
        "\u2713 met",
        "Ratios of mean illuminances", "Flux balance", "id=\"glare\"", "Plan of the scene", "Polar diagram",
        "Illuminance of work plane", "horizontal, at 0.75 m"})
    EXPECT_TRUE(has(html, words)) << words;
  EXPECT_FALSE(has(html, "<script") || has(html, "src=\"http") || has(html, "lamp <one>"));
  EXPECT_EQ(html.substr(html.size() - 8), "</html>\n");
}

// Two sets may have the same name: each keeps its verdict.
TEST_F(ReportPage, HasARowForEachOfTwoSetsOfOneName) {
  const ups_report_sensor alike[2] = {{LRoom::lit().points, 0, "plane"}, {LRoom::lit().wall, 0, "plane"}};
  page.sensors = alike, page.sensor_count = 2;
  page.targets_json = R"({"areas": [{"name": "Room", "meters": "plane", "mean_lx": 1e5}]})";
  const std::string html = written();
  const size_t begin = html.find("id=\"requirements\""), end = html.find("</section>", begin);
  ASSERT_NE(begin, html.npos);
  size_t rows = 0;
  for (size_t at = begin; (at = html.find(">plane<", at)) < end; ++at) ++rows;
  EXPECT_EQ(rows, 2u);
}

TEST_F(ReportPage, LeavesOutWhatIsNotTold) {
  page.sensor_count = 1;
  const std::string html = written();
  EXPECT_TRUE(has(html, "<h1>Lighting</h1>") && has(html, "luminaire 1"));
  EXPECT_FALSE(has(html, "Scene file") || has(html, "gives the same numbers again") || has(html, "id=\"pictures\"") ||
               has(html, "id=\"requirements\"") || has(html, "id=\"glare\""));
  page.sensor_count = 0, page.sensors = nullptr;
  EXPECT_TRUE(has(written(), "Flux balance"));
}

TEST_F(ReportPage, ShowsPictures) {
  using namespace std::string_literals;
  const std::string png = "\x89PNG\r\n\x1a\n\0\0\0\rIHDR rest \0\0\0\0IEND\xae\x42\x60\x82"s;
  ups_report_picture picture{LRoom::lit().camera, UPS_REPORT_EXPOSURE_CHOSEN, 5, 1, 0, nullptr,
                             reinterpret_cast<const uint8_t*>(png.data()), png.size()};
  page.pictures = &picture, page.picture_count = 1;
  const std::string html = written();
  EXPECT_TRUE(has(html, "data:image/png;base64,iVBORw0KGgoAAAANSUhEUiByZXN0IAAAAABJRU5ErkJggg=="));
  EXPECT_TRUE(has(html, "EV100 5.0") && has(html, "Smoothed"));
  std::ofstream(path_of("picture.png"), std::ios::binary) << png;
  const std::string path = path_of("picture.png");
  picture.path = path.c_str(), picture.png = nullptr, picture.png_size = 0;
  EXPECT_TRUE(written() == html);
  picture.path = "no such picture.png";
  expect_no_page(UPS_ERROR_IO, "cannot read 'no such picture.png'");
  const std::string folder = testing::TempDir();
  picture.path = folder.c_str();
  expect_no_page(UPS_ERROR_IO, "cannot read");
  picture.path = nullptr;
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "pictures[0]: needs path or png");
  picture.png = reinterpret_cast<const uint8_t*>("GIF89a..."), picture.png_size = 9;
  expect_no_page(UPS_ERROR_PARSE, "pictures[0]: is no PNG");
  picture.png = reinterpret_cast<const uint8_t*>(png.data()), picture.png_size = 24;
  expect_no_page(UPS_ERROR_PARSE, "pictures[0]: is no PNG");
  picture.camera = LRoom::lit().wall;
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "pictures[0] is no camera");
}

TEST_F(ReportPage, HasAPointInNumbersWhateverTheLocale) {
  const std::string before = written();
  const ups::test::GermanLocale german(LC_ALL);
  if (!german.is_set()) GTEST_SKIP() << "no German locale: samples/setup.sh test installs what it is made of";
  EXPECT_TRUE(written() == before);
}

TEST_F(ReportPage, RefusesWrongTargetsAndSensors) {
  page.targets_name = "wishes.json";
  page.targets_json = "{";
  expect_no_page(UPS_ERROR_PARSE, "wishes.json: is no JSON: parse error at line 1");
  const std::string deep = R"({"note": )" + std::string(100000, '[') + std::string(100000, ']') + "}";
  page.targets_json = deep.c_str();
  expect_no_page(UPS_ERROR_PARSE, "wishes.json: is nested deeper");
  page.targets_json = R"({"areas": [{"meters": "work plane", "mean_lx": 1e999}]})";
  expect_no_page(UPS_ERROR_PARSE, "wishes.json: has a number that is too large");
  page.targets_json = R"({"areas": [{"meters": "work plane", "mean": 500}]})";
  expect_no_page(UPS_ERROR_PARSE, "wishes.json: areas[0]: 'mean' is no word of it");
  page.targets_json = R"({"areas": [{"meters": "roof", "mean_lx": 500}]})";
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "the scene has no meters 'roof'; it has work plane, meters 2, surfaces");
  page.targets_json = R"({"include": "en12464-1.json", "areas": [{"meters": "work plane", "row": "office.writing"}]})";
  expect_no_page(UPS_ERROR_PARSE, "no folder is given that 'en12464-1.json' could lie in");
  page.targets_json = R"({"include": "../targets/en12464-1.json", "areas": []})";
  const std::string below = std::string(UPS_TARGETS_FOLDER) + "/../c";
  page.targets_folder = below.c_str();
  expect_no_page(UPS_ERROR_PARSE, "there is no file '../targets/en12464-1.json' in ");
  page.targets_json = R"({"include": "en12464-1.json", "areas": [{"meters": "work plane", "row": "office.writing"}]})";
  page.targets_folder = UPS_TARGETS_FOLDER;
  EXPECT_TRUE(has(written(), "EN 12464-1"));
  page.targets_json = nullptr;
  page.target_relative_error = -1;
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "target_relative_error");
  page.target_relative_error = 1.7e308;  // its axis would have no end
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "target_relative_error");
  page.target_relative_error = 0;
  page.ratio_count = 1;
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "ratios is NULL, but its count is 1");
  page.ratio_count = 0;
  ups_report_source sources[2] = {{UPS_SOURCE_LUMINAIRE, LRoom::lit().lamps[0], "lamp", nullptr},
                                  {UPS_SOURCE_LUMINAIRE, 4711, "of another room", nullptr}};
  page.sources = sources, page.source_count = 2;
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "sources[1]: the scene has no luminaire or light 4711");
  sources[1].kind = UPS_SOURCE_INSTANCE;
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "sources[1]: the scene has no instance 4711");
  sources[1] = sources[0];
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "sources[1] is named twice");
  page.source_count = 0;
  page.result = nullptr;
  expect_no_page(UPS_ERROR_INVALID_ARGUMENT, "result is NULL");
}

// Two distributions of the same flux, twice the first: two types, two diagrams.
class TwoPhotometries : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_EQ(ups_scene_create(LRoom::lit().context, &scene), UPS_OK);
    const float gamma_deg[3] = {0, 45, 90}, c_deg[1] = {0}, wide[3] = {500, 500, 500}, narrow[3] = {900, 100, 0};
    for (const float* cd : {wide, narrow, wide}) {
      ups_profile_desc desc;
      ups_profile_desc_init(&desc, sizeof desc);
      desc.c_count = 1, desc.gamma_count = 3, desc.c_deg = c_deg, desc.gamma_deg = gamma_deg, desc.intensity_cd = cd;
      ups_profile* profile = nullptr;
      ASSERT_EQ(ups_profile_create(LRoom::lit().context, &desc, &profile), UPS_OK);
      ups_luminaire_desc lamp;
      ups_luminaire_desc_init(&lamp, sizeof lamp);
      lamp.profile = profile, lamp.flux_lm = 800, lamp.to_world[11] = 3;
      ups_luminaire_id id;
      ASSERT_EQ(ups_scene_add_luminaire(scene, &lamp, &id), UPS_OK);
      ups_profile_destroy(profile);
    }
    const double at[12] = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};
    const float up[12] = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    meters.count = 4, meters.positions_m = at, meters.normals = up;
    ASSERT_EQ(ups_scene_add_meters(scene, &meters, &points), UPS_OK);
    camera.width = camera.height = 8;
    ASSERT_EQ(ups_scene_add_camera(scene, &camera, &view), UPS_OK);
    ASSERT_EQ(ups_scene_commit(scene), UPS_OK);
    result = render_once(scene);
    ASSERT_NE(result, nullptr);
  }
  void TearDown() override { ups_result_destroy(result), ups_scene_destroy(scene); }

  ups_scene* scene = nullptr;
  ups_result* result = nullptr;
  ups_meter_desc meters = [] {
    ups_meter_desc desc;
    ups_meter_desc_init(&desc, sizeof desc);
    return desc;
  }();
  ups_camera_desc camera = [] {
    ups_camera_desc desc;
    ups_camera_desc_init(&desc, sizeof desc);
    return desc;
  }();
  ups_sensor_id points{}, view{};
};

TEST_F(TwoPhotometries, AreTwoTypesWhereNoFileIsTold) {
  ups_report_page_desc page;
  ups_report_page_desc_init(&page, sizeof page);
  page.scene = scene, page.result = result;
  ASSERT_EQ(ups_report_write_page(path_of("types.html").c_str(), &page), UPS_OK) << ups_report_last_error();
  const std::string html = read(path_of("types.html"));
  EXPECT_TRUE(has(html, "Type 1</strong>") && has(html, "Type 2</strong>"));
  EXPECT_FALSE(has(html, "Type 3</strong>")) << "the third luminaire is of the first one's type";
}

TEST_F(TwoPhotometries, OfASceneWithEditsHaveNoMap) {
  MapDesc desc(points);
  desc.scene = scene, desc.result = result;
  EXPECT_EQ(ups_report_write_map(path_of("edited.svg").c_str(), &desc), UPS_OK) << ups_report_last_error();
  ups_luminaire_id lamp{};
  ups_light_desc light;
  ups_light_desc_init(&light, sizeof light);
  ASSERT_EQ(ups_scene_add_light(scene, &light, &lamp), UPS_OK);
  EXPECT_EQ(ups_report_write_map(path_of("edited.svg").c_str(), &desc), UPS_ERROR_INVALID_STATE);
  EXPECT_TRUE(has(ups_report_last_error(), "edits that are not committed")) << ups_report_last_error();

  ASSERT_EQ(ups_scene_commit(scene), UPS_OK);
  EXPECT_EQ(ups_report_write_map(path_of("edited.svg").c_str(), &desc), UPS_ERROR_INVALID_STATE);
  EXPECT_TRUE(has(ups_report_last_error(), "not of the scene as it was committed last")) << ups_report_last_error();
  ups_report_page_desc page;
  ups_report_page_desc_init(&page, sizeof page);
  page.scene = scene, page.result = result;
  EXPECT_EQ(ups_report_write_page(path_of("edited.html").c_str(), &page), UPS_ERROR_INVALID_STATE);
  EXPECT_TRUE(has(ups_report_last_error(), "not of the scene as it was committed last")) << ups_report_last_error();
}

TEST_F(TwoPhotometries, AreNotInThePageOfAnotherScene) {
  ups_scene* other = nullptr;
  ASSERT_EQ(ups_scene_create(LRoom::lit().context, &other), UPS_OK);
  ASSERT_EQ(ups_scene_commit(other), UPS_OK);
  ups_report_page_desc page;
  ups_report_page_desc_init(&page, sizeof page);
  page.scene = other, page.result = result;
  EXPECT_EQ(ups_report_write_page(path_of("other.html").c_str(), &page), UPS_ERROR_INVALID_STATE);
  EXPECT_TRUE(has(ups_report_last_error(), "or of another")) << ups_report_last_error();
  ups_scene_destroy(other);
}

// A camera in empty space, beside nothing that has a place.
TEST(ReportOfNothing, HasNoPlan) {
  ups_scene* scene = nullptr;
  ASSERT_EQ(ups_scene_create(LRoom::lit().context, &scene), UPS_OK);
  ups_camera_desc camera;
  ups_camera_desc_init(&camera, sizeof camera);
  camera.width = camera.height = 8;
  ups_sensor_id view{};
  ASSERT_EQ(ups_scene_add_camera(scene, &camera, &view), UPS_OK);
  ASSERT_EQ(ups_scene_commit(scene), UPS_OK);
  ups_result* result = render_once(scene);
  ASSERT_NE(result, nullptr);
  ups_report_page_desc page;
  ups_report_page_desc_init(&page, sizeof page);
  page.scene = scene, page.result = result;
  EXPECT_EQ(ups_report_write_page(path_of("nothing.html").c_str(), &page), UPS_OK) << ups_report_last_error();
  EXPECT_TRUE(has(read(path_of("nothing.html")), "0 triangles"));
  EXPECT_FALSE(has(read(path_of("nothing.html")), "Plan of the scene"));
  ups_result_destroy(result), ups_scene_destroy(scene);
}

TEST_F(ReportPage, NeedsACommittedScene) {
  ups_scene* empty = nullptr;
  ASSERT_EQ(ups_scene_create(LRoom::lit().context, &empty), UPS_OK);
  page.scene = empty;
  page.sensor_count = 0;
  expect_no_page(UPS_ERROR_INVALID_STATE, "commit");
  ups_scene_destroy(empty);
}

}  // namespace
