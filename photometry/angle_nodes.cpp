// See angle_nodes.h.
#include "photometry/angle_nodes.h"

#include <algorithm>
#include <cmath>

namespace photometry {
namespace {

constexpr double least_deg = 0.05;
constexpr double degree = 3.14159265358979323846 / 180;
constexpr size_t least_band = 30;  // rays that tell how dense they are
constexpr double dark = 25;        // rays that a gap lacks: by chance with exp(-25)

class NodeFinder {
 public:
  NodeFinder(const std::vector<WeightedAngle>& angles, const NodeRange& range)
      : angles_(angles), range_(range), band_(std::max(least_band, angles.size() / range.bands)) {}
  std::vector<double> find();

 private:
  // What evenly spread rays between two angles are proportional to.
  double measure(double a, double b) const {
    return range_.polar ? 2 * std::sin(0.5 * (a + b) * degree) * std::sin(0.5 * (b - a) * degree) : b - a;
  }
  // Steps of nodes there, a power of ten.
  static double unit(double width) { return std::pow(10, std::floor(std::log10(std::max(width, least_deg) / 50))); }
  static double rounded(double angle, double unit, double (*round)(double)) {
    const double per_unit = std::round(1 / unit);  // exact, as the units are below 1
    return unit < 1 ? round(angle * per_unit) / per_unit : round(angle / unit) * unit;
  }
  double density(size_t from, size_t to) const;  // rays a measure
  void add_edges(size_t next);
  void add_edge(size_t from, size_t to, bool upper);
  void add_quantiles();
  void fill();

  const std::vector<WeightedAngle>& angles_;
  const NodeRange& range_;
  const size_t band_;
  size_t lit_from_ = 0;  // first ray after the last gap
  std::vector<double> nodes_;
};

double NodeFinder::density(size_t from, size_t to) const {
  const double a = angles_[from].deg, b = angles_[to - 1].deg;
  const double whole = measure(range_.first_deg, range_.last_deg);
  return double(to - from) / std::max(measure(a, std::max(a, b)), 1e-15 * whole);
}

// The edge of the rays [from, to): above the last, or below the first.
void NodeFinder::add_edge(size_t from, size_t to, bool upper) {
  const double u = unit(angles_[to - 1].deg - angles_[from].deg);
  const double edge = upper ? rounded(angles_[to - 1].deg, u, std::ceil) : rounded(angles_[from].deg, u, std::floor);
  nodes_.push_back(edge);
  nodes_.push_back(rounded(upper ? edge + u : edge - u, u, std::round));
}

// Of the gap between the rays next - 1 and next, if it is one.
void NodeFinder::add_edges(size_t next) {
  const size_t n = angles_.size();
  const double low = next > 0 ? angles_[next - 1].deg : range_.first_deg,
               high = next < n ? angles_[next].deg : range_.last_deg;
  const bool below = next > 0, above = next < n;
  if ((below && next - lit_from_ < band_) || (above && n - next < band_)) return;
  const size_t from = next - std::min(next, band_), to = std::min(n, next + band_);
  const double densest = std::max(below ? density(from, next) : 0, above ? density(next, to) : 0);
  if (!(densest * measure(low, high) > dark)) return;
  const double below_unit = below ? unit(low - angles_[from].deg) : 0,
               above_unit = above ? unit(angles_[to - 1].deg - high) : 0;
  if (high - low < 5 * (below_unit + above_unit)) return;
  if (below) add_edge(from, next, true);
  if (above) add_edge(next, to, false);
  lit_from_ = next;
}

void NodeFinder::add_quantiles() {
  double total = 0, sum = 0;
  for (const WeightedAngle& a : angles_) total += a.weight;
  std::vector<double> quantile;
  for (const WeightedAngle& a : angles_) {
    sum += a.weight;
    while (quantile.size() + 1 < range_.bands && sum >= total * double(quantile.size() + 1) / double(range_.bands))
      quantile.push_back(a.deg);
  }
  const std::vector<double> edges = nodes_;  // which quantiles keep away from
  double last = range_.first_deg;
  for (size_t k = 0; k < quantile.size(); ++k) {
    const double width = (k + 1 < quantile.size() ? quantile[k + 1] : angles_.back().deg) - quantile[k];
    const double node = rounded(quantile[k], unit(width), std::round), apart = std::max(least_deg, 0.2 * width);
    const bool near_edge =
        std::any_of(edges.begin(), edges.end(), [&](double e) { return std::abs(e - node) < apart; });
    if (near_edge || node - last < apart) continue;
    nodes_.push_back(node);
    last = node;
  }
}

// Sorts, and parts what is too wide.
void NodeFinder::fill() {
  const auto outside = [&](double a) { return a < range_.first_deg || a > range_.last_deg; };
  nodes_.erase(std::remove_if(nodes_.begin(), nodes_.end(), outside), nodes_.end());
  std::sort(nodes_.begin(), nodes_.end());
  const auto same = [](double a, double b) { return b - a < 1e-9; };
  nodes_.erase(std::unique(nodes_.begin(), nodes_.end(), same), nodes_.end());
  std::vector<double> all;
  for (size_t i = 0; i + 1 < nodes_.size(); ++i) {
    const double width = nodes_[i + 1] - nodes_[i], parts = std::max(1.0, std::ceil(width / range_.widest_deg - 1e-9));
    all.push_back(nodes_[i]);
    for (double k = 1; k < parts; ++k)
      all.push_back(rounded(nodes_[i] + k * width / parts, unit(width / parts), std::round));
  }
  all.push_back(nodes_.back());
  nodes_ = std::move(all);
}

std::vector<double> NodeFinder::find() {
  for (double a = range_.first_deg; a < range_.last_deg; a += range_.always_deg) nodes_.push_back(a);
  nodes_.push_back(range_.last_deg);
  for (size_t next = 0; next <= angles_.size(); ++next) add_edges(next);
  add_quantiles();
  fill();
  return std::move(nodes_);
}

}  // namespace

std::vector<double> angle_nodes(const std::vector<WeightedAngle>& angles, const NodeRange& range) {
  return NodeFinder(angles, range).find();
}

}  // namespace photometry
