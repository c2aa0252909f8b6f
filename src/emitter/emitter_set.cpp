// Which emitter does a light path start from, and which one does a point look at?
#include "emitter/emitter_set.h"

namespace ups {
namespace {

constexpr float least_exposed = 0.01f;  // behind glass, which the probe may have missed a way around

}  // namespace

EmitterSet::EmitterSet(std::vector<std::shared_ptr<const Emitter>> emitters, const std::vector<float>& exposed)
    : emitters_(std::move(emitters)) {
  std::vector<double> flux;
  std::vector<LightTree::Entry> direct[2];
  for (size_t i = 0; i < emitters_.size(); ++i) {
    const Emitter& e = *emitters_[i];
    flux.push_back(std::max(0.0, e.flux_lm()));
    const float share = exposed.empty() ? 1.0f : std::max(exposed[i], least_exposed);
    if (e.is_direct()) direct[e.is_directional()].push_back({e.outline(), flux.back(), share, uint32_t(i)});
  }
  by_flux_ = DiscreteDistribution(flux);
  flux_lm_ = by_flux_.total();
  for (const int far : {0, 1}) {
    direct_[far] = LightTree(direct[far], emitters_.size());
    has_direct_[far] = !direct[far].empty();
  }
}

EmitterSet::Choice EmitterSet::choose_emission(double u) const {
  if (!(by_flux_.total() > 0)) return {};
  const DiscreteDistribution::Sample s = by_flux_.sample(u);
  return {uint32_t(s.index), s.probability, s.u};
}

float EmitterSet::emission_probability(size_t i) const { return by_flux_.probability(i); }

size_t EmitterSet::bytes() const {
  constexpr size_t of_one = 400;  // of any kind, with its pointer
  size_t sum = by_flux_.bytes() + direct_[0].bytes() + direct_[1].bytes() + emitters_.size() * of_one;
  for (const auto& e : emitters_) sum += e->bytes();
  return sum;
}

}  // namespace ups
