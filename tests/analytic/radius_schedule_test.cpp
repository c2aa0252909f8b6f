// Does the alpha that a user asks for set how fast merging shrinks? Under a sun that stands straight above a floor that
// pixels see every photon falls on a pixel's disc of radius r with the same probability, so that merges count r^2:
//   E[merges in n iterations] = N sum_i r_i^2 / R^2 for each pixel,   r^2_{i+1} = r^2_i (i + alpha) / (i + 1),
// R the radius of the disc that the sun's light starts on, around the whole scene. Another of the alphas is off by 15 %
// or more. (Meters' discs do not shrink.)
//
// The photons are stratified, so that their number on a disc varies less than the 0.32 % of 1e5 by Poisson's law. The
// picture is judged by expect_lx.h, its noise that of pixels whose discs hardly overlap; merges are the same photons,
// to 0.5 %: 1 % of either is found in 96 cases of 100 at the least.
#include "../support/expect_lx.h"

namespace ups::test {
namespace {

constexpr uint32_t iterations = 32;

double sum_of_factors(double alpha) {
  double r2 = 1, sum = 0;
  for (uint32_t i = 1; i <= iterations; ++i) {
    sum += r2;
    r2 *= (i + alpha) / (i + 1);
  }
  return sum;
}

class RadiusSchedule : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Alphas, RadiusSchedule, ::testing::Values(0, 0.5, 0.8),
                         [](const auto& i) { return std::to_string(int(100 * i.param)); });

TEST_P(RadiusSchedule, FollowsTheAlphaAskedFor) {
  constexpr double radius = 0.2;
  constexpr uint32_t light_paths = 1u << 16;
  Scene scene;
  scene.add(quad({-1.2, -1.2, 0}, {2.4, 0, 0}, {0, 2.4, 0}), matte(0.5));
  scene.add_directional({0, 0, -1}, 1000);
  const Sensor camera = scene.add_camera({0, 0, 1}, {0, 0, -1}, 4, 4, 1.4);  // sees 0.84 m from the middle at the most
  const Result result = scene.render({.method = UPS_METHOD_PPM,
                                      .iterations = iterations,
                                      .merge_radius_m = radius,
                                      .light_paths = light_paths,
                                      .radius_alpha = GetParam()});
  // R is half the diagonal of what has a place, and a tenth more for meters' discs at its rim.
  const double sun2 = 1.1 * 1.1 * (2 * 2.4 * 2.4 + 1) / 4;
  const double alpha = GetParam() > 0 ? GetParam() : 2.0 / 3;
  const double expected = 16 * light_paths * radius * radius / sun2 * sum_of_factors(alpha);
  EXPECT_GT(expected, 1e5);
  EXPECT_NEAR(double(result.info().merges) / expected, 1, 0.005);
  const Image image = result.image(camera);
  double mean = 0, error = 0;
  for (size_t pixel = 0; pixel < 16; ++pixel) {
    mean += double(image.luminance[3 * pixel]) / 16;
    error = std::hypot(error, double(image.standard_error[3 * pixel]) / 16);
  }
  expect_lx(mean, error, 0.5 * 1000 / pi_d, quiet, "cd/m2");
}

}  // namespace
}  // namespace ups::test
