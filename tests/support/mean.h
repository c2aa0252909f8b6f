// The mean of independent values, with its standard error.
#pragma once
#include <cmath>
#include <numeric>
#include <vector>

namespace ups::test {

struct Mean {
  double value = 0, standard_error = 0;
};

inline Mean mean_of(const std::vector<double>& values) {
  const double n = double(values.size());
  Mean m{std::accumulate(values.begin(), values.end(), 0.0) / n};
  for (double v : values) m.standard_error += (v - m.value) * (v - m.value);
  m.standard_error = std::sqrt(m.standard_error / (n - 1) / n);
  return m;
}

}  // namespace ups::test
