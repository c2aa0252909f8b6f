// When will the error be so small? From looks at the error on the way, told in iterations, with an interval. Kept by
// the job, which asks it for the end of a render.
#pragma once
#include <cstdint>
#include <vector>

#include "ups/ups_render.h"

namespace ups {

inline constexpr double prediction_horizon_s = 1e7;  // what would take longer is not told

// The error bound of one meter or pixel, apart by what makes it fall: noise + bias + unfound. In lx or cd/m^2, or
// relative: bound / max(E, floor).
struct MeterError {
  float noise = 0, bias = 0;
  float merged = 0;  // share of noise^2 that merging makes: it falls with the radius too
  float deviations = 0;  // of the estimated bias from 0, in its own standard errors
  float halves = 0;  // log_ratio_of_halves() of the batches
  float unfound = 0;  // bounds on what few paths or none have found
  float paths = 0;    // that have found what `unfound` bounds
  float of_bias = 0;  // share of noise^2 that is how little bias is known: it falls as bias does
  // A disc of photons is the widest there is, which does not shrink as long as its bias is little; or a narrower one.
  bool widest = false, narrower = false;
  bool is_disc() const { return widest || narrower; }
  uint32_t visits = 0;  // by which the batches' quantile is in the noise; 0: whatever their number, it is the same
  float error() const { return noise + bias + unfound; }
  MeterError scaled(double scale) const;
  void keep_of_bias(double share);  // the rest counts as noise
  // Of few batches the quantile is large. What it will be after so many times the visits, over what it is.
  double quantile_ratio(double factor) const;
  // What is left by then of merging's noise^2 and of bias, with r^2 ~ n^(alpha - 1) from where the disc shrinks. stays:
  // up to so many times the visits the widest disc does, as far as other meters tell.
  struct Left {
    double noise2, bias;
  };
  Left left_of_merging(double factor, double alpha, double stays) const;
};

// Estimated bias that may be noise counts as noise: |b| max(0, 1 - threshold / z^2) remains (Breiman 1995, the
// nonnegative garrote), so that what chance alone makes of b goes on falling as noise does.
void demote_bias(MeterError& error, double threshold = 2);

// The mean of many errors, part by part. Their bias is not demoted again.
class MeanError {
 public:
  void add(const MeterError& error);
  MeterError mean() const;

 private:
  double noise_ = 0, merged_ = 0, widest_ = 0, narrower_ = 0, of_bias_ = 0;
  double bias_ = 0, unfound_ = 0, paths_ = 0, count_ = 0;
  uint32_t visits_ = 0;
};

// The model: with r^2 ~ n^(alpha - 1) (Knaus, Zwicker 2011), what is estimated without merging has noise^2 ~ 1 / n,
// merging noise^2 ~ n^-alpha and bias ~ n^(alpha - 1), once the disc is narrower than the widest that there is. Bounds
// on what none of n paths have found fall as 1 / n; where k have, as u(k) / n with Poisson's limit u, and k grows with
// n. How much of each meter's error is which is known from its batches; a common factor, and a common exponent beside
// the model's with that as prior knowledge, are fitted to all looks.
class Prediction {
 public:
  // ups_criterion of the render, resolved: not DEFAULT; alpha of the radius schedule.
  Prediction(ups_criterion criterion, double alpha) : criterion_(criterion), alpha_(alpha) {}

  struct Look {
    double iterations, elapsed_s, error;
  };
  // meters: of the criterion, or one that stands for all; empty: their errors are noise alone.
  void add_look(const Look& look, std::vector<MeterError> meters);
  bool is_known() const { return !looks_.empty(); }

  struct Expected {  // iterations; -1: never
    double iterations = -1, low = -1, high = -1;
    bool by_bias = false;
    const Look* reached = nullptr;  // the look that found the target met, as all after it did
  };
  Expected expect(double target) const;
  // Expected logarithm of what a look finds then, and its standard deviation; iterations: not before the last look's.
  struct LogError {
    double mean, deviation;
  };
  LogError log_error(double iterations) const;

 private:
  struct Model {
    double error, bias_share;
  };
  void reduce(std::vector<MeterError>&& meters);
  void find_chance(const std::vector<MeterError>& meters);
  void find_stay(const std::vector<MeterError>& meters);
  Model model(double factor) const;  // of the criterion, at so many times the last look's iterations
  void fit();

  ups_criterion criterion_;
  double alpha_;
  std::vector<Look> looks_;
  std::vector<MeterError> parts_;  // of the last look: what the criterion is found from
  double meters_ = 0;  // how many were looked at last
  double stays_ = 1;   // see MeterError::left_of_merging
  double excess_ = 0;  // of the last look: variance by chance of stated noises' logarithms, less that of Gaussian ones
  double log_mean_ = 0, log_variance_ = 0;  // of the noises that meters state
  double exponent_deviation_ = 0;  // of the fitted exponent, before any look is fitted
  std::vector<LogError> curve_;    // from the last look on, in equal steps of the logarithm of iterations
  std::vector<float> bias_share_;  // beside curve_
};

}  // namespace ups
