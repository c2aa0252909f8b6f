// What an observer sees of the emitters: the sources of a glare rating. Called by render/job, once a render.
#pragma once
#include "base/parallel.h"
#include "base/stop.h"
#include "emitter/area.h"
#include "photometry/ugr.h"
#include "scene/snapshot.h"

namespace ups {

struct SeenSource {
  uint32_t emitter = 0;
  photometry::GlareSource glare;
  Vec3 direction;            // from the eye
  double visible_share = 0;  // of its light
  double largest_sr = 0;     // of one of its parts, which stand apart, before anything hides it
  double term = 0;           // L^2 w / p^2
  double term_error = 0;     // standard error of it, by the rays that look for what hides it
  bool by_place = false;     // stretches so far that each piece counts by its place in view
  bool is_covered = false;   // by what lets light through and is no pane
  bool is_unrated = false;   // all of it or some: what is not finite is left out
  double missed = 0;         // 95 %: what a term of 0 may be all the same, what one that nothing hides may lack
};

struct SeenGlare {
  std::vector<SeenSource> sources;  // with a term above 0, the largest first
  double sum = 0, sum_error = 0;    // of the terms
  // 95 %: what the sum may have more, of sources that no ray has seen; and less, of those that all rays have seen. Of
  // points, which one ray sees or not, nothing.
  double unseen = 0, hidden = 0;
  double ceiling_coverage = 0;      // by large sources (CIE 147); 0 where none is seen
  bool has_unrated = false;         // parallel light and rays of a file, without luminance; what is not finite
  bool has_fixture = false;         // one in view, whose own optics are no source
  bool has_covered = false;         // one in view behind glass or a diffuser that is no pane, which are no source
};

// The emitters as an eye tells them apart: a surface in parts that stand apart has each by itself. For all observers.
class GlareParts {
 public:
  struct Part {
    const Emitter* emitter;
    uint32_t index, number;  // in the scene; among its emitter's
  };
  GlareParts(const Snapshot& scene, ThreadPool& pool, const StopSignal& stop);
  const std::vector<Part>& all() const { return all_; }

 private:
  std::vector<std::vector<AreaEmitter>> own_;
  std::vector<Part> all_;
};

// By rays to places of each emitter that are spread evenly and by chance, the same in every render. Nothing where `stop`
// was set.
SeenGlare find_glare(const Snapshot& scene, const GlareParts& parts, const Observer& observer, ThreadPool& pool,
                     const StopSignal& stop);

}  // namespace ups
