// Does the flux of light paths balance? Emitted is absorbed, or escapes, or was cut off by the greatest length of
// paths; what is missing is chance, or a defect. Costs nothing: light paths keep the books (transport/flux_books.h).
#pragma once
#include <string>

#include "transport/tally.h"

namespace ups {

struct FluxBalance {
  double lost_lm = 0;      // emitted, but neither absorbed nor escaped nor cut off, nor at stake in roulette
  double roulette_lm = 0;  // taken by roulette from paths that it ended, less what it gave to others
  double standard_error = -1;  // of emitted - absorbed - escaped; -1: not known
  double chance_of_lost = 0, chance_of_roulette = 0;  // more than these is no chance
  bool closes() const;
};

// How often books without a fault seem to have one: once in so many renders at most.
inline constexpr double renders_per_false_alarm = 10000;

FluxBalance flux_balance(const WorkCounts& light, double emitted_lm);
// A line of warning; empty where it closes.
std::string flux_warning(const FluxBalance& balance, double emitted_lm);

}  // namespace ups
