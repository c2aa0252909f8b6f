// See progress.h. The end that a target brings is a random one; what is told is its expectation, given what is known.
// So neither the time left nor the fraction has a drift of its own that a later look would have to take back.
#include "render/progress.h"

namespace ups {

namespace {

// Standard deviation of one look's logarithm about the trend: 16 batches know a standard error to 18 %, half of which
// the trend has taken in.
constexpr double look_deviation = 0.1;
constexpr double trend_weight = 0.5;   // of the last look
constexpr double least_error = 1e-9;   // 0 has no logarithm

double normal_cumulative(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

}  // namespace

void ProgressEstimate::add_iterations(double iterations, double elapsed_s) {
  iterations_ = iterations;
  elapsed_s_ = elapsed_s;
  update();
}

void ProgressEstimate::add_look(double iterations, double error) {
  look_ = iterations;
  next_look_ = rule_.next(iterations);
  if (error < 0) return;  // not known yet
  passed_ = error <= limits_.target ? passed_ + 1 : 0;
  const double found = std::log(std::max(error, least_error)) + 0.5 * std::log(iterations);
  trend_ = has_trend_ ? trend_ + trend_weight * (found - trend_) : found;
  has_trend_ = true;
  if (limits_.target > 0) end_ = target_is_met() ? iterations : expected_end();
  update();
}

// Iterations in all. Noise falls as 1 / sqrt(n); each look to come is below the target with the chance that the trend
// gives it.
double ProgressEstimate::expected_end() const {
  double expected = 0, alive = 1, passed = passed_ > 0 ? 1 : 0;  // passed: of what is alive, with its last look below
  double look = next_look_;
  for (int i = 0; i < 500 && alive > 1e-4; ++i, look = rule_.next(look)) {
    const double error = trend_ - 0.5 * std::log(look);
    const double chance = normal_cumulative((std::log(std::max(limits_.target, least_error)) - error) / look_deviation);
    const double end = look >= rule_.least() ? passed * chance : 0;
    expected += end * look;
    passed = alive * chance - end;
    alive -= end;
  }
  return expected + alive * look;
}

void ProgressEstimate::update() {
  const double seconds = seconds_per_iteration();
  double remaining = -1;
  const auto consider = [&](double left) {
    left = std::max(left, 0.0);
    remaining = remaining < 0 ? left : std::min(remaining, left);
  };
  if (limits_.time_s > 0) consider(limits_.time_s - elapsed_s_);
  if (limits_.iterations > 0 && iterations_ > 0) consider(seconds * (limits_.iterations - iterations_));
  if (end_ > 0 && iterations_ > 0) consider(seconds * (end_ - iterations_));
  remaining_s_ = remaining;
  if (remaining >= 0 && elapsed_s_ > 0) fraction_ = std::max(fraction_, elapsed_s_ / (elapsed_s_ + remaining));
}

}  // namespace ups
