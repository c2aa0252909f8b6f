// A material as the scene holds it, and the Bsdf built from it at one surface point.
// Material is immutable after commit; Bsdf is a small value on the stack of a walk.
#pragma once
#include "bsdf/bsdf.h"
#include "geometry/texture.h"

namespace ups {

enum class MaterialModel { matte, plastic, metal, mirror, glass, glazing, diffuser };

struct Material {
  MaterialModel model = MaterialModel::matte;
  Rgb reflectance{0.5f}, transmittance{0.0f};
  float roughness = 0, ior = 1.5f, metallic = 0;
  Rgb ior_rgb{0.0f}, ior_k_rgb{0.0f};  // metal; all k 0: reflectance is F0
  Rgb absorption_per_m{0.0f};          // glass
  const Texture* reflectance_texture = nullptr;
  const Texture* roughness_texture = nullptr;
  const Texture* metallic_texture = nullptr;
  // Emission and alpha do not scatter; they live beside this in scene/snapshot.h.
};

// Below this GGX alpha a lobe is a delta lobe in all walks (algorithms.md 2, hazard 4).
inline constexpr float min_alpha = 3e-5f;

class Bsdf {
 public:
  Bsdf(const Material& material, const Vec2& uv);

  bool has_delta() const;       // some lobe can only be sampled
  bool has_continuous() const;  // eval() is not always 0: the point can be connected to and merged at
  bool transmits() const;       // eval() or sample() can cross the surface
  bool is_solid_dielectric() const { return material_->model == MaterialModel::glass; }
  // GGX alpha of the sharpest continuous lobe; 1 for Lambertian ones; 0 where there is no continuous lobe.
  float min_alpha_continuous() const;

  Rgb eval(const Vec3& wo, const Vec3& wi, TransportMode mode) const;
  float pdf(const Vec3& wo, const Vec3& wi) const;
  // False where nothing can be sampled (absorbed, or numerically degenerate); out is then unspecified.
  // u_lobe chooses lobes (and Fresnel), u the direction; all in [0, 1).
  bool sample(const Vec3& wo, float u_lobe, const Vec2& u, TransportMode mode, BsdfSample& out) const;

 private:
  const Material* material_;
  Rgb reflectance_;
  float alpha_ = 1, metallic_ = 0;
  // Implementers: add what the models need; keep it a trivially copyable value under 128 bytes.
};

// Classes of a whole material, for the scene's analysis (scene/effects.h): over all texture values.
struct MaterialTraits {
  bool delta;       // has a delta lobe
  bool continuous;  // has a continuous lobe
  bool transmits;
  bool glossy;      // a continuous lobe with alpha < 0.2
  bool coloured;
  bool interreflects;  // any reflectance or transmittance above 0
};
MaterialTraits traits_of(const Material& material);

}  // namespace ups
