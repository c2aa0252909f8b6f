// Thin panes of glass and blended surfaces (alpha), which light crosses straight: a segment has a transmittance, and a
// walk along it goes on through each with the probability that is left of reflection, or of alpha. Made at commit; read
// by transport/encounter.h.
#pragma once
#include <algorithm>
#include <vector>

#include "geometry/box.h"
#include "geometry/raytracer.h"
#include "scene/media.h"

namespace ups {

struct Snapshot;

// A pane within reach of another surface, so that where rays go on beyond the pane may lie behind that, too.
struct PaneOnSurface {
  uint32_t instance;
  uint32_t opaque = none;  // an instance that lets no light by there, if any
  float covered = 0;       // share of the pane where one does
};

struct Panes {
  std::vector<bool> of_instance;  // of glazing, and emits nothing; empty: there is none
  std::vector<bool> blended;      // where alpha lets a share of the light by, through glazing too; empty: none
  std::vector<bool> on_surface;   // whether a pane is among on_surfaces; empty: none
  std::vector<PaneOnSurface> on_surfaces;
  std::vector<bool> touched_glass;  // solids of glass that touch what no light goes through; empty: none
  Box bounds;  // of all

  bool empty() const { return of_instance.empty() && blended.empty(); }
  bool is_pane(uint32_t instance) const { return !of_instance.empty() && of_instance[instance]; }
  bool is_blended(uint32_t instance) const { return instance < blended.size() && blended[instance]; }
  bool is_on_surface(uint32_t instance) const { return !on_surface.empty() && on_surface[instance]; }
  bool is_touched_glass(uint32_t instance) const { return instance < touched_glass.size() && touched_glass[instance]; }
  bool is_crossed(uint32_t instance) const { return is_pane(instance) || is_blended(instance); }
  bool operator==(const Panes& b) const { return of_instance == b.of_instance && blended == b.blended; }
  // False where the segment cannot meet one. Most lie altogether to one side of them.
  bool may_lie_between(const Vec3& a, const Vec3& b) const {
    const auto beside = [](float from, float to, double lower, double upper) {
      return std::max(from, to) < lower || std::min(from, to) > upper;
    };
    return !empty() && !beside(a.x, b.x, bounds.lower.x, bounds.upper.x) &&
           !beside(a.y, b.y, bounds.lower.y, bounds.upper.y) && !beside(a.z, b.z, bounds.lower.z, bounds.upper.z) &&
           meets_bounds(a, b);
  }

 private:
  bool meets_bounds(const Vec3& a, const Vec3& b) const;
};

// It is met as other surfaces are: what it lets through goes on by a lobe of its own, a delta.
bool is_shining_pane(const Snapshot& scene, size_t instance);

Panes find_panes(const Snapshot& scene, const std::vector<Raytracer::Instance>& instances);

// The share of the light that meets a surface: alpha where it is blended.
float coverage(const Snapshot& scene, const SurfacePoint& s);

// The first hit along d for rays that tell of many: each blended surface is there for a share of them, the same ones
// each time.
bool intersect_blended(const Snapshot& scene, const Vec3& o, const Vec3& d, Hit& hit);
// And that is no pane's.
bool intersect_beyond_panes(const Snapshot& scene, const Vec3& o, const Vec3& d, Hit& hit);

}  // namespace ups
