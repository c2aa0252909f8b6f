// Hazard 1: the weights' sums overflow or underflow on long or sharp paths. With single precision 26 of 3000 paths of 9
// to 16 edges and densities to 1e12 lose all their energy, 157 in units of 1e5, and nothing that is not finite gives it
// away.
#include "../oracle/compare_weights.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

// Every weight against its definition, and their sum against 1, for 1e5 paths at each scale: a path whose weights
// vanish fails. Every second one with all techniques, so that few have none. With what vertices of light paths keep of
// their states until they are connected or merged, as without.
class Hazard01 : public testing::TestWithParam<LightStates> {};
INSTANTIATE_TEST_SUITE_P(LightStates, Hazard01, testing::Values(LightStates::exact, LightStates::stored),
                         [](const auto& i) { return i.param == LightStates::exact ? "exact" : "stored"; });

TEST_P(Hazard01, WeightsOfLongSharpPathsSumToOne) {
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
    while (worst.paths < 100000) {
      const int subset = worst.paths % 2 ? subset_count - 1 : random.integer(1, subset_count - 1);
      const Path path = scaled(random_path(random, range), scale);
      const mis::Counts n = random_counts(random, path, subset, scale);
      const mis::Gates gates{random.chance(0.5), random.chance(0.5)};
      ASSERT_NO_FATAL_FAILURE(compare(path, n, gates, subset, worst, GetParam()));
    }
    report(worst);
    measured("lengths times %g: %ld paths, largest error of a weight %.1e, of a sum %.1e", scale, worst.paths, worst.weight,
             worst.sum);
  }
}

}  // namespace
}  // namespace ups::test
