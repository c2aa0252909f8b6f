// Luminaires with a measured intensity distribution, from a point or from a flat luminous opening. Made by the scene
// for every luminaire.
#pragma once
#include <memory>

#include "emitter/emitter.h"
#include "emitter/point.h"
#include "photometry/photometry.h"

namespace ups {

// A distribution placed in the scene. frame: s, t, n are the luminaire's local X (C0), Y (C90) and Z (away from nadir).
class PlacedProfile {
 public:
  PlacedProfile(std::shared_ptr<const photometry::Distribution> distribution, const Frame& frame, const Rgb& scale);
  const Frame& frame() const { return frame_; }
  Rgb flux() const { return scale_ * float(distribution_->interpolated_flux_lm()); }
  bool emits() const { return emits_; }
  // Intensity, cd, towards a direction of the scene, and the density with which sample() takes it. False where it is 0.
  bool eval(const Vec3& direction, Rgb& intensity, float& pdf_w) const;
  bool sample(const Vec2& u, Vec3& direction, float& pdf_w) const;

 private:
  std::shared_ptr<const photometry::Distribution> distribution_;
  Frame frame_;
  Rgb scale_;
  bool emits_;
};

class ProfilePointEmitter : public PunctualEmitter {
 public:
  ProfilePointEmitter(std::shared_ptr<const photometry::Distribution> distribution, const Frame& frame, const Vec3& p,
                      const Rgb& scale, float error);
  EmitterKind kind() const override { return EmitterKind::profile_point; }
  double flux_lm() const override { return luminance(flux_rgb()); }
  Rgb flux_rgb() const override { return profile_.flux(); }
  bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const override;
  bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const override;

 private:
  PlacedProfile profile_;
};

// A flat opening centred on p in the local xy-plane. Its luminance I(w) / (A |cos|) is the same all over, so that from
// afar it is the distribution's intensity; what is above gamma = 90 degrees leaves from the back.
class ProfileOpeningEmitter : public Emitter {
 public:
  // Throws Error where the opening has no area in the xy-plane (has_area).
  ProfileOpeningEmitter(std::shared_ptr<const photometry::Distribution> distribution, const Frame& frame, const Vec3& p,
                        const photometry::Opening& opening, const Rgb& scale, float error);

  // Whether the opening is flat and horizontal, as this emitter is. Of others it takes the horizontal extent.
  static bool is_exact(const photometry::Opening& opening);
  static bool has_area(const photometry::Opening& opening);

  EmitterKind kind() const override { return EmitterKind::profile_opening; }
  bool is_delta() const override { return false; }
  double flux_lm() const override { return luminance(flux_rgb()); }
  Rgb flux_rgb() const override { return profile_.flux(); }
  Vec3 center() const override { return p_; }
  float radius() const override { return circumscribed_radius(); }
  bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const override;
  bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const override;
  bool eval_hit(const Vec3& reference, const Vec3& p, uint32_t primitive, const Vec3& wo,
                EmitterHit& out) const override;

  float circumscribed_radius() const;
  Vec3 normal() const { return -profile_.frame().n; }  // towards nadir
  bool contains(const Vec3& p_in_plane) const;

 private:
  Vec3 position(const Vec2& u) const;

  PlacedProfile profile_;
  Vec3 p_;
  bool round_;
  float half_x_, half_y_;  // half the extent, or the ellipse's semi-axes
  float pdf_a_, error_;
};

}  // namespace ups
