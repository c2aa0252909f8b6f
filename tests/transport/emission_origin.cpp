// Where light paths start: off the emitter's surface, on their own line, so that a small source keeps its size.
#include <gtest/gtest.h>

#include <cmath>

#include "transport/walk.h"

namespace ups {
namespace {

constexpr float error = 1e-5f;

Vec3 direction(float cosine, float azimuth) {
  const float s = std::sqrt(1 - cosine * cosine);
  return {s * std::cos(azimuth), s * std::sin(azimuth), cosine};
}

TEST(EmissionOrigin, IsAsHighAsTheSurfaceErrorAsksFor) {
  for (const float cosine : {1.0f, 0.7f, 0.25f, 0.2f, 0.01f, 1e-6f}) {
    const Vec3 o = emission_origin(Vec3(), Vec3(0, 0, 1), direction(cosine, 0.4f), error);
    EXPECT_NEAR(o.z, 2 * error, 1e-6f * error) << cosine;
    EXPECT_LE(length(o), 8.25f * error) << cosine;
  }
}

TEST(EmissionOrigin, LiesOnTheLineUnlessItGrazes) {
  for (const float cosine : {1.0f, 0.9f, 0.5f, 0.26f})
    for (const float azimuth : {0.0f, 1.0f, 4.0f}) {
      const Vec3 d = direction(cosine, azimuth);
      EXPECT_LT(length(cross(emission_origin(Vec3(), Vec3(0, 0, 1), d, error), d)), 1e-5f * error);
    }
}

TEST(EmissionOrigin, OfAPointIsThePoint) {
  const Vec3 p(1, 2, 3), o = emission_origin(p, Vec3(), Vec3(0, 0, 1), error);
  EXPECT_TRUE(o.x == p.x && o.y == p.y && o.z == p.z);
}

}  // namespace
}  // namespace ups
