// Sums over ten million iterations lose nothing: of meters, of discs' rings and of pixels.
#include <gtest/gtest.h>

#include <cmath>

#include "../support/figures.h"
#include "render/image_sums.h"
#include "render/meter_sums.h"

namespace ups {
namespace {

constexpr uint32_t additions = 10'000'000;
// 1 with an error of 1e-6, of every third addition to a batch the other way: floats would lose them, and their mean is
// not what rounding to 1 gives.
bool is_above(uint32_t i) { return i / batch_count % 3 == 0; }
double term(uint32_t i) { return is_above(i) ? 1 + 1e-6 : 1 - 1e-6; }
double mean_term(uint32_t terms) {
  uint32_t above = 0;
  for (uint32_t i = 0; i < terms; ++i) above += is_above(i);
  return 1 + 1e-6 * (2.0 * above - terms) / terms;
}

double relative_error(double mean) { return std::abs(mean / mean_term(additions) - 1); }

TEST(Hazard27, TenMillionAdditionsToAMeterKeepNineDigits) {
  MeterSums sums;
  for (uint32_t i = 0; i < additions; ++i) sums.add(i % batch_count, MeterTally::of_path(term(i), term(i), 0), i);
  test::measured("off by %.1e", relative_error(spread(sums.value, additions).mean));
  EXPECT_LE(relative_error(spread(sums.value, additions).mean), 1e-9);
  EXPECT_LE(relative_error(spread(sums.direct, additions).mean), 1e-9);
  EXPECT_LE(spread(sums.value, additions).standard_error, 1e-9);
  EXPECT_EQ(sums.paths[whole_light].count, additions);
}

TEST(Hazard27, TenMillionPhotonsOnADiscKeepNineDigits) {
  const MeterDiscs discs(1, max_rings, 1);
  const Rings rings = discs.rings(0, 0);
  MeterRings sums(1, 1, max_rings, true);
  for (uint32_t i = 0; i < additions; ++i)
    sums.add(0, i % batch_count, {0, 0, uint8_t(max_rings - 1), true, 0, 0, term(i)}, i);
  const MeterRings::Photons p = sums.read(0, rings, {max_rings - 1, max_rings - 1}, additions);
  double mean = 0, direct = 0;
  for (uint32_t b = 0; b < batch_count; ++b) mean += p.value[b], direct += p.direct[b];
  const double expected = 1 / 3.14159265358979323846;
  test::measured("off by %.1e", relative_error(mean / additions / expected));
  EXPECT_LE(relative_error(mean / additions / expected), 1e-9);
  EXPECT_LE(relative_error(direct / additions / expected), 1e-9);
  EXPECT_EQ(p.paths.count, additions);
}

// Pixels are told in floats: their mean is right to the rounding of one, the error that is stated of it stays below
// what rounding of 10^6 terms in batches may make, 1e-4.
TEST(Hazard27, AMillionAdditionsToAPixel) {
  const Camera camera{Affine(), 16, 8, 1.0f, false};
  Plan plan;
  IterationTally tally;
  tally.pixels.assign(1, std::vector<Rgb>(camera.pixel_count(), Rgb(1.0f)));
  tally.pixel_merges.assign(1, std::vector<PixelMerges>(camera.pixel_count()));
  tally.splats.resize(1);
  ImageSums sums(camera, plan, 1);
  constexpr uint32_t million = 1'000'000;
  for (uint32_t i = 0; i < million; ++i) {
    tally.pixels[0][7] = Rgb(float(term(i)));
    sums.add(i, tally, 0);
  }
  const ImageReading image = sums.read(million, 0);
  test::measured("off by %.1e; stated standard error %.1e", std::abs(image.luminance_rgb[7 * 3] - mean_term(million)),
                 double(image.standard_error_rgb[7 * 3]));
  EXPECT_NEAR(image.luminance_rgb[7 * 3], mean_term(million), 1.2e-7);
  EXPECT_GE(image.standard_error_rgb[7 * 3], 0);
  EXPECT_LE(image.standard_error_rgb[7 * 3], 1e-4);
  EXPECT_NEAR(image.robust_rgb[7 * 3], 1, 1e-4);
}

}  // namespace
}  // namespace ups
