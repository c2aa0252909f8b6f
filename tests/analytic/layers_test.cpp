// What a camera sees first, in closed form: albedo, normal, depth and number of the surface; means over a pixel; panes
// and mirrors are surfaces like any other.
#include <vector>

#include "../support/expect_lx.h"
#include "../support/image_mean.h"

namespace ups::test {
namespace {

constexpr uint32_t all = UPS_LAYER_ALBEDO | UPS_LAYER_NORMAL | UPS_LAYER_DEPTH | UPS_LAYER_ID;

// Seen from 2 m above through a window of 1 m: a floor of albedo 0.2 on the left, a mirror of 0.9 one metre higher on
// its right, and beyond them nothing. A camera of 8 x 8 pixels, 0.25 m of floor each.
struct Steps : testing::Test {
  Scene scene;
  Sensor camera;
  Steps() {
    scene.add(quad({-1, -1, 0}, {1, 0, 0}, {0, 1.5, 0}), matte(0.2));
    scene.add(quad({0, -0.5, 1}, {0.5, 0, 0}, {0, 1, 0}), mirror(0.9));
    scene.add_point_light({0, 0, 1.9}, 100);
    camera = scene.add_camera({0, 0, 2}, {0, 0, -1}, 8, 8, 2 * std::atan(0.5), false, UPS_PERSPECTIVE, all);
  }
};

// Along the rays of a pixel, to a plane so far below the camera: 16 x 16 points.
double mean_distance(uint32_t x, uint32_t y, double below) {
  double sum = 0;
  for (int i = 0; i < 256; ++i) {
    const double u = ((x + (i % 16 + 0.5) / 16) / 4 - 1) / 2, v = ((y + (i / 16 + 0.5) / 16) / 4 - 1) / 2;
    sum += below * std::sqrt(1 + u * u + v * v);
  }
  return sum / 256;
}

TEST_F(Steps, AreSeenByEveryMethod) {
  for (const ups_method method : {UPS_METHOD_PATH_TRACING, UPS_METHOD_UPS, UPS_METHOD_LIGHT_TRACING}) {
    const Result r = scene.render({.method = method, .iterations = 32});
    const auto albedo = r.read(camera, UPS_CHANNEL_ALBEDO_RGB, 3), normal = r.read(camera, UPS_CHANNEL_NORMAL, 3),
               depth = r.read(camera, UPS_CHANNEL_DEPTH, 1), id = r.read(camera, UPS_CHANNEL_ID, 1);
    const auto at = [](uint32_t x, uint32_t y) { return y * 8 + x; };
    const uint32_t floor = at(1, 5), mirror_pixel = at(5, 4), nothing = at(1, 0);
    EXPECT_NEAR(albedo[3 * floor], 0.2, 1e-6) << method_name(method);
    EXPECT_NEAR(albedo[3 * mirror_pixel + 1], 0.9, 1e-6);
    EXPECT_EQ(id[floor], 1);
    EXPECT_EQ(id[mirror_pixel], 2);
    EXPECT_EQ(normal[3 * floor + 2], 1);
    EXPECT_EQ(normal[3 * mirror_pixel + 2], 1);
    // Depths spread by 0.025 m over a pixel: 4 standard deviations of 32 samples. Along the axis it would be 0.13 less.
    EXPECT_NEAR(depth[floor], mean_distance(1, 5, 2), 0.018);
    EXPECT_NEAR(depth[mirror_pixel], mean_distance(5, 4, 1), 0.018);
    EXPECT_EQ(albedo[3 * nothing], 0);
    EXPECT_EQ(normal[3 * nothing + 2], 0);
    EXPECT_EQ(depth[nothing], -1);
    EXPECT_EQ(id[nothing], 0);
  }
}

// An edge through the middle of pixels: the mean of 0.1 and 0.7 by area, 0.4; and half of a pixel beyond the edge of all
// surfaces counts what was met alone. 256 stratified samples: a row within 0.02 by more than 4 standard deviations; the
// mean of 8 rows by expect_lx.h, which finds 1 % in 95 cases of 100 (P(|t_7| > 4) = 0.5 % where noise decides).
TEST(Layers, MeansOverPixels) {
  Scene scene;
  scene.add(quad({-2, -2, 0}, {2.125, 0, 0}, {0, 4, 0}), matte(0.1));
  scene.add(quad({0.125, -2, 0}, {0.5, 0, 0}, {0, 4, 0}), matte(0.7));
  scene.add_point_light({0, 0, 1.9}, 100);
  const Sensor camera =
      scene.add_camera({0, 0, 2}, {0, 0, -1}, 8, 8, 2 * std::atan(0.5), false, UPS_PERSPECTIVE, UPS_LAYER_ALBEDO);
  const auto albedo = scene.render({.iterations = 256}).read(camera, UPS_CHANNEL_ALBEDO_RGB, 3);
  std::vector<double> rows;
  for (uint32_t y = 0; y < 8; ++y) {
    rows.push_back(double(albedo[3 * (8 * y + 4)]));
    EXPECT_NEAR(rows.back(), 0.4, 0.02) << y;
    EXPECT_NEAR(albedo[3 * (8 * y + 6)], 0.7, 1e-6) << y;
  }
  const Mean mean = mean_of(rows);
  expect_lx(mean.value, mean.standard_error, 0.4, quiet, "albedo of an edge");
}

// The layers cost nothing where they are not asked for, and change no bit of what there is beside them.
TEST_F(Steps, ChangeNothingElse) {
  const Sensor plain = scene.add_camera({0.3, 0, 2}, {0, 0, -1}, 8, 8, 2 * std::atan(0.5));
  const Result with = scene.render({.iterations = 16});
  EXPECT_THROW(with.read(plain, UPS_CHANNEL_DEPTH, 1), std::runtime_error);
  EXPECT_NE(std::string(ups_last_error()).find("UPS_LAYER_DEPTH"), std::string::npos);
  Scene other;
  other.add(quad({-1, -1, 0}, {1, 0, 0}, {0, 1.5, 0}), matte(0.2));
  other.add(quad({0, -0.5, 1}, {0.5, 0, 0}, {0, 1, 0}), mirror(0.9));
  other.add_point_light({0, 0, 1.9}, 100);
  const Sensor first = other.add_camera({0, 0, 2}, {0, 0, -1}, 8, 8, 2 * std::atan(0.5)),
               second = other.add_camera({0.3, 0, 2}, {0, 0, -1}, 8, 8, 2 * std::atan(0.5));
  const Result without = other.render({.iterations = 16});
  EXPECT_EQ(with.image(camera).luminance, without.image(first).luminance);
  EXPECT_EQ(with.image(plain).luminance, without.image(second).luminance);
  EXPECT_EQ(with.info().rays, without.info().rays);
}

}  // namespace
}  // namespace ups::test
