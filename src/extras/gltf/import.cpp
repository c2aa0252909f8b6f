// The C boundary of ups_gltf and the order in which an import works.
#include "gltf/import.h"

#include <algorithm>

#include "base/owner.h"

namespace ups::gltf {

using extras::Error;

namespace {

// Of an object's array; none where it has no such array.
const std::vector<Json>& items_of(const Json* object, const char* array) {
  const Json* found = object ? object->find(array) : nullptr;
  return found ? found->items : empty_object().items;
}

std::string numbered(const std::string& array, size_t i) { return array + "[" + std::to_string(i) + "]"; }

}  // namespace

void Importer::check(ups_status status, const std::string& where) const {
  if (status != UPS_OK) throw Error(status, where + ": " + ups_last_error());
}

void Importer::check_part(ups_status status, const std::string& where) const {
  if (status == UPS_OK) return;
  std::string message = ups_last_error();  // "ups_fixture_add_lens: part 2 (lens): ..."
  const size_t begin = message.find("part "), end = message.find("): ");
  if (begin < end && end != std::string::npos) message.erase(begin, end + 3 - begin);
  throw Error(status, where + ": " + message);
}

void Importer::warn(const std::string& text) {
  if (warned_.insert(text).second) warnings.push_back(text);
}

void Importer::warn_about_extensions(const JsonReader& reader, std::initializer_list<std::string_view> known) {
  const JsonReader extensions = reader.object_or_empty("extensions");
  for (const auto& [name, value] : extensions.json().members) {
    (void)value;
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    warn(reader.where() + ": its extension '" + name + "' is skipped");
  }
}

void Importer::warn_about_the_rest() {
  if (!document_.model.animations.empty()) warn("animations are skipped");
  const auto look_at = [&](const Json& item, const std::string& where) {
    const Json* extras = item.find("extras");
    if (extras && extras->find("ups"))
      warn(where + ": extras.ups is skipped here; it belongs on a node, a material or a scene");
  };
  for (const char* array : {"meshes", "cameras"}) {
    const std::vector<Json>& items = items_of(&document_.json, array);
    for (size_t i = 0; i < items.size(); ++i) {
      const std::string where = numbered(array, i);
      look_at(items[i], where);
      const std::vector<Json>& primitives = items_of(&items[i], "primitives");
      for (size_t p = 0; p < primitives.size(); ++p) look_at(primitives[p], numbered(where + ".primitives", p));
    }
  }
  const Json* extensions = document_.json.find("extensions");
  for (const char* name : {"KHR_lights_punctual", "EXT_lights_ies"}) {
    const std::vector<Json>& lights = items_of(extensions ? extensions->find(name) : nullptr, "lights");
    for (size_t i = 0; i < lights.size(); ++i) look_at(lights[i], std::string(name) + " light " + std::to_string(i));
  }
  if (JsonReader(document_.json, "the file").ups_extras()) {
    warn("extras.ups at the file's top level is skipped; it belongs on a node, a material or a scene");
  }
}

void Importer::run(const std::string& path) {
  try {
    document_ = load_document(path, desc_.allow_outside == 1, warnings);
    meshes_.resize(document_.model.meshes.size());
    add_materials();
    read_scene();
    warn_about_the_rest();
  } catch (const Error& e) {
    throw Error(e.status(), path + ": " + e.what());
  }
}

}  // namespace ups::gltf

struct ups_gltf_import {
  ups::Owner<ups_gltf_import> owner;
  std::vector<ups::gltf::Sensor> sensors;
  std::vector<ups::gltf::SourceName> sources;
  ups::gltf::Places places;
  std::string warnings;
};

namespace {

using ups::extras::require;

ups::LastError last_error;

template <class Body>
ups_status guarded(Body&& body) {
  return ups::extras::guarded(last_error, body);
}

const ups::gltf::Sensor& sensor_of(const ups_gltf_import* import_result, uint32_t index) {
  ups::extras::require_handle(import_result, "import_result");
  require(index < import_result->sensors.size(), "index is not below the sensor count");
  return import_result->sensors[index];
}

const ups::gltf::SourceName& source_of(const ups_gltf_import* import_result, ups_source_kind kind, uint32_t id) {
  ups::extras::require_handle(import_result, "import_result");
  const auto& sources = import_result->sources;
  const auto found = std::find_if(sources.begin(), sources.end(),
                                  [&](const auto& source) { return source.kind == kind && source.id == id; });
  require(found != sources.end(), "no source of this kind and id comes from the file");
  return *found;
}

ups_gltf_import_desc default_desc() { return {sizeof(ups_gltf_import_desc), 0, 0, 0, 0}; }

}  // namespace

void ups_gltf_import_desc_init(ups_gltf_import_desc* desc, uint32_t struct_size) {
  ups::extras::write_defaults(desc, struct_size, default_desc());
}

ups_status ups_gltf_import_file(ups_context* context, const char* path, const ups_gltf_import_desc* desc,
                                ups_scene* scene, ups_gltf_import** out) {
  return guarded([&] {
    require(context != nullptr, "context is NULL");
    require(path != nullptr, "path is NULL");
    require(scene != nullptr, "scene is NULL");
    require(out != nullptr, "out is NULL");
    const ups_gltf_import_desc options = ups::extras::read_desc(desc, default_desc());
    require((options.camera_width == 0) == (options.camera_height == 0),
            "camera_width and camera_height must both be given or both be 0");
    require(options.allow_outside == 0 || options.allow_outside == 1, "allow_outside must be 0 or 1");
    ups::gltf::Importer importer(context, scene, options);
    importer.run(path);
    std::string warnings;
    for (const std::string& warning : importer.warnings) warnings += (warnings.empty() ? "" : "\n") + warning;
    *out = new ups_gltf_import{{}, std::move(importer.sensors), std::move(importer.sources), std::move(importer.places),
                               std::move(warnings)};
  });
}

void ups_gltf_import_destroy(ups_gltf_import* import_result) { ups::destroy(import_result); }

ups_status ups_gltf_get_sensor_count(const ups_gltf_import* import_result, uint32_t* out) {
  return guarded([&] {
    ups::extras::require_handle(import_result, "import_result");
    require(out != nullptr, "out is NULL");
    *out = uint32_t(import_result->sensors.size());
  });
}

ups_status ups_gltf_get_sensor(const ups_gltf_import* import_result, uint32_t index, ups_gltf_sensor_info* info) {
  return guarded([&] { ups::extras::write_info(sensor_of(import_result, index).info, info); });
}

ups_status ups_gltf_get_sensor_name(const ups_gltf_import* import_result, uint32_t index, char* text, size_t capacity,
                                    size_t* needed) {
  return guarded([&] { ups::extras::copy_text(sensor_of(import_result, index).name, text, capacity, needed); });
}

ups_status ups_gltf_get_source_name(const ups_gltf_import* import_result, ups_source_kind kind, uint32_t id, char* text,
                                    size_t capacity, size_t* needed) {
  return guarded([&] { ups::extras::copy_text(source_of(import_result, kind, id).name, text, capacity, needed); });
}

ups_status ups_gltf_get_source_file(const ups_gltf_import* import_result, ups_source_kind kind, uint32_t id, char* text,
                                    size_t capacity, size_t* needed) {
  return guarded([&] { ups::extras::copy_text(source_of(import_result, kind, id).file, text, capacity, needed); });
}

ups_status ups_gltf_get_place(const ups_gltf_import* import_result, ups_gltf_part part, uint32_t id, char* text,
                              size_t capacity, size_t* needed) {
  return guarded([&] {
    ups::extras::require_handle(import_result, "import_result");
    require(part >= UPS_GLTF_PART_MATERIAL && part <= UPS_GLTF_PART_FIXTURE, "part must be one of UPS_GLTF_PART_*");
    const auto found = import_result->places.find({part, id & ups::gltf::number_bits});
    require(found != import_result->places.end(), "no such part of this id comes from the file");
    ups::extras::copy_text(found->second, text, capacity, needed);
  });
}

ups_status ups_gltf_read_meters(const ups_gltf_import* import_result, uint32_t index, double* positions_m,
                                float* normals, size_t count) {
  return guarded([&] {
    const ups::gltf::Sensor& sensor = sensor_of(import_result, index);
    require(sensor.info.kind == UPS_GLTF_METERS || sensor.info.kind == UPS_GLTF_OBSERVER,
            "the sensor is not a set of meters");
    require(count == (sensor.info.kind == UPS_GLTF_OBSERVER ? 1 : sensor.info.meter_count),
            "count is not the sensor's meter_count, of an observer 1");
    require(sensor.positions_m.size() == 3 * count,
            "the sensor's meters lie on a surface; where they are the committed scene tells "
            "(ups_scene_read_meter_places)");
    if (positions_m) std::copy(sensor.positions_m.begin(), sensor.positions_m.end(), positions_m);
    if (normals) std::copy(sensor.normals.begin(), sensor.normals.end(), normals);
  });
}

ups_status ups_gltf_get_warnings(const ups_gltf_import* import_result, char* text, size_t capacity, size_t* needed) {
  return guarded([&] {
    ups::extras::require_handle(import_result, "import_result");
    ups::extras::copy_text(import_result->warnings, text, capacity, needed);
  });
}

const char* ups_gltf_last_error(void) { return last_error.get(); }
