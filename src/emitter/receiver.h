// A point that light may arrive at, as the choice of emitters for next-event estimation sees it: a function of the
// vertex alone, so that the eye walk that chooses there and the light walk that arrives there know the same.
#pragma once
#include "base/vec.h"

namespace ups {

struct Receiver {
  Vec3 p;
  Vec3 n;                   // unit, geometric, on the side that light comes from; zero: cosines do not count
  bool both_sides = false;  // it also scatters light through by a continuous lobe: light from either side counts
};

}  // namespace ups
