// What a ray meets next, and through which media it runs until there. Used by every walk and shadow ray.
//
// A boundary of glass inside a stronger medium, or between equal indices, is none: rays run on through it, and it
// becomes no vertex of a path. Faces that lie on one another within rounding, as those of cemented lenses, are one
// boundary between what lies before and behind all of them.
#pragma once
#include <limits>
#include <vector>

#include "scene/snapshot.h"
#include "transport/tally.h"

namespace ups {

inline Rgb attenuation(const Snapshot& scene, const MediaStack& media, float distance) {
  if (media.top() == none) return Rgb(1.0f);
  return exp(scene.materials[scene.media.by_rank[media.top()].material].absorption_per_m * -distance);
}

struct Encounter {
  bool found = false;
  SurfacePoint surface;  // where found
  float distance = std::numeric_limits<float>::infinity();
  MediaStack media;        // of the last stretch before it
  MediaStack front, back;  // on the surface's two sides
  float relative_ior = 1;  // of the back over the front, where the surface is of glass
  struct Stretch {
    float end;
    MediaStack media;
  };
  std::vector<Stretch> earlier;  // up to the boundaries without effect that were crossed
  // Panes and blended surfaces that were crossed, each with all before it: what is left of a walk's throughput, and its
  // probability.
  struct Crossed {
    float end;
    Rgb share;
    double pass;
  };
  std::vector<Crossed> panes;

  // Nothing takes light on the way to the surface.
  bool is_clear() const { return panes.empty() && earlier.empty() && media.top() == none; }
  // At `t` along the ray, not beyond the surface.
  Rgb transmittance(const Snapshot& scene, float t) const {
    const Rgb through = panes.empty() ? Rgb(1.0f) : crossed_before(t).share;
    return through * (earlier.empty() ? attenuation(scene, media, t) : transmittance_of_stretches(scene, t));
  }
  // Probability that a walk went on through the panes before t.
  double pass(float t) const { return panes.empty() ? 1.0 : crossed_before(t).pass; }
  // Of what lies before the last stretch: all that light meets which leaves the scene.
  Rgb transmittance_of_earlier(const Snapshot& scene) const {
    const Rgb through = panes.empty() ? Rgb(1.0f) : panes.back().share;
    return earlier.empty() ? through : through * transmittance_of_stretches(scene, earlier.back().end);
  }
  // What a ray from the surface towards w runs in.
  const MediaStack& beyond(const Vec3& w) const { return dot(w, surface.ng) < 0 ? back : front; }
  Bsdf bsdf(const Snapshot& scene) const {
    return Bsdf(scene.materials[surface.material], surface.uv, relative_ior);
  }

 private:
  Rgb transmittance_of_stretches(const Snapshot& scene, float t) const;
  Crossed crossed_before(float t) const;
};

// Of an edge: drawn where its first pane asks for it, as most meet none.
class PaneNumber {
 public:
  explicit PaneNumber(float u) : u_(u) {}
  PaneNumber(PathSampler& rng, uint32_t vertex) : rng_(&rng), vertex_(vertex) {}
  float& value() {
    if (rng_) u_ = rng_->get(vertex_, Slot::pane), rng_ = nullptr;
    return u_;
  }

 private:
  PathSampler* rng_ = nullptr;
  uint32_t vertex_ = 0;
  float u_ = 0;
};

// From o along d, where `start` is around o. u: a pane whose reflectance is larger is met, or a blended surface of larger
// alpha; others are crossed, and what is left of it is uniform again. panes_show_nothing: all panes are that let light by.
void meet(const Snapshot& scene, const Vec3& o, const Vec3& d, const MediaStack& start, PaneNumber& u,
          WorkCounts& work, Encounter& out, bool panes_show_nothing = false);

// What panes and blended surfaces leave of light along a segment, and media where they nest; else attenuation_ahead() has
// theirs.
struct Passage {
  Rgb transmittance{1.0f};
  double pass = 1;  // probability that a walk goes on through the panes
};
// Is the segment free, but for panes and what is blended? Shortened at its end by rounding. `media`: around a.
bool segment_free(const Snapshot& scene, const MediaStack& media, const Vec3& a, const Vec3& b, WorkCounts& work,
                  Passage& passage);
// Of a segment that is not traced yet.
inline Rgb attenuation_ahead(const Snapshot& scene, const MediaStack& media, float distance) {
  return scene.media.nest ? Rgb(1.0f) : attenuation(scene, media, distance);
}

}  // namespace ups
