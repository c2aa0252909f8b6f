// A mean of batches that no single sample dominates. Used by images, beside the mean.
#pragma once
#include <algorithm>
#include <array>

#include "render/spread.h"

namespace ups {

using Batches = std::array<float, batch_count>;

struct KeptBatches {
  std::array<uint8_t, batch_count> batches;
  uint32_t count;
  float mean(const Batches& sums, uint32_t samples) const {
    float sum = 0;
    for (uint32_t i = 0; i < count; ++i) sum += sums[batches[i]] / float(visits_of_batch(samples, batches[i]));
    return sum / float(count);
  }
};

// Of the batches in the order of their means, the more at both ends are left out the more unequal they are: all of them
// stay where the Gini coefficient is small, their median where it is 1 (Buisine, Delepoulle, Renaud 2021, Firefly
// removal in Monte Carlo rendering with adaptive median of means, section 4).
inline KeptBatches least_dominated(const Batches& means, uint32_t used) {
  std::array<uint8_t, batch_count> order{};
  for (uint32_t b = 0; b < used; ++b) {
    uint32_t at = b;
    for (; at > 0 && means[b] < means[order[at - 1]]; --at) order[at] = order[at - 1];
    order[at] = uint8_t(b);
  }
  double sum = 0, ranked = 0;
  for (uint32_t i = 0; i < used; ++i) {
    sum += means[order[i]];
    ranked += (i + 1.0) * means[order[i]];
  }
  const double gini = sum > 0 ? (2 * ranked / sum - (used + 1)) / used : 0;
  const uint32_t left_out = std::min(uint32_t(gini * used / 2), (used - 1) / 2);
  KeptBatches kept{{}, used - 2 * left_out};
  std::copy_n(order.begin() + left_out, kept.count, kept.batches.begin());
  return kept;
}

}  // namespace ups
