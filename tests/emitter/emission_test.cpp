// Do light paths start where, whither and with the flux that the emitters claim? Chi-square tests have fixed seeds and
// a false-alarm rate of 1e-4 each; densities that are off by 2 %, root mean square, are found in 97.7 of 100 cases.
#include <gtest/gtest.h>

#include "emitter/test_emitters.h"

namespace ups::test {
namespace {

constexpr int samples = 600000;
constexpr double smallest_error = 0.02;  // of a density, that is found

// pdf: an independent statement of the density of directions, per solid angle.
template <class Pdf>
void expect_directions(const Emitter& emitter, const SphereCells& cells, const Pdf& pdf, uint32_t seed) {
  Random random(seed);
  std::vector<double> observed(cells.size(), 0.0);
  for (int i = 0; i < samples; ++i) {
    EmissionSample s;
    const Vec2 u_position = random.pair();
    ASSERT_TRUE(emitter.sample_emission(u_position, random.pair(), s));
    const double claimed = pdf(Vec3d(s.direction));
    ASSERT_NEAR(s.pdf_direction_w, claimed, 2e-3 * claimed + 1e-5) << i;
    observed[cells.index(s.direction)] += 1;
  }
  std::vector<double> expected = cells.integrate(pdf);
  for (double& e : expected) e *= samples;
  expect_fit(observed, expected, smallest_error);
}

TEST(Emission, AreaDirectionsFollowTheCosine) {
  const Frame f = tilted_frame();
  const auto triangles = rectangle({1, 2, 3}, f.s, f.t);
  const auto cosine = [&](const Vec3d& d) { return dot(normalize(d), normalize(Vec3d(f.n))); };
  const SphereCells cells(20, 12, Vec3d(f.n));
  expect_directions(
      AreaEmitter(triangles, Rgb(1), false, 0), cells, [&](const Vec3d& d) { return std::max(0.0, cosine(d)) / pi_d; },
      1);
  expect_directions(
      AreaEmitter(triangles, Rgb(1), true, 0), cells, [&](const Vec3d& d) { return std::abs(cosine(d)) / (2 * pi_d); },
      2);
}

// Light paths start as far above the surface as rounding may have set a point off it: far from the origin, of an
// emitter much smaller than its coordinates.
TEST(Emission, AreaPointsKnowHowFarOffTheSurfaceTheyMayBe) {
  const Frame f = tilted_frame();
  const auto triangles = rectangle({4000, -2000, 3000}, f.s * 0.5f, f.t * 0.2f);
  const AreaEmitter emitter(triangles, Rgb(1), false, 0);
  Random random(3);
  double farthest = 0;
  for (int i = 0; i < 10000; ++i) {
    EmissionSample s;
    const Vec2 u_position = random.pair();
    ASSERT_TRUE(emitter.sample_emission(u_position, random.pair(), s));
    double off = 1e9;  // of the nearer triangle, as its corners are
    for (const EmitterTriangle& t : triangles) {
      const Vec3d p0(t.p0), n = normalize(cross(Vec3d(t.p1) - p0, Vec3d(t.p2) - p0));
      off = std::min(off, std::abs(dot(Vec3d(s.p) - p0, n)));
    }
    ASSERT_LE(off, s.error);
    ASSERT_LT(s.error, 0.05);  // and not so far that light leaks
    farthest = std::max(farthest, off);
  }
  EXPECT_GT(farthest, 1e-4) << "nothing was rounded";
}

TEST(Emission, PointDirectionsAreUniform) {
  expect_directions(
      PointEmitter({1, 2, 3}, Rgb(1), 0), SphereCells(20, 12), [](const Vec3d&) { return 1 / (4 * pi_d); }, 3);
}

// The falloff as KHR_lights_punctual states it, normalised by quadrature.
void expect_spot(float inner_rad, float outer_rad, uint32_t seed) {
  const double inner = inner_rad, outer = outer_rad;
  const Frame f = tilted_frame();
  const Vec3d axis = normalize(Vec3d(f.n));
  const auto falloff = [&](double angle) {
    const double ramp = (std::cos(angle) - std::cos(outer)) / (std::cos(inner) - std::cos(outer));
    const double t = inner == outer ? double(angle < inner) : std::clamp(ramp, 0.0, 1.0);
    return t * t;
  };
  double whole = 0;
  constexpr int n = 20000;
  for (int i = 0; i < n; ++i) {
    const double angle = outer * (i + 0.5) / n;
    whole += falloff(angle) * 2 * pi_d * std::sin(angle) * outer / n;
  }
  const SpotEmitter spot({1, 2, 3}, f.n * 5.0f, Rgb(10), inner_rad, outer_rad, 0);
  EXPECT_NEAR(spot.flux_lm(), 10 * whole, 1e-4 * 10 * whole);
  const auto pdf = [&](const Vec3d& d) { return falloff(std::atan2(length(cross(d, axis)), dot(d, axis))) / whole; };
  Random random(seed);
  const double sharpness = 0.25 * outer * outer;
  const SphereCells cells(40, 12, axis, sharpness);
  std::vector<double> observed(cells.size(), 0.0), expected = cells.integrate(pdf, 1e-7);
  for (int i = 0; i < samples; ++i) {
    EmissionSample s;
    ASSERT_TRUE(spot.sample_emission({0, 0}, random.pair(), s));
    ASSERT_NEAR(s.pdf_direction_w, pdf(Vec3d(s.direction)), 2e-3 / whole);
    observed[cells.index(s.direction)] += 1;
  }
  for (double& e : expected) e *= samples;
  expect_fit(observed, expected, smallest_error);
}

TEST(Emission, SpotDirectionsFollowItsFalloff) {
  expect_spot(0.3f, 0.7f, 4);
  expect_spot(0.0f, 1.5f, 5);
  expect_spot(0.0f, 0.002f, 6);
  expect_spot(0.001f, 0.002f, 7);
}

TEST(Emission, ProfileDirectionsFollowTheDistribution) {
  const Frame f = tilted_frame();
  const auto d = up_and_down();
  const auto pdf = [&](const Vec3d& w) {
    const auto local = [&](const Vec3& axis) { return dot(w, Vec3d(axis)); };
    return d->eval(local(f.s), local(f.t), local(f.n)) / d->interpolated_flux_lm();
  };
  const SphereCells cells(20, 24, Vec3d(f.n));
  expect_directions(ProfilePointEmitter(d, f, {1, 2, 3}, Rgb(2), 0), cells, pdf, 8);
  expect_directions(
      ProfileOpeningEmitter(d, f, {1, 2, 3}, opening(photometry::OpeningShape::disc, 0.3f, 0.3f), Rgb(2), 0), cells,
      pdf, 9);
}

// A luminaire whose frame is mirrored keeps its distribution mirrored; local +Z is n.
TEST(Emission, ProfileFollowsItsFrame) {
  const photometry::Distribution d({0, 90, 180, 270}, {80, 90, 100}, {0, 5, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0});
  const Frame f(Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 0, 0));
  const ProfilePointEmitter e(std::make_shared<photometry::Distribution>(d), f, Vec3(), Rgb(1), 0);
  DirectSample s;
  ASSERT_TRUE(e.sample_direct({0, 2, 0}, {0, 0}, s));  // along local +X
  EXPECT_NEAR(s.weight.r, 5.0f / 4, 1e-6);
  ASSERT_TRUE(e.sample_direct({0, 0, 2}, {0, 0}, s));
  EXPECT_NEAR(s.weight.r, 1.0f / 4, 1e-6);
  EXPECT_FALSE(e.sample_direct({2, 0, 0}, {0, 0}, s));
}

// Positions by cells of equal area.
template <class Cell>
void expect_positions(const Emitter& emitter, size_t cells, const Cell& cell, uint32_t seed) {
  Random random(seed);
  std::vector<double> emitted(cells, 0.0), direct(cells, 0.0);
  double direct_count = 0;
  const Vec3 reference = emitter.center() + Vec3(0.5f, -0.5f, 30) * emitter.radius();
  for (int i = 0; i < samples; ++i) {
    EmissionSample e;
    const Vec2 u_position = random.pair();
    ASSERT_TRUE(emitter.sample_emission(u_position, random.pair(), e));
    emitted[cell(e.p)] += 1;
    DirectSample d;
    if (!emitter.is_directional() && emitter.sample_direct(reference, random.pair(), d))
      direct[cell(d.p)] += 1, ++direct_count;
  }
  expect_fit(emitted, std::vector<double>(cells, samples / double(cells)), smallest_error);
  if (!emitter.is_directional())
    expect_fit(direct, std::vector<double>(cells, direct_count / double(cells)), smallest_error);
}

size_t grid_cell(float x, float y, int n) {  // of the unit square
  return size_t(std::clamp(int(x * float(n)), 0, n - 1) * n + std::clamp(int(y * float(n)), 0, n - 1));
}

TEST(Emission, PositionsAreUniformOnARectangle) {
  const Frame f = tilted_frame();
  const Vec3 p(1, 2, 3);
  const auto cell = [&](const Vec3& q) { return grid_cell(dot(q - p, f.s) / 2, dot(q - p, f.t) / 0.5f, 15); };
  expect_positions(AreaEmitter(rectangle(p, f.s * 2.0f, f.t * 0.5f), Rgb(1), false, 0), 225, cell, 10);
  // Any triangulation: a fan of slivers and a degenerate one.
  const Vec3 a = f.s * 2.0f, b = f.t * 0.5f;
  std::vector<EmitterTriangle> fan = {{p, p + a, p + a + b * 0.1f}, {p, p, p + a}, {p, p + a + b * 0.1f, p + a + b}};
  fan.push_back({p, p + a + b, p + b});
  expect_positions(AreaEmitter(fan, Rgb(1), true, 0), 225, cell, 11);
}

TEST(Emission, PositionsAreUniformOnOpenings) {
  const Frame f = tilted_frame();
  const Vec3 p(1, 2, 3);
  const ProfileOpeningEmitter plate(up_and_down(), f, p, opening(photometry::OpeningShape::rectangle, 0.6f, 0.2f),
                                    Rgb(1), 0);
  expect_positions(
      plate, 225,
      [&](const Vec3& q) {
        EXPECT_NEAR(dot(q - p, f.n), 0, 1e-6);
        return grid_cell(dot(q - p, f.s) / 0.6f + 0.5f, dot(q - p, f.t) / 0.2f + 0.5f, 15);
      },
      12);
  const ProfileOpeningEmitter ellipse(up_and_down(), f, p, opening(photometry::OpeningShape::disc, 0.6f, 0.2f), Rgb(1),
                                      0);
  expect_positions(
      ellipse, 225,
      [&](const Vec3& q) {
        const float x = dot(q - p, f.s) / 0.3f, y = dot(q - p, f.t) / 0.1f;
        return grid_cell(x * x + y * y, std::atan2(y, x) / (2 * pi) + 0.5f, 15);
      },
      13);
}

TEST(Emission, SunStartsOnADiscBehindTheScene) {
  const Frame f(normalize(Vec3(1, 2, -3)));
  const float radius = 20;
  const DirectionalEmitter sun(Vec3(1, 2, -3), Rgb(1000), radius);
  expect_positions(
      sun, 225,
      [&](const Vec3& q) {
        EXPECT_NEAR(dot(q, f.n), -radius, 1e-4);
        const float x = dot(q, f.s) / radius, y = dot(q, f.t) / radius;
        return grid_cell(x * x + y * y, std::atan2(y, x) / (2 * pi) + 0.5f, 15);
      },
      14);
  EXPECT_NEAR(sun.flux_lm(), 1000 * pi_d * radius * radius, 1);
}

// flux = radiance cos / (pdf_position pdf_direction) at every sample, where an eye walk would see that radiance.
TEST(Emission, FluxIsRadianceOverDensities) {
  for (const NamedEmitter& named : all_emitters()) {
    SCOPED_TRACE(named.name);
    const Emitter& e = *named.emitter;
    Random random(15);
    for (int i = 0; i < 2000; ++i) {
      EmissionSample s;
      const Vec2 u_position = random.pair();
      if (!e.sample_emission(u_position, random.pair(), s)) continue;
      ASSERT_NEAR(length(s.direction), 1, 1e-6);
      ASSERT_NEAR(s.flux.g, e.flux_rgb().g, 1e-5f * e.flux_rgb().g);
      if (e.is_delta()) {
        ASSERT_TRUE(e.is_directional() || s.pdf_position_a == 1);
        ASSERT_EQ(s.cos_0, 1);
        continue;
      }
      ASSERT_NEAR(s.cos_0, dot(s.n, s.direction), 1e-6);
      EmitterHit hit;
      const uint32_t primitive = s.primitive == EmissionSample::invalid ? 0 : s.primitive;
      ASSERT_TRUE(e.eval_hit(s.p + s.direction, s.p, primitive, s.direction, hit));
      ASSERT_EQ(hit.pdf_position_a, s.pdf_position_a);
      if (s.cos_0 < 1e-3f) continue;  // the cosine's own digits are gone
      ASSERT_NEAR(hit.pdf_direction_w / s.pdf_direction_w, 1, 2e-3);
      ASSERT_NEAR(hit.radiance.g * s.cos_0 / (hit.pdf_position_a * hit.pdf_direction_w) / s.flux.g, 1, 2e-3);
    }
  }
}

// What passes through a sphere around the emitter is its flux: 0.4 % is allowed. Eight sets of numbers of their own,
// each stratified over the sphere and, by an additive recurrence (Roberts 2018), over the emitter: the standard error
// of their mean is at most 0.1 %, asserted, so that 0.6 % is found in 97.7 of 100 cases; P(|t_7| > 4) = 0.5 % is the
// chance of a false alarm at that limit.
TEST(Emission, FluxIsWhatArrivesAround) {
  for (const NamedEmitter& named : all_emitters()) {
    if (named.emitter->is_directional() || named.name == std::string("narrow spot")) continue;
    SCOPED_TRACE(named.name);
    const Emitter& e = *named.emitter;
    const Vec3 center = e.center() + Vec3(0.1f, 0.2f, 0.05f);
    const double radius = 2 + 2 * e.radius();
    Random random(16);
    constexpr int sets = 8;
    const int strata = e.kind() == EmitterKind::spot ? 400 : 200;  // a hard edge is noise
    double mean = 0, squares = 0;
    for (int set = 0; set < sets; ++set) {
      const Vec2 shift = random.pair();
      double sum = 0;
      for (int i = 0; i < strata * strata; ++i) {
        const Vec2 jitter = random.pair();
        const double z = 1 - 2 * (i / strata + jitter.x) / strata, phi = 2 * pi_d * (i % strata + jitter.y) / strata;
        const double r = std::sqrt(1 - z * z);
        const Vec3 outwards(float(r * std::cos(phi)), float(r * std::sin(phi)), float(z));
        const Vec2 place{std::min(float(std::fmod(shift.x + 0.7548776662466927 * i, 1)), largest_u),
                         std::min(float(std::fmod(shift.y + 0.5698402909980532 * i, 1)), largest_u)};
        DirectSample s;
        if (e.sample_direct(center + outwards * float(radius), place, s))
          sum += luminance(s.weight) * -dot(s.wi, outwards);
      }
      const double relative = sum * 4 * pi_d * radius * radius / (strata * strata) / e.flux_lm();
      mean += relative / sets, squares += relative * relative / sets;
    }
    EXPECT_LE(std::sqrt(std::max(0.0, squares - mean * mean) / (sets - 1)), 0.001) << "too noisy to judge";
    EXPECT_NEAR(mean, 1, 0.004);
  }
}

TEST(Emission, ProfileCarriesTheInterpolatedFlux) {
  const auto d = up_and_down();
  const ProfilePointEmitter e(d, Frame(), Vec3(), Rgb(0.5f), 0);
  EXPECT_NEAR(e.flux_lm(), 0.5 * d->interpolated_flux_lm(), 1e-6 * d->interpolated_flux_lm());
}

TEST(Emission, NumbersAtTheEdgesOfTheUnitSquareAreFine) {
  const float edge[] = {0, 0x1p-24f, 0.25f, 0.5f, 0.75f, largest_u};
  for (const NamedEmitter& named : all_emitters()) {
    SCOPED_TRACE(named.name);
    for (float a : edge)
      for (float b : edge)
        for (const Vec2& u : {Vec2{a, b}, Vec2{b, a}}) {
          EmissionSample s;
          if (named.emitter->sample_emission({a, b}, u, s)) {
            ASSERT_TRUE(is_finite(s.p) && is_finite(s.direction) && is_finite(s.flux));
            ASSERT_GT(s.pdf_direction_w, 0);
            ASSERT_GT(s.cos_0, 0);
            ASSERT_TRUE(std::isfinite(s.pdf_direction_w) && std::isfinite(s.pdf_position_a));
          }
          DirectSample d;
          if (named.emitter->sample_direct({3, 3, 3}, u, d)) {
            ASSERT_TRUE(is_finite(d.weight) && is_finite(d.wi));
          }
        }
  }
}

TEST(Emission, WhatIsDarkOrWithoutAreaDoesNotEmit) {
  EmissionSample s;
  DirectSample d;
  const AreaEmitter nothing({}, Rgb(1), false, 0), flat({{{1, 1, 1}, {2, 2, 2}, {3, 3, 3}}}, Rgb(1), false, 0);
  const SpotEmitter closed(Vec3(), {0, 0, -1}, Rgb(1), 0, 0, 0);
  const ProfilePointEmitter dark(std::make_shared<photometry::Distribution>(
                                     std::vector<double>{0}, std::vector<double>{0, 90}, std::vector<double>{0, 0}),
                                 Frame(), Vec3(), Rgb(1), 0);
  for (const Emitter* e : {static_cast<const Emitter*>(&nothing), static_cast<const Emitter*>(&flat),
                           static_cast<const Emitter*>(&closed), static_cast<const Emitter*>(&dark)}) {
    EXPECT_EQ(e->flux_lm(), 0);
    EXPECT_FALSE(e->sample_emission({0.5f, 0.5f}, {0.5f, 0.5f}, s));
    EXPECT_FALSE(e->sample_direct({0, 0, -5}, {0.5f, 0.5f}, d));
  }
}

}  // namespace
}  // namespace ups::test
