// Lobes from rough to smooth, light that grazes, chains of mirrors and of total reflection.
#include "torture.h"

namespace ups::test {
namespace {

// Metal, glass and plastic of one roughness in a room. 0: smooth.
class TortureRoughness : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Steps, TortureRoughness, ::testing::Values(1e-1, 1e-2, 1e-3, 1e-4, 1e-5, 0.0),
                         [](const auto& i) { return i.index < 5 ? "_1e" + std::to_string(i.index + 1) : "_smooth"; });

TEST_P(TortureRoughness, OfMetalGlassAndPlastic) {
  const double roughness = GetParam();
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 4, 3}).flipped(), matte(0.5));
  scene.add(quad({1, 1, 2.9}, {0, 2, 0}, {2, 0, 0}), emitter(1000));
  scene.add(icosphere({1, 1, 0.8}, 0.4, 2), glass(1.5, roughness));
  scene.add(box({2.6, 2.6, 0.1}, {3.4, 3.4, 0.9}), rough(UPS_MATERIAL_METAL, 0.9, roughness));
  scene.add(box({0.5, 2.5, 0.1}, {1.3, 3.3, 0.9}), rough(UPS_MATERIAL_PLASTIC, 0.6, roughness));
  const Sensor meters = scene.add_meters(grid_points({0.5, 0.5, 0.05}, {3, 0, 0}, {0, 3, 0}, 3), {0, 0, 1});
  add_small_camera(scene, {3.5, 0.5, 1.6}, {-1, 1, -0.4});
  survive("roughness " + std::to_string(roughness).substr(0, 7), scene, {{meters, 0.05}});
}

constexpr double grazing = 0.01 * pi_d / 180;  // above the surface

// What comes straight from the source, but to photons that land on the floor by chance.
void expect_direct(const std::string& name, Scene& scene, const Sensor& meters, double truth, double truth_error) {
  const std::vector<Result> results =
      survive(name, scene, {{meters}}, {.blind = {std::begin(torture_methods), std::end(torture_methods)}});
  for (size_t r = 0; r < results.size(); ++r) {
    if (torture_methods[r] == UPS_METHOD_SPPM) continue;
    EXPECT_NEAR(results[r].readings(meters)[0].direct_lx, truth, truth_error * truth)
        << name << ", " << method_name(torture_methods[r]);
  }
}

// A point on the floor, a lamp and the sun, both 0.01 degrees above it: I cos / d^2 and E cos. The lamp is 1.7 mm above
// the floor, which floats know within 3e-4 of it.
TEST(Torture, LightThatGrazesFloors) {
  const double distance = 10, height = distance * std::tan(grazing), d = std::hypot(distance, height);
  const auto plastic = rough(UPS_MATERIAL_PLASTIC, 0.5, 0.01), metal = rough(UPS_MATERIAL_METAL, 0.9, 0.01);
  for (const ups_material_desc& floor : {matte(0.5), plastic, metal, mirror(0.9), glass(1.5), glass(1.5, 0.1)}) {
    const std::string name = "grazing, floor " + std::to_string(floor.model);
    Scene scene;
    scene.add(box({-1, -2, -0.1}, {11, 2, 0}), floor);
    scene.add_point_light({distance, 0, height}, 1000);
    const Sensor meters = scene.add_meters({{0, 0, 0}}, {0, 0, 1});
    add_small_camera(scene, {-0.5, 0, 0.01}, {1, 0, -0.001});
    expect_direct(name + ", lamp", scene, meters, 1000 * height / (d * d * d), 1e-3);

    Scene sunny;
    sunny.add(box({-1, -2, -0.1}, {11, 2, 0}), floor);
    sunny.add_directional({-std::cos(grazing), 0, -std::sin(grazing)}, 1e5);
    const Sensor in_sun = sunny.add_meters({{0, 0, 0}}, {0, 0, 1});
    add_small_camera(sunny, {-0.5, 0, 0.01}, {1, 0, -0.001});
    expect_direct(name + ", sun", sunny, in_sun, 1e5 * std::sin(grazing), 1e-3);
  }
}

// Of a rod of glass, 10 mm by 10 mm by 1 m, between an emitter and cells: total reflection guides all that enters.
TEST(Torture, ALightGuideOfGlass) {
  Scene scene;
  scene.add(box({0, 0, 0}, {0.01, 0.01, 1}), glass(1.5));
  scene.add(quad({0, 0, -0.001}, {0.01, 0, 0}, {0, 0.01, 0}), emitter(1e6));
  const Sensor end = add_cells(scene, {0, 0, 1.001}, {0, 0.01, 0}, {0.01, 0, 0}, 4);
  add_small_camera(scene, {0.005, 0.005, 1.2}, {0, 0, -1});
  scene.add_goniometer(4, 19);
  survive("light guide of glass", scene, {{end, 0.05}});
}

// Of mirrors of 0.999, 50 mm by 50 mm by 1 m; and two of 4 m that face each other, 0.5 m apart.
TEST(Torture, MirrorsThatLoseAThousandth) {
  Scene duct;
  for (const Shape& side : {quad({0, 0, 0}, {0, 0.05, 0}, {0, 0, 1}), quad({0.05, 0, 0}, {0, 0, 1}, {0, 0.05, 0}),
                            quad({0, 0, 0}, {0, 0, 1}, {0.05, 0, 0}), quad({0, 0.05, 0}, {0.05, 0, 0}, {0, 0, 1})})
    duct.add(side, mirror(0.999));
  duct.add(quad({0, 0, 0}, {0.05, 0, 0}, {0, 0.05, 0}), emitter(1e4));
  const Sensor end = add_cells(duct, {0, 0, 1}, {0, 0.05, 0}, {0.05, 0, 0}, 4);
  add_small_camera(duct, {0.025, 0.025, 1.2}, {0, 0, -1});
  survive("duct of mirrors", duct, {{end, 0.1}});

  Scene facing_mirrors;
  facing_mirrors.add(quad({0, 0, 0}, {0, 4, 0}, {0, 0, 4}), mirror(0.999));
  facing_mirrors.add(quad({0.5, 0, 0}, {0, 0, 4}, {0, 4, 0}), mirror(0.999));
  facing_mirrors.add(quad({0.15, 1, 1}, {0, 2, 0}, {0, 0, 2}), emitter(1e4));
  const Sensor between = add_cells(facing_mirrors, {0.3, 0.2, 0.2}, {0, 0, 3.6}, {0, 3.6, 0}, 4);
  add_small_camera(facing_mirrors, {0.25, 0.5, 0.5}, {-1, 0.3, 0.3});
  survive("facing mirrors", facing_mirrors, {{between, 0.1}});
}

}  // namespace
}  // namespace ups::test
