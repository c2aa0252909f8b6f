// The C API's handles with owners, its two-call texts as strings, its failures as exceptions. For the whole program.
#pragma once
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

#include "ups/ups.h"
#include "ups/ups_exr.h"
#include "ups/ups_gltf.h"
#include "ups/ups_ocio.h"

namespace ups::tool {

// The libraries' messages name the C function that failed, where one did: "ups_job_start: method ...". That helps
// programmers; for the program's users it is taken out.
std::string without_functions(const std::string& message);

// The work failed: message on standard error, exit code 1.
class Failure : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

template <auto destroy>
struct Destroy {
  template <class T>
  void operator()(T* handle) const {
    destroy(handle);
  }
};
using Context = std::unique_ptr<ups_context, Destroy<ups_context_destroy>>;
using Profile = std::unique_ptr<ups_profile, Destroy<ups_profile_destroy>>;
using Scene = std::unique_ptr<ups_scene, Destroy<ups_scene_destroy>>;
using Job = std::unique_ptr<ups_job, Destroy<ups_job_destroy>>;
using Result = std::unique_ptr<ups_result, Destroy<ups_result_destroy>>;
using Path = std::unique_ptr<ups_path, Destroy<ups_path_destroy>>;
using Import = std::unique_ptr<ups_gltf_import, Destroy<ups_gltf_import_destroy>>;
using Image = std::unique_ptr<ups_exr_image, Destroy<ups_exr_image_destroy>>;

inline void check(ups_status status, const char* (*last_error)() = ups_last_error) {
  if (status != UPS_OK) throw Failure(without_functions(last_error()));
}

// read(text, capacity, needed) is one of the API's two-call functions.
template <class Read>
std::string read_text(Read&& read, const char* (*last_error)() = ups_last_error) {
  size_t needed = 0;
  check(read(nullptr, 0, &needed), last_error);
  if (needed == 0) return {};
  std::string text(needed, '\0');
  check(read(text.data(), needed, &needed), last_error);
  text.resize(needed - 1);
  return text;
}

// The same of arrays of plain elements.
template <class Element, class Read>
std::vector<Element> read_array(Read&& read) {
  size_t needed = 0;
  check(read(nullptr, 0, &needed));
  std::vector<Element> all(needed);
  if (needed > 0) check(read(all.data(), needed, &needed));
  return all;
}

std::vector<std::string> lines_of(const std::string& text);  // without empty ones

void append_once(std::vector<std::string>& to, const std::vector<std::string>& lines);

struct SensorEntry {
  ups_gltf_sensor_info info;
  std::string name;
};

// What the commands read of a scene file; committed unless it comes from import_scene.
struct LoadedScene {
  Context context;
  Scene scene;
  Import import_result;
  std::vector<SensorEntry> sensors;
  std::vector<std::string> warnings;  // of the import and of the commit, each once
};

struct SceneOptions {
  int threads = 0;
  uint32_t camera_width = 0, camera_height = 0;  // 0: as the file says
  bool allow_outside = false;                    // files that the scene names may lie outside its folder
  uint32_t camera_layers = 0;                    // UPS_LAYER_* of every camera, beside the file's
};

Context make_context(int threads);
// In two steps for those who change the scene in between; path: of the file.
LoadedScene import_scene(const std::string& path, const SceneOptions& options);
void commit_scene(LoadedScene& scene, const std::string& path);
LoadedScene load_scene(const std::string& path, const SceneOptions& options);

}  // namespace ups::tool
