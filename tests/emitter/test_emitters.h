// The emitters that the tests of this folder share, their numbers, and how samples are judged.
#pragma once
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <random>
#include <vector>

#include "base/frame.h"
#include "emitter/area.h"
#include "emitter/point.h"
#include "emitter/profile.h"
#include "emitter/rays.h"
#include "support/chi_square.h"

namespace ups::test {

constexpr float largest_u = 0x1.fffffep-1f;

constexpr double false_alarm = 1e-4;

// worst: a density that is off by so much, root mean square, is found in 97.7 of 100 cases.
inline void expect_fit(const std::vector<double>& observed, const std::vector<double>& expected, double worst) {
  const ChiSquareResult r = chi_square_test(observed, expected);
  ASSERT_GT(r.degrees_of_freedom, 4);
  EXPECT_GT(r.p_value, false_alarm) << r.statistic << " / " << r.degrees_of_freedom;
  const double samples = std::accumulate(expected.begin(), expected.end(), 0.0);
  EXPECT_LE(smallest_found(samples, r.degrees_of_freedom, false_alarm), worst) << "too few samples to judge";
}

class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  float operator()() { return float(engine_() >> 8) * 0x1p-24f; }
  Vec2 pair() {
    const float x = (*this)();
    return {x, (*this)()};
  }
  Vec3 in_box(float half) {
    return {half * (2 * (*this)() - 1), half * (2 * (*this)() - 1), half * (2 * (*this)() - 1)};
  }

 private:
  std::mt19937 engine_;
};

// A frame that no axis is special in.
inline Frame tilted_frame() {
  const Vec3 n = normalize(Vec3(0.3f, -0.5f, 0.8f)), s = normalize(cross(Vec3(0.2f, 1, 0.1f), n));
  return {s, cross(n, s), n};
}

// Corners p, p + a, p + a + b, p + b; the front faces along a x b.
inline std::vector<EmitterTriangle> rectangle(const Vec3& p, const Vec3& a, const Vec3& b) {
  return {{p, p + a, p + a + b}, {p, p + a + b, p + b}};
}

// A regular polygon in the plane z = h that faces down, fine enough for a disc: its area is within 7e-6 of pi r^2.
inline std::vector<EmitterTriangle> disc_facing_down(float radius, float h) {
  constexpr int n = 1000;
  std::vector<EmitterTriangle> out;
  const auto corner = [&](int i) {
    const double phi = 2 * pi_d * i / n;
    return Vec3(float(radius * std::cos(phi)), float(radius * std::sin(phi)), h);
  };
  for (int i = 0; i < n; ++i) out.push_back({{0, 0, h}, corner(i + 1), corner(i)});
  return out;
}

inline std::vector<EmitterTriangle> tetrahedron() {
  const Vec3 a(0, 0, 0), b(1, 0.1f, 0), c(0.2f, 0.9f, 0.1f), d(0.3f, 0.2f, 0.8f);
  return {{a, c, b}, {a, b, d}, {b, c, d}, {c, a, d}};
}

// Light in all directions: bright down, weaker up, stronger towards C30.
inline std::shared_ptr<const photometry::Distribution> up_and_down() {
  std::vector<double> c, g, table;
  for (int i = 0; i < 24; ++i) c.push_back(15 * i);
  for (int j = 0; j <= 36; ++j) g.push_back(5 * j);
  for (double ci : c)
    for (double gj : g) {
      const double cosine = std::cos(gj * pi_d / 180),
                   side = std::sin(gj * pi_d / 180) * std::cos((ci - 30) * pi_d / 180);
      table.push_back((cosine > 0 ? 900 * cosine : -300 * cosine) * (1 + 0.6 * side));
    }
  return std::make_shared<photometry::Distribution>(c, g, table);
}

// I0 cos(gamma) below the horizon, in steps of half a degree.
inline std::shared_ptr<const photometry::Distribution> lambertian(double i0) {
  std::vector<double> g, table;
  for (int j = 0; j <= 180; ++j) {
    g.push_back(0.5 * j);
    table.push_back(j < 180 ? i0 * std::cos(g.back() * pi_d / 180) : 0);
  }
  return std::make_shared<photometry::Distribution>(std::vector<double>{0}, g, table);
}

inline photometry::Opening opening(photometry::OpeningShape shape, float x, float y, float z = 0) {
  photometry::Opening out;
  out.shape = shape;
  out.size_m[0] = x, out.size_m[1] = y, out.size_m[2] = z;
  return out;
}

inline std::shared_ptr<const RaySet> one_ray() {
  auto file = std::make_shared<photometry::Photometry>(photometry::Photometry{*lambertian(1)});
  file->rays.push_back({{0, 0, 0}, {0, 0, -1}, 1});
  return std::make_shared<RaySet>(file);
}

struct NamedOpening {
  const char* name;
  photometry::Opening opening;
};

inline photometry::Opening cylinder(float x, float y, float z, int axis) {
  photometry::Opening out = opening(photometry::OpeningShape::cylinder, x, y, z);
  out.axis = axis;
  return out;
}

// Of each kind one, and every axis as that of a flat opening and of a cylinder.
inline std::vector<NamedOpening> all_openings() {
  using photometry::OpeningShape;
  return {{"rectangle opening", opening(OpeningShape::rectangle, 0.6f, 0.2f)},
          {"round opening", opening(OpeningShape::disc, 0.3f, 0.4f)},
          {"standing rectangle across y", opening(OpeningShape::rectangle, 0.6f, 0, 0.2f)},
          {"standing disc across x", opening(OpeningShape::disc, 0, 0.3f, 0.4f)},
          {"box without width", opening(OpeningShape::box, 0, 0.3f, 0.5f)},
          {"box", opening(OpeningShape::box, 0.6f, 0.3f, 0.1f)},
          {"standing cylinder", cylinder(0.2f, 0.3f, 0.5f, 2)},
          {"tube along x", cylinder(1.2f, 0.03f, 0.03f, 0)},
          {"tube along y", cylinder(0.2f, 0.9f, 0.1f, 1)},
          {"sphere", opening(OpeningShape::sphere, 0.4f, 0.4f, 0.4f)},
          {"ellipsoid", opening(OpeningShape::sphere, 0.6f, 0.3f, 0.2f)}};
}

struct NamedEmitter {
  const char* name;
  std::unique_ptr<Emitter> emitter;
  bool coplanar = true;  // all triangles in one plane: primitive 0 stands for any
};

inline std::vector<NamedEmitter> all_emitters() {
  const Frame f = tilted_frame();
  const Vec3 p(0.5f, 1, -2);
  const Rgb colour(3, 2, 1);
  std::vector<NamedEmitter> out;
  const auto add = [&](const char* name, std::unique_ptr<Emitter> e) { out.push_back({name, std::move(e)}); };
  add("rectangle", std::make_unique<AreaEmitter>(rectangle(p, f.s * 2.0f, f.t * 0.5f), colour, false, 7));
  add("both sides", std::make_unique<AreaEmitter>(rectangle(p, f.s * 2.0f, f.t * 0.5f), colour, true, 7));
  add("tetrahedron", std::make_unique<AreaEmitter>(tetrahedron(), colour, false, 8));
  out.back().coplanar = false;
  add("point", std::make_unique<PointEmitter>(p, colour, 1e-6f));
  add("spot", std::make_unique<SpotEmitter>(p, f.n, colour, 0.3f, 0.7f, 1e-6f));
  add("hard spot", std::make_unique<SpotEmitter>(p, f.n, colour, 0.4f, 0.4f, 1e-6f));
  add("narrow spot", std::make_unique<SpotEmitter>(p, f.n, colour, 0.0f, 0.002f, 1e-6f));
  add("directional", std::make_unique<DirectionalEmitter>(f.n, colour, 30.0f));
  add("profile", std::make_unique<ProfilePointEmitter>(up_and_down(), f, p, colour, 1e-6f));
  for (const NamedOpening& o : all_openings())
    add(o.name, std::make_unique<ProfileOpeningEmitter>(up_and_down(), f, p, o.opening, colour, 1e-6f));
  return out;
}

}  // namespace ups::test
