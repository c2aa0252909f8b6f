// glTF materials become the core's: metallic-roughness, thin glazing and glass, emission, alpha. What `extras.ups` says
// about scattering replaces the first two (material_extras.cpp).
#include <cmath>
#include <limits>

#include "gltf/import.h"

namespace ups::gltf {

namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();
constexpr double default_ior = 1.5;  // KHR_materials_ior
// An attenuation colour of exactly 0 would absorb without limit.
constexpr double min_attenuation = 1e-6;

struct BaseColor {
  Rgb rgb;
  double alpha;
};

BaseColor base_color(const JsonReader& material) {
  const auto factor = material.object_or_empty("pbrMetallicRoughness").numbers("baseColorFactor", 4, 0, 1);
  if (!factor) return {{1, 1, 1}, 1};
  return {{(*factor)[0], (*factor)[1], (*factor)[2]}, (*factor)[3]};
}

// KHR_materials_ior: at least 1; or 0, which stands for an index without limit, whose Fresnel reflectance is 1 at every
// angle.
constexpr double total_reflection = 0;
double ior_of(const JsonReader& material) {
  const auto ior = material.extension("KHR_materials_ior");
  const double value = ior ? ior->number("ior", default_ior, 0, unlimited) : default_ior;
  if (value != total_reflection && value < 1) ior->fail("ior", "must be a number at least 1, or 0");
  return value;
}

bool is_alpha_blended(const JsonReader& material) { return material.text("alphaMode", "OPAQUE") != "OPAQUE"; }

}  // namespace

int Importer::uv_set_of(const JsonReader& material) {
  const JsonReader pbr = material.object_or_empty("pbrMetallicRoughness");
  std::optional<int64_t> chosen;
  for (const auto& info :
       {pbr.object("baseColorTexture"), pbr.object("metallicRoughnessTexture"), material.object("normalTexture")}) {
    if (!info) continue;
    const int64_t set = info->integer("texCoord", 0, 0, 15);
    if (!chosen) chosen = set;
    if (*chosen != set) {
      warn(info->where() + ": texCoord " + std::to_string(set) +
           " is skipped, one set a material is read: " + std::to_string(*chosen));
    }
  }
  return int(chosen.value_or(0));
}

void Importer::read_core_material(const JsonReader& material, ups_material_desc& desc) {
  const JsonReader pbr = material.object_or_empty("pbrMetallicRoughness");
  store(base_color(material).rgb, desc.reflectance_rgb);
  desc.roughness = float(pbr.number("roughnessFactor", 1, 0, 1));
  desc.metallic = float(pbr.number("metallicFactor", 1, 0, 1));
  const double ior = ior_of(material);
  desc.ior = float(ior == total_reflection ? default_ior : ior);
  if (const auto info = pbr.object("baseColorTexture")) {
    desc.reflectance_texture =
        texture(material, *info, is_alpha_blended(material) ? Decode::color_with_alpha : Decode::color);
  }
  if (const auto info = pbr.object("metallicRoughnessTexture")) {
    desc.roughness_texture = texture(material, *info, Decode::green);
    if (desc.metallic > 0) desc.metallic_texture = texture(material, *info, Decode::blue);
  }
  if (const auto info = material.object("normalTexture")) {
    desc.normal_texture = texture(material, *info, Decode::normal);
    desc.normal_scale = float(info->number("scale", 1, -unlimited, unlimited));
  }
  if (ior == total_reflection) reflect_all(material, desc);
  const bool all_metal = desc.metallic == 1 && desc.metallic_texture.v == 0;
  desc.model = all_metal ? UPS_MATERIAL_METAL : UPS_MATERIAL_PLASTIC;
  if (all_metal) desc.metallic = 0;
}

// What is no metal becomes one of F0 1: no light reaches its base. Schlick's reflectance is linear in F0, so a mixture
// is one metal too.
void Importer::reflect_all(const JsonReader& material, ups_material_desc& desc) {
  if (material.extension("KHR_materials_specular"))
    warn(material.where() + ": an \"ior\" of 0 reflects all light, as KHR_materials_specular is skipped");
  const bool varies = desc.metallic_texture.v != 0 || (desc.metallic < 1 && desc.reflectance_texture.v != 0);
  if (desc.metallic > 0 && varies) {
    warn(material.where() + ": an \"ior\" of 0 in a mixture with textures: all of it is taken for metal");
  } else if (desc.metallic < 1) {
    for (float& f : desc.reflectance_rgb) f = 1 + desc.metallic * (f - 1);
    desc.reflectance_texture = {};
  }
  desc.metallic = 1;
  desc.metallic_texture = {};
}

// KHR_materials_transmission, and KHR_materials_volume with it. Replaces what read_core_material found.
void Importer::read_transmission(const JsonReader& material, ups_material_desc& desc) {
  const auto transmission = material.extension("KHR_materials_transmission");
  const double factor = transmission ? transmission->number("transmissionFactor", 0, 0, 1) : 0;
  if (factor == 0) return;
  const auto skipped = [&](const std::string& what) { warn(material.where() + ": " + what); };
  if (ior_of(material) == total_reflection) return skipped("an \"ior\" of 0 reflects all light, none is transmitted");
  if (transmission->has("transmissionTexture")) skipped("transmissionTexture is skipped");
  const JsonReader pbr = material.object_or_empty("pbrMetallicRoughness");
  if (pbr.number("metallicFactor", 1, 0, 1) > 0) skipped("metallicFactor is skipped, as the material transmits");
  if (desc.reflectance_texture.v != 0) skipped("baseColorTexture does not tint what is transmitted");
  const float roughness = desc.roughness;
  const ups_texture_id of_roughness = desc.roughness_texture, none{};
  desc.reflectance_texture = desc.roughness_texture = desc.metallic_texture = none;
  desc.metallic = desc.roughness = 0;

  const auto volume = material.extension("KHR_materials_volume");
  const Rgb color = base_color(material).rgb;
  if (volume && volume->number("thicknessFactor", 0, 0, unlimited) > 0) {
    desc.model = UPS_MATERIAL_GLASS;
    desc.roughness = roughness;
    desc.roughness_texture = of_roughness;
    if (volume->has("thicknessTexture")) skipped("thicknessTexture is skipped: the mesh is the solid");
    if (color != Rgb{1, 1, 1}) skipped("glass takes its colour from attenuationColor, baseColorFactor is skipped");
    if (factor < 1) skipped("transmissionFactor is skipped: glass transmits what its surface does not reflect");
    const double distance = volume->number("attenuationDistance", unlimited, 0, unlimited);
    const Rgb attenuation = volume->rgb("attenuationColor", {1, 1, 1}, 0, 1, false);
    for (size_t i = 0; i < 3 && volume->has("attenuationDistance"); ++i) {
      if (distance == 0) volume->fail("attenuationDistance", "must be greater than 0");
      desc.absorption_per_m_rgb[i] = float(-std::log(std::max(attenuation[i], min_attenuation)) / distance);
    }
    return;
  }
  desc.model = UPS_MATERIAL_GLAZING;
  if (factor < 1) skipped("transmissionFactor below 1: the share that is not transmitted is absorbed");
  if (roughness > 0) skipped("roughnessFactor of a thin pane is skipped: it is clear");
  // A clear pane transmits (1 - R) / (1 + R) at normal incidence, its inner reflections summed; base colour tints that.
  const double r = std::pow((desc.ior - 1.0) / (desc.ior + 1.0), 2);
  for (size_t i = 0; i < 3; ++i) desc.transmittance_rgb[i] = float(factor * color[i] * (1 - r) / (1 + r));
}

void Importer::read_emission(const JsonReader& material, ups_material_desc& desc) {
  const auto strength = material.extension("KHR_materials_emissive_strength");
  const double luminance = strength ? strength->number("emissiveStrength", 1, 0, unlimited) : 1;
  const Rgb factor = material.rgb("emissiveFactor", {0, 0, 0}, 0, unlimited, false);
  bool emits = false;
  for (size_t i = 0; i < 3; ++i) {
    desc.luminance_cd_m2[i] = float(factor[i] * luminance);
    emits = emits || factor[i] * luminance > 0;
  }
  desc.emits_both_sides = material.boolean("doubleSided", false);
  if (emits && material.has("emissiveTexture")) {
    throw extras::Error(UPS_ERROR_UNSUPPORTED,
                        material.where() +
                            ": emissiveTexture is not built yet, and leaving it out would change the "
                            "flux; use emissiveFactor alone");
  }
}

void Importer::read_alpha(const JsonReader& material, ups_material_desc& desc) {
  const std::string mode = material.text("alphaMode", "OPAQUE");
  if (mode == "MASK") {
    desc.alpha_mode = UPS_ALPHA_MASK;
  } else if (mode == "BLEND") {
    desc.alpha_mode = UPS_ALPHA_BLEND;
  } else if (mode != "OPAQUE") {
    material.fail("alphaMode", "must be OPAQUE, MASK or BLEND");
  } else {
    return;
  }
  desc.alpha = float(base_color(material).alpha);
  desc.alpha_cutoff = float(material.number("alphaCutoff", 0.5, 0, unlimited));
  if (const auto info = material.object_or_empty("pbrMetallicRoughness").object("baseColorTexture")) {
    desc.alpha_texture = texture(material, *info, Decode::color_with_alpha);
  }
}

Material Importer::add_material(const JsonReader& material) {
  ups_material_desc desc;
  ups_material_desc_init(&desc, sizeof desc);
  if (const auto extras = material.ups_extras()) {
    read_extras_material(*extras, desc);
  } else {
    read_core_material(material, desc);
    read_transmission(material, desc);
    warn_about_extensions(material, {"KHR_materials_ior", "KHR_materials_transmission", "KHR_materials_volume",
                                     "KHR_materials_emissive_strength"});
    if (material.has("occlusionTexture")) warn(material.where() + ": occlusionTexture is skipped: light is computed");
  }
  read_emission(material, desc);
  read_alpha(material, desc);
  ups_material_id id{};
  check(ups_scene_add_material(scene_, &desc, &id), material.where());
  note_place(UPS_GLTF_PART_MATERIAL, id.v, material.where());
  const bool textured = desc.reflectance_texture.v || desc.roughness_texture.v || desc.metallic_texture.v ||
                        desc.normal_texture.v || desc.alpha_texture.v;
  const bool emits = desc.luminance_cd_m2[0] > 0 || desc.luminance_cd_m2[1] > 0 || desc.luminance_cd_m2[2] > 0;
  return {id, uv_set_of(material), textured, emits};
}

void Importer::add_materials() {
  for (size_t i = 0; i < document_.model.materials.size(); ++i) {
    const std::string where = place("material", i, document_.model.materials[i].name);
    materials_.push_back(add_material(document_.element("materials", i, where)));
  }
}

const Material& Importer::default_material() {
  if (!default_material_) {
    warn("a primitive without a material gets glTF's default: a white, rough metal");
    default_material_ = add_material(JsonReader(empty_object(), "the default material"));
  }
  return *default_material_;
}

}  // namespace ups::gltf
