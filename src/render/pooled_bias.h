// What meters beside each other tell of the bias of their discs: most of what one of them says alone is noise.
#pragma once
#include <vector>

#include "render/meter_sums.h"

namespace ups {

// Of a set's meters, in its order, in which neighbours follow each other. Each bias that is not beyond doubt becomes
// what is to be expected of it when the neighbours' curvatures are known.
void pool_bias(std::vector<MeterLight>& lights);

}  // namespace ups
