// The profiles of reflectors, lenses and emitters, see optics.h; tessellated by optics_mesh.cpp. Collimators are in
// optics_collimator.cpp.
#include "photometry/optics.h"

#include <charconv>
#include <cmath>
#include <stdexcept>

#include "photometry/optics_face.h"

namespace optics {

std::string text(double value) {
  char buffer[32];
  return {buffer, std::to_chars(buffer, buffer + sizeof buffer, float(value)).ptr};
}

void fail(const std::string& field, double value, const std::string& requirement) {
  throw std::invalid_argument(field + " is " + text(value) + "; it must be " + requirement);
}

void positive(double value, const char* field) {
  if (!(std::isfinite(value) && value > 0)) fail(field, value, "finite and above 0");
}

Section line(const Point& a, const Point& b) {
  const double dr = b.r - a.r, dz = b.z - a.z, length = std::hypot(dr, dz);
  return {[=](double t) {
    if (t >= 1) return ProfilePoint{b.r, b.z, dz / length, -dr / length};  // the end exactly: the next one starts there
    return ProfilePoint{a.r + t * dr, a.z + t * dz, dz / length, -dr / length};
  }};
}

namespace {

ProfilePoint unit(double r, double z, double normal_r, double normal_z) {
  const double length = std::hypot(normal_r, normal_z);
  return {r, z, normal_r / length, normal_z / length};
}

double between(double a, double b, double t) { return t >= 1 ? b : a + t * (b - a); }

void check_hole(double inner_radius, double aperture_radius) {
  positive(aperture_radius, "aperture_radius_m");
  if (!(inner_radius >= 0 && inner_radius < aperture_radius))
    fail("inner_radius_m", inner_radius, "at least 0 and less than aperture_radius_m, " + text(aperture_radius));
}

}  // namespace

// ---- reflectors ----

Profile paraboloid(double f, double inner_radius, double aperture_radius) {
  positive(f, "focal_length_m");
  check_hole(inner_radius, aperture_radius);
  return {{{[=](double t) {
    const double r = between(inner_radius, aperture_radius, t);
    return unit(r, f - r * r / (4 * f), -r, -2 * f);
  }}}};
}

Profile ellipsoid(double a, double c, double inner_radius, double aperture_radius, double depth) {
  positive(a, "semi_axis_m");
  if (!(c >= 0 && c < a)) fail("half_distance_m", c, "at least 0 and less than semi_axis_m, " + text(a));
  const double b = std::sqrt((a - c) * (a + c));
  if (!(depth >= 0 && depth < 2 * a)) fail("depth_m", depth, "0 or more and less than 2 semi_axis_m, " + text(2 * a));
  double end;  // angle from the vertex, of the auxiliary circle
  if (depth > 0) {
    end = std::acos(1 - depth / a);
    if (aperture_radius != 0)
      fail("aperture_radius_m", aperture_radius, "0 where depth_m is given, as it follows from it");
  } else {
    positive(aperture_radius, "aperture_radius_m");
    if (!(aperture_radius <= b))
      fail("aperture_radius_m", aperture_radius, "at most the semi-minor axis, " + text(b) + ", where depth_m is 0");
    end = std::asin(aperture_radius / b);
  }
  if (!(inner_radius >= 0 && inner_radius < b && std::asin(inner_radius / b) < end))
    fail("inner_radius_m", inner_radius,
         "at least 0 and above the aperture (its radius is " + text(b * std::sin(end)) + ")");
  const double start = std::asin(inner_radius / b);
  return {{{[=](double t) {
    const double angle = between(start, end, t), r = b * std::sin(angle), z = a * std::cos(angle);
    return unit(r, z - c, -std::sin(angle) / b, -std::cos(angle) / a);
  }}}};
}

Profile cone(double inner_radius, double aperture_radius, double depth) {
  if (!(inner_radius >= 0 && std::isfinite(inner_radius)))
    fail("inner_radius_m", inner_radius, "finite and at least 0");
  positive(aperture_radius, "aperture_radius_m");
  positive(depth, "depth_m");
  return {{line({inner_radius, 0}, {aperture_radius, -depth})}};
}

// ---- polylines ----

namespace {

void check_points(const std::vector<Point>& points, const std::string& name) {
  if (points.size() < 2 || points.size() > 100'000)
    fail("the number of points of " + name, double(points.size()), "2 to 100000");
  for (size_t i = 0; i < points.size(); ++i) {
    const auto& [r, z] = points[i];
    const std::string field = name + ": point " + std::to_string(i);
    if (!(r >= 0 && std::isfinite(r))) fail(field + "'s r", r, "finite and at least 0");
    if (!std::isfinite(z)) fail(field + "'s z", z, "finite");
    if (i > 0 && !(std::hypot(r - points[i - 1].r, z - points[i - 1].z) > 0))
      throw std::invalid_argument(field + " lies where the one before it does; each piece must have a length");
    const bool end = i == 0 || i + 1 == points.size();
    if (!end && r == 0) fail(field + "'s r", r, "above 0 between the ends: the axis is an end of the surface");
  }
}

// Slope at the middle one of three points, of the parabola through them (Bessel's, by chord length).
Point slope(const Point& a, const Point& b, const Point& c) {
  const double u = std::hypot(b.r - a.r, b.z - a.z), v = std::hypot(c.r - b.r, c.z - b.z);
  const auto at = [&](double p, double q, double s) { return ((q - p) / u * v + (s - q) / v * u) / (u + v); };
  return {at(a.r, b.r, c.r), at(a.z, b.z, c.z)};
}

// At an end, inwards: level where it lies on the axis, as the surface is round there; else of the parabola through
// three.
Point end_slope(const std::vector<Point>& p, size_t end, size_t next, size_t third) {
  if (p[end].r == 0) return slope({-p[next].r, p[next].z}, p[end], p[next]);
  const Point m = slope(p[end], p[next], p[third]);
  const double u = std::hypot(p[next].r - p[end].r, p[next].z - p[end].z);
  return {2 * (p[next].r - p[end].r) / u - m.r, 2 * (p[next].z - p[end].z) / u - m.z};
}

Section cubic(const Point& a, const Point& b, const Point& slope_a, const Point& slope_b) {  // Hermite
  const double u = std::hypot(b.r - a.r, b.z - a.z);
  const auto value = [u](double p, double q, double m, double n, double t) {
    return p + t * (u * m + t * (3 * (q - p) - u * (2 * m + n) + t * (2 * (p - q) + u * (m + n))));
  };
  const auto rate = [u](double p, double q, double m, double n, double t) {
    return u * m + t * (2 * (3 * (q - p) - u * (2 * m + n)) + t * 3 * (2 * (p - q) + u * (m + n)));
  };
  return {[=](double t) {
    const double dr = rate(a.r, b.r, slope_a.r, slope_b.r, t), dz = rate(a.z, b.z, slope_a.z, slope_b.z, t);
    if (t >= 1) return unit(b.r, b.z, dz, -dr);
    return unit(value(a.r, b.r, slope_a.r, slope_b.r, t), value(a.z, b.z, slope_a.z, slope_b.z, t), dz, -dr);
  }};
}

}  // namespace

Profile polyline(const std::vector<Point>& p, bool smooth, const std::string& field) {
  check_points(p, field);
  Profile out;
  const size_t n = p.size();
  smooth = smooth && n > 2;
  std::vector<Point> slopes(n);
  for (size_t i = 1; smooth && i + 1 < n; ++i) slopes[i] = slope(p[i - 1], p[i], p[i + 1]);
  if (smooth) {
    slopes[0] = end_slope(p, 0, 1, 2);
    slopes[n - 1] = end_slope(p, n - 1, n - 2, n - 3);
    slopes[n - 1] = {-slopes[n - 1].r, -slopes[n - 1].z};
  }
  for (size_t i = 0; i + 1 < n; ++i) {
    out.sections.push_back(smooth ? cubic(p[i], p[i + 1], slopes[i], slopes[i + 1]) : line(p[i], p[i + 1]));
    for (int k = 0; k <= 64; ++k)
      if (!(out.sections.back().at(k / 64.0).r >= 0))
        throw std::invalid_argument(field + ": the smooth curve crosses the axis after point " + std::to_string(i) +
                                    "; give more points there, or smooth 0");
  }
  return out;
}

// ---- lenses ----

FacePoint face_point(const Face& face, double r) {
  const double c = face.radius_m == 0 ? 0 : 1 / face.radius_m, u = r * r;
  const double q = std::sqrt(std::max(0.0, 1 - (1 + face.conic) * c * c * u));  // 0 where it ends, but for rounding
  double sag = c * u / (1 + q), rate = 0, power = u * u;
  for (size_t i = 0; i < face.coefficients.size(); ++i, power *= u) {
    sag += face.coefficients[i] * power;
    if (r > 0) rate += double(4 + 2 * i) * face.coefficients[i] * power / r;
  }
  return {sag, c * r + q * rate, q};  // q times the slope and 1: both finite where the conic ends
}

void check_face(const Face& face, double radius, const char* name) {
  const std::string prefix = name;
  if (std::isnan(face.radius_m)) fail(prefix + "_radius_m", face.radius_m, "a number; 0: flat");
  if (!std::isfinite(face.conic)) fail(prefix + "_conic", face.conic, "finite");
  for (size_t i = 0; i < face.coefficients.size(); ++i)
    if (!std::isfinite(face.coefficients[i]))
      fail(prefix + "_coefficients[" + std::to_string(i) + "]", face.coefficients[i], "finite");
  if (face.radius_m == 0 || !(1 + face.conic > 0)) return;
  const double reach = std::abs(face.radius_m) / std::sqrt(1 + face.conic);
  if (!(radius <= reach))
    fail(prefix + "_radius_m", face.radius_m,
         "so large that the face reaches the rim: with its conic it ends " + text(reach) +
             " m from the axis, the rim is at " + text(radius));
}

Section face_section(const Face& face, double radius, double vertex_z, bool below, bool inwards) {
  return {[=](double t) {
    const double r = inwards ? between(radius, 0, t) : between(0, radius, t);
    const FacePoint p = face_point(face, r);
    return unit(r, vertex_z + (below ? p.sag : -p.sag), p.slope, below ? -p.one : p.one);
  }};
}

Profile lens(const Face& entry, const Face& exit, double radius, double thickness) {
  positive(radius, "radius_m");
  positive(thickness, "thickness_m");
  check_face(entry, radius, "entry");
  check_face(exit, radius, "exit");
  constexpr int steps = 2000;
  for (int i = 0; i <= steps; ++i) {
    const double r = radius * i / steps, taken = face_point(entry, r).sag + face_point(exit, r).sag;
    if (!(taken < thickness))
      fail("thickness_m", thickness,
           "above " + text(taken) + ", or the faces cross inside the aperture, " + text(r) + " m from the axis");
  }
  Profile out;
  out.sections.push_back(face_section(exit, radius, -thickness, true, false));
  const ProfilePoint low = out.sections[0].at(1);
  Section top = face_section(entry, radius, 0, false, true);
  const ProfilePoint high = top.at(0);
  out.sections.push_back(line({low.r, low.z}, {high.r, high.z}));
  out.sections.push_back(std::move(top));
  return out;
}

// ---- emitters ----

Profile disc(double radius) {
  positive(radius, "radius_m");
  return {{line({0, 0}, {radius, 0})}};
}

Profile sphere(double radius) {
  positive(radius, "radius_m");
  return {{{[=](double t) {
    // The poles exactly.
    const double s = t <= 0 || t >= 1 ? 0 : std::sin(pi * t), c = std::cos(pi * t);
    return ProfilePoint{radius * s, -radius * c, s, -c};
  }}}};
}

Profile cylinder(double radius, double length) {
  positive(radius, "radius_m");
  positive(length, "length_m");
  const double h = length / 2;
  return {{line({0, -h}, {radius, -h}), line({radius, -h}, {radius, h}), line({radius, h}, {0, h})}};
}

Mesh rectangle(double width, double length) {
  positive(width, "width_m");
  positive(length, "length_m");
  const float x = float(width / 2), y = float(length / 2);
  return {{-x, -y, 0, x, -y, 0, x, y, 0, -x, y, 0}, {0, 0, -1, 0, 0, -1, 0, 0, -1, 0, 0, -1}, {0, 2, 1, 0, 3, 2}};
}

}  // namespace optics
