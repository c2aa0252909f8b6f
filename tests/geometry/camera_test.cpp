// The camera's three functions against each other: a pixel's ray lands in that pixel, and the density of a pixel's rays
// integrates to 1 over its solid angle.
#include <gtest/gtest.h>

#include <random>

#include "pixel_density.h"

namespace ups {
namespace {

Affine looking(const Vec3d& back, const Vec3d& up, const Vec3d& p, double scale) {
  const Vec3d z = normalize(back), x = normalize(cross(up, z)), y = cross(z, x);
  Affine m;
  for (int r = 0; r < 3; ++r) {
    m.m[4 * r] = x[r] * scale;
    m.m[4 * r + 1] = y[r] * scale;
    m.m[4 * r + 2] = z[r] * scale;
    m.m[4 * r + 3] = p[r];
  }
  return m;
}

TEST(Camera, LooksAlongMinusZWithRowZeroOnTop) {
  const Camera camera(Affine(), 4, 2, 1.0f, false);
  EXPECT_EQ(camera.forward().z, -1);
  const Vec3 top_left = *camera.ray(0, 0, {0, 0});
  EXPECT_LT(top_left.x, 0);
  EXPECT_GT(top_left.y, 0);
  EXPECT_NEAR(top_left.y / -top_left.z, std::tan(0.5f), 1e-6f);
  EXPECT_NEAR(top_left.x / -top_left.z, -2 * std::tan(0.5f), 1e-6f);
}

TEST(Camera, RayAndPixelAreInverse) {
  const Camera camera(looking({1, 2, 0.5}, {0, 0, 1}, {5, 6, 7}, 3.5), 333, 77, 1.2f, false);
  std::mt19937 rng(1);
  std::uniform_real_distribution<float> uniform(0.001f, 0.999f);
  for (uint32_t y = 0; y < 77; y += 4)
    for (uint32_t x = 0; x < 333; x += 3) {
      const auto pixel = camera.pixel_of(*camera.ray(x, y, {uniform(rng), uniform(rng)}));
      ASSERT_TRUE(pixel.has_value());
      EXPECT_EQ(*pixel, y * 333 + x);
    }
  EXPECT_FALSE(camera.pixel_of(-camera.forward()).has_value());
  EXPECT_EQ(camera.pdf_w(-camera.forward()), 0);
}

TEST(Camera, NoPixelSeesWhatLiesBesideTheImage) {
  const Camera camera(Affine(), 40, 30, 1.0f, false);
  const float half = std::tan(0.5f), pixel = 2 * half / 30;
  const auto seen = [&](float x, float y) { return camera.pixel_of(normalize(Vec3(x, y, -1))).has_value(); };
  const float right = 20 * pixel, top = 15 * pixel, inside = 0.99f, outside = 0.5f;  // pixels
  EXPECT_TRUE(seen(-right + inside * pixel, 0) && seen(right - inside * pixel, 0));
  EXPECT_TRUE(seen(0, -top + inside * pixel) && seen(0, top - inside * pixel));
  EXPECT_FALSE(seen(-right - outside * pixel, 0));
  EXPECT_FALSE(seen(right + outside * pixel, 0));
  EXPECT_FALSE(seen(0, -top - outside * pixel));
  EXPECT_FALSE(seen(0, top + outside * pixel));
}

TEST(Camera, DensityIntegratesToOneOverAPixel) {
  const Camera camera(looking({0, -1, 0.2}, {0, 0, 1}, {0, 0, 0}, 1), 5, 3, 2.0f, false);
  for (const auto& [px, py] : {std::pair<uint32_t, uint32_t>{0, 0}, {2, 1}, {4, 2}})
    EXPECT_NEAR(density_over_pixel(camera, px, py, 64), 1, 1e-3);
}

TEST(Camera, IgnoresScaleAndSkew) {
  Affine skewed;  // y leans towards z, everything scaled by 7
  const double m[12] = {7, 0, 0, 1, 0, 7, 0, 2, 0, 3, 7, 3};
  std::copy(std::begin(m), std::end(m), skewed.m);
  const Camera camera(skewed, 10, 10, 1.0f, false),
      plain(looking({0, 0, 1}, {0, 1, 0}, {1, 2, 3}, 1), 10, 10, 1.0f, false);
  for (uint32_t i = 0; i < 10; ++i) {
    const Vec3 a = *camera.ray(i, 9 - i, {0.5f, 0.5f}), b = *plain.ray(i, 9 - i, {0.5f, 0.5f});
    EXPECT_LT(length(a - b), 1e-6f);
  }
}

}  // namespace
}  // namespace ups
