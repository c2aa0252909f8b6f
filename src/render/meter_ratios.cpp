// See meter_ratios.h. To first order x / y is off by (dx - (x / y) dy) / y, by noise and by bias alike.
#include "render/meter_ratios.h"

namespace ups {
namespace {

struct Quantity {
  double value, batches[batch_count], bias_batches[batch_count], bias, bias_error, unfound;
  double choice_variance = 0;  // of the mean of several, that batches do not show
};

Quantity meter_of(const MeterBatches& meters, size_t m) {
  Quantity q{meters.value(m), {}, {}, meters.bias(m), meters.bias_error(m), meters.unfound(m)};
  for (uint32_t b = 0; b < meters.used(); ++b) q.batches[b] = double(meters.batch(m, b));
  return q;
}

// Of one meter what its own reading says, as its bound has what batches do not tell.
Quantity mean_of(const MeterBatches& meters) {
  if (meters.count() == 1) return meter_of(meters, 0);
  Quantity q{meters.mean(), {}, {}, 0, 0, meters.unfound() + meters.caustic().size(), meters.choice_variance()};
  for (uint32_t b = 0; b < meters.used(); ++b) {
    q.batches[b] = meters.mean_of_batch(b);
    q.bias_batches[b] = meters.bias_of_batch(b);
    q.bias += q.bias_batches[b] / meters.used();
  }
  if (const double told = meters.told_bias(); std::abs(told) > std::abs(q.bias)) q.bias = told;
  return q;
}

// means: that batches are about.
Ratio ratio_of(const Quantity& x, const Quantity& y, uint32_t used, uint32_t means) {
  Ratio r;
  if (!(y.value > 0) || x.value < 0) return r;
  r.value = x.value / y.value;
  if (used < min_batches_of_interval) return r;
  const auto error_of = [&](const double* batches) {
    return error_of_mean(used, means, [&](uint32_t b) { return batches[b]; });
  };
  const double t = t_quantile(used, means),
               y_noise = std::hypot(error_of(y.batches), y.bias_error, std::sqrt(y.choice_variance)),
               y_error = std::abs(y.bias) + y.unfound + t * y_noise;
  if (y_error > 0.5 * y.value) return r;  // first order is not enough
  double noise[batch_count], bias[batch_count];
  for (uint32_t b = 0; b < used; ++b) {
    noise[b] = (x.batches[b] - r.value * y.batches[b]) / y.value;
    bias[b] = (x.bias_batches[b] - r.value * y.bias_batches[b]) / y.value;
  }
  const double s_bias = error_of(bias), own_bias = std::hypot(x.bias_error, r.value * y.bias_error) / y.value,
               offset = (std::abs(x.bias - r.value * y.bias) + x.unfound + r.value * y.unfound) / y.value,
               choice2 = (x.choice_variance + r.value * r.value * y.choice_variance) / (y.value * y.value),
               error = offset + t * std::sqrt(std::pow(error_of(noise), 2) + s_bias * s_bias + own_bias * own_bias +
                                              choice2);
  r.interval = {std::max(0.0, r.value - error), r.value + error};
  return r;
}

}  // namespace

Ratio ratio_of_means(const MeterBatches& numerator, const MeterBatches& denominator) {
  if (numerator.count() == 0 || denominator.count() == 0) return {};
  return ratio_of(mean_of(numerator), mean_of(denominator), std::min(numerator.used(), denominator.used()),
                  std::max(numerator.means(), denominator.means()));
}

Ratio ratio_at(const MeterBatches& numerator, size_t m, const MeterBatches& denominator, size_t n) {
  return ratio_of(meter_of(numerator, m), meter_of(denominator, n),
                  std::min(numerator.used(), denominator.used()), std::max(numerator.means(), denominator.means()));
}

}  // namespace ups
