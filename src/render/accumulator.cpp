// See accumulator.h: what iterations found in, readings out, then summaries of the errors.
#include "render/accumulator.h"

#include <algorithm>
#include <cmath>

#include "render/accuracy.h"
#include "render/tails.h"
#include "render/zero_bound.h"

namespace ups {

namespace {

ErrorSummary summary_of(std::vector<double> errors, double bias_share) {
  ErrorSummary s;
  if (errors.empty()) return s;
  double sum = 0, worst = 0;
  for (double e : errors) {
    sum += e;
    worst = std::max(worst, e);
  }
  s.mean = float(sum / double(errors.size()));
  s.worst = float(worst);
  s.p95 = float(quantile(errors, 0.95));
  s.median = float(quantile(errors, 0.5));
  s.bias_share = float(bias_share);
  return s;
}

}  // namespace

Accumulator::Accumulator(const Snapshot& scene, const Plan& plan)
    : scene_(scene), plan_(plan), emitted_lm_(scene.emitters.flux_lm()),
      scene_lx_(scene.radius > 0 ? emitted_lm_ / (4 * pi_d * scene.radius * scene.radius) : emitted_lm_),
      emits_(emitted_lm_ > 0),
      largest_(scene.meter_sets.size(), std::vector<Largest>(plan.separation.columns.size() + 1)),
      largest_exact_(largest_.size()),
      emitted_(emitted_by_column(scene, plan)) {
  for (const Goniometer& g : scene.goniometers) goniometers_.emplace_back(g, emitted_lm_, plan.light_paths);
  for (const MeterSet& set : scene.meter_sets) {
    meters_.emplace_back(set.meters.size());
    separated_.emplace_back(set.meters.size() * plan.separation.columns.size());
    const size_t s = rings_.size();
    const uint32_t rings = plan.lands_on(s) ? plan.meter_discs[s].ring_count() : 0;
    const size_t meters = rings ? set.meters.size() : 0, columns = plan.separation.columns.size() + 1;
    rings_.push_back({MeterRings(meters, columns, rings, plan.merges_direct_light()),
                      MeterRings(plan.seeks_caustics ? meters : 0, columns, rings, false, true)});
    const uint32_t sides = set.kind == UPS_METER_VECTOR ? vector_sides : 1;
    discs_that_meet_.push_back(rings ? plan.meter_discs[s].most_that_meet(set.meters, sides) : 1);
  }
  for (const Camera& c : scene.cameras) images_.emplace_back(c, plan, scene_lx_ / pi_d);
}

std::vector<Accumulator::Emitted> Accumulator::emitted_by_column(const Snapshot& scene, const Plan& plan) {
  std::vector<Emitted> out(plan.separation.columns.size() + 1);
  for (size_t i = 0; i < scene.emitters.size(); ++i) {
    const Emitter& emitter = scene.emitters[i];
    const double flux = emitter.flux_lm(), chance = double(plan.guide.probability(scene.emitters, i)),
                 started = chance > 0 ? flux / (chance * double(plan.guide.least_density(i))) : 0,
                 cd_m2 = plan.hits_alone && !scene.meter_sets.empty() ? emitter.brightest_cd_m2() : 0;
    const auto add = [&](Emitted& e) {
      e.lm += flux;
      e.brightest_lm = std::max(e.brightest_lm, started);
      e.brightest_cd_m2 = std::max(e.brightest_cd_m2, cd_m2);
    };
    add(out[0]);
    if (out.size() > 1) add(out[1 + plan.separation.column_of_emitter[i]]);
  }
  return out;
}

// All meters' light, and beside it the choice of discs, then profiles, or two more copies of the batches and their
// ranks.
double Accumulator::scratch_bytes(bool has_discs) {
  constexpr double profiles = sizeof(RingProfile) + class_count * sizeof(MeterRings::Choice),
                   choosing = class_count * sizeof(OwnBias) + sizeof(NeighbourCurvature);
  return sizeof(MeterLight) + std::max(choosing + has_discs * profiles, 2 * MeterBatches::bytes_per_meter + 48);
}

void Accumulator::add(const IterationTally& tally) {
  const uint32_t batch = iterations_ % batch_count, meter_batch = plan_.meter_pass(iterations_) % batch_count;
  const size_t columns = plan_.separation.columns.size();
  const auto add = [&](const MeterTally& t, MeterSums& sums, size_t set, size_t column) {
    sums.add(meter_batch, t, iterations_);
    Largest& largest = largest_[set][column];
    for (size_t k = 0; k < light_part_count; ++k) largest[k] = std::max(largest[k], t.paths[k].largest);
  };
  for (size_t s = 0; s < meters_.size(); ++s)
    for (size_t i = 0; i < tally.meters[s].size(); ++i) {
      const size_t m = plan_.visited_meter(iterations_, i);
      add(tally.meters[s][i], meters_[s][m], s, 0);
      largest_exact_[s] = std::max(largest_exact_[s], tally.meters[s][i].exact);
      for (size_t c = 0; c < columns; ++c)
        add(tally.separated[s][i * columns + c], separated_[s][m * columns + c], s, c + 1);
    }
  for (size_t s = 0; s < tally.landings.size(); ++s)
    for (const MeterLanding& l : tally.landings[s]) {
      const size_t row = plan_.visited_meter(iterations_, l.visited) * (columns + 1);
      MeterRings& rings = rings_[s][l.caustic && plan_.seeks_caustics ? caustic_light : other_light];
      rings.add(row, meter_batch, l, iterations_);
      if (columns) rings.add(row + 1 + l.column, meter_batch, l, iterations_);
    }
  for (size_t c = 0; c < images_.size(); ++c) images_[c].add(iterations_, tally, c);
  for (size_t g = 0; g < goniometers_.size(); ++g) goniometers_[g].add(batch, tally.goniometers[g]);
  static_assert(std::tuple_size_v<decltype(FluxBooks::batches)> == batch_count);
  WorkCounts work = tally.work;
  work.flux.settle(batch, work.light_paths);
  work_.add(work);
  ++iterations_;
}

MeterSetReading Accumulator::read_meters_and_sources(size_t set) const {
  const Choices discs = choose_discs(set);
  MeterSetReading r = read_meters(set, discs);
  r.separated.resize(plan_.separation.columns.size());
  for (size_t c = 0; c < r.separated.size(); ++c) {
    r.separated[c].reserve(scene_.meter_sets[set].count());
    const SetLight light = light_of_set(set, discs, c + 1);
    for (size_t m = 0; m < light.meters.size(); ++m) r.separated[c].push_back(reading_of(light, m));
  }
  return r;
}

MeterSetReading Accumulator::read_meters(size_t set, const Choices& discs) const {
  MeterSetReading r;
  const SetLight light = light_of_set(set, discs);
  const std::vector<MeterLight>& lights = light.meters;
  r.meters.reserve(lights.size()), r.flags.reserve(lights.size()), r.largest.reserve(lights.size());
  for (auto& part : r.parts) part.reserve(lights.size());
  for (auto& part : r.vectors) part.reserve(light.sides.empty() ? 0 : lights.size());
  for (size_t m = 0; m < lights.size(); ++m) {
    r.meters.push_back(reading_of(light, m));
    r.flags.push_back(lights[m].flags(r.meters.back()));
    r.largest.push_back(lights[m].largest_sample());
    for (const ups_light_part part : {UPS_LIGHT_PART_DIRECT, UPS_LIGHT_PART_INDIRECT})
      r.parts[size_t(part)].push_back(light.sides.empty() ? lights[m].part(part)
                                                          : vector_of(light.sides, m).part(part));
    if (light.sides.empty()) continue;
    const auto components = vector_of(light.sides, m).components();
    for (size_t part = 0; part < components.size(); ++part) r.vectors[part].push_back(components[part]);
  }
  add_statistics(set, lights, r);
  r.statistics.count = scene_.meter_sets[set].count();
  return r;
}

std::vector<ups_sample> Accumulator::largest_samples(size_t camera, const ImageReading& image, uint64_t seed) const {
  LargestSamples largest(scene_.camera_ids[camera], seed);
  images_[camera].find_largest(iterations_, image, largest);
  return largest.take();
}

std::vector<ups_sample> Accumulator::largest_samples(size_t set, const MeterSetReading& r, uint64_t seed) const {
  LargestSamples largest(scene_.meter_set_ids[set], seed);
  for (uint32_t m = 0; m < r.meters.size(); ++m)
    largest.add(scene_.meter_sets[set].number(m), r.largest[m], visits(m), double(r.meters[m].illuminance_lx),
                r.statistics.mean_lx);
  return largest.take();
}

size_t Accumulator::unvisited_meters(size_t set) const {
  size_t count = 0;
  const size_t meters = scene_.meter_sets[set].count();
  for (size_t m = 0; m < meters; ++m) {
    bool visited = true;
    for (size_t side = m; side < meters_[set].size(); side += meters) visited = visited && visits(side) > 0;
    count += !visited;
  }
  return count;
}

// Of the meters that were visited. A pass that is under way visited some of them more often than others: each meter's
// batch counts as its mean.
void Accumulator::add_statistics(size_t set, const std::vector<MeterLight>& lights, MeterSetReading& r) const {
  const std::vector<ups_meter_reading>& readings = r.meters;
  MeterBatches batches(std::min(plan_.meter_pass(iterations_), batch_count), discs_that_meet_[set]);
  uint16_t reached = 0;  // batches, by any path
  const double of_set = unfound_in_mean(set, lights);
  for (size_t m = 0; m < readings.size(); ++m) {
    const uint32_t n = lights[m].visits;
    if (n == 0) continue;
    const MeterSums& sums = lights[m].sums;
    double means[batch_count] = {}, biases[batch_count] = {};
    for (uint32_t b = 0; b < batches.used(); ++b) {
      means[b] = sums.value[b] / visits_of_batch(n, b);
      biases[b] = sums.bias[b] / visits_of_batch(n, b);
    }
    const Spread& bias = lights[m].bias;
    const bool known = readings[m].standard_error_lx >= 0;
    const double all = std::max(0.0, readings[m].error_bound_lx - std::abs(bias.mean)), rounding = sums.rounding / n;
    MeterError apart;
    lights[m].error_of(whole_light, &apart);
    const double unfound = lights[m].unfound[whole_light] + rounding,
                 own = known ? std::max(double(apart.unfound), unfound) : all;
    batches.add({spread(sums.value, n).mean, bias, own, lights[m].weight, known, lights[m].photons.halves_differ,
                 lights[m].photons.choice_variance, known ? lights[m].photons.caustic : NarrowLight(),
                 !known ? -1 : of_set >= 0 ? of_set + rounding : unfound},
                means, biases);
    batches.widen(double(readings[m].error_bound_lx));
    reached |= sums.batches[whole_light];
  }
  const ChanceLight light{0, uint32_t(std::popcount(reached)), 0};
  const bool known = lights.front().exact[whole_light] || light.is_enough(plan_.meter_pass(iterations_));
  ups_meter_statistics s = meter_statistics(batches, plan_.meter_pass(iterations_), known);
  std::vector<double> errors;
  bool of_all = true;  // that were visited: some may know no error yet, as others were visited once more
  for (size_t m = 0; m < readings.size(); ++m) {
    const double bound = double(readings[m].error_bound_lx);
    of_all &= lights[m].visits == 0 || bound >= 0;
    if (bound >= 0 && s.mean_lx > 0)
      errors.push_back(bound / std::max(double(readings[m].illuminance_lx), share_of_mean * s.mean_lx));
  }
  if (!of_all) errors.clear();
  const ErrorSummary e = summary_of(std::move(errors), 0);
  const double of_dark = known && !emits_ ? 0 : -1;  // a set that no light has reached has no known error
  s.median_relative_error_bound = e.median >= 0 ? e.median : of_dark;
  s.p95_relative_error_bound = e.p95 >= 0 ? e.p95 : of_dark;
  s.worst_relative_error_bound = e.worst >= 0 ? e.worst : of_dark;
  r.statistics = s;
  r.batches = std::move(batches);
}

ImageReading Accumulator::read_image_and_techniques(size_t c) const {
  ImageReading r = read_image(c);
  images_[c].read_techniques(iterations_, r);
  return r;
}

ErrorSummary Accumulator::summarize(const StopSignal* stop) const {
  if (by_pixels(scene_)) return summarize_images();
  if (meters_.empty()) return summarize_goniometers();
  std::vector<double> errors;
  std::vector<MeterError> parts;
  std::optional<ErrorSummary::Place> worst;
  double bias = 0, bound = 0, worst_error = 0;
  for (size_t s = 0; s < meters_.size(); ++s) {
    if (!is_looked_at(scene_, s)) continue;
    const std::vector<MeterLight> lights = light_of_set(s, choose_discs(s, stop), 0, stop).meters;
    std::vector<ups_meter_reading> readings;
    for (const MeterLight& light : lights) readings.push_back(light.reading());
    double mean = 0, weights = 0;  // as the statistics have it: on surfaces by area
    for (size_t i = 0; i < readings.size(); ++i)
      mean += lights[i].weight * double(readings[i].illuminance_lx), weights += lights[i].weight;
    mean = mean > 0 ? mean / weights : scene_lx_;
    const double floor = share_of_mean * mean;
    for (size_t i = 0; i < readings.size(); ++i) {
      const ups_meter_reading& m = readings[i];
      if (m.error_bound_lx < 0) return {};
      MeterError apart;
      lights[i].error_of(whole_light, &apart);
      parts.push_back(emits_ ? apart.scaled(1 / std::max(double(m.illuminance_lx), floor)) : MeterError{});
      parts.back().halves = float(log_ratio_of_halves(lights[i].sums.value, lights[i].visits));
      errors.push_back(emits_ ? m.error_bound_lx / std::max(double(m.illuminance_lx), floor) : 0);
      if (!worst || errors.back() > worst_error) worst = {s, i, parts.back()}, worst_error = errors.back();
      bias += std::abs(m.bias_lx);
      bound += m.error_bound_lx;
    }
  }
  ErrorSummary all = summary_of(std::move(errors), bound > 0 ? bias / bound : 0.0);
  all.meters = std::move(parts);
  all.worst_place = worst;
  return all;
}

GoniometerReading Accumulator::read_goniometer(size_t goniometer) const {
  return goniometers_[goniometer].read(iterations_);
}

ErrorSummary Accumulator::summarize_goniometers() const {
  std::vector<double> errors;
  double noise = 0;
  for (const GoniometerSums& g : goniometers_) {
    const double own = g.mean_noise(iterations_);
    if (own < 0) return {};
    noise = std::max(noise, own);
    if (!g.relative_errors(iterations_, errors)) return {};
  }
  ErrorSummary s = summary_of(std::move(errors), 0.0);
  s.mean = float(noise);  // a target must be within reach
  return s;
}

ErrorSummary Accumulator::summarize_images() const {
  std::vector<double> errors;
  MeanError together;
  for (const ImageSums& image : images_)
    if (!image.relative_errors(iterations_, brightest_caustic_lm(0), errors, together)) return {};
  const bool known = !errors.empty();
  ErrorSummary s = summary_of(std::move(errors), 0.0);
  s.meters = {together.mean()};
  s.mean = known ? s.meters[0].error() : -1;
  return s;
}

}  // namespace ups
