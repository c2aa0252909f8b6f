// See progress.h. The end that a target brings is a random one; what is told is its expectation, given what is known.
// So neither the time left nor the fraction has a drift of its own that a later look would have to take back.
#include "render/progress.h"

namespace ups {

namespace {

// Standard deviation of one look's logarithm about its expectation, beside what it has in common with those before: 16
// batches know a standard error to 18 %.
constexpr double look_deviation = 0.1;

double normal_cumulative(double x) { return 0.5 * std::erfc(-x / std::sqrt(2.0)); }

}  // namespace

void ProgressEstimate::add_iterations(double iterations, double elapsed_s) {
  iterations_ = iterations;
  elapsed_s_ = now_s_ = elapsed_s;
  update();
}

void ProgressEstimate::set_rest(double seconds, double elapsed_s) {
  rest_s_ = seconds;
  now_s_ = elapsed_s;
  update();
}

void ProgressEstimate::add_look(double iterations, double error, const Prediction* prediction) {
  look_ = iterations;
  next_look_ = rule_.next(iterations);
  if (error < 0) return;  // not known yet
  passed_ = error <= limits_.target ? passed_ + 1 : 0;
  if (limits_.target > 0 && prediction) end_ = target_is_met() ? iterations : expected_end(*prediction);
  update();
}

// Iterations in all; 0: not known. Each look to come is below the target with the chance that the prediction gives it.
double ProgressEstimate::expected_end(const Prediction& prediction) const {
  double expected = 0, alive = 1, passed = passed_ > 0 ? 1 : 0;  // passed: of what is alive, with its last look below
  double look = next_look_;
  for (int i = 0; i < 500 && alive > 1e-4; ++i, look = rule_.next(look)) {
    const double error = prediction.log_error(look).mean;
    const double chance = normal_cumulative((std::log(limits_.target) - error) / look_deviation);
    const double end = look >= rule_.least() ? passed * chance : 0;
    expected += end * look;
    passed = alive * chance - end;
    alive -= end;
  }
  return alive > 0.5 ? 0 : expected + alive * look;  // most renders like this one would not end within what is foretold
}

void ProgressEstimate::update() {
  const double seconds = seconds_per_iteration();
  double remaining = -1;
  const auto consider = [&](double left) {
    left = std::max(left, 0.0);
    remaining = remaining < 0 ? left : std::min(remaining, left);
  };
  const auto consider_iterations = [&](double end) { consider(std::max(0.0, seconds * (end - iterations_)) + rest_s_); };
  if (limits_.time_s > 0) consider(limits_.time_s - now_s_);
  if (limits_.iterations > 0 && iterations_ > 0) consider_iterations(limits_.iterations);
  // Where it has passed before its look was taken, that may still tell of another.
  const bool is_ahead = end_ > iterations_ || target_is_met();
  if (end_ > 0 && is_ahead && iterations_ > 0 && seconds * end_ < prediction_horizon_s)
    consider_iterations(end_);
  remaining_s_ = remaining;
  if (remaining >= 0 && now_s_ > 0) fraction_ = std::max(fraction_, now_s_ / (now_s_ + remaining));
}

}  // namespace ups
