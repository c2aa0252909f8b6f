// Collimators with total internal reflection, see optics.h: a solid whose profile runs over the exit face, the outer
// wall, the rim around the mouth, the wall of the cavity and the lens at its bottom.
#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "photometry/optics_face.h"

namespace optics {
namespace {

// The wall that turns what comes from the origin through the cavity's wall parallel to -z: with the ray refracted at W
// into the direction d (Snell: the part along the wall shrinks by 1 / n), all optical paths |W| + n s + n z from the
// source over P = W + s d down to a level plane are equal (Fermat). Elevation: angle of the ray from straight down.
Section collimating_wall(double cavity_radius, double wall_thickness, double n, double lowest) {
  return {[=](double t) {
    const double angle = t >= 1 ? pi / 2 : lowest + t * (pi / 2 - lowest);
    const double cosine = t >= 1 ? 0 : std::cos(angle), sine = std::sin(angle);
    const double wall_z = -cavity_radius * cosine / sine, d_z = -cosine / n, d_r = std::sqrt(1 - d_z * d_z);
    const double s = (cavity_radius + n * wall_thickness - cavity_radius / sine - n * wall_z) / (n * (1 + d_z));
    // Half-way between the two directions, away from the glass.
    const double normal_r = d_r, normal_z = d_z + 1, length = std::hypot(normal_r, normal_z);
    return ProfilePoint{cavity_radius + s * d_r, wall_z + s * d_z, normal_r / length, normal_z / length};
  }};
}

// Focus at the origin, from the plane z = -height up to z = 0.
Section parabolic_wall(double f, double height) {
  return {[=](double t) {
    const double low = 2 * std::sqrt(f * (f + height)), high = 2 * f;
    const double r = t >= 1 ? high : low + t * (high - low), length = std::hypot(r, 2 * f);
    return ProfilePoint{r, t <= 0 ? -height : t >= 1 ? 0 : f - r * r / (4 * f), r / length, 2 * f / length};
  }};
}

Section reversed(const Section& s) {
  return {[at = s.at](double t) {
    const ProfilePoint p = at(1 - t);
    return ProfilePoint{p.r, p.z, -p.normal_r, -p.normal_z};
  }};
}

// From its lower end up.
std::vector<Section> outer_wall(const Collimator& d, double lens_rim_depth) {
  using Wall = Collimator::Wall;
  if (d.wall == Wall::collimating) {
    positive(d.wall_thickness_m, "wall_thickness_m");
    return {
        collimating_wall(d.cavity_radius_m, d.wall_thickness_m, d.ior, std::atan2(d.cavity_radius_m, lens_rim_depth))};
  }
  if (d.wall == Wall::paraboloid) {
    positive(d.focal_length_m, "wall_focal_length_m");
    positive(d.height_m, "height_m");
    return {parabolic_wall(d.focal_length_m, d.height_m)};
  }
  const Profile free = polyline(d.wall_points, d.smooth, "wall_rz_m");
  if (d.wall_points.front().z != 0)
    fail("wall_rz_m: point 0's z", d.wall_points.front().z, "0, the plane of the mouth");
  for (size_t i = 1; i < d.wall_points.size(); ++i)
    if (!(d.wall_points[i].z < d.wall_points[i - 1].z))
      fail("wall_rz_m: point " + std::to_string(i) + "'s z", d.wall_points[i].z, "below that of the point before");
  std::vector<Section> up;
  for (auto s = free.sections.rbegin(); s != free.sections.rend(); ++s) up.push_back(reversed(*s));
  return up;
}

void check_inside(const std::vector<Section>& wall, double cavity_radius, double cavity_bottom) {
  for (const Section& section : wall)
    for (int i = 0; i <= 256; ++i) {
      const ProfilePoint p = section.at(i / 256.0);
      if (p.z >= cavity_bottom && !(p.r > cavity_radius))
        fail("cavity_radius_m", cavity_radius,
             "less than the outer wall's radius, which is " + text(p.r) + " at the depth " + text(-p.z));
    }
}

}  // namespace

Profile collimator(const Collimator& d) {
  positive(d.cavity_radius_m, "cavity_radius_m");
  positive(d.cavity_depth_m, "cavity_depth_m");
  if (!(d.ior > 1 && std::isfinite(d.ior))) fail("finish_ior", d.ior, "finite and above 1");
  if (!(d.height_m >= 0 && std::isfinite(d.height_m))) fail("height_m", d.height_m, "finite and at least 0");
  Face inner = d.lens;
  if (inner.radius_m == 0)
    inner = {(d.ior - 1) * d.cavity_depth_m, -d.ior * d.ior, {}};
  else if (std::isinf(inner.radius_m))
    inner.radius_m = 0;
  check_face(inner, d.cavity_radius_m, "lens");
  const double lens_rim = d.cavity_depth_m + face_point(inner, d.cavity_radius_m).sag;
  if (!(lens_rim > 0)) fail("cavity_depth_m", d.cavity_depth_m, "larger: the lens's rim would rise out of the mouth");

  std::vector<Section> wall = outer_wall(d, lens_rim);
  const ProfilePoint wall_end = wall.front().at(0);
  const double height = d.height_m > 0 ? d.height_m : -wall_end.z;
  if (!(height >= -wall_end.z))
    fail("height_m", d.height_m, "0 or at least the height of the wall, " + text(-wall_end.z));
  check_face(d.exit, wall_end.r, "exit");
  const double exit_vertex = -height - face_point(d.exit, wall_end.r).sag;
  check_inside(wall, d.cavity_radius_m, -lens_rim);
  for (int i = 0; i <= 2000; ++i) {
    const double r = d.cavity_radius_m * i / 2000;
    const double top = -d.cavity_depth_m - face_point(inner, r).sag, bottom = exit_vertex + face_point(d.exit, r).sag;
    if (!(bottom < top))
      fail("height_m", height, "larger: the exit face meets the lens of the cavity " + text(r) + " m from the axis");
  }
  for (const Section& section : wall)
    for (int i = 0; i <= 256; ++i) {
      const ProfilePoint p = section.at(i / 256.0);
      if (p.r < wall_end.r * (1 - 1e-9) && !(exit_vertex + face_point(d.exit, p.r).sag < p.z))
        fail("exit_radius_m", d.exit.radius_m, "less curved: the exit face leaves the outer wall " + text(p.r) +
                                                   " m from the axis");
    }

  Profile out;
  out.facets_around = d.facets_around;
  out.sections.push_back(face_section(d.exit, wall_end.r, exit_vertex, true, false));
  out.sections.back().facets_along = d.exit_facets_along;
  const ProfilePoint rim = out.sections.back().at(1);
  if (rim.z < wall_end.z && height > -wall_end.z)
    out.sections.push_back(line({rim.r, rim.z}, {wall_end.r, wall_end.z}));
  for (Section& s : wall) out.sections.push_back(std::move(s));
  const ProfilePoint top = out.sections.back().at(1);
  out.sections.push_back(line({top.r, top.z}, {d.cavity_radius_m, 0}));
  Section lens_section = face_section(inner, d.cavity_radius_m, -d.cavity_depth_m, false, true);
  const ProfilePoint lens_edge = lens_section.at(0);
  out.sections.push_back(line({d.cavity_radius_m, 0}, {lens_edge.r, lens_edge.z}));
  out.sections.push_back(std::move(lens_section));
  return out;
}

}  // namespace optics
