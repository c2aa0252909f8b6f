// Do the intervals of a set's extremes, uniformity, diversity, percentiles and shares above a threshold cover the true
// values, whatever the field and however the meters' noise goes together?
#include "render/meter_ratios.h"

#include <gtest/gtest.h>

#include <functional>
#include <numeric>
#include <random>

namespace {

using namespace ups;

constexpr int repetitions = 1000;

struct Field {
  const char* name;
  size_t meters;
  std::function<double(size_t)> truth;  // in standard errors of a reading, about 200
  std::function<double(size_t)> weight = [](size_t) { return 1.0; };
};

struct Weighted {
  double value, weight;
};
// Of the weight, the share of values from `threshold` on; and the value that a share of it is below.
double share_from(const std::vector<Weighted>& all, double threshold) {
  double sum = 0, above = 0;
  for (const Weighted& w : all) sum += w.weight, above += w.value >= threshold ? w.weight : 0;
  return above / sum;
}
double weighted_quantile(std::vector<Weighted> all, double share) {
  std::sort(all.begin(), all.end(), [](const Weighted& a, const Weighted& b) { return a.value < b.value; });
  for (const Weighted& w : all)
    if (1 - share_from(all, std::nextafter(w.value, INFINITY)) > share + 1e-12) return w.value;
  return all.back().value;
}

struct Coverage {
  double minimum = 0, maximum = 0, uniformity = 0, diversity = 0, percentile = 0, median = 0, high = 0, share = 0,
         mean = 0;
};

bool holds(double low, double high, double truth) { return low <= truth && truth <= high; }

// common: share of the variance that all meters have together. halves: how far even and odd batches of every other meter
// are off, to either side, as discs of different width are.
Coverage coverage_of(const Field& field, double common, double halves, std::mt19937_64& random) {
  std::normal_distribution<double> normal;
  std::vector<double> truth;
  for (size_t m = 0; m < field.meters; ++m) truth.push_back(200 + field.truth(m));
  std::vector<Weighted> all;
  for (size_t m = 0; m < field.meters; ++m) all.push_back({truth[m], field.weight(m)});
  const double least = *std::min_element(truth.begin(), truth.end()),
               most = *std::max_element(truth.begin(), truth.end()), fifth = weighted_quantile(all, 0.05),
               median = weighted_quantile(all, 0.5), high = weighted_quantile(all, 0.9);
  // A threshold within the noise of many meters, where there are many alike.
  const double threshold = median + 0.7;
  const double true_share = share_from(all, threshold);
  double true_mean = 0, weights = 0;
  for (const Weighted& w : all) true_mean += w.weight * w.value, weights += w.weight;
  true_mean /= weights;
  Coverage c;
  for (int r = 0; r < repetitions; ++r) {
    double shared[batch_count], batch[batch_count], value;
    const double no_bias[batch_count] = {};
    for (double& s : shared) s = 4 * std::sqrt(common) * normal(random);
    MeterBatches meters(batch_count);
    for (const Weighted& w : all) {
      value = 0;
      const bool differ = halves > 0 && meters.count() % 2 == 0;
      const double off = differ ? halves * normal(random) : 0;
      for (uint32_t b = 0; b < batch_count; ++b) {
        batch[b] = w.value + shared[b] + (b % 2 ? off : -off) + 4 * std::sqrt(1 - common) * normal(random);
        value += batch[b] / batch_count;
      }
      meters.add({value, {0, 0}, 0, w.weight, true, differ}, batch, no_bias);
    }
    const ups_meter_statistics s = meter_statistics(meters, 3 * batch_count, true);
    c.minimum += holds(s.min_low_lx, s.min_high_lx, least) / double(repetitions);
    c.maximum += holds(s.max_low_lx, s.max_high_lx, most) / double(repetitions);
    c.uniformity += holds(s.uniformity_low, s.uniformity_high, least / true_mean) / double(repetitions);
    c.percentile += holds(s.percentile_5_low_lx, s.percentile_5_high_lx, fifth) / double(repetitions);
    c.diversity += holds(s.diversity_low, s.diversity_high, least / most) / double(repetitions);
    const auto at = [&](double share) { return percentile(meters, share).interval; };
    c.median += holds(at(0.5).low, at(0.5).high, median) / double(repetitions);
    c.high += holds(at(0.9).low, at(0.9).high, high) / double(repetitions);
    const auto [share_read, share] = share_above(meters, threshold);
    c.share += holds(share.low, share.high, true_share) / double(repetitions);
    c.mean += (std::abs(s.mean_lx - true_mean) <= s.mean_error_bound_lx) / double(repetitions);
    if (r > 0) continue;
    EXPECT_LE(s.min_low_lx, s.min_lx);
    EXPECT_LE(s.min_lx, s.min_high_lx);
    EXPECT_LE(s.percentile_5_low_lx, s.percentile_5_lx);
    EXPECT_LE(s.max_low_lx, s.max_lx);
    EXPECT_LE(s.uniformity_high, 1);
    EXPECT_LE(s.diversity_low, s.diversity);
    EXPECT_LE(share.low, share_read);
    EXPECT_GE(share.high, share_read);
  }
  return c;
}

struct Few {
  double value, bound;
};
// Ninety of 20 to 100 lx, known to 0.1 lx, and some that few paths found.
MeterBatches beside(const std::vector<Few>& few) {
  const double no_bias[batch_count] = {};
  MeterBatches meters(batch_count);
  const auto add = [&](double value, double bound, bool known) {
    double batch[batch_count];
    for (uint32_t b = 0; b < batch_count; ++b) batch[b] = value + (known ? (b % 2 ? 0.4 : -0.4) : 0);
    meters.add({value, {0, 0}, bound, 1, known}, batch, no_bias);
  };
  for (int m = 0; m < 90; ++m) add(20 + 80.0 / 89 * m, 0, true);
  for (const Few& f : few) add(f.value, f.bound, false);
  return meters;
}

// Ten that no path has found may all be above a threshold that their bounds hold, or, of a bright one, below it: their
// ranks do not say so.
TEST(MeterStatistics, SharesHoldWhatFewPathsFound) {
  const auto share = [](const std::vector<Few>& few) { return share_above(beside(few), 30).interval; };
  const Interval surely = share(std::vector<Few>(10, {0, 1})), dark = share(std::vector<Few>(10, {0, 50})),
                 bright = share(std::vector<Few>(10, {90, 80}));
  EXPECT_NEAR(surely.low, 0.785, 0.02);
  EXPECT_NEAR(surely.high, 0.785, 0.02);
  EXPECT_GE(dark.high, surely.low + 0.1);
  EXPECT_NEAR(dark.low, surely.low, 0.02);
  EXPECT_LE(bright.low, surely.low);
  EXPECT_GE(bright.high, surely.high + 0.1);
  const Interval one = share({{59.9, 80}});  // in the middle: it alone may be anywhere
  EXPECT_GE(one.low, 0.85);
  EXPECT_LE(one.high, 0.89);
}

// Without noise the share is all there is: rounding leaves no value outside its interval.
TEST(MeterStatistics, AnExactShareIsWithinItsInterval) {
  const double no_bias[batch_count] = {};
  double batch[batch_count];
  MeterBatches meters(batch_count);
  for (int m = 0; m < 10; ++m) {
    std::fill(batch, batch + batch_count, 10.0 * m);
    meters.add({10.0 * m, {0, 0}, 0}, batch, no_bias);
  }
  for (double threshold = 5; threshold < 95; threshold += 10) {
    const auto [value, interval] = share_above(meters, threshold);
    EXPECT_NEAR(value, (95 - threshold) / 100, 1e-12);
    EXPECT_LE(interval.low, value);
    EXPECT_GE(interval.high, value);
    EXPECT_NEAR(interval.high - interval.low, 0, 1e-12);
  }
}

// So do percentiles: ten bright ones may be the darkest, ten dark ones above the median. What is known keeps its noise.
TEST(MeterStatistics, PercentilesHoldWhatFewPathsFound) {
  const MeterBatches bright = beside(std::vector<Few>(10, {90, 85})), dark = beside(std::vector<Few>(10, {0, 80}));
  const ups_meter_statistics s = meter_statistics(bright, batch_count, true);
  EXPECT_LE(s.percentile_5_low_lx, 5);
  EXPECT_NEAR(s.percentile_5_high_lx, s.percentile_5_lx, 1.5);
  EXPECT_EQ(percentile(bright, 0.05).interval.low, s.percentile_5_low_lx);
  const Known median = percentile(dark, 0.5);
  EXPECT_NEAR(median.value, 55.5, 1);
  EXPECT_GE(median.interval.high, 64.8);  // where it is with those at 79
  EXPECT_NEAR(median.interval.low, median.value, 1.5);
}

// What neighbours and profiles tell of each meter's bias is told of the mean, too, where its own fits show less.
TEST(MeterStatistics, TheMeanHasTheBiasThatIsToldOfItsMeters) {
  const double no_bias[batch_count] = {};
  for (const double told : {0.0, 5.0, -5.0}) {
    double batch[batch_count];
    for (uint32_t b = 0; b < batch_count; ++b) batch[b] = 100 + (b % 2 ? 0.4 : -0.4);
    MeterBatches meters(batch_count);
    for (int m = 0; m < 10; ++m) meters.add({100, {told, 1}, 0}, batch, no_bias);
    const double bound = meter_statistics(meters, batch_count, true).mean_error_bound_lx;
    EXPECT_GE(bound, std::abs(told));
    EXPECT_LE(bound, std::abs(told) + 1);
    MeterBatches surround(batch_count);
    std::fill(batch, batch + batch_count, 200.0);
    surround.add({200, {0, 0}, 0}, batch, no_bias);
    const Ratio r = ratio_of_means(meters, surround);
    EXPECT_LE(r.interval.low, 0.5 - std::abs(told) / 200);
    EXPECT_GE(r.interval.high, 0.5 + std::abs(told) / 200);
  }
}

// Fields in which the least reading is one of many alike, of a slope, of a dark corner, or alone. 1000 renders of each:
// standard deviation of a share of 95 % 0.7 %; one that truly is 95 % is found outside 92.5 to 97.5 % once in 2000. So
// intervals that cover less than 91 % would be found, and, were they of the plain kind (min +- t s), at once: in a flat
// field of 100 they cover 30 %. Ends that hold for any field are never both at their limit in a flat one: up to 100 %.
TEST(MeterStatistics, IntervalsCoverTheTruth) {
  const Field fields[] = {{"flat", 100, [](size_t) { return 0.0; }},
                          {"flat, few", 4, [](size_t) { return 0.0; }},
                          {"slope, shallow", 100, [](size_t m) { return 0.05 * double(m); }},
                          {"slope", 100, [](size_t m) { return 0.5 * double(m); }},
                          {"slope, steep", 25, [](size_t m) { return 4.0 * double(m); }},
                          {"corner", 60, [](size_t m) { return m < 6 ? 0.0 : 20; }},
                          {"one alone", 60, [](size_t m) { return m < 1 ? 0.0 : 10; }},
                          {"slope of areas", 100, [](size_t m) { return 0.5 * double(m); },
                           [](size_t m) { return m % 7 == 3 ? 12 : 0.5 + double(m % 3); }},
                          {"steps", 60, [](size_t m) { return m < 20 ? 0.0 : double(m % 20); }},
                          {"one large area", 60, [](size_t m) { return m < 20 ? 0.0 : double(m % 20); },
                           [](size_t m) { return m == 30 ? 40.0 : 1; }}};
  std::mt19937_64 random(11);
  for (const Field& f : fields)
    for (const auto& [common, halves] : {std::pair{0.0, 0.0}, {0.6, 0.0}, {0.0, 0.5}}) {
      const Coverage c = coverage_of(f, common, halves, random);
      const std::string what =
          std::string(f.name) + ", common " + std::to_string(common) + ", halves " + std::to_string(halves);
      RecordProperty(what, std::to_string(c.minimum));
      std::printf("%-22s min %.3f max %.3f U0 %.3f Ud %.3f p5 %.3f p50 %.3f p90 %.3f share %.3f mean %.3f\n",
                  what.c_str(), c.minimum, c.maximum, c.uniformity, c.diversity, c.percentile, c.median, c.high,
                  c.share, c.mean);
      for (const double share : {c.minimum, c.maximum, c.uniformity, c.diversity, c.percentile, c.median, c.high,
                                 c.share})
        EXPECT_GE(share, 0.925) << what;
      EXPECT_NEAR(c.mean, 0.95, 0.025) << what;
    }
}

// One meter: what chose it says nothing of it. Means of 1 to 16: of both halves squared deviations add up to 336.
TEST(MeterStatistics, TheLeastOfOneIsItself) {
  double batch[batch_count];
  const double no_bias[batch_count] = {};
  std::iota(batch, batch + batch_count, 1.0);
  MeterBatches meters(batch_count);
  meters.add({8.5, {0, 0}, 0}, batch, no_bias);
  const Interval i = minimum_interval(meters);
  EXPECT_NEAR(i.low, 8.5 - 2.131 * std::sqrt(340.0 / (16 * 15)), 1e-6);   // 15 degrees of freedom
  EXPECT_NEAR(i.high, 8.5 + 2.145 * std::sqrt(336.0 / (16 * 14)), 1e-6);  // 14: halves have means of their own
}

// Even and odd batches that are biased by another amount each: what they differ in is no noise.
TEST(MeterStatistics, HalvesOfTheirOwnBiasAreNoNoise) {
  double batch[batch_count];
  const double no_bias[batch_count] = {};
  MeterBatches meters(batch_count);
  for (const double off : {0.0, 40.0}) {
    for (uint32_t b = 0; b < batch_count; ++b) batch[b] = 100 + double(b / 2) + (b % 2 ? off : -off);
    meters.add({103.5, {0, 0}, 0, 1, true, off > 0}, batch, no_bias);
  }
  EXPECT_EQ(meters.means(), 2u);
  for (size_t m = 0; m < 2; ++m) {  // 42 about the mean of each half
    EXPECT_NEAR(meters.standard_error(m), std::sqrt(84.0 / (16 * 14)), 1e-5) << m;
    EXPECT_NEAR(meters.bound(m), 2.145 * std::sqrt(84.0 / (16 * 14)), 1e-4) << m;
  }
  meters.widen(7);  // the meter's own, which knows more
  EXPECT_NEAR(meters.bound(1), 7, 1e-5);
  meters.widen(0.5);
  EXPECT_NEAR(meters.bound(1), 2.145 * std::sqrt(84.0 / (16 * 14)), 1e-4);
}

// What a meter knows of its error beyond its batches the mean of a set of one knows, too, and a ratio to it.
TEST(MeterStatistics, TheMeanOfOneMeterIsAsWideAsTheMeter) {
  double batch[batch_count];
  const double no_bias[batch_count] = {};
  for (uint32_t b = 0; b < batch_count; ++b) batch[b] = 100 + (b % 2 ? 4 : -4);
  MeterBatches meters(batch_count);
  meters.add({100, {0, 0}, 0}, batch, no_bias);
  meters.widen(30);
  EXPECT_NEAR(meter_statistics(meters, 32, true).mean_error_bound_lx, 30, 1e-4);
  MeterBatches surround(batch_count);
  std::fill(batch, batch + batch_count, 200.0);
  surround.add({200, {0, 0}, 0}, batch, no_bias);
  const Ratio r = ratio_of_means(meters, surround);
  EXPECT_NEAR(r.interval.low, 0.35, 1e-6);
  EXPECT_NEAR(r.interval.high, 0.65, 1e-6);
}

// Caustics that may be narrower than the discs of nine meters. What is chance of them is independent, and of noise; of discs
// that all find the same photons it adds up, as what narrower discs show does. A ratio to the mean adds it to the meter's own.
TEST(MeterStatistics, NarrowCausticsOfSeveralMetersAreIndependentButWhereDiscsMeet) {
  double batch[batch_count];
  const double no_bias[batch_count] = {};
  for (uint32_t b = 0; b < batch_count; ++b) batch[b] = 100 + (b % 2 ? 1 : -1);
  const double noise = 2.131 * std::sqrt(1.0 / 15);
  for (const uint32_t meet : {1u, 4u, 9u, 100u})
    for (const double shift : {0.0, -2.0}) {
      MeterBatches meters(batch_count, meet);
      for (int m = 0; m < 9; ++m)
        meters.add({100, {0, 0}, 3.5, 1, true, false, 0, {m % 3 ? shift : -shift, 3}, 0.25}, batch, no_bias);
      const double chance = meet == 1 ? 1 : meet == 4 ? 2 : 3, both = std::abs(shift) / 3;
      EXPECT_NEAR(meter_statistics(meters, 32, true).mean_error_bound_lx, 0.25 + both + std::hypot(noise, chance), 1e-3);
      EXPECT_NEAR(meters.over_mean().unfound(0), (3.5 + 0.25 + both + chance) / 100, 1e-6);
    }
}

// A ratio to a mean that is off by more than half of itself is not known to first order; the minimum is known.
TEST(MeterStatistics, AnUnknownMeanGivesNoUniformity) {
  double batch[batch_count];
  const double no_bias[batch_count] = {};
  std::fill(batch, batch + batch_count, 5.0);
  for (const double unfound : {2.0, 3.0}) {
    MeterBatches meters(batch_count);
    for (int m = 0; m < 2; ++m) meters.add({5, {0, 0}, unfound}, batch, no_bias);
    const ups_meter_statistics s = meter_statistics(meters, 32, true);
    EXPECT_EQ(s.uniformity_low >= 0, unfound < 2.5);
    EXPECT_EQ(s.uniformity_high >= 0, unfound < 2.5);
    EXPECT_EQ(s.diversity_low >= 0, unfound < 2.5);
    EXPECT_NEAR(s.min_low_lx, 5 - unfound, 1e-6);
  }
}

// Meters that rise and fall together: their ratio to the mean has no noise.
TEST(MeterStatistics, RatiosLeaveCommonNoiseOut) {
  const double no_bias[batch_count] = {};
  MeterBatches meters(batch_count);
  for (const double scale : {1.0, 3.0}) {
    double batch[batch_count];
    for (uint32_t b = 0; b < batch_count; ++b) batch[b] = scale * (100 + (b % 2 ? 10.0 : -10.0));
    meters.add({scale * 100, {0, 0}, 0}, batch, no_bias);
  }
  const MeterBatches ratios = meters.over_mean();
  for (size_t m = 0; m < 2; ++m) {
    EXPECT_NEAR(ratios.value(m), m ? 1.5 : 0.5, 1e-12);
    EXPECT_NEAR(ratios.standard_error(m), 0, 1e-6);
    for (uint32_t b = 0; b < batch_count; ++b) EXPECT_NEAR(ratios.batch(m, b), m ? 1.5 : 0.5, 1e-6);
  }
}

// Ratios of two sets whose noise goes together in part: the interval covers 95 % (+- 0.7 %; 92.5 to 97.5 % by mistake
// once in 2000), and is as narrow as what they do not share. A ratio off by 1 % of noise of 0.35 % is found at once.
TEST(MeterRatios, IntervalsCoverTheTruth) {
  std::mt19937_64 random(14);
  std::normal_distribution<double> normal;
  double means = 0, single = 0, width = 0;
  for (int r = 0; r < repetitions; ++r) {
    double shared[batch_count];
    for (double& s : shared) s = 1 + 0.1 * normal(random);
    MeterBatches sets[2] = {MeterBatches(batch_count), MeterBatches(batch_count)};
    const double truth[2] = {60, 200}, no_bias[batch_count] = {};
    for (int k = 0; k < 2; ++k)
      for (int m = 0; m < 10; ++m) {
        double batch[batch_count], value = 0;
        for (uint32_t b = 0; b < batch_count; ++b) {
          batch[b] = truth[k] * shared[b] * (1 + 0.01 * normal(random));
          value += batch[b] / batch_count;
        }
        sets[k].add({value, {0, 0}, 0}, batch, no_bias);
      }
    const Ratio of_means = ratio_of_means(sets[0], sets[1]), of_one = ratio_at(sets[0], 3, sets[1], 3);
    means += holds(of_means.interval.low, of_means.interval.high, 0.3) / double(repetitions);
    single += holds(of_one.interval.low, of_one.interval.high, 0.3) / double(repetitions);
    width += (of_one.interval.high - of_one.interval.low) / 2 / double(repetitions);
  }
  EXPECT_NEAR(means, 0.95, 0.025);
  EXPECT_NEAR(single, 0.95, 0.025);
  EXPECT_NEAR(width, 0.3 * std::sqrt(2) * 0.01 / 4 * 2.13, 1e-4);  // and not 5 % of the illuminance
}

// The bias of both counts, with its sign: what both have alike cancels.
TEST(MeterRatios, CommonBiasCancels) {
  double batch[batch_count];
  const double no_bias[batch_count] = {};
  MeterBatches sets[3] = {MeterBatches(batch_count), MeterBatches(batch_count), MeterBatches(batch_count)};
  const double value[3] = {60, 200, 200}, bias[3] = {3, 10, -10};
  for (int k = 0; k < 3; ++k) {
    std::fill(batch, batch + batch_count, value[k]);
    sets[k].add({value[k], {bias[k], 0}, 0}, batch, no_bias);
  }
  const Interval alike = ratio_at(sets[0], 0, sets[1], 0).interval, apart = ratio_at(sets[0], 0, sets[2], 0).interval;
  EXPECT_NEAR(alike.high - alike.low, 0, 1e-12);
  EXPECT_NEAR(apart.high, 0.3 + 0.03, 1e-9);
  EXPECT_NEAR(apart.low, 0.3 - 0.03, 1e-9);
}

// Nothing to divide by, or only noise.
TEST(MeterRatios, AnUnknownDenominatorGivesNoInterval) {
  double batch[batch_count];
  const double no_bias[batch_count] = {};
  MeterBatches light(batch_count), dark(batch_count), vague(batch_count);
  std::fill(batch, batch + batch_count, 5.0);
  light.add({5, {0, 0}, 0}, batch, no_bias);
  vague.add({5, {0, 0}, 3, 1, false}, batch, no_bias);
  std::fill(batch, batch + batch_count, 0.0);
  dark.add({0, {0, 0}, 0}, batch, no_bias);
  EXPECT_EQ(ratio_of_means(light, dark).value, -1);
  EXPECT_EQ(ratio_of_means(light, vague).value, 1);
  EXPECT_EQ(ratio_of_means(light, vague).interval.high, -1);
  EXPECT_NEAR(ratio_of_means(vague, light).interval.high, 1.6, 1e-9);
}

}  // namespace
