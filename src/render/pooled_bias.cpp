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
bool alike(const OwnBias& a, const OwnBias& b) {
  return b.mean_radius2 <= 2.1 * a.mean_radius2 && a.mean_radius2 <= 2.1 * b.mean_radius2;
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

std::vector<NeighbourCurvature> neighbour_curvatures(const std::vector<OwnBias>& meters) {
  std::vector<NeighbourCurvature> out(meters.size());
  std::vector<Curvature> group;
  const auto tells = [](const OwnBias& m) { return m.bias.standard_error > 0 && m.lx > 0; };
  for (size_t m = 0; m < meters.size(); ++m) {
    if (!tells(meters[m])) continue;
    group.clear();
    for (size_t j = m - std::min(m, reach), end = std::min(meters.size(), m + reach + 1); j < end; ++j) {
      const OwnBias& n = meters[j];
      if (!tells(n) || !alike(meters[m], n)) continue;
      const double error = n.bias.standard_error / n.scale();
      group.push_back({n.bias.mean / n.scale(), error * error});
    }
    if (group.size() > least_neighbours) out[m] = pool(group);
  }
  return out;
}

Spread pooled_bias(const OwnBias& own, const NeighbourCurvature& neighbours) {
  const auto [mean, error] = own.bias;
  if (!(error > 0) || own.is_beyond_doubt()) return own.bias;
  const double share = neighbours.share_of_own(own.scale(), error * error), told = (1 - share) * own.scale();
  return {share * mean + told * neighbours.mean,
          std::sqrt(share * error * error + told * told * neighbours.variance_of_mean)};
}

}  // namespace ups
