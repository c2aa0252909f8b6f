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
  explicit EmitterSet(std::vector<std::unique_ptr<Emitter>> emitters);

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
  // For next-event estimation at a point: a function of the point alone, so that both walks know it.
  Choice choose_direct(const Vec3& reference, float u) const;
  float direct_probability(const Vec3& reference, size_t i) const;

 private:
  std::vector<std::unique_ptr<Emitter>> emitters_;
  DiscreteDistribution by_flux_;
  double flux_lm_ = 0;
  // Implementers: add what choose_direct needs.
};

}  // namespace ups
