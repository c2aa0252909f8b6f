// Where a plane cuts the surfaces of a scene.
#include <gtest/gtest.h>

#include <algorithm>
#include <string>

#include "../support/scene_builder.h"

namespace ups::test {
namespace {

std::vector<ups_segment> section(const Scene& scene, const P3& point, const P3& normal) {
  const double p[] = {point.x, point.y, point.z}, n[] = {normal.x, normal.y, normal.z};
  size_t count = 0;
  check(ups_scene_read_section(scene.get(), p, n, nullptr, 0, &count), "ups_scene_read_section");
  std::vector<ups_segment> out(count);
  check(ups_scene_read_section(scene.get(), p, n, out.data(), count, &count), "ups_scene_read_section");
  return out;
}

double length(const std::vector<ups_segment>& all) {
  double sum = 0;
  for (const ups_segment& s : all)
    sum += length(P3{s.to_m[0], s.to_m[1], s.to_m[2]} - P3{s.from_m[0], s.from_m[1], s.from_m[2]});
  return sum;
}

TEST(Section, OfABoxIsItsOutlineWhereverItStands) {
  for (const double far : {0.0, 1e5}) {
    Scene scene;
    scene.add(box({0, 0, 0}, {4, 3, 2.5}), matte(0.5), {far, 0, 0});
    check(ups_scene_commit(scene.get()), "ups_scene_commit");
    const auto plan = section(scene, {0, 0, 1}, {0, 0, 2});
    EXPECT_EQ(plan.size(), 8u);  // two triangles a wall
    EXPECT_NEAR(length(plan), 14, 1e-4);
    for (const ups_segment& s : plan) {
      EXPECT_NEAR(s.from_m[2], 1, 1e-6);
      EXPECT_TRUE(s.from_m[0] > far - 1e-3 && s.from_m[0] < far + 4.001) << s.from_m[0];
    }
    EXPECT_NEAR(length(section(scene, {far + 1, 0, 0}, {1, 0, 0})), 11, 1e-4);
    EXPECT_TRUE(section(scene, {0, 0, 3}, {0, 0, 1}).empty());
    // Each edge of a face that lies in the plane once, from the wall beside it.
    EXPECT_NEAR(length(section(scene, {0, 0, 0}, {0, 0, 1})), 14, 1e-4);
  }
}

TEST(Section, OfABallIsACircle) {
  Scene scene;
  scene.add(icosphere({1, 1, 1}, 0.5, 4), matte(0.5));
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  // The plane passes the centre at 0.1 / sqrt(1.05); chords of a fine polygon.
  EXPECT_NEAR(length(section(scene, {1, 1, 1.1}, {0.1, 0.2, 1})), 2 * pi_d * std::sqrt(0.25 - 0.01 / 1.05), 0.005);
}

TEST(Section, SaysWhatIsWrong) {
  Scene scene;
  scene.add(box({0, 0, 0}, {1, 1, 1}), matte(0.5));
  const double p[] = {0, 0, 0.5}, up[] = {0, 0, 1}, zero[] = {0, 0, 0}, bad[] = {0, NAN, 0};
  size_t count = 0;
  EXPECT_EQ(ups_scene_read_section(scene.get(), p, up, nullptr, 0, &count), UPS_ERROR_INVALID_STATE);
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  EXPECT_EQ(ups_scene_read_section(scene.get(), p, zero, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_scene_read_section(scene.get(), bad, up, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_scene_read_section(scene.get(), nullptr, up, nullptr, 0, &count), UPS_ERROR_INVALID_ARGUMENT);
  ups_segment one;
  EXPECT_EQ(ups_scene_read_section(scene.get(), p, up, &one, 1, &count), UPS_ERROR_BUFFER_TOO_SMALL);
  EXPECT_EQ(count, 8u);
}

}  // namespace
}  // namespace ups::test
