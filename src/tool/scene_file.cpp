// How the commands load a scene file: context, import, commit, sensors and warnings.
#include <algorithm>
#include <string_view>

#include "tool/handles.h"

namespace ups::tool {

std::string without_functions(const std::string& message) {
  constexpr std::string_view prefix = "ups_", end = ": ";
  std::string result;
  for (size_t i = 0; i < message.size();) {
    const bool first = i == 0 || (i >= end.size() && message.compare(i - end.size(), end.size(), end) == 0);
    if (first && message.compare(i, prefix.size(), prefix) == 0) {
      const size_t after =
          std::min(message.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_", i), message.size());
      if (message.compare(after, end.size(), end) == 0) {
        i = after + end.size();
        continue;
      }
    }
    result += message[i++];
  }
  return result;
}

Context make_context(int threads) {
  ups_context_desc desc;
  ups_context_desc_init(&desc, sizeof desc);
  desc.thread_count = threads;
  ups_context* context = nullptr;
  check(ups_context_create(&desc, &context));
  return Context(context);
}

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  for (size_t begin = 0; begin < text.size();) {
    const size_t end = std::min(text.find('\n', begin), text.size());
    if (end > begin) lines.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return lines;
}

namespace {

// What is wrong with a photometric file the import tells of the file, "a.ies: ...", and the commit of whoever has it,
// "luminaire 2: ...", "luminaires 1 and 2: ...".
bool is_told(const std::vector<std::string>& lines, const std::string& line) {
  const size_t colon = line.find(": ");
  const bool of_luminaire =
      colon != std::string::npos && (line.rfind("luminaire ", 0) == 0 || line.rfind("luminaires ", 0) == 0);
  const std::string rest = of_luminaire ? line.substr(colon) : "";
  return std::any_of(lines.begin(), lines.end(), [&](const std::string& told) {
    return told == line || (of_luminaire && told.size() > rest.size() &&
                            told.compare(told.size() - rest.size(), rest.size(), rest) == 0);
  });
}

}  // namespace

void append_once(std::vector<std::string>& to, const std::vector<std::string>& lines) {
  for (const std::string& line : lines) {
    if (!is_told(to, line)) to.push_back(line);
  }
}

LoadedScene import_scene(const std::string& path, const SceneOptions& options) {
  LoadedScene loaded;
  loaded.context = make_context(options.threads);
  ups_scene* scene = nullptr;
  check(ups_scene_create(loaded.context.get(), &scene));
  loaded.scene.reset(scene);
  ups_gltf_import_desc desc;
  ups_gltf_import_desc_init(&desc, sizeof desc);
  desc.camera_width = options.camera_width;
  desc.camera_height = options.camera_height;
  desc.allow_outside = options.allow_outside;
  desc.camera_layers = options.camera_layers;
  ups_gltf_import* imported = nullptr;
  check(ups_gltf_import_file(loaded.context.get(), path.c_str(), &desc, scene, &imported), ups_gltf_last_error);
  loaded.import_result.reset(imported);
  uint32_t count = 0;
  check(ups_gltf_get_sensor_count(imported, &count), ups_gltf_last_error);
  for (uint32_t i = 0; i < count; ++i) {
    SensorEntry sensor{};
    sensor.info.struct_size = sizeof sensor.info;
    check(ups_gltf_get_sensor(imported, i, &sensor.info), ups_gltf_last_error);
    sensor.name = read_text([&](char* to, size_t capacity, size_t* needed) {
      return ups_gltf_get_sensor_name(imported, i, to, capacity, needed);
    });
    loaded.sensors.push_back(sensor);
  }
  append_once(loaded.warnings, lines_of(read_text([&](char* to, size_t capacity, size_t* needed) {
                return ups_gltf_get_warnings(imported, to, capacity, needed);
              })));
  return loaded;
}

void commit_scene(LoadedScene& loaded, const std::string& path) {
  ups_scene* scene = loaded.scene.get();
  const ups_status committed = ups_scene_commit(scene);
  if (committed != UPS_OK) throw Failure(path + ": " + without_functions(ups_last_error()));
  append_once(loaded.warnings, lines_of(read_text([&](char* to, size_t capacity, size_t* needed) {
                return ups_scene_get_text(scene, UPS_SCENE_TEXT_WARNINGS, to, capacity, needed);
              })));
}

LoadedScene load_scene(const std::string& path, const SceneOptions& options) {
  LoadedScene loaded = import_scene(path, options);
  commit_scene(loaded, path);
  return loaded;
}

}  // namespace ups::tool
