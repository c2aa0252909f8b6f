// How the analytic tests judge a reading. An error of half a percent is allowed, or four standard errors where the
// noise is larger; the noise itself is bounded, so that a test cannot pass by being vague. Standard errors come from 16
// batches: a right engine fails one comparison with probability below P(|t_15| > 4) = 0.12 % where noise decides, and
// far below that where the half percent does. Seeds are fixed: a test that passes once passes always.
//
// What is found: at a standard error of 0.17 % (`quiet`) an error of 1 % lies (1 - 4 * 0.17) / 0.17 = 1.9 standard
// errors beyond what is allowed, and is found in 96 cases of 100; at 0.125 % and less in 99.9 of 100. A single meter
// beside a mean that is judged so may be noisier, by one_of(limit): it shows what is wrong in one place by five limits.
#pragma once
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "figures.h"
#include "scene_builder.h"

namespace ups::test {

inline constexpr double relative_tolerance = 0.005;
inline constexpr double sigmas = 4;
inline constexpr double quiet = 0.0017;

inline const char* method_name(ups_method m) {
  return m == UPS_METHOD_UPS             ? "UPS"
         : m == UPS_METHOD_BIDIRECTIONAL ? "BPT"
         : m == UPS_METHOD_PATH_TRACING  ? "PT"
         : m == UPS_METHOD_LIGHT_TRACING ? "LT"
         : m == UPS_METHOD_PPM           ? "PPM"
         : m == UPS_METHOD_SPPM          ? "SPPM"
         : m == UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING ? "BPM"
                                         : "other";
}
inline constexpr ups_method eye_methods[] = {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING};
inline constexpr ups_method cell_methods[] = {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING,
                                              UPS_METHOD_LIGHT_TRACING};

// Iterations for noise that came out so many times as large as is asked for, with a sixth more for luck: a multiple of
// the 16 batches that errors come from, at most eight times as many.
inline uint32_t quieter(uint32_t iterations, double excess) {
  const double more = iterations * std::clamp(1.17 * excess * excess, 1.25, 8.0);
  return (uint32_t(more) + 15) / 16 * 16;
}

// Renders anew with more iterations until excess(result), noise over what is allowed, is at most 1, or there are `most`
// of them or more; options.iterations are those of the result.
template <class Excess>
Result render_until_quiet(Scene& scene, RenderOptions& options, uint32_t most, const Excess& excess) {
  Result result = scene.render(options);
  for (double e = excess(result); options.iterations < most && e > 1 && !low_effort(); e = excess(result)) {
    options.iterations = quieter(options.iterations, e);
    result = scene.render(options);
  }
  return result;
}

// The largest relative standard error of one reading of several whose mean, too, is judged.
struct OneOf {
  double largest_relative_error;
};
inline OneOf one_of(double largest_relative_error) { return {largest_relative_error}; }

inline void expect_lx(double value, double standard_error, double expected, const OneOf& noise,
                      const std::string& what) {
  compared(value, expected, standard_error, what);
  EXPECT_GE(standard_error, 0) << what << ": no standard error";
  EXPECT_LE(standard_error, noise.largest_relative_error * expected) << what << ": too noisy to judge " << value;
  EXPECT_LE(std::abs(value - expected), std::max(relative_tolerance * expected, sigmas * standard_error))
      << what << ": " << value << " +- " << standard_error << " lx, expected " << expected << " (" << std::showpos
      << 100 * (value / expected - 1) << " %, " << (value - expected) / standard_error << " standard errors)";
}
inline void expect_lx(double value, double standard_error, double expected, double largest_relative_error,
                      const std::string& what) {
  expect_lx(value, standard_error, expected, one_of(largest_relative_error), what);
}
template <class Noise>
void expect_lx(const ups_meter_reading& r, double expected, const Noise& noise, const std::string& what) {
  expect_lx(r.illuminance_lx, r.standard_error_lx, expected, noise, what);
}

// Light that arrives by density estimation alone: inside what the library itself claims, and the claim is worth
// something. error_bound is a 95 % statement; twice that is beyond 4 standard errors.
inline void expect_inside_bound(const ups_meter_reading& r, double expected, double largest_relative_bound,
                                const std::string& what) {
  compared(r.illuminance_lx, expected, r.standard_error_lx, what);
  EXPECT_GT(r.error_bound_lx, 0) << what;
  EXPECT_LE(r.error_bound_lx, largest_relative_bound * expected)
      << what << ": bound too wide, read " << r.illuminance_lx;
  EXPECT_LE(std::abs(r.illuminance_lx - expected), 2 * r.error_bound_lx)
      << what << ": " << r.illuminance_lx << " +- " << r.error_bound_lx << " lx (bias " << r.bias_lx << ", noise "
      << r.standard_error_lx << "), expected " << expected;
}

}  // namespace ups::test
