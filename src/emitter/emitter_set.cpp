// Which emitter does a light path start from, and which one does a point look at?
#include "emitter/emitter_set.h"

#include <algorithm>
#include <numeric>

namespace ups {
namespace {

constexpr float least_exposed = 0.01f;  // behind glass, which the probe may have missed a way around
constexpr double least_of_kind = 0.25;  // of the light paths, where there are directional emitters and others

// Of each emitter, the share of light paths by flux, but no less than least_of_kind for a kind together: outdoors the
// sun has thousands of times the lamps' flux, little of which comes in through a window.
std::vector<double> emission_shares(const std::vector<std::shared_ptr<const Emitter>>& emitters,
                                    const std::vector<double>& flux) {
  double of_kind[2] = {};
  for (size_t i = 0; i < flux.size(); ++i) of_kind[emitters[i]->is_directional()] += flux[i];
  if (!(of_kind[0] > 0 && of_kind[1] > 0)) return flux;
  const double far = std::clamp(of_kind[1] / (of_kind[0] + of_kind[1]), least_of_kind, 1 - least_of_kind);
  std::vector<double> share(flux);
  for (size_t i = 0; i < flux.size(); ++i)
    share[i] *= emitters[i]->is_directional() ? far / of_kind[1] : (1 - far) / of_kind[0];
  return share;
}

}  // namespace

EmitterSet::EmitterSet(std::vector<std::shared_ptr<const Emitter>> emitters, const std::vector<float>& exposed)
    : emitters_(std::move(emitters)) {
  std::vector<double> flux;
  std::vector<LightTree::Entry> direct[2];
  for (size_t i = 0; i < emitters_.size(); ++i) {
    const Emitter& e = *emitters_[i];
    flux.push_back(std::max(0.0, e.flux_lm()));
    const float share = exposed.empty() ? 1.0f : std::max(exposed[i], least_exposed);
    kinds_.push_back({e.is_delta(), e.is_directional()});
    have_extent_ = have_extent_ || !e.is_delta();
    if (e.is_direct()) direct[e.is_directional()].push_back({e.outline(), flux.back(), share, uint32_t(i)});
  }
  emission_ = DiscreteDistribution(emission_shares(emitters_, flux));
  flux_lm_ = std::accumulate(flux.begin(), flux.end(), 0.0);
  for (const int far : {0, 1}) {
    direct_[far] = LightTree(direct[far], emitters_.size());
    has_direct_[far] = !direct[far].empty();
  }
}

EmitterSet::Choice EmitterSet::choose_emission(double u) const {
  if (!(emission_.total() > 0)) return {};
  const DiscreteDistribution::Sample s = emission_.sample(u);
  return {uint32_t(s.index), s.probability, s.u};
}

float EmitterSet::emission_probability(size_t i) const { return emission_.probability(i); }

size_t EmitterSet::bytes() const {
  constexpr size_t of_one = 400;  // of any kind, with its pointer
  size_t sum = emission_.bytes() + direct_[0].bytes() + direct_[1].bytes() + emitters_.size() * of_one;
  for (const auto& e : emitters_) sum += e->bytes();
  return sum;
}

}  // namespace ups
