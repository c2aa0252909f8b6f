// Light must not leak through thin walls: into discs of meters, into photons that are merged at what eye paths meet, or
// into cells. A wall of 5 mm runs through the room, which it shares with its floor, ceiling and side walls; lamp and
// mirror stand on one side. No chance is in it: whatever is not 0 on the dark side has leaked.
#include <algorithm>
#include <numeric>

#include "../support/expect_lx.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

constexpr double wall = 0.005, most = 1e-4;  // of what the lit side has

constexpr ups_method all_methods[] = {
    UPS_METHOD_AUTO,         UPS_METHOD_UPS,          UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING,
    UPS_METHOD_PPM,          UPS_METHOD_SPPM,         UPS_METHOD_BIDIRECTIONAL,
    UPS_METHOD_PATH_TRACING, UPS_METHOD_LIGHT_TRACING};

struct TwoRooms {
  Scene scene;
  Sensor dark_points, dark_cells, dark_camera, lit_points, lit_camera;

  TwoRooms() {
    scene.add(box({-4, 0, 0}, {4, 4, 3}).flipped(), matte(0.6));
    scene.add(box({-wall, -0.01, -0.01}, {0, 4.01, 3.01}), matte(0.6));
    scene.add(quad({0.5, 1, 2.9}, {0, 2, 0}, {2, 0, 0}), photon_mirror(0.9));
    scene.add_point_light({0.4, 2, 1}, 1000);
    std::vector<P3> at, n;
    for (const double d : {0.001, 0.01, 0.02, 0.2})
      for (const auto& [p, normal] : {std::pair(P3{-wall - d, 2, 0}, P3{0, 0, 1}),
                                      {{-wall - d, 2, 0.75}, {0, 0, 1}},
                                      {{-wall - d, 2, 3}, {0, 0, -1}},
                                      {{-wall - d, 2, 1}, {-1, 0, 0}},
                                      {{-wall - d, 2, 1}, {1, 0, 0}},
                                      {{-wall - d, 0, 1}, {0, 1, 0}}})
        at.push_back(p), n.push_back(normal);
    at.push_back({-wall, 2, 1}), n.push_back({-1, 0, 0});
    dark_points = scene.add_meters(at, n);
    dark_cells = scene.add_cells({{-wall - 0.021, 2, 0}, {-wall, 2, 1}}, {{0, 0, 1}, {-1, 0, 0}},
                                 {{1, 0, 0}, {0, 1, 0}}, 0.04, 0.04);
    lit_points = scene.add_meters({{0.02, 2, 0}, {0.02, 2, 0.75}}, {0, 0, 1});
    dark_camera = scene.add_camera({-0.3, 2, 0.3}, {0.25, 0, -0.3}, 24, 24, 1, true);
    lit_camera = scene.add_camera({0.3, 2, 0.3}, {-0.25, 0, -0.3}, 24, 24, 1, true);
  }
};

double brightest(const std::vector<ups_meter_reading>& all) {
  double most_lx = 0;
  for (const auto& r : all) most_lx = std::max(most_lx, double(r.illuminance_lx));
  return most_lx;
}
float brightest(const std::vector<float>& all) { return *std::max_element(all.begin(), all.end()); }
double mean(const std::vector<float>& v) { return std::accumulate(v.begin(), v.end(), 0.0) / double(v.size()); }

TEST(Hazard18, ThinWallsDoNotLeak) {
  TwoRooms rooms;
  for (const ups_method method : all_methods)
    for (const double radius : {0.0, 0.1}) {
      const Result r =
          rooms.scene.render({.method = method, .iterations = 1, .merge_radius_m = radius, .light_paths = 1u << 14});
      const std::string what = std::string(method_name(method)) + ", radius " + std::to_string(radius);
      const auto dark = r.readings(rooms.dark_points);
      const double lit = r.statistics(rooms.lit_points).mean_lx;
      EXPECT_GT(lit, 1) << what;
      for (size_t i = 0; i < dark.size(); ++i) EXPECT_LE(dark[i].illuminance_lx, most * lit) << what << ", meter " << i;
      EXPECT_LE(brightest(r.readings(rooms.dark_cells)), most * lit) << what << ", cells";
      const Image a = r.image(rooms.dark_camera), b = r.image(rooms.lit_camera);
      EXPECT_GT(mean(b.luminance), 0.1) << what;
      EXPECT_GT(mean(b.illuminance), 1) << what;
      measured("%s: meters %g of %g lx, pixels %g of %g cd/m2", what.c_str(), brightest(dark), lit,
               brightest(a.luminance), mean(b.luminance));
      EXPECT_LE(brightest(a.luminance), most * mean(b.luminance)) << what;
      EXPECT_LE(brightest(a.illuminance), most * mean(b.illuminance)) << what;
    }
}

// What path integration finds at vertices that are moved within the radius.
TEST(Hazard18, MovedVerticesStayOnTheirSideOfAThinWall) {
  TwoRooms rooms;
  const Result r = rooms.scene.render({.method = UPS_METHOD_BIDIRECTIONAL,
                                       .iterations = 1,
                                       .merge_radius_m = 0.1,
                                       .light_paths = 1u << 14,
                                       .perturbation = UPS_PERTURBATION_ACTUAL});
  const Image a = r.image(rooms.dark_camera), b = r.image(rooms.lit_camera);
  EXPECT_GT(mean(b.luminance), 0.1);
  EXPECT_LE(brightest(a.luminance), most * mean(b.luminance));
}

// Beside the wall a weak lamp alone lights the meters, by next-event estimation without chance: in a black room, with a
// bright one of some 10 lx beyond the wall. What leaked would show at 1e-5.
TEST(Hazard18, MetersBesideAThinWallHaveTheirOwnLightAlone) {
  const P3 lamp{-8, 8, 2.5};
  for (const double distance : {0.001, 0.01, 0.02, 0.2}) {
    Scene scene;
    scene.add(box({-10, 0, 0}, {-wall, 10, 3}).flipped(), matte(0));
    scene.add(box({0, 0, 0}, {10, 10, 3}).flipped(), matte(0.5));
    scene.add(quad({0, 4, 2.9}, {0, 2, 0}, {1, 0, 0}), photon_mirror(0.9));
    scene.add_point_light({0.5, 5, 0.3}, 1000);
    scene.add_point_light(lamp, 1);
    const P3 p{-wall - distance, 5, 0.75}, to = lamp - p;
    const Sensor dark = scene.add_meters({p}, {0, 0, 1}), bright = scene.add_meters({{0.02, 5, 0.75}}, {0, 0, 1});
    const Result result = scene.render({.method = UPS_METHOD_UPS, .iterations = 16, .light_paths = 1u << 13});
    const double truth = to.z / std::pow(dot(to, to), 1.5);
    expect_ratio(result.readings(dark)[0].illuminance_lx, truth, 1e-5, short_number(distance) + " m behind");
    EXPECT_GT(result.readings(bright)[0].indirect_lx, 5) << "there is nothing to leak";
  }
}

}  // namespace
}  // namespace ups::test
