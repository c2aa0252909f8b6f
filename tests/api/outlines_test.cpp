// What lies beneath a plane, as a plan shows it.
#include <gtest/gtest.h>

#include <string>

#include "../support/scene_builder.h"

namespace ups::test {
namespace {

std::vector<ups_segment> outlines(const Scene& scene, const P3& point, const P3& normal, double depth = INFINITY) {
  const double p[] = {point.x, point.y, point.z}, n[] = {normal.x, normal.y, normal.z};
  size_t count = 0;
  check(ups_scene_read_outlines(scene.get(), p, n, depth, nullptr, 0, &count), "ups_scene_read_outlines");
  std::vector<ups_segment> out(count);
  check(ups_scene_read_outlines(scene.get(), p, n, depth, out.data(), count, &count), "ups_scene_read_outlines");
  return out;
}

// Of those at this height.
double length_at(const std::vector<ups_segment>& all, double z) {
  double sum = 0;
  for (const ups_segment& s : all)
    if (std::abs(s.from_m[2] - z) < 1e-3)
      sum += length(P3{s.to_m[0], s.to_m[1], s.to_m[2]} - P3{s.from_m[0], s.from_m[1], s.from_m[2]});
  return sum;
}

TEST(Outlines, OfATableHideWhatIsBelowIt) {
  for (const double far : {0.0, 1e5}) {
    Scene scene;
    scene.add(box({0, 0, 0}, {4, 3, 2.5}), matte(0.5), {far, 0, 0});
    scene.add(box({1, 1, 0.7}, {2.5, 1.8, 0.72}), matte(0.5), {far, 0, 0});
    scene.add(box({1.2, 1.2, 0.1}, {1.6, 1.5, 0.4}), matte(0.5), {far, 0, 0});   // beneath the table
    scene.add(box({2.2, 1.2, 0.1}, {2.8, 1.5, 0.4}), matte(0.5), {far, 0, 0});   // half of it
    scene.add(box({0.1, 0.1, 1.9}, {3.9, 2.9, 2.0}), matte(0.5), {far, 0, 0});   // above the plane: no matter
    check(ups_scene_commit(scene.get()), "ups_scene_commit");
    const auto seen = outlines(scene, {far, 0, 1}, {0, 0, 3});
    EXPECT_NEAR(length_at(seen, 0.72), 4.6, 1e-3);
    // Of the second thing what stands out by 0.3 m on both sides and its end; pieces of an edge are a 200th of the room.
    EXPECT_NEAR(length_at(seen, 0.4), 0.3 + 2 * 0.3, 0.03);
    for (const ups_segment& s : seen) EXPECT_LT(s.from_m[2], 1) << "of what is above the plane";
    EXPECT_NEAR(length_at(outlines(scene, {far, 0, 1}, {0, 0, 1}, 0.5), 0.72), 4.6, 1e-3);
    EXPECT_EQ(length_at(outlines(scene, {far, 0, 1}, {0, 0, 1}, 0.5), 0.4), 0);
  }
}

TEST(Outlines, OfABallAreItsRim) {
  Scene scene;
  scene.add(icosphere({1, 1, 1}, 0.5, 4), matte(0.5));
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  double flat = 0;  // the rim zigzags up and down from facet to facet
  for (const ups_segment& s : outlines(scene, {0, 0, 2}, {0, 0, 1})) {
    flat += std::hypot(s.to_m[0] - s.from_m[0], s.to_m[1] - s.from_m[1]);
    EXPECT_NEAR(std::hypot(s.to_m[0] - 1, s.to_m[1] - 1), 0.5, 0.01);
  }
  EXPECT_NEAR(flat, pi_d, 0.03 * pi_d);
}

TEST(Outlines, SayWhatIsWrong) {
  Scene scene;
  scene.add(box({0, 0, 0}, {1, 1, 1}), matte(0.5));
  const double p[] = {0, 0, 2}, up[] = {0, 0, 1}, zero[] = {0, 0, 0};
  size_t count = 0;
  const auto read = [&](const double* point, const double* normal, double depth) {
    return ups_scene_read_outlines(scene.get(), point, normal, depth, nullptr, 0, &count);
  };
  EXPECT_EQ(read(p, up, 1), UPS_ERROR_INVALID_STATE);
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  EXPECT_EQ(read(p, zero, 1), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(read(nullptr, up, 1), UPS_ERROR_INVALID_ARGUMENT);
  for (const double depth : {0.0, -1.0, double(NAN)}) {
    EXPECT_EQ(read(p, up, depth), UPS_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(ups_last_error()).find("depth_m"), std::string::npos);
  }
  EXPECT_EQ(read(p, up, INFINITY), UPS_OK);
  EXPECT_EQ(count, 8u);  // the lower rim is seen too, just past the upper one
}

}  // namespace
}  // namespace ups::test
