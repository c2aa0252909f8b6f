// The extras with exhausted memory. Each time the call must answer with a status and leave the file that was there
// whole, and nothing beside it; the same call must work once there is memory. Where the code is our own every allocation
// fails once, and all from one on (UPS_MEMORY_SWEEP=all; else they are sampled). Within OpenColorIO, Cairo and the JSON
// reader that would end the process: there the process may have so many bytes more, from none to more than enough.
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "sweep.h"
#ifdef UPS_HAS_EXR
#include "ups/ups_exr.h"
#endif
#ifdef UPS_HAS_GLTF
#include "ups/ups_gltf.h"
#endif
#ifdef UPS_HAS_OCIO
#include "ups/ups_ocio.h"
#endif
#ifdef UPS_HAS_REPORT
#include "ups/ups_report.h"
#endif

using namespace ups::test;

#ifdef UPS_SANITIZE
// Cairo loses strings of its own where memory fails it (two bytes of a page); where it does not, report_tests find none.
extern "C" const char* __lsan_default_suppressions() { return "leak:libcairo\n"; }
#endif

namespace {

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class MemoryOfExtras : public testing::Test {
 protected:
  void SetUp() override {
    folder = std::filesystem::temp_directory_path() /
             ("ups_memory_" + std::to_string(::getpid()) + "_" +
              testing::UnitTest::GetInstance()->current_test_info()->name());
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    begin_watch();
#ifdef UPS_HAS_EXR
    ups_exr_read(nullptr, nullptr);  // these fail: the room for this thread's messages stays
#endif
#ifdef UPS_HAS_OCIO
    ups_ocio_get_ev100(-1, nullptr);
#endif
#ifdef UPS_HAS_GLTF
    ups_gltf_get_sensor_count(nullptr, nullptr);
#endif
#ifdef UPS_HAS_REPORT
    ups_report_write_map(nullptr, nullptr);
#endif
  }
  void TearDown() override { std::filesystem::remove_all(folder); }
  std::string file(const std::string& name) const { return (folder / name).string(); }

  // What `call` leaves at `path` (none: nothing) is whole after each failure.
  void sweep(const Call& call, LastError* last_error, long samples, const std::string& path = {}) {
    if (low_effort()) samples /= 4;  // sanitizers take seconds to write a picture
    ASSERT_EQ(call(), UPS_OK) << last_error();  // tables that the process makes once
    ASSERT_EQ(call(), UPS_OK) << last_error();
    const std::string right = path.empty() ? std::string() : content(path);
    const long calls = count_calls(call, last_error), before = allocations_held(), bytes = bytes_allocated();
    EXPECT_GT(calls, 3);
    for (const long count : {1L, all_after})
      for (long k = 1; try_failing(call, k, count, last_error); k += stride(calls, samples)) {
        ASSERT_EQ(allocations_held(), before) << "after the failure of allocation " << k;
        if (path.empty()) continue;
        ASSERT_EQ(content(path), right) << "after the failure of allocation " << k;
        ASSERT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "allocation " << k;
      }
    EXPECT_EQ(call(), UPS_OK) << last_error();
    expect_as_much(bytes);
  }

  // The status of `call` in a child that may have `more` bytes; -1000: it did not return.
  static int status_within(size_t more, const Call& call) {
    long pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const pid_t child = fork();
    if (child == 0) {
      const rlim_t bytes = rlim_t(pages) * rlim_t(sysconf(_SC_PAGESIZE)) + more;
      const rlimit limit{bytes, bytes};
      setrlimit(RLIMIT_AS, &limit);
      _exit(-call());
    }
    int state = 0;
    waitpid(child, &state, 0);
    return WIFEXITED(state) ? -WEXITSTATUS(state) : -1000;
  }
  void limit(const Call& call, LastError* last_error, const std::string& path = {}) {
    ASSERT_EQ(call(), UPS_OK) << last_error();
    const std::string right = path.empty() ? std::string() : content(path);
    constexpr size_t kib = 1024, most = size_t(1) << 30;
#ifdef UPS_SANITIZE
    constexpr size_t least = most;  // it ends a process that has no addresses left for it
#else
    constexpr size_t least = 0;
#endif
    for (size_t more = least; more <= most; more = std::max(kib, 2 * more)) {
      const int status = status_within(more, call);
      ASSERT_TRUE(status == UPS_OK || status == UPS_ERROR_OUT_OF_MEMORY) << status << " within " << more << " bytes";
      if (more == most) {
        EXPECT_EQ(status, UPS_OK);
      }
      if (path.empty()) continue;
      ASSERT_EQ(content(path), right) << "within " << more << " bytes";
      ASSERT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1) << "within " << more << " bytes";
    }
  }

  std::filesystem::path folder;
};

#ifdef UPS_HAS_EXR
TEST_F(MemoryOfExtras, ExrIsWritten) {
  std::vector<float> values(64 * 48, 0.5f);
  const ups_exr_channel channels[] = {{"R", values.data(), 0, 0}, {"Y", values.data(), 0, 0}};
  const ups_exr_attribute unit{"unit.Y", "lx"};
  const std::string path = file("image.exr");
  limit([&] { return ups_exr_write(path.c_str(), 64, 48, channels, 2, &unit, 1); }, &ups_exr_last_error, path);
}

TEST_F(MemoryOfExtras, ExrIsRead) {
  std::vector<float> values(64 * 48, 0.5f);
  const ups_exr_channel channel{"Y", values.data(), 0, 0};
  const std::string path = file("image.exr");
  ASSERT_EQ(ups_exr_write(path.c_str(), 64, 48, &channel, 1, nullptr, 0), UPS_OK) << ups_exr_last_error();
  limit([&] {
    ups_exr_image* image = nullptr;
    ups_status status = ups_exr_read(path.c_str(), &image);
    if (status == UPS_OK) status = ups_exr_read_channel(image, "Y", values.data(), values.size());
    ups_exr_image_destroy(image);
    return status;
  }, &ups_exr_last_error);
}
#endif

#ifdef UPS_HAS_OCIO
TEST_F(MemoryOfExtras, PicturesAreWritten) {
  const std::vector<float> rgb(3 * 32 * 24, 10.0f);
  const std::string path = file("image.png");
  limit([&] { return ups_ocio_write_png(path.c_str(), rgb.data(), 32, 24, 0); }, &ups_ocio_last_error, path);
}

// OpenColorIO kept 16 KiB of each.
TEST_F(MemoryOfExtras, ExposuresAreNotKept) {
  const std::vector<float> rgb(3 * 8 * 6, 10.0f);
  const std::string path = file("image.png");
  const auto write = [&](int i) { return ups_ocio_write_png(path.c_str(), rgb.data(), 8, 6, 0.01 * (i + 1)); };
  constexpr int warm = 20, pictures = 200;
  for (int i = 0; i < warm; ++i) ASSERT_EQ(write(i), UPS_OK) << ups_ocio_last_error();
  const long before = bytes_allocated();
  for (int i = warm; i < warm + pictures; ++i) ASSERT_EQ(write(i), UPS_OK) << ups_ocio_last_error();
  EXPECT_LT(bytes_allocated() - before, 1 << 18);
}

TEST_F(MemoryOfExtras, FalseColoursAreWritten) {
  const std::vector<float> values(32 * 24, 10.0f);
  auto desc = make_desc<ups_ocio_false_color_desc>(ups_ocio_false_color_desc_init);
  desc.columns = 32, desc.rows = 24, desc.values = values.data(), desc.title = "floor";
  const std::string path = file("floor.png");
  sweep([&] { return ups_ocio_write_false_color_png(path.c_str(), &desc); }, &ups_ocio_last_error, 40, path);
}
#endif

#ifdef UPS_HAS_GLTF
// A floor of 4 m under a point light, and 16 meters over it.
constexpr const char* lit_floor = R"({"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1, 2]}],
 "extensionsUsed": ["KHR_lights_punctual"],
 "extensions": {"KHR_lights_punctual": {"lights": [{"type": "point", "intensity": 100}]}},
 "nodes": [{"mesh": 0, "name": "floor"},
           {"translation": [2, 2, -2], "extensions": {"KHR_lights_punctual": {"light": 0}}},
           {"translation": [2, 0.5, -2], "rotation": [-0.7071068, 0, 0, 0.7071068],
            "extras": {"ups": {"meters": {"name": "desk", "width_m": 2, "height_m": 2, "columns": 4, "rows": 4}}}}],
 "materials": [{"name": "matte"}],
 "meshes": [{"primitives": [{"attributes": {"POSITION": 0}, "indices": 1, "material": 0}]}],
 "accessors": [{"bufferView": 0, "componentType": 5126, "count": 4, "type": "VEC3", "min": [0, 0, -4], "max": [4, 0, 0]},
               {"bufferView": 1, "componentType": 5123, "count": 6, "type": "SCALAR"}],
 "bufferViews": [{"buffer": 0, "byteLength": 48}, {"buffer": 0, "byteOffset": 48, "byteLength": 12}],
 "buffers": [{"byteLength": 60, "uri": "data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAQAAAAAAAAAAAAACAQAAAAAAAAIDAAAAAAAAAAAAAAIDAAAABAAIAAAACAAMA"}]}
)";

bool error_is_the_cores = false;
const char* import_error() { return error_is_the_cores ? ups_last_error() : ups_gltf_last_error(); }

TEST_F(MemoryOfExtras, ASceneIsImported) {
  const std::string path = file("floor.gltf");
  std::ofstream(path) << lit_floor;
  ups_context* context = nullptr;
  ASSERT_EQ(ups_context_create(nullptr, &context), UPS_OK) << ups_last_error();
  limit([&] {
    ups_scene* scene = nullptr;
    ups_status status = ups_scene_create(context, &scene);
    error_is_the_cores = status != UPS_OK;
    if (status != UPS_OK) return status;
    ups_gltf_import* import_result = nullptr;
    status = ups_gltf_import_file(context, path.c_str(), nullptr, scene, &import_result);
    ups_gltf_import_destroy(import_result);
    ups_scene_destroy(scene);
    return status;
  }, &import_error);
  ups_context_destroy(context);
}
#endif

#ifdef UPS_HAS_REPORT
class MemoryOfReports : public MemoryOfExtras {
 protected:
  void SetUp() override {
    MemoryOfExtras::SetUp();
    ASSERT_EQ(ups_scene_commit(room.scene.get()), UPS_OK) << ups_last_error();
    const ups_render_desc render = short_render(0.1f);
    ASSERT_EQ(ups_render(room.scene.get(), &render, &result), UPS_OK) << ups_last_error();
  }
  void TearDown() override {
    ups_result_destroy(result);
    MemoryOfExtras::TearDown();
  }
  // Of numbers over the room's plan.
  template <class Try>
  void try_map(const std::string& name, const Try& try_call) {
    std::vector<double> places;
    std::vector<float> values;
    for (int i = 0; i < 16; ++i) {
      places.insert(places.end(), {0.5 + i % 4, 0.5 + i / 4, 0.75});
      values.push_back(float(100 + 20 * (i % 5)));
    }
    auto desc = make_desc<ups_report_map_desc>(ups_report_map_desc_init);
    desc.scene = room.scene.get(), desc.positions_m = places.data(), desc.values = values.data();
    desc.count = 16, desc.columns = 4, desc.title = "work plane";
    const std::string path = file(name);
    try_call([&] { return ups_report_write_map(path.c_str(), &desc); }, path);
  }
  Room room{1};
  ups_result* result = nullptr;
};

TEST_F(MemoryOfReports, MapAsSvg) {
  try_map("map.svg", [&](const Call& call, const std::string& path) { limit(call, &ups_report_last_error, path); });
}
TEST_F(MemoryOfReports, MapAsPng) {
  try_map("map.png", [&](const Call& call, const std::string& path) { limit(call, &ups_report_last_error, path); });
}
TEST_F(MemoryOfReports, MapAsPdf) {
  try_map("map.pdf", [&](const Call& call, const std::string& path) { limit(call, &ups_report_last_error, path); });
}
TEST_F(MemoryOfReports, MapOfACamera) {
  auto desc = make_desc<ups_report_map_desc>(ups_report_map_desc_init);
  desc.scene = room.scene.get(), desc.result = result, desc.sensor = room.camera.id;
  const std::string path = file("view.png");
  limit([&] { return ups_report_write_map(path.c_str(), &desc); }, &ups_report_last_error, path);
}
TEST_F(MemoryOfReports, Page) {
  const ups_report_sensor sensors[] = {{room.meters.id, 0, "work plane"}, {room.camera.id, 0, "view"}};
  auto desc = make_desc<ups_report_page_desc>(ups_report_page_desc_init);
  desc.scene = room.scene.get(), desc.result = result, desc.sensors = sensors, desc.sensor_count = 2;
  desc.date = "today";
  const std::string path = file("page.html");
  limit([&] { return ups_report_write_page(path.c_str(), &desc); }, &ups_report_last_error, path);
}
#endif

}  // namespace
