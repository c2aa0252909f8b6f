// Sources of a node: KHR_lights_punctual, EXT_lights_ies, and the luminaires of `extras.ups`. Each photometric file is
// parsed once.
#include <cmath>
#include <limits>

#include "gltf/import.h"
#include "platform/paths.h"

namespace ups::gltf {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double quarter_pi = 0.78539816339744831;

// Where files beside it are looked for; a bare name lies in the working folder, not nowhere.
std::string folder_of(const std::string& file) {
  const std::string folder = platform::folder_of(file);
  return folder.empty() ? "." : folder;
}

// Index into the lights of an extension at the file's top level.
JsonReader light_of(const Json& document, const JsonReader& use, const char* name) {
  const auto top = JsonReader(document, "the file").extension(name);
  const std::vector<Json> none;
  const std::vector<Json>& lights = top ? top->array("lights") : none;
  const int64_t index = use.integer("light", -1, 0, std::numeric_limits<int32_t>::max());
  if (index < 0 || size_t(index) >= lights.size()) {
    use.fail("light",
             "is missing or out of range: the file has " + std::to_string(lights.size()) + " lights of " + name);
  }
  return JsonReader(lights[size_t(index)], std::string(name) + " light " + std::to_string(index));
}

}  // namespace

void Importer::add_punctual_light(const JsonReader& node, const Affine& frame) {
  const JsonReader light = light_of(document_.json, *node.extension("KHR_lights_punctual"), "KHR_lights_punctual");
  const std::string where = node.where() + ", " + light.where();
  const std::string type = light.text("type", "");
  ups_light_desc desc;
  ups_light_desc_init(&desc, sizeof desc);
  if (type == "point") {
    desc.kind = UPS_LIGHT_POINT;
  } else if (type == "directional") {
    desc.kind = UPS_LIGHT_DIRECTIONAL;
  } else if (type == "spot") {
    desc.kind = UPS_LIGHT_SPOT;
    const JsonReader spot = light.object_or_empty("spot");
    constexpr double half_pi = double(float(2 * quarter_pi));  // as exporters write it
    desc.inner_cone_rad = float(spot.number("innerConeAngle", 0, 0, half_pi));
    desc.outer_cone_rad = float(spot.number("outerConeAngle", quarter_pi, 0, half_pi));
    if (desc.inner_cone_rad > desc.outer_cone_rad || desc.outer_cone_rad == 0)
      spot.fail("innerConeAngle", "must be less than outerConeAngle");
    if (desc.inner_cone_rad == desc.outer_cone_rad) {  // a sharp edge, by Blender and three.js
      desc.inner_cone_rad = std::nextafter(desc.outer_cone_rad, 0.0f);
      warn(spot.where() + ": innerConeAngle is outerConeAngle; it is taken to be a little less");
    }
  } else {
    light.fail("type", "must be point, spot or directional");
  }
  const double intensity = light.number("intensity", 1, 0, unlimited);
  const Rgb color = light.rgb("color", {1, 1, 1}, 0, unlimited, false);
  store({color[0] * intensity, color[1] * intensity, color[2] * intensity}, desc.intensity_rgb);
  std::copy(std::begin(frame.m), std::end(frame.m), desc.to_world);
  desc.group = group_;
  ups_luminaire_id id{};
  check(ups_scene_add_light(scene_, &desc, &id), where);
  name_source(UPS_SOURCE_LUMINAIRE, id.v, "luminaire");
}

void Importer::add_ies_light(const JsonReader& node, const Affine& frame) {
  const JsonReader use = *node.extension("EXT_lights_ies");
  const JsonReader light = light_of(document_.json, use, "EXT_lights_ies");
  std::string where = node.where() + ", " + light.where();
  ups_luminaire_desc desc;
  ups_luminaire_desc_init(&desc, sizeof desc);
  if (light.has("uri") == light.has("bufferView")) light.fail("uri", "or \"bufferView\" must be given, and not both");
  if (light.has("uri")) {
    const std::string uri = light.text("uri", "");
    const bool embedded = is_data_uri(uri);
    if (!embedded) where += ", file '" + uri + "'";
    const std::string folder = embedded ? "" : folder_of(platform::joined(document_.folder, percent_decoded(uri)));
    const std::string name = embedded ? light.where() : "uri " + uri;
    desc.profile = profile({name, name, read_uri(document_, uri, where), folder}, where);
  } else {
    const int64_t view = light.integer("bufferView", 0, 0, std::numeric_limits<int32_t>::max());
    const ByteRange range = buffer_view(document_, int(view), where);
    desc.profile = profile({light.where(), light.where(), Bytes(range.data, range.data + range.size), {}}, where);
  }
  Rgb color = use.rgb("color", {1, 1, 1}, 0, unlimited, false);
  if (*std::max_element(color.begin(), color.end()) > 1) {
    for (double& c : color) c = std::min(c, 1.0);
    warn(where + ": color is more than 1, to which EXT_lights_ies clamps it; multiplier may be more");
  }
  const double y = luminance(color);
  // The core takes chromaticity and scale apart; the extension's colour multiplies each component.
  store(y > 0 ? color : Rgb{1, 1, 1}, desc.color_rgb);
  desc.intensity_scale = float(use.number("multiplier", 1, 0, unlimited) * y);
  desc.use_opening = 0;  // the extension: "infinitely small points"
  std::copy(std::begin(frame.m), std::end(frame.m), desc.to_world);
  desc.group = group_;
  ups_luminaire_id id{};
  check(ups_scene_add_luminaire(scene_, &desc, &id), where);
  const std::string uri = light.text("uri", "");
  name_source(UPS_SOURCE_LUMINAIRE, id.v, "luminaire", is_data_uri(uri) ? "" : uri);
}

void Importer::add_luminaire(const JsonReader& luminaire, const Affine& frame) {
  luminaire.allow_only(
      {"file", "flux_lm", "dimming", "colour_temperature_k", "color", "opening", "tilt_deg", "lamp_set"});
  const std::string file = luminaire.text("file", "");
  if (file.empty())
    luminaire.fail("file", "is missing: the name of a file beside the scene, IES, EULUMDAT, TM-33 or rays");
  const std::string where = luminaire.where() + ", file '" + file + "'";
  ups_luminaire_desc desc;
  ups_luminaire_desc_init(&desc, sizeof desc);
  const std::string path = platform::joined(document_.folder, file);
  ProfileFile source{"file " + file, file, read_beside(document_, path, luminaire.where()), folder_of(path)};
  if (luminaire.has("tilt_deg")) source.tilt_deg = float(luminaire.number("tilt_deg", 0, 0, 180));
  source.lamp_set = uint32_t(luminaire.integer("lamp_set", 0, 0, 999));
  desc.profile = profile(source, where);
  desc.use_opening = luminaire.boolean("opening", true);
  desc.dimming = float(luminaire.number("dimming", 1, 0, largest_float));
  if (luminaire.has("flux_lm")) desc.flux_lm = float(luminaire.number("flux_lm", 0, 0, largest_float));
  if (luminaire.has("color")) {
    if (luminaire.has("colour_temperature_k"))
      luminaire.fail("color", "and \"colour_temperature_k\" exclude each other");
    const Rgb color = luminaire.rgb("color", {1, 1, 1}, 0, unlimited, false);
    if (!(luminance(color) > 0)) luminaire.fail("color", "must have a component above 0: it is a chromaticity alone");
    store(color, desc.color_rgb);
  }
  read_colour_temperature(luminaire, desc.color_rgb);
  std::copy(std::begin(frame.m), std::end(frame.m), desc.to_world);
  desc.group = group_;
  ups_luminaire_id id{};
  check(ups_scene_add_luminaire(scene_, &desc, &id), where);
  name_source(UPS_SOURCE_LUMINAIRE, id.v, "luminaire", file);
}

}  // namespace ups::gltf
