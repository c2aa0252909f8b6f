// Faces that lie in one plane: floors given twice, sheets of two faces, emitters in the plane of a ceiling, luminaires
// that touch their housing.
#include <algorithm>
#include <cstring>

#include "../analytic/ies_text.h"
#include "../support/expect_lx.h"
#include "../support/scene_warnings.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

constexpr ups_method methods[] = {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING, UPS_METHOD_PPM};

enum class Floor { once, twice, twice_and_turned, other_diagonal };

struct Room {
  Scene scene;
  Sensor meters;
  explicit Room(Floor floor) {
    Shape walls = box({0, 0, 0}, {4, 3, 2.5}).flipped();
    walls.triangles.erase(walls.triangles.begin(), walls.triangles.begin() + 2);
    scene.add(walls, matte(0.6));
    const Shape once = quad({0, 0, 0}, {4, 0, 0}, {0, 3, 0});
    scene.add(once, matte(0.7));
    if (floor == Floor::twice) scene.add(once, matte(0.7));
    if (floor == Floor::twice_and_turned) scene.add(once.flipped(), matte(0.7));
    if (floor == Floor::other_diagonal) scene.add(quad({4, 0, 0}, {0, 3, 0}, {-4, 0, 0}), matte(0.7));
    scene.add_point_light({1.5, 1.2, 1.8}, 100);
    std::vector<P3> at;
    for (int i = 0; i < 16; ++i) at.push_back({0.5 + i % 4, 0.4 + 0.7 * (i / 4), i % 2 ? 0.0 : 0.8});
    meters = scene.add_meters(at, {0, 0, 1});
  }
};

// From the same random numbers, so that there is no noise between them.
TEST(Hazard17, DoubledFloorsReadTheSameAndAreWarnedOf) {
  Room once(Floor::once);
  for (const Floor floor : {Floor::twice, Floor::twice_and_turned, Floor::other_diagonal}) {
    Room room(floor);
    const bool warned = scene_warnings(room.scene).find("2 triangles lie exactly on another") != std::string::npos;
    EXPECT_EQ(warned, floor != Floor::other_diagonal);  // which has other corners
    for (const ups_method method : methods) {
      const RenderOptions options{.method = method, .iterations = 4, .light_paths = 1u << 10};
      const auto a = once.scene.render(options).readings(once.meters),
                 b = room.scene.render(options).readings(room.meters);
      for (size_t i = 0; i < a.size(); ++i)
        expect_ratio(b[i].illuminance_lx, a[i].illuminance_lx, 1e-3,
                     method_name(method) + (", floor " + std::to_string(int(floor)) + ", meter " + std::to_string(i)));
    }
  }
}

// Two walls of 20,480 triangles each in one place, a light one and a dark one, enough for an index that several threads
// build: which of them a ray meets shows in every digit.
TEST(Hazard17, WhichOfTwoFacesIsMetDoesNotDependOnThreads) {
  const auto read = [](std::vector<double> walls, int threads) {
    Scene scene(threads);
    for (const double reflectance : walls) scene.add(icosphere({0, 0, 0}, 2, 5).flipped(), matte(reflectance));
    scene.add_point_light({0.3, 0.2, 0.4}, 100);
    const Sensor meters = scene.add_meters({{0.5, -0.5, 0}, {-1, 0.2, -0.3}}, {0, 0, 1});
    return scene.render({.iterations = 8, .light_paths = 1u << 12}).readings(meters);
  };
  const auto one = read({0.7, 0.2}, 1), light = read({0.7}, 1);
  for (const int threads : {2, 4}) {
    const auto several = read({0.7, 0.2}, threads);
    EXPECT_EQ(std::memcmp(one.data(), several.data(), one.size() * sizeof one[0]), 0) << threads << " threads";
  }
  const auto turned = read({0.2, 0.7}, 1);
  EXPECT_TRUE(one[0].indirect_lx != light[0].indirect_lx || turned[0].indirect_lx != light[0].indirect_lx)
      << "the dark wall is met";
}

// A sheet of two faces, white above and grey below. Which of them a ray meets is a matter of rounding: that is said,
// and what is read lies between what either would give.
TEST(Taught, CoplanarDoubleFacesAreWarnedOf) {
  const auto read = [](double first, double second, bool both, std::string* warnings) {
    Scene scene;
    scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte(first));
    if (both) scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}).flipped(), matte(second));
    scene.add_point_light({0.3, 0.2, 1}, 100);
    const Sensor meters = scene.add_meters({{0.4, -0.1, 0.5}}, {0, 0, -1});
    if (warnings) *warnings = scene_warnings(scene);
    return scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 64}).readings(meters)[0];
  };
  std::string warnings;
  const auto white = read(0.8, 0, false, nullptr), same = read(0.8, 0.8, true, nullptr),
             grey = read(0.2, 0, false, nullptr), mixed = read(0.8, 0.2, true, &warnings);
  EXPECT_NE(warnings.find("exactly on another"), std::string::npos) << warnings;
  expect_ratio(same.illuminance_lx, white.illuminance_lx, 1e-3, "the same material");
  EXPECT_LE(mixed.illuminance_lx, white.illuminance_lx * (1 + 1e-3));
  EXPECT_GE(mixed.illuminance_lx, grey.illuminance_lx * (1 - 1e-3));
}

// A rug that is drawn on the floor: triangles of other places and sizes in one plane. Which of both a ray meets is a
// matter of rounding, which is told; not of what stands on the floor, wound either way, of a rug of the floor's material,
// or of one that is moved up.
TEST(Taught, SurfacesInTheVeryPlaneOfAnotherAreWarnedOf) {
  const auto told = [](const Shape& thing, double reflectance, const P3& at, const P3& tilt) {
    Scene scene;
    const P3 n = normalize(tilt), s = normalize(cross({0, 1, 0}, n)), t = cross(n, s);
    const auto turned = [&](Shape shape) {
      for (P3& v : shape.vertices) v = s * v.x + t * v.y + n * v.z;
      return shape;
    };
    scene.add(turned(quad({-3, -2, 0}, {6, 0, 0}, {0, 4, 0})), matte(0.6), at);
    scene.add(turned(thing), matte(reflectance), at);
    scene.add_point_light(at + n * 2, 100);
    scene.add_meters({at + n}, n);
    return scene_warnings(scene).find(": in the very plane of another surface") != std::string::npos;
  };
  const auto rug = [](double height) { return quad({0.33, 0.21, height}, {0.7, 0, 0}, {0, 0.4, 0}); };
  for (const P3& at : {P3{0, 0, 0}, P3{713, -321, 12}})
    for (const P3& tilt : {P3{0, 0, 1}, P3{0.3, 0.2, 1}, P3{1, 0, 0}}) {
      EXPECT_TRUE(told(rug(0), 0.2, at, tilt));
      EXPECT_FALSE(told(rug(0), 0.6, at, tilt)) << "of the floor's material";
      EXPECT_FALSE(told(rug(0.002), 0.2, at, tilt)) << "2 mm up";
      EXPECT_FALSE(told(box({0.1, 0.1, 0}, {0.6, 0.5, 0.4}), 0.2, at, tilt)) << "stands on it";
      EXPECT_FALSE(told(box({0.1, 0.1, 0}, {0.6, 0.5, 0.4}).flipped(), 0.2, at, tilt)) << "stands on it, inside out";
    }
  const P3 up{0, 0, 1};
  // Two things that stand in one another on the floor have their lower faces in one plane, which the floor covers.
  for (const P3& at : {P3{0, 0, 0}, P3{713, -321, 12}})
    for (const size_t first : {0, 1, 2}) {
      const std::pair<Shape, double> things[] = {{quad({-3, -2, 0}, {6, 0, 0}, {0, 4, 0}), 0.6},
                                                 {box({0, 0, 0}, {0.6, 0.5, 0.4}), 0.2},
                                                 {box({0.1, 0.1, 0}, {0.3, 0.3, 0.8}), 0.4}};
      Scene scene;
      for (size_t i = 0; i < 3; ++i) {
        const auto& [shape, reflectance] = things[(first + i) % 3];
        scene.add(shape, matte(reflectance), at);
      }
      scene.add_point_light(at + P3{0, 0, 2}, 100);
      scene.add_meters({at + P3{1, 1, 0.5}}, up);
      EXPECT_EQ(scene_warnings(scene).find("in the very plane of another surface"), std::string::npos) << first;
    }
  const Shape room = box({-3, -2, 0}, {3, 2, 2.5}).flipped();
  EXPECT_TRUE(told(room, 0.2, {0, 0, 0}, up)) << "the floor of a room that has one already";
}

// A panel in the very plane of the ceiling, which goes on behind it: the form factor of the panel, by methods that hit
// emitters, choose them, and merge; 0.5 % is allowed and the noise at most 0.1 %: 0.9 % is found. Photons merged at
// points have bias: 0.7 % at a noise of at most 0.15 %, so that 1 % is found in 97 of 100 cases.
TEST(Taught, EmittersFlushWithSurfacesKeepTheirLight) {
  const double luminance = 1000, half = 0.6;
  for (const double z : {2.5, 2.503, 1e4 / 3}) {
    Scene scene;
    scene.add(quad({-3, -3, z}, {0, 6, 0}, {6, 0, 0}), matte(0));
    const Shape panel = quad({-half, -half, z}, {0, 2 * half, 0}, {2 * half, 0, 0});
    scene.add(panel, emitter(luminance));
    std::vector<P3> at;
    double expected = 0;
    for (int i = 0; i < 64; ++i) at.push_back({0.2 * (i % 8), 0.15 * (i / 8), z - 1});
    for (const P3& p : at) expected += luminance * polygon_irradiance_factor(panel.vertices, p, {0, 0, 1}) / 64;
    const Sensor meters = scene.add_meters(at, {0, 0, 1});
    for (const ups_method method : methods) {
      const auto s = scene.render({.method = method, .iterations = 32, .light_paths = 1u << 14}).statistics(meters);
      const std::string what = std::string(method_name(method)) + ", z " + std::to_string(z);
      if (method == UPS_METHOD_PPM)
        expect_within(s.mean_lx, s.mean_standard_error_lx, expected, 0.007, 0.0015, what);
      else
        expect_lx(s.mean_lx, s.mean_standard_error_lx, expected, 0.001, what);
    }
  }
}

// What emits to both sides has no side to be lifted to: up to a third of its light is lost (known limit), and that is
// told, and no more off that plane.
TEST(Taught, EmittersOfTwoSidesInAnothersPlaneAreWarnedOf) {
  for (const bool both_sides : {true, false})
    for (const double below : {0.0, 1e-3}) {
      Scene scene;
      scene.add(quad({-3, -3, 2.503}, {0, 6, 0}, {6, 0, 0}), matte(0.5));
      auto panel = emitter(1000);
      panel.emits_both_sides = both_sides;
      scene.add(quad({2.7, -0.3, 2.503 - below}, {0, 0.6, 0}, {0.6, 0, 0}), panel);
      const bool warned = scene_warnings(scene).find("emits to both sides, and lies in the plane") != std::string::npos;
      EXPECT_EQ(warned, both_sides && below == 0) << both_sides << ", " << below;
    }
}

// A luminaire whose luminous disc lies in the plane of its housing's bottom, 0 or 1 mm below it, or in an open housing:
// I / (d^2 + r^2) on its axis, at a standard error of 0.1 % (expect_lx.h: 0.9 % is found in all of 1000 cases). In a closed
// one it lights nothing, which is said.
TEST(Taught, ALuminaireInsideItsOwnHousing) {
  const double intensity = 100, radius = 0.1, d = 1.5, expected = intensity / (d * d + radius * radius);
  const std::string ies = ies_text([=](double gamma) { return intensity * std::cos(gamma); }, 90, 2 * radius);
  const double w = 0.12;
  Shape shell = box({-w, -w, 2}, {w, w, 2.1}), open = shell;
  open.triangles.erase(open.triangles.begin(), open.triangles.begin() + 2);  // without its bottom
  struct Case {
    const char* name;
    Shape housing;
    double z;
    bool lit;
  };
  for (const Case& c : {Case{"flush", shell, 2, true},
                        {"1 mm below", shell, 1.999, true},
                        {"open", open, 2.02, true},
                        {"on the rim of an open one", open, 2, true},
                        {"closed", shell, 2.05, false}}) {
    Scene scene;
    const Profile profile = parse(scene.context(), ies);
    scene.add(c.housing, matte(0));
    scene.add_luminaire(profile.get(), {0, 0, c.z}, {0, 0, -1}, true);
    const Sensor meters = scene.add_meters({{0, 0, c.z - d}}, {0, 0, 1});
    const bool warned = scene_warnings(scene).find("swallowed at once") != std::string::npos;
    EXPECT_EQ(warned, !c.lit) << c.name;
    for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING}) {
      const auto r = scene.render({.method = method, .iterations = 256, .light_paths = 1024}).readings(meters)[0];
      const std::string what = std::string(c.name) + ", " + method_name(method);
      if (c.lit)
        expect_lx(r, expected, 0.001, what);
      else
        EXPECT_EQ(r.illuminance_lx, 0) << what;
    }
  }
}

}  // namespace
}  // namespace ups::test
