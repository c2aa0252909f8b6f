// See pooled_bias.h. Empirical Bayes: the curvatures of neighbours, bias over mean squared radius, scatter about their
// mean by their noise and by what they really differ in (DerSimonian and Laird, Meta-analysis in clinical trials, 1986,
// eq. 8), whose variance says how much of its own estimate a meter keeps.
#include "render/pooled_bias.h"

#include <algorithm>
#include <cmath>

namespace ups {

namespace {

constexpr size_t reach = 16, least_neighbours = 4;  // on either side; without the meter itself

struct Curvature {
  double value, variance;  // 1/m2, its square
};

// Of meters with discs of similar size: a disc is narrow where light is not like its neighbours'.
bool alike(const MeterRings::Photons& a, const MeterRings::Photons& b) {
  return b.bias_error > 0 && b.lx > 0 && b.mean_radius2 <= 2.1 * a.mean_radius2 && a.mean_radius2 <= 2.1 * b.mean_radius2;
}

NeighbourCurvature pool(const std::vector<Curvature>& all) {
  double w = 0, w2 = 0, sum = 0, q = 0;
  for (const Curvature& c : all) w += 1 / c.variance, w2 += 1 / (c.variance * c.variance), sum += c.value / c.variance;
  for (const Curvature& c : all) q += (c.value - sum / w) * (c.value - sum / w) / c.variance;
  // A standard deviation more than estimated, as q has a chi-square's: taken for alike, meters would know too much.
  const double dof = double(all.size() - 1), between = std::max(0.0, (q - dof + std::sqrt(2 * dof)) / (w - w2 / w));
  w = sum = 0;
  for (const Curvature& c : all) w += 1 / (c.variance + between), sum += c.value / (c.variance + between);
  return {sum / w, 1 / w, between};
}

}  // namespace

std::vector<NeighbourCurvature> neighbour_curvatures(const std::vector<MeterRings::Photons>& photons) {
  std::vector<NeighbourCurvature> out(photons.size());
  std::vector<Curvature> group;
  for (size_t m = 0; m < photons.size(); ++m) {
    const MeterRings::Photons& p = photons[m];
    if (!(p.bias_error > 0 && p.lx > 0)) continue;
    group.clear();
    for (size_t j = m - std::min(m, reach), end = std::min(photons.size(), m + reach + 1); j < end; ++j) {
      const MeterRings::Photons& n = photons[j];
      const double scale = n.lx * n.mean_radius2, error = n.bias_error / scale;
      if (alike(p, n)) group.push_back({n.bias / scale, error * error});
    }
    if (group.size() > least_neighbours) out[m] = pool(group);
  }
  return out;
}

void pool_bias(MeterRings::Photons& p, const NeighbourCurvature& neighbours) {
  if (!(p.bias_error > 0) || p.has_bias()) return;
  const double scale = p.lx * p.mean_radius2, variance = p.bias_error * p.bias_error,
               own = neighbours.share_of_own(scale, variance), told = (1 - own) * scale;
  p.bias = own * p.bias + told * neighbours.mean;
  p.bias_error = std::sqrt(own * variance + told * told * neighbours.variance_of_mean);
}

}  // namespace ups
