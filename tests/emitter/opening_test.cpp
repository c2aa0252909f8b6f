// Are luminous openings the bodies that they claim to be? Samples against what rays find: two ways that share no formula.
// Chi-square tests have fixed seeds and a false-alarm rate of 1e-4 each.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/warp.h"
#include "emitter/test_emitters.h"
#include "support/chi_square.h"

namespace ups::test {
namespace {

constexpr double false_alarm = 1e-4;
constexpr int samples = 100000;

void expect_fit(const std::vector<double>& observed, const std::vector<double>& expected) {
  const ChiSquareResult r = chi_square_test(observed, expected);
  ASSERT_GT(r.degrees_of_freedom, 4);
  EXPECT_GT(r.p_value, false_alarm) << r.statistic << " / " << r.degrees_of_freedom;
}

Vec3d on_sphere(Random& random) { return normalize(Vec3d(square_to_sphere(random.pair()))); }

// Parallel rays that come in against w, on a grid across the circumscribed disc: how many cells of it meet the body.
struct Silhouette {
  static constexpr int n = 12, fine = 40;
  Vec3d w, s, t;
  double radius;
  explicit Silhouette(const Vec3d& w_, double r) : w(w_), radius(r) {
    const Frame f{Vec3(w)};
    s = normalize(Vec3d(f.s) - w * dot(Vec3d(f.s), w));
    t = cross(w, s);
  }
  size_t cell(const Vec3d& p) const {
    const auto at = [&](double v) { return std::clamp(int((v / radius + 1) / 2 * n), 0, n - 1); };
    return size_t(at(dot(p, s)) * n + at(dot(p, t)));
  }
  std::vector<double> areas(const LuminousBody& body) const {
    std::vector<double> out(size_t(n) * n, 0.0);
    const int lines = n * fine;
    for (int i = 0; i < lines; ++i)
      for (int j = 0; j < lines; ++j) {
        const double x = (2 * (i + 0.5) / lines - 1) * radius, y = (2 * (j + 0.5) / lines - 1) * radius;
        double distance;
        Vec3d normal;
        const Vec3d o = s * x + t * y;
        if (body.enter(o + w * (5 * radius), -w, 0, distance, normal))
          out[cell(o)] += 4 * radius * radius / (double(lines) * lines);
      }
    return out;
  }
};

TEST(LuminousBody, LooksAsLargeAsItsSilhouetteAndIsSampledEvenlyInIt) {
  Random random(31);
  for (const NamedOpening& named : all_openings()) {
    const LuminousBody body(named.opening);
    for (int k = 0; k < 3; ++k) {
      SCOPED_TRACE(std::string(named.name) + ", direction " + std::to_string(k));
      const Silhouette view(on_sphere(random), body.circumscribed_radius());
      std::vector<double> expected = view.areas(body), observed(expected.size(), 0.0);
      double area = 0;
      for (double a : expected) area += a;
      // The grid's own error: half the lines that cross the outline are counted wrongly.
      EXPECT_NEAR(area / body.projected_area(view.w), 1, 0.01);
      for (double& e : expected) e *= samples / area;
      for (int i = 0; i < samples; ++i) {
        LuminousBody::Point point;
        ASSERT_TRUE(body.sample_seen_along(view.w, random.pair(), point));
        ASSERT_NEAR(point.pdf_a * body.projected_area(view.w), dot(point.n, view.w), 1e-9);
        // It is on the surface, where the ray along w enters.
        double distance;
        Vec3d normal;
        const double back = 5 * view.radius;
        if (dot(point.n, view.w) > 1e-2) {
          ASSERT_TRUE(body.enter(point.p + view.w * back, -view.w, 1e-9, distance, normal));
          ASSERT_NEAR(distance, back, 1e-6 * view.radius);
          ASSERT_NEAR(dot(normal, point.n), 1, 1e-6);
        }
        observed[view.cell(point.p)] += 1;
      }
      // Cells that the outline cuts are known to the grid's error alone: neighbours share it.
      std::vector<double> even_observed, even_expected;
      double rest_observed = 0, rest_expected = 0;
      double full = 0;
      for (double e : expected) full = std::max(full, e);
      for (size_t i = 0; i < expected.size(); ++i) {
        if (expected[i] > 0.999 * full)
          even_observed.push_back(observed[i]), even_expected.push_back(expected[i]);
        else
          rest_observed += observed[i], rest_expected += expected[i];
      }
      even_observed.push_back(rest_observed), even_expected.push_back(rest_expected);
      if (even_expected.size() > 8) expect_fit(even_observed, even_expected);
    }
  }
}

// References of all kinds: far, near, grazing, in front of a face, of an end, of an edge.
std::vector<Vec3d> references(const LuminousBody& body, Random& random) {
  const Vec3d h = body.half();
  std::vector<Vec3d> out = {{1.5 * h.x, 0.1 * h.y, h.z + 0.1}, {0.2 * h.x, 0.3 * h.y, h.z + 0.02}};
  for (const double distance : {1.1, 1.7, 10.0, 1000.0}) out.push_back(on_sphere(random) * (distance * body.circumscribed_radius()));
  return out;
}

// Density per solid angle of next-event estimation from a point, found by a ray; 0 where it misses.
double seen_density(const LuminousBody& body, const Vec3d& reference, const Vec3d& d) {
  double distance;
  Vec3d n;
  if (!body.enter(reference, d, 0, distance, n)) return 0;
  return body.pdf_seen_from(reference, reference + d * distance, n) * distance * distance / std::abs(dot(n, d));
}

TEST(LuminousBody, NextEventEstimationTakesWhatRaysSeeWithItsDensity) {
  Random random(32);
  for (const NamedOpening& named : all_openings()) {
    const LuminousBody body(named.opening);
    int number = 0;
    for (const Vec3d& reference : references(body, random)) {
      SCOPED_TRACE(std::string(named.name) + ", reference " + std::to_string(number++));
      if (body.is_flat() && std::abs(reference.z) < 0.1 * length(reference)) continue;  // too thin for the cells
      // Cells about the direction to the centre, as fine as the body looks.
      const double size = body.circumscribed_radius() / length(reference);
      const SphereCells cells(24, 16, -reference, std::min(1.0, 0.5 * size * size));
      std::vector<double> observed(cells.size() + 1, 0.0);
      for (int i = 0; i < samples; ++i) {
        LuminousBody::Point point;
        if (!body.sample_seen_from(reference, random.pair(), point)) {
          observed.back() += 1;
          continue;
        }
        const Vec3d d = point.p - reference;
        if (dot(point.n, d) >= 0) {
          observed.back() += 1;  // none of them is hidden
          continue;
        }
        observed[cells.index(Vec3(normalize(d)))] += 1;
      }
      std::vector<double> expected =
          cells.integrate([&](const Vec3d& d) { return seen_density(body, reference, normalize(d)); }, 1e-6, 7, 3);
      double sum = 0;
      for (double e : expected) sum += e;
      EXPECT_NEAR(sum, 1, 0.004);  // the quadrature's: the outline crosses cells
      expected.push_back(0);
      for (double& e : expected) e *= samples;
      EXPECT_EQ(observed.back(), 0);
      const ChiSquareResult fit = chi_square_test(observed, expected);
      EXPECT_GT(fit.p_value, false_alarm) << fit.statistic << " / " << fit.degrees_of_freedom;
    }
  }
}

TEST(LuminousBody, FromInsideNothingOfItIsSeen) {
  Random random(33);
  for (const NamedOpening& named : all_openings()) {
    SCOPED_TRACE(named.name);
    const LuminousBody body(named.opening);
    if (body.is_flat()) continue;
    const Frame f = tilted_frame();
    const ProfileOpeningEmitter emitter(up_and_down(), f, {1, 2, 3}, named.opening, Rgb(1), 1e-6f);
    const Vec3d h = body.half() * 0.55;
    for (int i = 0; i < 500; ++i) {
      const Vec3 r = random.in_box(1);
      const Vec3d inside(r.x * h.x, r.y * h.y, r.z * h.z);
      LuminousBody::Point point;
      ASSERT_FALSE(body.sample_seen_from(inside, random.pair(), point));
      double t;
      Vec3d n;
      ASSERT_FALSE(body.enter(inside, on_sphere(random), 0, t, n));
      DirectSample direct;
      const Frame own = body.turned(f);
      ASSERT_FALSE(emitter.sample_direct(emitter.center() + own.to_world(Vec3(inside)), random.pair(), direct));
    }
  }
}

TEST(LuminousBody, KnowsItsKindByExtents) {
  using photometry::OpeningShape;
  const auto has_area = [](OpeningShape shape, float x, float y, float z) {
    return LuminousBody::has_area(opening(shape, x, y, z));
  };
  EXPECT_FALSE(has_area(OpeningShape::point, 1, 1, 1));
  EXPECT_FALSE(has_area(OpeningShape::rectangle, 1, 0, 0));
  EXPECT_FALSE(has_area(OpeningShape::box, 0, 0, 1));
  EXPECT_TRUE(has_area(OpeningShape::box, 0, 1, 1));
  EXPECT_THROW(LuminousBody(opening(OpeningShape::rectangle, 1, 0)), Error);
  EXPECT_THROW(LuminousBody(opening(OpeningShape::rectangle, 1e-30f, 1e-30f)), Error);
  EXPECT_NEAR(LuminousBody(opening(OpeningShape::disc, 0.6f, 0.4f)).area(), pi_d * 0.06, 1e-7);
  EXPECT_NEAR(LuminousBody(opening(OpeningShape::box, 0, 2, 3)).area(), 6, 1e-6);
  EXPECT_NEAR(LuminousBody(opening(OpeningShape::box, 1, 2, 3)).area(), 22, 1e-5);
  EXPECT_NEAR(LuminousBody(cylinder(1, 0.5f, 0.5f, 0)).area(), pi_d * (0.5 + 2 * 0.0625), 1e-6);
  EXPECT_NEAR(LuminousBody(opening(OpeningShape::sphere, 2, 2, 2)).area(), 4 * pi_d, 1e-5);
  EXPECT_TRUE(LuminousBody(cylinder(0, 0.5f, 0.5f, 0)).is_flat());  // without length: a disc
  EXPECT_NEAR(LuminousBody(cylinder(0, 0.5f, 0.5f, 0)).area(), pi_d * 0.0625, 1e-7);
  EXPECT_NEAR(LuminousBody(cylinder(1, 0, 0.5f, 0)).area(), 0.5, 1e-7);  // without width: a rectangle
}

TEST(LuminousBody, WalksRunIntoTheLiftedSurface) {
  using photometry::OpeningShape;
  const Frame f = tilted_frame();
  const Vec3 p(1, 2, 3);
  const float error = 1e-3f;
  float t, cosine;
  const auto enters = [&](const ProfileOpeningEmitter& e, const Vec3& at, const Vec3& d) {
    return e.enter(at - d, d, t, cosine);
  };
  const ProfileOpeningEmitter plate(up_and_down(), f, p, opening(OpeningShape::rectangle, 0.6f, 0.8f), Rgb(1), error);
  EXPECT_FLOAT_EQ(plate.circumscribed_radius(), 0.5f);
  EXPECT_NEAR(dot(plate.normal(), f.n), -1, 1e-6);
  ASSERT_TRUE(enters(plate, p + f.s * 0.29f - f.t * 0.39f, f.n));
  EXPECT_NEAR(t, 1 - 2 * error, 1e-6);
  EXPECT_NEAR(cosine, 1, 1e-6);
  ASSERT_TRUE(enters(plate, p, -f.n));  // from above it lies behind by as much
  EXPECT_NEAR(t, 1 + 2 * error, 1e-6);
  EXPECT_FALSE(enters(plate, p + f.s * 0.31f, f.n));
  EXPECT_FALSE(enters(plate, p + f.t * 0.41f, f.n));
  EXPECT_FALSE(enters(plate, p, f.s));  // edge on
  const ProfileOpeningEmitter ellipse(up_and_down(), f, p, opening(OpeningShape::disc, 0.6f, 0.8f), Rgb(1), 0);
  EXPECT_TRUE(enters(ellipse, p + f.t * 0.39f, f.n));
  EXPECT_FALSE(enters(ellipse, p + f.s * 0.25f + f.t * 0.3f, f.n));
  const ProfileOpeningEmitter box(up_and_down(), f, p, opening(OpeningShape::box, 0.6f, 0.8f, 0.2f), Rgb(1), error);
  for (const Vec3& d : {f.n, -f.n}) {
    ASSERT_TRUE(enters(box, p + f.s * 0.29f, d));
    EXPECT_NEAR(t, 0.9f - 2 * error, 1e-6);
  }
  EXPECT_FALSE(enters(box, p + f.s * 0.31f, f.n));
  // A sheet on a wall: up_and_down shines towards C30, so to the side of local +X.
  const ProfileOpeningEmitter wall(up_and_down(), f, p, opening(OpeningShape::rectangle, 0, 0.6f, 0.2f), Rgb(1), error);
  EXPECT_NEAR(dot(wall.normal(), f.s), 1, 1e-6);
  ASSERT_TRUE(enters(wall, p, -f.s));
  EXPECT_NEAR(t, 1 - 2 * error, 1e-6);
}

}  // namespace
}  // namespace ups::test
