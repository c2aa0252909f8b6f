// Emission, next-event estimation and hits of luminaires with a measured distribution.
#include "emitter/profile.h"

#include "base/error.h"
#include "base/warp.h"

namespace ups {

PlacedProfile::PlacedProfile(std::shared_ptr<const photometry::Distribution> distribution, const Frame& frame,
                             const Rgb& scale)
    : distribution_(std::move(distribution)), frame_(frame), scale_(scale), emits_(!is_black(flux())) {}

bool PlacedProfile::eval(const Vec3& direction, Rgb& intensity, float& pdf_w) const {
  if (!emits_) return false;
  const Vec3 local = frame_.to_local(direction);
  const double value = distribution_->eval(local.x, local.y, local.z);
  intensity = scale_ * float(value);
  pdf_w = float(value / distribution_->interpolated_flux_lm());
  return pdf_w > 0;
}

bool PlacedProfile::sample(const Vec2& u, Vec3& direction, float& pdf_w) const {
  if (!emits_) return false;
  const photometry::Distribution::Sample s = distribution_->sample(u.x, u.y);
  direction = normalize(frame_.to_world({float(s.x), float(s.y), float(s.z)}));
  pdf_w = float(s.pdf_w);
  return pdf_w > 0;
}

ProfilePointEmitter::ProfilePointEmitter(std::shared_ptr<const photometry::Distribution> distribution,
                                         const Frame& frame, const Vec3& p, const Rgb& scale, float error)
    : PunctualEmitter(p, error), profile_(std::move(distribution), frame, scale) {}

bool ProfilePointEmitter::sample_emission(const Vec2&, const Vec2& u_direction, EmissionSample& out) const {
  Vec3 direction;
  float pdf;
  if (!profile_.sample(u_direction, direction, pdf)) return false;
  start_emission(direction, flux_rgb(), pdf, out);
  return true;
}

bool ProfilePointEmitter::sample_direct(const Vec3& reference, const Vec2&, DirectSample& out) const {
  Rgb intensity;
  if (!start_direct(reference, out) || !profile_.eval(-out.wi, intensity, out.pdf_direction_w)) return false;
  out.weight *= intensity;
  return is_finite(out.weight);
}

bool ProfileOpeningEmitter::is_exact(const photometry::Opening& opening) {
  using photometry::OpeningShape;
  return (opening.shape == OpeningShape::rectangle || opening.shape == OpeningShape::disc) && opening.size_m[2] == 0;
}

bool ProfileOpeningEmitter::has_area(const photometry::Opening& opening) {
  return opening.shape != photometry::OpeningShape::point && opening.size_m[0] > 0 && opening.size_m[1] > 0;
}

namespace {

// A lying cylinder is seen from below as a rectangle.
bool is_round(const photometry::Opening& opening) {
  using photometry::OpeningShape;
  return opening.shape == OpeningShape::disc || opening.shape == OpeningShape::sphere ||
         (opening.shape == OpeningShape::cylinder && opening.axis == 2);
}

}  // namespace

ProfileOpeningEmitter::ProfileOpeningEmitter(std::shared_ptr<const photometry::Distribution> distribution,
                                             const Frame& frame, const Vec3& p, const photometry::Opening& opening,
                                             const Rgb& scale, float error)
    : profile_(std::move(distribution), frame, scale),
      p_(p),
      round_(is_round(opening)),
      half_x_(0.5f * opening.size_m[0]),
      half_y_(0.5f * opening.size_m[1]),
      error_(error) {
  if (!has_area(opening)) fail_argument("a luminous opening without extent along x and y cannot emit as an area");
  pdf_a_ = 1 / ((round_ ? pi : 4.0f) * half_x_ * half_y_);
  if (!std::isfinite(pdf_a_) || !(pdf_a_ > 0))
    fail_argument("a luminous opening's area is outside the range of a float");
}

float ProfileOpeningEmitter::circumscribed_radius() const {
  return round_ ? std::max(half_x_, half_y_) : std::hypot(half_x_, half_y_);
}

bool ProfileOpeningEmitter::contains(const Vec3& p_in_plane) const {
  const Vec3 local = profile_.frame().to_local(p_in_plane - p_);
  const float x = local.x / half_x_, y = local.y / half_y_;
  return round_ ? x * x + y * y <= 1 : std::max(std::abs(x), std::abs(y)) <= 1;
}

Vec3 ProfileOpeningEmitter::position(const Vec2& u) const {
  const Vec2 unit = round_ ? square_to_disc(u) : Vec2{2 * u.x - 1, 2 * u.y - 1};
  return p_ + profile_.frame().s * (half_x_ * unit.x) + profile_.frame().t * (half_y_ * unit.y);
}

bool ProfileOpeningEmitter::sample_emission(const Vec2& u_position, const Vec2& u_direction,
                                            EmissionSample& out) const {
  out = {};
  if (!profile_.sample(u_direction, out.direction, out.pdf_direction_w)) return false;
  const float cos_up = dot(out.direction, profile_.frame().n);
  if (cos_up == 0) return false;
  out.p = position(u_position);
  out.n = cos_up > 0 ? profile_.frame().n : normal();
  out.flux = flux_rgb();
  out.pdf_position_a = pdf_a_;
  out.cos_0 = std::abs(cos_up);
  out.error = error_;
  return true;
}

bool ProfileOpeningEmitter::sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const {
  const Vec3 p = position(u), to_p = p - reference;
  const float distance2 = length2(to_p);
  if (!(distance2 > 0)) return false;
  out = {};
  out.p = p;
  out.distance = std::sqrt(distance2);
  out.wi = to_p / out.distance;
  const float cos_up = -dot(out.wi, profile_.frame().n);
  Rgb intensity;
  if (cos_up == 0 || !profile_.eval(-out.wi, intensity, out.pdf_direction_w)) return false;
  out.n = cos_up > 0 ? profile_.frame().n : normal();
  out.cos_0 = std::abs(cos_up);
  out.weight = intensity / distance2;  // L cos_0 / (d^2 pdf_a), in which cosine and area cancel
  out.pdf_nee_a = pdf_a_;
  out.pdf_position_a = pdf_a_;
  out.error = error_;
  return is_finite(out.weight);
}

bool ProfileOpeningEmitter::eval_hit(const Vec3&, const Vec3&, uint32_t, const Vec3& wo, EmitterHit& out) const {
  const float cosine = std::abs(dot(wo, profile_.frame().n));
  Rgb intensity;
  if (cosine == 0 || !profile_.eval(wo, intensity, out.pdf_direction_w)) return false;
  out.radiance = intensity * (pdf_a_ / cosine);
  out.pdf_nee_a = pdf_a_;
  out.pdf_position_a = pdf_a_;
  return is_finite(out.radiance);
}

}  // namespace ups
