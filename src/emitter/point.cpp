// Emission and next-event estimation of point, spot and directional lights.
#include "emitter/point.h"

#include "base/warp.h"

namespace ups {

void PunctualEmitter::start_emission(const Vec3& direction, const Rgb& flux, float pdf_direction_w,
                                     EmissionSample& out) const {
  out = {};
  out.p = start_;
  out.direction = direction;
  out.flux = flux;
  out.pdf_direction_w = pdf_direction_w;
  out.error = error_;
}

bool PunctualEmitter::seen_from(const Vec3& eye, Sight& out) const {
  DirectSample s;
  if (!sample_direct(eye, {0.5f, 0.5f}, s)) return false;
  out = {s.wi, double(s.distance), double(luminance(s.weight)) * s.distance * s.distance, 0};
  return out.intensity_cd > 0;
}

bool PunctualEmitter::start_direct(const Vec3& reference, DirectSample& out) const {
  const Vec3 to_p = p_ - reference;
  const float distance2 = length2(to_p);
  if (!(distance2 > 0)) return false;
  out = {};
  out.p = start_;
  out.distance = std::sqrt(distance2);
  out.wi = to_p / out.distance;
  out.weight = Rgb(1 / distance2);
  out.error = error_;
  return true;
}

double PointEmitter::flux_lm() const { return luminance(flux_rgb()); }
Rgb PointEmitter::flux_rgb() const { return intensity_ * (4 * pi); }

Outline PointEmitter::outline() const {
  Outline out;
  out.center = center();
  out.intensity = luminance(intensity_);
  return out;
}

bool PointEmitter::sample_emission(const Vec2&, const Vec2& u_direction, EmissionSample& out) const {
  start_emission(square_to_sphere(u_direction), flux_rgb(), sphere_pdf, out);
  return !is_black(intensity_);
}

bool PointEmitter::sample_direct(const Vec3& reference, const Vec2&, DirectSample& out) const {
  if (is_black(intensity_) || !start_direct(reference, out)) return false;
  out.weight *= intensity_;
  out.pdf_direction_w = sphere_pdf;
  return true;
}

bool PointEmitter::emission_square(const Vec3&, uint32_t, const Vec3& direction, Vec2& u) const {
  u = sphere_to_square(direction);
  return true;
}

SpotEmitter::SpotEmitter(const Vec3& p, const Vec3& axis, const Rgb& intensity, float inner_cone_rad,
                         float outer_cone_rad, float error, const Vec3& shift)
    : PunctualEmitter(p, error, shift), frame_(normalize(axis)), intensity_(intensity) {
  const auto versine = [](double angle) { return 2 * std::pow(std::sin(0.5 * angle), 2); };
  outer_versine_ = versine(outer_cone_rad);
  inner_versine_ = std::min(versine(inner_cone_rad), outer_versine_);
  solid_angle_ = 2 * double(pi) * (inner_versine_ + (outer_versine_ - inner_versine_) / 3);
}

double SpotEmitter::versine_to(const Vec3& direction) const {
  return 0.5 * length2(normalize(Vec3d(direction)) - normalize(Vec3d(frame_.n)));
}

double SpotEmitter::attenuation(double versine) const {
  if (versine <= inner_versine_) return 1;
  if (versine >= outer_versine_) return 0;
  const double ramp = (outer_versine_ - versine) / (outer_versine_ - inner_versine_);
  return ramp * ramp;
}

double SpotEmitter::flux_lm() const { return luminance(flux_rgb()); }
Rgb SpotEmitter::flux_rgb() const { return intensity_ * float(solid_angle_); }

Outline SpotEmitter::outline() const {
  Outline out;
  out.shape = Outline::Shape::cone;
  out.center = center();
  out.intensity = luminance(intensity_);
  out.frame = frame_;
  out.inner_versine = inner_versine_;
  out.outer_versine = outer_versine_;
  return out;
}

// The cone's core and its ramp in proportion to their fluxes; the integral of the squared ramp is a cube.
bool SpotEmitter::sample_emission(const Vec2&, const Vec2& u_direction, EmissionSample& out) const {
  if (!(solid_angle_ > 0) || is_black(intensity_)) return false;
  const double ramp_width = outer_versine_ - inner_versine_;
  const double v = u_direction.x * (inner_versine_ + ramp_width / 3);
  const double rest = v - inner_versine_;  // of the ramp's integral, from its bright end
  const double versine =
      rest <= 0 ? v : outer_versine_ - ramp_width * std::cbrt(std::max(0.0, 1 - 3 * rest / ramp_width));
  const double sine = std::sqrt(std::max(0.0, versine * (2 - versine))), phi = 2 * double(pi) * u_direction.y;
  const Vec3 local(float(sine * std::cos(phi)), float(sine * std::sin(phi)), float(1 - versine));
  const float pdf = float(attenuation(versine) / solid_angle_);
  start_emission(normalize(frame_.to_world(local)), flux_rgb(), pdf, out);
  return pdf > 0;
}

bool SpotEmitter::sample_direct(const Vec3& reference, const Vec2&, DirectSample& out) const {
  if (!(solid_angle_ > 0) || !start_direct(reference, out)) return false;
  const double factor = attenuation(versine_to(-out.wi));
  out.weight *= intensity_ * float(factor);
  out.pdf_direction_w = float(factor / solid_angle_);
  return factor > 0 && !is_black(out.weight);
}

bool SpotEmitter::emission_square(const Vec3&, uint32_t, const Vec3& direction, Vec2& u) const {
  const double versine = versine_to(direction), ramp_width = outer_versine_ - inner_versine_;
  if (!(attenuation(versine) > 0)) return false;
  const double ramp = ramp_width > 0 ? std::clamp((outer_versine_ - versine) / ramp_width, 0.0, 1.0) : 1.0;
  const double v = std::min(versine, inner_versine_) + ramp_width * (1 - ramp * ramp * ramp) / 3;
  const float turns = std::atan2(dot(direction, frame_.t), dot(direction, frame_.s)) * (0.5f * inv_pi);
  u = {float(v / (inner_versine_ + ramp_width / 3)), turns < 0 ? turns + 1 : turns};
  return true;
}

DirectionalEmitter::DirectionalEmitter(const Vec3& direction, const Rgb& illuminance, float scene_radius,
                                       const Vec3& scene_center)
    : frame_(normalize(direction)), illuminance_(illuminance), scene_radius_(scene_radius),
      scene_center_(scene_center) {}

double DirectionalEmitter::flux_lm() const { return luminance(flux_rgb()); }
Rgb DirectionalEmitter::flux_rgb() const { return illuminance_ * (pi * scene_radius_ * scene_radius_); }

// A point so far away that the scene sees it in one direction and at one distance; as large as the scene, so that no
// part of that takes it to be below its horizon.
Outline DirectionalEmitter::outline() const {
  const float distance = 1000 * scene_radius_;
  Outline out;
  out.center = scene_center_ + frame_.n * -distance;
  out.half = Vec3(scene_radius_, scene_radius_, scene_radius_);
  out.intensity = luminance(illuminance_) * distance * distance;
  return out;
}

bool DirectionalEmitter::sample_emission(const Vec2& u_position, const Vec2&, EmissionSample& out) const {
  if (is_black(illuminance_) || !(scene_radius_ > 0)) return false;
  const Vec2 disc = square_to_disc(u_position);
  out = {};
  out.p = scene_center_ + (frame_.s * disc.x + frame_.t * disc.y - frame_.n) * scene_radius_;
  out.n = frame_.n;
  out.direction = frame_.n;
  out.flux = flux_rgb();
  out.pdf_position_a = pdf_position_a();
  out.pdf_direction_w = 1;
  return true;
}

bool DirectionalEmitter::sample_direct(const Vec3& reference, const Vec2&, DirectSample& out) const {
  if (is_black(illuminance_) || !(scene_radius_ > 0)) return false;
  out = {};
  out.n = frame_.n;
  out.wi = -frame_.n;
  out.distance = 2 * scene_radius_;
  out.p = reference + out.wi * out.distance;
  out.weight = illuminance_;
  out.pdf_position_a = pdf_position_a();
  out.pdf_direction_w = 1;
  return true;
}

bool DirectionalEmitter::emission_square(const Vec3& p, uint32_t, const Vec3&, Vec2& u) const {
  const Vec3 from = p - scene_center_;
  const Vec2 disc{dot(from, frame_.s) / scene_radius_, dot(from, frame_.t) / scene_radius_};
  if (!(disc.x * disc.x + disc.y * disc.y <= 1)) return false;
  u = disc_to_square(disc);
  return true;
}

}  // namespace ups
