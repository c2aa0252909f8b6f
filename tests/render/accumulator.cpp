// Is the reported error honest: does its 95 % interval cover the truth, and the standard error match the spread?
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "render/accumulator.h"

namespace {

using namespace ups;

struct Rig {
  Snapshot scene;
  Plan plan;
  IterationTally tally;
  explicit Rig(uint32_t meters) {
    scene.meter_sets.resize(1);
    scene.meter_sets[0].meters.resize(meters);
    tally.meters.assign(1, std::vector<MeterTally>(meters));
  }
};

// Gaussian iterations whose variance drifts as a shrinking radius makes it. 2000 meters: the share covered by a 95 %
// interval has standard deviation 0.5 %; outside 93..97 % by chance: about 4 in 10^5.
TEST(Accumulator, IntervalCoversTheTruth) {
  Rig rig(2000);
  Accumulator sums(rig.scene, rig.plan);
  std::mt19937_64 random(7);
  std::normal_distribution<double> normal;
  for (int i = 1; i <= 80; ++i) {
    for (MeterTally& m : rig.tally.meters[0]) m = {100 + 10 * std::pow(i, 1.0 / 6) * normal(random), 0, 0};
    sums.add(rig.tally);
  }
  const MeterSetReading r = sums.read_meters(0);
  int covered = 0;
  double mean_square = 0, predicted = 0;
  for (const ups_meter_reading& m : r.meters) {
    covered += std::abs(m.illuminance_lx - 100) <= m.error_bound_lx;
    mean_square += std::pow(m.illuminance_lx - 100, 2) / 2000;
    predicted += std::pow(m.standard_error_lx, 2) / 2000;
  }
  EXPECT_NEAR(covered / 2000.0, 0.95, 0.02);
  EXPECT_NEAR(predicted / mean_square, 1.0, 0.15);  // a chi-square of 2000 over one of 30000 degrees: sd 0.033
  EXPECT_NEAR(r.statistics.mean_lx, 100, 5 * r.statistics.mean_standard_error_lx);
}

// Bias b(r) = b_1 r^2 and its noisy estimate: the bound must still hold where a noise-only interval would not.
TEST(Accumulator, BoundCoversBias) {
  Rig rig(1000);
  Accumulator sums(rig.scene, rig.plan);
  std::mt19937_64 random(8);
  std::normal_distribution<double> normal;
  for (uint32_t i = 0; i < 64; ++i) {
    const double bias = 8 * Plan::radius2_factor(i, 2.0 / 3);
    for (MeterTally& m : rig.tally.meters[0]) {
      const double noise = 6 * normal(random), other = 12 * normal(random);
      m = {100 + bias + noise, 0, bias + other};
    }
    sums.add(rig.tally);
  }
  int covered = 0, noise_only = 0;
  for (const ups_meter_reading& m : sums.read_meters(0).meters) {
    covered += std::abs(m.illuminance_lx - 100) <= m.error_bound_lx;
    noise_only += std::abs(m.illuminance_lx - 100) <= 2.131 * m.standard_error_lx;
  }
  EXPECT_GE(covered, 950);
  EXPECT_LT(noise_only, 200);
}

TEST(Accumulator, ErrorIsUnknownBeforeFourIterations) {
  Rig rig(1);
  Accumulator sums(rig.scene, rig.plan);
  for (int i = 0; i < 3; ++i) {
    rig.tally.meters[0][0] = {1, 0.25, 0};
    sums.add(rig.tally);
    const ups_meter_reading m = sums.read_meters(0).meters[0];
    EXPECT_EQ(m.standard_error_lx, -1);
    EXPECT_EQ(m.error_bound_lx, -1);
    EXPECT_EQ(m.illuminance_lx, 1);
    EXPECT_EQ(m.direct_lx, 0.25f);
    EXPECT_EQ(m.indirect_lx, 0.75f);
    EXPECT_LT(sums.summarize().worst, 0);
  }
  sums.add(rig.tally);
  EXPECT_EQ(sums.read_meters(0).meters[0].standard_error_lx, 0);
}

// Pixels come by subsets, splats in every iteration; the mean must not depend on where a pass stands.
TEST(Accumulator, ImageAddsEyePathsAndSplats) {
  Snapshot scene;
  scene.cameras.emplace_back(Affine(), 8, 4, 1.0f, false);
  Plan plan;
  plan.camera_subsets = 3;
  Accumulator sums(scene, plan);
  IterationTally tally;
  tally.pixels.assign(1, std::vector<Rgb>(32, Rgb(2.0f)));
  tally.splats.assign(1, std::vector<Rgb>(32, Rgb(1.0f, 0.5f, 0.25f)));
  for (int i = 0; i < 40; ++i) {
    sums.add(tally);
    if (i < 2) continue;  // a first pass visits every pixel
    const ImageReading image = sums.read_image(0);
    for (size_t p = 0; p < 32; ++p) {
      ASSERT_FLOAT_EQ(image.luminance_rgb[p * 3], 3.0f);
      ASSERT_FLOAT_EQ(image.luminance_rgb[p * 3 + 2], 2.25f);
      ASSERT_NEAR(image.standard_error_rgb[p * 3], i + 1 < 12 ? -1.0f : 0.0f, 1e-6);
    }
  }
}

}  // namespace
