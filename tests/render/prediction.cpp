// Predictions of simulated renders whose truth is known: meters with noise of rays, noise of merging and bias, read from
// 16 batches as the accumulator reads them.
#include "render/prediction.h"

#include <gtest/gtest.h>

#include <random>

#include "render/progress.h"
#include "render/spread.h"

namespace {

using namespace ups;

constexpr double alpha = 2.0 / 3;

// Of one iteration, relative to what the meters read; merging's at the first radius.
struct Room {
  const char* name;
  size_t meters;
  double noise, merge_noise, bias;  // the first meter has all of the bias, the last one a tenth
};

struct Render {
  std::vector<double> looks, errors;
  std::vector<Prediction> predictions;  // one a look, as far as asked for
};

// Looks up to `most` iterations; predictions at each look up to `predict_to`.
Render simulate(const Room& room, ups_criterion criterion, double most, double predict_to, uint32_t seed) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  struct Sums {
    double value[batch_count] = {}, bias[batch_count] = {};
  };
  std::vector<Sums> sums(room.meters);
  Render all;
  Prediction prediction(criterion, alpha);
  const TargetRule rule(1);
  double look = rule.first();
  for (double n = 1; n <= most; ++n) {
    const double r2 = std::pow(n, alpha - 1), merge_noise = room.merge_noise / std::sqrt(r2);
    for (size_t m = 0; m < room.meters; ++m) {
      const double bias = room.bias * r2 * (1 - 0.9 * double(m) / double(room.meters));
      Sums& s = sums[m];
      s.value[size_t(n - 1) % batch_count] += 1 + bias + room.noise * normal(random) + merge_noise * normal(random);
      s.bias[size_t(n - 1) % batch_count] += bias + 2 * merge_noise * normal(random);
    }
    if (n < look) continue;
    look = rule.next(n);
    std::vector<MeterError> meters;
    std::vector<double> errors;
    double mean = 0;
    for (const Sums& s : sums) {
      const Spread value = spread(s.value, uint32_t(n)), bias = spread(s.bias, uint32_t(n));
      const ups_meter_reading r{float(value.mean), float(value.standard_error), float(bias.mean),
                                error_bound(value, bias, uint32_t(n)), 0, 0};
      meters.push_back(meter_error(r, 0.05, uint32_t(n)));
      errors.push_back(meters.back().error());
      mean += errors.back() / double(room.meters);
    }
    all.looks.push_back(n);
    all.errors.push_back(criterion == UPS_CRITERION_MEAN   ? mean
                         : criterion == UPS_CRITERION_P95  ? quantile(errors, 0.95)
                         : criterion == UPS_CRITERION_MEDIAN ? quantile(errors, 0.5)
                                                           : *std::max_element(errors.begin(), errors.end()));
    if (n > predict_to) continue;
    prediction.add_look({n, n, all.errors.back()}, std::move(meters));
    all.predictions.push_back(prediction);
  }
  return all;
}

// Where a curve of looks first meets the target, between looks on straight lines of logarithms; 0: never.
double crossing(const std::vector<double>& looks, const std::vector<double>& errors, double target) {
  for (size_t i = 1; i < looks.size(); ++i)
    if (errors[i] <= target) {
      if (errors[i - 1] <= target) return looks[i - 1];
      const double f = std::log(errors[i - 1] / target) / std::log(errors[i - 1] / errors[i]);
      return looks[i - 1] * std::pow(looks[i] / looks[i - 1], f);
    }
  return 0;
}

TEST(PredictionExplore, All) {
  const Room rooms[] = {{"rays", 25, 0.3, 0, 0},      {"one", 1, 0.3, 0, 0},          {"merging", 25, 0, 0.1, 0},
                        {"caustic", 25, 0.02, 0.02, 0.5}, {"both", 25, 0.3, 0.05, 0.1}, {"many", 400, 0.1, 0.1, 0}, {"onebias", 1, 0.02, 0.02, 0.5}, {"grow",25,0.3,0.02,0.2}};
  for (const Room& room : rooms)
    for (const ups_criterion criterion : {UPS_CRITERION_WORST, UPS_CRITERION_P95, UPS_CRITERION_MEAN, UPS_CRITERION_MEDIAN}) {
      const size_t seeds = room.meters > 100 ? 20 : 100;
      const double quarter = 127;  // a look
      std::vector<Render> all;
      std::vector<double> mean;
      for (size_t s = 0; s < seeds; ++s) {
        all.push_back(simulate(room, criterion, 2500, 160, uint32_t(s + 1)));
        mean.resize(all[0].errors.size());
        for (size_t i = 0; i < mean.size(); ++i) mean[i] += std::log(all.back().errors[i]) / double(seeds);
      }
      for (double& e : mean) e = std::exp(e);
      size_t at = 0;
      while (all[0].looks[at] < quarter - 8) ++at;
      const double n0 = all[0].looks[at];
      size_t end = 0;
      while (all[0].looks[end] < 4 * n0) ++end;
      const double target = mean[end], real = all[0].looks[end];
      double within = 0, held = 0, logs = 0, bias = 0, wide = 0, held_run = 0;
      for (const Render& r : all) {
        const auto e = r.predictions[at].expect(target);
        const double run = crossing(r.looks, r.errors, target);
        within += std::abs(std::log(e.iterations / real)) < std::log(1.5);
        held += e.low <= real && (e.high < 0 || e.high >= real);
        held_run += e.low <= run && (e.high < 0 || e.high >= run);
        logs += std::log(e.iterations / real);
        bias += e.by_bias;
        wide += e.high > 0 ? std::log(e.high / e.low) : 10;
      }
      const double k = double(seeds);
      std::printf("%-8s %d: n %g to %g error %.4f within %.2f  covers truth %.2f run %.2f  mean log %.2f bias %.2f width x%.2f\n", room.name,
                  criterion, n0, real, target, within / k, held / k, held_run / k, logs / k, bias / k, std::exp(wide / k));
    }
}

}  // namespace
