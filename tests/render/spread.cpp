// The arithmetic of errors, against numbers worked out by hand.
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <utility>

#include "render/goniometer_sums.h"
#include "render/image_sums.h"
#include "render/meter_rings.h"

namespace ups {
namespace {

TEST(Spread, StandardErrorIsThatOfTheMean) {
  double sums[batch_count];
  std::iota(sums, sums + batch_count, 1.0);
  const Spread s = spread(sums, 16);  // 1 to 16: squared deviations add up to 340
  EXPECT_DOUBLE_EQ(s.mean, 8.5);
  EXPECT_DOUBLE_EQ(s.standard_error, std::sqrt(340.0 / (16 * 15)));
  const double few[] = {1, 2, 6, 7};
  EXPECT_DOUBLE_EQ(spread(few, 4).standard_error, std::sqrt(26.0 / (4 * 3)));
  EXPECT_EQ(spread(few, 3).standard_error, -1);
}

// 18 samples: the first two batches have two, so that they count twice.
TEST(Spread, BatchesCountByTheirSamples) {
  uint32_t visits = 0;
  for (uint32_t b = 0; b < batch_count; ++b) visits += visits_of_batch(18, b);
  EXPECT_EQ(visits, 18u);
  double sums[batch_count] = {8, 2};
  std::fill(sums + 2, sums + batch_count, 1.0);  // means 4, 1, 1 ... of 2, 2, 1 ... samples: mean 24 / 18
  const Spread s = spread(sums, 18);
  const double mean = 24.0 / 18, square = 2 * (4 - mean) * (4 - mean) + 16 * (1 - mean) * (1 - mean);
  EXPECT_DOUBLE_EQ(s.mean, mean);
  EXPECT_DOUBLE_EQ(s.standard_error, std::sqrt(square / (18 * 15)));
}

TEST(Spread, QuantilesAreStudents) {  // of 3, 4, 14 and 15 degrees of freedom
  EXPECT_EQ(t_quantile(4), 3.182);
  EXPECT_EQ(t_quantile(5), 2.776);
  EXPECT_EQ(t_quantile(15), 2.145);
  EXPECT_EQ(t_quantile(16), 2.131);
  EXPECT_EQ(t_quantile(1000), 2.131);
  EXPECT_EQ(t_quantile(4, 2), 4.303);
  EXPECT_EQ(t_quantile(16, 2), 2.145);
}

TEST(Spread, ABoundHoldsBiasOfEitherSign) {
  for (const double bias : {-2.0, 2.0}) EXPECT_FLOAT_EQ(error_bound({10, 3}, {bias, 4}, 16), 2 + 2.131f * 5);
}

TEST(ZeroBound, IsTheRuleOfThree) {
  EXPECT_DOUBLE_EQ((ChanceLight{0, 0, 0}.bound(2, 10)), 3.00 * 2 / 10);
  EXPECT_DOUBLE_EQ((ChanceLight{1, 1, 0}.bound(2, 10)), 3.74 * 2 / 10);
  // Paths that came together: of one batch, more than of so many paths.
  EXPECT_DOUBLE_EQ((ChanceLight{5, 1, 40}.bound(2, 10)), 3.74 * 40 / 10);
}

// As rare as a normal number at its root: exact tails of Poisson's distribution, to one side, 0.15 of a deviation and 2 %.
TEST(ZeroBound, DeviancesAreThoseOfPoissonNumbers) {
  const auto chance = [](int events, double mean, bool below) {
    double sum = 0;
    for (int n = below ? 0 : events, end = below ? events + 1 : events + 200; n < end; ++n)
      sum += std::exp(-mean + n * std::log(mean) - std::lgamma(n + 1));
    return sum;
  };
  constexpr std::pair<int, double> numbers[] = {{0, 6.9}, {0, 20}, {8, 0.5}, {8, 2}, {20, 6}, {73, 115}, {150, 110}};
  for (const auto& [events, mean] : numbers) {
    const double deviations = std::sqrt(poisson_deviance(events, mean)), p = chance(events, mean, events < mean);
    const auto normal = [](double z) { return 0.5 * std::erfc(z / std::sqrt(2.0)); };
    EXPECT_LT(normal(1.02 * deviations + 0.15), p) << events << " of " << mean;
    EXPECT_GT(normal(0.98 * deviations - 0.15), p) << events << " of " << mean;
  }
  EXPECT_EQ(poisson_deviance(3, 3), 0);
  EXPECT_EQ(poisson_deviance(0, 0), 0);
}

// Half of each batch's photons on the inner half of the disc in even batches, so that the discs of the halves differ.
TEST(MeterRings, StateTheNoiseOfChoosing) {
  Rings rings;
  rings.count = 2;
  rings.area[0] = rings.area[1] = 1;
  rings.radius2[0] = rings.bias_scale[0] = 0.5, rings.radius2[1] = rings.bias_scale[1] = 1.5;
  MeterRings sums(1, 1, 2, false);
  const auto landing = [](uint8_t ring, double lm) { return MeterLanding{0, 0, ring, false, 0, 0, lm}; };
  for (uint32_t b = 0; b < batch_count; ++b) {
    for (int i = 0; i < 8; ++i) sums.add(0, b, landing(0, 3), b);
    for (int i = 0; i < 8; ++i) sums.add(0, b, landing(1, 1), b);
  }
  const MeterRings::Photons p = sums.read(0, rings, {0, 1}, 16);
  // Means of 24 and 16 lx; of variances 8 * 9 / 16 in the inner disc, 8 * 1 / 16 in the ring, of areas 1 and 2.
  const double difference2 = 64, noise2 = 0.25 * 4.5 + 0.5 / 4;
  EXPECT_DOUBLE_EQ(p.choice_variance, 0.25 * (difference2 - 2 * noise2));
  EXPECT_EQ(sums.read(0, rings, {1, 1}, 16).choice_variance, 0);
  EXPECT_DOUBLE_EQ(p.lx, 20);
}

// Wide hats say 3 cd, narrow ones 2.5: half the width changes half of the blur at a kink.
TEST(GoniometerSums, StateTwiceWhatTheNarrowHatsDifferIn) {
  const Goniometer g(Frame(), {0}, {0, 90, 180}, photometry::Symmetry::axial);
  GoniometerSums sums(g, 100, 1000);
  GoniometerTally tally = g.empty_tally();
  tally.wide[1] = 3 * g.wide_solid_angle(1), tally.narrow[1] = 2.5 * g.narrow_solid_angle(1);
  for (uint32_t b = 0; b < batch_count; ++b) sums.add(b, tally);
  const ups_intensity_reading r = sums.read(16).nodes[1];
  EXPECT_FLOAT_EQ(r.intensity_cd, 3);
  EXPECT_FLOAT_EQ(r.bias_cd, 1);
}

// An image of two passes' worth of pixels: splats come in every iteration, eye paths in every second one.
TEST(ImageSums, SplatsCountByIterations) {
  const Camera camera(Affine(), 4, 2, 1.0f, false);
  Plan plan;
  plan.camera_subsets = 2;
  ImageSums sums(camera, plan, 1);
  for (uint32_t i = 0; i < 32; ++i) {
    IterationTally tally;
    tally.pixels.emplace_back(4, Rgb(1.0f));
    tally.splats.push_back({{3, 0, Rgb(float(i / 2 % 2))}});  // 0 and 1 by passes
    sums.add(i, tally, 0);
  }
  const ImageReading image = sums.read(32, 0);
  EXPECT_FLOAT_EQ(image.luminance_rgb[0], 1);
  EXPECT_FLOAT_EQ(image.luminance_rgb[3 * 3], 1.5f);
  EXPECT_FLOAT_EQ(image.standard_error_rgb[0], 0);
  EXPECT_FLOAT_EQ(image.standard_error_rgb[3 * 3], 0.5f / std::sqrt(15.0f));  // of 16 batches that are 1 or 2
}

// A pixel whose own bias is beyond doubt: its noise is that of its visits' mean.
TEST(PixelBias, NoiseIsThatOfTheMean) {
  PixelBias bias(8, 8);
  for (uint32_t i = 0; i < 16; ++i) {
    bias.add(0, i % 2 ? 1.5f : 0.5f);
    bias.end_pass(i);
  }
  const Spread own = bias.of_pixel(0, 16, 1, bias.of_squares(16, std::vector<float>(64, 1.0f)));
  EXPECT_FLOAT_EQ(float(own.mean), 1);
  EXPECT_DOUBLE_EQ(own.standard_error, 0.5 / std::sqrt(15.0));
}

// Where half of a square shows a lamp, which merges nothing, the others keep the bias that they have together, in
// proportion to their light where it is more than theirs in the mean; the lamp is no brighter for it.
TEST(PixelBias, DarkPixelsBesideALampHaveTheirSquaresBias) {
  PixelBias bias(8, 8);
  std::vector<float> light(64, 50.0f);
  std::fill_n(light.begin(), 32, 1e5f);
  light[63] = 100;
  for (uint32_t i = 0; i < 16; ++i) {
    for (uint32_t p = 32; p < 64; ++p) bias.add(p, (i + p) % 2 ? 20.0f : -16.0f);  // 2, in 18 of noise
    bias.end_pass(i);
  }
  const auto squares = bias.of_squares(16, light);
  const double mean = (31 * 50 + 100) / 32.0;
  EXPECT_NEAR(bias.of_pixel(40, 16, light[40], squares).mean, 2, 1e-5);
  EXPECT_NEAR(bias.of_pixel(63, 16, light[63], squares).mean, 2 * 100 / mean, 1e-5);
  EXPECT_NEAR(bias.of_pixel(0, 16, light[0], squares).mean, 2, 1e-5);
}

}  // namespace
}  // namespace ups
