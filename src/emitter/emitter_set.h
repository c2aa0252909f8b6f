// All emitters of a scene, and the choice among them for light paths and for next-event estimation.
#pragma once
#include <memory>
#include <vector>

#include "base/discrete.h"
#include "emitter/emitter.h"

namespace ups {

class EmitterSet {
 public:
  EmitterSet() = default;
  // exposed: of each emitter, the share of its flux that reaches a surface where next-event estimation can pick it, in
  // [0, 1]; empty: all. A lamp behind a lens has none, and choosing it there is wasted. Only choose_direct uses it.
  explicit EmitterSet(std::vector<std::unique_ptr<Emitter>> emitters, const std::vector<float>& exposed = {});

  // Whether `exposed` makes a difference for so many emitters.
  static bool uses_exposed(size_t count) { return count > 1 && count <= max_by_distance; }

  size_t size() const { return emitters_.size(); }
  const Emitter& operator[](size_t i) const { return *emitters_[i]; }
  double flux_lm() const { return flux_lm_; }

  struct Choice {
    uint32_t index = 0;
    float probability = 0;  // 0: nothing emits
    float u = 0;            // uniform again in [0, 1): stratification is kept
  };
  // For a light path: in proportion to flux.
  Choice choose_emission(float u) const;
  float emission_probability(size_t i) const;
  // For next-event estimation at a point: a function of the point alone, so that both walks know it. Up to 64 emitters
  // by flux / distance^2, mixed with a tenth by flux; more by flux. Never one that it cannot sample.
  Choice choose_direct(const Vec3& reference, float u) const;
  float direct_probability(const Vec3& reference, size_t i) const;

 private:
  std::vector<std::unique_ptr<Emitter>> emitters_;
  static constexpr size_t max_by_distance = 64;
  struct Nearness;
  Nearness nearness(const Vec3& reference) const;
  float mixed_probability(const Nearness& near, size_t i) const;

  DiscreteDistribution by_flux_, direct_by_flux_;  // the second of those that next-event estimation can sample
  double flux_lm_ = 0;
  // Of each emitter, if there are at most max_by_distance and next-event estimation can sample any. Below
  // least_distance2 emitters at one place are told apart by flux, so that nothing divides by zero.
  struct Bounds {
    Vec3 center;
    float flux, least_distance2;
    bool directional;
  };
  std::vector<Bounds> bounds_;
};

}  // namespace ups
