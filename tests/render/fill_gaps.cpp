// What an image shows where no eye path was yet: sensible means of what is around.
#include "render/fill_gaps.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "transport/plan.h"

namespace {

using namespace ups;

struct Picture {
  uint32_t width, height;
  std::vector<uint8_t> known;
  std::vector<float> values;
  // Known where the first `iterations` of `subsets` went.
  Picture(uint32_t w, uint32_t h, uint32_t subsets, uint32_t iterations)
      : width(w), height(h), known(w * h), values(w * h) {
    Plan plan;
    plan.camera_subsets = subsets;
    for (uint32_t i = 0; i < iterations; ++i)
      plan.for_visited_pixels(i, w, h, [&](uint32_t, uint32_t p) { known[p] = 1; });
  }
  template <class Value>
  void fill(const Value& value) {
    for (uint32_t p = 0; p < width * height; ++p)
      if (known[p]) values[p] = float(value(p % width, p / width));
    fill_gaps(width, height, 1, known, values);
  }
  float at(uint32_t x, uint32_t y) const { return values[y * width + x]; }
};

TEST(FillGaps, KeepsAConstant) {
  for (const uint32_t subsets : {2u, 7u, 64u})
    for (const uint32_t iterations : {1u, subsets / 2, subsets - 1}) {
      Picture picture(61, 37, subsets, iterations);
      picture.fill([](uint32_t, uint32_t) { return 3.0; });
      for (const float v : picture.values) ASSERT_FLOAT_EQ(v, 3.0f) << subsets << ", " << iterations;
    }
}

TEST(FillGaps, KeepsWhatIsKnown) {
  Picture picture(40, 30, 9, 3);
  picture.fill([](uint32_t x, uint32_t y) { return x * 100.0 + y; });
  for (uint32_t p = 0; p < 1200; ++p)
    if (picture.known[p]) {
      ASSERT_EQ(picture.values[p], float((p % 40) * 100.0 + p / 40));
    }
}

// A ramp from 0 to 1: within, what is filled in may be off by the ramp's change over the distance to what is known, in
// all but 1 % of the pixels; and no line stands out from its neighbours by more than that.
TEST(FillGaps, FollowsARampWithoutLines) {
  constexpr uint32_t size = 256, subsets = 32;
  Picture picture(size, size, subsets, 1);
  picture.fill([](uint32_t x, uint32_t) { return double(x) / size; });
  const float allowed = float(subsets) / size;
  double sum = 0;
  for (uint32_t y = 0; y < size; ++y)
    for (uint32_t x = 0; x < size; ++x) {
      sum += picture.at(x, y) - double(x) / size;
      ASSERT_NEAR(picture.at(x, y), float(x) / size, allowed) << x << ", " << y;
      ASSERT_LT(std::abs(picture.at(std::min(x + 1, size - 1), y) - picture.at(x, y)), 0.5f * allowed);
      ASSERT_LT(std::abs(picture.at(x, std::min(y + 1, size - 1)) - picture.at(x, y)), 0.5f * allowed);
    }
  EXPECT_NEAR(sum / (size * size), 0, 0.01);
}

// Noise of standard deviation 1 about 10, known at a 16th of 65536 pixels: the image's mean is that of what is known,
// with a standard error of 1/64; squares of pixels at the same distance weigh a little unlike, so 5 of these. Chance of
// a false alarm: 10^-6 with the seed fixed at its worst; 7 of them, 1.1 % of the mean, are found in 97.7 of 100 cases.
TEST(FillGaps, IsUnbiased) {
  Picture picture(256, 256, 16, 1);
  std::mt19937 random(5);
  std::normal_distribution<double> normal(10, 1);
  picture.fill([&](uint32_t, uint32_t) { return normal(random); });
  double sum = 0;
  for (const float v : picture.values) sum += v;
  EXPECT_NEAR(sum / 65536, 10, 5.0 / 64);
}

TEST(FillGaps, NothingKnownStaysAsItIs) {
  std::vector<float> values(35 * 2, 0.0f);
  fill_gaps(7, 5, 2, std::vector<uint8_t>(35), values);
  for (const float v : values) EXPECT_EQ(v, 0.0f);
}

}  // namespace
