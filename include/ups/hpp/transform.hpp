// UPS for C++17: where things stand and what they look at. See ups.hpp.
#ifndef UPS_HPP_TRANSFORM_HPP
#define UPS_HPP_TRANSFORM_HPP

#include <algorithm>
#include <array>
#include <cmath>

#include "base.hpp"

namespace ups {
inline namespace v0_1 {

using Vec3 = std::array<double, 3>;  // x, y, z; places in m

namespace detail {

inline Vec3 cross(const Vec3 &a, const Vec3 &b) noexcept {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Of length 1. Errors: INVALID_ARGUMENT where v has no direction.
inline Vec3 unit(const Vec3 &v, const char *what) {
  const bool finite = std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]);
  const double length = finite ? std::hypot(v[0], v[1], v[2]) : 0;  // which compares, and would trap
  if (length <= 0 || !std::isfinite(length))
    throw Error(UPS_ERROR_INVALID_ARGUMENT, std::string(what) + ": expected a finite length above 0");
  return {v[0] / length, v[1] / length, v[2] / length};
}

// The part of v across a unit vector, of length 1. Errors: INVALID_ARGUMENT where v lies along it within 1e-9 rad.
inline Vec3 across(const Vec3 &v, const Vec3 &axis, const char *what) {
  const Vec3 side = cross(unit(v, what), axis);
  if (std::hypot(side[0], side[1], side[2]) < 1e-9)
    throw Error(UPS_ERROR_INVALID_ARGUMENT, std::string(what) + ": lies along the axis; name another direction");
  return unit(cross(axis, side), what);
}

}  // namespace detail

// From an object's frame to the world's, or a part's to its fixture's: 3x4, row-major; the last column is the place, m.
class Transform {
 public:
  // Leaves all where it is.
  Transform() noexcept : m_{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0} {}
  // Of a desc's to_world.
  explicit Transform(const double (&m)[12]) noexcept { std::copy_n(m, 12, m_); }

  static Transform translation(double x, double y, double z) noexcept {
    return Transform({1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {x, y, z});
  }
  static Transform scale(double x, double y, double z) noexcept {
    return Transform({x, 0, 0}, {0, y, 0}, {0, 0, z}, {0, 0, 0});
  }
  // About an axis of any length > 0 through the origin, counter-clockwise as seen from its tip.
  static Transform rotation(const Vec3 &axis, double angle_rad) {
    const Vec3 a = detail::unit(axis, "axis");
    const double c = std::cos(angle_rad), s = std::sin(angle_rad), t = 1 - c;
    return Transform({c + t * a[0] * a[0], t * a[0] * a[1] + s * a[2], t * a[0] * a[2] - s * a[1]},
                     {t * a[0] * a[1] - s * a[2], c + t * a[1] * a[1], t * a[1] * a[2] + s * a[0]},
                     {t * a[0] * a[2] + s * a[1], t * a[1] * a[2] - s * a[0], c + t * a[2] * a[2]}, {0, 0, 0});
  }

  // Of a camera or an observer: local -Z points from `eye` to `target`, local +Y as far to `up` as that leaves it.
  // Errors: INVALID_ARGUMENT where eye and target are the same place, or up lies along the line of sight.
  static Transform look_at(const Vec3 &eye, const Vec3 &target, const Vec3 &up = {0, 0, 1}) {
    const Vec3 z = backwards(eye, target), y = detail::across(up, z, "up");
    return Transform(detail::cross(y, z), y, z, eye);
  }
  // Of a luminaire, a light or a fixture: its nadir, local -Z, points from `place` to `target`, C0, local +X, as far to
  // `c0` as that leaves it. Errors: as of look_at.
  static Transform aim(const Vec3 &place, const Vec3 &target, const Vec3 &c0 = {1, 0, 0}) {
    const Vec3 z = backwards(place, target), x = detail::across(c0, z, "c0");
    return Transform(x, detail::cross(z, x), z, place);
  }

  const double *data() const noexcept { return m_; }  // 12 values
  void copy_to(double (&m)[12]) const noexcept { std::copy_n(m_, 12, m); }
  Vec3 operator()(const Vec3 &point) const noexcept {
    Vec3 out;
    for (std::size_t i = 0; i < 3; ++i)
      out[i] = m_[4 * i] * point[0] + m_[4 * i + 1] * point[1] + m_[4 * i + 2] * point[2] + m_[4 * i + 3];
    return out;
  }
  // First b, then a.
  friend Transform operator*(const Transform &a, const Transform &b) noexcept {
    const Vec3 place = a({b.m_[3], b.m_[7], b.m_[11]}), origin = a({0, 0, 0});
    Transform out = translation(place[0], place[1], place[2]);
    for (std::size_t column = 0; column < 3; ++column) {
      const Vec3 tip = a({b.m_[column], b.m_[4 + column], b.m_[8 + column]});
      for (std::size_t i = 0; i < 3; ++i) out.m_[4 * i + column] = tip[i] - origin[i];
    }
    return out;
  }

 private:
  // Where the axes and the origin go.
  Transform(const Vec3 &x, const Vec3 &y, const Vec3 &z, const Vec3 &place) noexcept
      : m_{x[0], y[0], z[0], place[0], x[1], y[1], z[1], place[1], x[2], y[2], z[2], place[2]} {}
  static Vec3 backwards(const Vec3 &from, const Vec3 &target) {
    return detail::unit({from[0] - target[0], from[1] - target[1], from[2] - target[2]}, "target - place");
  }

  double m_[12];
};

}  // namespace v0_1
}  // namespace ups

#endif
