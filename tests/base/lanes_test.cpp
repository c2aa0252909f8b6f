// Has each of several floats at once the bits that it has by itself?
#include <gtest/gtest.h>

#include <bit>

#include "base/floating_point.h"
#include "base/lanes.h"
#include "base/rng.h"

namespace ups::test {
namespace {

TEST(Lanes, HaveTheBitsOfFloats) {
  const TrapsMasked masked;  // odd numbers are what it is about
  constexpr float odd[] = {0.0f, -0.0f, 1.0f, -1.0f, 1e-40f, -3e38f, 0x1.fffffep30f, 0.1f};
  for (uint32_t k = 0; k < 4096; ++k) {
    Float4 a, b;
    for (uint32_t i = 0; i < lane_count; ++i) {
      a[i] = k % 16 == 0 ? odd[(k / 16 + i) % 8] : to_unit_float(uint32_t(mix64(8 * k + i))) * 200 - 100;
      b[i] = k % 16 == 1 ? odd[(k / 16 + i) % 8] : to_unit_float(uint32_t(mix64(8 * k + 4 + i))) * 200 - 100;
    }
    const Float4 size = abs(a), copied = copysign(a, b), root = sqrt(size);
    const Float4 most = larger(a, b), least = smaller(a, b), none_last = larger(Float4{} / Float4{}, b);
    const Int4 whole = truncated(b);
    uint32_t below = 0;
    const auto bits = [](float x) { return std::bit_cast<uint32_t>(x); };
    for (int i = 0; i < lane_count; ++i) {
      EXPECT_EQ(bits(size[i]), bits(std::abs(a[i])));
      EXPECT_EQ(bits(copied[i]), bits(std::copysign(a[i], b[i])));
      EXPECT_EQ(bits(root[i]), bits(std::sqrt(size[i])));
      EXPECT_EQ(bits(most[i]), bits(larger(a[i], b[i])));
      EXPECT_EQ(bits(least[i]), bits(smaller(a[i], b[i])));
      EXPECT_EQ(bits(none_last[i]), bits(b[i]));
      below |= bits_of(a[i] < b[i]) << i;
      if (std::abs(b[i]) < 0x1p31f) {
        EXPECT_EQ(whole[i], truncated(b[i]));
      }
    }
    EXPECT_EQ(bits_of(a < b), below);
  }
}

}  // namespace
}  // namespace ups::test
