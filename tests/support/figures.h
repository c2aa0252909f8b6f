// Figures for the table of tests/stability: told by the full form, gathered by tests/stability/run.sh.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <string>

#include "full.h"

namespace ups::test {

[[gnu::format(printf, 1, 2)]] inline void measured(const char* format, ...) {
  if (!full()) return;
  std::va_list values;
  va_start(values, format);
  std::printf("[ MEASURED ] ");
  std::vprintf(format, values);
  std::printf("\n");
  va_end(values);
}

// A number for messages, as short as it is told.
inline std::string short_number(double v) {
  char text[32];
  std::snprintf(text, sizeof text, "%g", v);
  return text;
}

// What a test has compared, told at its end: how often, the largest difference, the largest noise. By one thread.
class Comparisons : public testing::EmptyTestEventListener {
 public:
  static Comparisons& of_test() {
    static Comparisons* const one = [] {
      auto* const listener = new Comparisons;
      testing::UnitTest::GetInstance()->listeners().Append(listener);  // which owns it
      return listener;
    }();
    return *one;
  }
  void add(double difference, double noise, const std::string& what) {
    if (count_++ == 0 || !(std::abs(difference) <= std::abs(worst_)))
      worst_ = difference, its_noise_ = noise, what_ = what;
    most_noise_ = std::max(most_noise_, noise);
  }

 private:
  void OnTestEnd(const testing::TestInfo&) override {
    if (count_ > 0 && most_noise_ > 0)
      measured("%d compared: worst %+.3g %% (+- %.2g %%), noise at most %.2g %%; %s", count_, 100 * worst_,
               100 * its_noise_, 100 * most_noise_, what_.c_str());
    else if (count_ > 0)
      measured("%d compared: worst %+.2g %%, without noise; %s", count_, 100 * worst_, what_.c_str());
    count_ = 0, worst_ = its_noise_ = most_noise_ = 0;
  }

  int count_ = 0;
  double worst_ = 0, its_noise_ = 0, most_noise_ = 0;
  std::string what_;
};

// With its standard error; 0: none.
inline void compared(double value, double expected, double standard_error, const std::string& what) {
  if (full() && expected != 0)
    Comparisons::of_test().add(value / expected - 1, standard_error / std::abs(expected), what);
}

// Without noise: to within `allowed` of what is expected.
inline void expect_ratio(double value, double expected, double allowed, const std::string& what) {
  compared(value, expected, 0, what);
  EXPECT_NEAR(value / expected, 1, allowed) << what << ": " << value << ", expected " << expected;
}

// To within `allowed` whatever the noise is, which is limited; both relative.
inline void expect_within(double value, double standard_error, double expected, double allowed, double most_noise,
                          const std::string& what) {
  compared(value, expected, standard_error, what);
  EXPECT_GE(standard_error, 0) << what;
  EXPECT_LE(standard_error, most_noise * expected) << what << ": too noisy to judge " << value;
  EXPECT_NEAR(value, expected, allowed * expected) << what << " +- " << standard_error;
}

}  // namespace ups::test
