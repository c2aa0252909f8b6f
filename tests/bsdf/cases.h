// Materials, directions and random numbers for the tests of this folder.
#pragma once
#include <string>
#include <vector>

#include "base/rng.h"
#include "bsdf/material.h"

namespace ups::test {

struct Case {
  std::string name;
  Material material;
};

inline Material make(MaterialModel model, float roughness = 0, Rgb reflectance = Rgb(0.5f), float ior = 1.5f) {
  Material m;
  m.model = model;
  m.roughness = roughness;
  m.reflectance = reflectance;
  m.ior = ior;
  return m;
}
inline float roughness_of(float alpha) { return std::sqrt(alpha); }

// Every model at roughnesses from smooth to 1.
inline std::vector<Case> all_cases() {
  std::vector<Case> cases;
  const Rgb red{0.8f, 0.4f, 0.1f};
  cases.push_back({"matte", make(MaterialModel::matte, 0, red)});
  cases.push_back({"mirror", make(MaterialModel::mirror, 0, red)});
  Material diffuser = make(MaterialModel::diffuser, 0, {0.5f, 0.4f, 0.3f});
  diffuser.transmittance = {0.3f, 0.4f, 0.1f};
  cases.push_back({"diffuser", diffuser});
  Material pane = make(MaterialModel::glazing, 0, Rgb(0.5f), 1.52f);
  pane.transmittance = {0.8f, 0.7f, -1};
  cases.push_back({"glazing", pane});
  for (float alpha : {0.0f, 1e-4f, 0.01f, 0.1f, 0.4f, 1.0f}) {
    const float roughness = roughness_of(alpha);
    const auto add = [&](const std::string& name, const Material& m) {
      cases.push_back({name + ", alpha " + std::to_string(alpha), m});
    };
    add("plastic", make(MaterialModel::plastic, roughness, red));
    add("black plastic of ior 1.8", make(MaterialModel::plastic, roughness, Rgb(0.0f), 1.8f));
    add("metal", make(MaterialModel::metal, roughness, red));
    Material gold = make(MaterialModel::metal, roughness);
    gold.ior_rgb = {0.18f, 0.42f, 1.37f};
    gold.ior_k_rgb = {3.42f, 2.35f, 1.77f};
    add("gold", gold);
    Material mixture = make(MaterialModel::plastic, roughness, red);
    mixture.metallic = 0.3f;
    add("mixture", mixture);
    add("glass", make(MaterialModel::glass, roughness));
    add("glass of ior 1.05", make(MaterialModel::glass, roughness, Rgb(0.5f), 1.05f));
    add("glass of ior 2.4", make(MaterialModel::glass, roughness, Rgb(0.5f), 2.4f));
  }
  return cases;
}

// Unit direction of that cosine.
inline Vec3 direction(float cosine, float phi = 0.7f) {
  const float sine = std::sqrt(std::max(0.0f, (1 - cosine) * (1 + cosine)));
  return {sine * std::cos(phi), sine * std::sin(phi), cosine};
}

// Relative difference that rounding of directions (6e-8) makes in a lobe of that sharpness, when a value is computed
// from both ends: the density of half vectors varies by 4 / alpha, and refraction turns them by 1 / (ior - 1) more.
inline float rounding(const Material& m) {
  const float alpha = Bsdf(m, {0, 0}).min_alpha_continuous();
  const float bend = m.model == MaterialModel::glass ? std::min(1.0f, m.ior - 1) : 1.0f;
  return 1e-4f + 4 * 1e-7f / std::max(1e-6f, alpha * bend);
}

struct Random {
  uint32_t seed, counter = 0;
  struct Numbers {
    float lobe;
    Vec2 u;
    float other;
  };
  Numbers next() {
    const auto r = philox({counter++, 0, 0, 0}, {seed, 0x62736466u});
    return {to_unit_float(r[0]), {to_unit_float(r[1]), to_unit_float(r[2])}, to_unit_float(r[3])};
  }
};

}  // namespace ups::test
