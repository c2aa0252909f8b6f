// What walks do where the shading normal leans away from the surface's own, by hand.
#include <gtest/gtest.h>

#include "transport/walk.h"

namespace ups {
namespace {

SurfacePoint leaning() {
  SurfacePoint s;
  s.ng = {0, 0, 1};
  s.shading = Frame(Vec3(0.6f, 0, 0.8f));
  return s;
}

TEST(Shading, BothNormalsAgreeOnTheSide) {
  const SurfacePoint s = leaning();
  const auto agree = [&](const Vec3& w) { return consistent_side(s, normalize(w), s.shading.to_local(normalize(w))); };
  EXPECT_TRUE(agree({0, 0, 1}) && agree({0, 0, -1}) && agree({1, 0, 0.1f}));
  EXPECT_FALSE(agree({-0.9f, 0, 0.2f}));  // above the surface, behind the shading normal
  EXPECT_FALSE(agree({0.9f, 0, -0.2f}));
  EXPECT_FALSE(agree({1, 0, 1e-7f}));  // grazes
}

// Chiang, Li, Burley 2019: with g = cos n_g / (cos n_s cos between), 1 above one, else g + g^2 - g^3.
TEST(Shading, TerminatorFadesOutWithoutAStep) {
  const SurfacePoint s = leaning();
  const double g = 0.6 / (0.96 * 0.8);
  EXPECT_NEAR(terminator(s, {0.8f, 0, 0.6f}), g + g * g - g * g * g, 1e-6);
  EXPECT_EQ(terminator(s, {-0.6f, 0, 0.8f}), 1);
  EXPECT_NEAR(terminator(s, normalize(Vec3(1, 0, 1e-4f))), 0, 3e-4);
}

// Veach 1997, Eq. 5.19: |wi n_s| |wo n_g| / (|wi n_g| |wo n_s|).
TEST(Shading, CorrectionOfTheLightWalkIsVeachs) {
  EXPECT_NEAR(shading_correction(leaning(), {0.8f, 0, 0.6f}, {0, 0, 1}), 0.96 * 1 / (0.6 * 0.8), 1e-6);
}

}  // namespace
}  // namespace ups
