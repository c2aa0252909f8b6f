// Where Transform puts and turns things.
#include <cmath>

#include "room.h"

namespace {

using ups::Transform;
using ups::Vec3;

const double pi = std::acos(-1.0);

void expect_near(const Vec3 &have, const Vec3 &want) {
  for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(have[i], want[i], 1e-12) << "component " << i;
}

// Of a direction: without the place.
Vec3 turned(const Transform &t, const Vec3 &v) {
  const Vec3 tip = t(v), origin = t({0, 0, 0});
  return {tip[0] - origin[0], tip[1] - origin[1], tip[2] - origin[2]};
}

TEST(Transforms, LeaveMoveScaleAndTurn) {
  expect_near(Transform()({1, 2, 3}), {1, 2, 3});
  expect_near(Transform::translation(1, 2, 3)({4, 5, 6}), {5, 7, 9});
  expect_near(Transform::scale(1, 2, 3)({4, 5, 6}), {4, 10, 18});
  expect_near(Transform::rotation({0, 0, 2}, pi / 2)({1, 0, 3}), {0, 1, 3});
  expect_near(Transform::rotation({1, 0, 0}, pi / 2)({0, 1, 0}), {0, 0, 1});
  expect_near(Transform::rotation({0, 1, 0}, pi / 2)({0, 0, 1}), {1, 0, 0});
  expect_near(Transform::rotation({1, 1, 1}, 2 * pi / 3)({1, 0, 0}), {0, 1, 0});
}

TEST(Transforms, ProductTakesTheRightOneFirst) {
  const Transform turn = Transform::rotation({0, 0, 1}, pi / 2), move = Transform::translation(1, 0, 0.5);
  expect_near((turn * move)({1, 0, 0}), {0, 2, 0.5});
  expect_near((move * turn)({1, 0, 0}), {1, 1, 0.5});
  expect_near((turn * move * Transform::scale(2, 2, 2))({1, 1, 1}), turn(move({2, 2, 2})));
}

TEST(Transforms, LookAtHasTheTargetInFrontAndUpUp) {
  const Transform t = Transform::look_at({1, 2, 3}, {4, 2, 3});
  expect_near(t({0, 0, 0}), {1, 2, 3});
  expect_near(turned(t, {0, 0, -1}), {1, 0, 0});
  expect_near(turned(t, {0, 1, 0}), {0, 0, 1});
  expect_near(turned(t, {1, 0, 0}), {0, -1, 0});  // along +X the right is -Y
  const double s = std::sqrt(0.5);
  const Transform down = Transform::look_at({0, 0, 1}, {0, 1, 0});
  expect_near(turned(down, {0, 0, -1}), {0, s, -s});
  expect_near(turned(down, {0, 1, 0}), {0, s, s});
  expect_near(turned(Transform::look_at({0, 0, 5}, {0, 0, 0}, {0, 1, 0}), {0, 1, 0}), {0, 1, 0});
}

TEST(Transforms, AimTurnsTheNadirAndKeepsC0) {
  const Transform straight = Transform::aim({2, 1.5, 2.5}, {2, 1.5, 0});
  for (int i = 0; i < 12; ++i)
    EXPECT_NEAR(straight.data()[i], Transform::translation(2, 1.5, 2.5).data()[i], 1e-12) << "a luminaire that hangs";
  const double s = std::sqrt(0.5);
  const Transform tilted = Transform::aim({0, 0, 2}, {0, 2, 0});
  expect_near(turned(tilted, {0, 0, -1}), {0, s, -s});
  expect_near(turned(tilted, {1, 0, 0}), {1, 0, 0});
  expect_near(turned(Transform::aim({0, 0, 2}, {2, 0, 2}, {0, 0, 1}), {1, 0, 0}), {0, 0, 1});
}

TEST(Transforms, WithoutADirectionAreRefused) {
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"target - place"}, [] { Transform::look_at({1, 2, 3}, {1, 2, 3}); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"up", "another direction"},
               [] { Transform::look_at({0, 0, 1}, {0, 0, 0}); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"c0", "another direction"}, [] { Transform::aim({0, 0, 1}, {1, 0, 1}); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"axis"}, [] { Transform::rotation({0, 0, 0}, 1); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"target - place"},
               [] { Transform::aim({0, 0, std::nan("")}, {0, 0, 0}); });
}

TEST(Transforms, GoIntoDescsAndBack) {
  const Transform t = Transform::aim({1, 2, 3}, {4, 5, 0});
  double m[12];
  t.copy_to(m);
  for (int i = 0; i < 12; ++i) {
    EXPECT_EQ(m[i], t.data()[i]);
    EXPECT_EQ(Transform(m).data()[i], m[i]);
  }
}

}  // namespace
