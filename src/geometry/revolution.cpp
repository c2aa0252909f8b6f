// See revolution.h. A point of a band is told by s, its place along the chord between the circles, and its angle; s and
// the angle's share w of a column are those of the quad that the column's triangles make up.
#include "geometry/revolution.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace ups {
namespace {

constexpr double two_pi = 6.283185307179586;

// In the (r, z) half-plane.
struct Chord {
  double r, z, length;  // direction, of length 1
  explicit Chord(const RevolutionBand& b) : r(b.to_r - b.from_r), z(b.to_z - b.from_z), length(b.length()) {
    r /= length, z /= length;
  }
};

struct Quad {
  uint32_t column;
  double s, w;
};

// Corners of a quad: a and b of the first circle, c and d, across from b and a, of the second. Triangles: a b c and
// a c d, or the one of them that has an area.
void to_address(const RevolutionBand& band, const Quad& q, RevolutionHit& hit) {
  const auto set = [&](uint32_t primitive, double u, double v) {
    hit.primitive = band.first_triangle + primitive;
    hit.u = float(u), hit.v = float(v);
  };
  if (band.pole_first()) return set(q.column, q.s * q.w, q.s * (1 - q.w));
  if (band.pole_last()) return set(q.column, (1 - q.s) * q.w, q.s);
  if (q.w >= q.s) return set(2 * q.column, q.w - q.s, q.s);
  set(2 * q.column + 1, q.w, q.s - q.w);
}

Quad to_quad(const RevolutionBand& band, uint32_t primitive, double u, double v) {
  primitive -= band.first_triangle;
  const auto share = [](double part, double whole) { return whole > 0 ? std::clamp(part / whole, 0.0, 1.0) : 0.5; };
  if (band.pole_first()) return {primitive, u + v, share(u, u + v)};
  if (band.pole_last()) return {primitive, v, share(u, 1 - v)};
  if (primitive % 2 == 0) return {primitive / 2, v, u + v};
  return {primitive / 2, u + v, u};
}

double value(const RevolutionBand& b, double r, double z) {
  const double h = z - b.from_z;
  return b.square_r * (r - b.from_r) * (r + b.from_r) + h * (b.square_z * h + b.linear);
}

// How far from the chord the curve is at one of its points (r, z).
double offset(const RevolutionBand& b, const Chord& chord, double r, double z) {
  // Along the chord's left, (-chord.z, chord.r): value + rate y + square y^2 = 0.
  const double square = b.square_r * chord.z * chord.z + b.square_z * chord.r * chord.r;
  const double half = -b.square_r * r * chord.z + (b.square_z * (z - b.from_z) + 0.5 * b.linear) * chord.r;
  const double rest = value(b, r, z), root = half * half - square * rest;
  const double sum = half + std::copysign(std::sqrt(std::max(root, 0.0)), half);
  return sum == 0 ? 0 : std::clamp(-rest / sum, -b.bulge, b.bulge);
}

// Real roots of a t^2 + 2 b t + c, the lower one first; their number.
int solve(double a, double b, double c, double (&t)[2]) {
  const double root = b * b - a * c;
  if (!(root >= 0)) return 0;
  const double sum = -(b + std::copysign(std::sqrt(root), b));
  int count = 0;
  if (a != 0 && std::isfinite(sum / a)) t[count++] = sum / a;
  if (sum != 0 && std::isfinite(c / sum)) t[count++] = c / sum;
  if (count == 2 && t[1] < t[0]) std::swap(t[0], t[1]);
  return count;
}

}  // namespace

bool intersect(const Revolution& shape, const RevolutionBand& band, const Vec3d& o, const Vec3d& d, double near,
               double far, RevolutionHit& hit) {
  // From where the ray is nearest to the band's middle: a far origin would take digits of the roots.
  const Vec3d middle(0, 0, 0.5 * (band.from_z + band.to_z));
  const double start = dot(middle - o, d) / length2(d);
  const Vec3d p = o + d * start;
  const double h = p.z - band.from_z;
  const double a = band.square_r * (d.x * d.x + d.y * d.y) + band.square_z * d.z * d.z;
  const double b = band.square_r * (p.x * d.x + p.y * d.y) + (band.square_z * h + 0.5 * band.linear) * d.z;
  double t[2];
  const double c = band.square_r * (p.x * p.x + p.y * p.y - band.from_r * band.from_r) +
                   h * (band.square_z * h + band.linear);
  const int count = solve(a, b, c, t);
  if (count == 0) return false;
  const Chord chord(band);
  for (int i = 0; i < count; ++i) {
    hit.t = start + t[i];
    if (!(hit.t > near && hit.t < far)) continue;
    const Vec3d at = p + d * t[i];
    const double r = std::hypot(at.x, at.y) - band.from_r, z = at.z - band.from_z;
    const double along = r * chord.r + z * chord.z, across = r * chord.z - z * chord.r;
    if (!(along >= -shape.margin && along <= chord.length + shape.margin)) continue;
    if (!(std::abs(across) <= band.bulge + shape.margin)) continue;  // another part of the quadric
    double turn = std::atan2(at.y, at.x) / two_pi;
    turn = (turn < 0 ? turn + 1 : turn) * shape.columns;
    const uint32_t column = std::min(uint32_t(turn), shape.columns - 1);
    const double s = std::clamp(along / chord.length, 0.0, 1.0), w = std::clamp(turn - column, 0.0, 1.0);
    to_address(band, {column, s, w}, hit);
    return true;
  }
  return false;
}

RevolutionPoint point_at(const Revolution& shape, uint32_t primitive, double u, double v, double inset) {
  const auto above = std::upper_bound(shape.bands.begin(), shape.bands.end(), primitive,
                                      [](uint32_t p, const RevolutionBand& b) { return p < b.first_triangle; });
  const RevolutionBand& band = *(above - 1);
  const Chord chord(band);
  const Quad q = to_quad(band, primitive, u, v);
  const double kept = std::min(inset, 0.125 * chord.length);
  const double along = std::clamp(q.s * chord.length, kept, chord.length - kept);
  double r = band.from_r + chord.r * along, z = band.from_z + chord.z * along;
  const double y = offset(band, chord, r, z);
  r -= chord.z * y, z += chord.r * y;
  const double angle = two_pi * (q.column + q.w) / shape.columns, c = std::cos(angle), s = std::sin(angle);
  const double along_r = 2 * band.square_r * r, along_z = 2 * band.square_z * (z - band.from_z) + band.linear;
  return {{r * c, r * s, z}, {along_r * c, along_r * s, along_z}};
}

RevolutionHull hull(const Revolution& shape, const RevolutionBand& band, uint32_t sector, uint32_t sectors) {
  const Chord chord(band);
  const double half = 0.5 * two_pi / sectors, beyond = shape.margin, aside = band.bulge + shape.margin;
  RevolutionHull out;
  int n = 0;
  for (const double y : {-aside, aside})
    for (const double end : {-beyond, chord.length + beyond}) {
      const double r = band.from_r + chord.r * end - chord.z * y, z = band.from_z + chord.z * end + chord.r * y;
      for (int k = 0; k < 3; ++k) {  // the ends of the arc, and where its tangents there meet
        const double angle = (2 * sector + k) * half, at = k == 1 ? r / std::cos(half) : r;
        out.p[n++] = {at * std::cos(angle), at * std::sin(angle), z};
      }
    }
  return out;
}

}  // namespace ups
