// Sums of one goniometer over iterations, and what can be said of their error. Kept by the accumulator.
#pragma once
#include <string>
#include <vector>

#include "render/spread.h"
#include "transport/tally.h"
#include "ups/ups_render.h"

namespace ups {

struct GoniometerReading {
  ups_goniometer_info info{};  // without what the light balance adds: absorbed_flux_lm
  std::vector<ups_intensity_reading> nodes;  // gamma fastest
};

class GoniometerSums {
 public:
  explicit GoniometerSums(const Goniometer& goniometer);
  // Sums, one iteration's tally, the reading.
  static constexpr double bytes_per_node = 2 * sizeof(double) * (batch_count + 1) + sizeof(ups_intensity_reading);
  void add(uint32_t batch, const GoniometerTally& tally);
  GoniometerReading read(uint32_t iterations, double emitted_lm) const;
  // Of each node that stands for itself: bound / max(I, 5 % of the peak). False where it is not known yet.
  bool relative_errors(uint32_t iterations, std::vector<double>& out) const;
  // Noise of a node's intensity, 95 %, relative, in the mean over the light: what more iterations lessen, as they do
  // not lessen blur. Nodes without light do not count. 0 where no light was found; < 0: not known yet.
  double mean_noise(uint32_t iterations) const;
  // What of the light, beyond noise, has not the symmetry that the goniometer was told, in words; empty: nothing.
  std::string asymmetry(uint32_t iterations) const;

 private:
  ups_intensity_reading read_node(uint32_t node, uint32_t iterations) const;

  const Goniometer& goniometer_;
  std::vector<double> wide_, narrow_;  // batch_count a node
  double flux_[batch_count] = {}, outside_ = 0, moments_[4][batch_count] = {};
};

}  // namespace ups
