// One meter's sums over iterations, and the reading that they make together with what landed on its disc.
#pragma once
#include "render/meter_rings.h"
#include "render/spread.h"
#include "ups/ups_render.h"

namespace ups {

struct MeterSums {
  double value[batch_count] = {}, direct = 0, bias[batch_count] = {};
  void add(uint32_t batch, const MeterTally& tally);
  void add(const MeterRings::Photons& photons);
};

// Even and odd batches apart, as their discs differ, and so does their bias.
Spread spread_of_halves(const double* sums, uint32_t visits);
// sums: with the photons.
ups_meter_reading reading_of(const MeterSums& sums, const MeterRings::Photons& photons, uint32_t visits);

}  // namespace ups
