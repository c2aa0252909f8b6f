// What an emitter looks like, roughly: where it lies, and how much it shines in which direction. Enough to choose among
// emitters by, never the light itself.
#pragma once
#include <vector>

#include "base/frame.h"

namespace photometry {
class Distribution;
}

namespace ups {

struct Outline {
  // uniform: alike in all directions; cosine: towards frame.n; two_cosines: to both sides; cone: about frame.n;
  // profile: a distribution in the frame; facets: the sum over `areas` of their cosines.
  enum class Shape { uniform, cosine, two_cosines, cone, profile, facets };
  Shape shape = Shape::uniform;
  float intensity = 0;  // cd, luminance: multiplies the shape; of facets: cd/m^2
  Vec3 center, half;    // of the box along the axes that holds it
  Frame frame;
  double outer_versine = 0, inner_versine = 0;  // cone: as in SpotEmitter
  const photometry::Distribution* distribution = nullptr;
  std::vector<Vec3> areas;  // m^2, along the normals
};

}  // namespace ups
