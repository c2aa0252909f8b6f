// See effects.h.
#include "scene/effects.h"

#include "ups/ups_scene.h"

namespace ups {
namespace {

const char* name_of(MaterialModel model) {
  switch (model) {
    case MaterialModel::matte:
      return "matte";
    case MaterialModel::plastic:
      return "plastic";
    case MaterialModel::metal:
      return "metal";
    case MaterialModel::mirror:
      return "mirror";
    case MaterialModel::glass:
      return "glass";
    case MaterialModel::glazing:
      return "glazing";
    case MaterialModel::diffuser:
      return "diffuser";
  }
  return "material";
}

bool is_coloured(const Rgb& c) {
  const float spread = max_component(c) - std::min({c.r, c.g, c.b});
  return spread > 1e-5f * max_component(c);
}

class Analysis {
 public:
  explicit Analysis(const Snapshot& scene) : scene_(scene) {
    for (const Material& m : scene.materials) traits_.push_back(traits_of(m));
    for (size_t i = 0; i < scene.instances.size(); ++i)
      traits_[scene.instances[i].material].delta |= is_shining_pane(scene, i);
  }

  std::string materials(const std::function<bool(size_t)>& has) const {
    return materials_of(scene_, [&](const Material& m) { return has(size_t(&m - scene_.materials.data())); });
  }
  std::string materials(bool MaterialTraits::*trait) const {
    return materials([&](size_t i) { return traits_[i].*trait; });
  }

  SceneEffects find() const;

 private:
  bool is_textured(size_t i) const {
    const Material& m = scene_.materials[i];
    const SurfaceTexturing& t = scene_.texturing[i];
    return m.reflectance_texture || m.roughness_texture || m.metallic_texture || t.normal || t.alpha;
  }
  bool has_coloured_emitter() const {
    for (size_t i = 0; i < scene_.emitters.size(); ++i)
      if (is_coloured(scene_.emitters[i].flux_rgb())) return true;
    return false;
  }
  bool has_ray_emitter() const {
    for (size_t i = 0; i < scene_.emitters.size(); ++i)
      if (scene_.emitters[i].kind() == EmitterKind::rays) return true;
    return false;
  }
  bool has_delta_emitter() const {
    for (size_t i = 0; i < scene_.emitters.size(); ++i)
      if (scene_.emitters[i].is_delta()) return true;
    return false;
  }

  const Snapshot& scene_;
  std::vector<MaterialTraits> traits_;
};

SceneEffects Analysis::find() const {
  SceneEffects out;
  const auto add = [&](uint32_t effect, const std::string& line) {
    out.effects |= effect;
    out.text += line + "\n";
  };
  const std::string delta = materials(&MaterialTraits::delta), glossy = materials(&MaterialTraits::glossy);
  const std::string passes = materials(&MaterialTraits::transmits),
                    reflects = materials(&MaterialTraits::interreflects);
  const std::string coloured = materials(&MaterialTraits::coloured);
  const std::string textured = materials([&](size_t i) { return is_textured(i); });
  const std::string receiver = materials(&MaterialTraits::continuous);
  const std::string caster = delta.empty() ? glossy : delta;

  if (!delta.empty())
    add(UPS_EFFECT_SPECULAR_REFLECTION, "specular_reflection: " + delta + " has an ideal reflection or refraction");
  if (!passes.empty()) add(UPS_EFFECT_TRANSMISSION, "transmission: " + passes + " lets light through");
  if (!caster.empty() && scene_.emitters.size() > 0 && (!receiver.empty() || !scene_.meter_sets.empty()))
    add(UPS_EFFECT_CAUSTICS, "caustics: " + caster + " can focus light on " + (receiver.empty() ? "meters" : receiver));
  if (!glossy.empty()) add(UPS_EFFECT_GLOSSY, "glossy: " + glossy + " has a narrow lobe (as of a GGX alpha below 0.2)");
  if (!reflects.empty())
    add(UPS_EFFECT_INTERREFLECTION, "interreflection: " + reflects + " passes light on to other surfaces");
  if (!coloured.empty())
    add(UPS_EFFECT_COLOUR, "colour: " + coloured + " is coloured");
  else if (has_coloured_emitter())
    add(UPS_EFFECT_COLOUR, "colour: an emitter is coloured");
  if (!textured.empty()) add(UPS_EFFECT_TEXTURES, "textures: " + textured + " has textures");

  out.ray_emitters = has_ray_emitter();
  out.path_tracing_complete =
      (delta.empty() || !has_delta_emitter() || scene_.flat_mirrors.complete) && !out.ray_emitters;
  out.sharp_caster = !caster.empty();
  out.casts = !materials(&MaterialTraits::caster).empty();
  out.images_suffice = glossy.empty() && scene_.flat_mirrors.complete && scene_.flat_mirrors.of_all;
  out.transmits_solid = !materials([&](size_t i) { return scene_.materials[i].model == MaterialModel::glass; }).empty();
  out.coloured = (out.effects & UPS_EFFECT_COLOUR) != 0;
  return out;
}

}  // namespace

SceneEffects find_effects(const Snapshot& scene) { return Analysis(scene).find(); }

std::string materials_of(const Snapshot& scene, const std::function<bool(const Material&)>& holds) {
  std::string text;
  size_t more = 0;
  for (size_t i = 0; i < scene.materials.size(); ++i) {
    if (!holds(scene.materials[i])) continue;
    if (text.empty())
      text = "material " + std::to_string(scene.material_numbers[i]) + " (" + name_of(scene.materials[i].model) + ")";
    else
      ++more;
  }
  return more ? text + " and " + std::to_string(more) + " more" : text;
}

}  // namespace ups
