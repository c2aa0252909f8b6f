// Triangle meshes of simple shapes, with their own area, and what a uniform Lambertian polygon or mesh gives at a point
// in closed form. Double precision; needs no engine and no test framework.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <utility>
#include <vector>

namespace ups::test {

inline constexpr double pi_d = 3.14159265358979323846;

struct P3 {
  double x = 0, y = 0, z = 0;
};
constexpr P3 operator+(const P3& a, const P3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
constexpr P3 operator-(const P3& a, const P3& b) { return {a.x - b.x, a.y - b.y, a.z - b.z}; }
constexpr P3 operator*(const P3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }
constexpr double dot(const P3& a, const P3& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
constexpr P3 cross(const P3& a, const P3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline double length(const P3& a) { return std::sqrt(dot(a, a)); }
inline P3 normalize(const P3& a) { return a * (1 / length(a)); }

// Front: counter-clockwise.
struct Shape {
  std::vector<P3> vertices;
  std::vector<std::array<uint32_t, 3>> triangles;
  std::vector<P3> normals{};                // of vertices; empty: flat
  std::vector<std::array<float, 2>> uvs{};  // of vertices; empty: none

  P3 corner(size_t triangle, int i) const { return vertices[triangles[triangle][i]]; }
  P3 area_normal(size_t t) const { return cross(corner(t, 1) - corner(t, 0), corner(t, 2) - corner(t, 0)) * 0.5; }
  P3 centroid(size_t t) const { return (corner(t, 0) + corner(t, 1) + corner(t, 2)) * (1 / 3.0); }
  double area() const {
    double sum = 0;
    for (size_t t = 0; t < triangles.size(); ++t) sum += length(area_normal(t));
    return sum;
  }
  Shape flipped() const {
    Shape s = *this;
    for (auto& t : s.triangles) std::swap(t[1], t[2]);
    return s;
  }
  Shape scaled(double factor) const {
    Shape s = *this;
    for (P3& v : s.vertices) v = v * factor;
    return s;
  }
  void append(const Shape& other) {
    const uint32_t first = uint32_t(vertices.size());
    vertices.insert(vertices.end(), other.vertices.begin(), other.vertices.end());
    for (const auto& t : other.triangles) triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  }
};

// A parallelogram from its corner; faces u x v.
inline Shape quad(const P3& corner, const P3& u, const P3& v) {
  return {{corner, corner + u, corner + u + v, corner + v}, {{0, 1, 2}, {0, 2, 3}}};
}

// Faces point outwards; flipped() makes a room.
inline Shape box(const P3& low, const P3& high) {
  const P3 d = high - low, x{d.x, 0, 0}, y{0, d.y, 0}, z{0, 0, d.z};
  Shape s = quad(low, y, x);
  for (const Shape& side :
       {quad(low + z, x, y), quad(low, x, z), quad(low + y, z, x), quad(low, z, y), quad(low + x, y, z)})
    s.append(side);
  return s;
}

inline Shape disc(const P3& center, const P3& normal, double radius, int segments) {
  const P3 n = normalize(normal), s = normalize(std::abs(n.x) < 0.9 ? cross({1, 0, 0}, n) : cross({0, 1, 0}, n));
  const P3 t = cross(n, s);
  Shape shape{{center}, {}};
  for (int i = 0; i < segments; ++i) {
    const double a = 2 * pi_d * i / segments;
    shape.vertices.push_back(center + s * (radius * std::cos(a)) + t * (radius * std::sin(a)));
    shape.triangles.push_back({0u, uint32_t(i + 1), uint32_t((i + 1) % segments + 1)});
  }
  return shape;
}

// 20 * 4^subdivisions faces, vertices on the sphere, faces outwards.
inline Shape icosphere(const P3& center, double radius, int subdivisions) {
  const double g = (1 + std::sqrt(5.0)) / 2;
  Shape s{{{-1, g, 0},
           {1, g, 0},
           {-1, -g, 0},
           {1, -g, 0},
           {0, -1, g},
           {0, 1, g},
           {0, -1, -g},
           {0, 1, -g},
           {g, 0, -1},
           {g, 0, 1},
           {-g, 0, -1},
           {-g, 0, 1}},
          {{0, 11, 5},  {0, 5, 1},  {0, 1, 7},  {0, 7, 10}, {0, 10, 11}, {1, 5, 9}, {5, 11, 4},
           {11, 10, 2}, {10, 7, 6}, {7, 1, 8},  {3, 9, 4},  {3, 4, 2},   {3, 2, 6}, {3, 6, 8},
           {3, 8, 9},   {4, 9, 5},  {2, 4, 11}, {6, 2, 10}, {8, 6, 7},   {9, 8, 1}}};
  for (int i = 0; i < subdivisions; ++i) {
    std::map<std::pair<uint32_t, uint32_t>, uint32_t> middles;
    const auto middle = [&](uint32_t a, uint32_t b) {
      const auto [it, fresh] = middles.try_emplace(std::minmax(a, b), uint32_t(s.vertices.size()));
      if (fresh) s.vertices.push_back((s.vertices[a] + s.vertices[b]) * 0.5);
      return it->second;
    };
    std::vector<std::array<uint32_t, 3>> finer;
    for (const auto& [a, b, c] : s.triangles) {
      const uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    s.triangles = std::move(finer);
  }
  for (P3& v : s.vertices) v = center + normalize(v) * radius;
  return s;
}

// E / L at a point from a uniform Lambertian polygon that lies wholly in front of the receiver (Lambert 1760; Baum et
// al. 1989, Eq. 2): half the sum over edges of angle times the cosine of the edge plane's normal. Positive where the
// polygon's front, counter-clockwise, faces the point.
inline double polygon_irradiance_factor(const std::vector<P3>& polygon, const P3& point, const P3& normal) {
  double sum = 0;
  for (size_t i = 0; i < polygon.size(); ++i) {
    const P3 a = normalize(polygon[i] - point), b = normalize(polygon[(i + 1) % polygon.size()] - point);
    const P3 c = cross(b, a);
    const double sine = length(c);
    if (sine > 0) sum += std::atan2(sine, dot(a, b)) * dot(c, normal) / sine;
  }
  return sum / 2 / length(normal);
}

// The same for a convex mesh that lies wholly in front of the receiver: no face hides another.
inline double convex_irradiance_factor(const Shape& shape, const P3& point, const P3& normal) {
  double sum = 0;
  for (size_t t = 0; t < shape.triangles.size(); ++t)
    if (dot(point - shape.centroid(t), shape.area_normal(t)) > 0)
      sum += polygon_irradiance_factor({shape.corner(t, 0), shape.corner(t, 1), shape.corner(t, 2)}, point, normal);
  return sum;
}

// Points spread evenly over the area of a mesh that is seen from inside.
struct Points {
  std::vector<P3> positions, normals;
};
inline Points points_inside(const Shape& outward, int count, uint32_t seed) {
  std::vector<double> sums;
  double sum = 0;
  for (size_t t = 0; t < outward.triangles.size(); ++t) sums.push_back(sum += length(outward.area_normal(t)));
  std::mt19937 engine(seed);
  const auto uniform = [&] { return std::generate_canonical<double, 53>(engine); };
  Points out;
  for (int i = 0; i < count; ++i) {
    const double target = sum * (i + uniform()) / count;
    const size_t t = size_t(std::lower_bound(sums.begin(), sums.end(), target) - sums.begin());
    double u = uniform(), v = uniform();
    if (u + v > 1) {
      u = 1 - u;
      v = 1 - v;
    }
    const P3 a = outward.corner(t, 0);
    out.positions.push_back(a + (outward.corner(t, 1) - a) * u + (outward.corner(t, 2) - a) * v);
    out.normals.push_back(normalize(outward.area_normal(t)) * -1);
  }
  return out;
}

}  // namespace ups::test
