// See accumulator.h: what meters' readings may hide, as no path or too few have found it yet.
#include "render/accumulator.h"

#include <algorithm>
#include <cmath>

namespace ups {

// Of a separated source its own: its flux is known, and with what chance light paths start from it. Of all light what
// they did start with.
double Accumulator::brightest_lm(size_t column) const {
  const double found = double(work_.brightest_lm);
  return column > 0 ? std::min(found, emitted_[column].brightest_lm) : found;
}

// At least the brightest photon on the whole disc; and as an eye path that sees a surface as bright as the brightest
// exact light makes a white one, or the scene's mean; of one source, too: emitters are chosen in proportion to what
// they bring, so that the few paths that choose a weak one weigh as much as the others. One that runs into the
// brightest emitter by way of casters brings the most of all. Where photons bring that light, too, it counts by its
// weight no more than one of them; light straight from emitters next-event estimation brings.
double Accumulator::largest_path(size_t set, size_t m, size_t column, double disc_area, LightPart part) const {
  const MeterSet& meters = scene_.meter_sets[set];
  const double area = meters.is_cell() && plan_.lands_on_cells(set) ? meters.area(m) : disc_area;
  const bool photons = plan_.light_paths > 0 && area > 0 &&
                       (part != direct_light || meters.is_cell() || plan_.merges_direct_light());
  const double photon = photons ? brightest_lm(column) / (plan_.light_paths * area) : 0,
               seen = std::max(largest_exact_[set], scene_lx_),
               hit = plan_.hits_alone && !photons && part != direct_light
                         ? double(meters.response(m).total()) * emitted_[column].brightest_cd_m2
                         : 0;
  return std::max({double(largest_[set][column][part]), photon, std::max(seen, hit) / plan_.meter_samples});
}

// The most that one hit brings: an emitter as bright as any, seen in full.
double Accumulator::unfound_by_hits(size_t set, size_t m, size_t column, double hits, double visits) const {
  const double most = double(scene_.meter_sets[set].response(m).total()) * emitted_[column].brightest_cd_m2;
  return CausticSearch{visits, hits}.unfound_lx(most, plan_.meter_samples);
}

// As long as no light path has met a caster whose light is not that of an image, any might have.
double Accumulator::brightest_caustic_lm(size_t column) const {
  if (!plan_.seeks_caustics) return 0;
  const double found = double(work_.brightest_caustic_lm), most = brightest_lm(column);
  return found > 0 ? std::min(found, most) : most;
}

// A path that none has shown may light any of the meters, at most that which brings most to the mean. Discs of which so
// many meet are so many groups whose discs do not: each group's photons are independent, and the groups' bounds add up
// (no more than as many times that of the mean group, as poisson_excess is concave).
CausticSearch Accumulator::search_of_mean(size_t set, const std::vector<MeterLight>& lights) const {
  const MeterSet& meters = scene_.meter_sets[set];
  if (meters.kind == UPS_METER_VECTOR) return {};  // any one of its sides may lack all of that light
  if (meters.is_cell()) {
    CausticSearch all;
    for (size_t m = 0; m < lights.size(); ++m) all.add(search_of_cell(set, m, 0));
    return all;
  }
  if (rings_[set][other_light].empty()) return {};
  double weights = 0, least = INFINITY, caustics = 0;
  for (size_t m = 0; m < lights.size(); ++m) {
    if (lights[m].visits == 0) continue;  // what its disc reaches may be found right now
    weights += lights[m].weight;
    least = std::min(least, plan_.meter_discs[set].area(uint32_t(m)) * lights[m].visits / lights[m].weight);
    caustics += lights[m].sums.caustics;
  }
  const double groups = discs_that_meet_[set];
  return weights > 0 ? CausticSearch{weights * least / groups, caustics / groups} : CausticSearch{};
}

// Both what each leaves open and what all do holds.
double Accumulator::unfound_in_mean(size_t set, const std::vector<MeterLight>& lights) const {
  const bool by_hits = plan_.hits_alone_at(set) && scene_.meter_sets[set].kind != UPS_METER_VECTOR;
  const CausticSearch together = search_of_mean(set, lights);
  if (!by_hits && !(together.m2 > 0)) return -1;
  double weights = 0, each = 0, hits = 0, by_all = 0;
  for (const MeterLight& light : lights) {
    if (light.visits == 0) continue;
    weights += light.weight, each += light.weight * light.unfound[whole_light];
    hits += light.sums.caustics;
  }
  for (size_t m = 0; by_hits && m < lights.size(); ++m)  // any of them may be the one that a path did not find
    if (lights[m].visits > 0)
      by_all = std::max(by_all, lights[m].weight * unfound_by_hits(set, m, 0, hits, lights[m].visits));
  return std::min(each / weights, by_hits ? by_all / weights
                                          : together.unfound_lx(brightest_caustic_lm(0), plan_.light_paths));
}

CausticSearch Accumulator::search_of_cell(size_t set, size_t m, size_t column) const {
  if (!plan_.lands_on_cells(set)) return {};
  const size_t columns = plan_.separation.columns.size();
  const MeterSums& sums = column == 0 ? meters_[set][m] : separated_[set][m * columns + column - 1];
  return {double(scene_.meter_sets[set].area(m)) * visits(m), double(sums.caustics)};
}

// A cell's with what its neighbours found, as far as a point's disc may reach: of those before and after it, that adjoin
// it, face where it does and are of its size.
CausticSearch Accumulator::search_about_cell(size_t set, size_t m, size_t column) const {
  constexpr size_t beside = 2;
  const MeterSet& meters = scene_.meter_sets[set];
  const size_t alike = meters.kind == UPS_METER_VECTOR ? meters.count() : meters.meters.size(),  // of one side
               first = m - m % alike;
  const auto adjoins = [&](size_t j) {
    const Meter &a = meters.meters[m], &b = meters.meters[j];
    const double one = meters.area(m), other = meters.area(j);
    return std::max(one, other) <= 4 * std::min(one, other) && dot(a.frame.n, b.frame.n) > 0.7f &&
           double(length2(a.p - b.p)) <= 2.5 * 2.5 * std::max(one, other);
  };
  CausticSearch all;
  for (size_t j = std::max(first + beside, m) - beside; j < std::min(first + alike, m + beside + 1); ++j)
    if (j == m || adjoins(j)) all.add(search_of_cell(set, j, column));
  return all;
}

}  // namespace ups
