// Directions that a meter draws have the density that it states, in proportion to its response: counted over a grid of
// directions, from a fine grid of the square, so without chance.
#include "sensor/response.h"

#include <gtest/gtest.h>

#include <vector>

namespace ups {
namespace {

constexpr ups_meter_kind kinds[] = {UPS_METER_PLANAR,        UPS_METER_CYLINDRICAL, UPS_METER_SEMICYLINDRICAL,
                                    UPS_METER_HEMISPHERICAL, UPS_METER_SPHERICAL,   UPS_METER_VECTOR};
constexpr int heights = 16, turns = 24;

int bin_of(const Vec3& w) {
  const int z = std::min(int((w.z + 1) * 0.5f * heights), heights - 1),
            turn = std::min(int((std::atan2(w.y, w.x) + pi) / (2 * pi) * turns), turns - 1);
  return z * turns + turn;
}

TEST(MeterResponse, DrawsDirectionsInProportionToIt) {
  for (const ups_meter_kind kind : kinds) {
    const MeterResponse response{kind};
    constexpr int n = 1536;  // whole multiples of the bins
    std::vector<double> drawn(heights * turns), stated(heights * turns);
    for (int i = 0; i < n; ++i)
      for (int j = 0; j < n; ++j) {
        const Vec3 w = response.sample({(float(i) + 0.5f) / n, (float(j) + 0.5f) / n});
        ASSERT_NEAR(length(w), 1, 1e-5);
        ASSERT_GE(response.value(w), -1e-6f);
        ASSERT_NEAR(response.pdf(w) * response.total(), response.value(w), 1e-5);
        drawn[size_t(bin_of(w))] += 1.0 / (n * n);
        const float z = -1 + 2 * (float(i) + 0.5f) / n, r = std::sqrt(1 - z * z), turn = 2 * pi * (float(j) + 0.5f) / n;
        const Vec3 v{r * std::cos(turn), r * std::sin(turn), z};
        stated[size_t(bin_of(v))] += std::max(0.0f, response.pdf(v)) * 4 * double(pi) / (n * n);
      }
    double sum = 0;
    for (size_t b = 0; b < stated.size(); ++b) {
      sum += stated[b];
      EXPECT_NEAR(drawn[b], stated[b], 2e-4) << "kind " << kind << ", bin " << b;
    }
    EXPECT_NEAR(sum, 1, 1e-4) << "kind " << kind;
  }
}

TEST(MeterResponse, AVectorsSidesAreTheAxes) {
  Vec3 sum;
  for (uint32_t side = 0; side < vector_sides; ++side) {
    const MeterResponse response{UPS_METER_VECTOR, true, uint8_t(side)};
    const Frame frame = response.frame(Frame(Vec3(0, 0, 1)));
    EXPECT_EQ(frame.n.x, axis_of_side(side).x);
    EXPECT_EQ(frame.n.y, axis_of_side(side).y);
    EXPECT_EQ(frame.n.z, axis_of_side(side).z);
    EXPECT_NEAR(response.value(frame.to_local(axis_of_side(side))), 1, 1e-6);
    sum += axis_of_side(side);
  }
  EXPECT_EQ(length(sum), 0);
}

}  // namespace
}  // namespace ups
