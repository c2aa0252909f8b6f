// Numbers of reports: durations as texts, intervals of means and of extremes.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <vector>

#include "report/findings.h"
#include "report/intervals.h"
#include "report/page.h"
#include "report/targets.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

TEST(Durations, HaveTwoDigits) {
  struct Case {
    double seconds;
    const char* text;
  };
  constexpr Case cases[] = {{0.25, "0.25 s"},  {9.9, "9.9 s"},   {42, "42 s"},     {99.4, "99 s"},
                            {100, "1.7 min"},  {120, "2 min"},   {130, "2.2 min"}, {149, "2.5 min"},
                            {596, "9.9 min"},  {598, "10 min"},  {640, "11 min"},  {5400, "1.5 h"}};
  for (const Case& c : cases) EXPECT_EQ(duration_text(c.seconds), c.text) << c.seconds;
}

TEST(Significant, DigitsHaveNoExponent) {
  struct Case {
    double value;
    int digits;
    const char* text;
  };
  constexpr Case cases[] = {{100, 2, "100"},   {149, 2, "150"},      {9.96, 2, "10"},        {99.6, 2, "100"},
                            {0.95, 2, "0.95"}, {0.999, 2, "1"},      {12346, 4, "12350"},    {1.2e5, 2, "120000"},
                            {5, 2, "5"},       {5.04, 2, "5"},       {0.00012, 2, "0.00012"}, {0, 2, "0"},
                            {-12.34, 3, "-12.3"}, {1e-9, 2, "1e-09"}, {INFINITY, 2, "inf"}};
  for (const Case& c : cases) EXPECT_EQ(significant(c.value, c.digits), c.text) << c.value;
}

// What is signed: no end of an interval lies within it, no bound is less than it is.
TEST(Significant, BoundsAreRoundedUp) {
  struct Case {
    double value;
    const char* text;
  };
  constexpr Case cases[] = {{1.049, "1.1"}, {1.1, "1.1"},     {0.3, "0.3"}, {double(0.6f), "0.6"}, {0.0991, "0.1"},
                            {141, "150"},   {9.91, "10"},     {99.1, "100"}, {0, "0"},             {0.00021, "0.00021"},
                            {0.999, "1"},   {0.000211, "0.00022"}};
  for (const Case& c : cases) EXPECT_EQ(bound_text(c.value), c.text) << c.value;
}
TEST(Intervals, AreRoundedOutwards) {
  EXPECT_EQ(interval(499.64, 499.91, lux), "499.6 to 500.0");
  EXPECT_EQ(interval(0.5996, 0.6121, ratio), "0.599 to 0.613");
  EXPECT_EQ(interval(double(0.6f), double(0.7f), ratio), "0.600 to 0.700");
  EXPECT_EQ(interval(999.97, 1000.4, lux), "999.9 to 1001");
  EXPECT_EQ(interval(0, 0, lux), "0.000");
  EXPECT_EQ(rating_interval(23.3998, 23.41), "23.3 to 23.5");
  EXPECT_EQ(rating_interval(-3.04, -2.96), "-3.1 to -2.9");
  EXPECT_EQ(rating_interval(-1, -0.4), "");  // not known
  EXPECT_EQ(with_interval(499.96, 499.94, 2000.2, lux), "500.0 <span class=\"i\">499.9 to 2001</span>");
}

TEST(Intervals, OfNoiseAreThoseOfStudentsT) {
  constexpr std::array<double, 13> table = {3.182, 2.776, 2.571, 2.447, 2.365, 2.306, 2.262,
                                            2.228, 2.201, 2.179, 2.160, 2.145, 2.131};
  for (uint32_t i = 0; i < table.size(); ++i) EXPECT_NEAR(noise_bound(2, 4 + i), 2 * table[i], 0.0012) << 4 + i;
  EXPECT_EQ(noise_bound(1, 4096), noise_bound(1, 16));
  EXPECT_EQ(noise_bound(-1, 64), -1);
}

TEST(Intervals, OfOneValueAreItsOwn) {
  for (const auto& extreme : {least_of({{3, 2, 5}}, 64), greatest_of({{3, 2, 5}}, 64)}) {
    EXPECT_EQ(extreme.value, 3);
    EXPECT_NEAR(extreme.low, 2, 1e-8);
    EXPECT_NEAR(extreme.high, 5, 1e-8);
  }
}

TEST(Intervals, OfExtremesAreUnknownWhereOneIs) {
  for (const auto& extreme : {least_of({{3, 2, 5}, {4, -1, -1}}, 64), greatest_of({{3, 2, 5}, {2, -1, -1}}, 64)}) {
    EXPECT_EQ(extreme.value, 3);
    EXPECT_EQ(extreme.low, -1);
    EXPECT_EQ(extreme.high, -1);
  }
  EXPECT_EQ(least_of({}, 64).value, -1);
}

// 1000 meters of the same ratio, by 16 batches each.
TEST(Intervals, OfExtremesOfManyNoisyValuesHoldTheTrueOnes) {
  constexpr double truth = 0.4, noise = 0.03 * truth;
  constexpr int rounds = 200, batches = 16;
  std::mt19937_64 random(5);
  std::normal_distribution<double> normal(truth, noise * std::sqrt(double(batches)));
  int least_holds = 0, greatest_holds = 0, own_holds = 0;
  for (int round = 0; round < rounds; ++round) {
    std::vector<ups_interval> meters;
    for (int m = 0; m < 1000; ++m) {
      double sum = 0, squares = 0;
      for (int b = 0; b < batches; ++b) {
        const double x = normal(random);
        sum += x, squares += x * x;
      }
      const double mean = sum / batches;
      const double bound = 2.131 * std::sqrt((squares / batches - mean * mean) / (batches - 1));
      meters.push_back({mean, mean - bound, mean + bound});
    }
    const auto holds = [&](const ups_interval& i) { return i.low <= truth && truth <= i.high; };
    least_holds += holds(least_of(meters, batches));
    greatest_holds += holds(greatest_of(meters, batches));
    own_holds += holds(*std::min_element(meters.begin(), meters.end(), [](const auto& a, const auto& b) {
      return a.value < b.value;
    }));
  }
  // At least 97.5 % each are foretold: fewer than 184 of 200 are one in 70,000.
  EXPECT_GE(least_holds, 184);
  EXPECT_GE(greatest_holds, 184);
  EXPECT_LT(own_holds, rounds / 2) << "the least one's own interval would have done";
}

TEST(Verdicts, OnGlareCountWhatNoRayHasSeen) {
  Targets targets;
  targets.areas.push_back({});
  targets.areas[0].observers = {"eye"};
  targets.areas[0].ugr = 19;
  Report report{};
  ObserverReport eye{};
  eye.name = "eye";
  eye.reading.flags = UPS_OBSERVER_NO_SOURCE;
  eye.reading.ugr = eye.reading.ugr_low = -1;
  struct Case {
    float high;
    Judgement judgement;
  };
  for (const Case& c : {Case{-1, Judgement::met}, Case{12, Judgement::met}, Case{19.5f, Judgement::not_sure},
                        Case{INFINITY, Judgement::not_sure}}) {
    eye.reading.ugr_high = c.high;
    report.observers = {eye};
    const std::vector<TargetVerdict> verdicts = judge(targets, report);
    ASSERT_EQ(verdicts.size(), 1u);
    EXPECT_EQ(verdicts[0].judgement, c.judgement) << c.high;
  }
}

}  // namespace
}  // namespace ups::report
