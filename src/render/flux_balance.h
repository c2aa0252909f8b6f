// Does the flux of light paths balance? Emitted is absorbed, or escapes, or was cut off by the greatest length of
// paths; what is missing is chance, or a defect. So of eye paths the importance that they start with. Costs nothing:
// paths keep the books (transport/flux_books.h).
#pragma once
#include <string>

#include "transport/tally.h"

namespace ups {

struct FluxBalance {  // of importance shares of all that started instead of lm
  double not_started_lm = 0;  // emitted, but no path started with it
  double lost_lm = 0;         // started, but neither absorbed nor escaped nor cut off, nor at stake in roulette
  double roulette_lm = 0;     // taken by roulette from paths that it ended, less what it gave to others
  double standard_error = -1;  // of emitted - absorbed - escaped; -1: not known
  // More than these is no chance. On its way a path loses nothing by chance, but by rounding.
  double chance_of_starts = 0, chance_of_lost = 0, chance_of_roulette = 0;
  bool closes() const;
};

// How often books without a fault seem to have one: once in so many renders at most.
inline constexpr double renders_per_false_alarm = 10000;

FluxBalance flux_balance(const WorkCounts& light, double emitted_lm);
FluxBalance importance_balance(const FluxBooks& importance);
// A line of warning; empty where it closes.
std::string flux_warning(const FluxBalance& balance, double emitted_lm);
std::string importance_warning(const FluxBalance& balance);

}  // namespace ups
