// See intervals.h.
#include "report/intervals.h"

#include <algorithm>
#include <cmath>

namespace ups::report {
namespace {

constexpr double pi = 3.14159265358979323846;

// How much of Student's distribution lies within -t to t (Abramowitz, Stegun 26.7.3 and 26.7.4).
double share_within(double t, uint32_t freedom) {
  const double angle = std::atan(t / std::sqrt(double(freedom))), c = std::cos(angle);
  const bool odd = freedom % 2 == 1;
  double sum = 0, term = odd ? c : 1;
  for (uint32_t power = odd ? 1 : 0; power + 2 <= freedom; power += 2) {
    sum += term;
    term *= c * c * double(power + 1) / double(power + 2);
  }
  sum *= std::sin(angle);
  return odd ? 2 / pi * (angle + sum) : sum;
}

// 1 - outside of the distribution lies within -t to t.
double quantile(double outside, uint32_t freedom) {
  double low = 0, high = 1e6;
  while (high - low > 1e-9 * high) {
    const double middle = 0.5 * (low + high);
    (share_within(middle, freedom) < 1 - outside ? low : high) = middle;
  }
  return high;
}

constexpr double outside = 0.05;

uint32_t freedom_of(uint32_t iterations) {
  constexpr uint32_t fewest = 4, most = 16;  // batches; of fewer no error is known
  return std::clamp(iterations, fewest, most) - 1;
}

// So much wider are intervals of which all `count` hold together as often as one of them does alone (Bonferroni).
double widening(size_t count, uint32_t iterations) {
  const uint32_t freedom = freedom_of(iterations);
  return quantile(outside / double(count), freedom) / quantile(outside, freedom);
}

bool is_unknown(const ups_interval& i) { return i.low < 0 || i.high < 0; }

}  // namespace

double noise_bound(double standard_error, uint32_t iterations) {
  return standard_error < 0 ? -1 : quantile(outside, freedom_of(iterations)) * standard_error;
}

// The least true value is above the least low end unless the interval of that very value fails: one of 95 %. It is below
// the least high end unless some interval fails, whichever: those must hold together.
ups_interval least_of(const std::vector<ups_interval>& values, uint32_t iterations) {
  if (values.empty()) return {-1, -1, -1};
  const double wider = widening(values.size(), iterations);
  ups_interval least = values[0];
  least.high = INFINITY;
  for (const ups_interval& i : values) {
    least.value = std::min(least.value, i.value);
    least.low = std::min(least.low, i.low);
    least.high = std::min(least.high, i.value + wider * (i.high - i.value));
  }
  if (std::any_of(values.begin(), values.end(), is_unknown)) least.low = least.high = -1;
  return least;
}

// The same from the other side.
ups_interval greatest_of(const std::vector<ups_interval>& values, uint32_t iterations) {
  if (values.empty()) return {-1, -1, -1};
  const double wider = widening(values.size(), iterations);
  ups_interval greatest = values[0];
  greatest.low = 0;
  for (const ups_interval& i : values) {
    greatest.value = std::max(greatest.value, i.value);
    greatest.low = std::max(greatest.low, i.value - wider * (i.value - i.low));
    greatest.high = std::max(greatest.high, i.high);
  }
  if (std::any_of(values.begin(), values.end(), is_unknown)) greatest.low = greatest.high = -1;
  return greatest;
}

}  // namespace ups::report
