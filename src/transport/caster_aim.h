// Where light leaves emitters towards what casts caustics, told by points of those surfaces: a small mirror gets its
// share of light paths though none of a pilot has met it.
#pragma once
#include "base/parallel.h"
#include "emitter/guide.h"
#include "scene/snapshot.h"

namespace ups {

class CasterAims {
 public:
  // shown: no caster sends on what a flat mirror reflects, so that nothing need be aimed at one that shows the emitter.
  CasterAims(const Snapshot& scene, bool shown, ThreadPool& pool);
  // Those at surfaces that so many light paths, unguided, would hardly meet: the others they find by themselves.
  // densest: see GuideTraining::aim.
  GuideTraining missed_by(double paths, double densest) const;

 private:
  struct Caster {
    uint32_t number;  // of casters
    float share;      // of the emitter's light that may go there
    std::vector<uint32_t> cells;  // none: it is too large to be looked for
  };
  class Search;
  std::vector<std::vector<Caster>> of_emitter_;
  std::vector<double> share_;  // of all light paths, by caster
};

}  // namespace ups
