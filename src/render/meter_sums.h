// One meter's sums over iterations, and what they say together with what landed on its disc.
#pragma once
#include <utility>

#include "render/pooled_bias.h"
#include "render/prediction.h"
#include "render/spread.h"
#include "ups/ups_render.h"

namespace ups {

// Of a meter, or of one source's part of its light. By batch where they are arrays.
struct MeterSums {
  double value[batch_count] = {}, direct[batch_count] = {}, bias[batch_count] = {};
  double exact = 0, exact_mirrored = 0, rounding = 0;
  uint32_t caustics = 0;  // paths that came by way of casters alone
  std::array<PathRecord, light_part_count> paths;
  std::array<uint16_t, light_part_count> batches{};  // a bit for each that such paths have brought light to
  uint8_t largest_batch = 0;                         // that with paths[whole_light].largest
  SampleOrigin largest;                              // the same

  void add(uint32_t batch, const MeterTally& tally, uint32_t iteration);
  void add(const MeterRings::Photons& photons);
};

LightPart light_part(ups_light_part part);

struct MeterLight {
  MeterSums sums;  // with the photons
  MeterRings::Photons photons;
  uint32_t visits;
  std::array<double, light_part_count> largest;  // that one path may bring to an iteration's reading, as far as is known
  std::array<bool, light_part_count> exact;      // nothing of it is a matter of chance
  bool merges_direct;                            // photons bring light straight from emitters, too
  Spread bias;                                   // of merging, estimated: its own, or what neighbours tell besides
  double weight = 1;                             // in the set's mean
  std::array<double, light_part_count> unfound{};  // lx, added to the bound: of what few paths found, see VectorLight
  double edge = 0;  // lx, part of the bias's standard error: caustics that end beside the meter
  double largest_counts = 1;  // of a vector: the share of its largest path's side along it
  double bias_apart = 0;  // lx, root of squares of the biases of photons that have discs of their own: they may cancel

  ups_meter_reading reading() const;
  ups_meter_part_reading part(ups_light_part part) const;
  double mean_of(LightPart part) const;  // lx; of part of a vector with its sign
  bool may_be_merged(LightPart part) const { return part != direct_light || merges_direct; }
  double bias_of(LightPart part) const { return may_be_merged(part) ? bias.mean : 0; }
  uint32_t flags(const ups_meter_reading& reading) const;
  Sample largest_sample() const { return {sums.paths[whole_light].largest, sums.largest}; }
  OwnBias own_bias() const { return {spread(sums.bias, visits), merged_lx(), photons.bias_scale, photons.widest_scale}; }
  double merged_lx() const;  // at most: of light that photons may bring; of the rest bias is no share
  // Standard error and bound; -1: not known. apart: what the bound is made of, lx; nothing where it is not known.
  std::pair<float, float> error_of(LightPart part, MeterError* apart = nullptr) const;
};

}  // namespace ups
