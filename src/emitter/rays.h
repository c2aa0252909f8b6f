// A luminaire whose light is the rays of a ray file: light paths start from them, each in proportion to its flux. Made
// by the scene for luminaires whose profile has rays. Position and direction of a ray are fixed, so no eye path runs
// into one and next-event estimation cannot look at one: what light paths carry is all.
#pragma once
#include <memory>

#include "base/discrete.h"
#include "emitter/emitter.h"
#include "photometry/photometry.h"

namespace ups {

// What all luminaires of one profile share. Keeps the rays alive.
class RaySet {
 public:
  explicit RaySet(std::shared_ptr<const photometry::Photometry> profile);
  // u: uniform in [0, 1), in double, as there may be more rays than floats. Of no use where the flux is 0.
  const photometry::Ray& choose(double u) const { return profile_->rays[order_[by_flux_.sample(u).index]]; }
  // The rays are a sample, and of it each batch has a share of its own: what batches differ in is its noise, too.
  // Else paths that repeat rays would seem to agree with each other. A sample that is too small to be shared is not.
  bool is_shared() const { return effective_size_ >= least_shared; }
  double flux_lm() const { return by_flux_.total(); }
  // Of the rays' starting points, in the luminaire's frame.
  Vec3 lower() const { return lower_; }
  Vec3 upper() const { return upper_; }
  size_t size() const { return profile_->rays.size(); }
  size_t bytes() const {
    return profile_->rays.capacity() * sizeof(photometry::Ray) + by_flux_.bytes() + order_.capacity() * sizeof(uint32_t);
  }
  // As many rays of equal flux would have the same noise.
  double effective_size() const { return effective_size_; }

 private:
  static constexpr double least_shared = 4096;  // 256 for each of 16 batches
  std::shared_ptr<const photometry::Photometry> profile_;
  std::vector<uint32_t> order_;  // the file's; of those that are shared by chance, whatever the file's may mean
  DiscreteDistribution by_flux_;
  Vec3 lower_, upper_;
  double effective_size_ = 0;
};

class RayEmitter : public Emitter {
 public:
  // frame: s, t, n are the file's x, y, z; scale: multiplies the rays' fluxes.
  RayEmitter(std::shared_ptr<const RaySet> rays, const Frame& frame, const Vec3& p, const Rgb& scale);

  const RaySet& rays() const { return *rays_; }
  EmitterKind kind() const override { return EmitterKind::rays; }
  bool is_delta() const override { return true; }
  bool is_direct() const override { return false; }
  double flux_lm() const override { return luminance(flux_rgb()); }
  Rgb flux_rgb() const override { return scale_ * float(rays_->flux_lm()); }
  Vec3 center() const override { return center_; }
  float radius() const override { return radius_; }
  bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const override;
  Vec2 position_of_batch(const Vec2& u, uint32_t batch, uint32_t batches) const override;
  bool sample_direct(const Vec3&, const Vec2&, DirectSample&) const override { return false; }
  bool eval_hit(const Vec3&, const Vec3&, uint32_t, const Vec3&, EmitterHit&) const override { return false; }
  bool emission_square(const Vec3&, uint32_t, const Vec3&, Vec2&) const override { return false; }

 private:
  std::shared_ptr<const RaySet> rays_;
  Frame frame_;
  Vec3 p_, center_;
  float radius_;
  Rgb scale_;
};

}  // namespace ups
