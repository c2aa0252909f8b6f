// How far a render is, and when it will end: by its limits, and by the errors that were found on the way to its target.
// Kept by the job.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>

#include "render/prediction.h"

namespace ups {

// When the error is looked at, in iterations: after 16, 20, 25, 32 ... passes of all meters; without meters after 4, 5,
// 7, 9 ... passes of all pixels, and 16 iterations at the least. Two looks one after the other must be below the target,
// which guards against stopping on a lucky one, and no sooner than after 32 passes.
class TargetRule {
 public:
  explicit TargetRule(uint32_t pass, bool of_pixels = false)
      : pass_(pass), first_(of_pixels ? std::max(16.0, 4.0 * pass) : 16.0 * pass) {}
  double first() const { return first_; }
  double next(double look) const {
    const double passes = std::floor(look / pass_);
    return pass_ * std::max(passes + 1, std::ceil(passes * 1.25));
  }
  double least() const { return 32.0 * pass_; }
  static constexpr uint32_t looks = 2;

 private:
  double pass_, first_;
};

class ProgressEstimate {
 public:
  struct Limits {  // 0: none
    double time_s = 0, iterations = 0, target = 0;
    uint32_t pass = 1;  // of TargetRule
    bool of_pixels = false;
  };
  explicit ProgressEstimate(const Limits& limits) : limits_(limits), rule_(limits.pass, limits.of_pixels) {}

  void start(double elapsed_s) { start_s_ = elapsed_s; }  // of the first iteration
  double start_s() const { return start_s_; }
  void add_iterations(double iterations, double elapsed_s);
  double seconds_per_iteration() const { return iterations_ > 0 ? (elapsed_s_ - start_s_) / iterations_ : 0; }
  // What is left to do after the iterations, within the time limit.
  void set_rest(double seconds, double elapsed_s);
  // The error after so many iterations, at a look of the rule's or at the render's end, which the prediction, if any,
  // has taken in. The same iterations are added before or later. error: -1: not known yet.
  void add_look(double iterations, double error, const Prediction* prediction);
  bool target_is_met() const { return passed_ >= TargetRule::looks && look_ >= rule_.least(); }
  double next_look() const { return next_look_ > 0 ? next_look_ : rule_.first(); }
  void leave_out_look(double iterations) { next_look_ = rule_.next(iterations); }
  // Of a render that has ended after so many iterations: one look more would tell something new.
  bool is_last_look_old(double iterations) const { return iterations >= rule_.first() && look_ < 0.9 * iterations; }

  double fraction() const { return fraction_; }  // [0, 1]; never falls
  double remaining_s() const { return remaining_s_; }  // -1: not known

 private:
  double expected_end(const Prediction& prediction) const;
  void update();

  const Limits limits_;
  const TargetRule rule_;
  double start_s_ = 0, elapsed_s_ = 0, iterations_ = 0, now_s_ = 0, rest_s_ = 0;
  double look_ = 0, next_look_ = 0;
  double end_ = 0;  // by the target, in iterations; 0: not known
  uint32_t passed_ = 0;
  double fraction_ = 0, remaining_s_ = -1;
};

}  // namespace ups
