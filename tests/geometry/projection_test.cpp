// Fisheyes and the panorama: rays and pixels are inverse, the density of a pixel's rays is one over its solid angle,
// all pixels together see the half space or all of space, and well-known directions lie where they belong.
#include <gtest/gtest.h>

#include <random>

#include "pixel_density.h"

namespace ups {
namespace {

constexpr Projection wide[] = {Projection::equidistant, Projection::equisolid, Projection::panorama};

// Looks along +x, +z up.
Camera camera_of(Projection p, uint32_t width, uint32_t height) {
  Affine m;
  const double frame[12] = {0, 0, -1, 3, -1, 0, 0, 4, 0, 1, 0, 5};
  std::copy(std::begin(frame), std::end(frame), m.m);
  return Camera(m, width, height, 0, false, p);
}

TEST(Projection, RayAndPixelAreInverse) {
  for (const Projection p : wide)
    for (const auto& [width, height] : {std::pair<uint32_t, uint32_t>{200, 100}, {64, 64}, {31, 90}, {4001, 3}}) {
      const Camera camera = camera_of(p, width, height);
      std::mt19937 rng(1);
      std::uniform_real_distribution<float> uniform(0.002f, 0.998f);
      uint32_t rays = 0;
      for (uint32_t y = 0; y < height; ++y)
        for (uint32_t x = 0; x < width; ++x) {
          const auto d = camera.ray(x, y, {uniform(rng), uniform(rng)});
          if (!d) continue;
          ++rays;
          EXPECT_NEAR(length(*d), 1, 1e-6f);
          const auto pixel = camera.pixel_of(*d);
          ASSERT_TRUE(pixel.has_value()) << int(p) << ": " << x << ", " << y;
          EXPECT_EQ(*pixel, y * width + x) << int(p);
          EXPECT_GT(camera.pdf_w(*d), 0);
        }
      EXPECT_GT(rays, width * height / 3 > height * height ? height * height / 3 : width * height / 3);
    }
}

TEST(Projection, EveryDirectionThatIsSeenHasItsRay) {
  std::mt19937 rng(2);
  std::normal_distribution<float> normal;
  for (const Projection p : wide) {
    const Camera camera = camera_of(p, 128, 128);
    for (int i = 0; i < 20000; ++i) {
      const Vec3 d = normalize(Vec3(normal(rng), normal(rng), normal(rng)));
      const bool seen = p == Projection::panorama || dot(d, camera.forward()) >= 0;
      if (std::abs(dot(d, camera.forward())) < 1e-6f) continue;
      const auto pixel = camera.pixel_of(d);
      ASSERT_EQ(pixel.has_value(), seen);
      EXPECT_EQ(camera.pdf_w(d) > 0, seen);
      if (!seen) continue;
      ASSERT_TRUE(camera.sees(*pixel % 128, *pixel / 128));
      const auto middle = camera.ray(*pixel % 128, *pixel / 128, {0.5f, 0.5f});  // none: on the rim
      if (middle && (p != Projection::panorama || std::abs(d.z) < 0.9f)) {
        EXPECT_GT(dot(*middle, d), 0.998f);
      }
    }
  }
}

// By the pole of a panorama cells are long: more of them.
TEST(Projection, DensityIntegratesToOneOverAPixel) {
  for (const Projection p : wide) {
    const Camera camera = camera_of(p, 12, 12);
    for (const auto& [px, py] : {std::pair<uint32_t, uint32_t>{6, 5}, {3, 4}, {10, 6}, {4, 1}})
      EXPECT_NEAR(density_over_pixel(camera, px, py, 128), 1, 1e-3) << int(p) << ", pixel " << px << ", " << py;
  }
}

TEST(Projection, AllPixelsTogetherSeeTheHalfSpaceOrAllOfIt) {
  for (const Projection p : wide) {
    const uint32_t width = 60, height = 40;
    const Camera camera = camera_of(p, width, height);
    double solid_angle = 0, seen = 0;
    const int n = 16;
    for (uint32_t y = 0; y < height; ++y)
      for (uint32_t x = 0; x < width; ++x) {
        int rays = 0;
        for (int i = 0; i < n * n; ++i) {
          const auto d = camera.ray(x, y, {(float(i % n) + 0.5f) / n, (float(i / n) + 0.5f) / n});
          if (d) ++rays, solid_angle += 1 / (double(camera.pdf_w(*d)) * n * n);
        }
        seen += double(rays) / (n * n);
        EXPECT_TRUE(rays == 0 || camera.sees(x, y));
      }
    const double all = p == Projection::panorama ? 4 * pi_d : 2 * pi_d;
    EXPECT_NEAR(solid_angle, all, 1e-3 * all) << int(p);
    EXPECT_NEAR(seen, p == Projection::panorama ? width * height : pi_d * 20 * 20, 1e-3 * seen) << int(p);
  }
}

// Angles from the axis along the middle row, and the axes of the panorama.
TEST(Projection, DirectionsLieWhereTheyBelong) {
  const uint32_t side = 1000;
  const auto column = [&](const Camera& camera, double degrees) {
    const double a = degrees / 180 * pi_d;
    const auto pixel = camera.pixel_of(Vec3(Vec3d(std::cos(a), -std::sin(a), 1e-5)));  // right is -y
    return pixel ? int(*pixel % side) : -1;
  };
  const Camera equidistant = camera_of(Projection::equidistant, side, side),
               equisolid = camera_of(Projection::equisolid, side, side);
  EXPECT_NEAR(column(equidistant, 45), 750, 1);
  EXPECT_NEAR(column(equidistant, -81), 50, 1);
  EXPECT_NEAR(column(equisolid, 60), 500 + 353.55, 1);
  EXPECT_EQ(column(equisolid, 90.1), -1);
  EXPECT_EQ(column(equidistant, 180), -1);

  const Camera panorama = camera_of(Projection::panorama, 400, 200);
  const auto at = [&](const Vec3& d) { return std::pair(*panorama.pixel_of(d) % 400, *panorama.pixel_of(d) / 400); };
  EXPECT_EQ(at(normalize(Vec3(1, -1e-3f, -1e-3f))), std::pair(200u, 100u));  // the axis
  EXPECT_EQ(at(normalize(Vec3(-1e-3f, -1, -1e-3f))), std::pair(300u, 100u));  // to its right
  EXPECT_EQ(at(normalize(Vec3(-1, 1e-3f, -1e-3f))), std::pair(0u, 100u));     // behind it
  EXPECT_EQ(at(Vec3(0, 0, 1)).second, 0u);
  EXPECT_EQ(at(Vec3(0, 0, -1)).second, 199u);
}

}  // namespace
}  // namespace ups
