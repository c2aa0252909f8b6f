// Do the recurrences of transport/weights.h give the balance heuristic? Compared with the definition (slow_weights.h) on
// random paths, for every subset of techniques. Long and sharp ones: tests/stability/long_paths_test.cpp.
#include "compare_weights.h"

namespace ups::test {
namespace {

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
