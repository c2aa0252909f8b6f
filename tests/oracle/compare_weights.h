// The recurrences of transport/weights.h against the definition (slow_weights.h), path by path.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "fast_weights.h"
#include "random_path.h"
#include "slow_weights.h"

namespace ups::test {

// What is promised is 1e-4 (a weight off by less changes no result that anybody can see); what double arithmetic gives
// is about 1e-13, and a wrong term shows long before 1e-11.
// Of light states as they are stored, in floats, those beyond their range at its end, what is promised.
inline constexpr double tolerance = 1e-11, tolerance_of_stored = 1e-4;

struct Worst {
  double weight = 0, sum = 0;  // largest errors
  long paths = 0, impossible = 0;
  std::array<long, 6> terms{};  // by technique: nothing was left out by accident
};

inline std::string describe(const Path& p, const mis::Gates& gates, int subset) {
  std::ostringstream out;
  out << "k " << p.k << ", emitter " << int(p.emitter) << ", sensor " << int(p.sensor) << ", subset " << subset
      << ", gates " << gates.merge_at_first << gates.sensor_connect_at_first << ", delta";
  for (int i = 1; i < p.k; ++i) out << ' ' << p.delta[i];
  return out.str();
}

inline void compare(const Path& path, const mis::Counts& n, const mis::Gates& gates, int subset, Worst& worst,
                    LightStates states = LightStates::exact) {
  const std::vector<Term> terms = slow_weights(path, n, gates);
  if (terms.empty()) {
    ++worst.impossible;
    return;
  }
  const FastWeights fast(path, n, gates, states);
  const double allowed = states == LightStates::exact ? tolerance : tolerance_of_stored;
  double sum = 0;
  for (const Term& t : terms) {
    const double w = fast.weight(t.technique, t.at), error = std::abs(w - t.weight);
    ASSERT_LT(error, allowed) << "technique " << int(t.technique) << " at " << t.at << ": " << w << ", oracle "
                                << t.weight << "; " << describe(path, gates, subset);
    worst.weight = std::max(worst.weight, error);
    ++worst.terms[size_t(t.technique)];
    sum += w;
  }
  ASSERT_LT(std::abs(sum - 1), allowed) << describe(path, gates, subset);
  worst.sum = std::max(worst.sum, std::abs(sum - 1));
  ++worst.paths;
}

inline void report(const Worst& worst) {
  std::printf("  %ld paths (%ld more that no technique makes), worst weight error %.2g, worst |sum - 1| %.2g\n",
              worst.paths, worst.impossible, worst.weight, worst.sum);
}

}  // namespace ups::test
