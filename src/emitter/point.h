// Sources without extent in position or direction: point, spot and directional lights as in glTF's KHR_lights_punctual.
// Made by the scene for its lights. No eye path can hit them.
#pragma once
#include "emitter/emitter.h"

namespace ups {

// What all sources share that a walk cannot run into and that stand at a point. shift: from there to where rays start
// and end, off a surface that the source lies on; shadow rays bring what they would from the point itself.
class PunctualEmitter : public Emitter {
 public:
  bool is_delta() const override { return true; }
  Vec3 center() const override { return p_; }
  float radius() const override { return 0; }
  bool eval_hit(const Vec3&, const Vec3&, uint32_t, const Vec3&, EmitterHit&) const override { return false; }
  bool seen_from(const Vec3& eye, Sight& out) const override;

 protected:
  PunctualEmitter(const Vec3& p, float error, const Vec3& shift) : p_(p), start_(p + shift), error_(error) {}
  void start_emission(const Vec3& direction, const Rgb& flux, float pdf_direction_w, EmissionSample& out) const;
  // Fills what follows from the two points; the weight becomes 1 / d^2. False where they are the same.
  bool start_direct(const Vec3& reference, DirectSample& out) const;

 private:
  Vec3 p_, start_;
  float error_;
};

// The same intensity, cd, in all directions.
class PointEmitter : public PunctualEmitter {
 public:
  PointEmitter(const Vec3& p, const Rgb& intensity, float error, const Vec3& shift = {})
      : PunctualEmitter(p, error, shift), intensity_(intensity) {}
  EmitterKind kind() const override { return EmitterKind::point; }
  double flux_lm() const override;
  Rgb flux_rgb() const override;
  Outline outline() const override;
  bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const override;
  bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const override;
  bool emission_square(const Vec3& p, uint32_t, const Vec3& direction, Vec2& u) const override;

 private:
  Rgb intensity_;
};

// A cone about the axis: the intensity, cd, within the inner angle, none outside the outer one, between them the square
// of a ramp in the cosine (KHR_lights_punctual, "Inner and Outer Cone Angles").
class SpotEmitter : public PunctualEmitter {
 public:
  SpotEmitter(const Vec3& p, const Vec3& axis, const Rgb& intensity, float inner_cone_rad, float outer_cone_rad,
              float error, const Vec3& shift = {});
  EmitterKind kind() const override { return EmitterKind::spot; }
  double flux_lm() const override;
  Rgb flux_rgb() const override;
  Outline outline() const override;
  bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const override;
  bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const override;
  bool emission_square(const Vec3& p, uint32_t, const Vec3& direction, Vec2& u) const override;

 private:
  double versine_to(const Vec3& direction) const;
  double attenuation(double versine) const;

  Frame frame_;
  Rgb intensity_;
  // 1 - cos of the cones: keeps its digits for narrow beams, where the cosine loses them.
  double inner_versine_, outer_versine_;
  double solid_angle_;  // integral of the attenuation over directions, sr
};

// Parallel light of the given illuminance, lx, on a plane across it. Light paths start on a disc behind the scene; its
// area density stands for the position, both densities of the direction are 1.
class DirectionalEmitter : public Emitter {
 public:
  // direction: of travel.
  DirectionalEmitter(const Vec3& direction, const Rgb& illuminance, float scene_radius, const Vec3& scene_center = {});
  EmitterKind kind() const override { return EmitterKind::directional; }
  bool is_delta() const override { return true; }
  bool is_directional() const override { return true; }
  double flux_lm() const override;
  Rgb flux_rgb() const override;
  Vec3 center() const override { return scene_center_; }
  float radius() const override { return scene_radius_; }
  Outline outline() const override;
  bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const override;
  bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const override;
  bool emission_square(const Vec3& p, uint32_t, const Vec3& direction, Vec2& u) const override;
  bool eval_hit(const Vec3&, const Vec3&, uint32_t, const Vec3&, EmitterHit&) const override { return false; }

 private:
  float pdf_position_a() const { return 1 / (pi * scene_radius_ * scene_radius_); }

  Frame frame_;  // n: direction of travel
  Rgb illuminance_;
  float scene_radius_;
  Vec3 scene_center_;
};

}  // namespace ups
