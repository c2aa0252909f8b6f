// Shapes of reflectors and emitters against closed forms: is every point of the mesh as near to the true surface, and
// every interpolated normal as near to the true one, as the tolerances say? Areas, closed solids, facets.
#include "optics_truth.h"

namespace {

using namespace optics_test;

TEST(OpticsReflector, ParaboloidIsAsNearAsAsked) {
  for (const Tolerance& tolerance : {fine, Tolerance{4e-5, 2 * deg}, Tolerance{1e-3, 0.02 * deg}, Tolerance{1e-6, 1}}) {
    const Mesh mesh = tessellate(paraboloid(0.020, 0.002, 0.060), tolerance);
    const Worst worst = compare(mesh, [](const P3& p) { return paraboloid_truth(p, 0.020); });
    expect_within(worst, tolerance);
    // Not finer than needed by more than the halvings explain: one of the two is used to a quarter at least.
    EXPECT_GT(std::max(worst.distance / tolerance.chord_m, worst.angle / tolerance.normal_rad), 0.25);
  }
}

TEST(OpticsReflector, ParaboloidHasItsArea) {
  const double f = 0.020, r = 0.060;
  const double exact = 8 * optics::pi * f * f / 3 * (std::pow(1 + r * r / (4 * f * f), 1.5) - 1);
  const Mesh coarse = tessellate(paraboloid(f, 0, r), {1e-4, 1}), dense = tessellate(paraboloid(f, 0, r), {1e-6, 1});
  EXPECT_LT(area(coarse), exact);  // inscribed
  EXPECT_NEAR(area(dense) / exact, 1, 1e-4);
  EXPECT_LT(std::abs(area(dense) - exact), std::abs(area(coarse) - exact) / 20);
  const Topology t = topology(dense);
  EXPECT_FALSE(t.closed);
  EXPECT_EQ(t.euler, 1);                                                   // a disc
  EXPECT_EQ(topology(tessellate(paraboloid(f, 0.01, r), fine)).euler, 0);  // a band
}

TEST(OpticsReflector, EllipsoidKeepsTheSumOfDistances) {
  for (const double c : {0.05, 0.08}) {
    const double a = 0.1, b2 = a * a - c * c;
    // At the focus' level the radius is the semi-latus rectum; depth a + c below the vertex: beyond the widest place.
    for (const Profile& profile : {ellipsoid(a, c, 0, b2 / a, 0), ellipsoid(a, c, 0.01, 0, a + c)}) {
      const Mesh mesh = tessellate(profile, fine);
      const Worst worst = compare(mesh, [&](const P3& p) {
        const P3 q = p - P3{0, 0, -2 * c}, up = normalize(p), uq = normalize(q);
        return implicit(2 * a - length(p) - length(q), (up + uq) * -1);
      });
      expect_within(worst, fine);
    }
    const Mesh mesh = tessellate(ellipsoid(a, c, 0, b2 / a, 0), fine);
    double low = 1;
    for (size_t i = 2; i < mesh.positions.size(); i += 3) low = std::min(low, double(mesh.positions[i]));
    EXPECT_NEAR(low, 0, 1e-8);
  }
}

TEST(OpticsReflector, ConeAndCylinder) {
  const Mesh open = tessellate(cone(0.02, 0.05, 0.04), fine);
  const double slant = std::hypot(0.03, 0.04);
  const auto truth = [&](const P3& p) {
    const double r = std::hypot(p.x, p.y);
    return Truth{(0.02 - p.z * 0.75 - r) * 0.04 / slant, P3{-0.04 * p.x / r, -0.04 * p.y / r, -0.03} * (1 / slant)};
  };
  expect_within(compare(open, truth), fine);
  EXPECT_NEAR(area(open) / (optics::pi * 0.07 * slant), 1, 1e-3);
  const Mesh pointed = tessellate(cone(0, 0.03, 0.04), fine);  // no normal at its tip
  expect_within(compare(
                    pointed,
                    [&](const P3& p) {
                      const double r = std::max(std::hypot(p.x, p.y), 1e-30);
                      return Truth{(-p.z * 0.75 - r) * 0.8, P3{-0.8 * p.x / r, -0.8 * p.y / r, -0.6}};
                    },
                    fine.chord_m),
                Tolerance{fine.chord_m, fine.normal_rad});
  const Mesh tube = tessellate(cone(0.03, 0.03, 0.1), fine);
  EXPECT_NEAR(area(tube) / (2 * optics::pi * 0.03 * 0.1), 1, 1e-3);
}

TEST(OpticsReflector, FacetsAreFlat) {
  Profile around = paraboloid(0.02, 0.005, 0.05);
  around.facets_around = 16;
  around.sections[0].facets_along = 9;
  const Mesh mesh = tessellate(around, fine);
  EXPECT_EQ(mesh.triangle_count(), 16u * 9 * 2);
  for (size_t t = 0; t < mesh.indices.size(); t += 3) {
    const uint32_t* i = &mesh.indices[t];
    const P3 a = vector(mesh.positions, i[0]), b = vector(mesh.positions, i[1]), c = vector(mesh.positions, i[2]);
    const P3 face = normalize(cross(b - a, c - a));
    for (int k = 0; k < 3; ++k) EXPECT_LT(length(face - vector(mesh.normals, i[k])), 1e-5);
    EXPECT_LT(std::abs(paraboloid_truth(a, 0.02).distance), 1e-8);  // corners on the smooth surface
  }
  // A prism: n flat sides, and one ring of bands that stays round.
  Profile prism = cone(0.03, 0.03, 0.1);
  prism.facets_around = 6;
  EXPECT_NEAR(area(tessellate(prism, fine)), 6 * 0.03 * 0.1, 1e-8);
  Profile bands = paraboloid(0.02, 0, 0.05);
  bands.sections[0].facets_along = 5;
  const Mesh banded = tessellate(bands, fine);
  double worst = 0;
  for (size_t v = 0; v < banded.normals.size() / 3; ++v) {  // each vertex has the slope of one of the five bands
    const P3 n = vector(banded.normals, v);
    double nearest = 1;
    for (int k = 0; k < 5; ++k) {
      const double r0 = 0.01 * k, r1 = 0.01 * (k + 1), slope = (r0 + r1) / 0.08;
      nearest = std::min(nearest, std::abs(n.z + 1 / std::hypot(1, slope)));
    }
    worst = std::max(worst, nearest);
  }
  EXPECT_LT(worst, 1e-6);
}

TEST(OpticsReflector, StripsOfAFacetedParaboloidAreCylinders) {
  Profile around = paraboloid(0.02, 0, 0.05);
  around.facets_around = 8;
  const Mesh mesh = tessellate(around, fine);
  const double c = std::cos(optics::pi / 8);
  expect_within(compare(mesh,
                        [&](const P3& p) {
                          // The middle of the facet's azimuth; there r / c is the profile's radius.
                          const double k = std::floor(std::atan2(p.y, p.x) / (optics::pi / 4) + 1e-7) + 0.5;
                          const double x = std::cos(k * optics::pi / 4), y = std::sin(k * optics::pi / 4);
                          const double r = p.x * x + p.y * y;
                          return implicit(0.08 * (0.02 - p.z) - r * r / (c * c),
                                          P3{-2 * r / (c * c) * x, -2 * r / (c * c) * y, -0.08});
                        }),
                fine);
}

TEST(OpticsReflector, PolylineIsStraightOrSmooth) {
  const std::vector<Point> points{{0.01, 0}, {0.02, -0.005}, {0.03, -0.02}, {0.035, -0.04}};
  const Mesh creased = tessellate(polyline(points, false), fine), smooth = tessellate(polyline(points, true), fine);
  double exact = 0;
  for (size_t i = 0; i + 1 < points.size(); ++i)
    exact += optics::pi * (points[i].r + points[i + 1].r) *
             std::hypot(points[i + 1].r - points[i].r, points[i + 1].z - points[i].z);
  EXPECT_NEAR(area(creased) / exact, 1, 1e-3);
  EXPECT_EQ(topology(smooth).euler, 0);
  // The smooth one passes all points, and its normals agree where two pieces meet.
  for (const Point& p : points) {
    std::vector<P3> normals;
    for (size_t v = 0; v < smooth.positions.size() / 3; ++v) {
      const P3 q = vector(smooth.positions, v);
      if (std::abs(q.y) < 1e-9 && q.x > 0 && std::abs(q.x - p.r) < 1e-8 && std::abs(q.z - p.z) < 1e-8)
        normals.push_back(vector(smooth.normals, v));
    }
    ASSERT_FALSE(normals.empty());
    EXPECT_LT(length(normals.front() - normals.back()), 1e-6);
  }
  // Points of a circle around the axis' point (0, -0.05): the cubic follows it, and it is level on the axis.
  std::vector<Point> arc;
  for (int i = 0; i <= 16; ++i) arc.push_back({0.05 * std::sin(i * 5 * deg), 0.05 * std::cos(i * 5 * deg) - 0.05});
  expect_within(compare(tessellate(polyline(arc, true), fine),
                        [](const P3& p) {
                          const P3 q = p - P3{0, 0, -0.05};
                          return Truth{0.05 - length(q), normalize(q) * -1};
                        }),
                {fine.chord_m + 2e-6, fine.normal_rad + 0.2 * deg});
}

TEST(OpticsEmitter, SphereCylinderDiscAndRectangle) {
  const double r = 0.001;
  const Mesh ball = tessellate(sphere(r), {1e-6, 1});
  expect_solid(ball, 4.0 / 3 * optics::pi * r * r * r, 5e-3);
  expect_within(compare(ball, [&](const P3& p) { return Truth{length(p) - r, normalize(p)}; }), {1e-6, 1});
  expect_solid(tessellate(cylinder(r, 0.01), {1e-6, 1}), optics::pi * r * r * 0.01, 2e-3);
  const Mesh flat = tessellate(disc(r), {1e-6, 1});
  EXPECT_NEAR(area(flat) / (optics::pi * r * r), 1, 2e-3);
  for (const Mesh& down : {flat, rectangle(0.02, 0.01)}) {
    const Worst worst = compare(down, [](const P3& p) { return Truth{-p.z, {0, 0, -1}}; });
    EXPECT_EQ(worst.distance, 0);
    EXPECT_EQ(worst.angle, 0);
    EXPECT_LT(worst.face_angle, 1e-6);
  }
  EXPECT_NEAR(area(rectangle(0.02, 0.01)), 2e-4, 1e-10);
}

}  // namespace
