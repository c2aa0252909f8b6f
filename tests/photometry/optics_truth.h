// How far a mesh of an optic, and its interpolated normals, are from the true surface. Called by the tests of optics.
#pragma once
#include <gtest/gtest.h>

#include <cmath>

#include "photometry/optics.h"
#include "support/shapes.h"

namespace optics_test {

using namespace optics;
using ups::test::cross;
using ups::test::dot;
using ups::test::length;
using ups::test::normalize;
using ups::test::P3;

constexpr double deg = optics::pi / 180;
constexpr Tolerance fine{2e-5, 0.1 * deg};

inline P3 vector(const std::vector<float>& values, size_t i) {
  return {double(values[3 * i]), double(values[3 * i + 1]), double(values[3 * i + 2])};
}

// What the true surface says of a point beside it: signed distance, front positive, and the front's normal.
struct Truth {
  double distance;
  P3 normal;
};

struct Worst {
  double distance = 0, angle = 0, normal_length = 0, face_angle = 0;
};

// Over points of all triangles; `skip_radius`: around the axis angles do not count.
template <class Surface>
Worst compare(const Mesh& mesh, const Surface& surface, double skip_radius = 0) {
  Worst worst;
  constexpr int steps = 7;
  for (size_t t = 0; t < mesh.indices.size(); t += 3) {
    const uint32_t* i = &mesh.indices[t];
    const P3 a = vector(mesh.positions, i[0]), b = vector(mesh.positions, i[1]), c = vector(mesh.positions, i[2]);
    const P3 na = vector(mesh.normals, i[0]), nb = vector(mesh.normals, i[1]), nc = vector(mesh.normals, i[2]);
    for (const P3& n : {na, nb, nc}) worst.normal_length = std::max(worst.normal_length, std::abs(length(n) - 1));
    const P3 face = normalize(cross(b - a, c - a));
    for (int u = 0; u <= steps; ++u)
      for (int v = 0; u + v <= steps; ++v) {
        // Not on the edges themselves: where two facets meet, either would be right.
        const double s = 0.998 * u / steps + 0.001, w = 0.998 * v / steps + 0.0005;
        const P3 p = a * (1 - s - w) + b * s + c * w, n = normalize(na * (1 - s - w) + nb * s + nc * w);
        const Truth truth = surface(p);
        worst.distance = std::max(worst.distance, std::abs(truth.distance));
        if (std::hypot(p.x, p.y) <= skip_radius) continue;
        worst.face_angle = std::max(worst.face_angle, std::acos(std::min(1.0, dot(face, truth.normal))));
        worst.angle = std::max(worst.angle, std::atan2(length(cross(n, truth.normal)), dot(n, truth.normal)));
      }
  }
  return worst;
}

// From an implicit function: to first order, which is enough beside the surface.
inline Truth implicit(double value, const P3& gradient) { return {value / length(gradient), normalize(gradient)}; }

inline Truth paraboloid_truth(const P3& p, double f) {  // inside is the front
  return implicit(4 * f * (f - p.z) - p.x * p.x - p.y * p.y, P3{-2 * p.x, -2 * p.y, -4 * f});
}

inline void expect_within(const Worst& worst, const Tolerance& tolerance) {
  EXPECT_LE(worst.distance, tolerance.chord_m * 1.001 + 1e-8);
  EXPECT_LE(worst.angle, tolerance.normal_rad * 1.001 + 1e-6);
  EXPECT_LE(worst.normal_length, 2e-7);
  EXPECT_LT(worst.face_angle, 30 * deg);  // turned to the front
}

inline void expect_solid(const Mesh& mesh, double exact_volume, double tolerance) {
  const Topology t = topology(mesh);
  EXPECT_TRUE(t.closed);
  EXPECT_EQ(t.euler, 2);
  EXPECT_NEAR(volume(mesh) / exact_volume, 1, tolerance);
}

}  // namespace optics_test
