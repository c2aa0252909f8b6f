// See accumulator.h: what iterations found in, readings out, then summaries of the errors.
#include "render/accumulator.h"

#include <algorithm>
#include <cmath>

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
    : plan_(plan), emitted_lm_(scene.emitters.flux_lm()), emits_(emitted_lm_ > 0) {
  for (const Goniometer& g : scene.goniometers) goniometers_.emplace_back(g);
  for (const MeterSet& set : scene.meter_sets) {
    meters_.emplace_back(set.meters.size());
    separated_.emplace_back(set.meters.size() * plan.separation.columns.size());
  }
  for (const Camera& c : scene.cameras) images_.emplace_back(c, plan);
}

void Accumulator::MeterSums::add(uint32_t batch, const MeterTally& t) {
  value[batch] += t.value;
  direct += t.direct;
  bias[batch] += t.bias;
}

void Accumulator::add(const IterationTally& tally) {
  const uint32_t batch = iterations_ % batch_count, meter_batch = plan_.meter_pass(iterations_) % batch_count;
  const size_t columns = plan_.separation.columns.size();
  for (size_t s = 0; s < meters_.size(); ++s)
    for (size_t i = 0; i < tally.meters[s].size(); ++i) {
      const size_t m = plan_.visited_meter(iterations_, i);
      meters_[s][m].add(meter_batch, tally.meters[s][i]);
      for (size_t c = 0; c < columns; ++c)
        separated_[s][m * columns + c].add(meter_batch, tally.separated[s][i * columns + c]);
    }
  for (size_t c = 0; c < images_.size(); ++c) images_[c].add(iterations_, tally, c);
  for (size_t g = 0; g < goniometers_.size(); ++g) goniometers_[g].add(batch, tally.goniometers[g]);
  work_.add(tally.work);
  ++iterations_;
}

ups_meter_reading Accumulator::reading_of(const MeterSums& sums, uint32_t visits) const {
  if (visits == 0) return {-1, -1, -1, -1, -1, -1};
  const Spread e = spread(sums.value, visits), b = spread(sums.bias, visits);
  ups_meter_reading out;
  out.illuminance_lx = float(e.mean);
  out.direct_lx = float(sums.direct / visits);
  out.indirect_lx = float(std::max(0.0, e.mean - double(out.direct_lx)));
  out.bias_lx = float(b.mean);
  out.standard_error_lx = float(e.standard_error);
  out.error_bound_lx = error_bound(e, b, visits);
  return out;
}

MeterSetReading Accumulator::read_meters_and_sources(size_t set) const {
  MeterSetReading r = read_meters(set);
  const size_t columns = plan_.separation.columns.size();
  for (size_t c = 0; c < columns; ++c) {
    std::vector<ups_meter_reading>& column = r.separated.emplace_back();
    for (size_t m = 0; m < r.meters.size(); ++m)
      column.push_back(reading_of(separated_[set][m * columns + c], visits(m)));
  }
  return r;
}

MeterSetReading Accumulator::read_meters(size_t set) const {
  MeterSetReading r;
  r.meters.reserve(meters_[set].size());
  for (size_t m = 0; m < meters_[set].size(); ++m) r.meters.push_back(reading_of(meters_[set][m], visits(m)));
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
  const auto visits_of_batch = [](uint32_t visits, uint32_t batch) {
    return visits / batch_count + (batch < visits % batch_count);
  };
  const uint32_t passes = plan_.meter_pass(iterations_);
  double batch_sums[batch_count] = {}, sum = 0, minimum = INFINITY, maximum = 0;
  size_t visited = 0;
  for (size_t m = 0; m < readings.size(); ++m) {
    const uint32_t n = visits(m);
    if (n == 0) continue;
    ++visited;
    const MeterSums& sums = meters_[set][m];
    const double mean = spread(sums.value, n).mean;
    sum += mean;
    minimum = std::min(minimum, mean);
    maximum = std::max(maximum, mean);
    for (uint32_t k = 0; k < batch_count; ++k)
      if (const uint32_t of_set = visits_of_batch(passes, k))
        batch_sums[k] += sums.value[k] * (double(of_set) / visits_of_batch(n, k)) / double(readings.size());
  }
  ups_meter_statistics s{};
  s.struct_size = sizeof s;
  s.count = uint32_t(readings.size());
  s.mean_lx = visited ? sum / double(visited) : -1;
  s.min_lx = visited ? minimum : -1;
  s.max_lx = visited ? maximum : -1;
  s.uniformity = s.mean_lx > 0 ? minimum / s.mean_lx : 0;
  s.mean_standard_error_lx = spread(batch_sums, passes).standard_error;
  std::vector<double> errors;
  for (const ups_meter_reading& m : readings)
    if (m.error_bound_lx >= 0 && s.mean_lx > 0)
      errors.push_back(m.error_bound_lx / std::max(double(m.illuminance_lx), share_of_mean * s.mean_lx));
  const bool known = s.mean_standard_error_lx >= 0 && !emits_;  // a set that no light has reached has no known error
  const ErrorSummary e = summary_of(std::move(errors), 0);
  s.median_relative_error_bound = e.median >= 0 ? e.median : known ? 0 : -1;
  s.p95_relative_error_bound = e.p95 >= 0 ? e.p95 : known ? 0 : -1;
  s.worst_relative_error_bound = e.worst >= 0 ? e.worst : known ? 0 : -1;
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
  std::vector<MeterError> parts;
  std::optional<ErrorSummary::Place> worst;
  double bias = 0, bound = 0;
  for (size_t s = 0; s < meters_.size(); ++s) {
    const MeterSetReading set = read_meters(s);
    if (set.statistics.mean_standard_error_lx < 0) return {};
    if (!(set.statistics.mean_lx > 0)) {
      if (!takes_dark_for_dark()) return {};
      errors.push_back(0);
      parts.emplace_back();
      continue;
    }
    for (size_t i = 0; i < set.meters.size(); ++i) {
      const ups_meter_reading& m = set.meters[i];
      const double floor = share_of_mean * set.statistics.mean_lx;
      errors.push_back(m.error_bound_lx / std::max(double(m.illuminance_lx), floor));
      parts.push_back(meter_error(m, floor, visits(i)));
      if (!worst || parts.back().error() > worst->error.error()) worst = {s, i, parts.back()};
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
  return goniometers_[goniometer].read(iterations_, emitted_lm_);
}

ErrorSummary Accumulator::summarize_goniometers() const {
  std::vector<double> errors;
  double noise = 0;
  for (const GoniometerSums& g : goniometers_) {
    const double own = g.mean_noise(iterations_);
    if (own < 0) return {};
    noise = std::max(noise, own);
    if (!g.relative_errors(iterations_, errors)) {
      if (!takes_dark_for_dark()) return {};
      errors.push_back(0);
    }
  }
  ErrorSummary s = summary_of(std::move(errors), 0.0);
  s.mean = float(noise);  // a target must be within reach
  return s;
}

ErrorSummary Accumulator::summarize_images() const {
  std::vector<double> errors;
  for (const ImageSums& image : images_) switch (image.relative_errors(iterations_, errors)) {
      case ImageSums::Errors::known: break;
      case ImageSums::Errors::unknown: return {};
      case ImageSums::Errors::dark:
        if (!takes_dark_for_dark()) return {};
        errors.push_back(0);
    }
  return summary_of(std::move(errors), 0.0);
}

}  // namespace ups
