// See rays.h.
#include "emitter/rays.h"

namespace ups {
namespace {

std::vector<double> fluxes(const std::vector<photometry::Ray>& rays) {
  std::vector<double> flux;
  flux.reserve(rays.size());
  for (const photometry::Ray& r : rays) flux.push_back(r.flux_lm);
  return flux;
}

Vec3 to_vec3(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

}  // namespace

RaySet::RaySet(std::shared_ptr<const photometry::Photometry> profile)
    : profile_(std::move(profile)), by_flux_(fluxes(profile_->rays)) {
  if (profile_->rays.empty()) return;
  lower_ = upper_ = to_vec3(profile_->rays[0].p_m);
  double squares = 0;
  for (const photometry::Ray& r : profile_->rays) {
    lower_ = {std::min(lower_.x, r.p_m[0]), std::min(lower_.y, r.p_m[1]), std::min(lower_.z, r.p_m[2])};
    upper_ = {std::max(upper_.x, r.p_m[0]), std::max(upper_.y, r.p_m[1]), std::max(upper_.z, r.p_m[2])};
    squares += double(r.flux_lm) * r.flux_lm;
  }
  if (squares > 0) effective_size_ = flux_lm() * flux_lm() / squares;
}

RayEmitter::RayEmitter(std::shared_ptr<const RaySet> rays, const Frame& frame, const Vec3& p, const Rgb& scale)
    : rays_(std::move(rays)),
      frame_(frame),
      p_(p),
      center_(p + frame.to_world((rays_->lower() + rays_->upper()) * 0.5f)),
      radius_(0.5f * length(rays_->upper() - rays_->lower())),
      scale_(scale) {}

bool RayEmitter::sample_emission(const Vec2& u_position, const Vec2&, EmissionSample& out) const {
  if (!(rays_->flux_lm() > 0)) return false;
  // The second number goes on where the first one's 24 bits end.
  const photometry::Ray& ray = rays_->choose(double(u_position.x) + 0x1p-24 * double(u_position.y));
  out = {};
  out.p = p_ + frame_.to_world(to_vec3(ray.p_m));
  out.direction = normalize(frame_.to_world(to_vec3(ray.direction)));
  out.n = out.direction;  // a ray that starts on a surface leaves it
  out.flux = flux_rgb();
  // No density: a ray is chosen, and next-event estimation, which would compare with it, has none either.
  out.pdf_position_a = out.pdf_direction_w = 1;
  out.error = 16 * 0x1p-24f * std::max(max_abs(p_), max_abs(out.p));
  return true;
}

}  // namespace ups
