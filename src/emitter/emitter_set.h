// All emitters of a scene, and the choice among them for light paths and for next-event estimation.
#pragma once
#include <memory>
#include <vector>

#include "base/discrete.h"
#include "emitter/emitter.h"
#include "emitter/light_tree.h"

namespace ups {

class EmitterSet {
 public:
  EmitterSet() = default;
  // exposed: of each emitter, the share of its flux that reaches a surface where next-event estimation can pick it, in
  // [0, 1]; empty: all. A lamp behind a lens has none, and choosing it there is wasted. Only choose_direct uses it.
  explicit EmitterSet(std::vector<std::shared_ptr<const Emitter>> emitters, const std::vector<float>& exposed = {});

  // Whether `exposed` makes a difference for so many emitters.
  static bool uses_exposed(size_t count) { return count > 1 && count <= LightTree::max_listed; }

  // Whether next-event estimation chooses by the nodes of a tree, and not among all of them.
  bool has_tree() const { return direct_[0].is_tree() || direct_[1].is_tree(); }

  size_t size() const { return emitters_.size(); }
  const Emitter& operator[](size_t i) const { return *emitters_[i]; }
  const std::shared_ptr<const Emitter>& shared(size_t i) const { return emitters_[i]; }
  // As each says of itself; walks ask at every vertex.
  bool is_delta(size_t i) const { return kinds_[i].delta; }
  bool is_directional(size_t i) const { return kinds_[i].directional; }
  double flux_lm() const { return flux_lm_; }
  size_t bytes() const;

  using Choice = EmitterChoice;
  // For a light path: in proportion to flux, where there are directional emitters and others no less than a quarter for
  // each kind.
  Choice choose_emission(double u) const;
  float emission_probability(size_t i) const;
  // For next-event estimation at a point: by about what each emitter would bring there, see light_tree.h. Never one
  // that it cannot sample. Directional ones are chosen by themselves (far): the sun is strong, and mostly hidden
  // indoors.
  Choice choose_direct(const Receiver& receiver, double u, bool far = false) const {
    return direct_[far].choose(receiver, u);
  }
  // Among those of its kind.
  float direct_probability(const Receiver& receiver, size_t i) const {
    return direct_[is_directional(i)].probability(receiver, i);
  }
  bool has_direct(bool far) const { return has_direct_[far]; }
  // Whether next-event estimation needs a place on any of them.
  bool have_extent() const { return have_extent_; }

 private:
  struct Kind {
    bool delta, directional;
  };
  std::vector<std::shared_ptr<const Emitter>> emitters_;
  std::vector<Kind> kinds_;
  DiscreteDistribution emission_;
  double flux_lm_ = 0;
  LightTree direct_[2];  // near, far
  bool has_direct_[2] = {}, have_extent_ = false;
};

}  // namespace ups
