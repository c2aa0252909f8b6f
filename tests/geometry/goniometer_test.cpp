// A goniometer's grid by itself: which nodes take flux of a direction, and over which solid angles it is divided.
#include <gtest/gtest.h>

#include <numeric>

#include "sensor/goniometer.h"

namespace ups {
namespace {

Vec3 towards(double c_deg, double gamma_deg) {
  const double c = c_deg / 180 * pi_d, g = gamma_deg / 180 * pi_d;
  return Vec3(Vec3d(std::sin(g) * std::cos(c), std::sin(g) * std::sin(c), -std::cos(g)));
}

double sum(const std::vector<double>& v) { return std::accumulate(v.begin(), v.end(), 0.0); }

const std::vector<double> uneven{0, 90, 200, 270}, rows{0, 30, 90, 180};
Goniometer grid() { return {Frame(), uneven, rows, photometry::Symmetry::none}; }

TEST(GoniometerGrid, ANodeTakesWhatGoesTowardsIt) {
  const Goniometer g = grid();
  for (size_t c = 0; c < uneven.size(); ++c)
    for (size_t r = 0; r < rows.size(); ++r) {
      GoniometerTally tally = g.empty_tally();
      g.add(towards(uneven[c], rows[r]), 3, tally);
      const uint32_t node = g.representative(c * rows.size() + r);
      EXPECT_NEAR(tally.wide[node], 3, 1e-4) << uneven[c] << ", " << rows[r];
      const bool pole = r == 0 || r + 1 == rows.size();  // where narrow hats leave out half of all azimuths
      EXPECT_NEAR(pole ? 3 : tally.narrow[node], 3, 1e-4) << uneven[c] << ", " << rows[r];
      EXPECT_NEAR(sum(tally.wide), 3, 1e-12);
      EXPECT_EQ(tally.outside, 0);
    }
}

// Equal steps whose floats are no decimals: each plane finds the one that mirrors it.
TEST(GoniometerGrid, PlanesMayBeFloats) {
  for (const int planes : {7, 50, 100, 300, 3600}) {
    std::vector<double> c_deg;
    for (int i = 0; i < planes; ++i) c_deg.push_back(double(float(i) * (360.0f / float(planes))));
    const Goniometer g(Frame(), c_deg, rows, photometry::Symmetry::c0_c180);
    const auto size = rows.size();
    for (size_t i = 1; i < c_deg.size(); ++i)
      EXPECT_EQ(g.representative(uint32_t(i * size + 1)), g.representative(uint32_t((c_deg.size() - i) * size + 1))) << i;
  }
}

TEST(GoniometerGrid, FluxBetweenPlanesIsDividedByTheirDistance) {
  const Goniometer g = grid();
  struct Case {
    double c_deg;
    size_t before, after;
    double share;  // of the plane after
  };
  for (const Case& k : {Case{22.5, 0, 1, 0.25}, {145, 1, 2, 0.5}, {177.5, 1, 2, 87.5 / 110}, {300, 3, 0, 1.0 / 3}}) {
    GoniometerTally tally = g.empty_tally();
    g.add(towards(k.c_deg, 90), 1, tally);
    EXPECT_NEAR(tally.wide[k.before * rows.size() + 2], 1 - k.share, 1e-6) << k.c_deg;
    EXPECT_NEAR(tally.wide[k.after * rows.size() + 2], k.share, 1e-6) << k.c_deg;
    EXPECT_NEAR(tally.narrow[k.before * rows.size() + 2], std::max(0.0, 1 - 2 * k.share), 2e-6) << k.c_deg;
    EXPECT_NEAR(tally.narrow[k.after * rows.size() + 2], std::max(0.0, 2 * k.share - 1), 2e-6) << k.c_deg;
  }
}

TEST(GoniometerGrid, AllPlanesMeetAtBothPoles) {
  const Goniometer g = grid();
  for (size_t c = 0; c < uneven.size(); ++c)
    for (const size_t row : {size_t(0), rows.size() - 1}) EXPECT_EQ(g.representative(c * rows.size() + row), row);
}

// The hats of one candela towards everywhere, summed over a fine lattice of directions.
TEST(GoniometerGrid, SolidAnglesAreThoseOfTheHats) {
  for (const bool planes : {true, false}) {
    const Goniometer g = planes ? grid() : Goniometer(Frame(), {0}, rows, photometry::Symmetry::axial);
    GoniometerTally tally = g.empty_tally();
    constexpr int n = 720;  // half a degree
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n / 2; ++j) {
        const double step = 360.0 / n, low = j * step / 180 * pi_d, high = (j + 1) * step / 180 * pi_d;
        g.add(towards((i + 0.5) * step, (j + 0.5) * step), 2 * pi_d / n * (std::cos(low) - std::cos(high)), tally);
      }
    double wide = 0;
    for (uint32_t node = 0; node < g.node_count(); ++node) {
      EXPECT_NEAR(tally.wide[node], g.wide_solid_angle(node), 2e-4);
      EXPECT_NEAR(tally.narrow[node], g.narrow_solid_angle(node), 2e-4);
      wide += g.wide_solid_angle(node);
    }
    EXPECT_NEAR(wide, 4 * pi_d, 1e-9);
  }
}

TEST(GoniometerGrid, MirrorPlanesShareTheirNodes) {
  using photometry::Symmetry;
  const std::vector<double> sixths{0, 60, 120, 180, 240, 300};
  const auto stands_for = [&](Symmetry s, size_t plane) {
    return Goniometer(Frame(), sixths, {0, 90, 180}, s).representative(plane * 3 + 1) / 3;
  };
  const uint32_t about_0[] = {0, 1, 2, 3, 2, 1}, about_90[] = {0, 1, 1, 0, 4, 4}, quadrants[] = {0, 1, 1, 0, 1, 1};
  for (size_t c = 0; c < sixths.size(); ++c) {
    EXPECT_EQ(stands_for(Symmetry::c0_c180, c), about_0[c]);
    EXPECT_EQ(stands_for(Symmetry::c90_c270, c), about_90[c]);
    EXPECT_EQ(stands_for(Symmetry::quadrants, c), quadrants[c]);
  }
}

TEST(GoniometerGrid, KeepsWhatLiesOutsideApart) {
  const Goniometer g(Frame(), {0}, {20, 60, 90}, photometry::Symmetry::axial);
  GoniometerTally tally = g.empty_tally();
  g.add(towards(10, 10), 1, tally);
  g.add(towards(10, 91), 2, tally);
  EXPECT_EQ(tally.outside, 3);
  EXPECT_EQ(sum(tally.wide), 0);
  g.add(towards(10, 40), 4, tally);
  EXPECT_EQ(tally.outside, 3);
  EXPECT_NEAR(sum(tally.wide), 4, 1e-12);
  EXPECT_EQ(tally.flux, 7);
}

}  // namespace
}  // namespace ups
