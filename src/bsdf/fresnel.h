// How much of the light is reflected at a smooth interface: exact Fresnel reflectances of unpolarised light, and their
// means over diffuse incidence. Used by every model that has an interface.
#pragma once
#include <algorithm>
#include <cmath>

#include "base/rgb.h"

namespace ups {

// Cosine of refraction for eta = n_t / n_i; 0 under total internal reflection. As (eta^2 - 1) + cos^2 it neither
// cancels at grazing incidence nor loses eta = 1, which passes straight on.
inline float refracted_cosine(float cos_i, float eta) {
  const float square = (eta - 1) * (eta + 1) + cos_i * cos_i;
  return square > 0 ? std::min(1.0f, std::sqrt(square) / eta) : 0.0f;
}

struct PolarisedReflectance {
  float s, p;
};
inline PolarisedReflectance fresnel_polarised(float cos_i, float eta) {
  const float cos_t = refracted_cosine(cos_i, eta);
  if (!(cos_t > 0) || !(cos_i > 0)) return {1, 1};
  const float s = (cos_i - eta * cos_t) / (cos_i + eta * cos_t), p = (eta * cos_i - cos_t) / (eta * cos_i + cos_t);
  return {s * s, p * p};
}
inline float fresnel_dielectric(float cos_i, float eta) {
  const PolarisedReflectance r = fresnel_polarised(cos_i, eta);
  return std::min(1.0f, 0.5f * (r.s + r.p));
}
inline float normal_reflectance(float ior) { return (ior - 1) * (ior - 1) / ((ior + 1) * (ior + 1)); }

// Reflectance of diffuse light from the thin side of an interface, ior > 1 (Walsh 1926; in the form of Duntley 1942).
// From the dense side it is 1 - (1 - this) / ior^2.
inline float diffuse_fresnel_reflectance(float ior) {
  constexpr double thin = 1.001;  // below, the terms cancel; the function is almost straight
  if (!(ior > 1)) return 0;
  const double n = std::max(double(ior), thin), n2 = n * n, n4 = n2 * n2, a = n2 + 1, b = n4 - 1;
  const double r = 0.5 + (n - 1) * (3 * n + 1) / (6 * (n + 1) * (n + 1)) +
                   n2 * (n2 - 1) * (n2 - 1) / (a * a * a) * std::log((n - 1) / (n + 1)) -
                   2 * n2 * n * (n2 + 2 * n - 1) / (a * b) + 8 * n4 * (n4 + 1) / (a * b * b) * std::log(n);
  return float(ior < thin ? r * (double(ior) - 1) / (thin - 1) : r);
}

// Schlick 1994; f0 is the reflectance at normal incidence. Its mean over diffuse incidence is f0 + (1 - f0) / 21.
inline Rgb fresnel_schlick(float cos_i, const Rgb& f0) {
  const float m = std::clamp(1 - cos_i, 0.0f, 1.0f), m2 = m * m, m5 = m2 * m2 * m;
  return f0 * (1 - m5) + Rgb(m5);
}
inline Rgb fresnel_schlick_average(const Rgb& f0) { return f0 * (20.0f / 21) + Rgb(1.0f / 21); }

// Exact reflectance of a conductor of complex index n + ik (Born, Wolf, "Principles of Optics", 14.2).
inline float fresnel_conductor(float cos_i, float n, float k) {
  const float c2 = cos_i * cos_i, s2 = 1 - c2;
  const float t = n * n - k * k - s2, a2b2 = std::sqrt(t * t + 4 * n * n * k * k);
  const float a = std::sqrt(std::max(0.0f, 0.5f * (a2b2 + t)));
  const float sum = a2b2 + c2, cross = 2 * a * cos_i;
  const float denominator_s = sum + cross;
  if (!(denominator_s > 0)) return 1;
  const float s = (sum - cross) / denominator_s;
  const float sum_p = c2 * a2b2 + s2 * s2, cross_p = cross * s2;
  const float denominator_p = sum_p + cross_p;
  const float p = denominator_p > 0 ? s * (sum_p - cross_p) / denominator_p : s;
  return std::clamp(0.5f * (s + p), 0.0f, 1.0f);
}
inline Rgb fresnel_conductor(float cos_i, const Rgb& n, const Rgb& k) {
  return {fresnel_conductor(cos_i, n.r, k.r), fresnel_conductor(cos_i, n.g, k.g), fresnel_conductor(cos_i, n.b, k.b)};
}
// Over diffuse incidence: the integral of 2 c F(c) by Gauss points for the weight 2c on [0, 1].
inline Rgb fresnel_conductor_average(const Rgb& n, const Rgb& k) {
  constexpr float cosine[3] = {0.2123405382f, 0.5905331356f, 0.9114120405f};
  constexpr float weight[3] = {0.1396539556f, 0.4584822063f, 0.4018638381f};
  Rgb sum;
  for (int i = 0; i < 3; ++i) sum += fresnel_conductor(cosine[i], n, k) * weight[i];
  return sum;
}

}  // namespace ups
