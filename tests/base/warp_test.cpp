// Does the map onto the disc, by polynomials of its own, follow the formula by the mathematical library?
#include <gtest/gtest.h>

#include <vector>

#include "base/rng.h"
#include "base/warp.h"

namespace ups::test {
namespace {

TEST(Warp, CosineAndSineAreRightToTheLastBits) {
  for (int i = -100000; i <= 100000; ++i) {
    const float angle = pi / 4 * (float(i) / 100000);
    const Vec2 q = cosine_and_sine(angle);
    ASSERT_NEAR(q.x, std::cos(double(angle)), 1e-7) << angle;
    ASSERT_NEAR(q.y, std::sin(double(angle)), 1e-7 * std::abs(double(angle))) << angle;
  }
}

// Shirley and Chiu's, in double.
Vec2T<double> concentric(const Vec2& u) {
  const double a = 2 * double(u.x) - 1, b = 2 * double(u.y) - 1;
  if (a == 0 && b == 0) return {0, 0};
  const bool first = std::abs(a) > std::abs(b);
  const double r = first ? a : b, phi = first ? pi_d / 4 * (b / a) : pi_d / 2 - pi_d / 4 * (a / b);
  return {r * std::cos(phi), r * std::sin(phi)};
}

TEST(Warp, DiscIsConcentric) {
  std::vector<Vec2> all;
  for (uint32_t i = 0; i < 100000; ++i)
    all.push_back({to_unit_float(uint32_t(mix64(2 * i))), to_unit_float(uint32_t(mix64(2 * i + 1)))});
  for (const float x : {0.0f, 0x1p-24f, 0.25f, 0.5f - 0x1p-24f, 0.5f, 0.5f + 0x1p-24f, 0.75f, 0x1.fffffep-1f})
    for (const float y : {0.0f, 0x1p-24f, 0.25f, 0.5f - 0x1p-24f, 0.5f, 0.5f + 0x1p-24f, 0.75f, 0x1.fffffep-1f})
      all.push_back({x, y});
  for (const Vec2& u : all) {
    const Vec2 p = square_to_disc(u), back = disc_to_square(p);
    const Vec2T<double> exact = concentric(u);
    const double allowed = 2e-7 * std::hypot(exact.x, exact.y);
    ASSERT_NEAR(p.x, exact.x, allowed) << u.x << " " << u.y;
    ASSERT_NEAR(p.y, exact.y, allowed) << u.x << " " << u.y;
    ASSERT_NEAR(back.x, u.x, 3e-7) << u.x << " " << u.y;
    ASSERT_NEAR(back.y, u.y, 3e-7) << u.x << " " << u.y;
  }
}

}  // namespace
}  // namespace ups::test
