// Do samples follow the density that they claim? Pearson's chi-square test, and cells on the sphere with the integral
// of a density over each. Used by the statistical tests of every sampler; needs no test framework.
//
//   SphereCells cells(20, 40);
//   observed[cells.index(direction)] += 1;                      // count all samples
//   expected = cells.integrate([&](const Vec3d& d) { return pdf(Vec3(d)); }), times the number of samples
//   const ChiSquareResult r = chi_square_test(observed, expected);
//   r.p_value, and smallest_found(samples, r.degrees_of_freedom, level): what it is worth
//
// Samples that fail need a cell of their own, so that both vectors have the same total.
#pragma once
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numeric>
#include <vector>

#include "base/frame.h"
#include "base/vec.h"

namespace ups::test {

// P(a, x), the regularised lower incomplete gamma function: series below a + 1, continued fraction (modified Lentz)
// above; Abramowitz and Stegun 6.5.29 and 6.5.31. Returns its complement Q = 1 - P.
inline double gamma_q(double a, double x) {
  if (!(x > 0)) return 1;
  const double scale = std::exp(a * std::log(x) - x - std::lgamma(a));
  constexpr double epsilon = 1e-15;
  if (x < a + 1) {
    double term = 1 / a, sum = term;
    for (double n = a + 1; term > sum * epsilon; ++n) sum += term *= x / n;
    return std::max(0.0, 1 - scale * sum);
  }
  double b = x + 1 - a, c = 1e300, d = 1 / b, h = d;
  for (int i = 1; i < 100000; ++i) {
    const double an = -i * (i - a);
    b += 2;
    d = 1 / (an * d + b);
    c = b + an / c;
    h *= c * d;
    if (std::abs(c * d - 1) < epsilon) break;
  }
  return std::min(1.0, scale * h);
}

struct ChiSquareResult {
  double statistic = 0;
  int degrees_of_freedom = 0;  // 0: a single pooled cell, nothing could be tested (p_value is 1)
  double p_value = 1;          // of a statistic at least this large, were the density right
};

// Pools cells, smallest first, until each expects 5 or more. Something observed where nothing at all is expected has
// p = 0.
inline ChiSquareResult chi_square_test(const std::vector<double>& observed, const std::vector<double>& expected) {
  std::vector<size_t> order(std::min(observed.size(), expected.size()));
  std::iota(order.begin(), order.end(), size_t(0));
  std::stable_sort(order.begin(), order.end(), [&](size_t a, size_t b) { return expected[a] < expected[b]; });

  ChiSquareResult result;
  std::vector<std::array<double, 2>> pools;  // observed, expected
  std::array<double, 2> pool{0, 0};
  for (size_t i : order) {
    if (!(expected[i] > 0)) {
      if (observed[i] > 0) return {std::numeric_limits<double>::infinity(), 1, 0};
      continue;
    }
    pool[0] += observed[i];
    pool[1] += expected[i];
    if (pool[1] >= 5) {
      pools.push_back(pool);
      pool = {0, 0};
    }
  }
  if (pool[1] > 0) {  // a rest of less than 5
    if (pools.empty()) pools.push_back({0, 0});
    pools.back()[0] += pool[0];
    pools.back()[1] += pool[1];
  }
  for (const auto& [o, e] : pools) result.statistic += (o - e) * (o - e) / e;
  result.degrees_of_freedom = std::max(0, int(pools.size()) - 1);
  if (result.degrees_of_freedom > 0) result.p_value = gamma_q(0.5 * result.degrees_of_freedom, 0.5 * result.statistic);
  return result;
}

// What chance alone passes with probability `level`.
inline double chi_square_quantile(int degrees_of_freedom, double level) {
  double low = 0, high = 1;
  while (gamma_q(0.5 * degrees_of_freedom, 0.5 * high) > level) low = high, high *= 2;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (gamma_q(0.5 * degrees_of_freedom, 0.5 * middle) > level ? low : high) = middle;
  }
  return high;
}

// The smallest error of a density that a test of that level finds in 97.7 of 100 cases: relative, the root of its mean
// square over the samples, as the cells see it. With an error e the statistic of n samples is chi-square with the
// noncentrality n e^2 (Patnaik 1949), of mean k + n e^2 and variance 2 (k + 2 n e^2): the mean less two standard
// deviations reaches what `level` allows. The true share is 97.8 to 99 cases, as the distribution leans to the right.
inline double smallest_found(double samples, int degrees_of_freedom, double level) {
  const double k = degrees_of_freedom, beyond = chi_square_quantile(degrees_of_freedom, level) - k;
  return std::sqrt((beyond + 8 + std::sqrt(16 * beyond + 64 + 8 * k)) / samples);
}

// The level that each of `tests` tests must be held to, so that any of them fails by chance with probability `alpha`
// (Sidak).
inline double sidak_level(double alpha, int tests) { return -std::expm1(std::log1p(-alpha) / tests); }

// Cells of the sphere: rows in 1 - cos(theta) about an axis, columns in phi. Half of the rows are even from 0 to
// `width`, half even in the logarithm from there to 2, so that a lobe of angle a about the axis is resolved with a
// width of about a^2, and so is what lies around it. The default is even everywhere.
class SphereCells {
 public:
  SphereCells(int rows, int columns, const Vec3d& axis = {0, 0, 1},
              double width = std::numeric_limits<double>::infinity())
      : rows_(rows), columns_(columns), width_(width), n_(normalize(axis)) {
    const Frame frame{Vec3(n_)};
    s_ = normalize(Vec3d(frame.s) - n_ * dot(Vec3d(frame.s), n_));
    t_ = cross(n_, s_);
  }
  size_t size() const { return size_t(rows_) * columns_; }

  size_t index(const Vec3& direction) const {
    const Vec3d d = normalize(Vec3d(direction));
    const Vec3d from_axis = d - n_;
    const double u = 0.5 * length2(from_axis);  // 1 - cos(theta), without cancellation
    const double r = row_coordinate(u);
    double phi = std::atan2(dot(d, t_), dot(d, s_)) / (2 * pi_d);
    if (phi < 0) phi += 1;
    return size_t(std::clamp(int(r * rows_), 0, rows_ - 1)) * columns_ +
           std::clamp(int(phi * columns_), 0, columns_ - 1);
  }

  // The integral of pdf(Vec3d) -> double over each cell, to about `tolerance` a cell: a cell is cut in four until that
  // agrees (4 x 4 Gauss points each), at most `depth` times and at least `min_depth` times, lest a corner be missed.
  template <class Pdf>
  std::vector<double> integrate(const Pdf& pdf, double tolerance = 1e-6, int depth = 8, int min_depth = 1) const {
    std::vector<double> out(size());
    for (int i = 0; i < rows_; ++i)
      for (int j = 0; j < columns_; ++j) {
        const Box box{double(i) / rows_, double(i + 1) / rows_, double(j) / columns_, double(j + 1) / columns_};
        out[size_t(i) * columns_ + j] = refine(pdf, box, gauss(pdf, box), tolerance, depth, min_depth);
      }
    return out;
  }

 private:
  struct Box {
    double r0, r1, p0, p1;
  };
  static constexpr double pi_d = 3.141592653589793238463;

  double row_coordinate(double u) const {
    if (std::isinf(width_)) return 0.5 * u;
    return u < width_ ? 0.5 * u / width_ : 0.5 + 0.5 * std::log(u / width_) / std::log(2 / width_);
  }

  template <class Pdf>
  double gauss(const Pdf& pdf, const Box& b) const {
    static constexpr double x[4] = {0.06943184420297371, 0.33000947820757187, 0.6699905217924281, 0.9305681557970263};
    static constexpr double w[4] = {0.17392742256872693, 0.32607257743127307, 0.32607257743127307, 0.17392742256872693};
    double sum = 0;
    for (int i = 0; i < 4; ++i) {
      const double r = b.r0 + (b.r1 - b.r0) * x[i], growth = std::isinf(width_) ? 0 : 2 * std::log(2 / width_);
      const bool near = std::isinf(width_) || r < 0.5;
      const double u = std::isinf(width_) ? 2 * r : near ? 2 * width_ * r : width_ * std::exp((r - 0.5) * growth);
      const double du_dr = std::isinf(width_) ? 2 : near ? 2 * width_ : u * growth, sine = std::sqrt(u * (2 - u));
      for (int j = 0; j < 4; ++j) {
        const double phi = 2 * pi_d * (b.p0 + (b.p1 - b.p0) * x[j]);
        const Vec3d d = n_ * (1 - u) + s_ * (sine * std::cos(phi)) + t_ * (sine * std::sin(phi));
        sum += w[i] * w[j] * du_dr * double(pdf(d));
      }
    }
    return sum * (b.r1 - b.r0) * (b.p1 - b.p0) * 2 * pi_d;
  }

  template <class Pdf>
  double refine(const Pdf& pdf, const Box& b, double whole, double tolerance, int depth, int min_depth) const {
    const double r = 0.5 * (b.r0 + b.r1), p = 0.5 * (b.p0 + b.p1);
    const Box quarters[4] = {{b.r0, r, b.p0, p}, {b.r0, r, p, b.p1}, {r, b.r1, b.p0, p}, {r, b.r1, p, b.p1}};
    double part[4], sum = 0;
    for (int k = 0; k < 4; ++k) sum += part[k] = gauss(pdf, quarters[k]);
    if (depth <= 1 || (min_depth <= 1 && std::abs(sum - whole) <= tolerance)) return sum;
    sum = 0;
    for (int k = 0; k < 4; ++k) sum += refine(pdf, quarters[k], part[k], tolerance / 2, depth - 1, min_depth - 1);
    return sum;
  }

  int rows_, columns_;
  double width_;
  Vec3d n_, s_, t_;
};

}  // namespace ups::test
