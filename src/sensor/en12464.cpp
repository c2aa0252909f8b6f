// See en12464.h. EN 12464-1, "Illuminance grid": p = 0.2 * 5^log10(d), d the longer side of the area or, where that is
// at least twice the shorter, the shorter one; so many points that none are further apart than p, in cells that are at
// most twice as long as wide.
#include "sensor/en12464.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "base/text.h"

namespace ups {

namespace {

constexpr uint32_t most_points = 16'777'216;
constexpr double most_tests = 0x1p32;  // of a point against a corner
constexpr double rounding = 1e-9;  // relative, of coordinates

std::string text(double value) { return short_number(value, 6); }
std::string text(const PlanPoint& p) { return std::string("(").append(text(p.x)) + ", " + text(p.y) + ")"; }

double turn(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c) {
  return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

const PlanPoint& next(const PlanOutline& o, size_t i) { return o[i + 1 < o.size() ? i + 1 : 0]; }

double distance(const PlanPoint& p, const PlanPoint& a, const PlanPoint& b) {
  const double x = b.x - a.x, y = b.y - a.y, length2 = x * x + y * y;
  const double t = length2 > 0 ? std::clamp(((p.x - a.x) * x + (p.y - a.y) * y) / length2, 0.0, 1.0) : 0;
  return std::hypot(p.x - a.x - t * x, p.y - a.y - t * y);
}
double distance(const PlanPoint& p, const PlanOutline& o) {
  double least = INFINITY;
  for (size_t i = 0; i < o.size(); ++i) least = std::min(least, distance(p, o[i], next(o, i)));
  return least;
}

bool is_inside(const PlanPoint& p, const PlanOutline& o) {
  bool inside = false;
  for (size_t i = 0; i < o.size(); ++i) {
    const PlanPoint &a = o[i], &b = next(o, i);
    if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

bool meet(const PlanPoint& a, const PlanPoint& b, const PlanPoint& c, const PlanPoint& d) {
  const auto between = [](const PlanPoint& p, const PlanPoint& q, const PlanPoint& r) {  // all three on a line
    return std::min(p.x, q.x) <= r.x && r.x <= std::max(p.x, q.x) && std::min(p.y, q.y) <= r.y &&
           r.y <= std::max(p.y, q.y);
  };
  const double abc = turn(a, b, c), abd = turn(a, b, d), cda = turn(c, d, a), cdb = turn(c, d, b);
  if (((abc > 0 && abd < 0) || (abc < 0 && abd > 0)) && ((cda > 0 && cdb < 0) || (cda < 0 && cdb > 0))) return true;
  return (abc == 0 && between(a, b, c)) || (abd == 0 && between(a, b, d)) || (cda == 0 && between(c, d, a)) ||
         (cdb == 0 && between(c, d, b));
}

double area_of(const PlanOutline& o) {
  double sum = 0;
  for (size_t i = 1; i + 1 < o.size(); ++i) sum += turn(o[0], o[i], o[i + 1]);
  return 0.5 * std::abs(sum);
}

// Of its own corners, by their numbers; name: of the outline.
void check_outline(const PlanOutline& o, const std::string& name) {
  if (o.size() < 3)
    fail_argument(name + " has " + std::to_string(o.size()) + " corners; it must have at least 3");
  double size = 0;
  for (size_t i = 0; i < o.size(); ++i) {
    if (!std::isfinite(o[i].x) || !std::isfinite(o[i].y) || std::hypot(o[i].x, o[i].y) > 1e9)
      fail_argument(name + ": corner " + std::to_string(i) + " is " + text(o[i]) +
                    "; it must be finite and within 1e+09 m of the origin");
    size = std::max(size, std::hypot(o[i].x - o[0].x, o[i].y - o[0].y));
  }
  for (size_t i = 0; i < o.size(); ++i)
    if (o[i].x == next(o, i).x && o[i].y == next(o, i).y)
      fail_argument(name + ": corner " + std::to_string((i + 1) % o.size()) + " " + text(o[i]) +
                    " repeats the one before; each is given once, the first not again at the end");
  for (size_t i = 0; i < o.size(); ++i)
    for (size_t j = i + 2; j < o.size() - (i == 0); ++j)
      if (meet(o[i], next(o, i), o[j], next(o, j)))
        fail_argument(name + ": its side from corner " + std::to_string(i) + " " + text(o[i]) +
                      " meets that from corner " + std::to_string(j) + " " + text(o[j]) +
                      "; an outline must not cross or touch itself");
  if (!(area_of(o) > rounding * size * size))
    fail_argument(name + " has no area; its corners must not lie on one line");
}

struct Extent {
  PlanPoint low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
  double width() const { return high.x - low.x; }
  double height() const { return high.y - low.y; }
};
Extent extent_of(const PlanOutline& o) {
  Extent e;
  for (const PlanPoint& p : o) {
    e.low = {std::min(e.low.x, p.x), std::min(e.low.y, p.y)};
    e.high = {std::max(e.high.x, p.x), std::max(e.high.y, p.y)};
  }
  return e;
}

void check_area(const En12464Area& area) {
  uint64_t corners = area.polygon.size();
  for (const PlanOutline& hole : area.holes) corners += hole.size();
  check_en12464_corners(corners);
  check_outline(area.polygon, "polygon");
  const Extent e = extent_of(area.polygon);
  const double slack = rounding * (std::hypot(e.width(), e.height()) + std::hypot(e.low.x, e.low.y));
  for (size_t h = 0; h < area.holes.size(); ++h) {
    const std::string name = "hole " + std::to_string(h);
    check_outline(area.holes[h], name);
    for (size_t i = 0; i < area.holes[h].size(); ++i)
      if (const PlanPoint& p = area.holes[h][i];
          !is_inside(p, area.polygon) && distance(p, area.polygon) > slack)
        fail_argument(name + ": corner " + std::to_string(i) + " " + text(p) +
                      " lies outside the polygon; a hole must lie within it");
  }
  if (!(area.border >= 0 && std::isfinite(area.border)))
    fail_argument("border is " + text(area.border) + " m; it must be finite and at least 0");
}

[[noreturn]] void fail_of_border(const En12464Area& area, const Extent& e) {
  fail_argument("the border of " + text(area.border) + " m leaves no point of the polygon of " + text(e.width()) +
                " x " + text(e.height()) + " m" + (area.holes.empty() ? "" : " with its holes") +
                "; a narrower border would be right, or 0 where the task lies at the walls");
}

double count_for(double side, double spacing) { return std::max(1.0, std::ceil(side / spacing - 1e-6)); }

// More cells along what is more than twice the other side; both within p stay so.
void limit_aspect(double width, double height, double& columns, double& rows) {
  const auto least = [](double side, double other, double others) {  // but for rounding
    return std::floor(side * others / (2 * other * (1 + rounding)));
  };
  columns = std::max(columns, least(width, height, rows));
  while (width / columns > 2 * (height / rows) * (1 + rounding) && columns < most_points) ++columns;
  rows = std::max(rows, least(height, width, columns));
  while (height / rows > 2 * (width / columns) * (1 + rounding) && rows < most_points) ++rows;
}

}  // namespace

double en12464_largest_spacing(double d) { return std::min(10.0, 0.2 * std::pow(5.0, std::log10(d))); }

void check_en12464_corners(uint64_t count) {
  if (count > most_en12464_corners)
    fail_argument("the polygon and its holes have " + std::to_string(count) + " corners or more; " +
                  std::to_string(most_en12464_corners) + " are the most");
}

En12464Grid en12464_grid(const En12464Area& area) {
  check_area(area);
  const Extent e = extent_of(area.polygon);
  const double width = e.width() - 2 * area.border, height = e.height() - 2 * area.border;
  const double slack = rounding * (std::max(width, height) + std::hypot(e.low.x, e.low.y));
  if (!(width > slack && height > slack)) fail_of_border(area, e);
  const double shorter = std::min(width, height), longer = std::max(width, height);
  En12464Grid grid;
  grid.largest_spacing = en12464_largest_spacing(longer >= 2 * shorter ? shorter : longer);
  double columns = count_for(width, grid.largest_spacing), rows = count_for(height, grid.largest_spacing);
  limit_aspect(width, height, columns, rows);
  if (columns * rows > most_points)
    fail_argument("the polygon of " + text(e.width()) + " x " + text(e.height()) + " m would have more than " +
                  std::to_string(most_points) + " points; a smaller one would be right");
  size_t corners = area.polygon.size();
  for (const PlanOutline& hole : area.holes) corners += hole.size();
  if (columns * rows * double(corners) > most_tests)
    fail_argument("the polygon and its holes have " + std::to_string(corners) + " corners and would have " +
                  text(columns * rows) + " points; corners times points may be 2^32 at most: fewer corners or a " +
                  "smaller polygon would be right");
  grid.columns = uint32_t(columns), grid.rows = uint32_t(rows);
  grid.origin = {e.low.x + area.border, e.low.y + area.border};
  grid.cell = {width / columns, height / rows};
  const double least = area.border - slack;
  const auto takes_part = [&](const PlanPoint& p) {
    if (!is_inside(p, area.polygon) || distance(p, area.polygon) < least) return false;
    return std::none_of(area.holes.begin(), area.holes.end(),
                        [&](const PlanOutline& h) { return is_inside(p, h) || distance(p, h) < least; });
  };
  for (uint32_t row = 0; row < grid.rows; ++row)
    for (uint32_t column = 0; column < grid.columns; ++column) {
      const PlanPoint p{grid.origin.x + (column + 0.5) * grid.cell.x, grid.origin.y + (row + 0.5) * grid.cell.y};
      if (takes_part(p)) grid.points.push_back({p, column, row});
    }
  if (grid.points.empty()) fail_of_border(area, e);
  return grid;
}

}  // namespace ups
