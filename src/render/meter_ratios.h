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
// Of a meter of each, by its place in the batches.
Ratio ratio_at(const MeterBatches& numerator, size_t m, const MeterBatches& denominator, size_t n);

}  // namespace ups
