// The grid of EN 12464-1: against the standard's own table of lengths, in a room with a corner cut out and a column, and
// what is said of outlines that make no sense.
#include <cmath>

#include "fixture.h"

namespace ups_test {
namespace {

struct Grid {
  ups_en12464_info info{};
  std::vector<ups_en12464_point> points;
};

struct Outline {
  std::vector<double> corners;
  uint32_t count() const { return uint32_t(corners.size() / 2); }
};

ups_en12464_desc desc_of(const Outline& polygon, double border) {
  auto d = make(&ups_en12464_desc_init);
  d.corners_m = polygon.corners.data();
  d.corner_count = polygon.count();
  d.border_m = border;
  return d;
}

Grid grid_of(const ups_en12464_desc& d) {
  Grid g;
  g.info.struct_size = sizeof g.info;
  size_t count = 0;
  EXPECT_OK(ups_en12464_grid(&d, nullptr, nullptr, 0, &count));
  g.points.resize(count);
  EXPECT_OK(ups_en12464_grid(&d, &g.info, g.points.data(), count, nullptr));
  EXPECT_EQ(g.info.point_count, count);
  return g;
}

Outline rectangle(double x, double y, double width, double height) {
  return {{x, y, x + width, y, x + width, y + height, x, y + height}};
}

// EN 12464-1, table of the maximum spacing and the minimum number of points by the length of the area.
struct Row {
  double length, spacing;
  uint32_t points;
};
constexpr Row table[] = {{0.4, 0.15, 3}, {0.6, 0.2, 3}, {1, 0.2, 5},   {2, 0.3, 6},   {5, 0.6, 8},
                         {10, 1, 10},    {25, 2, 12},   {50, 3, 17},   {100, 5, 20}};

TEST(En12464, HoldsTheStandardsTable) {
  for (const Row& row : table) {
    const Grid g = grid_of(desc_of(rectangle(3, -2, row.length, row.length), 0));
    const double p = 0.2 * std::pow(5, std::log10(row.length));
    EXPECT_NEAR(g.info.largest_spacing_m, p, 1e-12) << row.length;
    EXPECT_EQ(g.info.columns, uint32_t(std::ceil(row.length / p - 1e-6))) << row.length;
    EXPECT_EQ(g.info.rows, g.info.columns) << row.length;
    EXPECT_GE(g.info.columns, row.points) << row.length;
    EXPECT_LE(g.info.cell_m[0], row.spacing + 1e-9) << row.length;
    EXPECT_EQ(g.points.size(), size_t(g.info.columns) * g.info.rows);
    EXPECT_NEAR(g.points[0].x_m, 3 + g.info.cell_m[0] / 2, 1e-12);
    EXPECT_NEAR(g.points.back().y_m, -2 + row.length - g.info.cell_m[1] / 2, 1e-12);
  }
  EXPECT_EQ(grid_of(desc_of(rectangle(0, 0, 100, 100), 0)).info.columns, 20u);
  EXPECT_EQ(grid_of(desc_of(rectangle(0, 0, 10, 10), 0)).info.columns, 10u);
  EXPECT_NEAR(grid_of(desc_of(rectangle(0, 0, 1000, 900), 0)).info.largest_spacing_m, 10, 1e-12);
}

// Where the area is at least twice as long as wide, its width decides.
TEST(En12464, TakesTheShorterSideOfALongArea) {
  const Grid g = grid_of(desc_of(rectangle(0, 0, 11, 3), 0.5));  // 10 m x 2 m less the border
  EXPECT_NEAR(g.info.largest_spacing_m, 0.2 * std::pow(5, std::log10(2.0)), 1e-12);
  EXPECT_EQ(g.info.columns, 31u);
  EXPECT_EQ(g.info.rows, 7u);
  const double almost = grid_of(desc_of(rectangle(0, 0, 10.99, 6), 0.5)).info.largest_spacing_m;
  EXPECT_NEAR(almost, 0.2 * std::pow(5, std::log10(9.99)), 1e-12);
  for (const double width : {0.001, 0.02, 0.3, 7.0})
    for (const double length : {0.0011, 0.4, 2.0, 13.7, 200.0}) {
      const Grid n = grid_of(desc_of(rectangle(0, 0, width, length), 0));
      EXPECT_LE(n.info.cell_m[0], n.info.largest_spacing_m * (1 + 1e-5));
      EXPECT_LE(n.info.cell_m[1], n.info.largest_spacing_m * (1 + 1e-5));
      const double aspect = n.info.cell_m[0] / n.info.cell_m[1];
      EXPECT_TRUE(aspect > 0.4999 && aspect < 2.0001) << width << " x " << length << ": " << aspect;
    }
}

// 8 m x 8 m without a quarter: 7 m less the border, p 0.78 m, 9 x 9 cells of 0.78 m; 36 points left of 3.5 m, 20 right of
// it below 3.5 m; the column and its border take four.
TEST(En12464, LeavesOutBordersHolesAndWhatIsOutside) {
  const Outline room{{0, 0, 8, 0, 8, 4, 4, 4, 4, 8, 0, 8}}, column = rectangle(1.8, 1.8, 0.4, 0.4);
  auto d = desc_of(room, 0.5);
  EXPECT_EQ(grid_of(d).points.size(), 56u);
  const uint32_t corners = column.count();
  d.hole_corners_m = column.corners.data();
  d.hole_corner_counts = &corners;
  d.hole_count = 1;
  const Grid g = grid_of(d);
  EXPECT_EQ(g.info.columns, 9u);
  EXPECT_EQ(g.info.rows, 9u);
  EXPECT_EQ(g.points.size(), 52u);
  for (const ups_en12464_point& p : g.points) {
    EXPECT_NEAR(p.x_m, 0.5 + (p.column + 0.5) * 7 / 9, 1e-12);
    EXPECT_NEAR(p.y_m, 0.5 + (p.row + 0.5) * 7 / 9, 1e-12);
    EXPECT_TRUE(p.x_m < 3.5 || p.y_m < 3.5);
    EXPECT_GE(std::hypot(std::max(std::abs(p.x_m - 2) - 0.2, 0.0), std::max(std::abs(p.y_m - 2) - 0.2, 0.0)), 0.5);
  }
  // The other way round it is the same room.
  const Outline back{{0, 8, 4, 8, 4, 4, 8, 4, 8, 0, 0, 0}};
  EXPECT_EQ(grid_of(desc_of(back, 0.5)).points.size(), 56u);
}

TEST(En12464, SaysWhatIsWrong) {
  const auto expect_fails = [](const Outline& polygon, double border, const std::vector<std::string>& words) {
    const auto d = desc_of(polygon, border);
    size_t count = 7;
    expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT, words);
    EXPECT_EQ(count, 7u);
  };
  expect_fails({{0, 0, 1, 0}}, 0, {"polygon has 2 corners", "at least 3"});
  expect_fails({{0, 0, 4, 4, 4, 0, 0, 4}}, 0, {"corner 0 (0, 0)", "corner 2 (4, 0)", "must not cross"});
  expect_fails({{0, 0, 4, 0, 4, 4, 0, 4, 0, 0}}, 0, {"corner 0 (0, 0) repeats"});
  expect_fails({{0, 0, 4, 0, NAN, 4}}, 0, {"polygon: corner 2", "finite"});
  expect_fails({{0, 0, 2, 0, 1, 0}}, 0, {"polygon", "must not"});
  expect_fails(rectangle(0, 0, 4, 3), -1, {"border is -1 m", "at least 0"});
  expect_fails(rectangle(0, 0, 4, 1), 0.5, {"border of 0.5 m", "4 x 1 m", "narrower"});
  expect_fails({{0, 0, 10, 10, 10, 10.2}}, 0.5, {"border of 0.5 m leaves no point"});
  expect_fails(rectangle(0, 0, 1e6, 1e6), 0, {"more than 16777216 points"});
  // What borders leave is but rounding, or so narrow that cells no longer than twice their width would be too many.
  expect_fails(rectangle(0, 5000000.3, 21.2, 1.2), 0.6, {"border of 0.6 m leaves no point"});
  expect_fails(rectangle(0, 0, 3, 1.0000000001), 0.5, {"border of 0.5 m leaves no point"});
  expect_fails(rectangle(0, 0, 3, 1.00000001), 0.5, {"more than 16777216 points"});

  const Outline room = rectangle(0, 0, 4, 3), holes{{1, 1, 2, 1, 2, 2, 3, 2, 5, 2, 3, 2.5}};
  auto d = desc_of(room, 0.2);
  const uint32_t counts[] = {3, 3}, two[] = {2, 4};
  d.hole_corners_m = holes.corners.data();
  d.hole_corner_counts = counts;
  d.hole_count = 2;
  size_t count = 0;
  expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT,
               {"hole 1: corner 1 (5, 2)", "outside"});
  d.hole_corner_counts = two;
  expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT, {"hole 0 has 2 corners"});
  d.hole_corner_counts = nullptr;
  expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT,
               {"hole_corner_counts is NULL"});
  d = desc_of(room, 0.2);
  ups_en12464_point one;
  expect_error(ups_en12464_grid(&d, nullptr, &one, 1, &count), UPS_ERROR_BUFFER_TOO_SMALL, {"capacity is 1", "points"});
  std::vector<ups_en12464_point> points(count, {-7, -7, 0, 0});
  ups_en12464_info info{};  // without its size
  size_t untouched = 7;
  expect_error(ups_en12464_grid(&d, &info, points.data(), points.size(), &untouched), UPS_ERROR_INVALID_ARGUMENT,
               {"info", "struct_size"});
  EXPECT_EQ(untouched, 7u);
  EXPECT_EQ(points[0].x_m, -7);
  expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"needed is NULL"});
  info.struct_size = sizeof info;
  EXPECT_EQ(ups_en12464_grid(&d, &info, nullptr, 0, nullptr), UPS_OK) << ups_last_error();
  EXPECT_EQ(info.point_count, count);
  expect_error(ups_en12464_grid(nullptr, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT, {"desc is NULL"});
  d.corners_m = nullptr;
  expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT, {"corners_m is NULL"});
  d.reserved = 1;
  d.corners_m = room.corners.data();
  expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT, {"reserved is 1"});
}

// Too many are refused before one is read.
TEST(En12464, CountsBeyondTheLimit) {
  const Outline four = rectangle(0, 0, 5, 4);
  size_t count = 0;
  auto d = desc_of(four, 0);
  d.corner_count = UINT32_MAX;
  expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT, {"corners", "4096"});
  d = desc_of(four, 0);
  const uint32_t of_hole = UINT32_MAX;
  d.hole_corners_m = four.corners.data(), d.hole_corner_counts = &of_hole, d.hole_count = 1;
  expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT, {"corners", "4096"});
}

// A polygon that would keep a thread for an hour.
TEST(En12464, CornersTimesPointsBeyondTheLimit) {
  Outline round;
  for (int i = 0; i < 4000; ++i) {
    const double angle = 2 * 3.14159265358979 * i / 4000;
    round.corners.insert(round.corners.end(), {20000 * std::cos(angle), 20000 * std::sin(angle)});
  }
  size_t count = 0;
  const auto d = desc_of(round, 0);
  expect_error(ups_en12464_grid(&d, nullptr, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT,
               {"4000 corners", "1.6e+07 points", "2^32"});
}

}  // namespace
}  // namespace ups_test
