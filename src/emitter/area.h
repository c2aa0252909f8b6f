// Triangles that emit light evenly in all directions: a Lambertian area emitter of constant luminance. Made by the
// scene for every instance whose material emits.
#pragma once
#include <functional>
#include <vector>

#include "base/discrete.h"
#include "emitter/emitter.h"

namespace ups {

struct EmitterTriangle {
  Vec3 p0, p1, p2;
};

class AreaEmitter : public Emitter {
 public:
  // Triangles in the order of the mesh (a hit's primitive is an index into them), counter-clockwise seen from the side
  // that emits; both_sides: the back emits as well, with the same radiance, cd/m^2.
  AreaEmitter(std::vector<EmitterTriangle> triangles, const Rgb& radiance, bool both_sides, uint32_t instance);
  // The same triangles with other light.
  AreaEmitter(const AreaEmitter& shape, const Rgb& radiance, bool both_sides) : AreaEmitter(shape) {
    radiance_ = radiance, both_sides_ = both_sides;
  }
  bool emits_both_sides() const { return both_sides_; }
  void set_radiance(const Rgb& radiance) { radiance_ = radiance; }
  // At least the ray tracer's of its points, which knows in which frame it meets them.
  void set_least_error(float m) { least_error_ = m; }

  EmitterKind kind() const override { return EmitterKind::area; }
  bool is_delta() const override { return false; }
  double brightest_cd_m2() const override { return area() > 0 ? double(luminance(radiance_)) : 0; }
  double flux_lm() const override;
  Rgb flux_rgb() const override;
  Vec3 center() const override { return center_; }
  float radius() const override { return radius_; }
  float reach(const Vec3& n) const override;
  size_t bytes() const override {
    return triangles_.capacity() * sizeof(EmitterTriangle) + normals_.capacity() * sizeof(Vec3) + by_area_.bytes();
  }
  Outline outline() const override;
  bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const override;
  bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const override;
  bool eval_hit(const Vec3& reference, const Vec3& p, uint32_t primitive, const Vec3& wo,
                EmitterHit& out) const override;
  bool seen_from(const Vec3& eye, Sight& out) const override;
  bool emission_square(const Vec3& p, uint32_t primitive, const Vec3& direction, Vec2& u) const override;

  double area() const { return by_area_.total(); }
  // Parts that stand apart, as emitters of their own: those without a common corner, and farther from one another than
  // a quarter of the smaller one's size, and than 10 cm. Empty where all is one part, or more than `most` have no common
  // corner.
  std::vector<AreaEmitter> separate_parts(size_t most) const;
  // As an eye sees it, in pieces that are small beside their distance and count by their centres: the mean over its solid
  // angle of a weight by direction, and its area across the line of sight.
  struct Stretch {
    double weight = 0, area_m2 = 0;
  };
  Stretch stretch_over(const Vec3& eye, const std::function<double(const Vec3&)>& weight) const;

 private:
  struct Point {
    Vec3 p, n;  // n: unit normal of the front
    float error;
    uint32_t primitive;
  };
  bool sample_position(const Vec2& u, Point& out) const;
  float direction_pdf(float cos_front) const;  // per solid angle, of a direction with this cosine to the front normal

  std::vector<EmitterTriangle> triangles_;
  std::vector<Vec3> normals_;  // zero for a triangle without area
  DiscreteDistribution by_area_;
  Rgb radiance_;
  bool both_sides_;
  uint32_t instance_;
  float pdf_a_ = 0;
  Vec3 center_, half_;  // of the bounding box
  float radius_ = 0, least_error_ = 0;
};

}  // namespace ups
