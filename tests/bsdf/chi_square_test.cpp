// The tests' own instrument: does the chi-square test of support/chi_square.h give tabulated levels, and find a wrong
// density?
#include "support/chi_square.h"

#include <gtest/gtest.h>

#include "base/warp.h"
#include "cases.h"

namespace ups::test {
namespace {

TEST(ChiSquare, TabulatedQuantiles) {  // 5 % and 1 % points
  EXPECT_NEAR(gamma_q(0.5, 3.8415 / 2), 0.05, 1e-5);
  EXPECT_NEAR(gamma_q(5, 18.307 / 2), 0.05, 1e-5);
  EXPECT_NEAR(gamma_q(50, 135.807 / 2), 0.01, 1e-5);
  EXPECT_EQ(gamma_q(3, 0), 1);
}

TEST(ChiSquare, PoolsSmallCellsAndRejectsTheImpossible) {
  EXPECT_EQ(chi_square_test({1, 1, 3, 10}, {1, 1, 3, 10}).degrees_of_freedom, 1);
  EXPECT_EQ(chi_square_test({1, 0, 10}, {0, 5, 6}).p_value, 0);
  EXPECT_EQ(chi_square_test({2, 1}, {1, 2}).degrees_of_freedom, 0);
}

double p_of_cosine_samples(const SphereCells& cells, double exponent) {
  constexpr int count = 20000;
  std::vector<double> observed(cells.size());
  std::vector<double> expected = cells.integrate(
      [&](const Vec3d& d) { return d.z > 0 ? (exponent + 1) / (2 * M_PI) * std::pow(d.z, exponent) : 0.0; }, 1e-6, 8,
      2);
  Random random{5};
  for (int i = 0; i < count; ++i) observed[cells.index(square_to_cosine_hemisphere(random.next().u))] += 1;
  double total = 0;
  for (double& e : expected) {
    total += e;
    e *= count;
  }
  EXPECT_NEAR(total, 1, 1e-4);
  return chi_square_test(observed, expected).p_value;
}

TEST(ChiSquare, AcceptsTheRightDensityAndFindsAWrongOne) {
  const Vec3d tilted{0.3, 0.4, 0.8};
  for (const SphereCells& cells :
       {SphereCells(12, 16), SphereCells(16, 12, tilted), SphereCells(16, 12, tilted, 1e-2)}) {
    EXPECT_GT(p_of_cosine_samples(cells, 1), 1e-3);  // false alarm: 1 in 1000 a check, with fixed numbers
    EXPECT_LT(p_of_cosine_samples(cells, 1.15), 1e-6);
  }
}

TEST(ChiSquare, QuantilesAreTheInverse) {
  EXPECT_NEAR(chi_square_quantile(10, 0.05), 18.307, 1e-3);
  EXPECT_NEAR(chi_square_quantile(100, 0.01), 135.807, 1e-3);
}

// A density that rises by as much as smallest_found() says over 16 cells, root mean square, is found in 97.7 of 100
// cases at least: of 400 sets of samples in 380 (a right helper fails with probability 5e-4, with fixed numbers); half
// of it in few.
TEST(ChiSquare, KnowsTheSmallestErrorThatItFinds) {
  constexpr int cells = 16, samples = 4000, sets = 400;
  constexpr double level = 1e-4;
  const std::vector<double> expected(cells, samples / double(cells));
  const double smallest = smallest_found(samples, cells - 1, level);
  EXPECT_NEAR(smallest, 0.125, 0.001);
  const auto found = [&](double error) {
    const double slope = std::sqrt(3.0) * error;  // of a density 1 + slope (2 x - 1)
    int count = 0;
    Random random{6};
    for (int k = 0; k < sets; ++k) {
      std::vector<double> observed(cells);
      for (int i = 0; i < samples; ++i) {
        // Inverts (1 - slope) x + slope x^2.
        const double u = double(random.next().lobe), b = 1 - slope, x = 2 * u / (b + std::sqrt(b * b + 4 * slope * u));
        observed[std::min(size_t(x * cells), size_t(cells - 1))] += 1;
      }
      count += chi_square_test(observed, expected).p_value < level;
    }
    return count;
  };
  EXPECT_GE(found(smallest), 380);
  EXPECT_LE(found(smallest / 2), sets / 3);
}

}  // namespace
}  // namespace ups::test
