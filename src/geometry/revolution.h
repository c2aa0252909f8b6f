// Surfaces of revolution as they are traced: bands of quadrics about z, in double. Their points have the addresses of
// the mesh's triangles, so that everything else sees triangles. No Embree; see traced_revolution.cpp.
#pragma once
#include <cstdint>
#include <vector>

#include "base/vec.h"

namespace ups {

// square_r (r^2 - from_r^2) + square_z h^2 + linear h = 0, h = z - from_z, between two circles; the gradient points to
// the front.
struct RevolutionBand {
  double from_r, from_z, to_r, to_z;
  double square_r, square_z, linear;
  double bulge;             // the curve is no farther from its chord
  uint32_t first_triangle;  // of `columns` triangles where an end is on the axis, else of 2 a column
  double length() const { return std::hypot(to_r - from_r, to_z - from_z); }  // of the chord
  bool pole_first() const { return from_r == 0; }
  bool pole_last() const { return !pole_first() && to_r == 0; }
};

struct Revolution {
  uint32_t columns = 0;
  double margin = 0;  // bands reach so much farther: far less than an error bound, more than rounding
  std::vector<RevolutionBand> bands;
};

struct RevolutionHit {
  double t;
  uint32_t primitive;
  float u, v;
};
// The first point of a band with near < t < far, whichever its column. d of any length.
bool intersect(const Revolution& shape, const RevolutionBand& band, const Vec3d& o, const Vec3d& d, double near,
               double far, RevolutionHit& hit);

struct RevolutionPoint {
  Vec3d p, n;  // n of any length
};
// From an address, kept off the band's ends by `inset`.
RevolutionPoint point_at(const Revolution& shape, uint32_t primitive, double u, double v, double inset);

// Points whose hull holds one of so many equal sectors of a band.
struct RevolutionHull {
  Vec3d p[12];
};
RevolutionHull hull(const Revolution& shape, const RevolutionBand& band, uint32_t sector, uint32_t sectors);

}  // namespace ups
