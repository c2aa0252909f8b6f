// How the commands load a scene file: context, import, commit, sensors and warnings.
#include <algorithm>

#include "tool/handles.h"
#include "tool/profile_file.h"

namespace ups::tool {

Context make_context(int threads) {
  ups_context_desc desc;
  ups_context_desc_init(&desc, sizeof desc);
  desc.thread_count = threads;
  ups_context* context = nullptr;
  check(ups_context_create(&desc, &context));
  return Context(context);
}

namespace {

static_assert(int(SensorKind::observer) == UPS_GLTF_OBSERVER && int(MeterLayout::lightmap) == UPS_GLTF_LAYOUT_LIGHTMAP);

SensorEntry sensor_at(const ups_gltf_import* imported, uint32_t index) {
  auto info = sized<ups_gltf_sensor_info>();
  check(ups_gltf_get_sensor(imported, index, &info), ups_gltf_last_error);
  SensorEntry sensor;
  sensor.info = {SensorKind(info.kind), info.sensor, info.width, info.height, info.illuminance != 0, info.meter_count,
                 info.columns, info.rows, MeterLayout(info.layout), info.meter_kind, info.projection, info.layers};
  sensor.name = read_text([&](char* to, size_t capacity, size_t* needed) {
    return ups_gltf_get_sensor_name(imported, index, to, capacity, needed);
  });
  return sensor;
}

SourceWords words_of(const ups_gltf_import* imported, ups_source_kind kind, uint32_t id) {
  const auto text = [&](auto function) {
    return read_text(
        [&](char* to, size_t capacity, size_t* needed) { return function(imported, kind, id, to, capacity, needed); },
        ups_gltf_last_error);
  };
  return {text(ups_gltf_get_source_name), text(ups_gltf_get_source_file)};
}

// Of a part that the file did not add, such as a fixture's mesh: empty.
std::string place_of(const ups_gltf_import* imported, std::string_view noun, uint32_t number) {
  constexpr std::string_view nouns[] = {"material", "mesh", "instance", "luminaire", "fixture"};  // UPS_GLTF_PART_*
  const auto part = ups_gltf_part(std::find(std::begin(nouns), std::end(nouns), noun) - std::begin(nouns));
  size_t needed = 0;
  if (ups_gltf_get_place(imported, part, number, nullptr, 0, &needed) != UPS_OK) return {};
  return read_text(
      [&](char* to, size_t capacity, size_t* size) {
        return ups_gltf_get_place(imported, part, number, to, capacity, size);
      },
      ups_gltf_last_error);
}

}  // namespace

LoadedScene import_scene(const std::string& path, const SceneOptions& options) {
  LoadedScene loaded;
  loaded.context = make_context(options.threads);
  ups_scene* scene = nullptr;
  check(ups_scene_create(loaded.context.get(), &scene));
  loaded.owned.reset(scene);
  loaded.scene = scene;
  ups_gltf_import_desc desc;
  ups_gltf_import_desc_init(&desc, sizeof desc);
  desc.camera_width = options.camera_width;
  desc.camera_height = options.camera_height;
  desc.allow_outside = options.allow_outside;
  desc.camera_layers = options.camera_layers;
  ups_gltf_import* imported = nullptr;
  const ups_status status = ups_gltf_import_file(loaded.context.get(), path.c_str(), &desc, scene, &imported);
  if (status == UPS_ERROR_PARSE && photometric_format(path))
    throw Failure(path + ": is a photometric file by its name, no scene; `ups info` reads it, and the luminaires of a "
                  "scene (.gltf, .glb) name such files");
  check(status, ups_gltf_last_error);
  loaded.import_result.reset(imported);
  loaded.source_words = [imported](ups_source_kind kind, uint32_t id) { return words_of(imported, kind, id); };
  loaded.part_words = [imported](std::string_view noun, uint32_t number) { return place_of(imported, noun, number); };
  uint32_t count = 0;
  check(ups_gltf_get_sensor_count(imported, &count), ups_gltf_last_error);
  for (uint32_t i = 0; i < count; ++i) loaded.sensors.push_back(sensor_at(imported, i));
  append_once(loaded.warnings, lines_of(read_text([&](char* to, size_t capacity, size_t* needed) {
                return ups_gltf_get_warnings(imported, to, capacity, needed);
              })));
  return loaded;
}

void commit_scene(LoadedScene& loaded, const std::string& path) {
  ups_scene* scene = loaded.owned.get();
  const ups_status committed = ups_scene_commit(scene);
  if (committed != UPS_OK) throw Failure(path + ": " + for_people(loaded, without_functions(ups_last_error())));
  for (const std::string& line : lines_of(read_text([&](char* to, size_t capacity, size_t* needed) {
         return ups_scene_get_text(scene, UPS_SCENE_TEXT_WARNINGS, to, capacity, needed);
       })))
    if (!is_told(loaded.warnings, line)) append_once(loaded.warnings, {for_people(loaded, line)});
}

LoadedScene load_scene(const std::string& path, const SceneOptions& options) {
  LoadedScene loaded = import_scene(path, options);
  commit_scene(loaded, path);
  return loaded;
}

}  // namespace ups::tool
