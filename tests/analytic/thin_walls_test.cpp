// A meter close to a thin wall must not gather the photons that land beyond it. Two rooms with 5 mm of wall between them:
// a bright one with a mirror, so that photons are merged, and a black one, where a weak lamp alone lights the meter, by
// next-event estimation without chance. Any photon from the bright room, of some 10 lx, would show.
#include "../support/expect_lx.h"

namespace ups::test {
namespace {

class ThinWall : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Distances, ThinWall, ::testing::Values(0.001, 0.01, 0.02, 0.2),
                         [](const auto& i) { return std::to_string(int(1000 * i.param)) + "mm"; });

TEST_P(ThinWall, LeavesLightBeyondItOut) {
  constexpr double wall = 0.005;
  const P3 lamp{-8, 8, 2.5};
  Scene scene;
  scene.add(box({-10, 0, 0}, {-wall, 10, 3}).flipped(), matte(0));
  scene.add(box({0, 0, 0}, {10, 10, 3}).flipped(), matte(0.5));
  scene.add(quad({0, 4, 2.9}, {0, 2, 0}, {1, 0, 0}), mirror(0.9));
  scene.add_point_light({0.5, 5, 0.3}, 1000);
  scene.add_point_light(lamp, 1);
  const P3 p{-wall - GetParam(), 5, 0.75};
  const Sensor dark = scene.add_meters({p}, {0, 0, 1}), bright = scene.add_meters({{0.02, 5, 0.75}}, {0, 0, 1});
  const Result result = scene.render({.method = UPS_METHOD_UPS, .iterations = 16, .light_paths = 1u << 13});
  const P3 to = lamp - p;
  const double truth = to.z / std::pow(dot(to, to), 1.5);
  EXPECT_NEAR(result.readings(dark)[0].illuminance_lx, truth, 1e-5 * truth);
  EXPECT_GT(result.readings(bright)[0].indirect_lx, 5) << "there is nothing to leak";
}

}  // namespace
}  // namespace ups::test
