// Sums of one goniometer over iterations, and what can be said of their error. Kept by the accumulator.
#pragma once
#include <string>
#include <vector>

#include "render/zero_bound.h"
#include "transport/tally.h"
#include "ups/ups_render.h"

namespace ups {

struct GoniometerReading {
  ups_goniometer_info info{};  // without what the light balance adds: absorbed_flux_lm
  std::vector<ups_intensity_reading> nodes;  // gamma fastest
  // cd of each node that stands for itself, by all batches but one; empty where there are too few.
  std::vector<std::vector<float>> without_batch;
};

class GoniometerSums {
 public:
  // emitted_lm: by the scene's emitters; light_paths: an iteration, 0: none.
  GoniometerSums(const Goniometer& goniometer, double emitted_lm, uint32_t light_paths);
  // Of a node: its sums, one iteration's tally, the reading.
  static constexpr double sum_bytes = 2 * sizeof(double) * batch_count, tally_bytes = 2 * sizeof(double),
                          reading_bytes = sizeof(ups_intensity_reading) + sizeof(float) * batch_count;
  void add(uint32_t batch, const GoniometerTally& tally);
  GoniometerReading read(uint32_t iterations) const;
  // Of each node that stands for itself: bound / max(I, 5 % of the peak), without light of what the emitters would
  // bring to all directions alike. False where it is not known yet.
  bool relative_errors(uint32_t iterations, std::vector<double>& out) const;
  // Noise of a node's intensity, 95 %, relative, in the mean over the light: what more iterations lessen, as they do
  // not lessen blur. All nodes without light have together what one of them could have. < 0: not known yet.
  double mean_noise(uint32_t iterations) const;
  // What of the light, beyond noise, has not the symmetry that the goniometer was told, in words; empty: nothing.
  std::string asymmetry(uint32_t iterations) const;

 private:
  ups_intensity_reading read_node(uint32_t node, uint32_t iterations) const;
  ChanceLight chance(uint32_t node, uint32_t iterations) const {
    return chance_light(&wide_[size_t(node) * batch_count], iterations);
  }

  const Goniometer& goniometer_;
  const double emitted_lm_;
  double largest_;  // lm that one light path brought, at least what they bring in the mean
  std::vector<double> wide_, narrow_;  // batch_count a node
  double flux_[batch_count] = {}, outside_ = 0, moments_[4][batch_count] = {};
};

}  // namespace ups
