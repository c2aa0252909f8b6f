// Vectors, directions and affine transforms. Floats inside a path; doubles at the API and where sums accumulate.
#pragma once
#include <algorithm>
#include <cmath>

namespace ups {

inline constexpr float pi = 3.14159265358979323846f;
inline constexpr double pi_d = 3.14159265358979323846;
inline constexpr float inv_pi = 0.31830988618379067154f;

template <class T>
struct Vec2T {
  T x{}, y{};
};
using Vec2 = Vec2T<float>;

template <class T>
struct Vec3T {
  T x{}, y{}, z{};
  constexpr Vec3T() = default;
  constexpr Vec3T(T x_, T y_, T z_) : x(x_), y(y_), z(z_) {}
  template <class U>
  explicit constexpr Vec3T(const Vec3T<U>& v) : x(T(v.x)), y(T(v.y)), z(T(v.z)) {}
  constexpr T operator[](int i) const { return i == 0 ? x : i == 1 ? y : z; }
  constexpr Vec3T operator-() const { return {-x, -y, -z}; }
  constexpr Vec3T& operator+=(const Vec3T& b) { return *this = {x + b.x, y + b.y, z + b.z}; }
  constexpr Vec3T& operator*=(T s) { return *this = {x * s, y * s, z * s}; }
};
using Vec3 = Vec3T<float>;
using Vec3d = Vec3T<double>;

template <class T>
constexpr Vec3T<T> operator+(const Vec3T<T>& a, const Vec3T<T>& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
template <class T>
constexpr Vec3T<T> operator-(const Vec3T<T>& a, const Vec3T<T>& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
template <class T> constexpr Vec3T<T> operator*(const Vec3T<T>& a, T s) { return {a.x * s, a.y * s, a.z * s}; }
template <class T> constexpr Vec3T<T> operator*(T s, const Vec3T<T>& a) { return a * s; }
template <class T> constexpr Vec3T<T> operator/(const Vec3T<T>& a, T s) { return {a.x / s, a.y / s, a.z / s}; }
template <class T> constexpr T dot(const Vec3T<T>& a, const Vec3T<T>& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
template <class T> constexpr Vec3T<T> cross(const Vec3T<T>& a, const Vec3T<T>& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
template <class T> constexpr T length2(const Vec3T<T>& a) { return dot(a, a); }
template <class T> T length(const Vec3T<T>& a) { return std::sqrt(dot(a, a)); }
template <class T> Vec3T<T> normalize(const Vec3T<T>& a) { return a * (T(1) / length(a)); }
template <class T> T max_abs(const Vec3T<T>& a) { return std::max({std::abs(a.x), std::abs(a.y), std::abs(a.z)}); }
template <class T>
bool is_finite(const Vec3T<T>& a) {
  return std::isfinite(a.x) && std::isfinite(a.y) && std::isfinite(a.z);
}

// 3x4, row-major, object to world, as in the C API.
struct Affine {
  double m[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0};
  bool operator==(const Affine&) const = default;

  Vec3d point(const Vec3d& p) const {
    return {m[0] * p.x + m[1] * p.y + m[2] * p.z + m[3], m[4] * p.x + m[5] * p.y + m[6] * p.z + m[7],
            m[8] * p.x + m[9] * p.y + m[10] * p.z + m[11]};
  }
  Vec3d vector(const Vec3d& v) const {
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[4] * v.x + m[5] * v.y + m[6] * v.z,
            m[8] * v.x + m[9] * v.y + m[10] * v.z};
  }
  Vec3d column(int c) const { return {m[c], m[4 + c], m[8 + c]}; }
  double determinant() const { return dot(column(0), cross(column(1), column(2))); }
};

// Turns normals as an Affine turns surfaces, up to length, by its cofactors; a mirroring transform keeps the side.
struct NormalMatrix {
  Vec3d x, y, z;
  explicit NormalMatrix(const Affine& m)
      : x(cross(m.column(1), m.column(2))), y(cross(m.column(2), m.column(0))), z(cross(m.column(0), m.column(1))) {}
  Vec3d operator*(const Vec3d& n) const { return x * n.x + y * n.y + z * n.z; }
};

}  // namespace ups
