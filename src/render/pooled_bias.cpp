// See pooled_bias.h. Empirical Bayes: the curvatures of neighbours, bias over mean squared radius, scatter about their
// mean by their noise and by what they really differ in (DerSimonian and Laird, Meta-analysis in clinical trials, 1986,
// eq. 8), whose variance says how much of its own estimate a meter keeps.
#include "render/pooled_bias.h"

#include <algorithm>
#include <cmath>

namespace ups {

namespace {

constexpr size_t reach = 16, least_neighbours = 4;  // on either side; without the meter itself
constexpr uint32_t quarter = 4, narrower = 2, most_narrow = 8;  // rings: to a quarter of a radius; steps down to a 16th
constexpr double rounding = 1e-9;  // of a reading: a few photons' bias that varies by less is zero, and tells nothing
constexpr double certain = 2.5;  // standard deviations, of one of several estimates that are looked at, of few meters

struct Estimate {
  double value = 0, variance = 0;
};
struct Pooled {
  double mean, variance_of_mean, between;
};

// Of meters that took similar shares of their discs: a disc that is chosen narrow is so as light is not like its
// neighbours', one that walls leave narrow is not.
bool alike(const OwnBias& a, const OwnBias& b) {
  const auto share = [](const OwnBias& m) { return m.widest_scale > 0 ? m.bias_scale / m.widest_scale : m.bias_scale; };
  return share(b) <= 2.1 * share(a) && share(a) <= 2.1 * share(b);
}

StepBias mean_of(const std::array<StepBias, 2>& halves) {
  const auto& [a, b] = halves;
  return {0.5 * (a.mean + b.mean), 0.5 * (a.own_variance + b.own_variance), 0.5 * (a.told_variance + b.told_variance)};
}

// between: so many standard deviations of chance, of the chi-square that tells of it, more than estimated.
Pooled pool(const std::vector<Estimate>& all, double more) {
  // pairs: w^2 less the squares' sum, over 2, without the difference: a meter whose photons cancel to rounding
  // outweighs all others by so much that nothing would be left of it.
  double w = 0, pairs = 0, sum = 0, q = 0;
  for (const Estimate& e : all) pairs += w / e.variance, w += 1 / e.variance, sum += e.value / e.variance;
  for (const Estimate& e : all) q += (e.value - sum / w) * (e.value - sum / w) / e.variance;
  const double dof = double(all.size() - 1),
               between = std::max(0.0, (q - dof + more * std::sqrt(2 * dof)) / (2 * pairs / w));
  w = sum = 0;
  for (const Estimate& e : all) w += 1 / (e.variance + between), sum += e.value / (e.variance + between);
  return {sum / w, 1 / w, between};
}

}  // namespace

std::vector<NeighbourCurvature> neighbour_curvatures(const std::vector<OwnBias>& meters) {
  std::vector<NeighbourCurvature> out(meters.size());
  std::vector<Estimate> group;
  const auto tells = [](const OwnBias& m) { return m.lx > 0 && m.bias.standard_error > rounding * m.lx; };
  for (size_t m = 0; m < meters.size(); ++m) {
    if (!tells(meters[m])) continue;
    group.clear();
    for (size_t j = m - std::min(m, reach), end = std::min(meters.size(), m + reach + 1); j < end; ++j) {
      const OwnBias& n = meters[j];
      if (!tells(n) || !alike(meters[m], n)) continue;
      const double error = n.bias.standard_error / n.scale();
      group.push_back({n.bias.mean / n.scale(), error * error});
    }
    // Taken for alike, meters would know too much.
    if (group.size() <= least_neighbours) continue;
    const Pooled p = pool(group, 1);
    out[m] = {p.mean, p.variance_of_mean, p.between};
  }
  return out;
}

Spread pooled_bias(const OwnBias& own, const NeighbourCurvature& neighbours, size_t meters) {
  const auto [mean, error] = own.bias;
  if (!(error > 0) || own.is_beyond_doubt(meters)) return own.bias;
  const double share = neighbours.share_of_own(own.scale(), error * error), told = (1 - share) * own.scale();
  return {share * mean + told * neighbours.mean,
          std::sqrt(share * error * error + told * told * neighbours.variance_of_mean)};
}

NeighbourProfiles::NeighbourProfiles(std::vector<RingProfile> meters)
    : meters_(std::move(meters)), certain_(deviations_among(meters_.size(), certain)) {}

bool NeighbourProfiles::tell(size_t m) const { return meters_.size() > least_neighbours && meters_[m].lx > 0; }

// Of an estimate of each meter, by its profile and by how many rings further in a disc of that size ends there; without
// a variance where it has none. alone: where too few tell. Where meters differ, each may be biased by as much, which
// narrows its disc and widens its bound: chance must not do that, so it is taken for less than estimated; all the more
// where discs are chosen, as one of several that chance lets seem biased is enough to take another.
template <class Of>
StepBias NeighbourProfiles::together(size_t m, const RingProfile& own, double sure, const StepBias& alone,
                                     const Of& estimate) const {
  const Estimate e = estimate(own, 0);
  if (!(e.variance > 0)) return {};
  std::vector<Estimate> group;
  group.reserve(2 * reach + 1);
  for (size_t j = m - std::min(m, reach), end = std::min(meters_.size(), m + reach + 1); j < end; ++j) {
    const RingProfile& n = j == m ? own : meters_[j];  // a half must not be told of the other by itself
    if (!(n.lx > 0)) continue;
    const int shift = n.radius2 == own.radius2 ? 0 : int(std::lround(std::log2(n.radius2 / own.radius2)));
    if (const Estimate of = estimate(n, uint32_t(shift)); of.variance > 0) group.push_back(of);
  }
  if (group.size() <= least_neighbours) return alone;
  const Pooled p = pool(group, -sure);
  const double share = p.between / (p.between + e.variance), told = 1 - share;
  return {share * e.value + told * p.mean, share * e.variance, told * told * p.variance_of_mean};
}

StepBias NeighbourProfiles::bias_from(size_t m, const RingProfile& own, uint32_t from, uint32_t ring,
                                      double sure) const {
  return together(m, own, sure, {}, [=](const RingProfile& p, uint32_t shift) {
    const uint32_t a = from - shift, b = ring - shift;
    return p.has(a, b) ? Estimate{p.step(a, b), p.step_variance(a, b)} : Estimate{};
  });
}

// From the disc of a quarter of the radius, which holds most of the bias of any light; from narrower ones where these
// show beyond doubt more than it may be.
StepBias NeighbourProfiles::bias(size_t m, const RingProfile& own, uint32_t ring, double sure) const {
  if (!tell(m) || ring < quarter) return {};
  StepBias found = bias_from(m, own, ring - quarter, ring, sure);
  const auto surely = [](const StepBias& b, double errors) {
    return std::abs(b.mean) - errors * std::sqrt(b.variance());
  };
  for (uint32_t down = quarter + narrower; down <= std::min(most_narrow, ring); down += narrower) {
    const StepBias b = bias_from(m, own, ring - down, ring, sure);
    if (surely(b, certain_) > std::max(0.0, surely(found, 2))) found = b;
  }
  return found;
}

// Of a caustic: few photons do not tell an edge from a slope by that fit, and caustics have edges. One at the meter makes
// their mean direction 2/pi long, one at half a radius 0.21, and takes a fourth of what is read. A slope biases little and
// makes it a third of what it changes over the radius, 1/3 at most: what is short counts less. Many photons do tell.
double NeighbourProfiles::caustic_lean(const RingProfile& p, uint32_t ring) {
  const double one_sided = double(p.one_sided[ring]),
               edge = one_sided * std::min(1.0, std::pow(4 * one_sided, 3)) * double(p.mean[ring]),
               fit = std::hypot(double(p.lean_s[ring]), double(p.lean_t[ring])),
               noise = std::sqrt(2 * RingProfile::lean_noise * double(p.variance[ring]));
  return std::min(edge, fit + 2 * noise);
}

// A step beside the meter leans by 1/pi of its height, and half of its height is the bias. On which side the meter is
// does not show. Within a wide disc several steps may be like a slope: then a narrower one shows the nearest.
double NeighbourProfiles::bias_by_edge(size_t m, uint32_t ring) const {
  double square = 0, sure = 0;
  for (uint32_t down = 0; down <= std::min(quarter, ring); down += narrower) {
    StepBias lean[2];
    for (const bool t : {false, true}) {
      const auto estimate = [=](const RingProfile& p, uint32_t shift) {
        const uint32_t k = ring - down - shift;
        if (k <= p.narrowest || k >= max_rings) return Estimate{};
        return Estimate{double(t ? p.lean_t[k] : p.lean_s[k]), RingProfile::lean_noise * double(p.variance[k])};
      };
      const Estimate own = estimate(meters_[m], 0);
      lean[t] = together(m, meters_[m], to_state, {own.value, own.variance, 0}, estimate);
    }
    const double variance = lean[0].variance() + lean[1].variance(),
                 length2 = lean[0].mean * lean[0].mean + lean[1].mean * lean[1].mean,
                 surely = std::sqrt(length2) - certain_ * std::sqrt(variance);
    if (surely > sure) sure = surely, square = length2 - variance;
  }
  return 0.5 * pi_d * std::max(std::sqrt(square), caustic_lean(meters_[m], ring));
}

double NeighbourProfiles::edge(size_t m, const MeterRings::Choice& discs) const {
  return std::hypot(bias_by_edge(m, discs[0]), bias_by_edge(m, discs[1])) / std::sqrt(2.0) * meters_[m].lx;
}

std::array<StepBias, 2> NeighbourProfiles::stated(size_t m, const MeterRings::Choice& discs) const {
  return {bias(m, meters_[m], discs[0], to_state), bias(m, meters_[m], discs[1], to_state)};
}

// One meter in a few hundred takes a narrow disc by chance. Its few photons know little of how light goes on within it;
// the neighbours, who took wide ones, have photons on discs of that size, too. A meter that differs from them is seldom
// told from one that does not: so it may, by twice what they leave open, and keeps its own where that is far off.
Spread NeighbourProfiles::instead_of(const Spread& own, size_t m, const MeterRings::Choice& discs) const {
  const double lx = meters_[m].lx;
  if (!(lx > 0)) return own;
  const std::array<StepBias, 2> halves = stated(m, discs);
  if (!(halves[0].variance() > 0) || !(halves[1].variance() > 0)) return own;
  const StepBias steps = mean_of(halves);
  const double told = steps.variance() * lx * lx, of_own = own.standard_error * own.standard_error,
               apart = own.mean - steps.mean * lx;
  if (apart * apart > 4 * (told + of_own)) return own;
  const double share = 4 * told / (4 * told + of_own);
  return {share * own.mean + (1 - share) * steps.mean * lx, std::sqrt(share * of_own)};
}

// What the meter may differ from its neighbours in stands for twice its standard error, 95 %: a bound counts it once.
// Profiles are of what lands on the disc alone: a bias beyond doubt, which holds what eye paths merge farther on, stays
// where they show less.
Spread NeighbourProfiles::added_to(const Spread& bias, size_t m, const MeterRings::Choice& discs, double edge) const {
  const RingProfile& own = meters_[m];
  if (!(own.lx > 0)) return bias;
  const StepBias both = mean_of(stated(m, discs));
  const bool more = std::abs(bias.mean) > std::max(2 * bias.standard_error, std::abs(both.mean) * own.lx);
  if (both.is_beyond(2) && !more)
    return {both.mean * own.lx, std::max(std::sqrt(both.variance()) * own.lx, edge)};
  return {bias.mean, std::max({bias.standard_error, 2 * std::sqrt(both.own_variance) * own.lx, edge})};
}

}  // namespace ups
