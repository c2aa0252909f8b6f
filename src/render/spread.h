// Mean, standard error and error bound from interleaved batches, and quantiles of relative errors. Used by the
// accumulator's parts.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "transport/integrator.h"

namespace ups {

// Fewer replicates say too little about an error.
inline constexpr uint32_t min_batches = 4;
// Of its set's mean, of the peak: the floor of a relative error's denominator.
inline constexpr double share_of_mean = 0.05;

// 95 % quantiles of Student's t, of so many batches about as many means as were fitted to them: 2 to 15 degrees of
// freedom. Two-sided.
inline double t_quantile(uint32_t batches, uint32_t means = 1) {
  static constexpr double table[] = {4.303, 3.182, 2.776, 2.571, 2.447, 2.365, 2.306,
                                     2.262, 2.228, 2.201, 2.179, 2.160, 2.145, 2.131};
  return table[std::min<uint32_t>(batches, batch_count) - means - 2];
}

// With an offset, so many standard errors: 95 % of noise lie within |offset| + q s. Far from zero one side alone counts,
// and q is the one-sided quantile. Between, exp(-3 rho) is at most 0.04 above the normal distribution's q.
inline double t_quantile(uint32_t batches, uint32_t means, double offset, double standard_error) {
  static constexpr double one_sided[] = {2.920, 2.353, 2.132, 2.015, 1.943, 1.895, 1.860,
                                         1.833, 1.812, 1.796, 1.782, 1.771, 1.761, 1.753};
  const double one = one_sided[std::min<uint32_t>(batches, batch_count) - means - 2];
  if (!(standard_error > 0)) return one;
  return one + (t_quantile(batches, means) - one) * std::exp(-3 * std::abs(offset) / standard_error);
}

inline uint32_t visits_of_batch(uint32_t visits, uint32_t batch) {
  return visits / batch_count + (batch < visits % batch_count);
}

// Deviations that chance alone makes of one of many as seldom as it makes `of_few` of one of 25: a normal number's tail
// falls as exp(-z^2 / 2).
inline double deviations_among(size_t count, double of_few) {
  return std::sqrt(of_few * of_few + 2 * std::log(std::max(1.0, double(count) / 25)));
}
// Of Student's t for 16 batches, which is as rare as z of a normal number (Wallace 1959).
inline double deviations_by_batches(double z) {
  constexpr double nu = batch_count - 1, scale = (8 * nu + 3) / (8 * nu + 1);
  return std::sqrt(nu * std::expm1(z * scale * z * scale / nu));
}

struct Spread {
  double mean = 0, standard_error = -1;  // -1: not known
};
// Of batch sums with counts that differ by one at the most.
template <class T>
Spread spread(const T* sums, uint32_t samples) {
  const uint32_t used = std::min(samples, batch_count);
  Spread s;
  double total = 0;
  for (uint32_t b = 0; b < used; ++b) total += sums[b];
  s.mean = samples ? total / samples : 0;
  if (used < min_batches) return s;
  double square = 0;
  for (uint32_t b = 0; b < used; ++b) {
    const double n = visits_of_batch(samples, b);
    const double d = sums[b] / n - s.mean;
    square += n * d * d;
  }
  s.standard_error = std::sqrt(square / (double(samples) * (used - 1)));
  return s;
}

// Even and odd batches about a mean each: where both are biased by another amount, their difference is no noise.
inline Spread spread_of_halves(const double* sums, uint32_t samples) {
  Spread s = spread(sums, samples);
  if (s.standard_error < 0) return s;
  const uint32_t used = std::min(samples, batch_count);
  double variance = 0;
  for (uint32_t half = 0; half < 2; ++half) {
    double n = 0, mean = 0, square = 0, count = 0;
    for (uint32_t b = half; b < used; b += 2, ++count) n += visits_of_batch(samples, b), mean += sums[b];
    mean /= n;
    for (uint32_t b = half; b < used; b += 2) {
      const double of_batch = visits_of_batch(samples, b), d = sums[b] / of_batch - mean;
      square += of_batch * d * d;
    }
    variance += n / samples * n / samples * square / (n * (count - 1));
  }
  s.standard_error = std::sqrt(variance);
  return s;
}

// Standard error of the mean of batches, value(b) each, about the mean of each of `means` interleaved parts of them: s^2
// of so many less `means` degrees.
template <class Value>
double error_of_mean(uint32_t used, uint32_t means, const Value& value) {
  double square = 0;
  for (uint32_t part = 0; part < means; ++part) {
    double sum = 0, count = 0;
    for (uint32_t b = part; b < used; b += means) sum += value(b), ++count;
    for (uint32_t b = part; b < used; b += means) square += std::pow(value(b) - sum / count, 2);
  }
  return std::sqrt(square / (double(used) * (used - means)));
}

// |b| + t sqrt(s^2 + s_b^2): the two are uncorrelated, as the bias estimate's kernel is orthogonal to the value's.
// means: see t_quantile. -1: not known.
inline float error_bound(const Spread& value, const Spread& bias, uint32_t samples, uint32_t means = 1) {
  if (value.standard_error < 0) return -1;
  const double noise = std::hypot(value.standard_error, bias.standard_error);
  return float(std::abs(bias.mean) + t_quantile(samples, means) * noise);
}

// The value at a share q of the values, which are put in another order.
inline double quantile(std::vector<double>& v, double q) {
  const size_t i = std::min(v.size() - 1, size_t(q * double(v.size())));
  std::nth_element(v.begin(), v.begin() + ptrdiff_t(i), v.end());
  return v[i];
}

}  // namespace ups
