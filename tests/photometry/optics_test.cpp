// Shapes of optics against closed forms: is every point of the mesh as near to the true surface, and every interpolated
// normal as near to the true one, as the tolerances say? Areas, volumes, closed solids, and what mirrors and lenses do
// to a ray at their vertices.
#include "photometry/optics.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "support/shapes.h"

namespace {

using namespace optics;
using ups::test::cross;
using ups::test::dot;
using ups::test::length;
using ups::test::normalize;
using ups::test::P3;

constexpr double deg = optics::pi / 180;
constexpr Tolerance fine{2e-5, 0.1 * deg};

P3 vector(const std::vector<float>& values, size_t i) {
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
Truth implicit(double value, const P3& gradient) { return {value / length(gradient), normalize(gradient)}; }

Truth paraboloid_truth(const P3& p, double f) {  // inside is the front
  return implicit(4 * f * (f - p.z) - p.x * p.x - p.y * p.y, P3{-2 * p.x, -2 * p.y, -4 * f});
}

void expect_within(const Worst& worst, const Tolerance& tolerance) {
  EXPECT_LE(worst.distance, tolerance.chord_m * 1.001 + 1e-8);
  EXPECT_LE(worst.angle, tolerance.normal_rad * 1.001 + 1e-6);
  EXPECT_LE(worst.normal_length, 2e-7);
  EXPECT_LT(worst.face_angle, 30 * deg);  // turned to the front
}

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

// ---- lenses ----

double cap_volume(double radius, double rim) {
  const double h = radius - std::sqrt(radius * radius - rim * rim);
  return optics::pi * h * h * (radius - h / 3);
}

void expect_solid(const Mesh& mesh, double exact_volume, double tolerance) {
  const Topology t = topology(mesh);
  EXPECT_TRUE(t.closed);
  EXPECT_EQ(t.euler, 2);
  EXPECT_NEAR(volume(mesh) / exact_volume, 1, tolerance);
}

TEST(OpticsLens, SphericalLensesAreClosedAndHaveTheirVolume) {
  const double rim = 0.02, thickness = 0.006, r = 0.05;
  const double slab = optics::pi * rim * rim * thickness, cap = cap_volume(r, rim);
  const double sag = r - std::sqrt(r * r - rim * rim), beside = optics::pi * rim * rim * sag - cap;
  const Tolerance tolerance{2e-6, 0.1 * deg};
  expect_solid(tessellate(lens({}, {r}, rim, thickness), tolerance), slab - beside, 5e-4);         // plano-convex
  expect_solid(tessellate(lens({r}, {}, rim, thickness), tolerance), slab - beside, 5e-4);         // convex side first
  expect_solid(tessellate(lens({r}, {r}, rim, 0.009), tolerance), slab * 1.5 - 2 * beside, 5e-4);  // bi-convex
  expect_solid(tessellate(lens({-r}, {r}, rim, thickness), tolerance), slab, 5e-4);                // meniscus
  expect_solid(tessellate(lens({-r}, {-r}, rim, thickness), tolerance), slab + 2 * beside, 5e-4);
  expect_solid(tessellate(lens({}, {}, rim, thickness), tolerance), slab, 5e-4);  // plate
  // A hemisphere: the face ends upright on the rim.
  expect_solid(tessellate(lens({}, {0.02}, 0.02, 0.021), tolerance),
               optics::pi * (0.02 * 0.02 * 0.001 + 2.0 / 3 * 0.02 * 0.02 * 0.02), 5e-4);
}

TEST(OpticsLens, ConicsAndAspheresAreAsNearAsAsked) {
  const Face faces[] = {{0.05}, {-0.05}, {0.05, -2.25}, {0.03, -1}, {0.05, 0.5, {200, -3e4, 1e7, 0}}, {0, 0, {300}}};
  for (const Face& face : faces) {
    const Mesh mesh = tessellate(lens({}, face, 0.02, 0.012), fine);
    expect_solid(mesh, volume(mesh), 0);
    const double c = face.radius_m == 0 ? 0 : 1 / face.radius_m;
    Mesh exit;  // the triangles of the exit face: they alone have normals that point down
    exit.positions = mesh.positions, exit.normals = mesh.normals;
    for (size_t t = 0; t < mesh.indices.size(); t += 3)
      if (mesh.normals[3 * mesh.indices[t] + 2] < -0.01f)
        exit.indices.insert(exit.indices.end(), {mesh.indices[t], mesh.indices[t + 1], mesh.indices[t + 2]});
    ASSERT_GT(exit.indices.size(), 0u);
    const Worst worst = compare(exit, [&](const P3& p) {
      const auto sag = [&](double r) {
        double value = c * r * r / (1 + std::sqrt(1 - (1 + face.conic) * c * c * r * r));
        for (int i = 0; i < 4; ++i) value += face.coefficients[i] * std::pow(r, 4 + 2 * i);
        return value;
      };
      const double r = std::hypot(p.x, p.y), e = 1e-6;
      const double slope = (sag(r + e) - sag(r - e)) / (2 * e);  // independent of the analytic normal
      const P3 gradient{r > 0 ? slope * p.x / r : 0, r > 0 ? slope * p.y / r : 0, -1};
      return implicit(-0.012 + sag(r) - p.z, gradient);
    });
    expect_within(worst, fine);
  }
}

// Snell; `n` is the relative index behind the surface, the normal is against the ray.
P3 refracted(const P3& d, const P3& normal, double n) {
  const double cosine = -dot(d, normal), sine2 = (1 - cosine * cosine) / (n * n);
  return d * (1 / n) + normal * (cosine / n - std::sqrt(1 - sine2));
}

TEST(OpticsLens, HyperboloidFocusesParallelLightInAPoint) {
  const double n = 1.5, f = 0.1;  // vertex radius f (n - 1) and conic -n^2, plane side first
  const Mesh mesh = tessellate(lens({}, {f * (n - 1), -n * n}, 0.06, 0.03), fine);
  size_t checked = 0;
  for (size_t v = 0; v < mesh.positions.size() / 3; ++v) {
    const P3 p = vector(mesh.positions, v), normal = vector(mesh.normals, v);
    if (!(normal.z < -0.01) || !(p.x > 0.001)) continue;
    const P3 d = refracted({0, 0, -1}, normal * -1, 1 / n);
    EXPECT_NEAR(p.z + d.z * (-p.x / d.x), -0.03 - f, 2e-6 * f / p.x * 0.05 + 2e-6);
    ++checked;
  }
  EXPECT_GT(checked, 100u);
}

TEST(OpticsCollimator, WallMakesTheLightOfItsSourceParallel) {
  Collimator d;
  d.cavity_radius_m = 0.004, d.cavity_depth_m = 0.005, d.wall_thickness_m = 0.001, d.ior = 1.49;
  const Mesh mesh = tessellate(collimator(d), {5e-6, 0.1 * deg});
  expect_solid(mesh, volume(mesh), 0);
  EXPECT_GT(volume(mesh), 0);
  size_t wall = 0, centre = 0;
  for (size_t v = 0; v < mesh.positions.size() / 3; ++v) {
    const P3 p = vector(mesh.positions, v), normal = vector(mesh.normals, v);
    const double r = std::hypot(p.x, p.y);
    const double normal_r = r > 0 ? (normal.x * p.x + normal.y * p.y) / r : 0;
    P3 back;  // from the place where light enters the solid, to the source
    P3 entry;
    if (r > 0.0045 && normal_r > 0.1 && normal.z > 0.01) {  // the outer wall
      const P3 in = P3{0, 0, -1} - normal * (2 * dot(P3{0, 0, -1}, normal));
      const double in_r = (in.x * p.x + in.y * p.y) / r;
      ASSERT_GT(in_r, 0);
      entry = p - in * ((r - 0.004) / in_r);
      back = refracted(in * -1, normalize(P3{p.x, p.y, 0}), 1 / d.ior);  // out of the glass: normal against -in
      ++wall;
    } else if (r < 0.0039 && r > 1e-4 && normal.z > 0.01) {  // the lens
      entry = p;
      back = refracted({0, 0, 1}, normal * -1, 1 / d.ior);
      ++centre;
    } else {
      continue;
    }
    const P3 miss = entry - back * dot(entry, back);
    EXPECT_LT(length(miss), 1e-7 + 1e-5 * length(entry)) << p.x << " " << p.y << " " << p.z;
  }
  EXPECT_GT(wall, 100u);
  EXPECT_GT(centre, 100u);
}

TEST(OpticsCollimator, AllKindsAreClosed) {
  Collimator base;
  base.cavity_radius_m = 0.004, base.cavity_depth_m = 0.005, base.wall_thickness_m = 0.001;
  const auto expect_closed = [](const Collimator& d) {
    const Mesh mesh = tessellate(collimator(d), {2e-5, 0.5 * deg});
    const Topology t = topology(mesh);
    EXPECT_TRUE(t.closed);
    EXPECT_EQ(t.euler, 2);
    EXPECT_GT(volume(mesh), 0);
  };
  Collimator d = base;
  d.height_m = 0.05, d.exit = {0.1}, d.exit_facets_along = 6;
  expect_closed(d);
  d = base, d.facets_around = 12;
  expect_closed(d);
  d = base, d.wall = Collimator::Wall::paraboloid, d.focal_length_m = 0.003, d.height_m = 0.02;
  d.lens = {std::numeric_limits<double>::infinity()};
  expect_closed(d);
  d.wall = Collimator::Wall::polyline, d.height_m = 0;
  d.wall_points = {{0.006, 0}, {0.009, -0.006}, {0.011, -0.015}};
  expect_closed(d);
  d.smooth = false;
  expect_closed(d);
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

// ---- what is out of range ----

template <class Make>
void expect_refused(const Make& make, std::initializer_list<const char*> words) {
  try {
    make();
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& e) {
    for (const char* word : words) EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
  }
}

TEST(OpticsErrors, NameFieldValueAndRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, inf}) {
    expect_refused([&] { paraboloid(bad, 0, 1); }, {"focal_length_m", "above 0"});
    expect_refused([&] { paraboloid(1, 0, bad); }, {"aperture_radius_m", "above 0"});
    expect_refused([&] { cone(0, 1, bad); }, {"depth_m"});
    expect_refused([&] { disc(bad); }, {"radius_m"});
    expect_refused([&] { rectangle(1, bad); }, {"length_m"});
    expect_refused([&] { lens({}, {}, 0.1, bad); }, {"thickness_m"});
    expect_refused([&] { tessellate(disc(1), {bad, 0.1}); }, {"chord_tolerance_m"});
    expect_refused([&] { tessellate(disc(1), {0.1, bad}); }, {"normal_tolerance_rad"});
  }
  expect_refused([] { paraboloid(1, 0.5, 0.5); }, {"inner_radius_m is 0.5", "less than aperture_radius_m"});
  expect_refused([] { ellipsoid(0.1, 0.1, 0, 0.05, 0); }, {"half_distance_m", "less than semi_axis_m"});
  expect_refused([] { ellipsoid(0.1, 0.05, 0, 0.09, 0); }, {"aperture_radius_m", "semi-minor"});
  expect_refused([] { ellipsoid(0.1, 0.05, 0, 0, 0.2); }, {"depth_m is 0.2"});
  expect_refused([] { ellipsoid(0.1, 0.05, 0, 0.05, 0.1); }, {"aperture_radius_m", "0 where depth_m is given"});
  expect_refused([] { lens({}, {0.05}, 0.04, 0.01); }, {"thickness_m is 0.01", "cross", "from the axis"});
  expect_refused([] { lens({0.01}, {}, 0.02, 0.1); }, {"entry_radius_m is 0.01", "ends 0.01 m"});
  expect_refused([&] { lens({}, {0.1, nan}, 0.02, 0.1); }, {"exit_conic"});
  expect_refused([&] { lens({}, {0.1, 0, {0, nan}}, 0.02, 0.1); }, {"exit_coefficients[1]"});
  expect_refused([] { polyline({{0.1, 0}}, true); }, {"number of points of profile_rz_m is 1"});
  expect_refused([] { polyline({{0.1, 0}, {-0.1, 1}}, true); }, {"point 1's r"});
  expect_refused([] { polyline({{0.1, 0}, {0.1, 0}}, true); }, {"point 1", "length"});
  expect_refused([] { polyline({{0.1, 0}, {0, 1}, {0.1, 2}}, true); }, {"point 1's r", "axis"});
}

TEST(OpticsErrors, CollimatorsThatCannotBe) {
  Collimator base;
  base.cavity_radius_m = 0.004, base.cavity_depth_m = 0.005, base.wall_thickness_m = 0.001;
  const auto refused = [&](const auto& change, std::initializer_list<const char*> words) {
    Collimator d = base;
    change(d);
    expect_refused([&] { collimator(d); }, words);
  };
  refused([](auto& d) { d.cavity_radius_m = 0; }, {"cavity_radius_m"});
  refused([](auto& d) { d.wall_thickness_m = 0; }, {"wall_thickness_m"});
  refused([](auto& d) { d.ior = 1; }, {"ior"});
  refused([](auto& d) { d.height_m = 0.001; }, {"height_m", "height of the wall"});
  refused([](auto& d) { d.exit = {-0.0145}; }, {"height_m", "meets the lens"});
  refused([](auto& d) { d.wall = Collimator::Wall::paraboloid, d.focal_length_m = 0.001, d.height_m = 0.02; },
          {"cavity_radius_m", "outer wall"});
  refused(
      [](auto& d) {
        d.wall = Collimator::Wall::polyline, d.wall_points = {{0.01, -1}, {0.02, -2}};
      },
      {"point 0's z"});
  refused(
      [](auto& d) {
        d.wall = Collimator::Wall::polyline, d.wall_points = {{0.01, 0}, {0.02, 1}};
      },
      {"point 1's z"});
}

TEST(OpticsErrors, TooManyTrianglesNameTheTolerance) {
  expect_refused([] { tessellate(sphere(1), {1e-15, 1}); }, {"chord_tolerance_m", "4000000"});
  expect_refused([] { tessellate(paraboloid(0.02, 0, 0.06), {1e-3, 1e-7}); }, {"normal_tolerance_rad", "4000000"});
  EXPECT_LT(tessellate(paraboloid(0.02, 0, 0.06), {6e-5, 0.1 * deg}).triangle_count(), 20000u);
}

}  // namespace
