// Emission, next-event estimation and hits of luminaires with a measured distribution.
#include "emitter/profile.h"

namespace ups {

PlacedProfile::PlacedProfile(std::shared_ptr<const photometry::Distribution> distribution, const Frame& frame,
                             const Rgb& scale)
    : distribution_(std::move(distribution)),
      frame_(frame),
      scale_(scale),
      flux_(scale * float(distribution_->interpolated_flux_lm())),
      emits_(!is_black(flux_)) {}

bool PlacedProfile::eval(const Vec3& direction, Rgb& intensity, float& pdf_w) const {
  if (!emits_) return false;
  const Vec3 local = frame_.to_local(direction);
  pdf_w = distribution_->fast_pdf_w(local.x, local.y, local.z);
  intensity = flux_ * pdf_w;
  return pdf_w > 0;
}

Outline PlacedProfile::outline(const Vec3& center, const Vec3& half) const {
  Outline out;
  out.shape = Outline::Shape::profile;
  out.intensity = luminance(scale_);
  out.center = center;
  out.half = half;
  out.frame = frame_;
  out.distribution = distribution_.get();
  return out;
}

bool PlacedProfile::sample(const Vec2& u, Vec3& direction, float& pdf_w) const {
  if (!emits_) return false;
  const photometry::Distribution::Sample s = distribution_->sample(u.x, u.y);
  direction = normalize(frame_.to_world({float(s.x), float(s.y), float(s.z)}));
  pdf_w = float(s.pdf_w);
  return pdf_w > 0;
}

bool PlacedProfile::invert(const Vec3& direction, Vec2& u) const {
  const Vec3 local = frame_.to_local(direction);
  double u1, u2;
  if (!emits_ || !distribution_->invert(local.x, local.y, local.z, u1, u2)) return false;
  u = {float(u1), float(u2)};
  return true;
}

ProfilePointEmitter::ProfilePointEmitter(std::shared_ptr<const photometry::Distribution> distribution,
                                         const Frame& frame, const Vec3& p, const Rgb& scale, float error,
                                         const Vec3& shift)
    : PunctualEmitter(p, error, shift), profile_(std::move(distribution), frame, scale) {}

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
  return true;
}

ProfileOpeningEmitter::ProfileOpeningEmitter(std::shared_ptr<const photometry::Distribution> distribution,
                                             const Frame& frame, const Vec3& p, const photometry::Opening& opening,
                                             const Rgb& scale, float error)
    : profile_(std::move(distribution), frame, scale),
      body_(opening),
      frame_(body_.turned(frame)),
      p_(p),
      pdf_a_(float(1 / body_.area())),
      error_(error) {
  front_ = brighter_side();
}

Vec3d ProfileOpeningEmitter::place_in_body(const Vec3& p) const {
  const Vec3d v = Vec3d(p) - Vec3d(p_);
  return {dot(v, Vec3d(frame_.s)), dot(v, Vec3d(frame_.t)), dot(v, Vec3d(frame_.n))};
}

Vec3 ProfileOpeningEmitter::from_body(const Vec3d& v) const {
  return Vec3(Vec3d(frame_.s) * v.x + Vec3d(frame_.t) * v.y + Vec3d(frame_.n) * v.z);
}

template <class Visit>
void ProfileOpeningEmitter::for_typical_directions(const Visit& visit) const {
  constexpr int lattice = 16;
  for (int i = 0; i < lattice * lattice; ++i) {
    Vec3 direction;
    float pdf;
    if (profile_.sample({(float(i / lattice) + 0.5f) / lattice, (float(i % lattice) + 0.5f) / lattice}, direction, pdf))
      visit(direction, pdf);
  }
}

double ProfileOpeningEmitter::brightest_cd_m2() const {
  double most = 0;
  for_typical_directions([&](const Vec3& direction, float pdf) {
    const double area = body_.projected_area(normalize(to_body(direction)));
    if (area > 0) most = std::max(most, flux_lm() * double(pdf) / area);
  });
  return most;
}

// A sheet on a wall or a floor shines away from it; one on a ceiling, which may light the ceiling more, hangs below it.
Vec3 ProfileOpeningEmitter::brighter_side() const {
  const Vec3 nadir = -profile_.frame().n;
  if (!body_.is_flat()) return nadir;
  int front = 0, all = 0;
  for_typical_directions([&](const Vec3& direction, float) { front += dot(direction, frame_.n) > 0, ++all; });
  constexpr double least_upwards = 0.9;  // of what lies on a floor
  const bool level = dot(frame_.n, nadir) < -0.5f;
  const double share = all > 0 ? double(front) / all : 0;
  return share >= (level ? least_upwards : 0.5) ? frame_.n : -frame_.n;
}

// Per area and solid angle a direction w has the density pdf_w(w) cos / projected area: exactly the profile's
// direction, then a point of what is seen from there. It is stated as 1 / area, a constant, times the rest.
bool ProfileOpeningEmitter::emitted(const Vec3& direction, const Vec3d& w, const Vec3d& n, Emitted& out) const {
  out.cosine = dot(n, w);
  out.projected_area = body_.projected_area(w);
  float pdf;
  if (!(out.cosine > 0) || !(out.projected_area > 0) || !profile_.eval(direction, out.intensity, pdf)) return false;
  out.pdf_direction_w = float(double(pdf) * out.cosine * body_.area() / out.projected_area);
  return out.pdf_direction_w > 0;
}

float ProfileOpeningEmitter::reach(const Vec3& n) const {
  const Vec3 extent(body_.half());
  return std::abs(dot(n, frame_.s)) * extent.x + std::abs(dot(n, frame_.t)) * extent.y +
         std::abs(dot(n, frame_.n)) * extent.z + 2 * error_;
}

Outline ProfileOpeningEmitter::outline() const {
  return profile_.outline(p_, {reach({1, 0, 0}), reach({0, 1, 0}), reach({0, 0, 1})});
}

bool ProfileOpeningEmitter::sample_emission(const Vec2& u_position, const Vec2& u_direction,
                                            EmissionSample& out) const {
  out = {};
  float pdf;
  if (!profile_.sample(u_direction, out.direction, pdf)) return false;
  LuminousBody::Point point;
  if (!body_.sample_seen_along(normalize(to_body(out.direction)), u_position, point)) return false;
  out.p = p_ + from_body(point.p);
  out.n = normalize(from_body(point.n));
  out.flux = flux_rgb();
  out.pdf_position_a = pdf_a_;
  out.pdf_direction_w = float(double(pdf) * point.pdf_a * body_.area());
  out.cos_0 = dot(out.n, out.direction);
  out.error = error_;
  return out.pdf_direction_w > 0 && out.cos_0 > 0;
}

bool ProfileOpeningEmitter::sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const {
  out = {};
  Vec3d local = place_in_body(reference);
  // In a sheet's plane cosine and projected area vanish, their ratio does not.
  const double nearest = body_.is_flat() ? 1e-9 * std::max(body_.half().x, body_.half().y) : 0;
  if (std::abs(local.z) < nearest) local.z = local.z < 0 ? -nearest : nearest;
  LuminousBody::Point point;
  if (!body_.sample_seen_from(local, u, point)) return false;
  const Vec3d to_reference = local - point.p;
  const double distance2 = length2(to_reference);
  if (!(distance2 > 0)) return false;
  out.p = p_ + from_body(point.p);
  out.n = normalize(from_body(point.n));
  out.distance = float(std::sqrt(distance2));
  const Vec3d w = to_reference / std::sqrt(distance2);
  out.wi = normalize(from_body(-w));
  Emitted e;
  if (!emitted(-out.wi, w, point.n, e)) return false;
  out.cos_0 = float(e.cosine);
  out.weight = e.intensity * float(e.cosine / (e.projected_area * distance2 * point.pdf_a));
  out.pdf_nee_a = float(point.pdf_a);
  out.pdf_position_a = pdf_a_;
  out.pdf_direction_w = e.pdf_direction_w;
  out.error = error_;
  return true;
}

bool ProfileOpeningEmitter::eval_hit(const Vec3& reference, const Vec3& p, uint32_t, const Vec3& wo,
                                     EmitterHit& out) const {
  const Vec3d local = place_in_body(p), w = normalize(to_body(wo));
  Vec3d n;
  Emitted e;
  if (!body_.normal_at(local, w, n) || !emitted(wo, w, n, e)) return false;
  out.radiance = e.intensity * float(1 / body_.projected_area(w, lift()));  // of what rays run into
  out.pdf_nee_a = float(body_.pdf_seen_from(place_in_body(reference), local, n));
  out.pdf_position_a = pdf_a_;
  out.pdf_direction_w = e.pdf_direction_w;
  return true;
}

bool ProfileOpeningEmitter::seen_from(const Vec3& eye, Sight& out) const {
  const Vec3d to_eye = Vec3d(eye) - Vec3d(p_);
  const double distance = length(to_eye);
  Rgb intensity;
  float pdf;
  if (!(distance > 0) || !profile_.eval(Vec3(to_eye / distance), intensity, pdf)) return false;
  const double area = body_.projected_area(normalize(to_body(Vec3(to_eye / distance))));
  out = {Vec3(-(to_eye / distance)), distance, double(luminance(intensity)), area / (distance * distance)};
  return out.intensity_cd > 0 && out.solid_angle_sr > 0;
}

bool ProfileOpeningEmitter::enter(const Vec3& o, const Vec3& d, float& t, float& cosine) const {
  const double margin = body_.is_flat() && dot(front_, frame_.n) < 0 ? -lift() : lift();
  const Vec3d w = normalize(to_body(d));
  double distance;
  Vec3d n;
  if (!body_.enter(place_in_body(o), w, margin, distance, n)) return false;
  t = float(distance);
  cosine = float(std::abs(dot(n, w)));
  return true;
}

}  // namespace ups
