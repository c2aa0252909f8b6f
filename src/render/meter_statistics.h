// What can be said of a set of meters as a whole: its mean, extremes, uniformity and fifth percentile, with 95 %
// intervals. Meters share light paths, so aggregates have batches of their own. Called by the accumulator.
#pragma once
#include <span>
#include <vector>

#include "render/meter_rings.h"
#include "render/spread.h"
#include "ups/ups_render.h"

namespace ups {

// The meters of a set that were visited; each batch counts as its mean.
class MeterBatches {
 public:
  // discs_that_meet: how many meters have photons in common, at most.
  explicit MeterBatches(uint32_t used = 0, uint32_t discs_that_meet = 1) : used_(used), meet_(discs_that_meet) {}
  struct Meter {
    double value;
    Spread bias;
    double unfound;  // bound on light that few paths have found, and rounding
    double weight = 1;  // in the mean and in percentiles: an area, or all alike
    bool known = true;  // the batches know the error of all other light
    bool halves_differ = false;  // even and odd batches have a bias of their own each
    double choice_variance = 0;  // that the batches do not show, of the choice of its disc
    NarrowLight caustic;         // in the mean; what it adds to the meter's own error is in `unfound`
    double unfound_in_mean = -1;  // without it, and where all meters together leave less open than each; < 0: the same
  };
  // Means of `used` batches each.
  void add(const Meter& meter, const double* batch, const double* bias_batch);
  // Of the one added last: its own bound, which knows more than its batches do, is not undercut. < 0: it has none.
  void widen(double bound);

  static constexpr double bytes_per_meter = batch_count * sizeof(float) + sizeof(Meter) + sizeof(float);

  size_t count() const { return meters_.size(); }
  uint32_t used() const { return used_; }
  uint32_t means() const { return means_; }  // that batches are about: 2 where some meter's halves differ
  double value(size_t m) const { return meters_[m].value; }
  double weight(size_t m) const { return meters_[m].weight; }
  bool known(size_t m) const { return meters_[m].known; }
  float batch(size_t m, uint32_t b) const { return batches_[m * used_ + b]; }
  double standard_error(size_t m) const;
  // 95 %, noise where it is known, bias, and what is unfound.
  double bound(size_t m) const;
  // Bias and what is unfound, without noise: magnitude, and the bias's standard error.
  double offset(size_t m) const { return std::abs(meters_[m].bias.mean) + unfound(m); }
  double bias(size_t m) const { return meters_[m].bias.mean; }
  double bias_error(size_t m) const { return std::max(0.0, meters_[m].bias.standard_error); }
  double unfound(size_t m) const { return meters_[m].unfound + double(widened_[m]); }

  double mean() const;
  double unfound() const;          // of the mean
  NarrowLight caustic() const;     // of the mean, not in unfound(): chance is independent where discs do not meet
  double choice_variance() const;  // of the mean
  double stated_bound() const { return stated_; }  // of the one added last; < 0: it has none
  double told_bias() const;  // of the mean, as neighbours and profiles tell it of each
  double mean_of_batch(uint32_t b) const;
  double bias_of_batch(uint32_t b) const { return bias_sums_[b] / weights_; }  // of the mean
  // Of value / mean, by the batches of both together.
  MeterBatches over_mean() const;
  MeterBatches negative() const;
  // Each by its offset, down or up: sign -1 or 1. What few paths found has no noise then, only that end.
  MeterBatches moved(double sign) const;

 private:
  uint32_t used_, meet_, means_ = 1;
  std::vector<Meter> meters_;
  std::vector<float> batches_, widened_;
  double bias_sums_[batch_count] = {};
  double weights_ = 0, stated_ = -1;
};

struct Interval {
  double low = -1, high = -1;
};
inline constexpr uint32_t min_batches_of_interval = 6;
// 95 %, of the least true value.
Interval minimum_interval(const MeterBatches& meters);

// By value, or by whatever stands for it.
struct MeterOrder {
  std::vector<uint32_t> meters;  // ascending
  std::vector<double> up_to;     // by rank, the weight of it and those before
  MeterOrder() = default;
  MeterOrder(const MeterBatches& of, const std::vector<double>& values);
  explicit MeterOrder(const MeterBatches& of);
  double up_to_rank(size_t rank) const { return rank > 0 ? up_to[rank - 1] : 0; }
  size_t rank_above(double weight) const;
  // That this share of the weight is below.
  size_t rank_at(double share) const { return rank_above(share * up_to.back()); }
  std::span<const uint32_t> between(double begin, double end) const;
};

// The true values in ascending order, of which noise hides who is where: the lower half of them. Of meters without
// offsets (`MeterBatches::moved`).
class LowerRanks {
 public:
  explicit LowerRanks(MeterBatches of);
  size_t count() const { return meters_.count(); }
  uint32_t used() const { return meters_.used(); }
  double value(size_t rank) const { return meters_.value(all_.meters[rank]); }
  size_t rank_at(double share) const { return all_.rank_at(share); }
  double share_from(size_t rank) const { return 1 - all_.up_to_rank(rank) / all_.up_to.back(); }  // of the weight
  Interval interval(size_t rank) const;  // 95 %; of the upper half the negative meters' ranks tell more

 private:
  double noise_at(size_t rank) const;
  Interval interval_at(size_t rank) const;

  MeterBatches meters_;
  MeterOrder all_, by_half_[2];  // by all batches, by the even and by the odd ones
};

struct Known {
  double value;
  Interval interval;  // 95 %
};
// The value that this share of the weight is below: of one meter at the least.
Known percentile(const MeterBatches& meters, double share);
// Of the true values at least as large as the threshold: their share by weight.
Known share_above(const MeterBatches& meters, double threshold);

// All but the relative errors, of so many passes. known: the spread of the mean's batches is its error.
ups_meter_statistics meter_statistics(const MeterBatches& meters, uint32_t passes, bool known);

}  // namespace ups
