// Tables of type A and B on C-planes, for formats that have no others. Used by eulumdat_writer.cpp.
#pragma once
#include "photometry/distribution.h"

namespace photometry {

// The same light as a table of type C; one of type C as it is. Even steps that are no coarser than the source's finest
// (5, 2.5 or 1 degree), or the next finer of these, where they keep flux and peak within 0.1 %. Else a node at the peak
// and at the brightest place of every 5 degrees that have light, and between them steps of 5, 1, 0.5, 0.1 and 0.05
// degrees: finer where linear interpolation misses light, until it misses less than 0.1 % of the flux in all or the
// table has 720 planes, 361 rows or 150,000 values. Angles have as many decimals as EULUMDAT's six characters hold.
Distribution in_c_gamma(const Distribution& distribution);

}  // namespace photometry
