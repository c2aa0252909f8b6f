// The grid of points that EN 12464-1 wants an area's illuminance measured and calculated at. Called by the API.
#pragma once
#include <cstdint>
#include <vector>

namespace ups {

struct PlanPoint {
  double x = 0, y = 0;  // m
};
using PlanOutline = std::vector<PlanPoint>;  // either way round

struct En12464Area {
  PlanOutline polygon;
  std::vector<PlanOutline> holes;
  double border;  // along the polygon and the holes that takes no part, m
};

struct En12464Grid {
  uint32_t columns, rows;
  PlanPoint origin, cell;  // corner of the first cell; a cell's sides
  double largest_spacing;  // p of the standard, m
  struct Point {
    PlanPoint at;
    uint32_t column, row;
  };
  std::vector<Point> points;  // column fastest; the cells whose centre takes part
};

// 0.2 * 5^log10(d) m, at most 10 m.
double en12464_largest_spacing(double d);
// Throws Error INVALID_ARGUMENT where those of polygon and holes are too many.
constexpr uint64_t most_en12464_corners = 4096;
void check_en12464_corners(uint64_t count);
// Throws Error INVALID_ARGUMENT that names the corner or hole.
En12464Grid en12464_grid(const En12464Area& area);

}  // namespace ups
