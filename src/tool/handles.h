// What the commands read of a scene file, and the handles that they own. For the whole program.
#pragma once
#include <memory>
#include <string>
#include <vector>

#include "report/lit_scene.h"
#include "tool/library.h"
#include "ups/ups.h"
#include "ups/ups_exr.h"
#include "ups/ups_gltf.h"
#include "ups/ups_ocio.h"

namespace ups::tool {

using Context = std::unique_ptr<ups_context, Destroy<ups_context_destroy>>;
using Scene = std::unique_ptr<ups_scene, Destroy<ups_scene_destroy>>;
using Job = std::unique_ptr<ups_job, Destroy<ups_job_destroy>>;
using Result = std::unique_ptr<ups_result, Destroy<ups_result_destroy>>;
using Path = std::unique_ptr<ups_path, Destroy<ups_path_destroy>>;
using Import = std::unique_ptr<ups_gltf_import, Destroy<ups_gltf_import_destroy>>;
using Image = std::unique_ptr<ups_exr_image, Destroy<ups_exr_image_destroy>>;

// A scene file; committed unless it comes from import_scene.
struct LoadedScene : LitScene {
  Context context;
  Scene owned;  // what `scene` is
  Import import_result;
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
