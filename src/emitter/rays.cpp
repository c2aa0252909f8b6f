// See rays.h.
#include "emitter/rays.h"

#include <cmath>
#include <numeric>

#include "base/rng.h"

namespace ups {
namespace {

// Fisher and Yates'.
void shuffle(std::vector<uint32_t>& order) {
  for (size_t i = order.size(); i > 1; --i) {
    const auto r = philox({uint32_t(i), 0, 0, 0}, {0x7261u, 0x7973u});
    std::swap(order[i - 1], order[size_t(uint64_t(r[0]) * i >> 32)]);
  }
}

std::vector<double> fluxes(const std::vector<photometry::Ray>& rays, const std::vector<uint32_t>& order) {
  std::vector<double> flux;
  flux.reserve(rays.size());
  for (const uint32_t i : order) flux.push_back(rays[i].flux_lm);
  return flux;
}

Vec3 to_vec3(const float (&v)[3]) { return {v[0], v[1], v[2]}; }

}  // namespace

RaySet::RaySet(std::shared_ptr<const photometry::Photometry> profile)
    : profile_(std::move(profile)), order_(profile_->rays.size()) {
  if (profile_->rays.empty()) return;
  std::iota(order_.begin(), order_.end(), 0u);
  lower_ = upper_ = to_vec3(profile_->rays[0].p_m);
  double sum = 0, squares = 0;
  for (const photometry::Ray& r : profile_->rays) {
    lower_ = {std::min(lower_.x, r.p_m[0]), std::min(lower_.y, r.p_m[1]), std::min(lower_.z, r.p_m[2])};
    upper_ = {std::max(upper_.x, r.p_m[0]), std::max(upper_.y, r.p_m[1]), std::max(upper_.z, r.p_m[2])};
    sum += r.flux_lm, squares += double(r.flux_lm) * r.flux_lm;
  }
  if (squares > 0) effective_size_ = sum * sum / squares;
  if (is_shared()) shuffle(order_);
  by_flux_ = DiscreteDistribution(fluxes(profile_->rays, order_));
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

// Both numbers are one of 48 bits, of which a batch has a part.
Vec2 RayEmitter::position_of_batch(const Vec2& u, uint32_t batch, uint32_t batches) const {
  if (!rays_->is_shared()) return u;
  const double whole = (double(batch) + double(u.x) + 0x1p-24 * double(u.y)) / double(batches),
               first = std::floor(whole * 0x1p24) * 0x1p-24;
  return {float(first), float((whole - first) * 0x1p24)};
}

}  // namespace ups
