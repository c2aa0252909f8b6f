// Every projection by every technique against what must come out: a room of one luminance reads it everywhere in the
// image, and a fisheye's and a panorama's light from the half space adds up to what a meter reads at the same place.
#include <array>
#include <vector>

#include "../support/expect_lx.h"
#include "../support/image_mean.h"

namespace ups::test {
namespace {

constexpr ups_projection projections[] = {UPS_PERSPECTIVE, UPS_EQUIDISTANT, UPS_EQUISOLID, UPS_PANORAMA};
constexpr const char* names[] = {"perspective", "equidistant", "equisolid", "panorama"};

bool is_fisheye(ups_projection p) { return p == UPS_EQUIDISTANT || p == UPS_EQUISOLID; }

// From the middle of a pixel to that of the image circle, whose radius is 1.
double from_middle(uint32_t x, uint32_t y, uint32_t side) {
  return std::hypot(2 * (x + 0.5) / side - 1, 2 * (y + 0.5) / side - 1);
}

// Means over the pixels of two parts of a square image: a fisheye's inner and outer half, a panorama's half ahead and
// half behind, of a perspective image its upper and lower half. Pixels on the rim of the image circle are left out.
std::array<Mean, 2> means_of_parts(const Image& image, ups_projection p, uint32_t side) {
  double sums[2] = {0, 0}, squares[2] = {0, 0}, counts[2] = {0, 0};
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const double r = from_middle(x, y, side);
      if (is_fisheye(p) && r > 1 - 1.5 / side) continue;
      const size_t part = is_fisheye(p)        ? r > 0.7
                          : p == UPS_PANORAMA ? x < side / 4 || x >= 3 * side / 4
                                              : y >= side / 2;
      const size_t green = 3 * (size_t(y) * side + x) + 1;
      EXPECT_GE(image.standard_error[green], 0) << "no standard error at " << x << ", " << y;
      sums[part] += double(image.luminance[green]);
      squares[part] += std::pow(double(image.standard_error[green]), 2);
      ++counts[part];
    }
  return {Mean{sums[0] / counts[0], std::sqrt(squares[0]) / counts[0]},
          Mean{sums[1] / counts[1], std::sqrt(squares[1]) / counts[1]}};
}

// Every surface emits Le and reflects rho: L = Le / (1 - rho). 1 % for each half of an image. Its noise was 0.3 % at
// the most by the spread over seeds, and is that by its pixels' errors, too, taken for their own: P(|t_15| > 3.3) =
// 0.5 % is the chance of a false alarm, and an error of 2 % of half an image is found in 99 cases of 100.
TEST(Projections, AUniformRoomReadsItsLuminanceByEveryTechnique) {
  constexpr uint32_t side = 40;
  const double rho = 0.6, emitted = 10, expected = emitted / (1 - rho);
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 4, 4}).flipped(), emitter(emitted, rho));
  std::vector<Sensor> cameras;
  for (const ups_projection p : projections)
    cameras.push_back(scene.add_camera({1.8, 2.1, 1.9}, {1, 0.3, -0.2}, side, side, 1.2, false, p));
  for (const ups_method method : {UPS_METHOD_PATH_TRACING, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_BIDIRECTIONAL,
                                  UPS_METHOD_PPM, UPS_METHOD_UPS}) {
    const Result result = scene.render({.method = method, .iterations = method == UPS_METHOD_PPM ? 256u : 64u});
    for (size_t c = 0; c < cameras.size(); ++c) {
      const Image image = result.image(cameras[c]);
      for (const Mean& mean : means_of_parts(image, projections[c], side)) {
        EXPECT_LE(mean.standard_error, 0.003 * expected) << method_name(method) << ", " << names[c];
        EXPECT_NEAR(mean.value, expected, 0.01 * expected) << method_name(method) << ", " << names[c];
      }
      if (!is_fisheye(projections[c])) continue;
      for (const size_t corner : {size_t(0), size_t(3 * (side * side - 1))}) {  // no light, and that is certain
        EXPECT_EQ(image.luminance[corner], 0) << names[c];
        EXPECT_EQ(image.standard_error[corner], 0) << names[c];
        EXPECT_EQ(image.error_bound[corner / 3], 0) << names[c];
      }
    }
  }
}

// Of a pixel: its solid angle times the cosine from the axis, at its middle.
double weight_of(uint32_t x, uint32_t y, uint32_t side, ups_projection p) {
  if (p == UPS_PANORAMA) {
    const double longitude = 2 * pi_d * (x + 0.5) / side - pi_d, zenith = pi_d * (y + 0.5) / side,
                 solid_angle = 2 * pi_d / side * (std::cos(pi_d * y / side) - std::cos(pi_d * (y + 1) / side));
    return solid_angle * std::max(0.0, std::sin(zenith) * std::cos(longitude));
  }
  const double r = from_middle(x, y, side), area = 4.0 / side / side;
  if (r >= 1) return 0;
  if (p == UPS_EQUISOLID) return 2 * area * std::cos(2 * std::asin(r / std::sqrt(2.0)));
  const double angle = r * pi_d / 2;
  return pi_d * pi_d / 4 * std::sin(angle) / angle * area * std::cos(angle);
}

// What an image adds up to, with the noise that its pixels' errors have, each taken for its own.
Mean lux_of(const Image& image, uint32_t side, ups_projection p) {
  Mean lx;
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const double weight = weight_of(x, y, side, p);
      if (weight == 0) continue;
      const size_t green = 3 * (size_t(y) * side + x) + 1;
      EXPECT_GE(image.standard_error[green], 0) << "no standard error at " << x << ", " << y;
      lx.value += weight * double(image.luminance[green]);
      lx.standard_error = std::hypot(lx.standard_error, weight * double(image.standard_error[green]));
    }
  return lx;
}

// Within 0.6 %, of which the sum over pixels takes 0.2 %, at standard errors of at most 0.1 % of the meter and 0.13 % of
// each image, asserted: together 0.16 %. Where that sum takes all of it, P(|t_15| > 2.4) = 3 % a picture is the chance of
// a false alarm, and far less where images are less noisy; 1 % is found in 99 cases of 100.
TEST(Projections, LightFromTheHalfSpaceIsWhatAMeterReads) {
  constexpr uint32_t side = 64;
  const P3 place{1.2, 2.5, 1.4}, ahead{1, -0.4, 0.1};
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.6));
  scene.add(quad({1.5, 1, 2.99}, {0, 1.2, 0}, {1.2, 0, 0}), emitter(500, 0.3));
  const Sensor meter = scene.add_meters({place}, ahead);  // rendered alone: an image's sum is far less noisy
  const ups_meter_reading reading =
      scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 2048}).readings(meter)[0];
  const double lx = double(reading.illuminance_lx);
  ASSERT_GT(reading.standard_error_lx, 0);
  ASSERT_LT(reading.standard_error_lx, 0.001 * lx);
  std::vector<Sensor> cameras;
  for (const ups_projection p : projections)
    if (p != UPS_PERSPECTIVE) cameras.push_back(scene.add_camera(place, ahead, side, side, 1.2, false, p));
  for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING}) {
    const Result result = scene.render({.method = method, .iterations = method == UPS_METHOD_PATH_TRACING ? 128u : 112u});
    for (size_t c = 1; c <= cameras.size(); ++c) {
      const Mean sum = lux_of(result.image(cameras[c - 1]), side, projections[c]);
      expect_within(sum.value, sum.standard_error, lx, 0.006, 0.0013, method_name(method) + std::string(", ") + names[c]);
    }
  }
}

}  // namespace
}  // namespace ups::test
