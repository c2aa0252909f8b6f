// Does UPS_METHOD_AUTO measure the same light as UPS with every technique? Three small rooms: an office of matte
// surfaces, the same with a picture glass, a room with a mirror; and an office that a later edit gives a mirror.
//
// Equivalent: two one-sided t tests (Schuirmann 1987) show that the means over the meters differ by less than 1 %. Each
// mean has a standard error of at most 0.1 % (asserted), their difference one of at most 0.14 %. With t > 2.25 in each
// of four scenes, P(t_30 > 2.25) = 1.6 %, the chance to call even one pair equivalent that differs by 1 % or more is
// at most 7 % (Bonferroni). Methods that differ by 0.2 % fail with probability P(t_30 > 0.8 / 0.14 - 2.25) = 0.1 % a
// scene. Seeds are fixed: a test that passes once passes always.
#include "../support/expect_lx.h"

namespace ups::test {
namespace {

constexpr double margin = 0.01, largest_error = 0.001, one_sided_t = 2.25;
constexpr double length_m = 5, width_m = 4, height_m = 2.8;
const Shape picture_glass = quad({2, 0.01, 1.1}, {0, 0, 0.8}, {0.8, 0, 0}),
            wall_mirror = quad({0.01, 3, 0.8}, {0, -1.5, 0}, {0, 0, 1.2});

ups_material_desc glazing() {
  auto d = material(UPS_MATERIAL_GLAZING, 1);
  d.transmittance_rgb[0] = d.transmittance_rgb[1] = d.transmittance_rgb[2] = 0.84f;
  return d;
}

// Matte, four spots of wide beam below the ceiling; 12 meters on the work plane.
class Office : public ::testing::Test {
 protected:
  void SetUp() override {
    scene.add(box({0, 0, 0}, {length_m, width_m, height_m}).flipped(), matte(0.5));
    scene.add(box({1.2, 1.4, 0}, {2.8, 2.2, 0.7}), matte(0.4));
    for (double x : {1.25, 3.75})
      for (double y : {1.0, 3.0}) scene.add_spot({x, y, height_m - 0.01}, {0, 0, -1}, 1000, 0.6, 1.3);
    std::vector<P3> points;
    for (int i = 0; i < 12; ++i)
      points.push_back({(i % 4 + 0.5) * length_m / 4, (double(i / 4) + 0.5) * width_m / 3, 0.75});
    meters = scene.add_meters(points, {0, 0, 1});
  }

  void expect_equivalent() {
    const auto automatic = mean_of(UPS_METHOD_AUTO), full = mean_of(UPS_METHOD_UPS);
    const double s = std::hypot(automatic.mean_standard_error_lx, full.mean_standard_error_lx);
    for (const auto& m : {automatic, full}) {
      EXPECT_GE(m.mean_standard_error_lx, 0);
      EXPECT_LE(m.mean_standard_error_lx, largest_error * m.mean_lx) << "too noisy to judge";
    }
    const double difference = automatic.mean_lx - full.mean_lx;
    EXPECT_GE(margin * full.mean_lx - std::abs(difference), one_sided_t * s)
        << automatic.mean_lx << " and " << full.mean_lx << " lx: " << std::showpos << 100 * difference / full.mean_lx
        << " % +- " << 100 * s / full.mean_lx << " %";
  }

  ups_meter_statistics mean_of(ups_method method) {
    // A seed each: the same techniques would give the same bits, and prove nothing.
    const uint64_t seed = method == UPS_METHOD_AUTO ? 1 : 2;
    return scene.render({.method = method, .iterations = 32, .seed = seed, .light_paths = 1u << 12}).statistics(meters);
  }

  Scene scene;
  Sensor meters;
};

TEST_F(Office, AutoIsEquivalentToAllTechniques) { expect_equivalent(); }

TEST_F(Office, AutoIsEquivalentToAllTechniquesBesideGlass) {
  scene.add(picture_glass, glazing());
  expect_equivalent();
}

TEST_F(Office, AutoIsEquivalentToAllTechniquesBesideAMirror) {
  scene.add(wall_mirror, mirror(0.9));
  expect_equivalent();
}

TEST_F(Office, AutoIsEquivalentToAllTechniquesBesideAMirrorOfPhotons) {
  scene.add(wall_mirror, photon_mirror(0.9));
  expect_equivalent();
}

// What path tracing cannot do, light of a spot by way of a mirror, is found in a flat one's image of it, and else a
// photon's: the choice is made again at a commit.
TEST_F(Office, GainsWhatAMirrorNeedsAtTheNextCommit) {
  const RenderOptions options{.method = UPS_METHOD_AUTO, .iterations = 16, .light_paths = 1u << 12};
  const ups_result_info before = scene.render(options).info();
  EXPECT_FALSE(before.techniques & (UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_MIRROR_SAMPLE));
  scene.add(wall_mirror, mirror(0.9));
  const ups_result_info flat = scene.render(options).info();
  EXPECT_TRUE(flat.techniques & UPS_TECHNIQUE_MIRROR_SAMPLE);
  EXPECT_FALSE(flat.techniques & UPS_TECHNIQUE_MERGE);
  scene.add(wall_mirror, photon_mirror(0.9), {4.9, 0, 0});
  const Result after = scene.render(options);
  EXPECT_TRUE(after.info().techniques & UPS_TECHNIQUE_MERGE);
  EXPECT_EQ(after.text(UPS_TEXT_WARNINGS).find("is missing"), std::string::npos) << after.text(UPS_TEXT_WARNINGS);
  EXPECT_GT(after.statistics(meters).mean_lx, 0);
}

}  // namespace
}  // namespace ups::test
