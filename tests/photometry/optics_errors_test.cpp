// Are optics that cannot be refused with the field, its value and its range?
#include <limits>
#include <stdexcept>

#include "optics_truth.h"

namespace {

using namespace optics_test;

template <class Make>
void expect_refused(const Make& make, std::initializer_list<const char*> words) {
  try {
    make();
    ADD_FAILURE() << "accepted";
  } catch (const std::invalid_argument& e) {
    for (const char* word : words) EXPECT_NE(std::string(e.what()).find(word), std::string::npos) << e.what();
  }
}

TEST(OpticsErrors, NameFieldValueAndRange) {
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {0.0, -1.0, nan, inf}) {
    expect_refused([&] { paraboloid(bad, 0, 1); }, {"focal_length_m", "above 0"});
    expect_refused([&] { paraboloid(1, 0, bad); }, {"aperture_radius_m", "above 0"});
    expect_refused([&] { cone(0, 1, bad); }, {"depth_m"});
    expect_refused([&] { disc(bad); }, {"radius_m"});
    expect_refused([&] { rectangle(1, bad); }, {"length_m"});
    expect_refused([&] { lens({}, {}, 0.1, bad); }, {"thickness_m"});
    expect_refused([&] { tessellate(disc(1), {bad, 0.1}); }, {"chord_tolerance_m"});
    expect_refused([&] { tessellate(disc(1), {0.1, bad}); }, {"normal_tolerance_rad"});
  }
  expect_refused([] { paraboloid(1, 0.5, 0.5); }, {"inner_radius_m is 0.5", "less than aperture_radius_m"});
  expect_refused([] { ellipsoid(0.1, 0.1, 0, 0.05, 0); }, {"half_distance_m", "less than semi_axis_m"});
  expect_refused([] { ellipsoid(0.1, 0.05, 0, 0.09, 0); }, {"aperture_radius_m", "semi-minor"});
  expect_refused([] { ellipsoid(0.1, 0.05, 0, 0, 0.2); }, {"depth_m is 0.2"});
  expect_refused([] { ellipsoid(0.1, 0.05, 0, 0.05, 0.1); }, {"aperture_radius_m", "0 where depth_m is given"});
  expect_refused([] { lens({}, {0.05}, 0.04, 0.01); }, {"thickness_m is 0.01", "cross", "from the axis"});
  expect_refused([] { lens({0.01}, {}, 0.02, 0.1); }, {"entry_radius_m is 0.01", "ends 0.01 m"});
  expect_refused([&] { lens({}, {0.1, nan}, 0.02, 0.1); }, {"exit_conic"});
  expect_refused([&] { lens({}, {0.1, 0, {0, nan}}, 0.02, 0.1); }, {"exit_coefficients[1]"});
  expect_refused([] { polyline({{0.1, 0}}, true); }, {"number of points of profile_rz_m is 1"});
  expect_refused([] { polyline({{0.1, 0}, {-0.1, 1}}, true); }, {"point 1's r"});
  expect_refused([] { polyline({{0.1, 0}, {0.1, 0}}, true); }, {"point 1", "length"});
  expect_refused([] { polyline({{0.1, 0}, {0, 1}, {0.1, 2}}, true); }, {"point 1's r", "axis"});
}

TEST(OpticsErrors, CollimatorsThatCannotBe) {
  Collimator base;
  base.cavity_radius_m = 0.004, base.cavity_depth_m = 0.005, base.wall_thickness_m = 0.001;
  const auto refused = [&](const auto& change, std::initializer_list<const char*> words) {
    Collimator d = base;
    change(d);
    expect_refused([&] { collimator(d); }, words);
  };
  refused([](auto& d) { d.cavity_radius_m = 0; }, {"cavity_radius_m"});
  refused([](auto& d) { d.wall_thickness_m = 0; }, {"wall_thickness_m"});
  refused([](auto& d) { d.ior = 1; }, {"ior"});
  refused([](auto& d) { d.height_m = 0.001; }, {"height_m", "height of the wall"});
  refused([](auto& d) { d.exit = {-0.0145}; }, {"height_m", "meets the lens"});
  refused(
      [](auto& d) {
        d.wall = Collimator::Wall::paraboloid, d.focal_length_m = 0.003, d.height_m = 0.02, d.wall_thickness_m = 0;
        d.cavity_depth_m = 0.002, d.lens = {std::numeric_limits<double>::infinity()}, d.exit = {-0.017};
      },
      {"exit_radius_m is -0.017", "leaves the outer wall"});
  refused([](auto& d) { d.wall = Collimator::Wall::paraboloid, d.focal_length_m = 0.001, d.height_m = 0.02; },
          {"cavity_radius_m", "outer wall"});
  refused(
      [](auto& d) {
        d.wall = Collimator::Wall::polyline, d.wall_points = {{0.01, -1}, {0.02, -2}};
      },
      {"point 0's z"});
  refused(
      [](auto& d) {
        d.wall = Collimator::Wall::polyline, d.wall_points = {{0.01, 0}, {0.02, 1}};
      },
      {"point 1's z"});
}

TEST(OpticsErrors, TooManyTrianglesNameTheTolerance) {
  expect_refused([] { tessellate(sphere(1), {1e-15, 1}); }, {"chord_tolerance_m", "4000000"});
  expect_refused([] { tessellate(paraboloid(0.02, 0, 0.06), {1e-3, 1e-7}); }, {"normal_tolerance_rad", "4000000"});
  EXPECT_LT(tessellate(paraboloid(0.02, 0, 0.06), {6e-5, 0.1 * deg}).triangle_count(), 20000u);
}

}  // namespace
