// See pooled_bias.h. Empirical Bayes: the curvatures of neighbours, bias over mean squared radius, scatter about their
// mean by their noise and by what they really differ in (DerSimonian and Laird, Meta-analysis in clinical trials, 1986,
// eq. 8), whose variance says how much of its own estimate a meter keeps.
#include "render/pooled_bias.h"

#include <algorithm>
#include <cmath>

namespace ups {

namespace {

constexpr size_t reach = 8, least_neighbours = 4;  // on either side; without the meter itself

struct Curvature {
  double value, variance;  // lx/m2, of a disc's mean; (lx/m2)^2
};

// Of meters with discs of similar size: a disc is narrow where light is not like its neighbours'.
bool alike(const MeterRings::Photons& a, const MeterRings::Photons& b) {
  return b.bias_error > 0 && b.mean_radius2 <= 2.1 * a.mean_radius2 && a.mean_radius2 <= 2.1 * b.mean_radius2;
}

Curvature curvature_of(const MeterRings::Photons& p) {
  const double error = p.bias_error / p.mean_radius2;
  return {p.bias / p.mean_radius2, error * error};
}

// Mean and variance between meters.
struct Pool {
  double mean = 0, variance_of_mean = 0, between = 0;
};
Pool pool(const std::vector<Curvature>& all) {
  double w = 0, w2 = 0, sum = 0, q = 0;
  for (const Curvature& c : all) w += 1 / c.variance, w2 += 1 / (c.variance * c.variance), sum += c.value / c.variance;
  for (const Curvature& c : all) q += (c.value - sum / w) * (c.value - sum / w) / c.variance;
  Pool p;
  p.between = std::max(0.0, (q - double(all.size() - 1)) / (w - w2 / w));
  w = sum = 0;
  for (const Curvature& c : all) w += 1 / (c.variance + p.between), sum += c.value / (c.variance + p.between);
  p.mean = sum / w, p.variance_of_mean = 1 / w;
  return p;
}

}  // namespace

void pool_bias(std::vector<MeterLight>& lights) {
  std::vector<Spread> pooled(lights.size());
  std::vector<Curvature> group;
  for (size_t m = 0; m < lights.size(); ++m) {
    const MeterRings::Photons& p = lights[m].photons;
    pooled[m] = {p.bias, p.bias_error};
    if (!(p.bias_error > 0) || p.has_bias()) continue;
    group.clear();
    for (size_t j = m - std::min(m, reach), end = std::min(lights.size(), m + reach + 1); j < end; ++j)
      if (alike(p, lights[j].photons)) group.push_back(curvature_of(lights[j].photons));
    if (group.size() <= least_neighbours) continue;
    const Pool of_group = pool(group);
    const Curvature c = curvature_of(p);
    const double share = of_group.between / (of_group.between + c.variance),  // what it keeps of its own
        variance = share * c.variance + (1 - share) * (1 - share) * of_group.variance_of_mean;
    pooled[m] = {p.mean_radius2 * (share * c.value + (1 - share) * of_group.mean),
                 p.mean_radius2 * std::sqrt(variance)};
  }
  for (size_t m = 0; m < lights.size(); ++m)
    lights[m].photons.bias = pooled[m].mean, lights[m].photons.bias_error = pooled[m].standard_error;
}

}  // namespace ups
