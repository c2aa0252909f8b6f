// Shapes of lenses and collimators against closed forms: is every point of the mesh as near to the true surface as the
// tolerances say? Volumes, closed solids, and what they do to a ray at their vertices.
#include <limits>

#include "optics_truth.h"

namespace {

using namespace optics_test;

double cap_volume(double radius, double rim) {
  const double h = radius - std::sqrt(radius * radius - rim * rim);
  return optics::pi * h * h * (radius - h / 3);
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

// Whether 1 - (r / R)^2 at r = R comes out as 0 or a rounding below depends on R.
TEST(OpticsLens, HemispheresOfAnySizeAreLenses) {
  for (int tenths = 10; tenths <= 1000; ++tenths) {
    const double r = 1e-4 * tenths;
    EXPECT_NO_THROW(lens({}, {r}, r, 1.05 * r)) << r;
    EXPECT_NO_THROW(lens({-r}, {}, r, 0.05 * r)) << r;
  }
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

}  // namespace
