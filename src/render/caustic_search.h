// Light by way of casters that photons alone bring, or without them eye paths that run into its emitter, hides in other
// light, whose error the batches know, until enough of them have come. Used by the sums of meters and images.
#pragma once
#include "render/zero_bound.h"

namespace ups {

struct CausticSearch {
  double m2 = 0;     // where light paths would be found, summed over iterations
  double paths = 0;  // that were found there, by way of casters alone

  static constexpr double enough = 8;  // paths, for the spread of what came to know its error
  void add(const CausticSearch& o) { m2 += o.m2, paths += o.paths; }
  // 95 %, lx, of what was not found, where a light path starts with so many lm; 0 where nothing was looked for, or
  // where enough came for the spread of what came to know its error.
  double unfound_lx(double brightest_lm, uint32_t light_paths) const {
    if (!(m2 > 0) || paths >= enough || light_paths == 0) return 0;
    return brightest_lm * poisson_excess(paths) / (light_paths * m2);
  }
};

}  // namespace ups
