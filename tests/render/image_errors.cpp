// What images say of bias and of single samples, from tallies made here.
#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "render/image_sums.h"

namespace ups {
namespace {

struct Rig {
  Rig() {
    tally.pixels.assign(1, std::vector<Rgb>(camera.pixel_count(), Rgb(1.0f)));
    tally.pixel_merges.assign(1, std::vector<PixelMerges>(camera.pixel_count()));
    tally.splats.resize(1);
  }
  const Camera camera{Affine(), 16, 8, 1.0f, false};
  Plan plan;
  IterationTally tally;
};

// Noise that all pixels of a square share in an iteration, as they share photons, does not pass for bias.
TEST(PixelBias, SharedNoiseIsKnownAsNoise) {
  Rig rig;
  ImageSums sums(rig.camera, rig.plan, 1);
  std::mt19937 random(1);
  std::normal_distribution<float> noise(0.0f, 1.0f);
  for (uint32_t i = 0; i < 400; ++i) {
    std::fill(rig.tally.pixel_merges[0].begin(), rig.tally.pixel_merges[0].end(), PixelMerges{noise(random)});
    sums.add(i, rig.tally, 0);
  }
  const ImageReading image = sums.read(400, 0);
  for (float bound : image.error_bound) {  // t |b| and its noise of 0.05, the luminance has none
    EXPECT_GT(bound, 2.1 * 0.05 * 0.5);    // 16 batches know a deviation to 18 %: 3 of them
    EXPECT_LT(bound, (2.2 + 4) * 0.05 * 1.6);
  }
}

// A pixel beside an edge has a bias that those around it have not: its own.
TEST(PixelBias, OwnBiasStaysWhereItIsBeyondDoubt) {
  Rig rig;
  ImageSums sums(rig.camera, rig.plan, 1);
  std::mt19937 random(2);
  std::normal_distribution<float> noise(0.0f, 0.1f);
  for (uint32_t i = 0; i < 64; ++i) {
    for (PixelMerges& m : rig.tally.pixel_merges[0]) m.bias = noise(random);
    rig.tally.pixel_merges[0][5].bias += 0.5f;
    sums.add(i, rig.tally, 0);
  }
  const ImageReading image = sums.read(64, 0);
  EXPECT_NEAR(image.bias[5], 0.5, 0.1);
  EXPECT_GT(image.error_bound[5], 0.4);
  EXPECT_LT(image.error_bound[6], 0.1);
}

// Where merging makes all the noise, its bias estimate has four times the variance; it may be noise and counts as that.
// 16 batches know a variance to 37 %, so that where all is merged some 0.9 seem to be.
TEST(PixelBias, TellsWhatMergingMakes) {
  for (const double merged : {0.0, 1.0}) {
    Rig rig;
    ImageSums sums(rig.camera, rig.plan, 1);
    std::mt19937 random(3);
    std::normal_distribution<float> noise(0.0f, 0.1f);
    for (uint32_t i = 0; i < 64; ++i) {
      for (PixelMerges& m : rig.tally.pixel_merges[0]) m.bias = merged > 0 ? 2 * noise(random) : 0;
      for (Rgb& v : rig.tally.pixels[0]) v = Rgb(1 + noise(random));
      sums.add(i, rig.tally, 0);
    }
    std::vector<double> errors;
    MeanError together;
    ASSERT_TRUE(sums.relative_errors(64, 0, errors, together));
    const double mean = std::accumulate(errors.begin(), errors.end(), 0.0) / double(errors.size());
    EXPECT_NEAR(together.mean().error() / mean, 1, 1e-4);
    if (merged == 0) {
      EXPECT_NEAR(mean, 2.131 * 0.1 / 8, 0.002) << "as if there were no photons";
    }
    EXPECT_NEAR(together.mean().merged, merged, 0.25) << merged;
    EXPECT_LT(together.mean().bias, 0.2f * together.mean().noise);
    EXPECT_EQ(together.mean().visits, 64u);
  }
}

// Where no photon was merged there is no bias, and nothing is added for it: neither to luminance nor to illuminance.
TEST(PixelBias, AddsNothingWhereNothingWasMerged) {
  Rig rig;
  ImageSums image(rig.camera, rig.plan, 1);
  IlluminanceSums illuminance(rig.camera, rig.plan, 1);
  std::vector<PixelIlluminance> lx(rig.camera.pixel_count());
  std::mt19937 random(4);
  std::normal_distribution<float> noise(0.0f, 0.01f);
  for (uint32_t i = 0; i < 64; ++i) {
    for (size_t p = 0; p < lx.size(); ++p) rig.tally.pixels[0][p] = Rgb(lx[p].lx = 1 + noise(random));
    image.add(i, rig.tally, 0);
    illuminance.add(i, lx, true);
  }
  const ImageReading seen = image.read(64, 0);
  const IlluminanceReading lit = illuminance.read(std::vector<uint32_t>(lx.size(), 64), 64, 0);
  for (size_t p = 0; p < lx.size(); ++p) {
    EXPECT_NEAR(seen.error_bound[p], 2.131f * seen.standard_error_rgb[3 * p], 1e-5);
    EXPECT_NEAR(lit.error_bound[p], 2.131f * lit.standard_error[p], 1e-5);
  }
}

// A pixel that light reaches too seldom for a standard error has a bound, and its bias is in that.
TEST(PixelBias, IsInTheBoundOfWhatIsSeldomLit) {
  std::vector<float> bounds[2];
  for (const float bias : {0.0f, 3.0f}) {
    Rig rig;
    rig.tally.pixels[0].assign(rig.camera.pixel_count(), Rgb());
    ImageSums image(rig.camera, rig.plan, 1);
    IlluminanceSums illuminance(rig.camera, rig.plan, 1);
    std::vector<PixelIlluminance> lx(rig.camera.pixel_count());
    for (uint32_t i = 0; i < 64; ++i) {
      rig.tally.pixels[0][5] = Rgb(i < 3 ? 40.0f : 0.0f);
      rig.tally.pixel_merges[0][5].bias = lx[5].merges.bias = bias;
      lx[5].lx = i < 3 ? 40 : 0;
      image.add(i, rig.tally, 0);
      illuminance.add(i, lx, true);
    }
    const std::vector<uint32_t> visits(lx.size(), 64);
    const ImageReading seen = image.read(64, 0);
    EXPECT_LT(seen.standard_error_rgb[5 * 3], 0);
    bounds[0].push_back(seen.error_bound[5]);
    bounds[1].push_back(illuminance.read(visits, 64, 0).error_bound[5]);
  }
  for (const auto& of : bounds) EXPECT_NEAR(of[1] - of[0], 3, 1e-4);
}

// One sample in a thousand brings nearly all of a pixel's light.
TEST(RobustImage, LeavesOutWhatASingleSampleBrought) {
  Rig rig;
  ImageSums sums(rig.camera, rig.plan, 1);
  for (uint32_t i = 0; i < 1000; ++i) {
    rig.tally.pixels[0][7] = i == 500 ? Rgb(9000.0f) : Rgb(1.0f);
    sums.add(i, rig.tally, 0);
  }
  const ImageReading image = sums.read(1000, 0);
  EXPECT_NEAR(image.luminance_rgb[7 * 3], 10, 1e-2);
  EXPECT_NEAR(image.robust_rgb[7 * 3], 1, 1e-3);
  EXPECT_FLOAT_EQ(image.robust_rgb[8 * 3], image.luminance_rgb[8 * 3]);
}

// Of four pixels half see something, 1 cm2 of which is theirs, in 100 iterations of 1000 light paths.
TEST(PixelCaustics, AreBoundedUntilEightPhotonsHaveCome) {
  for (const uint32_t found : {0u, 7u, 8u}) {
    PixelCaustics caustics(64, 16);
    for (uint32_t i = 0; i < 100; ++i)
      for (uint32_t p = 0; p < 4; ++p) {
        const bool finds = p == 0 && i < found;
        caustics.add(p, {0, p < 2 ? 1e-4f : 0, finds ? 1.0f : 0, finds ? 4.0f : 0, finds ? 0.5f : 0});
        caustics.add(p + 16, {});
      }
    const double m2_paths = 200 * 1e-4 * 1000, limit = found == 0 ? 3.0 : found == 7 ? 6.15 : 0,
                 bound = 0.5 * 500 * limit / m2_paths;
    const auto unfound = caustics.unfound(500, 1000);
    ASSERT_EQ(unfound.size(), 4u);
    EXPECT_NEAR(unfound[0].lx, bound, 1e-3) << found;
    EXPECT_EQ(unfound[1].lx, 0) << "the sky beside it";
    EXPECT_EQ(unfound[1].photons, found);
    EXPECT_EQ(unfound[0].photons, found);
    EXPECT_EQ(unfound[2].lx, 0) << "where nothing was looked at";
    // Of a pixel that sees something: `found` / 50 are met in a visit. Which do is not known.
    const double light = 0.5 * found / 200;
    EXPECT_NEAR(unfound[0].noise(20), found ? light / std::sqrt(0.4 * found) : 0, 1e-6) << found;
    EXPECT_NEAR(unfound[0].noise(1), light, 1e-6) << "less than one is due";
    EXPECT_EQ(unfound[0].noise(100), 0) << "fourteen or more are due, or none";
    EXPECT_EQ(unfound[1].noise(20), 0) << "the sky beside it";
    EXPECT_EQ(caustics.unfound(0, 1000)[0].lx, 0) << "nothing casts any";
  }
}

}  // namespace
}  // namespace ups
