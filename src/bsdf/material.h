// A material as the scene holds it, and the Bsdf built from it at one surface point.
// Material is immutable after commit; Bsdf is a small value on the stack of a walk.
#pragma once
#include <cstdint>
#include <memory>
#include <optional>

#include "bsdf/albedo.h"
#include "bsdf/bsdf.h"
#include "bsdf/pane_table.h"
#include "geometry/texture.h"

namespace ups {

enum class MaterialModel { matte, plastic, metal, mirror, glass, glazing, diffuser };

struct Material {
  MaterialModel model = MaterialModel::matte;
  Rgb reflectance{0.5f}, transmittance{0.0f};
  float roughness = 0, ior = 1.5f, metallic = 0;
  Rgb ior_rgb{0.0f}, ior_k_rgb{0.0f};  // metal; all k 0: reflectance is F0
  Rgb absorption_per_m{0.0f};          // glass
  std::shared_ptr<const PaneTable> pane;  // glazing; null: by Fresnel's equations and transmittance
  int32_t priority = 0;                // glass: the higher one counts where solids overlap
  const Texture* reflectance_texture = nullptr;
  const Texture* roughness_texture = nullptr;
  const Texture* metallic_texture = nullptr;
  std::optional<InterfaceAlbedo> interface_albedo;  // of plastic and metal; without alpha where that is textured
  Rgb conductor_average{0.0f};                      // with it: of metal whose ior_k_rgb is given
  // Emission and alpha do not scatter; they live beside this in scene/snapshot.h.
};

// Fills interface_albedo and conductor_average: without, they are found at every point.
void prepare_interface(Material& material);

// Below this GGX alpha a lobe is a delta lobe in all walks.
inline constexpr float min_alpha = 3e-5f;

// Sharper continuous lobes are called glossy.
inline constexpr float default_glossy_alpha = 0.2f;

// One interface and no diffuse base.
inline bool is_interface_alone(MaterialModel model, float metallic) {
  return model == MaterialModel::metal || model == MaterialModel::glass ||
         (model == MaterialModel::plastic && metallic >= 1);
}

// How light from one direction divides among the lobes of plastic and metal, and the probabilities to sample them.
struct Division {
  float mu = -1;                // |cos| of the direction; negative: none
  float base = 0, missing = 0;  // share of light that reaches the base; that single scattering by metal loses
  float p_interface = 0, p_base = 0, p_missing = 0;
};

// What the models (bsdf/models.h) read: the material at one surface point, with what is the same for all directions.
struct BsdfParameters {
  const Material* material;
  Rgb reflectance;    // textured
  Rgb transmittance;  // diffuser
  float alpha = 0;    // of the interface; 0: smooth, its lobe is a delta lobe
  float metallic = 0;
  float ior = 1;         // glass: of the denser side over the other one, so at least 1
  bool flipped = false;  // glass: the denser side is in front
  bool has_delta = false, transmits_continuously = false, is_caster = false;  // what Bsdf answers, found once
  InterfaceAlbedo interface_albedo;  // plastic, metal
  // Lobes that close the energy balance of a rough interface, see bsdf/albedo.h.
  Rgb base, multiple;                   // share of the diffuse base; of light scattered repeatedly by metal
  float base_norm = 0;                  // 1 / (pi (1 - mean albedo of the coat))
  float missing_norm[2] = {0, 0};       // 1 / (pi mean missing albedo), outside and inside
  float missing_reflected[2] = {1, 1};  // share of the missing light that stays on its side
  mutable Division division;            // the last that was found: of a vertex's own direction it is asked again
  float min_alpha_continuous = 0;       // what Bsdf answers
};

// What is left of a material's textures at one point.
struct Textured {
  Rgb reflectance;
  float alpha = 0, metallic = 0;  // as in BsdfParameters
  Textured() = default;
  Textured(const Material& material, const Vec2& uv, float relative_ior);
};

// `reflectance` of a plastic is the share of the light that enters its coat and comes out again; the total at an angle
// is coat + reflectance * (1 - coat).
class Bsdf {
 public:
  Bsdf(const Material& material, const Vec2& uv) : Bsdf(material, uv, material.ior) {}
  // relative_ior: of what lies behind a surface of glass over what lies in front of it. Others do not read it.
  Bsdf(const Material& material, const Vec2& uv, float relative_ior)
      : Bsdf(material, relative_ior, Textured(material, uv, relative_ior)) {}
  Bsdf(const Material& material, float relative_ior, const Textured& textured);
  Textured textured() const;

  bool has_delta() const { return p_.has_delta; }  // some lobe can only be sampled
  // eval() is not always 0: the point can be connected to and merged at.
  bool has_continuous() const { return min_alpha_continuous() > 0; }
  bool chooses_lobe() const {  // sample() reads u_lobe
    return p_.material->model != MaterialModel::matte && p_.material->model != MaterialModel::mirror;
  }
  bool transmits() const;      // eval() or sample() can cross the surface
  bool transmits_continuously() const { return p_.transmits_continuously; }  // eval() can
  bool is_solid_dielectric() const { return p_.material->model == MaterialModel::glass; }
  // Scatters by one interface sharper than this GGX alpha and has no diffuse base: what SPPM calls glossy.
  bool is_glossy(float below_alpha) const {
    return p_.alpha > 0 && p_.alpha < below_alpha && is_interface_alone(p_.material->model, p_.metallic);
  }
  // A continuous lobe is so sharp that it casts caustics as a mirror does, and has most of the light.
  bool is_caster() const { return p_.is_caster; }
  // GGX alpha of the sharpest continuous lobe; 1 for Lambertian ones; 0 where there is no continuous lobe.
  float min_alpha_continuous() const { return p_.min_alpha_continuous; }

  // All continuous lobes.
  Scattering evaluate(const Vec3& wo, const Vec3& wi, TransportMode mode) const;
  Rgb eval(const Vec3& wo, const Vec3& wi, TransportMode mode) const { return evaluate(wo, wi, mode).value; }
  float pdf(const Vec3& wo, const Vec3& wi) const { return evaluate(wo, wi, TransportMode::importance).pdf; }
  // False where nothing can be sampled (absorbed, or numerically degenerate); out is then unspecified.
  // u_lobe chooses lobes (and Fresnel), u the direction; all in [0, 1).
  bool sample(const Vec3& wo, float u_lobe, const Vec2& u, TransportMode mode, BsdfSample& out) const;

 private:
  BsdfParameters p_;
};

// A surface's own colour, for people and filters: the reflectance of its material as given, of a diffuser with its
// transmittance, of a metal that facing its normal; glass and panes are white.
Rgb base_colour(const Material& material, const Vec2& uv);

// A thin pane at an angle of incidence: what it reflects and lets straight through, with all reflections between its two
// faces, and the probability that a walk is reflected.
struct PaneCrossing {
  Rgb reflectance, transmittance;
  float reflected = 0;
};
PaneCrossing cross_pane(const Material& glazing, float cosine);

// What a mirror or pane reflects at an angle of incidence, and the probability that a walk is reflected.
struct MirrorLobe {
  Rgb reflectance;
  float probability = 0;
};
MirrorLobe mirror_lobe(const Material& mirror_or_glazing, float cosine);

// Classes of a whole material, for the scene's analysis (scene/effects.h): over all texture values.
struct MaterialTraits {
  bool delta;       // has a delta lobe
  bool continuous;  // has a continuous lobe
  bool transmits;
  bool glossy;  // a continuous lobe with alpha < default_glossy_alpha, of glass as narrow as such
  bool caster;  // a delta lobe, or Bsdf::is_caster
  bool coloured;
  bool interreflects;  // any reflectance or transmittance above 0
};
MaterialTraits traits_of(const Material& material);

// Over all texture values: is it glossy somewhere (Bsdf::is_glossy), does it have another continuous lobe somewhere?
struct GlossyParts {
  bool glossy, other;
};
GlossyParts glossy_parts(const Material& material, float below_alpha);

}  // namespace ups
