// Quadrics of revolution through pieces of a profile, see optics.h: cones, cylinders, spheres, paraboloids, ellipsoids,
// hyperboloids and planes are met by any piece, other curves by short ones.
#include <algorithm>
#include <cmath>

#include "photometry/optics_face.h"

namespace optics {
namespace {

// Rounding of single precision is 6e-8 of a distance; 1e-4 rad is 0.006 degrees.
constexpr double max_distance = 1e-7, max_angle = 1e-4;
// A piece is told from the rest of its quadric by how far it lies from its chord: it must be a graph over that.
constexpr double max_turn = 0.8;
constexpr double shortest = 1e-6;  // no quadric follows a curve that is level off the axis: its bands end here
constexpr int steps = 8;
constexpr double between_steps = 1.25;  // the largest distance from the chord, which lies between two of them

double turn(const ProfilePoint& a, const ProfilePoint& b) {
  return std::abs(std::atan2(a.normal_r * b.normal_z - a.normal_z * b.normal_r,
                             a.normal_r * b.normal_r + a.normal_z * b.normal_z));
}

// The first of three points is on it as it is written; the other two give two equations for three coefficients.
void fit(Band& band, const ProfilePoint& middle, double size) {
  const auto square = [&](double r) { return (r - band.from.r) * (r + band.from.r); };
  const double q[2] = {square(middle.r), square(band.to.r)}, h[2] = {middle.z - band.from.z, band.to.z - band.from.z};
  if (std::max(std::abs(h[0]), std::abs(h[1])) <= 1e-12 * size) {  // a plane
    band.square_r = band.square_z = 0, band.linear = 1;
  } else {
    band.square_r = h[0] * h[1] * (h[1] - h[0]);
    band.linear = h[0] * h[0] * q[1] - q[0] * h[1] * h[1];
    band.square_z = q[0] * h[1] - h[0] * q[1];
  }
  double r, z;
  band.gradient(middle.r, middle.z, r, z);
  const double side = r * middle.normal_r + z * middle.normal_z, scale = std::copysign(1 / std::hypot(r, z), side);
  band.square_r *= scale, band.square_z *= scale, band.linear *= scale;
}

}  // namespace

double Band::value(double r, double z) const {
  const double h = z - from.z;
  return square_r * (r - from.r) * (r + from.r) + h * (square_z * h + linear);
}

void Band::gradient(double r, double z, double& along_r, double& along_z) const {
  along_r = 2 * square_r * r;
  along_z = 2 * square_z * (z - from.z) + linear;
}

std::optional<Band> fit_band(const Section& section, double low, double high, double size) {
  const ProfilePoint a = section.at(low), b = section.at(high);
  Band band{{a.r, a.z}, {b.r, b.z}};
  fit(band, section.at(0.5 * (low + high)), size);
  const double chord = std::hypot(b.r - a.r, b.z - a.z);
  for (int i = 0; i <= steps; ++i) {
    const ProfilePoint p = section.at(low + (high - low) * i / steps);
    double r, z;
    band.gradient(p.r, p.z, r, z);
    const double rate = std::hypot(r, z);
    const double aside = std::abs((p.r - a.r) * (b.z - a.z) - (p.z - a.z) * (b.r - a.r)) / chord;
    band.bulge = std::max(band.bulge, between_steps * aside);
    if (p.r <= max_distance * size || chord <= shortest * size) continue;  // the tip of a cone has no normal
    if (!(std::abs(band.value(p.r, p.z)) <= max_distance * size * rate)) return std::nullopt;
    const double cross = r * p.normal_z - z * p.normal_r, dot = r * p.normal_r + z * p.normal_z;
    if (!(std::abs(std::atan2(cross, dot)) <= max_angle)) return std::nullopt;
    if (std::max(turn(a, p), turn(p, b)) > max_turn) return std::nullopt;
  }
  return band;
}

}  // namespace optics
