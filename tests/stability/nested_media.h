// Solids of glass and layers of it, and what a face of theirs reflects, for the tests of media that meet.
#pragma once
#include <cmath>

#include "../support/scene_builder.h"

namespace ups::test {

inline ups_material_desc absorbing(double ior, double per_m, int priority = 0, double roughness = 0) {
  ups_material_desc m = glass(ior, roughness);
  for (float& a : m.absorption_per_m_rgb) a = float(per_m);
  m.priority = priority;
  return m;
}

inline double fresnel(double cos_1, double n_1, double n_2) {  // unpolarised
  const double sine = n_1 / n_2 * std::sqrt(1 - cos_1 * cos_1);
  if (sine >= 1) return 1;
  const double cos_2 = std::sqrt(1 - sine * sine);
  const double s = (n_1 * cos_1 - n_2 * cos_2) / (n_1 * cos_1 + n_2 * cos_2);
  const double p = (n_2 * cos_1 - n_1 * cos_2) / (n_2 * cos_1 + n_1 * cos_2);
  return 0.5 * (s * s + p * p);
}

struct Layer {
  double ior, absorption_per_m, thickness_m;
};

}  // namespace ups::test
