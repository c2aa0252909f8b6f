// See map_labels.h.
#include "report/map_labels.h"

#include <algorithm>

namespace ups::report {

Point point_at(const std::vector<Point>& points, const std::vector<double>& along, double at) {
  const size_t i = std::clamp<size_t>(size_t(std::lower_bound(along.begin(), along.end(), at) - along.begin()), 1,
                                      points.size() - 1);
  const double t = along[i] > along[i - 1] ? (at - along[i - 1]) / (along[i] - along[i - 1]) : 0;
  const Point a = points[i - 1], b = points[i];
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

double turn_at(const std::vector<Point>& points, const std::vector<double>& along, double at, double half) {
  const Point a = point_at(points, along, std::max(at - half, 0.0));
  const Point b = point_at(points, along, std::min(at + half, along.back()));
  const double turn = std::atan2(b.y - a.y, b.x - a.x), quarter = std::acos(0.0);
  return turn > quarter ? turn - 2 * quarter : turn <= -quarter ? turn + 2 * quarter : turn;
}

double best_place(const std::vector<Point>& points, const std::vector<double>& along, double from, double to,
                  double half) {
  double best = -1, least = 0.35;
  constexpr int tries = 24;
  for (int i = 0; i <= tries && to > from; ++i) {
    const double at = from + (to - from) * i / tries;
    const Point a = point_at(points, along, std::max(at - half, 0.0)), m = point_at(points, along, at);
    const Point b = point_at(points, along, std::min(at + half, along.back()));
    const double chord = std::hypot(b.x - a.x, b.y - a.y);
    const double sagitta = std::abs((m.x - a.x) * (b.y - a.y) - (m.y - a.y) * (b.x - a.x)) / std::max(chord, 1e-9);
    const double bend = sagitta / std::max(chord, 1e-9);
    const double steep = std::abs(turn_at(points, along, at, half));
    const double folded = chord < 1.7 * half ? 1 : 0;
    const double badness = bend + 0.06 * steep + folded + 0.002 * std::abs(i - tries / 2);
    if (badness < least) least = badness, best = at;
  }
  return best;
}

}  // namespace ups::report
