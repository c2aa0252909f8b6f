// See accumulator.h: each meter's light, with the photons of the disc that is chosen for it.
#include "render/accumulator.h"

#include <algorithm>
#include <cmath>

#include "base/monitor.h"
#include "render/pooled_bias.h"

namespace ups {

namespace {

void check(const StopSignal* stop) {
  if (stop && stop->is_cancelled()) throw Cancelled();
}

}  // namespace

NeighbourProfiles Accumulator::profiles_of(size_t set, LightClass of, size_t column, const StopSignal* stop) const {
  const size_t rows = plan_.separation.columns.size() + 1;
  std::vector<RingProfile> profiles(rings_[set][of].empty() ? 0 : meters_[set].size());
  for (size_t m = 0; m < profiles.size(); ++m) {
    check(stop);
    if (visits(m) == 0) continue;  // what its disc reaches may be found right now
    const Rings rings = plan_.meter_discs[set].rings(uint32_t(m), plan_.min_radius);
    profiles[m] = rings_[set][of].profile(m * rows + column, rings, visits(m));
  }
  return NeighbourProfiles(std::move(profiles));
}

// By what the meter alone tells, then by what its neighbours found with that.
Accumulator::ClassChoices Accumulator::choose_discs(size_t set, LightClass of, const StopSignal* stop) const {
  const MeterRings& sums = rings_[set][of];
  const size_t count = sums.empty() ? 0 : meters_[set].size(), rows = plan_.separation.columns.size() + 1;
  ClassChoices choices(count);
  std::vector<OwnBias> own(count);
  std::vector<NeighbourCurvature> neighbours(count);
  const NeighbourProfiles profiles = profiles_of(set, of, 0, stop);
  for (const bool alone : {true, false}) {
    for (size_t m = 0; m < count; ++m) {
      check(stop);
      if (visits(m) == 0 || (!alone && !neighbours[m].tell() && !profiles.tell(m))) continue;
      const Rings rings = plan_.meter_discs[set].rings(uint32_t(m), plan_.min_radius);
      MeterRings::Told told{neighbours[m], {}};
      if (!alone)
        told.steps = [&](const RingProfile& half, uint32_t ring) { return profiles.bias_to_choose_by(m, half, ring); };
      choices[m] = sums.choose(m * rows, rings, visits(m), told);
      if (!alone) continue;
      own[m] = own_bias(sums.read(m * rows, rings, choices[m], visits(m)), visits(m));
    }
    if (alone) neighbours = neighbour_curvatures(own);
  }
  return choices;
}

MeterLight Accumulator::light_of(size_t set, size_t m, const Choices& discs, size_t column,
                                 std::array<OwnBias, class_count>& own) const {
  const size_t columns = plan_.separation.columns.size(), row = m * (columns + 1);
  const bool point = !scene_.meter_sets[set].is_cell();
  MeterLight light{column == 0 ? meters_[set][m] : separated_[set][m * columns + column - 1], {}, visits(m), {}, {},
                   plan_.merges_direct_light(), {}, scene_.meter_sets[set].weight(m)};
  double area = 0;
  own = {};
  const auto read = [&](LightClass of, uint32_t others) {
    if (discs[of].empty() || light.visits == 0) return MeterRings::Photons();
    const Rings rings = plan_.meter_discs[set].rings(uint32_t(m), plan_.min_radius);
    area = plan_.meter_discs[set].area(uint32_t(m));
    return rings_[set][of].read(row + column, rings, discs[of][m], light.visits, others);
  };
  const MeterRings::Photons caustics = read(caustic_light, 0);
  light.photons = read(other_light, caustics.caustics);
  light.sums.add(light.photons);
  own[other_light] = light.own_bias();
  if (caustics.caustics > 0) {
    light.sums.add(caustics);
    light.photons.add(caustics);
    own[caustic_light] = own_bias(caustics, light.visits);
  }
  const CausticSearch search = point ? CausticSearch{area * light.visits, double(light.sums.caustics)}
                                     : search_about_cell(set, m, column);
  for (const LightPart part : {whole_light, direct_light, indirect_light}) {
    light.largest[part] = std::max(largest_path(set, m, column, area, part), double(light.sums.paths[part].largest));
    const bool no_chance = part == direct_light ? plan_.exact_direct : plan_.exact_light;
    light.exact[part] = !(emitted_[column].lm > 0) || (point && no_chance);
    if (part != direct_light)
      light.unfound[part] = plan_.hits_alone_at(set)
                                ? unfound_by_hits(set, m, column, double(light.sums.caustics), light.visits)
                                : search.unfound_lx(brightest_caustic_lm(column), plan_.light_paths);
  }
  return light;
}

std::vector<MeterLight> Accumulator::lights_of(size_t set, const Choices& discs, size_t column,
                                               const StopSignal* stop) const {
  const size_t count = meters_[set].size();
  std::vector<MeterLight> lights;
  lights.reserve(count);
  std::array<std::vector<OwnBias>, class_count> own;
  for (auto& of : own) of.reserve(count);
  for (size_t m = 0; m < count; ++m) {
    check(stop);
    std::array<OwnBias, class_count> of_meter;
    lights.push_back(light_of(set, m, discs, column, of_meter));
    for (size_t k = 0; k < class_count; ++k) own[k].push_back(of_meter[k]);
  }
  for (const LightClass of : {other_light, caustic_light}) {
    if (of == caustic_light && discs[of].empty()) continue;
    const std::vector<NeighbourCurvature> neighbours = neighbour_curvatures(own[of]);
    const NeighbourProfiles profiles = profiles_of(set, of, column, stop);
    for (size_t m = 0; m < count; ++m) {
      Spread bias = pooled_bias(own[of][m], neighbours[m], count), &all = lights[m].bias;
      const double edge = discs[of].empty() ? 0 : profiles.edge(m, discs[of][m]);
      if (!discs[of].empty()) {
        const bool alone = !neighbours[m].tell() && !own[of][m].is_beyond_doubt(count);
        if (alone) bias = profiles.instead_of(bias, m, discs[of][m]);
        bias = profiles.added_to(bias, m, discs[of][m], edge);
      }
      if (of == other_light) {
        all = bias;
      } else if (own[of][m].lx > 0 && bias.standard_error >= 0 && all.standard_error >= 0) {
        lights[m].bias_apart = std::hypot(all.mean, bias.mean);
        lights[m].edge = edge;
        all = {all.mean + bias.mean, std::hypot(all.standard_error, bias.standard_error)};
      }
    }
  }
  return lights;
}

VectorLight Accumulator::vector_of(const std::vector<MeterLight>& sides, size_t m) const {
  VectorLight::Sides of_meter;
  for (uint32_t i = 0; i < vector_sides; ++i) of_meter[i] = &sides[i * (sides.size() / vector_sides) + m];
  return VectorLight(of_meter, plan_.meter_samples);
}

Accumulator::SetLight Accumulator::light_of_set(size_t set, const Choices& discs, size_t column,
                                                const StopSignal* stop) const {
  const MeterSet& meters = scene_.meter_sets[set];
  SetLight light{lights_of(set, discs, column, stop), {}};
  if (meters.kind != UPS_METER_VECTOR) return light;
  light.sides.swap(light.meters);
  light.meters.reserve(meters.count());
  for (size_t m = 0; m < meters.count(); ++m)
    light.meters.push_back(vector_of(light.sides, m).length(whole_light));
  return light;
}

ups_meter_reading Accumulator::reading_of(const SetLight& light, size_t m) const {
  return light.sides.empty() ? light.meters[m].reading() : vector_of(light.sides, m).reading(light.meters[m]);
}

}  // namespace ups
