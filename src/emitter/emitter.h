// What emits light. One interface for surfaces, points and luminous openings; a kind is a class in a file of its own.
//
// Densities: *_a per area (m^-2), *_w per solid angle. A source without extent has no area density: its position
// densities are 1 in both emission and next-event estimation, so that their ratio is right. Densities here do not
// include the probability of choosing the emitter; EmitterSet knows that.
#pragma once
#include <cstdint>

#include "base/frame.h"
#include "base/rgb.h"
#include "emitter/outline.h"

namespace ups {

// The start of a light path.
struct EmissionSample {
  Vec3 p;
  Vec3 n;          // unit normal on the emitting side; zero for a point
  Vec3 direction;  // unit, away from the emitter
  Rgb flux;        // lm: emitted / (pdf_position * pdf_direction), cosine included
  float pdf_position_a = 1;
  float pdf_direction_w = 0;
  float cos_0 = 1;  // |n . direction|; 1 for points and directional lights
  float error = 0;  // of p, for ray origins
  uint32_t instance = invalid, primitive = invalid;  // the surface that it starts from, if any
  static constexpr uint32_t invalid = 0xffffffffu;
};

// Next-event estimation: light that arrives at a reference point from one sampled point of the emitter.
struct DirectSample {
  Vec3 p;
  Vec3 n;            // emitting side's normal; zero for a point
  Vec3 wi;           // unit, from the reference point to p
  float distance;    // directional: 2 * scene radius
  Rgb weight;        // lx per unit cosine at the receiver: L cos_0 / (d^2 pdf_a), or I / d^2; directional: lx
  float cos_0 = 1;
  float pdf_nee_a = 1;        // of p, as sampled for this reference point
  float pdf_position_a = 1;   // of p by emission sampling
  float pdf_direction_w = 0;  // of -wi by emission sampling
  float error = 0;            // of p
  uint32_t primitive = 0;     // as eval_hit counts them
};

// A walk has run into the emitter at p, n (front side), coming from `reference`; wo points back along the walk.
struct EmitterHit {
  Rgb radiance;  // towards wo; cd/m^2
  float pdf_nee_a = 0, pdf_position_a = 0, pdf_direction_w = 0;
};

// What an eye sees of an emitter that nothing hides.
struct Sight {
  Vec3 direction;            // unit, to its centre
  double distance = 0;       // of that
  double intensity_cd = 0;   // towards the eye
  double solid_angle_sr = 0; // 0: a point
};

enum class EmitterKind { area, point, spot, directional, profile_point, profile_opening, rays };

class Emitter {
 public:
  virtual ~Emitter() = default;
  virtual EmitterKind kind() const = 0;
  virtual bool is_delta() const = 0;        // no eye path can hit it
  virtual bool is_directional() const { return false; }
  virtual bool is_direct() const { return true; }  // next-event estimation can sample it
  virtual double brightest_cd_m2() const { return 0; }  // that an eye path can run into
  virtual double flux_lm() const = 0;       // luminance-weighted, all sides
  virtual Rgb flux_rgb() const = 0;
  virtual Vec3 center() const = 0;          // of its bounds
  virtual float radius() const = 0;         // of its bounds; 0 for a point
  virtual float reach(const Vec3&) const { return radius(); }  // from the centre along a unit vector, either way
  virtual size_t bytes() const { return 0; }  // of its own tables
  virtual Outline outline() const { return {}; }  // of one that next-event estimation can sample
  // False where nothing is emitted at u. u_position.x may be used to choose a part; all numbers in [0, 1).
  virtual bool sample_emission(const Vec2& u_position, const Vec2& u_direction, EmissionSample& out) const = 0;
  // u_position of a path of that batch, where batches have parts of their own: of rays that are a sample.
  virtual Vec2 position_of_batch(const Vec2& u, uint32_t /*batch*/, uint32_t /*batches*/) const { return u; }
  virtual bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const = 0;
  // Area emitters and openings. `primitive` is the triangle (area) or 0. False where wo sees no emission.
  virtual bool eval_hit(const Vec3& reference, const Vec3& p, uint32_t primitive, const Vec3& wo,
                        EmitterHit& out) const = 0;
  // As a source of glare: luminaires and points as from afar, by the intensity of the whole towards the eye; surfaces
  // as they are. False where the eye sees no light of it, or it has no intensity.
  virtual bool seen_from(const Vec3&, Sight&) const { return false; }
  // The inverse of sample_emission: u_direction of the light that leaves p in that direction; of a directional light,
  // u_position of the light that passes p. False where there is none. `primitive`: as for eval_hit.
  virtual bool emission_square(const Vec3& p, uint32_t primitive, const Vec3& direction, Vec2& u) const = 0;
};

}  // namespace ups
