// Progress is told one way: the fraction never falls, the time left falls by what passes but for the noise of looks.
#include "render/progress.h"

#include <gtest/gtest.h>

#include <random>
#include <vector>

namespace {

using namespace ups;

constexpr double second_an_iteration = 0.01;

struct Told {
  double iterations, fraction, remaining_s;
};

// Errors c / sqrt(n), each look's off by a log-normal deviation. Ends by the estimate's own rule or after `most`.
std::vector<Told> run(const ProgressEstimate::Limits& limits, double c, double deviation, uint32_t seed,
                      double most = 1e6) {
  ProgressEstimate estimate(limits);
  Prediction prediction(UPS_CRITERION_WORST, 2.0 / 3);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  std::vector<Told> all;
  for (double n = 1; n <= most && !estimate.target_is_met(); ++n) {
    estimate.add_iterations(n, n * second_an_iteration);
    if (n >= estimate.next_look()) {
      const double error = c / std::sqrt(n) * std::exp(deviation * normal(random));
      prediction.add_look({n, n * second_an_iteration, error}, {});
      estimate.add_look(n, error, &prediction);
    }
    all.push_back({n, estimate.fraction(), estimate.remaining_s()});
  }
  return all;
}

TEST(Progress, FractionNeverFalls) {
  for (const double target : {0.2, 0.05, 0.02, 0.005})
    for (const double limit : {0.0, 10.0, 1000.0})
      for (uint32_t seed = 0; seed < 20; ++seed) {
        double before = 0;
        for (const Told& t : run({limit, 0, target}, 0.5, 0.15, seed)) {
          ASSERT_GE(t.fraction, before) << target << ", iteration " << t.iterations;
          ASSERT_LE(t.fraction, 1);
          before = t.fraction;
        }
      }
}

// A target that the first look meets ends the render after 32 iterations, and is told so at iteration 16, although the
// time limit is far.
TEST(Progress, TellsATargetThatIsMetAtOnce) {
  const std::vector<Told> all = run({1000, 0, 0.9}, 0.5, 0, 1);
  ASSERT_EQ(all.back().iterations, 32);
  EXPECT_NEAR(all[14].remaining_s, 999.85, 0.01) << "nothing is known of the target before its first look";
  EXPECT_NEAR(all[15].remaining_s, 16 * second_an_iteration, 0.01 * second_an_iteration);
  EXPECT_NEAR(all[15].fraction, 0.5, 0.01);
}

// Looks may be late: an expected end that passes before its look is no end yet.
TEST(Progress, AnEndThatPassesBeforeItsLookIsNoneYet) {
  ProgressEstimate estimate({0, 0, 0.05});
  Prediction prediction(UPS_CRITERION_WORST, 2.0 / 3);
  double n = 1, end = 0;
  for (; n < 200; ++n) {
    estimate.add_iterations(n, n * second_an_iteration);
    if (n < estimate.next_look()) continue;
    prediction.add_look({n, n * second_an_iteration, 1 / std::sqrt(n)}, {});
    estimate.add_look(n, 1 / std::sqrt(n), &prediction);
    end = n + estimate.remaining_s() / second_an_iteration;
  }
  ASSERT_GT(end, n);
  estimate.add_iterations(std::ceil(end) + 10, (std::ceil(end) + 10) * second_an_iteration);
  EXPECT_EQ(estimate.remaining_s(), -1);
  EXPECT_LT(estimate.fraction(), 1);
}

// Without noise in the looks the end is known from the first one, to the steps between looks: 1.25, and the deviation
// that looks are taken to have. From there on the time left falls by what passes, and never rises.
TEST(Progress, TimeLeftFallsAsTimePasses) {
  for (const double target : {0.1, 0.03, 0.01}) {
    const std::vector<Told> all = run({0, 0, target}, 0.5, 0, 1);
    const double end = all.back().iterations;
    double before = 1e9;
    for (const Told& t : all) {
      if (t.iterations < 16) {
        EXPECT_EQ(t.remaining_s, -1);
        continue;
      }
      const double real = (end - t.iterations) * second_an_iteration;
      ASSERT_NEAR(t.remaining_s, real, 0.25 * end * second_an_iteration) << target << ", iteration " << t.iterations;
      ASSERT_LE(t.remaining_s, before + 0.06 * end * second_an_iteration);
      before = t.remaining_s;
    }
  }
}

// In the mean over 200 renders what is foretold at the first look is the real end, to 15 %: the deviation of one end is
// 30 % at the most, so that the mean's standard error is 2 %, and the trend's own share is to the looks' step.
TEST(Progress, TimeLeftIsTheMeanEnd) {
  for (const double target : {0.08, 0.03}) {
    double foretold = 0, real = 0;
    for (uint32_t seed = 0; seed < 200; ++seed) {
      const std::vector<Told> all = run({0, 0, target}, 0.5, 0.1, seed);
      foretold += all[15].remaining_s + 16 * second_an_iteration;
      real += all.back().iterations * second_an_iteration;
    }
    EXPECT_NEAR(foretold / real, 1, 0.15) << target;
  }
}

// Neither the time limit's share before the target is known nor a look that takes its promise back is ever undone.
TEST(Progress, LimitsOfTimeAndIterations) {
  for (const Told& t : run({2, 0, 0}, 1, 0, 1, 200)) {
    ASSERT_NEAR(t.fraction, t.iterations / 200, 1e-9);
    ASSERT_NEAR(t.remaining_s, 2 - t.iterations * second_an_iteration, 1e-9);
  }
  for (const Told& t : run({100, 50, 0}, 1, 0, 1, 50)) {
    ASSERT_NEAR(t.fraction, t.iterations / 50, 1e-9);
    ASSERT_NEAR(t.remaining_s, (50 - t.iterations) * second_an_iteration, 1e-9);
  }
}

// Paths that book flux after the last iteration: nothing is over before they are, but by the time limit.
TEST(Progress, TellsWhatComesAfterTheIterations) {
  for (const double limit : {0.0, 100.0, 0.75}) {
    ProgressEstimate estimate({limit, 50, 0});
    double fraction = 0;
    for (int n = 1; n <= 50; ++n) {
      estimate.add_iterations(n, n * second_an_iteration);
      estimate.set_rest(0.5, n * second_an_iteration);
      const double left = std::min(limit > 0 ? limit : 1, 1.0) - n * second_an_iteration;
      ASSERT_NEAR(estimate.remaining_s(), left, 1e-9);
    }
    for (double rest = 0.4; rest > -0.01; rest -= 0.1) {
      estimate.set_rest(rest, 1 - rest);
      EXPECT_NEAR(estimate.remaining_s(), std::max(0.0, std::min(rest, limit > 0 ? limit - 1 + rest : 1)), 1e-9);
      EXPECT_GE(estimate.fraction(), fraction);
      fraction = estimate.fraction();
    }
    EXPECT_NEAR(fraction, 1, 1e-9);
    EXPECT_NEAR(estimate.seconds_per_iteration(), second_an_iteration, 1e-9);
  }
}

// A target that no render would reach: its end is not known, nor is one that is months away.
TEST(Progress, TellsNoEndOfAHopelessTarget) {
  for (const double target : {1e-8, 1e-6})
    for (const Told& t : run({0, 0, target}, 0.5, 0.1, 1, 2000)) {
      ASSERT_EQ(t.remaining_s, -1) << target << ", iteration " << t.iterations;
      ASSERT_EQ(t.fraction, 0);
    }
}

TEST(Progress, ALastLookIsForOldOnes) {
  ProgressEstimate estimate({0, 1000, 0, 3});
  EXPECT_FALSE(estimate.is_last_look_old(3 * 16 - 1)) ;
  EXPECT_TRUE(estimate.is_last_look_old(3 * 16));
  estimate.leave_out_look(3 * 16);
  EXPECT_EQ(estimate.next_look(), 3 * 20);
  EXPECT_TRUE(estimate.is_last_look_old(3 * 16)) << "there was none";
  estimate.add_look(3 * 20, -1, nullptr);
  EXPECT_FALSE(estimate.is_last_look_old(3 * 22));
  EXPECT_TRUE(estimate.is_last_look_old(3 * 23));
}

// Of pixels, of which each iteration visits a tenth, an error is known after four passes.
TEST(Progress, LooksAtPixelsAsSoonAsTheyHaveAnError) {
  ProgressEstimate few({0, 1000, 0.1, 10, true}), one({0, 1000, 0.1, 1, true});
  EXPECT_EQ(few.next_look(), 40);
  EXPECT_EQ(one.next_look(), 16);
  few.add_look(40, 0.01, nullptr), few.add_look(50, 0.01, nullptr);
  EXPECT_FALSE(few.target_is_met()) << "by luck";
  few.add_look(320, 0.01, nullptr);
  EXPECT_TRUE(few.target_is_met());
}

// Meters that are visited in turn: what counts are passes.
TEST(Progress, CountsPasses) {
  const std::vector<Told> all = run({1000, 0, 0.9, 5}, 0.5, 0, 1);
  EXPECT_EQ(all.back().iterations, 160);
  EXPECT_LT(all[79].remaining_s, 1);
}

}  // namespace
