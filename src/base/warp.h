// Maps from the unit square to the domains that light transport samples, with their inverses and densities.
#pragma once
#include "base/vec.h"

namespace ups {

// Of an angle in [-pi/4, pi/4], each within 1e-7: by the polynomials of Moshier's Cephes library (sinf.c).
inline Vec2 cosine_and_sine(float angle) {
  const float x = angle, x2 = x * x;
  const float c = (2.443315711809948e-5f * x2 - 1.388731625493765e-3f) * x2 + 4.166664568298827e-2f;
  const float s = (-1.9515295891e-4f * x2 + 8.3321608736e-3f) * x2 - 1.6666654611e-1f;
  return {c * (x2 * x2) - 0.5f * x2 + 1, s * (x2 * x) + x};
}

// Concentric map (Shirley, Chiu 1997) onto the unit disc; density 1/pi.
inline Vec2 square_to_disc(const Vec2& u) {
  const float a = 2 * u.x - 1, b = 2 * u.y - 1;
  if (a == 0 && b == 0) return {0, 0};
  const bool first = std::abs(a) > std::abs(b);
  const float r = first ? a : b, other = first ? b : a;
  const Vec2 q = cosine_and_sine((pi / 4) * (other / r));  // from the axis that r lies along
  const float along = r * q.x, across = r * q.y;
  return {first ? along : across, first ? across : along};
}

inline Vec2 disc_to_square(const Vec2& d) {
  if (d.x == 0 && d.y == 0) return {0.5f, 0.5f};
  const bool first = std::abs(d.x) > std::abs(d.y);
  const float r = std::copysign(std::hypot(d.x, d.y), first ? d.x : d.y);
  const float other = r * (4 * inv_pi) * std::atan(first ? d.y / d.x : d.x / d.y);
  return {0.5f + 0.5f * (first ? r : other), 0.5f + 0.5f * (first ? other : r)};
}

// Cosine-weighted about +z; density z/pi.
inline Vec3 square_to_cosine_hemisphere(const Vec2& u) {
  const Vec2 d = square_to_disc(u);
  return {d.x, d.y, std::sqrt(std::max(0.0f, 1 - d.x * d.x - d.y * d.y))};
}
inline float cosine_hemisphere_pdf(float cos_theta) { return std::max(0.0f, cos_theta) * inv_pi; }

inline Vec3 square_to_sphere(const Vec2& u) {
  const float z = 1 - 2 * u.x, r = std::sqrt(std::max(0.0f, 1 - z * z)), phi = 2 * pi * u.y;
  return {r * std::cos(phi), r * std::sin(phi), z};
}
inline Vec2 sphere_to_square(const Vec3& w) {
  const float turns = std::atan2(w.y, w.x) * (0.5f * inv_pi);
  return {0.5f - 0.5f * w.z, turns < 0 ? turns + 1 : turns};
}
inline constexpr float sphere_pdf = 0.25f * inv_pi;

// Uniform barycentrics (u, v) of a triangle, weights (1-u-v, u, v). Area-preserving and continuous (Heitz 2019).
inline Vec2 square_to_triangle(const Vec2& u) {
  float a = u.x, b = u.y;
  if (b > a) {
    a *= 0.5f;
    b -= a;
  } else {
    b *= 0.5f;
    a -= b;
  }
  return {a, b};
}

}  // namespace ups
