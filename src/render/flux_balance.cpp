// See flux_balance.h.
#include "render/flux_balance.h"

#include <cmath>

#include "base/text.h"
#include "scene/check.h"

namespace ups {

namespace {

// Floats all along: what an emitter's samples carry, each edge's flux. Measured: 6e-8 at the most.
constexpr double rounding = 1e-6;
// Of the games' variance by the largest one, where the batches' spread is believed: each has the like of it, then.
constexpr double largest_share_of_games = 1e-2;

// What a sum of independent or fair games strays from its mean, but for one in renders_per_false_alarm: x with
// 2 exp(-x^2 / (2 (v + b x / 3))) = a third of that, as three such sums are looked at (Freedman 1975, Theorem 1.6; of
// independent terms Bernstein's inequality). b: the most that one game may bring. Of many small games these are 4.7
// standard errors, which Gaussian noise passes in 3 of 10^6.
double chance(double variance, double largest) {
  const double l = std::log(6 * renders_per_false_alarm), half = l * largest / 3;
  return half + std::sqrt(half * half + 2 * l * variance);
}

// Of what ended, lm a path, by the spread of the batches' means; -1 where one of them has no path yet.
double spread_of_batches(const FluxBooks& f, double paths) {
  double ended = 0, square = 0;
  for (const FluxBooks::OfBatch& b : f.batches) ended += b.ended;
  for (const FluxBooks::OfBatch& b : f.batches) {
    if (b.paths == 0) return -1;
    const double more = b.ended - ended / paths * double(b.paths);
    square += more * more;
  }
  const double count = double(f.batches.size());
  return std::sqrt(square * count / (count - 1)) / paths;
}

bool is_chance(double lm, double chance_lm) { return std::abs(lm) <= chance_lm; }

// What becomes of it between its start and its end; n: of paths, or whatever else all is told for.
void follow(const FluxBooks& f, double n, double started, FluxBalance& b) {
  b.roulette_lm = f.roulette / n;
  b.lost_lm = (f.started - (f.absorbed + f.escaped + f.cut + f.roulette)) / n;
  b.chance_of_lost = rounding * started;
  b.chance_of_roulette = chance(f.roulette_variance / (n * n), f.largest_game / n);
}

constexpr const char* end_of_warning = ". This is a defect of the library, or some samples were dropped\n";

}  // namespace

bool FluxBalance::closes() const {
  return is_chance(not_started_lm, chance_of_starts) && is_chance(lost_lm, chance_of_lost) &&
         is_chance(roulette_lm, chance_of_roulette);
}

FluxBalance flux_balance(const WorkCounts& light, double emitted_lm) {
  const FluxBooks& f = light.flux;
  const double n = double(std::max<uint64_t>(1, light.light_paths)), mean = f.started / n;
  FluxBalance b;
  follow(f, n, std::max(emitted_lm, mean), b);
  b.not_started_lm = emitted_lm - mean;
  const double squares = std::max(0.0, f.started_squares - n * mean * mean);  // none deviates by more than their root
  const double of_starts = squares / (n * n);                                 // stratified ones vary less
  const double of_roulette = f.roulette_variance / (n * n);
  // Where few games hold much of the variance, as of light that a lossless solid never lets out, batches do not show it.
  const bool even = f.largest_game * f.largest_game <= largest_share_of_games * f.roulette_variance;
  b.standard_error = std::sqrt(of_starts + of_roulette);  // as if nothing were stratified
  if (const double spread = spread_of_batches(f, n); spread >= 0 && even) b.standard_error = spread;
  const double largest = std::min(double(light.brightest_lm), std::sqrt(squares));
  b.chance_of_starts = chance(of_starts, largest / n) + rounding * emitted_lm;
  return b;
}

FluxBalance importance_balance(const FluxBooks& f) {
  FluxBalance b;
  if (f.started > 0) follow(f, f.started, 1, b);
  return b;
}

std::string flux_warning(const FluxBalance& b, double emitted_lm) {
  if (b.closes()) return {};
  const auto lm = [](double value) { return check::text(value) + " lm"; };
  const std::string end = std::string("; readings may be wrong by as much") + end_of_warning;
  const std::string start = "the flux balance does not close: of " + lm(emitted_lm) + " emitted ";
  const bool starts = is_chance(b.not_started_lm, b.chance_of_starts), arrives = is_chance(b.lost_lm, b.chance_of_lost);
  if (!starts || !arrives) {
    const double lost = (starts ? 0 : b.not_started_lm) + (arrives ? 0 : b.lost_lm);
    return start + lm(std::abs(lost)) +
           (lost > 0 ? " are neither absorbed nor escape" : " too much is absorbed or escapes") +
           ", where chance explains " + lm(arrives ? b.chance_of_starts : b.chance_of_lost) + end;
  }
  return start + "Russian roulette " + (b.roulette_lm > 0 ? "takes " : "gives ") + lm(std::abs(b.roulette_lm)) +
         " more than it " + (b.roulette_lm > 0 ? "gives" : "takes") + ", where chance explains " +
         lm(b.chance_of_roulette) + end;
}

std::string importance_warning(const FluxBalance& b) {
  if (b.closes()) return {};
  const auto percent = [](double share) { return short_number(100 * share, 2) + " %"; };
  const std::string end = std::string("; of all sensors together: readings may be wrong by more") + end_of_warning,
                    start = "the balance of eye paths does not close: of the importance that they start with ";
  if (!is_chance(b.lost_lm, b.chance_of_lost))
    return start + percent(std::abs(b.lost_lm)) +
           (b.lost_lm > 0 ? " is neither absorbed nor escapes" : " too much is absorbed or escapes") +
           ", where rounding explains " + percent(b.chance_of_lost) + end;
  return start + "Russian roulette " + (b.roulette_lm > 0 ? "takes " : "gives ") + percent(std::abs(b.roulette_lm)) +
         " more than it " + (b.roulette_lm > 0 ? "gives" : "takes") + ", where chance explains " +
         percent(b.chance_of_roulette) + end;
}

}  // namespace ups
