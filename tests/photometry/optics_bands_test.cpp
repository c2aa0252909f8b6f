// The quadrics that stand for round shapes: do they join without a gap, follow the profile as closely as optics.h says,
// and are there few of them?
#include <gtest/gtest.h>

#include <cmath>

#include "photometry/optics.h"

namespace {

using namespace optics;

// Of the band that has the point between its ends and within its bulge; infinite where none has.
void miss(const Mesh& mesh, const ProfilePoint& p, double size, double& distance, double& angle) {
  distance = angle = INFINITY;
  for (const Band& b : mesh.bands) {
    const double r = b.to.r - b.from.r, z = b.to.z - b.from.z, length = std::hypot(r, z);
    const double along = ((p.r - b.from.r) * r + (p.z - b.from.z) * z) / length;
    const double aside = std::abs((p.r - b.from.r) * z - (p.z - b.from.z) * r) / length;
    if (along < -1e-10 * size || along > length + 1e-10 * size || aside > b.bulge + 1e-10 * size) continue;
    double across_r, across_z;
    b.gradient(p.r, p.z, across_r, across_z);
    const double away = std::abs(b.value(p.r, p.z)) / std::hypot(across_r, across_z);
    if (away >= distance) continue;
    distance = away;
    angle = std::abs(std::atan2(across_r * p.normal_z - across_z * p.normal_r,
                                across_r * p.normal_r + across_z * p.normal_z));
  }
}

void expect_bands(const Profile& profile, size_t most) {
  const double size = largest_radius(profile);
  const Mesh mesh = tessellate(profile, {1e-3 * size, 10 * pi / 180});
  size_t triangles = 0;
  for (size_t i = 0; i < mesh.bands.size(); ++i) {
    const Band& b = mesh.bands[i];
    triangles += mesh.columns * (b.from.r == 0 || b.to.r == 0 ? 1 : 2);
    if (i == 0) continue;
    EXPECT_NEAR(b.from.r, mesh.bands[i - 1].to.r, 1e-14);
    EXPECT_NEAR(b.from.z, mesh.bands[i - 1].to.z, 1e-14);
  }
  EXPECT_EQ(triangles, mesh.triangle_count());
  EXPECT_LE(mesh.bands.size(), most);
  for (const Section& section : profile.sections)
    for (int i = 1; i < 1000; ++i) {
      const ProfilePoint p = section.at(i / 1000.0);
      double distance, angle;
      miss(mesh, p, size, distance, angle);
      EXPECT_LT(distance, 1.1e-7 * size);  // what lies between the places that were tried
      if (p.r > 1e-6 * size) {
        EXPECT_LT(angle, 1.1e-4);
      }
    }
}

TEST(OpticsBands, FollowQuadricsInFewPieces) {
  for (const Profile& profile :
       {paraboloid(0.02, 0.002, 0.06), ellipsoid(0.1, 0.05, 0, 0, 0.15), cone(0.008, 0.03, 0.045), cone(0, 0.03, 0.04),
        cone(0.03, 0.03, 0.1), lens({0.05, -2.2, {}}, {-0.06, 0.3, {}}, 0.02, 0.01), lens({}, {}, 0.03, 0.003)})
    expect_bands(profile, 64);
}

TEST(OpticsBands, FollowOtherCurves) {
  expect_bands(lens({0.05, 0, {2e3, -1e6, 0, 0}}, {}, 0.02, 0.01), 400);
  expect_bands(lens({-0.03, 0, {3e3, 0, 0, 0}}, {}, 0.02, 0.02), 400);  // level at the axis and off it
  expect_bands(polyline({{0, 0}, {0.01, -0.002}, {0.02, -0.009}, {0.025, -0.02}, {0.026, -0.035}}, true), 400);
  Collimator d;
  d.cavity_radius_m = 0.004, d.cavity_depth_m = 0.005, d.wall_thickness_m = 0.001, d.ior = 1.49;
  expect_bands(collimator(d), 400);
}

TEST(OpticsBands, FacetedShapesHaveNone) {
  Profile around = paraboloid(0.02, 0.005, 0.05);
  around.facets_around = 16;
  EXPECT_TRUE(tessellate(around, {1e-4, 0.1}).bands.empty());
}

}  // namespace
