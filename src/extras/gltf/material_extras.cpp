// `extras.ups` of a material: scattering by measured values. What is left out keeps the C API's default.
#include <limits>

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

}  // namespace

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
    extras.allow_only({"model", "transmittance", "ior"});
    desc.model = UPS_MATERIAL_GLAZING;
    desc.ior = float(extras.number("ior", glazing_ior, 1, unlimited));
    const Rgb clear{-1, -1, -1};
    if (extras.has("transmittance")) {
      store(extras.rgb("transmittance", clear, 0, 1, true), desc.transmittance_rgb);
    } else {
      store(clear, desc.transmittance_rgb);
    }
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
