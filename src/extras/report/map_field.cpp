// See map_field.h.
#include "report/map_field.h"

#include <algorithm>
#include <cmath>

namespace ups::report {
namespace {

// The smallest gap between sorted coordinates that is more than rounding; 0: they are all alike.
double step_of(std::vector<double> values, double rounding) {
  std::sort(values.begin(), values.end());
  double step = 0;
  for (size_t i = 1; i < values.size(); ++i) {
    const double gap = values[i] - values[i - 1];
    if (gap > rounding) step = step > 0 ? std::min(step, gap) : gap;
  }
  return step;
}

std::optional<Lattice> grid_of(const MapData& data) {
  const size_t count = size_t(data.columns) * data.rows;
  if (count == 0 || count != data.values.size()) return std::nullopt;
  const Place first = data.values.front().at, last = data.values.back().at;
  Lattice l{first, 0, 0, data.columns, data.rows, {}};
  if (l.columns > 1) l.step_x = (last.x - first.x) / (l.columns - 1);
  if (l.rows > 1) l.step_y = (last.y - first.y) / (l.rows - 1);
  if (!(l.step_x > 0)) l.step_x = l.step_y > 0 ? l.step_y : 1;
  if (!(l.step_y > 0)) l.step_y = l.step_x;
  l.value_of_cell.resize(count);
  for (size_t i = 0; i < count; ++i) l.value_of_cell[i] = uint32_t(i);
  return l;
}

// Of points in any order. None where some lie beside it, or where it would be nearly empty.
std::optional<Lattice> lattice_of(const MapData& data) {
  constexpr double emptiest = 16, rounding = 1e-3;  // cells a point; of a step
  if (data.values.empty()) return std::nullopt;
  std::vector<double> xs, ys;
  MapBox box;
  for (const MapValue& v : data.values) xs.push_back(v.at.x), ys.push_back(v.at.y), box.grow(v.at);
  const double tiny = 1e-6 * std::max({box.width(), box.height(), 1e-9});
  double step_x = step_of(xs, tiny), step_y = step_of(ys, tiny);
  if (!(step_x > 0)) step_x = step_y > 0 ? step_y : 1;
  if (!(step_y > 0)) step_y = step_x;
  const double columns = std::round(box.width() / step_x) + 1, rows = std::round(box.height() / step_y) + 1;
  if (columns * rows > emptiest * double(data.values.size())) return std::nullopt;
  Lattice l{{box.left, box.low}, step_x, step_y, uint32_t(columns), uint32_t(rows), {}};
  l.value_of_cell.assign(size_t(columns * rows), Lattice::none);
  for (size_t i = 0; i < data.values.size(); ++i) {
    const double x = (data.values[i].at.x - box.left) / step_x, y = (data.values[i].at.y - box.low) / step_y;
    if (std::abs(x - std::round(x)) > rounding * columns || std::abs(y - std::round(y)) > rounding * rows)
      return std::nullopt;
    uint32_t& cell = l.value_of_cell[size_t(std::round(y)) * l.columns + size_t(std::round(x))];
    if (cell != Lattice::none) return std::nullopt;
    cell = uint32_t(i);
  }
  return l;
}

double distance2(const Place& a, const Place& b) { return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y); }

// The middle one of the distances to each point's nearest other.
double spacing_of(const std::vector<MapValue>& values) {
  std::vector<double> nearest;
  for (size_t i = 0; i < values.size(); ++i) {
    double least = INFINITY;
    for (size_t k = 0; k < values.size(); ++k) {
      const double d = distance2(values[i].at, values[k].at);
      if (d > 0) least = std::min(least, d);
    }
    if (std::isfinite(least)) nearest.push_back(std::sqrt(least));
  }
  if (nearest.empty()) return 1;
  std::nth_element(nearest.begin(), nearest.begin() + ptrdiff_t(nearest.size() / 2), nearest.end());
  return nearest[nearest.size() / 2];
}

// The part of a convex outline that is nearer to `own` than to `other`.
std::vector<Place> nearer_part(const std::vector<Place>& outline, const Place& own, const Place& other) {
  const double nx = other.x - own.x, ny = other.y - own.y;
  const double limit = 0.5 * (nx * (own.x + other.x) + ny * (own.y + other.y));
  const auto over = [&](const Place& p) { return nx * p.x + ny * p.y - limit; };
  std::vector<Place> part;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Place a = outline[i], b = outline[(i + 1) % outline.size()];
    const double at_a = over(a), at_b = over(b);
    if (at_a <= 0) part.push_back(a);
    if ((at_a < 0) != (at_b < 0) && at_a != at_b) {
      const double t = at_a / (at_a - at_b);
      if (t > 0 && t < 1) part.push_back({a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t});
    }
  }
  return part;
}

// Through b and c at 0 and 1.
double catmull_rom(double a, double b, double c, double d, double t) {
  return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

}  // namespace

bool is_known(const MapValue& value) { return std::isfinite(value.value) && value.value >= 0; }

MapField::MapField(const MapData& data) : data_(data), lattice_(data.columns > 0 ? grid_of(data) : lattice_of(data)) {
  if (lattice_) {
    Lattice& l = *lattice_;
    l.corner = {l.corner.x - 0.5 * l.step_x, l.corner.y - 0.5 * l.step_y};
    for (uint32_t& value : l.value_of_cell)
      if (value != Lattice::none && !is_known(data.values[value])) value = Lattice::none;
    box_.grow(l.corner);
    box_.grow({l.corner.x + l.columns * l.step_x, l.corner.y + l.rows * l.step_y});
    return;
  }
  constexpr size_t most = 20000;
  if (data.values.size() > most) return;
  spacing_ = spacing_of(data.values);
  for (size_t i = 0; i < data.values.size(); ++i) squares_[square_of(data.values[i].at)].push_back(uint32_t(i));
  for (size_t i = 0; i < data.values.size(); ++i)
    for (const Place& p : cell(i)) box_.grow(p);
}

std::vector<Place> MapField::cell(size_t value) const {
  const Place at = data_.values[value].at;
  const double x = lattice_ ? 0.5 * lattice_->step_x : reach(), y = lattice_ ? 0.5 * lattice_->step_y : x;
  std::vector<Place> outline = {{at.x - x, at.y - y}, {at.x + x, at.y - y}, {at.x + x, at.y + y}, {at.x - x, at.y + y}};
  if (lattice_) return outline;
  for (const MapValue& other : data_.values) {
    const double d = distance2(other.at, at);
    if (d > 0 && d < 8 * x * x) outline = nearer_part(outline, at, other.at);
  }
  return outline;
}

// Beyond the border and in gaps the nearest one on the way to the own cell.
double MapField::known(int64_t column, int64_t row, int64_t own_column, int64_t own_row) const {
  int64_t c = std::clamp<int64_t>(column, 0, lattice_->columns - 1);
  int64_t r = std::clamp<int64_t>(row, 0, lattice_->rows - 1);
  while (lattice_->at(c, r) == Lattice::none) {
    if (std::abs(c - own_column) > std::abs(r - own_row))
      c += c < own_column ? 1 : -1;
    else
      r += r < own_row ? 1 : -1;
  }
  return data_.values[lattice_->at(c, r)].value;
}

double MapField::between(double x, double y, int64_t column, int64_t row) const {
  if (!lattice_ || lattice_->at(column, row) == Lattice::none) return NAN;
  const double from_x = std::floor(x - 0.5), from_y = std::floor(y - 0.5);
  const auto clamped = [](double v, int64_t own) { return int64_t(std::clamp(v, double(own - 2), double(own + 2))); };
  double rows[4], low = INFINITY, high = -INFINITY;
  for (int r = 0; r < 4; ++r) {
    double v[4];
    for (int c = 0; c < 4; ++c) {
      v[c] = known(clamped(from_x + c - 1, column), clamped(from_y + r - 1, row), column, row);
      const bool around = r >= 1 && r <= 2 && c >= 1 && c <= 2;
      if (around) low = std::min(low, v[c]), high = std::max(high, v[c]);
    }
    rows[r] = catmull_rom(v[0], v[1], v[2], v[3], x - 0.5 - from_x);
  }
  return std::clamp(catmull_rom(rows[0], rows[1], rows[2], rows[3], y - 0.5 - from_y), low, high);
}

uint32_t MapField::nearest(const Place& p) const {
  if (lattice_) {
    const Lattice& l = *lattice_;
    return l.at(int64_t(std::floor((p.x - l.corner.x) / l.step_x)), int64_t(std::floor((p.y - l.corner.y) / l.step_y)));
  }
  uint32_t best = Lattice::none;
  double least = INFINITY;
  const auto [column, row] = square_of(p);
  for (int64_t c = column - 1; c <= column + 1; ++c) {
    for (int64_t r = row - 1; r <= row + 1; ++r) {
      const auto square = squares_.find({c, r});
      if (square == squares_.end()) continue;
      for (const uint32_t i : square->second) {
        const Place at = data_.values[i].at;
        if (std::max(std::abs(at.x - p.x), std::abs(at.y - p.y)) > reach()) continue;
        if (const double d = distance2(at, p); d < least) least = d, best = i;
      }
    }
  }
  return best != Lattice::none && is_known(data_.values[best]) ? best : Lattice::none;
}

}  // namespace ups::report
