// Linear Rec.709 triples scaled so that luminance() is photometric: cd/m^2, lx, lm or cd.
#pragma once
#include <algorithm>
#include <cmath>

namespace ups {

struct Rgb {
  float r{}, g{}, b{};
  constexpr Rgb() = default;
  constexpr explicit Rgb(float v) : r(v), g(v), b(v) {}
  constexpr Rgb(float r_, float g_, float b_) : r(r_), g(g_), b(b_) {}
  constexpr Rgb& operator+=(const Rgb& o) { return *this = {r + o.r, g + o.g, b + o.b}; }
  constexpr Rgb& operator*=(const Rgb& o) { return *this = {r * o.r, g * o.g, b * o.b}; }
  constexpr Rgb& operator*=(float s) { return *this = {r * s, g * s, b * s}; }
};
constexpr Rgb operator+(const Rgb& a, const Rgb& b) { return {a.r + b.r, a.g + b.g, a.b + b.b}; }
constexpr Rgb operator-(const Rgb& a, const Rgb& b) { return {a.r - b.r, a.g - b.g, a.b - b.b}; }
constexpr Rgb operator*(const Rgb& a, const Rgb& b) { return {a.r * b.r, a.g * b.g, a.b * b.b}; }
constexpr Rgb operator*(const Rgb& a, float s) { return {a.r * s, a.g * s, a.b * s}; }
constexpr Rgb operator*(float s, const Rgb& a) { return a * s; }
constexpr Rgb operator/(const Rgb& a, float s) { return {a.r / s, a.g / s, a.b / s}; }

// Rec.709 luminance weights; metrics: luminance of an RGB whose white is Y = 1.
constexpr float luminance(const Rgb& c) { return 0.2126f * c.r + 0.7152f * c.g + 0.0722f * c.b; }
constexpr float max_component(const Rgb& c) { return std::max({c.r, c.g, c.b}); }
constexpr bool is_black(const Rgb& c) { return c.r == 0.0f && c.g == 0.0f && c.b == 0.0f; }
inline Rgb to_rgb(const float (&c)[3]) { return {c[0], c[1], c[2]}; }
inline bool is_finite(const Rgb& c) { return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b); }
inline Rgb exp(const Rgb& c) { return {std::exp(c.r), std::exp(c.g), std::exp(c.b)}; }

}  // namespace ups
