// See pilot.h.
#include "transport/pilot.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ups {

namespace {

class Pilot {
 public:
  Pilot(const Snapshot& scene, const Plan& plan, const Moments& moments)
      : scene_(scene), plan_(plan), sets_(moments.count()), row_(moments.row()) {
    for (const auto sums : sums_of_unit) (m_.*sums).resize(plan.units.count);
    m_.eye_share.resize(plan.units.count), m_.focused.resize(plan.units.count);
    m_.excess.assign(plan.units.count, std::vector<double>(sets_));
    for (size_t c = 0; c < scene.cameras.size(); ++c) {
      std::vector<Point>& points = points_.emplace_back();
      plan.for_visited_pixels(0, scene.cameras[c].width(), scene.cameras[c].height(),
                              [&](uint32_t, uint32_t pixel) { points.push_back({plan.units.of_pixel(c, pixel)}); });
    }
    for (size_t s = 0; s < scene.meter_sets.size(); ++s)
      points_.emplace_back(plan.visited_meters(0, scene.meter_sets[s].meters.size()), Point{plan.units.of_set(s)});
  }

  void add(const Iteration& in, const IterationTally& tally) {
    const Units& units = plan_.units;
    const size_t cameras = scene_.cameras.size();
    for (size_t c = 0; c < cameras; ++c) {
      const Camera& camera = scene_.cameras[c];
      plan_.for_visited_pixels(in.number, camera.width(), camera.height(), [&](uint32_t i, uint32_t pixel) {
        points_[c][i].of_iterations.add(luminance(tally.pixels[c][i]));
        take(units.of_pixel(c, pixel), &tally.excess_of_pixels[c][i * row_], 1, 1, false, points_[c][i]);
      });
      // A visit's splats are the mean of camera_subsets iterations' (1 / subsets of one's variance), and fall on all
      // pixels, of which one of camera_subsets is visited (as much again).
      const double of_visited = 1.0 / plan_.camera_subsets;
      Point none{};
      for (uint32_t t = 0; t < units.tiles(c); ++t)
        take(units.begin(c) + t, &tally.excess_of_splats[c][t * row_], of_visited, 0, false, none);
      for (const Splat& s : tally.splats[c]) {
        const double v = luminance(s.value) * of_visited;
        m_.variance[units.of_pixel(c, s.pixel)] += v * v / pilot_rounds;
      }
    }
    for (size_t s = 0; s < scene_.meter_sets.size(); ++s)
      for (size_t i = 0; i < tally.meters[s].size(); ++i) {
        Point& point = points_[cameras + s][i];
        point.of_iterations.add(tally.meters[s][i].value);
        m_.eye_share[units.of_set(s)] += plan_.meter_samples;
        take(units.of_set(s), &tally.excess_of_meters[s][i * row_], 1, plan_.meter_samples, true, point);
      }
    m_.all.add(tally.work);
    m_.light_work.add(tally.light_work);
  }

  const Measured& measured() {
    const size_t cameras = scene_.cameras.size();
    for (size_t s = 0; s < points_.size(); ++s)
      for (const Point& point : points_[s]) {
        const uint32_t unit = point.unit;
        ++m_.visited[unit];
        m_.reading[unit] += point.of_iterations.mean();
        m_.variance[unit] += point.of_iterations.variance();
        m_.independent[unit] += point.of_paths.variance() * (s < cameras ? 1 : plan_.meter_samples);
        if (s >= cameras) m_.focused[unit] = std::max(m_.focused[unit], point.focused());
      }
    for (size_t c = 0; c < cameras; ++c) share_eye_paths(c);
    double paths = 0;
    for (const double share : m_.eye_share) paths += share;
    for (double& share : m_.eye_share) share /= std::max(1.0, paths);
    const Measured own = m_;
    for (size_t c = 0; c < cameras; ++c) pool_tiles(own, c);
    return m_;
  }

 private:
  struct Sums {
    double sum = 0, square = 0;
    uint32_t count = 0;
    void add(double v) { sum += v, square += v * v, ++count; }
    double mean() const { return sum / count; }
    double variance() const { return count < 2 ? 0.0 : std::max(0.0, (square - sum * sum / count) / (count - 1)); }
  };
  struct Point {
    uint32_t unit = 0;
    Sums of_iterations{}, of_paths{};
    double caustic = 0, landed2 = 0;  // landed2: squares of what light paths brought
    // A few photons are chance, of many meters some meter's: three standard errors are left out.
    double focused() const {
      const double beyond_chance = caustic - 3 * std::sqrt(landed2);
      return beyond_chance > 0 ? beyond_chance / of_iterations.sum : 0.0;
    }
  };
  void take(uint32_t unit, const double* row, double scale, uint32_t eye_paths, bool landed, Point& point) {
    const double square = scale * scale;
    for (size_t j = 0; j < sets_; ++j) m_.excess[unit][j] += row[j] * square / pilot_rounds;
    m_.independent[unit] += row[sets_ + 2] * square / pilot_rounds;
    if (landed) m_.landed[unit] += row[sets_ + 2] * square / pilot_rounds;
    m_.light[unit] += row[sets_ + 3] * scale;
    m_.caustic[unit] += row[sets_ + 4] * scale;
    point.of_paths.sum += row[sets_], point.of_paths.square += row[sets_ + 1], point.of_paths.count += eye_paths;
    point.caustic += row[sets_ + 4], point.landed2 += row[sets_ + 2];
  }

  // A tile's, by its pixels: it may have been visited once too often, or not at all.
  void share_eye_paths(size_t camera) {
    const Units& units = plan_.units;
    double visits = 0;
    for (const Point& point : points_[camera]) visits += point.of_iterations.count;
    const auto pixels = uint32_t(scene_.cameras[camera].pixel_count());
    for (uint32_t p = 0; p < pixels; ++p) m_.eye_share[units.of_pixel(camera, p)] += visits / pixels;
  }

  static constexpr std::vector<double> Measured::*sums_of_unit[] = {
      &Measured::visited, &Measured::reading, &Measured::variance, &Measured::independent,
      &Measured::landed,  &Measured::light,   &Measured::caustic};
  void add_sums(const Measured& own, uint32_t other, uint32_t unit) {
    for (const auto sums : sums_of_unit) (m_.*sums)[unit] += (own.*sums)[other];
    for (size_t k = 0; k < sets_; ++k) m_.excess[unit][k] += own.excess[other][k];
  }

  // Tiles are noisy: each is judged with its neighbours; of a large image, whose pilot visits few pixels, squares of so
  // many of them that no single pixel decides.
  void pool_tiles(const Measured& own, size_t camera) {
    constexpr double least_pixels = 2;  // of a square on the average: with its neighbours' some 18
    const Units& units = plan_.units;
    const auto columns = int(units.columns(camera)), rows = int(units.tiles(camera)) / columns;
    double visited = 0;
    for (uint32_t u = units.begin(camera); u < units.end(camera); ++u) visited += own.visited[u];
    const int side = std::max(1, int(std::ceil(std::sqrt(least_pixels * units.tiles(camera) / std::max(1.0, visited)))));
    const auto unit_at = [&](int x, int y) { return units.begin(camera) + uint32_t(y * columns + x); };
    for (int top = 0; top < rows; top += side)
      for (int left = 0; left < columns; left += side) {
        const uint32_t first = unit_at(left, top);
        for (int y = std::max(0, top - side); y < std::min(rows, top + 2 * side); ++y)
          for (int x = std::max(0, left - side); x < std::min(columns, left + 2 * side); ++x)
            if (unit_at(x, y) != first) add_sums(own, unit_at(x, y), first);
        for (int y = top; y < std::min(rows, top + side); ++y)
          for (int x = left; x < std::min(columns, left + side); ++x) {
            for (const auto sums : sums_of_unit) (m_.*sums)[unit_at(x, y)] = (m_.*sums)[first];
            m_.excess[unit_at(x, y)] = m_.excess[first];
          }
      }
  }

  const Snapshot& scene_;
  const Plan& plan_;
  const size_t sets_, row_;
  Measured m_;
  std::vector<std::vector<Point>> points_;  // that are visited: cameras' pixels, then sets' meters
};

}  // namespace

// A lattice of rank 1: its generator near the golden section, prime to the number of points.
uint32_t spread_shift(uint32_t subsets) {
  auto shift = uint32_t(std::lround(0.6180339887 * subsets));
  while (shift > 1 && std::gcd(shift, subsets) != 1) --shift;
  return std::max(1u, shift);
}

Plan pilot_plan(const Snapshot& scene, const Plan& plan, const TransportSettings& settings) {
  Plan pilot = plan;
  set_path_counts(scene, settings, pilot_paths, pilot);
  pilot.pilot_shift = spread_shift(pilot.camera_subsets);
  pilot.meter_samples = plan.meter_samples;
  const size_t times = scene.meter_count() * plan.meter_samples / (pilot_paths * plan.meter_subsets);
  pilot.meter_subsets = plan.meter_subsets * uint32_t(times | 1);
  return pilot;
}

bool run_pilot(const Snapshot& scene, const Plan& plan, const TransportSettings& settings, const StopSignal& stop,
               const TraceIteration& trace, const Moments& moments, Measured& out) {
  Pilot pilot(scene, plan, moments);
  IterationTally tally;
  const uint64_t subsets = uint64_t(plan.camera_subsets) * plan.meter_subsets;
  if (subsets > UINT32_MAX / pilot_rounds) return false;  // 10^9 pixels beside 10^7 meters: numbers end
  for (uint32_t k = 0; k < pilot_rounds; ++k) {  // the same pixels and meters again
    Iteration in = Iteration::of_pilot(scene, plan, settings, k * uint32_t(subsets), stop, Stream::pilot);
    in.light_visit = in.camera_visit = in.meter_visit = {k, 0};
    in.moments = &moments;
    if (!trace(in, tally)) return false;
    pilot.add(in, tally);
  }
  out = pilot.measured();
  return true;
}

}  // namespace ups
