// What can be said of a set of meters as a whole: its mean, extremes, uniformity and fifth percentile, with 95 %
// intervals. Meters share light paths, so aggregates have batches of their own. Called by the accumulator.
#pragma once
#include <vector>

#include "render/spread.h"
#include "ups/ups_render.h"

namespace ups {

// The meters of a set that were visited; each batch counts as its mean.
class MeterBatches {
 public:
  explicit MeterBatches(uint32_t used) : used_(used) {}
  struct Meter {
    double value;
    Spread bias;
    double unfound;  // bound on light that few paths have found; 0: the batches know the error
    double weight = 1;  // in the mean
  };
  // Means of `used` batches each.
  void add(const Meter& meter, const double* batch, const double* bias_batch);

  static constexpr double bytes_per_meter = 3 * (batch_count * sizeof(float) + sizeof(Meter));  // with two copies

  size_t count() const { return meters_.size(); }
  uint32_t used() const { return used_; }
  double value(size_t m) const { return meters_[m].value; }
  float batch(size_t m, uint32_t b) const { return batches_[m * used_ + b]; }
  double standard_error(size_t m) const;
  // 95 %, noise and bias, or unfound.
  double bound(size_t m) const;
  // Bias and what is unfound, without noise: magnitude, and the bias's standard error.
  double offset(size_t m) const { return std::abs(meters_[m].bias.mean) + meters_[m].unfound; }
  double bias_error(size_t m) const { return std::max(0.0, meters_[m].bias.standard_error); }

  double mean() const;
  double unfound() const;  // of the mean
  double mean_of_batch(uint32_t b) const;
  double bias_of_batch(uint32_t b) const { return bias_sums_[b] / weights_; }  // of the mean
  // Of value / mean, by the batches of both together.
  MeterBatches over_mean() const;
  MeterBatches negative() const;

 private:
  uint32_t used_;
  std::vector<Meter> meters_;
  std::vector<float> batches_;
  double bias_sums_[batch_count] = {};
  double weights_ = 0;
};

struct Interval {
  double low = -1, high = -1;
};
inline constexpr uint32_t min_batches_of_interval = 6;
// 95 %, of the least true value; of the true value at a share of all.
Interval minimum_interval(const MeterBatches& meters);
Interval percentile_interval(const MeterBatches& meters, double share);

// All but the relative errors, of so many passes. known: the spread of the mean's batches is its error.
ups_meter_statistics meter_statistics(const MeterBatches& meters, uint32_t passes, bool known);

}  // namespace ups
