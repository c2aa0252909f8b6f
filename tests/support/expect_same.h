// Do estimators that walk from the light and from the sensor measure the same? Means over a set of meters, judged in
// pairs and against a closed form where there is one.
//
// Each standard error is at most 0.15 % of the value; two values differ by at most 0.5 % of it, or by 3 standard errors
// of the difference where that is more, which is only where both are near their limit (3 * 0.15 % * sqrt 2 = 0.64 %).
// False alarms: P(|t_30| > 3) = 0.5 % for a pair at the limit; where both errors are 0.1 %, as most are, the half
// percent is 3.5 standard errors of the difference, 0.15 %; at 0.075 %, 4e-5. An error of 1 % is found in 95 cases of
// 100 by a pair at the limit, in 99.9 where both errors are 0.1 %, and in 99.8 against a closed form. Errors come from
// 16 batches. Seeds are fixed: a test that passes once passes always. An error from 16 batches is itself uncertain by
// 18 %: where it comes out above the limit, the render is repeated with as many iterations as it asks for, and once
// more.
#pragma once
#include "expect_lx.h"
#include "image_mean.h"

namespace ups::test {

struct Limits {
  double standard_error, difference;  // relative
  double sigmas = 3;  // a pair may differ by so many of its standard errors, too
};
inline constexpr Limits usual{0.0015, relative_tolerance};

struct Estimate {
  std::string name;
  double mean = 0, standard_error = 0;
};

inline void expect_pair(const Estimate& a, const Estimate& b, const std::string& what, const Limits& limits = usual) {
  const double s = std::hypot(a.standard_error, b.standard_error), difference = a.mean - b.mean;
  compared(a.mean, b.mean, s, what + ", " + a.name + " and " + b.name);
  EXPECT_LE(std::abs(difference), std::max(limits.difference * std::abs(b.mean), limits.sigmas * s))
      << what << ", " << a.name << " and " << b.name << ": " << a.mean << " and " << b.mean << " lx (" << std::showpos
      << 100 * difference / b.mean << " %, " << difference / s << " standard errors)";
}

// expected: a closed form; 0: none.
inline void expect_same(const std::vector<Estimate>& all, double expected, const std::string& what,
                        const Limits& limits = usual) {
  for (size_t i = 0; i < all.size(); ++i) {
    EXPECT_GE(all[i].standard_error, 0) << what << ", " << all[i].name << ": no standard error";
    EXPECT_LE(all[i].standard_error, limits.standard_error * all[i].mean)
        << what << ", " << all[i].name << ": too noisy to judge " << all[i].mean;
    for (size_t j = 0; j < i; ++j) expect_pair(all[i], all[j], what, limits);
    if (expected > 0) expect_pair(all[i], {"closed form", expected, 0}, what, limits);
  }
}

struct Trial {
  std::string name;
  RenderOptions options;
};

inline Trial trial(ups_method method, uint32_t iterations, uint32_t light_paths = 0, double merge_radius_m = 0) {
  return {method_name(method),
          {.method = method, .iterations = iterations, .merge_radius_m = merge_radius_m, .light_paths = light_paths}};
}
// Every photon that reaches a point does so by density estimation.
inline Trial merge_only(uint32_t iterations, uint32_t light_paths, double merge_radius_m) {
  Trial r = trial(UPS_METHOD_UPS, iterations, light_paths, merge_radius_m);
  r.name = "merging alone";
  r.options.techniques = UPS_TECHNIQUE_MERGE;
  return r;
}

inline Estimate estimate(const std::string& name, const Result& result, const Sensor& meters) {
  const auto s = result.statistics(meters);
  return {name, s.mean_lx, s.mean_standard_error_lx};
}

// Renders until every mean over `sets` has the standard error that is asked for.
inline Result render_quietly(Scene& scene, RenderOptions options, const std::vector<Sensor>& sets,
                             const Limits& limits = usual) {
  for (int repeats = 0;; ++repeats) {
    Result result = scene.render(options);
    double worst = 0;
    for (const Sensor& set : sets) {
      const Estimate e = estimate("", result, set);
      worst = std::max(worst, e.standard_error / (limits.standard_error * e.mean));
    }
    if (repeats == 2 || worst <= 1 || low_effort()) return result;
    options.iterations = quieter(options.iterations, worst);
  }
}

inline Estimate estimate(const std::string& name, const Mean& mean) { return {name, mean.value, mean.standard_error}; }

// The means over points and over cells; a closed form of each, or 0. Cells count photons where points merge them: light
// tracing is left out of the points, merging alone out of the cells.
inline void expect_same(Scene& scene, const std::vector<Trial>& runs, const Sensor& points, const Sensor& cells,
                        double expected_points, double expected_cells, const Limits& limits = usual) {
  std::vector<Estimate> at_points, over_cells;
  for (const Trial& r : runs) {
    const bool by_points = r.options.method != UPS_METHOD_LIGHT_TRACING,
               by_cells = r.options.techniques != UPS_TECHNIQUE_MERGE;
    std::vector<Sensor> judged;
    if (by_points) judged.push_back(points);
    if (by_cells) judged.push_back(cells);
    const Result result = render_quietly(scene, r.options, judged, limits);
    if (by_points) at_points.push_back(estimate(r.name, result, points));
    if (by_cells) over_cells.push_back(estimate(r.name, result, cells));
  }
  expect_same(at_points, expected_points, "points", limits);
  expect_same(over_cells, expected_cells, "cells", limits);
}

// n x n points, or centres of cells that tile the square: about `center`, spanned by the unit vectors s and t.
inline std::vector<P3> grid_about(const P3& center, const P3& s, const P3& t, double side, int n) {
  std::vector<P3> out;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      out.push_back(center + s * (((i + 0.5) / n - 0.5) * side) + t * (((j + 0.5) / n - 0.5) * side));
  return out;
}

}  // namespace ups::test
