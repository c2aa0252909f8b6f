// Texture lookups: where texels lie, how they repeat, what is between them.
#include "geometry/texture.h"

#include <gtest/gtest.h>

#include <limits>

#include "base/error.h"
#include "base/floating_point.h"

namespace ups {
namespace {

TEST(Texture, TexelCentresAndBilinearBetween) {
  const Texture t(2, 2, 1, {0, 1, 2, 3});
  EXPECT_FLOAT_EQ(t.first({0.25f, 0.25f}), 0);
  EXPECT_FLOAT_EQ(t.first({0.75f, 0.25f}), 1);
  EXPECT_FLOAT_EQ(t.first({0.25f, 0.75f}), 2);  // v = 0 is row 0
  EXPECT_FLOAT_EQ(t.first({0.5f, 0.5f}), 1.5f);
  EXPECT_FLOAT_EQ(t.first({0.375f, 0.25f}), 0.25f);
  EXPECT_FLOAT_EQ(t.first({0.0f, 0.25f}), 0.5f);  // half way to the last column, which comes before the first
}

// Those of few different values are stored as bytes.
TEST(Texture, AnyNumberOfDifferentValues) {
  for (const uint32_t values : {1u, 255u, 256u, 257u, 1024u}) {
    std::vector<float> texels;
    for (uint32_t i = 0; i < 1024; ++i) texels.push_back(float(i * 7 % values) / 3 - 1);
    const Texture t(32, 32, 1, texels);
    for (uint32_t i = 0; i < 1024; ++i)
      ASSERT_EQ(t.first({(float(i % 32) + 0.5f) / 32, (float(i / 32) + 0.5f) / 32}), texels[i]) << values;
  }
}

void check_colours(uint32_t colours, uint32_t channels, bool few_values) {
  std::vector<float> texels, of_channel[4];
  for (uint32_t i = 0; i < 1024; ++i)
    for (uint32_t k = 0; k < channels; ++k) {
      const uint32_t colour = i * 7 % colours, value = few_values ? colour >> 5 * (k % 2) & 31 : colour * (k + 1);
      texels.push_back(float(value) / 3 - 1);
      of_channel[k].push_back(texels.back());
    }
  const Texture whole(32, 32, channels, texels), red(32, 32, 1, of_channel[0]), green(32, 32, 1, of_channel[1]),
      blue(32, 32, 1, of_channel[2]), last(32, 32, 1, of_channel[channels - 1]);
  for (uint32_t i = 0; i < texels.size(); ++i) ASSERT_EQ(whole.texel(i), texels[i]) << colours;
  for (float u = -0.9f; u < 2; u += 0.173f)
    for (float v = -0.9f; v < 2; v += 0.137f) {
      const Rgb c = whole.rgb({u, v});
      ASSERT_EQ(c.r, red.first({u, v})) << colours;
      ASSERT_EQ(c.g, green.first({u, v})) << colours;
      ASSERT_EQ(c.b, blue.first({u, v})) << colours;
      ASSERT_EQ(whole.first({u, v}), red.first({u, v})) << colours;
      ASSERT_EQ(whole.last({u, v}), last.first({u, v})) << colours;
    }
}

// Of few different colours those are stored, of few values in many colours these, with the same bits.
TEST(Texture, ColoursAreThoseOfTheirChannels) {
  for (const uint32_t colours : {1u, 255u, 256u, 257u, 1024u})
    for (const uint32_t channels : {3u, 4u})
      for (const bool few_values : {false, true}) check_colours(colours, channels, few_values);
}

TEST(Texture, RepeatsInBothDirections) {
  const Texture t(3, 2, 1, {0, 1, 2, 3, 4, 5});
  for (float u : {0.1f, 0.4f, 0.99f})
    for (float v : {0.05f, 0.6f}) {
      EXPECT_NEAR(t.first({u + 4, v - 3}), t.first({u, v}), 1e-5f);
      EXPECT_NEAR(t.first({u - 1, v + 1}), t.first({u, v}), 1e-5f);
    }
}

TEST(Texture, Channels) {
  const Texture grey(1, 1, 1, {0.3f}), rgb(1, 1, 3, {0.1f, 0.2f, 0.3f}), rgba(1, 1, 4, {0.5f, 0.5f, 0.5f, 0.9f});
  EXPECT_FLOAT_EQ(grey.rgb({0, 0}).b, 0.3f);
  EXPECT_FLOAT_EQ(grey.last({0, 0}), 0.3f);
  EXPECT_FLOAT_EQ(rgb.rgb({0, 0}).g, 0.2f);
  EXPECT_FLOAT_EQ(rgba.last({0, 0}), 0.9f);
  EXPECT_FALSE(grey.coloured());
  EXPECT_TRUE(rgb.coloured());
  EXPECT_FALSE(rgba.coloured());
  EXPECT_FLOAT_EQ(Texture(2, 1, 4, {0.5f, 0, 0, 0, 0.2f, 0, 0, 0}).min_first(), 0.2f);
}

TEST(Texture, EveryCoordinateIsSafe) {
  const TrapsMasked masked;  // some are no numbers
  const Texture t(4, 4, 1, std::vector<float>(16, 0.5f));
  const float inf = std::numeric_limits<float>::infinity();
  for (float x : {-1e30f, 1e30f, -1e-30f, 16777217.0f, inf, -inf, std::numeric_limits<float>::quiet_NaN()})
    EXPECT_FLOAT_EQ(t.first({x, x}), 0.5f) << x;
}

TEST(Texture, RejectsWhatDoesNotFit) {
  EXPECT_THROW(Texture(2, 2, 3, std::vector<float>(11)), Error);
  EXPECT_THROW(Texture(1, 1, 2, std::vector<float>(2)), Error);
  EXPECT_THROW(Texture(0, 1, 1, {}), Error);
}

}  // namespace
}  // namespace ups
