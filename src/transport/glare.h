// What an observer sees of the emitters: the sources of a glare rating. Called by render/job, once a render.
#pragma once
#include "base/parallel.h"
#include "base/stop.h"
#include "photometry/ugr.h"
#include "scene/snapshot.h"

namespace ups {

struct SeenSource {
  uint32_t emitter = 0;      // or one of its parts, where it is a surface of several that do not touch
  photometry::GlareSource glare;
  Vec3 direction;            // from the eye
  double visible_share = 0;  // of its light
  double term = 0;           // L^2 w / p^2
  double term_error = 0;     // standard error of it, by the rays that look for what hides it
  bool is_covered = false;   // by what lets light through and is no pane
  double missed = 0;         // 95 %: what a term of 0 may be all the same, what one that nothing hides may lack
};

struct SeenGlare {
  std::vector<SeenSource> sources;  // with a term above 0, the largest first
  double sum = 0, sum_error = 0;    // of the terms
  // 95 %: what the sum may have more, of sources that no ray has seen; and less, of those that all rays have seen. Of
  // points, which one ray sees or not, nothing.
  double unseen = 0, hidden = 0;
  double ceiling_coverage = 0;      // by large sources (CIE 147); 0 where none is seen
  bool has_unrated = false;         // sources without a luminance or intensity: parallel light, rays of a file
  bool has_fixture = false;         // one in view, whose own optics are no source
  bool has_covered = false;         // one in view behind glass or a diffuser that is no pane, which are no source
};

// By rays to places of each emitter that are spread evenly and by chance, the same in every render. Nothing where `stop`
// was set.
SeenGlare find_glare(const Snapshot& scene, const Observer& observer, ThreadPool& pool, const StopSignal& stop);

}  // namespace ups
