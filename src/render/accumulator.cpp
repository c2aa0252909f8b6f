// See accumulator.h: what iterations found in, readings out, then summaries of the errors.
#include "render/accumulator.h"

#include <algorithm>
#include <cmath>
#include <tuple>

#include "render/tails.h"

namespace ups {

namespace {

constexpr double pi_d = 3.14159265358979323846;

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
      emits_(emitted_lm_ > 0), largest_(scene.meter_sets.size()),
      largest_separated_(largest_.size(), std::vector<Largest>(plan.separation.columns.size())),
      largest_exact_(largest_.size()) {
  for (const Goniometer& g : scene.goniometers) goniometers_.emplace_back(g, emitted_lm_, plan.light_paths);
  for (const MeterSet& set : scene.meter_sets) {
    meters_.emplace_back(set.meters.size());
    separated_.emplace_back(set.meters.size() * plan.separation.columns.size());
  }
  for (const Camera& c : scene.cameras) images_.emplace_back(c, plan, scene_lx_ / pi_d);
}

void MeterSums::add(uint32_t batch, const MeterTally& t) {
  value[batch] += t.value;
  direct[batch] += t.direct;
  bias[batch] += t.bias;
  exact += t.exact;
  rounding += t.rounding;
  if (t.paths[whole_light].largest > paths[whole_light].largest) largest_batch = uint8_t(batch);
  for (size_t k = 0; k < light_part_count; ++k) {
    paths[k].add(t.paths[k]);
    if (t.paths[k].count > 0) batches[k] |= uint16_t(1u << batch);
  }
}

void Accumulator::add(const IterationTally& tally) {
  const uint32_t batch = iterations_ % batch_count, meter_batch = plan_.meter_pass(iterations_) % batch_count;
  const size_t columns = plan_.separation.columns.size();
  const auto add = [&](const MeterTally& t, MeterSums& sums, Largest& largest) {
    sums.add(meter_batch, t);
    for (size_t k = 0; k < light_part_count; ++k) largest[k] = std::max(largest[k], t.paths[k].largest);
  };
  for (size_t s = 0; s < meters_.size(); ++s)
    for (size_t i = 0; i < tally.meters[s].size(); ++i) {
      const size_t m = plan_.visited_meter(iterations_, i);
      add(tally.meters[s][i], meters_[s][m], largest_[s]);
      largest_exact_[s] = std::max(largest_exact_[s], tally.meters[s][i].exact);
      for (size_t c = 0; c < columns; ++c)
        add(tally.separated[s][i * columns + c], separated_[s][m * columns + c], largest_separated_[s][c]);
    }
  for (size_t c = 0; c < images_.size(); ++c) images_[c].add(iterations_, tally, c);
  for (size_t g = 0; g < goniometers_.size(); ++g) goniometers_[g].add(batch, tally.goniometers[g]);
  work_.add(tally.work);
  ++iterations_;
}

// At least the brightest photon on the nominal area; and as an eye path that sees a surface as bright as the brightest
// exact light makes a white one, or the scene's mean.
double Accumulator::largest_path(size_t set, size_t meter, const Largest& found, LightPart part) const {
  const MeterSet& meters = scene_.meter_sets[set];
  const TechniqueShare share = plan_.shares.empty() ? TechniqueShare{} : plan_.shares[plan_.units.of_set(set)];
  double area = 0;
  if (meters.is_cell())
    area = share.light ? double(meters.cell_area()) : 0;
  else if (!plan_.meter_radius.empty() && share.merge != TechniqueShare::no_merge)
    area = pi_d * std::pow(plan_.meter_radius[set][meter], 2);
  const double photon = plan_.light_paths > 0 && area > 0 ? work_.brightest_lm / (plan_.light_paths * area) : 0;
  const double seen = std::max(largest_exact_[set], scene_lx_) / plan_.meter_samples;
  return std::max({double(found[part]), photon, seen});
}

std::pair<float, float> Accumulator::error_of(const MeterSums& sums, LightPart part, uint32_t visits, size_t set,
                                              double largest) const {
  const bool point = !scene_.meter_sets[set].is_cell(), direct = part == direct_light;
  const double exact = part == indirect_light ? 0 : sums.exact / visits,
               rounding = part == indirect_light ? 0 : sums.rounding / visits;
  if (!emits_ || (point && (direct ? plan_.exact_direct : plan_.exact_light))) return {0.0f, float(rounding)};
  double values[batch_count];
  ChanceLight light{sums.paths[part].count, uint32_t(std::popcount(sums.batches[part])), 0};
  for (uint32_t b = 0; b < batch_count; ++b) {
    values[b] = direct ? sums.direct[b] : part == indirect_light ? sums.value[b] - sums.direct[b] : sums.value[b];
    light.largest_batch = std::max(light.largest_batch, values[b] - exact * visits_of_batch(visits, b));
  }
  const Spread e = spread(values, visits), bias = spread(sums.bias, visits);
  if (e.standard_error < 0) return {-1.0f, -1.0f};
  if (light.is_enough(visits)) return {float(e.standard_error), error_bound(e, bias, visits) + float(rounding)};
  return {-1.0f, float(std::abs(bias.mean) + light.bound(largest, visits) + rounding)};
}

ups_meter_reading Accumulator::reading_of(const MeterSums& sums, uint32_t visits, size_t set, double largest) const {
  if (visits == 0) return {-1, -1, -1, -1, -1, -1};
  const double value = spread(sums.value, visits).mean;
  ups_meter_reading out;
  out.illuminance_lx = float(value);
  out.direct_lx = float(spread(sums.direct, visits).mean);
  out.indirect_lx = float(std::max(0.0, value - double(out.direct_lx)));
  out.bias_lx = float(spread(sums.bias, visits).mean);
  std::tie(out.standard_error_lx, out.error_bound_lx) = error_of(sums, whole_light, visits, set, largest);
  return out;
}

// Light straight from emitters that no photon brings has no bias; the other part may have all of it.
ups_meter_part_reading Accumulator::part_of(const MeterSums& sums, ups_light_part part, uint32_t visits, size_t set,
                                            double largest) const {
  if (visits == 0) return {-1, -1, -1, -1};
  const LightPart of = part == UPS_LIGHT_PART_DIRECT ? direct_light : indirect_light;
  const double direct = spread(sums.direct, visits).mean;
  const bool biased = of == indirect_light || std::any_of(plan_.gates.begin(), plan_.gates.end(),
                                                          [](const mis::Gates& g) { return g.merge_at_first; });
  ups_meter_part_reading out;
  out.illuminance_lx = float(of == direct_light ? direct : std::max(0.0, spread(sums.value, visits).mean - direct));
  out.bias_lx = biased ? float(spread(sums.bias, visits).mean) : 0;
  std::tie(out.standard_error_lx, out.error_bound_lx) = error_of(sums, of, visits, set, largest);
  return out;
}

uint32_t Accumulator::flags_of(const MeterSums& sums, uint32_t visits, const ups_meter_reading& r) const {
  if (r.error_bound_lx < 0) return UPS_READING_UNKNOWN;
  if (r.standard_error_lx < 0) return UPS_READING_FEW_PATHS;
  const PathRecord& paths = sums.paths[whole_light];
  if (paths.count == 0) return UPS_READING_EXACT;
  const double by_chance = spread(sums.value, visits).mean - sums.exact / visits,
               batch = sums.value[sums.largest_batch] -
                       sums.exact / visits * visits_of_batch(visits, sums.largest_batch);
  uint32_t flags = 0;
  if (single_path_dominates(paths.largest, paths.count, by_chance, batch, r.standard_error_lx, visits))
    flags |= UPS_READING_SINGLE_PATH;
  if (batch_kurtosis(sums.value, visits) > largest_kurtosis) flags |= UPS_READING_HEAVY_TAIL;
  return flags;
}

MeterSetReading Accumulator::read_meters_and_sources(size_t set) const {
  MeterSetReading r = read_meters(set);
  const size_t columns = plan_.separation.columns.size();
  for (size_t c = 0; c < columns; ++c) {
    std::vector<ups_meter_reading>& column = r.separated.emplace_back();
    for (size_t m = 0; m < r.meters.size(); ++m)
      column.push_back(reading_of(separated_[set][m * columns + c], visits(m), set,
                                  largest_path(set, m, largest_separated_[set][c], whole_light)));
  }
  return r;
}

std::vector<ups_meter_reading> Accumulator::readings_of(size_t set) const {
  std::vector<ups_meter_reading> out;
  out.reserve(meters_[set].size());
  for (size_t m = 0; m < meters_[set].size(); ++m)
    out.push_back(
        reading_of(meters_[set][m], visits(m), set, largest_path(set, m, largest_[set], whole_light)));
  return out;
}

MeterSetReading Accumulator::read_meters(size_t set) const {
  MeterSetReading r;
  r.meters = readings_of(set);
  for (size_t m = 0; m < r.meters.size(); ++m) {
    r.flags.push_back(flags_of(meters_[set][m], visits(m), r.meters[m]));
    for (const ups_light_part part : {UPS_LIGHT_PART_DIRECT, UPS_LIGHT_PART_INDIRECT})
      r.parts[size_t(part)].push_back(
          part_of(meters_[set][m], part, visits(m), set,
                  largest_path(set, m, largest_[set], part == UPS_LIGHT_PART_DIRECT ? direct_light : indirect_light)));
  }
  r.statistics = statistics_of(set, r.meters);
  return r;
}

size_t Accumulator::unvisited_meters(size_t set) const {
  size_t count = 0;
  for (size_t m = 0; m < meters_[set].size(); ++m) count += visits(m) == 0;
  return count;
}

// Of the meters that were visited. A pass that is under way visited some of them more often than others: each meter's
// batch counts as its mean.
ups_meter_statistics Accumulator::statistics_of(size_t set, const std::vector<ups_meter_reading>& readings) const {
  MeterBatches batches(std::min(plan_.meter_pass(iterations_), batch_count));
  uint16_t reached = 0;  // batches, by any path
  for (size_t m = 0; m < readings.size(); ++m) {
    const uint32_t n = visits(m);
    if (n == 0) continue;
    const MeterSums& sums = meters_[set][m];
    double means[batch_count] = {}, biases[batch_count] = {};
    for (uint32_t b = 0; b < batches.used(); ++b) {
      means[b] = sums.value[b] / visits_of_batch(n, b);
      biases[b] = sums.bias[b] / visits_of_batch(n, b);
    }
    const Spread bias = spread(sums.bias, n);
    const double unfound = readings[m].error_bound_lx - std::abs(bias.mean);
    batches.add({spread(sums.value, n).mean, bias, readings[m].standard_error_lx < 0 ? std::max(0.0, unfound) : 0},
                means, biases);
    reached |= sums.batches[whole_light];
  }
  const bool exact = !emits_ || (plan_.exact_light && !scene_.meter_sets[set].is_cell());
  const ChanceLight light{0, uint32_t(std::popcount(reached)), 0};
  const bool known = exact || light.is_enough(plan_.meter_pass(iterations_));
  ups_meter_statistics s = meter_statistics(batches, plan_.meter_pass(iterations_), known);
  std::vector<double> errors;
  for (const ups_meter_reading& m : readings)
    if (m.error_bound_lx >= 0 && s.mean_lx > 0)
      errors.push_back(m.error_bound_lx / std::max(double(m.illuminance_lx), share_of_mean * s.mean_lx));
  const ErrorSummary e = summary_of(std::move(errors), 0);
  const double of_dark = known && !emits_ ? 0 : -1;  // a set that no light has reached has no known error
  s.count = uint32_t(readings.size());
  s.median_relative_error_bound = e.median >= 0 ? e.median : of_dark;
  s.p95_relative_error_bound = e.p95 >= 0 ? e.p95 : of_dark;
  s.worst_relative_error_bound = e.worst >= 0 ? e.worst : of_dark;
  return s;
}

ImageReading Accumulator::read_image_and_techniques(size_t c) const {
  ImageReading r = read_image(c);
  images_[c].read_techniques(iterations_, r);
  return r;
}

ErrorSummary Accumulator::summarize() const {
  if (meters_.empty()) return images_.empty() ? summarize_goniometers() : summarize_images();
  std::vector<double> errors;
  double bias = 0, bound = 0;
  for (size_t s = 0; s < meters_.size(); ++s) {
    const std::vector<ups_meter_reading> readings = readings_of(s);
    double mean = 0;
    for (const ups_meter_reading& m : readings) mean += double(m.illuminance_lx) / double(readings.size());
    if (!(mean > 0)) mean = scene_lx_;
    for (const ups_meter_reading& m : readings) {
      if (m.error_bound_lx < 0) return {};
      errors.push_back(emits_ ? m.error_bound_lx / std::max(double(m.illuminance_lx), share_of_mean * mean) : 0);
      bias += std::abs(m.bias_lx);
      bound += m.error_bound_lx;
    }
  }
  return summary_of(std::move(errors), bound > 0 ? bias / bound : 0.0);
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
  double sum = 0;
  for (const ImageSums& image : images_)
    if (!image.relative_errors(iterations_, errors, sum)) return {};
  const double mean = errors.empty() ? -1 : sum / double(errors.size());
  ErrorSummary s = summary_of(std::move(errors), 0.0);
  s.mean = float(mean);
  return s;
}

}  // namespace ups
