// Discrete and piecewise-constant distributions by cumulative sums, in double so that large tables stay exact.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ups {

class DiscreteDistribution {
 public:
  DiscreteDistribution() = default;
  explicit DiscreteDistribution(const std::vector<double>& weights) : cdf_(weights.size() + 1, 0.0) {
    for (size_t i = 0; i < weights.size(); ++i) cdf_[i + 1] = cdf_[i] + std::max(0.0, weights[i]);
    total_ = cdf_.back();
    if (total_ > 0)
      for (double& c : cdf_) c /= total_;
  }
  size_t size() const { return cdf_.empty() ? 0 : cdf_.size() - 1; }
  double total() const { return total_; }
  size_t bytes() const { return cdf_.capacity() * sizeof(double); }
  float probability(size_t i) const { return float(cdf_[i + 1] - cdf_[i]); }

  struct Sample {
    size_t index;
    float probability;
    float u;  // the number again uniform in [0, 1), so that stratification is kept
  };
  Sample sample(double u) const {
    auto it = std::upper_bound(cdf_.begin(), cdf_.end(), u);
    size_t i = std::min<size_t>(size() - 1, size_t(std::max<ptrdiff_t>(0, it - cdf_.begin() - 1)));
    while (i > 0 && cdf_[i + 1] == cdf_[i]) --i;  // never a zero entry
    const double p = cdf_[i + 1] - cdf_[i];
    const float rest = p > 0 ? float((u - cdf_[i]) / p) : 0.0f;
    return {i, float(p), std::clamp(rest, 0.0f, 0x1.fffffep-1f)};
  }

 private:
  std::vector<double> cdf_;
  double total_ = 0;
};

}  // namespace ups
