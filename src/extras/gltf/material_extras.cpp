// `extras.ups` of a material: scattering by measured values. What is left out keeps the C API's default.
#include <limits>
#include <set>

#include "gltf/import.h"

namespace ups::gltf {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double glazing_ior = 1.52;

Rgb as_rgb(const float (&from)[3]) { return {from[0], from[1], from[2]}; }

void read_reflectance(const JsonReader& extras, ups_material_desc& desc) {
  store(extras.rgb("reflectance", as_rgb(desc.reflectance_rgb), 0, 1, true), desc.reflectance_rgb);
}

void read_roughness(const JsonReader& extras, ups_material_desc& desc) {
  desc.roughness = float(extras.number("roughness", desc.roughness, 0, 1));
}

void read_metal(const JsonReader& extras, ups_material_desc& desc) {
  const bool has_index = extras.has("ior") || extras.has("k");
  if (has_index && extras.has("reflectance")) extras.fail("reflectance", "and \"ior\" with \"k\" exclude each other");
  if (!has_index) {
    read_reflectance(extras, desc);
    return;
  }
  if (!extras.has("ior")) extras.fail("ior", "is missing: a metal has \"reflectance\", or \"ior\" with \"k\"");
  if (!extras.has("k")) extras.fail("k", "is missing: a metal has \"reflectance\", or \"ior\" with \"k\"");
  store(extras.rgb("ior", {}, 0, unlimited, true), desc.ior_rgb);
  store(extras.rgb("k", {}, 0, unlimited, true), desc.ior_k_rgb);
  if (!(desc.ior_k_rgb[0] > 0 || desc.ior_k_rgb[1] > 0 || desc.ior_k_rgb[2] > 0)) {
    extras.fail("k", "must be greater than 0 in some channel");
  }
}

void read_diffuser(const JsonReader& extras, ups_material_desc& desc) {
  read_reflectance(extras, desc);
  store(extras.rgb("transmittance", {0, 0, 0}, 0, 1, true), desc.transmittance_rgb);
  for (size_t i = 0; i < 3; ++i) {
    if (desc.reflectance_rgb[i] + desc.transmittance_rgb[i] > 1) {
      extras.fail("transmittance", "and \"reflectance\" must not exceed 1 together");
    }
  }
}

// Shares by angle of incidence: [[0, T], ..., [90, T]].
using Curve = std::vector<std::pair<double, double>>;
Curve read_curve(const JsonReader& extras, std::string_view key) {
  Curve curve;
  for (const Json& item : extras.array(key)) {
    const bool pair = item.is_array() && item.items.size() == 2 && item.items[0].kind == Json::Kind::number &&
                      item.items[1].kind == Json::Kind::number;
    if (!pair)
      extras.fail(key, "must be an array of [degrees, share]; its element " + std::to_string(curve.size()) + " is not");
    const double angle = item.items[0].number, share = item.items[1].number;
    const bool ascends = curve.empty() ? angle == 0 : angle > curve.back().first && angle <= 90;
    if (!ascends || !(share >= 0 && share <= 1))
      extras.fail(key, "must ascend from 0 to 90 degrees, with shares in [0, 1]; its element " +
                           std::to_string(curve.size()) + " does not");
    curve.emplace_back(angle, share);
  }
  if (curve.size() < 2 || curve.back().first != 90) extras.fail(key, "must reach from 0 to 90 degrees");
  return curve;
}

float at(const Curve& curve, double angle) {
  size_t i = 1;
  while (curve[i].first < angle) ++i;
  const auto& [a, low] = curve[i - 1];
  const auto& [b, high] = curve[i];
  return float(low + (high - low) * (angle - a) / (b - a));
}

}  // namespace

// Straight lines between the angles of both curves are those of each.
void Importer::read_pane(const JsonReader& extras, ups_material_desc& desc) {
  if (!extras.has("transmittance_by_angle")) {
    if (extras.has("reflectance_by_angle"))
      extras.fail("reflectance_by_angle", "needs \"transmittance_by_angle\" beside it");
    return;
  }
  if (extras.has("transmittance"))
    extras.fail("transmittance", "and \"transmittance_by_angle\" are both there; one of them says what the pane lets "
                                 "through");
  const Curve transmittance = read_curve(extras, "transmittance_by_angle");
  const bool reflects = extras.has("reflectance_by_angle");
  const Curve reflectance = reflects ? read_curve(extras, "reflectance_by_angle") : Curve();
  std::set<double> angles;
  for (const Curve& curve : {transmittance, reflectance})
    for (const auto& [angle, share] : curve) angles.insert(angle);
  pane_ = {};
  for (const double angle : angles) {
    pane_.angle_deg.push_back(float(angle));
    pane_.transmittance.push_back(at(transmittance, angle));
    if (reflects) pane_.reflectance.push_back(at(reflectance, angle));
  }
  desc.pane_angle_count = uint32_t(angles.size());
  desc.pane_angle_deg = pane_.angle_deg.data();
  desc.pane_transmittance = pane_.transmittance.data();
  if (reflects) desc.pane_reflectance = pane_.reflectance.data();
}

void Importer::read_extras_material(const JsonReader& extras, ups_material_desc& desc) {
  const std::string model = extras.text("model", "");
  desc.metallic = 0;
  if (model == "matte") {
    extras.allow_only({"model", "reflectance"});
    desc.model = UPS_MATERIAL_MATTE;
    read_reflectance(extras, desc);
  } else if (model == "plastic") {
    extras.allow_only({"model", "reflectance", "roughness", "ior"});
    desc.model = UPS_MATERIAL_PLASTIC;
    read_reflectance(extras, desc);
    read_roughness(extras, desc);
    desc.ior = float(extras.number("ior", desc.ior, 1, unlimited));
  } else if (model == "metal") {
    extras.allow_only({"model", "reflectance", "roughness", "ior", "k"});
    desc.model = UPS_MATERIAL_METAL;
    read_metal(extras, desc);
    read_roughness(extras, desc);
  } else if (model == "mirror") {
    extras.allow_only({"model", "reflectance"});
    desc.model = UPS_MATERIAL_MIRROR;
    read_reflectance(extras, desc);
  } else if (model == "glass") {
    extras.allow_only({"model", "roughness", "ior", "absorption_per_m", "priority"});
    desc.model = UPS_MATERIAL_GLASS;
    read_roughness(extras, desc);
    desc.ior = float(extras.number("ior", desc.ior, 1, unlimited));
    store(extras.rgb("absorption_per_m", {0, 0, 0}, 0, unlimited, true), desc.absorption_per_m_rgb);
    desc.priority = int32_t(extras.integer("priority", desc.priority, std::numeric_limits<int32_t>::min(),
                                           std::numeric_limits<int32_t>::max()));
  } else if (model == "glazing") {
    extras.allow_only({"model", "transmittance", "transmittance_by_angle", "reflectance_by_angle", "ior"});
    desc.model = UPS_MATERIAL_GLAZING;
    desc.ior = float(extras.number("ior", glazing_ior, 1, unlimited));
    const Rgb clear{-1, -1, -1};
    if (extras.has("transmittance")) {
      store(extras.rgb("transmittance", clear, 0, 1, true), desc.transmittance_rgb);
    } else {
      store(clear, desc.transmittance_rgb);
    }
    read_pane(extras, desc);
  } else if (model == "diffuser") {
    extras.allow_only({"model", "reflectance", "transmittance"});
    desc.model = UPS_MATERIAL_DIFFUSER;
    read_diffuser(extras, desc);
  } else {
    extras.fail("model", "must be one of matte, plastic, metal, mirror, glass, glazing, diffuser");
  }
  const bool uses_reflectance = desc.model != UPS_MATERIAL_GLASS && desc.model != UPS_MATERIAL_GLAZING &&
                                !(desc.model == UPS_MATERIAL_METAL && extras.has("k"));
  if (uses_reflectance && !extras.has("reflectance")) {
    warn(extras.where() + ": \"reflectance\" is left out: the C API's default is taken");
  }
}

}  // namespace ups::gltf
