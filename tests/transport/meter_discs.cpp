// Rings, sectors and octants of a point meter's disc, from formulas.
#include <gtest/gtest.h>

#include "transport/meter_discs.h"

namespace ups {
namespace {

TEST(MeterDiscs, OctantsAreTheSignsAndTheLargerCoordinate) {
  for (int i = 0; i < 8; ++i) {
    const double phi = (i + 0.5) / 4 * 3.14159265358979323846;
    const float x = float(std::cos(phi)), y = float(std::sin(phi));
    const uint8_t octant = MeterDiscs::octant_of(x, y);
    EXPECT_EQ(octant & 1, std::abs(y) > std::abs(x)) << i;
    EXPECT_EQ((octant & 2) != 0, x < 0) << i;
    EXPECT_EQ((octant & 4) != 0, y < 0) << i;
  }
}

// A ring's flux under light that falls off as r^2 is its area times its mean squared radius.
TEST(MeterDiscs, RingsHaveTheirAreasAndMeanSquaredRadii) {
  const MeterDiscs discs(1, 8, 0.5f);
  const Rings rings = discs.rings(0, 0);
  ASSERT_EQ(rings.count, 8u);
  std::vector<double> area(8), moment(8);
  constexpr int n = 4000;
  for (int i = 0; i < n; ++i) {
    const double r = 0.5 * (i + 0.5) / n, share = 2 * 3.14159265358979323846 * r * 0.5 / n;
    const uint32_t ring = discs.ring_at(0, float(r), 0);
    ASSERT_LT(ring, 8u);
    area[ring] += share, moment[ring] += share * r * r;
  }
  for (uint32_t k = 0; k < 8; ++k) {
    EXPECT_NEAR(rings.area[k] / area[k], 1, 0.01) << k;
    EXPECT_NEAR(rings.radius2[k] / (moment[k] / area[k]), 1, 0.01) << k;
  }
}

}  // namespace
}  // namespace ups
