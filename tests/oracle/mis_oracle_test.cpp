// Do the recurrences of transport/weights.h give the balance heuristic? Compared with the definition (slow_weights.h) on
// random paths, for every subset of techniques, and at the scales and densities where sums overflow or underflow.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

#include "fast_weights.h"
#include "random_path.h"
#include "slow_weights.h"

namespace ups::test {
namespace {

// What is promised is 1e-4 (a weight off by less changes no result that anybody can see); what double arithmetic gives
// is about 1e-13, and a wrong term shows long before 1e-11.
constexpr double tolerance = 1e-11;

struct Worst {
  double weight = 0, sum = 0;  // largest errors
  long paths = 0, impossible = 0;
  std::array<long, 6> terms{};  // by technique: nothing was left out by accident
};

std::string describe(const Path& p, const mis::Gates& gates, int subset) {
  std::ostringstream out;
  out << "k " << p.k << ", emitter " << int(p.emitter) << ", sensor " << int(p.sensor) << ", subset " << subset
      << ", gates " << gates.merge_at_first << gates.sensor_connect_at_first << ", delta";
  for (int i = 1; i < p.k; ++i) out << ' ' << p.delta[i];
  return out.str();
}

void compare(const Path& path, const mis::Counts& n, const mis::Gates& gates, int subset, Worst& worst) {
  const std::vector<Term> terms = slow_weights(path, n, gates);
  if (terms.empty()) {
    ++worst.impossible;
    return;
  }
  const FastWeights fast(path, n, gates);
  double sum = 0;
  for (const Term& t : terms) {
    const double w = fast.weight(t.technique, t.at), error = std::abs(w - t.weight);
    ASSERT_LT(error, tolerance) << "technique " << int(t.technique) << " at " << t.at << ": " << w << ", oracle "
                                << t.weight << "; " << describe(path, gates, subset);
    worst.weight = std::max(worst.weight, error);
    ++worst.terms[size_t(t.technique)];
    sum += w;
  }
  ASSERT_LT(std::abs(sum - 1), tolerance) << describe(path, gates, subset);
  worst.sum = std::max(worst.sum, std::abs(sum - 1));
  ++worst.paths;
}

void report(const Worst& worst) {
  std::printf("  %ld paths (%ld more that no technique makes), worst weight error %.2g, worst |sum - 1| %.2g\n",
              worst.paths, worst.impossible, worst.weight, worst.sum);
}

TEST(MisOracle, EverySubsetOfTechniquesMatchesTheDefinition) {
  Random random(1);
  Worst worst;
  for (int subset = 0; subset < subset_count; ++subset)
    for (int i = 0; i < 1000; ++i) {
      const Path path = random_path(random, {});
      const mis::Counts n = random_counts(random, path, subset);
      const mis::Gates gates{random.chance(0.5), random.chance(0.5)};
      ASSERT_NO_FATAL_FAILURE(compare(path, n, gates, subset, worst));
    }
  report(worst);
  for (long count : worst.terms) EXPECT_GT(count, 1000);
}

// Long and sharp paths, where single precision loses whole paths: sums must neither overflow nor vanish at any scale.
TEST(MisOracle, LongSharpPathsKeepTheirEnergyAtAllScales) {
  const PathRanges range{.k_min = 9,
                         .k_max = 16,
                         .distance_min = 1e-3,
                         .distance_max = 1e3,
                         .cos_min = 1e-6,
                         .pdf_min = 1e-6,
                         .pdf_max = 1e12,
                         .position_min = 1e-3,
                         .position_max = 1e6};
  for (double scale : {1e-3, 1.0, 1e5}) {
    Random random(7);
    Worst worst;
    for (int i = 0; i < 40000; ++i) {
      const int subset = i % 2 ? subset_count - 1 : random.integer(1, subset_count - 1);
      const Path path = scaled(random_path(random, range), scale);
      const mis::Counts n = random_counts(random, path, subset, scale);
      const mis::Gates gates{random.chance(0.5), random.chance(0.5)};
      ASSERT_NO_FATAL_FAILURE(compare(path, n, gates, subset, worst));
    }
    report(worst);
  }
}

// Weights have no unit: the same path in millimetres or in kilometres weighs the same.
TEST(MisOracle, WeightsDoNotDependOnTheUnitOfLength) {
  Random random(3);
  double worst = 0;
  for (int i = 0; i < 20000; ++i) {
    const Path path = random_path(random, {});
    const mis::Counts n = random_counts(random, path, subset_count - 1);
    const mis::Gates gates{random.chance(0.5), random.chance(0.5)};
    const FastWeights reference(path, n, gates);
    for (double scale : {1e-3, 1e5}) {
      const Path other_path = scaled(path, scale);
      const mis::Counts other_n = scaled(n, scale);
      const FastWeights other(other_path, other_n, gates);
      for (const Term& t : slow_weights(path, n, gates)) {
        const double error = std::abs(other.weight(t.technique, t.at) - reference.weight(t.technique, t.at));
        ASSERT_LT(error, tolerance) << describe(path, gates, subset_count - 1) << ", scale " << scale;
        worst = std::max(worst, error);
      }
    }
  }
  std::printf("  worst difference %.2g\n", worst);
}

}  // namespace
}  // namespace ups::test
