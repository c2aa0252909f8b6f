// The display filter: noise falls, what is no noise stays (texture by albedo, edges by normal and depth, shadows by the
// pixels' own errors), and wrong input is refused.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "../support/mean.h"
#include "ups/ups_ocio.h"

namespace {

constexpr uint32_t width = 64, height = 48;
constexpr size_t pixels = width * height;

struct Picture {
  std::vector<float> rgb = std::vector<float>(3 * pixels, 100.f), error = std::vector<float>(3 * pixels),
                     albedo = std::vector<float>(3 * pixels, 0.5f), normal = std::vector<float>(3 * pixels),
                     depth = std::vector<float>(pixels, 2.f);
  ups_ocio_smooth_desc desc;

  Picture() {
    for (size_t p = 0; p < pixels; ++p) normal[3 * p + 2] = 1;
    ups_ocio_smooth_desc_init(&desc, sizeof desc);
    desc.width = width, desc.height = height;
  }
  // Independent in each channel, and the errors say so.
  void add_noise(float relative, uint32_t seed = 1) {
    std::mt19937 rng(seed);
    std::normal_distribution<float> normal_number;
    for (size_t i = 0; i < rgb.size(); ++i) {
      error[i] = relative * rgb[i];
      rgb[i] += error[i] * normal_number(rng);
    }
  }
  std::vector<float> smooth() {
    desc.luminance_rgb = rgb.data(), desc.standard_error_rgb = error.data();
    desc.albedo_rgb = albedo.data(), desc.normal = normal.data(), desc.depth = depth.data();
    std::vector<float> out(rgb.size());
    EXPECT_EQ(ups_ocio_smooth(&desc, out.data()), UPS_OK) << ups_ocio_last_error();
    return out;
  }
  template <class F>
  void each(const F& f) {
    for (uint32_t y = 0; y < height; ++y)
      for (uint32_t x = 0; x < width; ++x) f(x, y, size_t(y) * width + x);
  }
  void set(size_t pixel, float value) {
    for (size_t k = 0; k < 3; ++k) rgb[3 * pixel + k] = value;
  }
};

double rms(const std::vector<float>& a, const std::vector<float>& b) {
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += (a[i] - b[i]) * (a[i] - b[i]);
  return std::sqrt(sum / double(a.size()));
}

// A lamp in view of a dark scene, whose errors are 10^8 times the others': what is beside it is smoothed as ever.
TEST(Smooth, OneLargeErrorLeavesTheOthers) {
  Picture p, without;
  for (Picture* each : {&p, &without}) {
    for (float& v : each->rgb) v = 0.03f;
    each->add_noise(0.1f);
  }
  const size_t lamp = size_t(24) * width + 20;
  for (size_t i = 3 * lamp; i < 3 * lamp + 6; ++i) p.rgb[i] = 2e6f, p.error[i] = 2e5f;
  const std::vector<float> a = p.smooth(), b = without.smooth();
  double most = 0;
  for (uint32_t x = 40; x < width; ++x)  // right of it, beyond the filter's reach
    for (size_t k = 0; k < 3; ++k)
      most = std::max(most, double(std::abs(a[3 * (24 * width + x) + k] - b[3 * (24 * width + x) + k])));
  EXPECT_LE(most, 1e-6);
}

// Whose squares are beyond a float: it stays where it is.
TEST(Smooth, WhatIsBrighterThanAnythingIsNotSpread) {
  Picture picture;
  const size_t sun = size_t(24) * width + 20;
  picture.set(sun, 1e25f);
  const std::vector<float> out = picture.smooth();
  for (size_t i = 0; i < out.size(); ++i) {
    if (i / 3 == sun) ASSERT_NEAR(out[i], 1e25f, 1e19);
    else ASSERT_NEAR(out[i], 100, 1e-3) << i;
  }
}

TEST(Smooth, NoiseOfAFlatSurfaceFalls) {
  Picture picture;
  const std::vector<float> truth = picture.rgb;
  picture.add_noise(0.2f);
  const std::vector<float> out = picture.smooth();
  EXPECT_LT(rms(out, truth), 0.2 * rms(picture.rgb, truth));
  // Both means have most of the noise; their difference, as pixels near the border count for more, 0.03 %: 6 of that.
  double off = 0;
  for (size_t i = 0; i < out.size(); ++i) off += (out[i] - picture.rgb[i]) / double(out.size());
  EXPECT_NEAR(off, 0, 0.2);
}

TEST(Smooth, AnImageWithoutNoiseStays) {
  Picture picture;
  std::mt19937 rng(2);
  std::uniform_real_distribution<float> uniform(10, 200);
  for (float& v : picture.rgb) v = uniform(rng);
  const std::vector<float> out = picture.smooth();
  for (size_t i = 0; i < out.size(); ++i) EXPECT_NEAR(out[i], picture.rgb[i], 1e-3f * picture.rgb[i]);
}

// A fine pattern of albedo under even light, with as much noise as contrast: the noise falls, the pattern stays.
TEST(Smooth, TextureStays) {
  Picture picture;
  picture.each([&](uint32_t x, uint32_t y, size_t p) {
    const float albedo = (x / 2 + y / 2) % 2 ? 0.6f : 0.4f;
    picture.set(p, 200 * albedo);
    for (size_t k = 0; k < 3; ++k) picture.albedo[3 * p + k] = albedo;
  });
  const std::vector<float> truth = picture.rgb;
  picture.add_noise(0.2f);
  EXPECT_LT(rms(picture.smooth(), truth), 0.3 * rms(picture.rgb, truth));
}

// Mean of the columns from x to end, all rows and channels.
double mean_of_columns(const std::vector<float>& rgb, uint32_t x, uint32_t end) {
  double sum = 0;
  for (uint32_t y = 0; y < height; ++y)
    for (size_t i = 3 * (size_t(y) * width + x); i < 3 * (size_t(y) * width + end); ++i) sum += rgb[i];
  return sum / (3.0 * height * (end - x));
}

// Where two surfaces meet, each keeps its own luminance, though noise hides the step between them: the columns beside
// the edge become the mean of what the filter reaches on their own side, nine columns, noise and all. What is left has
// a standard error of 0.1 % at most, of 8 seeds: half a percent is 5 of that (0.2 % of seeds fail, t of 7 degrees of
// freedom), and an error of 1 % is found in more than 99 cases of 100.
TEST(Smooth, EdgesStayByNormalAndDepth) {
  constexpr uint32_t edge = width / 2, reach = 9;
  for (const bool by_depth : {false, true}) {
    std::vector<double> left, right;
    for (uint32_t seed = 1; seed <= 8; ++seed) {
      Picture picture;
      picture.each([&](uint32_t x, uint32_t, size_t p) {
        picture.set(p, x < edge ? 100.f : 110.f);
        if (x < edge) return;
        if (by_depth)
          picture.depth[p] = 3;
        else
          picture.normal[3 * p] = 1, picture.normal[3 * p + 2] = 0;
      });
      const std::vector<float> truth = picture.rgb;
      picture.add_noise(0.15f, seed);
      const std::vector<float> out = picture.smooth();
      const std::vector<float>& in = picture.rgb;
      left.push_back(mean_of_columns(out, edge - 1, edge) / mean_of_columns(in, edge - reach, edge));
      right.push_back(mean_of_columns(out, edge, edge + 1) / mean_of_columns(in, edge, edge + reach));
      EXPECT_LT(rms(out, truth), 0.35 * rms(in, truth));
    }
    for (const auto& side : {left, right}) {
      const ups::test::Mean mean = ups::test::mean_of(side);
      EXPECT_LE(mean.standard_error, 0.001);
      EXPECT_NEAR(mean.value, 1, 0.005);
    }
  }
}

// The edge of a shadow on one surface: nothing but the errors tell that it is none of the noise. No test of accuracy:
// such an edge may blur.
TEST(Smooth, ShadowsStayByTheErrors) {
  Picture picture;
  picture.each([&](uint32_t x, uint32_t, size_t p) { picture.set(p, x < width / 2 ? 100.f : 40.f); });
  const std::vector<float> truth = picture.rgb;
  picture.add_noise(0.1f);
  const std::vector<float> out = picture.smooth();
  for (uint32_t y = 4; y < height - 4; ++y) {
    EXPECT_GT(out[3 * (size_t(y) * width + width / 2 - 1)], 80) << y;
    EXPECT_LT(out[3 * (size_t(y) * width + width / 2)], 55) << y;
  }
  EXPECT_LT(rms(out, truth), 0.5 * rms(picture.rgb, truth));
}

TEST(Smooth, UnknownErrorsBlackAndBackgroundAreNoTrouble) {
  Picture picture;
  picture.each([&](uint32_t x, uint32_t y, size_t p) {
    if (y < 10) {  // nothing is met, nothing is seen
      picture.set(p, 0);
      picture.depth[p] = -1;
      for (size_t k = 0; k < 3; ++k) picture.albedo[3 * p + k] = picture.normal[3 * p + k] = 0;
    } else if (x % 5 == 0) {  // not found yet
      picture.set(p, 0);
      for (size_t k = 0; k < 3; ++k) picture.error[3 * p + k] = -1;
    }
  });
  const std::vector<float> out = picture.smooth();
  for (float v : out) EXPECT_TRUE(std::isfinite(v) && v >= 0);
  EXPECT_EQ(out[3 * 5 * width], 0);
  EXPECT_GT(out[3 * (30 * width + 30)], 60);  // a pixel that is not found takes what is around it
  picture.rgb.assign(3 * pixels, 0.f), picture.error = picture.rgb;
  for (float v : picture.smooth()) EXPECT_EQ(v, 0);
}

TEST(Smooth, LayersMayBeMissingAndTheOutputMayBeTheInput) {
  Picture picture;
  const std::vector<float> truth = picture.rgb;
  picture.add_noise(0.2f);
  const double before = rms(picture.rgb, truth);
  picture.desc.luminance_rgb = picture.rgb.data(), picture.desc.standard_error_rgb = picture.error.data();
  ASSERT_EQ(ups_ocio_smooth(&picture.desc, picture.rgb.data()), UPS_OK) << ups_ocio_last_error();
  EXPECT_LT(rms(picture.rgb, truth), 0.2 * before);
}

TEST(Smooth, WrongInputIsRefused) {
  Picture picture;
  picture.desc.luminance_rgb = picture.rgb.data(), picture.desc.standard_error_rgb = picture.error.data();
  const auto refused = [&](const std::string& words) {
    float out = 7;
    EXPECT_EQ(ups_ocio_smooth(&picture.desc, &out), UPS_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(ups_ocio_last_error()).find(words), std::string::npos) << ups_ocio_last_error();
    EXPECT_EQ(out, 7);
  };
  EXPECT_EQ(ups_ocio_smooth(&picture.desc, nullptr), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_ocio_smooth(nullptr, picture.rgb.data()), UPS_ERROR_INVALID_ARGUMENT);
  picture.desc.standard_error_rgb = nullptr;
  refused("standard_error_rgb is NULL");
  picture.desc.standard_error_rgb = picture.error.data();
  picture.error[4] = NAN;
  refused("standard_error_rgb: element 4 is");
  picture.error[4] = 0;
  picture.depth[9] = INFINITY;
  picture.desc.depth = picture.depth.data();
  refused("depth: element 9 is inf; it must be finite");
  picture.desc.depth = nullptr;
  picture.desc.reserved = 1;
  refused("reserved must be 0");
  picture.desc.reserved = 0;
  picture.desc.width = 0;
  refused("width and height must be 1 to 16384");
}

TEST(Exposure, ValuesAndFactorsAreInverse) {
  double exposure = 0, ev100 = 0;
  ASSERT_EQ(ups_ocio_get_exposure(3, &exposure), UPS_OK);  // 2^3 / 8 = 1 cd/m2
  EXPECT_NEAR(exposure, 0.26, 1e-12);
  ASSERT_EQ(ups_ocio_get_ev100(0.26 / 128, &ev100), UPS_OK);
  EXPECT_NEAR(ev100, 10, 1e-12);
  EXPECT_EQ(ups_ocio_get_ev100(0, &ev100), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_ocio_get_exposure(NAN, &exposure), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_ocio_get_exposure(101, &exposure), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_ocio_get_exposure(1, nullptr), UPS_ERROR_INVALID_ARGUMENT);
}

}  // namespace
