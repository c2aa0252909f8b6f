// Which emitter does a light path start from, and which one does a point look at? In proportion to flux, and for
// next-event estimation also to the inverse square of the distance: about the illuminance each could give.
#include "emitter/emitter_set.h"

namespace ups {
namespace {

constexpr float flux_share = 0.1f;    // of choose_direct: no emitter's probability vanishes far away
constexpr float least_exposed = 0.01f;  // nor behind glass, which the probe may have missed a way around

}  // namespace

// flux / distance^2 of every emitter as seen from a point.
struct EmitterSet::Nearness {
  float weight[max_by_distance];
  double total = 0;
};

EmitterSet::EmitterSet(std::vector<std::unique_ptr<Emitter>> emitters, const std::vector<float>& exposed)
    : emitters_(std::move(emitters)) {
  std::vector<double> flux, direct;
  for (const auto& e : emitters_) {
    flux.push_back(std::max(0.0, e->flux_lm()));
    direct.push_back(e->is_direct() ? flux.back() : 0.0);
  }
  by_flux_ = DiscreteDistribution(flux);
  direct_by_flux_ = DiscreteDistribution(direct);
  flux_lm_ = by_flux_.total();
  if (emitters_.size() > max_by_distance || !(direct_by_flux_.total() > 0)) return;

  float extent = 0;  // of the set: a length to measure "at the same place" by
  for (const auto& e : emitters_) extent = std::max(extent, length(e->center() - emitters_[0]->center()) + e->radius());
  if (!(extent > 0)) return;
  for (size_t i = 0; i < emitters_.size(); ++i) {
    const Emitter& e = *emitters_[i];
    const float least = std::max(e.radius(), 1e-6f * extent);
    const double share = exposed.empty() ? 1.0 : std::max(exposed[i], least_exposed);
    const float part = float(share * direct[i] / direct_by_flux_.total());
    bounds_.push_back({e.center(), part, least * least, e.is_directional()});
  }
}

namespace {

EmitterSet::Choice choose_from(const DiscreteDistribution& distribution, float u) {
  if (!(distribution.total() > 0)) return {};
  const DiscreteDistribution::Sample s = distribution.sample(u);
  return {uint32_t(s.index), s.probability, s.u};
}

}  // namespace

EmitterSet::Choice EmitterSet::choose_emission(float u) const { return choose_from(by_flux_, u); }

float EmitterSet::emission_probability(size_t i) const { return by_flux_.probability(i); }

EmitterSet::Nearness EmitterSet::nearness(const Vec3& reference) const {
  Nearness out;
  for (size_t i = 0; i < bounds_.size(); ++i) {
    const Bounds& b = bounds_[i];
    // A directional light's least distance is the scene's radius, which makes its flux / distance^2 what it gives.
    const float distance2 = b.directional ? 0 : length2(b.center - reference);
    out.weight[i] = b.flux / std::max(distance2, b.least_distance2);
    out.total += out.weight[i];
  }
  return out;
}

float EmitterSet::mixed_probability(const Nearness& near, size_t i) const {
  return flux_share * direct_by_flux_.probability(i) + (1 - flux_share) * float(near.weight[i] / near.total);
}

EmitterSet::Choice EmitterSet::choose_direct(const Vec3& reference, float u) const {
  if (bounds_.empty()) return choose_from(direct_by_flux_, u);
  const Nearness near = nearness(reference);
  Choice choice;
  double below = 0, start = 0;
  for (size_t i = 0; i < bounds_.size(); ++i) {
    const float p = mixed_probability(near, i);
    if (!(p > 0)) continue;
    choice.index = uint32_t(i);
    choice.probability = p;
    start = below;
    below += p;
    if (u < below) break;  // rounding may leave u above the last one, which is then taken
  }
  if (!(choice.probability > 0)) return {};
  choice.u = float(std::clamp((u - start) / choice.probability, 0.0, double(0x1.fffffep-1f)));
  return choice;
}

float EmitterSet::direct_probability(const Vec3& reference, size_t i) const {
  return bounds_.empty() ? direct_by_flux_.probability(i) : mixed_probability(nearness(reference), i);
}

}  // namespace ups
