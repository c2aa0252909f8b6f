// Scenes that are legal and hard: nothing absorbs light, nothing is reached by it, lengths are out of the ordinary.
//
// Seeds are fixed. What has noise is judged by means as in expect_lx.h, with its false alarms and what it finds: two of
// an image in a medium, two of an unfinished one, three of meters in the sun.
#include <algorithm>

#include "../support/expect_lx.h"
#include "../support/image_mean.h"

namespace ups::test {
namespace {

constexpr ups_method all_methods[] = {UPS_METHOD_AUTO,         UPS_METHOD_UPS,           UPS_METHOD_BIDIRECTIONAL,
                                      UPS_METHOD_PATH_TRACING, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_PPM};

// Light that can neither leave nor be absorbed would go round for ever: paths must end,
// and say nothing that is not finite.
void expect_to_end(const ups_material_desc& enclosure, const Shape& shape) {
  Scene scene;
  scene.add(shape, enclosure);
  scene.add_point_light({0.3, 0.1, 0.2}, 100);
  scene.add_cells({{0, 0, -0.5}}, {{0, 0, 1}}, {{1, 0, 0}}, 0.2, 0.2);
  scene.add_camera({-0.5, 0, 0}, {1, 0, 0}, 8, 8, 1);
  for (ups_method m : all_methods) {
    const Result r = scene.render({.method = m, .iterations = 2, .light_paths = 256});
    EXPECT_EQ(r.info().iterations, 2u) << method_name(m);
  }
}
TEST(LosslessEnclosure, OfClearGlassEnds) { expect_to_end(glass(1.5), box({-1, -1, -1}, {1, 1, 1})); }
TEST(LosslessEnclosure, OfMirrorsEnds) { expect_to_end(mirror(1), box({-1, -1, -1}, {1, 1, 1}).flipped()); }
TEST(LosslessEnclosure, OfWhiteWallsEnds) { expect_to_end(matte(1), box({-1, -1, -1}, {1, 1, 1}).flipped()); }

// A meter lies on its surface, however large that is: it is not measured off it by the rounding error of kilometres.
TEST(LargeFloor, DoesNotLiftItsMeters) {
  for (double half : {2.0, 200.0, 20000.0}) {
    Scene scene;
    scene.add(quad({-half, -half, 0}, {2 * half, 0, 0}, {0, 2 * half, 0}), matte(0.5));
    scene.add_point_light({0, 0, 2}, 100);
    const Sensor meters = scene.add_meters({P3{0, 0, 0}}, {0, 0, 1});
    const auto r = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 16}).readings(meters);
    EXPECT_NEAR(r[0].illuminance_lx, 25, 25 * 1e-3) << half;
  }
}

// A set that no light has reached is not known exactly: its error is unknown, and a warning says so.
TEST(DarkMeters, AreNotCalledExact) {
  Scene scene;
  scene.add(box({-0.1, -0.1, 1.9}, {0.1, 0.1, 2.1}), matte(0.5));  // shuts the light in
  scene.add_point_light({0, 0, 2}, 100);
  const Sensor meters = scene.add_meters({P3{0, 0, 0}, P3{1, 0, 0}}, {0, 0, 1});
  const Result r = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 32});
  EXPECT_EQ(r.readings(meters)[0].illuminance_lx, 0);
  EXPECT_EQ(r.statistics(meters).worst_relative_error_bound, -1);
  EXPECT_NE(r.text(UPS_TEXT_WARNINGS).find("no light has reached them"), std::string::npos)
      << r.text(UPS_TEXT_WARNINGS);
}

// Fewer iterations than an image has subsets of pixels: no pixel is black, the mean is right and a warning says it.
// A point light's light has no noise; between neighbours it differs by 0.1 %, so that a pixel is known to 0.5 %.
TEST(UnfinishedImage, ShowsNeighboursWhereNoPathWasTraced) {
  Scene scene;
  scene.add(quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}), matte(0.5));
  scene.add_point_light({0, 0, 3}, 100);
  const Sensor camera = scene.add_camera({0, 0, 2}, {0, 0, -1}, 512, 512, 0.5, true);  // 9 subsets
  const Result whole = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 9}),
               part = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 1});
  EXPECT_EQ(whole.text(UPS_TEXT_WARNINGS).find("neighbours"), std::string::npos);
  EXPECT_NE(part.text(UPS_TEXT_WARNINGS).find("neighbours"), std::string::npos);
  const Image a = whole.image(camera), b = part.image(camera);
  std::vector<double> luminance, illuminance;  // relative; of every 97th pixel: neighbours share their chance
  for (size_t p = 0; p < a.illuminance.size(); p += 97) {
    luminance.push_back(double(b.luminance[3 * p]) / double(a.luminance[3 * p]));
    illuminance.push_back(double(b.illuminance[p]) / double(a.illuminance[p]));
    EXPECT_NEAR(b.luminance[3 * p], a.luminance[3 * p], 0.005 * a.luminance[3 * p]) << p;
    EXPECT_NEAR(b.illuminance[p], a.illuminance[p], 0.005 * a.illuminance[p]) << p;
    EXPECT_EQ(b.standard_error[3 * p], -1) << p;
  }
  for (const Mean& m : {mean_of(luminance), mean_of(illuminance)})
    expect_lx(m.value, m.standard_error, 1, quiet, "part");
}

TEST(AbsurdFlux, IsRefused) {
  Scene scene;
  scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte(0.5));
  scene.add_point_light({0, 0, 2}, 2e37);
  scene.add_meters({P3{0, 0, 0}}, {0, 0, 1});
  EXPECT_THROW(scene.render({.iterations = 1}), std::runtime_error);
}

// Terabytes of image are refused, not left to the kernel, which would end the whole process.
TEST(AbsurdImages, AreRefused) {
  Scene scene;
  scene.add(quad({-1, -1, 0}, {2, 0, 0}, {0, 2, 0}), matte(0.5));
  for (int i = 0; i < 100; ++i) scene.add_camera({0, 0, 1}, {0, 0, -1}, 16384, 16384, 1);
  try {
    scene.render({.iterations = 1});
    FAIL() << "not refused";
  } catch (const std::runtime_error& e) {
    EXPECT_NE(std::string(e.what()).find("GB"), std::string::npos) << e.what();
  }
}

// The air before a camera in a block of glass is not what lies before the floor that it sees, and the other way round.
// 1 % for each of 64 pixels. Their spread is at most 0.4 %, so that a pixel that is off by 2 % is found in 99 cases of
// 100, and that of their mean 0.05 %: an error of 1 % of all is found for certain.
TEST(IlluminanceCamera, MeasuresInTheMediumThatItSees) {
  for (bool camera_inside : {true, false}) {
    Scene scene;
    ups_material_desc block = glass(1);  // no refraction, so that the closed form stays simple
    for (float& a : block.absorption_per_m_rgb) a = 1;
    const double side = 0.1;
    scene.add(quad({-3, -3, 0}, {6, 0, 0}, {0, 6, 0}), matte(0.5));
    if (camera_inside)
      scene.add(box({-side, -side, 1 - side}, {side, side, 1 + side}), block);
    else
      scene.add(box({-2, -2, -0.5}, {2, 2, 0.5}), block);  // floor and lamp stand in it, the camera above
    const P3 light{0.3, 0, 0.4};
    scene.add_point_light(light, 100);
    const Sensor camera = scene.add_camera({0, 0, 1}, {0, 0, -1}, 8, 8, 0.2, true);
    const Image image = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 64}).image(camera);
    std::vector<double> ratios;
    for (uint32_t y = 0; y < 8; ++y)
      for (uint32_t x = 0; x < 8; ++x) {
        const double half = std::tan(0.1);
        const P3 p{((x + 0.5) / 4 - 1) * half, (1 - (y + 0.5) / 4) * half, 0}, d = light - p;
        const double r = length(d), e = 100 * d.z / (r * r * r) * (camera_inside ? 1 : std::exp(-r));
        EXPECT_NEAR(image.illuminance[y * 8 + x], e, 0.01 * e) << camera_inside << ' ' << x << ' ' << y;
        ratios.push_back(double(image.illuminance[y * 8 + x]) / e);
      }
    const Mean mean = mean_of(ratios);
    expect_lx(mean.value, mean.standard_error, 1, 0.0005, camera_inside ? "camera inside" : "floor inside");
  }
}

// Meters at the rim of a scene that they alone make: photons of the sun land on all of their discs. The mean is judged
// to 1 %; one meter whose disc is cut would be off by tens of percent.
TEST(HardCases, SunOnMetersThatAreTheWholeScene) {
  Scene scene;
  std::vector<P3> grid;
  for (int i = 0; i < 16; ++i) grid.push_back({double(i % 4), double(i / 4), 0});
  scene.add_directional({0, 0.5, -1}, 1000);
  const Sensor meters = scene.add_meters(grid, {0, 0, 1});
  const double expected = 1000 / std::sqrt(1.25);
  for (ups_method m : {UPS_METHOD_UPS, UPS_METHOD_PPM, UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING}) {
    const Result result = scene.render({.method = m, .iterations = 256});
    const auto s = result.statistics(meters);
    expect_lx(s.mean_lx, s.mean_standard_error_lx, expected, quiet, method_name(m));
    for (const auto& r : result.readings(meters)) expect_lx(r, expected, one_of(0.01), method_name(m));
  }
}

}  // namespace
}  // namespace ups::test
