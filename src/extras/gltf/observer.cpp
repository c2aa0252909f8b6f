// `extras.ups.observer` of a node: an eye whose glare is rated. It looks along local -Z, local +Y up, as cameras do.
#include "gltf/import.h"

namespace ups::gltf {

void Importer::add_observer(const JsonReader& words, const std::string& node_name, const Affine& frame) {
  words.allow_only({"name", "metric", "position_index", "ceiling_area_m2"});
  if (words.text("metric", "ugr") != "ugr") words.fail("metric", "must be ugr");
  ups_observer_desc desc;
  ups_observer_desc_init(&desc, sizeof desc);
  const std::string index = words.text("position_index", "table");
  if (index != "table" && index != "guth") words.fail("position_index", "must be table or guth");
  desc.position_index = index == "guth" ? UPS_POSITION_INDEX_GUTH : UPS_POSITION_INDEX_TABLE;
  desc.ceiling_area_m2 = float(words.number("ceiling_area_m2", 0, 0, 1e12));
  std::copy(std::begin(frame.m), std::end(frame.m), desc.to_world);
  Sensor sensor{};
  check(ups_scene_add_observer(scene_, &desc, &sensor.info.sensor), words.where());
  sensor.info.struct_size = sizeof sensor.info;
  sensor.info.kind = UPS_GLTF_OBSERVER;
  for (int k = 0; k < 3; ++k) {
    sensor.positions_m.push_back(frame.column(3)[k]);
    sensor.normals.push_back(float(-frame.column(2)[k]));
  }
  std::string name = words.text("name", "");
  if (name.empty()) name = node_name;
  sensor.name = unique_observer_name(name.empty() ? "observer" : name, words.where());
  sensors.push_back(std::move(sensor));
}

}  // namespace ups::gltf
