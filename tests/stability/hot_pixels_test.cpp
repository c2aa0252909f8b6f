// Rare bright samples: path tracing that finds a small lamp by way of a mirror once in hundreds of paths. Nothing is
// clamped: means over many renders are those of the closed form; a single render says that it is not to be trusted.
#include <algorithm>
#include <numeric>

#include "../support/expect_lx.h"
#include "../support/image_mean.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

constexpr double mirror_z = 2, luminance = 500, reflectance = 0.9;

// A screen hides the lamp from the floor, which its image in the mirror lights; a second lamp lights the floor evenly
// where pixels are looked at.
struct Fireflies {
  Scene scene;
  Shape image;  // of the lamp in the mirror
  Sensor meters, camera;
  Fireflies(double candela, double rho, double lamp_half) {
    scene.add(quad({-0.5, -0.5, mirror_z}, {0, 1, 0}, {1, 0, 0}), photon_mirror(reflectance));
    scene.add(quad({-lamp_half, -lamp_half, 1.2}, {2 * lamp_half, 0, 0}, {0, 2 * lamp_half, 0}), emitter(luminance));
    scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte(rho));
    if (candela > 0) scene.add_point_light({0, 0, 1.19}, candela);
    image = quad({-lamp_half, -lamp_half, 2 * mirror_z - 1.2}, {0, 2 * lamp_half, 0}, {2 * lamp_half, 0, 0});
    std::vector<P3> at;
    for (int i = 0; i < 64; ++i) at.push_back(meter(i));
    meters = scene.add_meters(at, {0, 0, 1});
    camera = scene.add_camera({0.45, 0.45, 1}, {0, 0, -1}, 16, 16, 0.2);
  }
  static P3 meter(int i) { return {0.3 + 0.02 * (i % 8), 0.3 + 0.02 * (i / 8), 0.3}; }
  double mirrored_lx(const P3& p) const {
    return reflectance * luminance * polygon_irradiance_factor(image.vertices, p, {0, 0, 1});
  }
};

// 64 meters, few paths each: means over 300 seeds within 4 standard errors of at most 0.16 %, so that 1 % is found in
// 98 of 100 cases and a false alarm comes once in 12,000 (P(|t_299| > 4)). Every reading that a few paths made is
// flagged as such: of those without a flag, which are most, at most 1 % err by twice their bound. (A wider lamp, of less
// noise, would hide a part of its image.)
TEST(Hazard28, FirefliesAtMetersAreFlaggedAndUnbiased) {
  Fireflies room(0, 0, 0.12);
  double expected = 0;
  for (int i = 0; i < 64; ++i) expected += room.mirrored_lx(Fireflies::meter(i)) / 64;
  std::vector<double> means;
  int unflagged = 0, wrong = 0, all = 0;
  for (uint64_t seed = 1; seed <= less_with_effort(300, 2); ++seed) {
    const Result r = room.scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 16, .seed = seed});
    means.push_back(0);
    const auto readings = r.readings(room.meters);
    const auto flags = r.flags(room.meters);
    for (size_t i = 0; i < readings.size(); ++i) {
      means.back() += readings[i].illuminance_lx / 64;
      const bool flagged = flags[i] & (UPS_READING_FEW_PATHS | UPS_READING_SINGLE_PATH | UPS_READING_HEAVY_TAIL);
      ++all, unflagged += !flagged;
      wrong += !flagged && std::abs(readings[i].illuminance_lx - expected) > 2 * readings[i].error_bound_lx;
    }
  }
  const Mean mean = mean_of(means);
  measured("mean %+.2f +- %.2f %%, %d of %d readings without a flag, %d of them beyond twice their bound",
           100 * (mean.value / expected - 1), 100 * mean.standard_error / expected, unflagged, all, wrong);
  EXPECT_LE(mean.standard_error, 0.0016 * expected) << "too noisy to judge";
  EXPECT_NEAR(mean.value, expected, 4 * mean.standard_error) << expected;
  EXPECT_GT(unflagged, all / 2);
  EXPECT_LE(wrong, 0.01 * unflagged);
}

// A lamp a sixth as wide, found by one path in 10,000: no reading of it is told without a flag. Flags alone are judged, of
// seeds that are fixed.
TEST(Hazard28, RareFirefliesAtMetersAreAllFlagged) {
  Fireflies room(0, 0, 0.02);
  for (uint64_t seed = 1; seed <= 8; ++seed) {
    const Result r = room.scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 16, .seed = seed});
    for (const uint32_t flags : r.flags(room.meters))
      EXPECT_NE(flags & (UPS_READING_FEW_PATHS | UPS_READING_SINGLE_PATH | UPS_READING_HEAVY_TAIL), 0u) << seed;
  }
}

// The same at pixels that another lamp lights: their mean is right, the robust channel leaves the specks out, and the
// difference of the two tells the pixels that have some. The mean is judged to 3 standard errors of at most 0.33 %:
// 1.7 % is found in 98 of 100 cases, and P(|t_35| > 3) = 0.5 % is the chance of a false alarm; in the fast form of at
// most 0.4 %, so that 2 % is, and P(|t_23| > 3) = 0.6 %. At least 95 % of the specks must be told.
TEST(Hazard28, FirefliesInAnImageAreToldByItsRobustChannel) {
  constexpr double rho = 0.5;
  Fireflies room(50, rho, 0.12);
  std::vector<double> means;
  double expected = 0, even = 0;
  int specks = 0, told = 0;
  const double half = std::tan(0.1);
  const auto point = [&](uint32_t p) {
    return P3{0.45 + ((p % 16 + 0.5) / 8 - 1) * half, 0.45 + (1 - (p / 16 + 0.5) / 8) * half, 0};
  };
  for (uint32_t p = 0; p < 256; ++p) {
    const P3 at = point(p), d = P3{0, 0, 1.19} - at;
    even += 50 * d.z / std::pow(length(d), 3) * rho / pi_d / 256;
    expected += room.mirrored_lx(at) * rho / pi_d / 256;
  }
  for (uint64_t seed = 1; seed <= fast_or_full(24u, 36u); ++seed) {
    const Image image =
        room.scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 64, .seed = seed, .max_path_length = 3})
            .image(room.camera);
    means.push_back(std::accumulate(image.luminance.begin(), image.luminance.end(), 0.0) / 768);
    for (uint32_t p = 0; p < 256; ++p) {
      const bool speck = image.luminance[3 * p] > 1.5 * even;
      specks += speck;
      told += speck && image.robust[3 * p] < 0.8 * image.luminance[3 * p];
    }
  }
  const Mean mean = mean_of(means);
  measured("image %+.2f +- %.2f %%, %d of %d specks told", 100 * (mean.value / (even + expected) - 1),
           100 * mean.standard_error / (even + expected), told, specks);
  EXPECT_LE(mean.standard_error, fast_or_full(0.004, 0.0033) * (even + expected)) << "too noisy to judge";
  EXPECT_NEAR(mean.value, even + expected, 3 * mean.standard_error);
  EXPECT_GT(specks, 100);
  EXPECT_GE(told, 0.95 * specks);
}

}  // namespace
}  // namespace ups::test
