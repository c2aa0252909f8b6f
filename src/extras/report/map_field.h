// The values of a map as a surface: the cell of each, and what lies between them. Called by map.cpp and isolines.
#pragma once
#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <utility>

#include "report/map.h"

namespace ups::report {

struct MapBox {
  double left = INFINITY, low = INFINITY, right = -INFINITY, high = -INFINITY;
  void grow(const Place& p) {
    left = std::min(left, p.x), right = std::max(right, p.x);
    low = std::min(low, p.y), high = std::max(high, p.y);
  }
  bool empty() const { return !(left <= right); }
  double width() const { return right - left; }
  double height() const { return high - low; }
};

bool is_known(const MapValue& value);

// Values on a lattice along x and y, which may have gaps. Cell (c, r) is centred on its value; row 0 is the lowest.
struct Lattice {
  Place corner;          // the low left one of cell (0, 0)
  double step_x, step_y;
  uint32_t columns, rows;
  std::vector<uint32_t> value_of_cell;  // index of MapData::values; none: a gap, or a value that is not known
  static constexpr uint32_t none = 0xffffffffu;

  uint32_t at(int64_t column, int64_t row) const {
    const bool inside = column >= 0 && row >= 0 && column < int64_t(columns) && row < int64_t(rows);
    return inside ? value_of_cell[size_t(row) * columns + size_t(column)] : none;
  }
};

class MapField {
 public:
  explicit MapField(const MapData& data);

  // Points that lie on no lattice have none: then there is nothing between them.
  const std::optional<Lattice>& lattice() const { return lattice_; }
  // Closed, of a value; without a lattice what is nearer to it than to any other, as far as their spacing reaches.
  std::vector<Place> cell(size_t value) const;
  const MapBox& box() const { return box_; }  // of all cells; empty: more points than can be told apart without one

  // Between the values of a lattice, in cells from its corner, within the cell (column, row): smooth (Catmull-Rom), but
  // never beyond the four values around; beyond the outer ones as those. NaN in a gap.
  double between(double x, double y, int64_t column, int64_t row) const;
  // The value whose cell it is, or none.
  uint32_t nearest(const Place& p) const;

 private:
  double known(int64_t column, int64_t row, int64_t own_column, int64_t own_row) const;

  const MapData& data_;
  std::optional<Lattice> lattice_;
  // Of points without a lattice: their spacing, how far each reaches, and those of each square so wide.
  double spacing_ = 0;
  double reach() const { return 0.7 * spacing_; }
  std::pair<int64_t, int64_t> square_of(const Place& p) const {
    const auto whole = [&](double x) { return int64_t(std::clamp(std::floor(x / reach()), -1e15, 1e15)); };
    return {whole(p.x), whole(p.y)};
  }
  std::map<std::pair<int64_t, int64_t>, std::vector<uint32_t>> squares_;
  MapBox box_;
};

}  // namespace ups::report
