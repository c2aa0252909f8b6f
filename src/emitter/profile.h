// Luminaires with a measured intensity distribution, from a point or from a luminous opening. Made by the scene for
// every luminaire.
#pragma once
#include <memory>

#include "emitter/emitter.h"
#include "emitter/opening.h"
#include "emitter/point.h"
#include "photometry/photometry.h"

namespace ups {

// A distribution placed in the scene. frame: s, t, n are the luminaire's local X (C0), Y (C90) and Z (away from nadir).
class PlacedProfile {
 public:
  PlacedProfile(std::shared_ptr<const photometry::Distribution> distribution, const Frame& frame, const Rgb& scale);
  const Frame& frame() const { return frame_; }
  const Rgb& flux() const { return flux_; }
  bool emits() const { return emits_; }
  Outline outline(const Vec3& center, const Vec3& half) const;
  // Intensity, cd, towards a direction of the scene, and the density with which sample() takes it. False where it is 0.
  bool eval(const Vec3& direction, Rgb& intensity, float& pdf_w) const;
  bool sample(const Vec2& u, Vec3& direction, float& pdf_w) const;
  bool invert(const Vec3& direction, Vec2& u) const;  // what sample() takes it from

 private:
  std::shared_ptr<const photometry::Distribution> distribution_;
  Frame frame_;
  Rgb scale_, flux_;
  bool emits_;
};

class ProfilePointEmitter : public PunctualEmitter {
 public:
  ProfilePointEmitter(std::shared_ptr<const photometry::Distribution> distribution, const Frame& frame, const Vec3& p,
                      const Rgb& scale, float error, const Vec3& shift = {});
  EmitterKind kind() const override { return EmitterKind::profile_point; }
  double flux_lm() const override { return luminance(flux_rgb()); }
  Rgb flux_rgb() const override { return profile_.flux(); }
  Outline outline() const override { return profile_.outline(center(), Vec3()); }
  bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const override;
  bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const override;
  bool emission_square(const Vec3&, uint32_t, const Vec3& direction, Vec2& u) const override {
    return profile_.invert(direction, u);
  }

 private:
  PlacedProfile profile_;
};

// A luminous opening centred on p: a convex body, or a sheet with two sides. Its luminance towards a direction is the
// same all over what is seen from there, I / projected area: from afar it is the distribution's intensity, near by the
// body's. It emits outwards alone and blocks nothing; a point inside sees nothing of it.
class ProfileOpeningEmitter : public Emitter {
 public:
  // error: of the body's surface, for ray origins. Throws Error where the opening has no area (LuminousBody::has_area).
  ProfileOpeningEmitter(std::shared_ptr<const photometry::Distribution> distribution, const Frame& frame, const Vec3& p,
                        const photometry::Opening& opening, const Rgb& scale, float error);

  EmitterKind kind() const override { return EmitterKind::profile_opening; }
  bool is_delta() const override { return false; }
  double brightest_cd_m2() const override;  // of directions into which it sends its light
  double flux_lm() const override { return luminance(flux_rgb()); }
  Rgb flux_rgb() const override { return profile_.flux(); }
  Vec3 center() const override { return p_; }
  float radius() const override { return circumscribed_radius(); }
  float reach(const Vec3& n) const override;
  Outline outline() const override;
  bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const override;
  bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const override;
  bool eval_hit(const Vec3& reference, const Vec3& p, uint32_t primitive, const Vec3& wo,
                EmitterHit& out) const override;
  bool seen_from(const Vec3& eye, Sight& out) const override;
  bool emission_square(const Vec3&, uint32_t, const Vec3& direction, Vec2& u) const override {
    return profile_.invert(direction, u);
  }

  bool is_flat() const { return body_.is_flat(); }
  float circumscribed_radius() const { return float(body_.circumscribed_radius()); }
  Vec3 normal() const { return front_; }  // of a flat opening, of its front: towards nadir, or to the brighter side
  // Where a ray with unit direction enters what walks run into: the surface, lifted as ray origins are (a sheet to its
  // front). cosine: |n . d| there.
  bool enter(const Vec3& o, const Vec3& d, float& t, float& cosine) const;

 private:
  Vec3d to_body(const Vec3& v) const { return {dot(v, frame_.s), dot(v, frame_.t), dot(v, frame_.n)}; }
  Vec3d place_in_body(const Vec3& p) const;
  double lift() const { return 2 * double(error_); }
  Vec3 from_body(const Vec3d& v) const;
  // visit(direction, its density) of directions in proportion to the intensity.
  template <class Visit>
  void for_typical_directions(const Visit& visit) const;
  Vec3 brighter_side() const;
  // What leaves a point with normal n towards w, both in the body's frame.
  struct Emitted {
    Rgb intensity;
    double projected_area, cosine;
    float pdf_direction_w;
  };
  bool emitted(const Vec3& direction, const Vec3d& w, const Vec3d& n, Emitted& out) const;

  PlacedProfile profile_;
  LuminousBody body_;
  Frame frame_;  // the body's
  Vec3 p_, front_;
  float pdf_a_, error_;
};

}  // namespace ups
