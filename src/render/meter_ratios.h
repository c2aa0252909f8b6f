// Ratios between meters, with their errors: of the means of two areas, and of two kinds of illuminance at the same
// places (modelling: cylindrical over horizontal). Both share light paths, so ratios have batches of their own.
#pragma once
#include "render/meter_statistics.h"

namespace ups {

struct Ratio {
  double value = -1;
  Interval interval;  // 95 %, noise and bias; -1: not known, as where the denominator's own error is more than half of it
};
Ratio ratio_of_means(const MeterBatches& numerator, const MeterBatches& denominator);
// Of one meter of each; both have as many.
Ratio ratio_at(const MeterBatches& numerator, const MeterBatches& denominator, size_t meter);

}  // namespace ups
