// Next-event estimation: the right light at a point, and the same densities as emission and hits. Illuminances come
// from midpoints of a fine grid over u, so the tests are deterministic.
#include <gtest/gtest.h>

#include "base/floating_point.h"
#include "emitter/test_emitters.h"

namespace ups::test {
namespace {

// Of a plane with this normal, from a lattice of n numbers (golden section).
double illuminance(const Emitter& emitter, const Vec3& p, const Vec3& n, int numbers = 90000) {
  double sum = 0;
  for (int i = 0; i < numbers; ++i) {
    const double turn = i * 0.6180339887498949;
    DirectSample s;
    if (emitter.sample_direct(p, {float((i + 0.5) / numbers), float(turn - std::floor(turn))}, s))
      sum += luminance(s.weight) * std::max(0.0f, dot(n, s.wi));
  }
  return sum / numbers;
}

const Vec3 up(0, 0, 1);

TEST(Direct, PointFollowsInverseSquareAndCosine) {
  const PointEmitter e({1, 2, 3}, Rgb(100), 0);
  EXPECT_NEAR(illuminance(e, {1, 2, 1}, up, 1), 100.0 / 4, 1e-4);
  EXPECT_NEAR(illuminance(e, {1, 4, 1}, up, 1), 100 * std::cos(pi_d / 4) / 8, 1e-4);
}

// So close that the light is beyond a float: it is not hidden, so that whoever asked counts what is dropped.
TEST(Direct, WhatIsNotFiniteIsNotHidden) {
  const TrapsMasked masked;
  constexpr float gap = 1e-20f;
  DirectSample s;
  ASSERT_TRUE(PointEmitter({0, 0, gap}, Rgb(1), 0).sample_direct({0, 0, 0}, {}, s));
  EXPECT_FALSE(is_finite(s.weight));
  ASSERT_TRUE(SpotEmitter({0, 0, gap}, {0, 0, -1}, Rgb(1), 0.3f, 0.7f, 0).sample_direct({0, 0, 0}, {}, s));
  EXPECT_FALSE(is_finite(s.weight));
  const AreaEmitter area(disc_facing_down(0.5f, 0), Rgb(1), false, 0);
  ASSERT_TRUE(area.sample_direct({0, 0, -1}, {0.3f, 0.6f}, s));
  ASSERT_TRUE(area.sample_direct(s.p - Vec3(0, 0, gap), {0.3f, 0.6f}, s));
  EXPECT_FALSE(is_finite(s.weight));
}

TEST(Direct, SpotHasItsFalloff) {
  const float inner = 0.3f, outer = 0.7f;
  const SpotEmitter e({0, 0, 2}, {0, 0, -3}, Rgb(100), inner, outer, 0);
  EXPECT_NEAR(illuminance(e, {0, 0, 0}, up, 1), 25, 1e-4);
  const auto at = [&](double angle) {
    DirectSample s;
    const Vec3 p(float(5 * std::sin(angle)), 0, float(2 - 5 * std::cos(angle)));
    return e.sample_direct(p, {0, 0}, s) ? 25 * double(luminance(s.weight)) : 0;  // cd
  };
  EXPECT_NEAR(at(0.25), 100, 1e-3);
  const double ramp = (std::cos(0.5) - std::cos(double(outer))) / (std::cos(double(inner)) - std::cos(double(outer)));
  EXPECT_NEAR(at(0.5), 100 * ramp * ramp, 1e-3);
  EXPECT_EQ(at(0.71), 0);
  EXPECT_EQ(at(pi_d), 0);
}

TEST(Direct, SunHasItsIlluminance) {
  const DirectionalEmitter e({1, 0, -1}, Rgb(1000), 50);
  EXPECT_NEAR(illuminance(e, {3, 2, 1}, up, 1), 1000 * std::cos(pi_d / 4), 1e-3);
  DirectSample s;
  ASSERT_TRUE(e.sample_direct({3, 2, 1}, {0, 0}, s));
  EXPECT_EQ(s.distance, 100);
  EXPECT_EQ(s.pdf_nee_a, 1);
  EXPECT_EQ(s.pdf_direction_w, 1);
  EXPECT_NEAR(s.pdf_position_a, 1 / (pi_d * 2500), 1e-9);
}

// E = pi L r^2 / (r^2 + h^2) below a disc's centre.
TEST(Direct, DiscAbove) {
  for (float scale : {1.0f, 0x1p-10f, 0x1p14f}) {
    const AreaEmitter e(disc_facing_down(0.5f * scale, 2 * scale), Rgb(1000), false, 0);
    EXPECT_NEAR(illuminance(e, Vec3(), up) / (pi_d * 1000 * 0.25 / 4.25), 1, 2e-4) << scale;
    EXPECT_EQ(illuminance(e, {0, 0, 4 * scale}, -up), 0);  // the dark side
    const AreaEmitter both(disc_facing_down(0.5f * scale, 2 * scale), Rgb(1000), true, 0);
    EXPECT_NEAR(illuminance(both, {0, 0, 4 * scale}, -up) / (pi_d * 1000 * 0.25 / 4.25), 1, 2e-4) << scale;
  }
}

// Configuration factor of a rectangle a x b whose corner is at distance h on the normal (Howell, C-11).
double corner_factor(double a, double b, double h) {
  const double x = a / h, y = b / h, rx = std::sqrt(1 + x * x), ry = std::sqrt(1 + y * y);
  return (x / rx * std::atan(y / rx) + y / ry * std::atan(x / ry)) / (2 * pi_d);
}

TEST(Direct, RectangleAbove) {
  const AreaEmitter e(rectangle({-1, -0.5f, 1.5f}, {0, 1, 0}, {2, 0, 0}), Rgb(1000), false, 0);
  EXPECT_NEAR(illuminance(e, {0, 0, 0}, up) / (pi_d * 1000 * 4 * corner_factor(1, 0.5, 1.5)), 1, 2e-4);
  EXPECT_NEAR(illuminance(e, {1, 0.5f, 0}, up) / (pi_d * 1000 * corner_factor(2, 1, 1.5)), 1, 2e-4);
}

// A Lambertian opening is a Lambertian disc: at 5 diameters 1 % less than its far field, at 100 the far field.
TEST(Direct, RoundOpening) {
  const double i0 = 1000;
  const ProfileOpeningEmitter e(lambertian(i0), Frame(), {0, 0, 3}, opening(photometry::OpeningShape::disc, 0.2f, 0.2f),
                                Rgb(1), 0);
  EXPECT_NEAR(illuminance(e, {0, 0, 2}, up) / (i0 / (1 + 0.01)), 1, 2e-4);
  EXPECT_NEAR(illuminance(e, {0, 0, -17}, up) / (i0 / 400), 1, 2e-4);
  EXPECT_EQ(illuminance(e, {0, 0, 4}, -up), 0);
}

TEST(Direct, RectangularOpening) {
  const double i0 = 1000;
  const ProfileOpeningEmitter e(lambertian(i0), Frame(), {0, 0, 1.5f},
                                opening(photometry::OpeningShape::rectangle, 2, 1), Rgb(1), 0);
  const double luminance_cd_m2 = i0 / 2;
  EXPECT_NEAR(illuminance(e, {0, 0, 0}, up) / (pi_d * luminance_cd_m2 * 4 * corner_factor(1, 0.5, 1.5)), 1, 3e-4);
  // Anything but Lambertian converges to I / d^2.
  const auto d = up_and_down();
  const ProfileOpeningEmitter far(d, Frame(), Vec3(), opening(photometry::OpeningShape::rectangle, 0.2f, 0.1f), Rgb(1),
                                  0);
  const Vec3 p(6, -4, -10), q(6, -4, 10);
  for (const Vec3& r : {p, q})
    EXPECT_NEAR(illuminance(far, r, -normalize(r)) / (d->eval(r.x, r.y, r.z) / length2(r)), 1, 2e-3);
}

TEST(Direct, LambertianOpeningLooksEquallyBrightFromAnywhere) {
  const ProfileOpeningEmitter e(lambertian(1000), Frame(), Vec3(), opening(photometry::OpeningShape::disc, 2, 2),
                                Rgb(1), 0);
  for (double angle : {0.0, 0.5, 1.0, 1.5}) {
    EmitterHit hit;
    const Vec3 wo(float(std::sin(angle)), 0, float(-std::cos(angle)));
    ASSERT_TRUE(e.eval_hit(wo, Vec3(), 0, wo, hit));
    EXPECT_NEAR(hit.radiance.g, 1000 / pi_d, 0.02);
    EXPECT_FALSE(e.eval_hit(-wo, Vec3(), 0, -wo, hit));
  }
  EmitterHit hit;
  EXPECT_FALSE(e.eval_hit({1, 0, 0}, Vec3(), 0, {1, 0, 0}, hit));  // edge on
}

// The triangle that a point of the emitter lies in, from its side's normal.
uint32_t primitive_at(const std::vector<EmitterTriangle>& triangles, const Vec3& n) {
  uint32_t best = 0;
  float most = -2;
  for (uint32_t i = 0; i < triangles.size(); ++i) {
    const EmitterTriangle& t = triangles[i];
    const float agreement = dot(normalize(cross(t.p1 - t.p0, t.p2 - t.p0)), n);
    if (agreement > most) most = agreement, best = i;
  }
  return best;
}

// For the MIS weights: one point of the emitter has the same densities however it was found.
TEST(Direct, DensitiesAgreeWithHitsAndEmission) {
  for (const NamedEmitter& named : all_emitters()) {
    SCOPED_TRACE(named.name);
    const Emitter& e = *named.emitter;
    Random random(20);
    int seen = 0;
    for (int i = 0; i < 4000; ++i) {
      const Vec3 reference = e.center() + random.in_box(4);
      DirectSample s;
      if (!e.sample_direct(reference, random.pair(), s)) continue;
      ASSERT_NEAR(length(s.wi), 1, 1e-6);
      EmitterHit hit;
      if (e.is_delta()) {
        ASSERT_FALSE(e.eval_hit(reference, s.p, 0, -s.wi, hit));
        ASSERT_EQ(s.pdf_nee_a, 1);
        ASSERT_EQ(s.cos_0, 1);
        ASSERT_EQ(e.radius() == 0, !e.is_directional());
        continue;
      }
      ++seen;
      ASSERT_NEAR(s.distance, length(s.p - reference), 1e-5);
      ASSERT_NEAR(s.cos_0, dot(s.n, -s.wi), 1e-6);
      const uint32_t primitive = named.coplanar ? 0 : primitive_at(tetrahedron(), s.n);
      ASSERT_TRUE(e.eval_hit(reference, s.p, primitive, -s.wi, hit));
      ASSERT_EQ(s.pdf_position_a, hit.pdf_position_a);
      if (s.cos_0 < 1e-3f) continue;
      ASSERT_NEAR(s.pdf_nee_a / hit.pdf_nee_a, 1, 1e-3);
      ASSERT_NEAR(s.pdf_direction_w / hit.pdf_direction_w, 1, 1e-3);
      const float weight = hit.radiance.r * s.cos_0 / (s.distance * s.distance * s.pdf_nee_a);
      ASSERT_NEAR(s.weight.r / weight, 1, 1e-3);
    }
    if (!e.is_delta()) {
      EXPECT_GT(seen, 500);
    }
  }
}

// A delta source's direct sample at a point of a light path says what that path said.
TEST(Direct, DensitiesOfPointsAgreeWithEmission) {
  for (const NamedEmitter& named : all_emitters()) {
    const Emitter& e = *named.emitter;
    if (!e.is_delta() || named.name == std::string("narrow spot")) continue;
    SCOPED_TRACE(named.name);
    Random random(21);
    for (int i = 0; i < 2000; ++i) {
      EmissionSample s;
      const Vec2 u_position = random.pair();
      if (!e.sample_emission(u_position, random.pair(), s)) continue;
      DirectSample d;
      const bool found = e.sample_direct(s.p + s.direction * 3.0f, random.pair(), d);
      if (s.pdf_direction_w < 1e-3f) continue;  // at a spot's edge
      if (named.name == std::string("hard spot") && !found) continue;
      ASSERT_TRUE(found);
      ASSERT_NEAR(d.pdf_direction_w / s.pdf_direction_w, 1, 2e-3);
      ASSERT_EQ(d.pdf_position_a, s.pdf_position_a);
      const float intensity = d.weight.r * (e.is_directional() ? 1 : 9);
      ASSERT_NEAR(intensity / (s.flux.r * s.pdf_direction_w * s.pdf_position_a), 1, 2e-3);
    }
  }
}

TEST(Direct, AtTheEmitterItselfNothingIsSampled) {
  DirectSample s;
  EXPECT_FALSE(PointEmitter({1, 2, 3}, Rgb(1), 0).sample_direct({1, 2, 3}, {0, 0}, s));
  const AreaEmitter e(rectangle(Vec3(), {1, 0, 0}, {0, 1, 0}), Rgb(1), true, 0);
  EXPECT_FALSE(e.sample_direct({5, 5, 0}, {0.3f, 0.3f}, s));  // in its plane
}

}  // namespace
}  // namespace ups::test
