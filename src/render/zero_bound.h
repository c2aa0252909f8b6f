// What can be said of light that few paths have found, or none: no spread of batches knows its error. The rule of three
// and its continuation: after k events the mean of a Poisson distribution is below k + excess(k), 95 %.
#pragma once
#include <bit>
#include <iterator>

#include "render/spread.h"

namespace ups {

// Upper 95 % limit of a Poisson mean after k events, less k: half the quantile of chi-square of 2 k + 2 degrees of
// freedom (Garwood 1936), by Byar's approximation from k = 8 on (Breslow, Day 1987, Eq. 2.13), there within 0.01.
// Between whole numbers, which a prediction asks for, on straight lines.
inline double poisson_excess(double k) {
  static constexpr double table[] = {3.00, 3.74, 4.30, 4.75, 5.15, 5.51, 5.84, 6.15, 6.43};
  constexpr size_t last = std::size(table) - 1;
  if (k < double(last)) {
    const size_t i = size_t(k);
    return table[i] + (k - double(i)) * (table[i + 1] - table[i]);
  }
  const double n = k + 1;
  return n * std::pow(1 - 1 / (9 * n) + 1.6449 / (3 * std::sqrt(n)), 3) - k;
}

// Of a Poisson number that has this mean: the square of the standard deviations at which a normal number is as rare, to one
// side. Its deviance (McCullagh, Nelder 1989, Generalized Linear Models, 2.3), from half an event nearer, as events are
// whole: none of 6.9 are as rare as 3.1 deviations, where its root is 3.2, and 8 of 0.5 as 5.3, where it is 5.2.
inline double poisson_deviance(double events, double mean) {
  const double n = events < mean ? std::min(events + 0.5, mean) : std::max(events - 0.5, mean);
  return n > 0 ? 2 * (n * std::log(n / mean) - n + mean) : 0;
}

// Light of a reading that came by chance.
struct ChanceLight {
  uint32_t paths = 0, batches = 0;  // that contributed
  double largest_batch = 0;         // sum of a batch

  bool is_enough(uint32_t samples) const {  // for the spread of batches to be an error
    return batches >= std::min({samples, batch_count, batch_count / 2});
  }
  // 95 %, of the mean of so many samples. largest: that one path may bring to a sample. Paths that come together are
  // one event: so are those of a batch.
  double bound(double largest, uint32_t samples) const {
    return std::max(largest * poisson_excess(paths), largest_batch * poisson_excess(batches)) / samples;
  }
};

// Batches are all there is to count by.
template <class T>
ChanceLight chance_light(const T* sums, uint32_t samples) {
  ChanceLight c;
  for (uint32_t b = 0; b < std::min(samples, batch_count); ++b)
    if (const double sum = double(sums[b]); sum > 0) {
      ++c.batches;
      c.largest_batch = std::max(c.largest_batch, sum);
    }
  c.paths = c.batches;
  return c;
}

}  // namespace ups
