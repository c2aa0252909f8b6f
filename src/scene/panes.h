// Thin panes of glass, which light crosses straight: a segment has a transmittance, and a walk along it goes on through
// each with the probability that is left of reflection. Made at commit; read by transport/encounter.h.
#pragma once
#include <vector>

#include "geometry/box.h"
#include "geometry/raytracer.h"

namespace ups {

struct Snapshot;

struct Panes {
  std::vector<bool> of_instance;  // of glazing, and emits nothing; empty: there is none
  Box bounds;                     // of all

  bool is_pane(uint32_t instance) const { return !of_instance.empty() && of_instance[instance]; }
  bool is_pane(const Hit& hit) const { return is_pane(hit.instance); }
  // False where the segment cannot meet one.
  bool may_lie_between(const Vec3& a, const Vec3& b) const;
};

Panes find_panes(const Snapshot& scene, const std::vector<Raytracer::Instance>& instances);

// The first hit along d that is no pane's.
bool intersect_beyond_panes(const Snapshot& scene, const Vec3& o, const Vec3& d, Hit& hit);

}  // namespace ups
