// Are luminous openings the bodies that they claim to be? Samples against what rays find: two ways that share no
// formula. Chi-square tests have fixed seeds and a false-alarm rate of 1e-4 each; densities that are off by 4 %, root
// mean square, are found in 97.7 of 100 cases.
#include <gtest/gtest.h>

#include "base/error.h"
#include "base/warp.h"
#include "emitter/test_emitters.h"

namespace ups::test {
namespace {

constexpr int samples = 100000;
constexpr double smallest_error = 0.04;  // of a density, that is found

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
      if (even_expected.size() > 8) expect_fit(even_observed, even_expected, smallest_error);
    }
  }
}

// References of all kinds: far, near, grazing, in front of a face, of an end, of an edge.
std::vector<Vec3d> references(const LuminousBody& body, Random& random) {
  const Vec3d h = body.half();
  std::vector<Vec3d> out = {{1.5 * h.x, 0.1 * h.y, h.z + 0.1}, {0.2 * h.x, 0.3 * h.y, h.z + 0.1}};
  for (const double distance : {1.1, 1.7, 10.0, 1000.0})
    out.push_back(on_sphere(random) * (distance * body.circumscribed_radius()));
  return out;
}

// Density per solid angle of next-event estimation from a point, found by a ray; 0 where it misses.
double seen_density(const LuminousBody& body, const Vec3d& reference, const Vec3d& d) {
  double distance;
  Vec3d n;
  if (!body.enter(reference, d, 0, distance, n)) return 0;
  return body.pdf_seen_from(reference, reference + d * distance, n) * distance * distance / std::abs(dot(n, d));
}

// A picture of the body from a point: gnomonic coordinates, along the body's longest axis and across it, in the bounds
// of some samples. Cells that the body fills have the density's integral; what falls elsewhere counts as one cell.
struct Picture {
  static constexpr int n = 12, fine = 40;
  Vec3d w, s, t;
  double low[2] = {1e30, 1e30}, high[2] = {-1e30, -1e30};
  Picture(const LuminousBody& body, const Vec3d& reference) : w(normalize(-reference)) {
    const Vec3d h = body.half();
    const Vec3d longest = h.x >= h.y && h.x >= h.z ? Vec3d(1, 0, 0) : h.y >= h.z ? Vec3d(0, 1, 0) : Vec3d(0, 0, 1);
    s = normalize(longest - w * dot(longest, w));
    t = cross(w, s);
  }
  bool place(const Vec3d& d, double& x, double& y) const {
    if (!(dot(d, w) > 0)) return false;
    x = dot(d, s) / dot(d, w), y = dot(d, t) / dot(d, w);
    return true;
  }
  size_t cell(const Vec3d& d) const {  // n * n: none
    double x, y;
    if (!place(d, x, y)) return size_t(n) * n;
    const double i = std::floor((x - low[0]) / (high[0] - low[0]) * n),
                 j = std::floor((y - low[1]) / (high[1] - low[1]) * n);
    return i >= 0 && i < n && j >= 0 && j < n ? size_t(i) * n + size_t(j) : size_t(n) * n;
  }
  // 0 where the body does not fill the cell.
  double probability(const LuminousBody& body, const Vec3d& reference, int i, int j) const {
    const double dx = (high[0] - low[0]) / (n * fine), dy = (high[1] - low[1]) / (n * fine);
    double sum = 0;
    for (int k = 0; k < fine * fine; ++k) {
      const double x = low[0] + (i * fine + k / fine + 0.5) * dx, y = low[1] + (j * fine + k % fine + 0.5) * dy;
      const double density = seen_density(body, reference, normalize(w + s * x + t * y));
      if (!(density > 0)) return 0;
      sum += density * std::pow(1 + x * x + y * y, -1.5) * dx * dy;
    }
    return sum;
  }
};

TEST(LuminousBody, NextEventEstimationTakesWhatRaysSeeWithItsDensity) {
  Random random(32);
  for (const NamedOpening& named : all_openings()) {
    const LuminousBody body(named.opening);
    int number = 0;
    for (const Vec3d& reference : references(body, random)) {
      SCOPED_TRACE(std::string(named.name) + ", reference " + std::to_string(number++));
      Picture picture(body, reference);
      std::vector<double> observed(size_t(Picture::n) * Picture::n + 1, 0.0);
      for (int i = 0; i < samples; ++i) {
        LuminousBody::Point point;
        ASSERT_TRUE(body.sample_seen_from(reference, random.pair(), point));
        const Vec3d d = point.p - reference;
        ASSERT_LE(dot(point.n, d), 1e-9) << "hidden";
        double x, y;
        if (i < samples / 10) {
          if (!picture.place(d, x, y) || std::hypot(x, y) > 4) continue;
          picture.low[0] = std::min(picture.low[0], x), picture.high[0] = std::max(picture.high[0], x);
          picture.low[1] = std::min(picture.low[1], y), picture.high[1] = std::max(picture.high[1], y);
        } else {
          observed[picture.cell(d)] += 1;
        }
      }
      std::vector<double> filled, expected;
      double rest = 0.9 * samples, filled_share = 0;
      for (int i = 0; i < Picture::n; ++i)
        for (int j = 0; j < Picture::n; ++j) {
          const double p = picture.probability(body, reference, i, j);
          if (!(p > 0)) continue;
          filled.push_back(observed[size_t(i) * Picture::n + size_t(j)]);
          expected.push_back(0.9 * samples * p);
          rest -= filled.back(), filled_share += p;
        }
      ASSERT_LE(filled_share, 1 + 1e-4);
      EXPECT_GT(filled_share, 0.2) << "too little of it can be judged";
      filled.push_back(rest), expected.push_back(0.9 * samples * std::max(0.0, 1 - filled_share));
      expect_fit(filled, expected, smallest_error);
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

// Rays meet a body that is larger by the rounding of places in its scene, and see all of its intensity in it.
TEST(LuminousBody, ShowsItsIntensityHoweverFarItsSurfaceIsLifted) {
  constexpr double candela = 100;
  const auto even = std::make_shared<const photometry::Distribution>(
      std::vector<double>{0}, std::vector<double>{0, 180}, std::vector<double>{candela, candela});
  Random random(37);
  for (const NamedOpening& named : all_openings()) {
    const double radius = LuminousBody(named.opening).circumscribed_radius(), error = 0.02 * radius;
    const ProfileOpeningEmitter emitter(even, Frame(Vec3(0, 0, -1)), {}, named.opening, Rgb(1), float(error));
    if (emitter.is_flat()) continue;
    const Vec3d w = on_sphere(random);
    const Frame f{Vec3(w)};
    constexpr int lines = 400;
    const double side = 2 * (radius + 4 * error);
    double seen = 0;
    for (int i = 0; i < lines; ++i)
      for (int j = 0; j < lines; ++j) {
        const Vec3 o = Vec3(w * (5 * radius)) + f.s * float(side * ((i + 0.5) / lines - 0.5)) +
                       f.t * float(side * ((j + 0.5) / lines - 0.5));
        float t, cosine;
        EmitterHit hit;
        if (emitter.enter(o, Vec3(-w), t, cosine) && emitter.eval_hit(o, o - Vec3(w) * t, 0, Vec3(w), hit))
          seen += double(luminance(hit.radiance)) * side * side / (double(lines) * lines);
      }
    EXPECT_NEAR(seen / candela, 1, 0.01) << named.name;
  }
}

}  // namespace
}  // namespace ups::test
