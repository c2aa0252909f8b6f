// See meter_statistics.h.
//
// The least of noisy readings is biased low, and which of them is the least says nothing new of its own noise. Below:
// each true value is above its reading less its bound, 95 %, so the least true one is above the least of these. Above:
// a meter that was chosen by half of the batches is read by the other half without that bias, and is at least the least
// true one. Both hold for any field of true values; neither can be much tightened without knowing it: one meter may
// stand out as far as noise hides.
#include "render/meter_statistics.h"

#include <numeric>

namespace ups {

namespace {

std::vector<uint32_t> order_by(const std::vector<double>& values) {
  std::vector<uint32_t> order(values.size());
  std::iota(order.begin(), order.end(), 0u);
  std::sort(order.begin(), order.end(),
            [&](uint32_t i, uint32_t j) { return values[i] != values[j] ? values[i] < values[j] : i < j; });
  return order;
}

std::vector<double> values_of(const MeterBatches& meters) {
  std::vector<double> values;
  for (size_t m = 0; m < meters.count(); ++m) values.push_back(meters.value(m));
  return values;
}

// What all batches of one half say of each meter.
std::vector<double> sums_of_half(const MeterBatches& meters, uint32_t half) {
  std::vector<double> sums(meters.count());
  for (size_t m = 0; m < sums.size(); ++m)
    for (uint32_t b = half; b < meters.used(); b += 2) sums[m] += double(meters.batch(m, b));
  return sums;
}

// The mean of the meters that each half of the batches chose, read by the other half, and how far its limits are from it.
struct CrossReading {
  double value, above;
};
CrossReading cross_reading(const MeterBatches& meters, const std::span<const uint32_t> (&chosen)[2]) {
  double batches[batch_count] = {}, offset = 0, bias_error = 0;
  for (uint32_t half = 0; half < 2; ++half) {
    double weights = 0;
    for (const uint32_t m : chosen[half]) weights += meters.weight(m);
    for (const uint32_t m : chosen[half]) {
      const double share = meters.weight(m) / weights;
      offset += 0.5 * share * meters.offset(m);
      bias_error += 0.5 * share * meters.bias_error(m);
      for (uint32_t b = 1 - half; b < meters.used(); b += 2) batches[b] += share * double(meters.batch(m, b));
    }
  }
  const uint32_t used = meters.used();
  const double noise = error_of_mean(used, 2, [&](uint32_t b) { return batches[b]; });
  double halves[2] = {};
  for (uint32_t b = 0; b < used; ++b) halves[b % 2] += batches[b] / (used / 2 + (used % 2 && b % 2 == 0));
  return {0.5 * (halves[0] + halves[1]), offset + t_quantile(used, 2) * std::hypot(noise, bias_error)};
}

}  // namespace

Interval minimum_interval(const MeterBatches& meters) {
  if (meters.count() == 0 || meters.used() < min_batches_of_interval) return {};
  double low = INFINITY, least = INFINITY;
  uint32_t first[2];  // of each half
  for (uint32_t half = 0; half < 2; ++half) {
    const std::vector<double> sums = sums_of_half(meters, half);
    first[half] = uint32_t(std::min_element(sums.begin(), sums.end()) - sums.begin());
  }
  for (size_t m = 0; m < meters.count(); ++m) {
    low = std::min(low, meters.value(m) - meters.bound(m));
    least = std::min(least, meters.value(m));
  }
  const CrossReading high = cross_reading(meters, {{&first[0], 1}, {&first[1], 1}});
  return {low, std::max(least, high.value + high.above)};
}

MeterOrder::MeterOrder(const MeterBatches& of, const std::vector<double>& values) : meters(order_by(values)) {
  double sum = 0;
  for (const uint32_t m : meters) up_to.push_back(sum += of.weight(m));
}

MeterOrder::MeterOrder(const MeterBatches& of) : MeterOrder(of, values_of(of)) {}

size_t MeterOrder::rank_above(double weight) const {
  const size_t rank = size_t(std::upper_bound(up_to.begin(), up_to.end(), weight) - up_to.begin());
  return std::min(rank, meters.size() - 1);
}

// From the meter that the weight `begin` reaches into to that which `end` does, one at least.
std::span<const uint32_t> MeterOrder::between(double begin, double end) const {
  const size_t first = rank_above(begin),
               last = size_t(std::lower_bound(up_to.begin(), up_to.end(), end) - up_to.begin());
  return {&meters[first], std::max(std::min(last, meters.size() - 1), first) - first + 1};
}

LowerRanks::LowerRanks(MeterBatches of) : meters_(std::move(of)), all_(meters_) {
  for (uint32_t half = 0; half < 2; ++half) by_half_[half] = {meters_, sums_of_half(meters_, half)};
}

// Standard error of a reading there.
double LowerRanks::noise_at(size_t rank) const {
  double square = 0;
  const size_t reach = std::max<size_t>(1, count() / 40), first = rank - std::min(rank, reach),
               last = std::min(count() - 1, rank + reach);
  for (size_t i = first; i <= last; ++i)
    square += std::pow(meters_.standard_error(all_.meters[i]), 2) / double(last - first + 1);
  return std::sqrt(square);
}

// A meter that noise may have put on the wrong side moves the rank by its weight.
Interval LowerRanks::interval(size_t rank) const {
  Interval out = interval_at(rank);
  if (meters_.used() < min_batches_of_interval) return out;
  const double noise = 2 * noise_at(rank), value = this->value(rank),
               middle = 0.5 * (all_.up_to_rank(rank) + all_.up_to[rank]);
  double heaviest = 0;
  const auto look = [&](size_t i) { heaviest = std::max(heaviest, meters_.weight(all_.meters[i])); };
  for (size_t i = rank + 1; i < count() && this->value(i) - value <= noise; ++i) look(i);
  for (size_t i = rank; i-- > 0 && value - this->value(i) <= noise;) look(i);
  if (!(heaviest > 0)) return out;
  for (const double sign : {-1, 1}) {
    const Interval beside = interval_at(all_.rank_above(middle + sign * heaviest));
    out = {std::min(out.low, beside.low), std::max(out.high, beside.high)};
  }
  return out;
}

// As a minimum, but that noise averages over all meters whose readings it can exchange: those within a standard error.
Interval LowerRanks::interval_at(size_t rank) const {
  if (rank == 0) return minimum_interval(meters_);
  if (meters_.used() < min_batches_of_interval) return {};
  const size_t count = this->count();
  const double value = this->value(rank), noise = noise_at(rank);
  size_t begin = rank, end = rank + 1;
  while (begin > 0 && value - this->value(begin - 1) <= noise) --begin;
  while (end < count && this->value(end) - value <= noise) ++end;

  double batches[batch_count] = {}, bias_error = 0;
  const double before = all_.up_to_rank(begin), up_to = all_.up_to_rank(end);
  for (size_t i = begin; i < end; ++i) {
    const uint32_t m = all_.meters[i];
    const double part = meters_.weight(m) / (up_to - before);
    bias_error += part * meters_.bias_error(m);
    for (uint32_t b = 0; b < meters_.used(); ++b) batches[b] += part * double(meters_.batch(m, b));
  }
  const double own = error_of_mean(meters_.used(), meters_.means(), [&](uint32_t b) { return batches[b]; });
  const double below = t_quantile(meters_.used(), meters_.means()) * std::hypot(own, bias_error);
  const CrossReading cross =
      cross_reading(meters_, {by_half_[0].between(before, up_to), by_half_[1].between(before, up_to)});
  return {std::min(value - below, cross.value - cross.above), std::max(value + below, cross.value + cross.above)};
}

namespace {

// Of both halves. Its meters, too, are without offsets.
class AllRanks {
 public:
  explicit AllRanks(MeterBatches of) : upper_(of.negative()), lower_(std::move(of)) {}
  Interval interval_at(double share) const { return interval(lower_.rank_at(share)); }
  // Of the weight, what is from the first rank on whose interval's end is not below the threshold. Intervals rise with
  // the rank.
  double share_above(double threshold, double Interval::*end) const {
    size_t first = 0, last = lower_.count();
    while (first < last) {
      const size_t middle = first + (last - first) / 2;
      if (interval(middle).*end < threshold)
        first = middle + 1;
      else
        last = middle;
    }
    return lower_.share_from(first);
  }

 private:
  Interval interval(size_t rank) const {
    if (2 * rank < lower_.count()) return lower_.interval(rank);
    const Interval i = upper_.interval(upper_.count() - 1 - rank);
    return lower_.used() < min_batches_of_interval ? i : Interval{-i.high, -i.low};
  }
  LowerRanks upper_, lower_;  // upper_: of the negative
};

// The true values lie above those that are moved down by their offsets and noise, whatever that makes of their order,
// and below those that are moved up.
template <class Ranks, class Of>
Interval between_moved(const MeterBatches& meters, const Of& of) {
  if (meters.used() < min_batches_of_interval) return {};
  Interval out;  // one after the other: of many meters they are gigabytes
  out.low = of(Ranks(meters.moved(-1)), &Interval::low);
  out.high = of(Ranks(meters.moved(1)), &Interval::high);
  return out;
}

}  // namespace

namespace {

bool is_one(const MeterBatches& meters) { return meters.count() == 1 && meters.stated_bound() >= 0; }

Interval interval_of_one(const MeterBatches& meter) {
  return {std::max(0.0, meter.value(0) - meter.stated_bound()), meter.value(0) + meter.stated_bound()};
}

}  // namespace

Known percentile(const MeterBatches& meters, double share) {
  if (is_one(meters) && meters.used() >= min_batches_of_interval) return {meters.value(0), interval_of_one(meters)};
  const MeterOrder order(meters);
  return {meters.value(order.meters[order.rank_at(share)]),
          between_moved<AllRanks>(meters, [&](const AllRanks& r, auto end) { return r.interval_at(share).*end; })};
}

Known share_above(const MeterBatches& meters, double threshold) {
  double above = 0, all = 0;
  for (size_t m = 0; m < meters.count(); ++m) {
    all += meters.weight(m);
    above += meters.value(m) >= threshold ? meters.weight(m) : 0;
  }
  Known out{above / all, between_moved<AllRanks>(meters, [&](const AllRanks& r, auto end) {
              return r.share_above(threshold, end);
            })};
  if (meters.used() >= min_batches_of_interval)  // but for rounding they hold it
    out.interval = {std::min(out.interval.low, out.value), std::max(out.interval.high, out.value)};
  return out;
}

namespace {

// Of one meter least, largest and mean are the same number, and so are their intervals.
void add_interval_of_one(const MeterBatches& meter, ups_meter_statistics& s) {
  const Interval i = interval_of_one(meter);
  s.min_low_lx = s.max_low_lx = s.percentile_5_low_lx = i.low;
  s.min_high_lx = s.max_high_lx = s.percentile_5_high_lx = i.high;
  if (!(s.mean_lx > 0) || s.mean_error_bound_lx > 0.5 * s.mean_lx) return;
  s.uniformity_low = s.uniformity_high = s.diversity_low = s.diversity_high = 1;
}

void add_intervals(const MeterBatches& meters, ups_meter_statistics& s) {
  const auto positive = [](Interval i) { return Interval{std::max(0.0, i.low), std::max(0.0, i.high)}; };
  const auto fifth_of = [](const LowerRanks& ranks, auto end) { return ranks.interval(ranks.rank_at(0.05)).*end; };
  const Interval least = positive(minimum_interval(meters)),
                 fifth = positive(between_moved<LowerRanks>(meters, fifth_of)),
                 most = minimum_interval(meters.negative());
  s.min_low_lx = least.low, s.min_high_lx = least.high;
  s.max_low_lx = std::max(0.0, -most.high), s.max_high_lx = -most.low;
  s.percentile_5_low_lx = fifth.low, s.percentile_5_high_lx = fifth.high;
  if (!(s.mean_lx > 0) || s.mean_error_bound_lx > 0.5 * s.mean_lx) return;  // first order is not enough
  const MeterBatches relative = meters.over_mean();
  const Interval uniformity = positive(minimum_interval(relative)), peak = minimum_interval(relative.negative());
  s.uniformity_low = uniformity.low, s.uniformity_high = std::min(1.0, uniformity.high);
  s.diversity_low = -peak.low > 0 ? std::min(1.0, uniformity.low / -peak.low) : 0;
  s.diversity_high = -peak.high > 0 ? std::min(1.0, uniformity.high / -peak.high) : 1;
}

// Of all meters together: what few paths have found of one of them is found by the others' batches. The mean of one is
// that one.
void add_mean(const MeterBatches& meters, uint32_t passes, bool known, ups_meter_statistics& s) {
  double values[batch_count] = {}, biases[batch_count] = {};
  for (uint32_t b = 0; b < meters.used(); ++b) {
    values[b] = meters.mean_of_batch(b) * visits_of_batch(passes, b);
    biases[b] = meters.bias_of_batch(b) * visits_of_batch(passes, b);
  }
  Spread value = meters.means() == 2 ? spread_of_halves(values, passes) : spread(values, passes);
  Spread bias = spread(biases, passes);
  s.mean_bias_lx = bias.mean;
  if (const double told = meters.told_bias(); std::abs(told) > std::abs(bias.mean)) bias.mean = told;
  if (value.standard_error < 0) return;
  value.standard_error = std::sqrt(std::pow(value.standard_error, 2) + meters.choice_variance());
  if (known) s.mean_standard_error_lx = value.standard_error;
  const double offset = std::abs(bias.mean),
               noise = known ? double(error_bound(value, bias, passes, meters.means())) - offset : 0;
  const NarrowLight caustic = meters.caustic();
  s.mean_error_bound_lx = meters.unfound() + offset + std::abs(caustic.shift) + std::hypot(noise, caustic.chance);
  if (is_one(meters)) s.mean_error_bound_lx = meters.stated_bound();
}

}  // namespace

ups_meter_statistics meter_statistics(const MeterBatches& meters, uint32_t passes, bool known) {
  ups_meter_statistics s{};
  s.struct_size = sizeof s;
  s.mean_lx = s.min_lx = s.max_lx = s.mean_standard_error_lx = s.mean_error_bound_lx = s.percentile_5_lx = -1;
  s.min_low_lx = s.min_high_lx = s.max_low_lx = s.max_high_lx = s.uniformity_low = s.uniformity_high = -1;
  s.percentile_5_low_lx = s.percentile_5_high_lx = s.diversity_low = s.diversity_high = -1;
  s.uniformity = s.diversity = -1;
  if (meters.count() == 0) return s;
  s.mean_lx = meters.mean();
  {
    const MeterOrder order(meters);
    s.min_lx = meters.value(order.meters.front());
    s.max_lx = meters.value(order.meters.back());
    s.percentile_5_lx = meters.value(order.meters[order.rank_at(0.05)]);
  }
  s.uniformity = s.mean_lx > 0 ? s.min_lx / s.mean_lx : 0;
  s.diversity = s.max_lx > 0 ? s.min_lx / s.max_lx : 0;
  add_mean(meters, passes, known, s);
  if (meters.used() < min_batches_of_interval) return s;
  if (is_one(meters))
    add_interval_of_one(meters, s);
  else
    add_intervals(meters, s);
  return s;
}

}  // namespace ups
