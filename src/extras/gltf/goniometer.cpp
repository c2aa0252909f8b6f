// `extras.ups.goniometer` of a node: a virtual goniophotometer in the node's frame, nadir local -Z, C0 local +X.
#include <cmath>

#include "gltf/import.h"

namespace ups::gltf {

namespace {

constexpr double finest_step_deg = 0.01;

ups_profile_symmetry symmetry_of(const JsonReader& words) {
  const std::string text = words.text("symmetry", "none");
  if (text == "none") return UPS_SYMMETRY_NONE;
  if (text == "axial") return UPS_SYMMETRY_AXIAL;
  if (text == "c0_c180") return UPS_SYMMETRY_C0_C180;
  if (text == "c90_c270") return UPS_SYMMETRY_C90_C270;
  if (text == "quadrants") return UPS_SYMMETRY_QUADRANTS;
  words.fail("symmetry", "must be none, axial, c0_c180, c90_c270 or quadrants");
}

// From 0 in equal steps to `last`, or as listed.
std::vector<float> angles_of(const JsonReader& words, const char* list, const char* step, double fallback, double last,
                             bool with_last) {
  std::vector<float> angles;
  if (words.has(list)) {
    if (words.has(step)) words.fail(step, std::string("and \"") + list + "\" must not both be given");
    for (const Json& item : words.array(list)) {
      if (item.kind != Json::Kind::number) words.fail(list, "must be an array of numbers");
      angles.push_back(float(item.number));
    }
    return angles;
  }
  const double width = words.number(step, fallback, finest_step_deg, last);
  const double count = std::round(last / width);
  if (std::abs(count * width - last) > 1e-6 * last) words.fail(step, "must divide " + std::to_string(int(last)));
  for (int i = 0; i < int(count) + with_last; ++i) angles.push_back(float(last * i / count));
  return angles;
}

}  // namespace

void Importer::add_goniometer(const JsonReader& words, const std::string& node_name, const Affine& frame) {
  words.allow_only({"c_deg", "gamma_deg", "c_step_deg", "gamma_step_deg", "symmetry", "name"});
  ups_goniometer_desc desc;
  ups_goniometer_desc_init(&desc, sizeof desc);
  desc.symmetry = symmetry_of(words);
  const bool axial = desc.symmetry == UPS_SYMMETRY_AXIAL;
  if (axial && (words.has("c_deg") || words.has("c_step_deg")))
    words.fail("symmetry", "axial has one plane: leave c_deg and c_step_deg out");
  const std::vector<float> c = axial ? std::vector<float>{0} : angles_of(words, "c_deg", "c_step_deg", 15, 360, false);
  const std::vector<float> gamma = angles_of(words, "gamma_deg", "gamma_step_deg", 2.5, 180, true);
  desc.c_deg = c.data();
  desc.c_count = uint32_t(c.size());
  desc.gamma_deg = gamma.data();
  desc.gamma_count = uint32_t(gamma.size());
  std::copy(std::begin(frame.m), std::end(frame.m), desc.to_world);
  Sensor sensor{};
  check(ups_scene_add_goniometer(scene_, &desc, &sensor.info.sensor), words.where());
  sensor.info.struct_size = sizeof sensor.info;
  sensor.info.kind = UPS_GLTF_GONIOMETER;
  sensor.info.columns = desc.c_count;
  sensor.info.rows = desc.gamma_count;
  std::string name = words.text("name", "");
  if (name.empty()) name = node_name;
  sensor.name = unique_name(name.empty() ? "goniometer" : name, false, words.where());
  sensors.push_back(std::move(sensor));
}

}  // namespace ups::gltf
