// How much light does one scattering by a rough interface return, and how much does it lose to facets that shadow each
// other? Tables behind the energy compensation of the rough models (Kelemen, Szirmay-Kalos 2001; Kulla, Conty 2017).
//
// "Missing" is 1 - directional albedo of single scattering without absorption. The tables are computed on first use,
// once or, where threads need them at the same time, by each of them (one is kept), and depend on nothing else.
//
// With compensation, albedos that should be 1 are so within 0.4 % for metal, 0.5 % for plastic of ior 1.2 to 2 (1 %
// from 1.02 to 3) and 1.3 % for glass of ior 1.05 to 3 (2.1 % at 1.02). Beyond ior 3 the tables are those of 3; a plastic
// would return up to 2.3 times the light that arrives. Computing them takes about 20 ms, once.
//
// Missing light is given back by a lobe missing(wo) * missing(wi) / (pi * average), which is reciprocal and closes the
// balance exactly when `average` is the integral of 2 mu missing(mu). It is sampled with missing_lobe_pdf().
#pragma once
#include <cstdint>

#include "base/vec.h"

namespace ups {

inline constexpr float max_rough_ior = 3;  // of plastic and glass: see above

// The interface of plastic and metal: its place in the tables, found once for all directions.
class InterfaceAlbedo {
 public:
  InterfaceAlbedo() = default;
  explicit InterfaceAlbedo(float ior);
  void set_alpha(float alpha);  // once; until then 0
  // Reflection alone, from outside: the coat of a plastic. alpha 0: the exact Fresnel reflectance. `mu` is |cos| of the
  // direction.
  float coat(float mu) const;
  float coat_average() const { return coat_average_; }  // over diffuse incidence
  // Of conductors, at Fresnel reflectance 1.
  float missing(float mu) const;
  float missing_average() const { return missing_average_; }
  float missing_lobe_pdf(float mu) const;

 private:
  float alpha_ = 0, ior_ = 1, coat_average_ = 0, missing_average_ = 0, envelopes_ = 1;
  int16_t row_ = 0, table_ = 0;
  float row_fraction_ = 0, table_fraction_ = 0;
};

// Of a dielectric's reflection and transmission together, from outside or from inside. `mu` is |cos| of the direction.
float dielectric_missing(float mu, float alpha, float ior, bool inside);
float dielectric_missing_average(float alpha, float ior, bool inside);

// The envelope that missing light follows, 1 / (1 + (mu / alpha)^2), times |cos|: a density over the hemisphere z > 0.
float missing_lobe_pdf(float mu, float alpha);
Vec3 sample_missing_lobe(float alpha, const Vec2& u);

}  // namespace ups
