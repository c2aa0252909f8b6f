// Signs that the spread of 16 batches says too little about the error: rare light that is bright.
#pragma once
#include "render/spread.h"

namespace ups {

// m4 / m2^2 of batch sums. 16 values reach 14.1 at most, where all but one are equal; of Gaussian ones 0.1 % are above
// 7.1 (the 6 of long series: 0.4 %).
inline constexpr double largest_kurtosis = 7.1;

template <class T>
double batch_kurtosis(const T* sums, uint32_t samples) {
  if (samples < batch_count) return 0;
  const double mean = spread(sums, samples).mean;
  double m2 = 0, m4 = 0;
  for (uint32_t b = 0; b < batch_count; ++b) {
    const double n = visits_of_batch(samples, b), d2 = n * std::pow(sums[b] / n - mean, 2);
    m2 += d2 / batch_count;
    m4 += d2 * d2 / batch_count;
  }
  return m2 > 0 ? m4 / (m2 * m2) : 0;
}

// Logarithm of the ratio of the deviations that even and odd batches have among themselves; 0: not known.
inline double log_ratio_of_halves(const double* sums, uint32_t samples) {
  if (samples < batch_count) return 0;
  double square[2] = {};
  for (uint32_t half = 0; half < 2; ++half) {
    double sum = 0, visits = 0;
    for (uint32_t b = half; b < batch_count; b += 2) sum += sums[b], visits += visits_of_batch(samples, b);
    for (uint32_t b = half; b < batch_count; b += 2) {
      const double n = visits_of_batch(samples, b);
      square[half] += n * std::pow(sums[b] / n - sum / visits, 2);
    }
  }
  return square[0] > 0 && square[1] > 0 ? 0.5 * std::log(square[0] / square[1]) : 0;
}

// One of so many paths brought more than a tenth of its batch, and without it the reading would be another by more than
// half of its standard error: it makes a quarter of the variance. Of few paths one always brings much: then it must
// stand out by six of their standard deviations, which one of Gaussian values does not.
inline bool single_path_dominates(double largest, uint32_t paths, double mean, double batch, double standard_error,
                                  uint32_t samples) {
  if (paths == 0) return false;
  const double above = (largest - mean * samples / paths) / samples;
  return largest > 0.1 * batch && above > standard_error * std::max(0.5, 6 / std::sqrt(double(paths)));
}

}  // namespace ups
