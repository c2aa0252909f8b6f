// When will the error be so small? From looks at the error on the way, told in iterations, with an interval. Kept by
// the job, which asks it for the end of a render.
#pragma once
#include <cstdint>
#include <vector>

#include "ups/ups_render.h"

namespace ups {

inline constexpr double prediction_horizon_s = 1e7;  // what would take longer is not told

// The relative error of one meter, bound / max(E, floor), apart by what makes it fall: noise + bias + unfound.
struct MeterError {
  float noise = 0, bias = 0;
  float merged = 0;  // share of noise^2 that merging makes: it falls with the radius too
  float deviations = 0;  // of the estimated bias from 0, in its own standard errors
  float halves = 0;  // log_ratio_of_halves() of the batches
  float unfound = 0;  // bounds on what few paths or none have found
  float error() const { return noise + bias + unfound; }
};
// visits: for the quantile that is in the bound, which is known. unfound_lx: what is added to it.
MeterError meter_error(const ups_meter_reading& reading, double unfound_lx, double floor, uint32_t visits);

// The model: with r^2 ~ n^(alpha - 1) (Knaus, Zwicker 2011), what is estimated without merging has noise^2 ~ 1 / n,
// merging noise^2 ~ n^-alpha and bias ~ n^(alpha - 1); bounds on what is unfound fall as 1 / n. How much of each meter's
// error is which is known from its batches; a common factor, and a common exponent beside the model's with that as prior
// knowledge, are fitted to all looks.
class Prediction {
 public:
  // ups_criterion of the render, resolved: not DEFAULT; alpha of the radius schedule.
  Prediction(ups_criterion criterion, double alpha) : criterion_(criterion), alpha_(alpha) {}

  struct Look {
    double iterations, elapsed_s, error;
  };
  // meters: of the criterion; empty: their errors are noise alone.
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
  Model model(double factor) const;  // of the criterion, at so many times the last look's iterations
  void fit();

  ups_criterion criterion_;
  double alpha_;
  std::vector<Look> looks_;
  std::vector<MeterError> parts_;  // of the last look: what the criterion is found from
  double excess_ = 0;  // of the last look: variance by chance of stated noises' logarithms, less that of Gaussian ones
  double log_mean_ = 0, log_variance_ = 0;  // of the noises that meters state
  double exponent_deviation_ = 0;  // of the fitted exponent, before any look is fitted
  std::vector<LogError> curve_;    // from the last look on, in equal steps of the logarithm of iterations
  std::vector<float> bias_share_;  // beside curve_
};

}  // namespace ups
