// How a meter weighs light by the direction that it comes from: E = integral L(w) W(w) dw. Nothing but its kind decides
// that; where it stands, and whether it is a point or an area, is meters.h's.
#pragma once
#include <algorithm>
#include <cmath>

#include "base/frame.h"
#include "base/warp.h"
#include "ups/ups_sensor.h"

namespace ups {

// The light vector is what planar meters at one point that face the axes' ends differ in: x, -x, y, -y, z, -z. So a
// vector meter is measured as six that are never negative, and all that is known of such errors holds for them.
inline constexpr uint32_t vector_sides = 6;
inline Vec3 axis_of_side(uint32_t side) {
  const float sign = side % 2 ? -1.0f : 1.0f;
  return {side / 2 == 0 ? sign : 0.0f, side / 2 == 1 ? sign : 0.0f, side / 2 == 2 ? sign : 0.0f};
}

struct MeterResponse {
  ups_meter_kind kind = UPS_METER_PLANAR;
  // A point whose photons are counted on a disc across their direction, as it has no plane of its own: no cosine is in
  // any density there.
  bool across = false;
  uint8_t side = 0;  // of a vector

  // Of local directions. own: of the meter, n its normal. Cylinders stand upright.
  Frame frame(const Frame& own) const {
    if (kind == UPS_METER_VECTOR) return Frame(axis_of_side(side));
    if (kind == UPS_METER_CYLINDRICAL) return Frame();
    if (kind != UPS_METER_SEMICYLINDRICAL) return own;
    const Vec3 facing = normalize(Vec3(own.n.x, own.n.y, 0));
    return {facing, Vec3(-facing.y, facing.x, 0), Vec3(0, 0, 1)};
  }

  // W of a unit direction. With theta from local z and alpha from local x: planar and a vector's side, cos theta;
  // cylindrical, sin theta / pi; semicylindrical, sin theta (1 + cos alpha) / pi; hemispherical, (1 + cos theta) / 4 of
  // the upper hemisphere: the mean over a dome whose base lies on the ground; spherical, 1 / 4 (EN 13201-3 has the
  // second to fourth, per source as I / d2 times these).
  float value(const Vec3& w) const {
    switch (kind) {
      case UPS_METER_CYLINDRICAL: return inv_pi * sine(w);
      case UPS_METER_SEMICYLINDRICAL: return inv_pi * std::max(0.0f, sine(w) + w.x);
      case UPS_METER_HEMISPHERICAL: return w.z > 0 ? 0.25f * (1 + w.z) : 0.0f;
      case UPS_METER_SPHERICAL: return 0.25f;
      default: return w.z;
    }
  }
  // Directions are drawn in proportion to W.
  float total() const { return kind == UPS_METER_HEMISPHERICAL ? 0.75f * pi : pi; }  // integral W dw
  float pdf(const Vec3& w) const {
    return value(w) * (kind == UPS_METER_HEMISPHERICAL ? inv_pi / 0.75f : inv_pi);
  }
  Vec3 sample(const Vec2& u) const {
    switch (kind) {
      case UPS_METER_CYLINDRICAL:
      case UPS_METER_SEMICYLINDRICAL: return sample_cylinder(u);
      case UPS_METER_HEMISPHERICAL: return around(std::sqrt(1 + 3 * u.x) - 1, 2 * pi * u.y);
      case UPS_METER_SPHERICAL: return square_to_sphere(u);
      default: return square_to_cosine_hemisphere(u);
    }
  }

 private:
  static float sine(const Vec3& w) { return std::sqrt(w.x * w.x + w.y * w.y); }
  static Vec3 around(float z, float azimuth) {
    const float r = std::sqrt(std::max(0.0f, 1 - z * z));
    return {r * std::cos(azimuth), r * std::sin(azimuth), z};
  }
  // The height of a uniform point of a disc has the density of a direction's cosine to the axis, sin theta dz; where
  // the point lies on its chord is independent of that.
  Vec3 sample_cylinder(const Vec2& u) const {
    const Vec2 d = square_to_disc(u);
    const float half_chord = std::sqrt(std::max(0.0f, 1 - d.x * d.x)),
                turn = half_chord > 0 ? pi * std::clamp(d.y / half_chord, -1.0f, 1.0f) : 0.0f;
    return around(d.x, kind == UPS_METER_CYLINDRICAL ? turn : leaning(turn));
  }
  // Density (1 + cos alpha) / (2 pi) from a uniform turn: alpha + sin alpha = turn, by Newton's method from its limits
  // at 0 and pi.
  static float leaning(float turn) {
    const double y = std::min(double(std::abs(turn)), 3.14159265358979323846);
    double a = y < 2 ? y / 2 : 3.14159265358979323846 - std::cbrt(6 * (3.14159265358979323846 - y));
    for (int i = 0; i < 5; ++i) {
      const double slope = 1 + std::cos(a);
      if (slope > 1e-12) a -= (a + std::sin(a) - y) / slope;
    }
    return float(std::copysign(std::clamp(a, 0.0, 3.14159265358979323846), double(turn)));
  }
};

}  // namespace ups
