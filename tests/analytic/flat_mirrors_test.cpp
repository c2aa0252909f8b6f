// Lights without extent in flat mirrors and panes: what a meter gets of their images is E = R(a) I cos(b) / d^2, d along
// the whole way, and no matter of chance. In black surroundings that is all there is.
//
// Comparisons with closed forms have no noise: readings differ from them by rounding alone, 1e-4 is allowed. Two sets of
// techniques are compared by two one-sided t tests, see there.
#include "../support/expect_lx.h"
#include "../support/image_mean.h"

namespace ups::test {
namespace {

constexpr uint32_t all_but_mirrors = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT |
                                     UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT;
constexpr double rounding = 1e-4, intensity_cd = 500;
const P3 lamp{0.4, 1.2, 2.0};
const std::vector<P3> points = {{0.3, 0.8, 0}, {-0.5, 1.6, 0.1}, {1.1, 0.5, -0.2}};
const Shape wall_mirror = quad({-3, 0, -3}, {0, 0, 8}, {6, 0, 0});  // y = 0

P3 in_mirror(const P3& p) { return {p.x, -p.y, p.z}; }

double straight(const P3& from, const P3& at, const P3& n, double candela = intensity_cd) {
  const P3 way = from - at;
  const double d = std::sqrt(dot(way, way));
  return candela * std::max(0.0, dot(way, n)) / (d * d * d);
}
double mirrored(const P3& at, const P3& n, double reflectance) {
  return reflectance * straight(in_mirror(lamp), at, n);
}
double cosine_at_mirror(const P3& at) {
  const P3 way = in_mirror(lamp) - at;
  return std::abs(way.y) / std::sqrt(dot(way, way));
}
// Of both faces of a clear pane, with all reflections between them: 2 F / (1 + F) for each polarisation.
double pane_reflectance(double cosine, double ior) {
  const double sine = std::sqrt(1 - cosine * cosine), inside = std::sqrt(1 - sine * sine / (ior * ior));
  const double s = std::pow((cosine - ior * inside) / (cosine + ior * inside), 2),
               p = std::pow((ior * cosine - inside) / (ior * cosine + inside), 2);
  return s / (1 + s) + p / (1 + p);
}
ups_material_desc clear_pane() {
  auto d = material(UPS_MATERIAL_GLAZING, 1);
  for (float& t : d.transmittance_rgb) t = 1;
  return d;
}

class FlatMirrors : public ::testing::TestWithParam<ups_method> {
 protected:
  void SetUp() override { scene.add_point_light(lamp, intensity_cd); }
  Result render(uint32_t iterations = 16) {
    return scene.render({.method = GetParam(), .iterations = iterations, .light_paths = 1u << 10});
  }
  template <class Expected>
  void expect(const Sensor& meters, const Result& result, const Expected& expected) {
    EXPECT_TRUE(result.info().techniques & UPS_TECHNIQUE_MIRROR_SAMPLE);
    EXPECT_EQ(result.text(UPS_TEXT_WARNINGS).find("is missing"), std::string::npos) << result.text(UPS_TEXT_WARNINGS);
    const auto readings = result.readings(meters);
    for (size_t i = 0; i < readings.size(); ++i) {
      EXPECT_NEAR(readings[i].illuminance_lx, expected(i), rounding * expected(i)) << i;
      EXPECT_LE(std::abs(readings[i].illuminance_lx - expected(i)), readings[i].error_bound_lx) << i;
    }
  }
  // A tinted one that reflects nothing stands so far before the mirror: light goes through it twice, 0.7^(1 / cos a) each
  // time.
  void expect_through_a_sheet(double before) {
    scene.add(wall_mirror, mirror(0.9));
    auto sheet = clear_pane();
    sheet.ior = 1;
    for (float& t : sheet.transmittance_rgb) t = 0.7f;
    scene.add(quad({-3, before, -3}, {0, 0, 8}, {6, 0, 0}), sheet);
    const P3 n{0, 0, 1};
    const Sensor meters = scene.add_meters(points, n);
    expect(meters, render(), [&](size_t i) {
      return straight(lamp, points[i], n) +
             mirrored(points[i], n, 0.9 * std::pow(0.7, 2 / cosine_at_mirror(points[i])));
    });
  }
  Scene scene;
};

TEST_P(FlatMirrors, MirrorsShowALampAsItsImage) {
  scene.add(wall_mirror, mirror(0.85));
  for (const P3& n : {P3{0, 0, 1}, P3{0, -1, 0}, normalize(P3{0.3, -0.4, 0.8})}) {
    const Sensor meters = scene.add_meters(points, n);
    const Result result = render();
    expect(meters, result, [&](size_t i) { return straight(lamp, points[i], n) + mirrored(points[i], n, 0.85); });
    for (size_t i = 0; i < points.size(); ++i) {
      const auto r = result.readings(meters)[i];
      EXPECT_NEAR(r.direct_lx, straight(lamp, points[i], n), rounding * r.illuminance_lx) << i;
      EXPECT_NEAR(r.indirect_lx, mirrored(points[i], n, 0.85), rounding * r.illuminance_lx) << i;
    }
  }
}

TEST_P(FlatMirrors, PanesReflectByFresnel) {
  scene.add(wall_mirror, clear_pane());
  const P3 n{0, 0, 1};
  const Sensor meters = scene.add_meters(points, n);
  expect(meters, render(), [&](size_t i) {
    return straight(lamp, points[i], n) + mirrored(points[i], n, pane_reflectance(cosine_at_mirror(points[i]), 1.5));
  });
}

// From either side of a slab, and in each of its faces: a mirror of many triangles.
TEST_P(FlatMirrors, AreSlabsToo) {
  scene.add(box({-3, -0.1, -3}, {3, 0, 5}), mirror(0.7));
  const P3 n{0, 0, 1};
  const Sensor meters = scene.add_meters(points, n);
  expect(meters, render(), [&](size_t i) { return straight(lamp, points[i], n) + mirrored(points[i], n, 0.7); });
}

// Two windows in one wall: none shows what would lie between them.
TEST_P(FlatMirrors, ReflectOnlyWhereTheyAre) {
  const P3 n{0, 0, 1};
  const auto where = [&](size_t i) {
    return points[i].x + (lamp.x - points[i].x) * points[i].y / (points[i].y + lamp.y);
  };
  scene.add(quad({where(0) - 0.05, 0, -3}, {0, 0, 8}, {0.1, 0, 0}), mirror(0.9));
  scene.add(quad({where(2) - 0.05, 0, -3}, {0, 0, 8}, {0.1, 0, 0}), mirror(0.9));
  const Sensor meters = scene.add_meters(points, n);
  expect(meters, render(), [&](size_t i) {
    return straight(lamp, points[i], n) + (i == 1 ? 0 : mirrored(points[i], n, 0.9));
  });
}

// A screen between lamp and mirror, and one between mirror and meter.
TEST_P(FlatMirrors, SeeWhatStandsInTheWay) {
  scene.add(wall_mirror, mirror(0.9));
  const P3 n{0, 0, 1};
  const auto add_screen = [&](size_t i, const P3& end) {  // half way from the mirror
    const P3 at_mirror = points[i] + (in_mirror(lamp) - points[i]) * (points[i].y / (points[i].y + lamp.y));
    scene.add(quad((at_mirror + end) * 0.5 + P3{-0.01, 0, -0.01}, {0.02, 0, 0}, {0, 0, 0.02}), matte(0));
  };
  add_screen(1, lamp), add_screen(2, points[2]);
  const Sensor meters = scene.add_meters(points, n);
  expect(meters, render(),
         [&](size_t i) { return straight(lamp, points[i], n) + (i == 0 ? mirrored(points[i], n, 0.9) : 0); });
}

TEST_P(FlatMirrors, SeeThroughPanes) { expect_through_a_sheet(0.2); }

// 1 mm before the mirror, while black ground reaches 700 m: the extent of a scene is no measure of its mirrors.
TEST_P(FlatMirrors, AreAsFineAsRaysAre) {
  scene.add(quad({-700, -700, -50}, {1400, 0, 0}, {0, 1400, 0}), matte(0));
  expect_through_a_sheet(0.001);
}

INSTANTIATE_TEST_SUITE_P(By, FlatMirrors, ::testing::Values(UPS_METHOD_UPS, UPS_METHOD_AUTO),
                         [](const auto& p) { return p.param == UPS_METHOD_UPS ? "UPS" : "auto"; });

// Parallel light of 1000 lx across its way, which comes down at 0.6 along y and goes on as from below the mirror.
class FlatMirrorsInTheSun : public FlatMirrors {
 protected:
  void SetUp() override { scene.add_directional(sun, 1000); }
  static double straight(const P3& n) { return 1000 * std::max(0.0, -dot(sun, n)); }
  static double mirrored(const P3& n, double reflectance) {
    return 1000 * reflectance * std::max(0.0, -dot(P3{sun.x, -sun.y, sun.z}, n));
  }
  // Where the mirror, y = 0, shows it to a point.
  static P3 place(const P3& at) { return at + P3{-sun.x, sun.y, -sun.z} * (at.y / -sun.y); }
  static constexpr P3 sun{0.48, -0.6, -0.64};
};

TEST_P(FlatMirrorsInTheSun, TheyShowItWhereTheyAre) {
  const P3 n = normalize(P3{0.1, -0.3, 0.9});
  scene.add(quad(place(points[0]) - P3{0.05, 0, 0.05}, {0, 0, 0.1}, {0.1, 0, 0}), mirror(0.9));
  scene.add(quad(place(points[2]) - P3{0.05, 0, 0.05}, {0, 0, 0.1}, {0.1, 0, 0}), mirror(0.9));
  const Sensor meters = scene.add_meters(points, n);
  const Result result = render();
  expect(meters, result, [&](size_t i) { return straight(n) + (i == 1 ? 0 : mirrored(n, 0.9)); });
  EXPECT_NEAR(result.readings(meters)[0].indirect_lx, mirrored(n, 0.9), rounding * 1000);
}

TEST_P(FlatMirrorsInTheSun, TheySeeWhatStandsInTheWay) {
  scene.add(wall_mirror, mirror(0.9));
  const P3 n{0, 0, 1}, behind = place(points[1]) - sun * 3;
  scene.add(quad((points[2] + place(points[2])) * 0.5 - P3{0.01, 0, 0.01}, {0.02, 0, 0}, {0, 0, 0.02}), matte(0));
  scene.add(quad(behind - P3{0.01, 0, 0.01}, {0.02, 0, 0}, {0, 0, 0.02}), matte(0));
  const Sensor meters = scene.add_meters(points, n);
  expect(meters, render(), [&](size_t i) { return straight(n) + (i == 0 ? mirrored(n, 0.9) : 0); });
}

// Where the scene begins, seen by way of a small mirror at its end: 20 m from that, in a scene of 16 m about its middle.
TEST_P(FlatMirrorsInTheSun, TheySeeWhatIsFarOff) {
  const P3 n{0, 0, 1}, before{0.3, 8.4, 0}, mirrors = place(before), screens = mirrors - sun * 20;
  scene.add(quad(mirrors - P3{0.05, 0, 0.05}, {0, 0, 0.1}, {0.1, 0, 0}), mirror(0.9));
  scene.add(quad(screens - P3{0.1, 0, 0.1}, {0.2, 0, 0}, {0, 0, 0.2}), matte(0));
  const Sensor meters = scene.add_meters({before}, n);
  expect(meters, render(), [&](size_t) { return straight(n); });
}

TEST_P(FlatMirrorsInTheSun, PanesReflectByFresnel) {
  scene.add(wall_mirror, clear_pane());
  const P3 n{0, 0, 1};
  const Sensor meters = scene.add_meters(points, n);
  expect(meters, render(), [&](size_t) { return straight(n) + mirrored(n, pane_reflectance(0.6, 1.5)); });
}

INSTANTIATE_TEST_SUITE_P(By, FlatMirrorsInTheSun, ::testing::Values(UPS_METHOD_UPS, UPS_METHOD_AUTO),
                         [](const auto& p) { return p.param == UPS_METHOD_UPS ? "UPS" : "auto"; });

// What a narrow beam lights, straight or by way of the mirror, is a small patch that eye paths find by chance alone: its
// light is a photon's.
TEST(FlatMirrorsAndBeams, LeaveSmallPatchesToPhotons) {
  for (const bool at_mirror : {false, true}) {
    Scene scene;
    scene.add(box({-2, -2, 0}, {2, 2, 3}).flipped(), matte(0.5));
    scene.add(quad({-1.99, -1, 0.5}, {0, 2, 0}, {0, 0, 2}), mirror(0.8));
    scene.add_spot(at_mirror ? P3{-1, 0, 1.5} : P3{1.5, 0, 1.5}, {at_mirror ? -1.0 : 1.0, 0, 0}, 5000, 0.01, 0.02);
    scene.add_meters({{0, 1, 0.8}}, {0, 0, 1});
    const uint32_t techniques = scene.render({.method = UPS_METHOD_AUTO, .iterations = 16}).info().techniques;
    EXPECT_TRUE(techniques & UPS_TECHNIQUE_MERGE) << at_mirror;
    EXPECT_TRUE(techniques & UPS_TECHNIQUE_MIRROR_SAMPLE) << at_mirror;
  }
}

// So is the sun's by way of a mirror of 4 cm, on a table in a court with half a roof.
TEST(FlatMirrorsAndBeams, LeaveTheSunsSmallPatchesToPhotons) {
  Scene scene;
  scene.add(quad({-3, -2, 0}, {6, 0, 0}, {0, 4, 0}), matte(0.5));
  scene.add(quad({-3, -2, 2.8}, {0, 4, 0}, {2.5, 0, 0}), matte(0.5));
  scene.add(quad({-0.02, -0.02, 0.8}, {0.04, 0, 0}, {0, 0.04, 0}), mirror(0.9));
  scene.add_directional({-0.6, 0, -0.8}, 1e5);
  scene.add_meters({{1, 0, 0.8}}, {0, 0, 1});
  const uint32_t techniques = scene.render({.method = UPS_METHOD_AUTO, .iterations = 16}).info().techniques;
  EXPECT_TRUE(techniques & UPS_TECHNIQUE_MERGE);
  EXPECT_TRUE(techniques & UPS_TECHNIQUE_MIRROR_SAMPLE);
}

// A luminaire as a point, by its table; sources apart.
TEST(FlatMirrorsOfLuminaires, ShowThemByTheirTables) {
  Scene scene;
  const auto profile = table_profile(scene.context(), 0);
  scene.add_luminaire(profile.get(), lamp, {0, 0, -1}, false);
  scene.add_point_light({-1, 0.5, 1.5}, 100);
  scene.add(wall_mirror, mirror(0.85));
  const Sensor meters = scene.add_meters(points, {0, 0, 1});
  const Result result =
      scene.render({.method = UPS_METHOD_AUTO, .iterations = 16, .separation = UPS_SEPARATE_LUMINAIRES});
  const auto candela = [](const P3& from, const P3& to) {  // 1000, 700 and 0 cd at 0, 45 and 90 degrees
    const P3 way = to - from;
    const double gamma = std::acos(-way.z / std::sqrt(dot(way, way))) * 180 / pi_d;
    return gamma < 45 ? 1000 - gamma / 45 * 300 : gamma < 90 ? 700 * (1 - (gamma - 45) / 45) : 0.0;
  };
  for (size_t i = 0; i < points.size(); ++i) {
    double expected = 0;
    for (const double r : {1.0, 0.85}) {
      const P3 from = r == 1 ? lamp : in_mirror(lamp);
      expected += r * straight(from, points[i], {0, 0, 1}, candela(from, points[i]));
    }
    const P3 other{-1, 0.5, 1.5};
    const P3 up{0, 0, 1};
    const double of_other = straight(other, points[i], up, 100) + 0.85 * straight(in_mirror(other), points[i], up, 100);
    EXPECT_NEAR(result.readings(meters)[i].illuminance_lx, expected + of_other, 2e-3 * expected) << i;
  }
}

// What has no image is left to light paths: a curved mirror, one with other normals, a lamp that lies on the mirror.
TEST(FlatMirrorsThatAreNone, AreLeftToLightPaths) {
  Shape bent = wall_mirror;
  bent.normals.assign(bent.vertices.size(), normalize(P3{0.05, 1, 0}));
  const Shape ball = icosphere({0, -1, 1}, 0.5, 2);
  for (const Shape& shape : {bent, ball}) {
    Scene scene;
    scene.add_point_light(lamp, intensity_cd);
    scene.add(shape, mirror(0.9));
    scene.add_meters(points, {0, 0, 1});
    const Result result = scene.render({.method = UPS_METHOD_AUTO, .iterations = 16});
    EXPECT_FALSE(result.info().techniques & UPS_TECHNIQUE_MIRROR_SAMPLE);
    EXPECT_TRUE(result.info().techniques & UPS_TECHNIQUE_MERGE);
  }
  Scene scene;
  scene.add_point_light({0.4, 0, 2}, intensity_cd);
  scene.add(wall_mirror, mirror(0.9));
  scene.add_meters(points, {0, 0, 1});
  EXPECT_TRUE(scene.render({.method = UPS_METHOD_AUTO, .iterations = 16}).info().techniques & UPS_TECHNIQUE_MERGE);
  Scene along;
  along.add_directional({0, 0, -1}, 1000);
  along.add(wall_mirror, mirror(0.9));
  along.add_meters(points, {0, 0, 1});
  EXPECT_FALSE(along.render({.method = UPS_METHOD_AUTO, .iterations = 16}).info().techniques &
               UPS_TECHNIQUE_MIRROR_SAMPLE);
}

TEST(FlatMirrorsThatAreNone, AreNotAskedForWithoutLightSamples) {
  Scene scene;
  scene.add_point_light(lamp, intensity_cd);
  scene.add(wall_mirror, mirror(0.9));
  scene.add_meters(points, {0, 0, 1});
  const auto techniques = [&](uint32_t mask, ups_method method) {
    return scene.render({.method = method, .iterations = 16, .techniques = mask}).info().techniques;
  };
  constexpr uint32_t mirrors = UPS_TECHNIQUE_MIRROR_SAMPLE;
  EXPECT_FALSE(techniques(mirrors | UPS_TECHNIQUE_MERGE, UPS_METHOD_UPS) & mirrors);
  EXPECT_FALSE(techniques(all_but_mirrors, UPS_METHOD_UPS) & mirrors);
  EXPECT_FALSE(techniques(0, UPS_METHOD_PATH_TRACING) & mirrors);
}

// A room with two mirrors that face each other, a pane, gloss, a glass ball and lamps with and without extent: all
// techniques with images in mirrors, and without. Equivalent: two one-sided t tests show that means over the meters, and
// over the picture, differ by less than 1 %. Standard errors are at most 0.2 and 0.15 %, of the difference 0.25 %: methods
// that are the same fail with P(t > 1 / 0.25 - 2.04) = 3 %, those that differ by 1 % or more pass with P(t > 2.04) =
// 2.5 %. Seeds are fixed. Merge radii are small, as point meters' own would be off by half a percent.
void add_all_else(Scene& scene) {
  scene.add(box({0, 0, 0}, {4, 3, 2.6}).flipped(), matte(0.6));
  scene.add(quad({0.01, 0.5, 0.5}, {0, 2, 0}, {0, 0, 1.6}), mirror(0.9));
  scene.add(quad({3.99, 0.5, 0.5}, {0, 0, 1.6}, {0, 2, 0}), mirror(0.8));
  scene.add(quad({1, 2.4, 0}, {2, 0, 0.3}, {0, 0, 2}), clear_pane());
  scene.add(box({2.6, 0.4, 0}, {3.2, 1, 0.5}), rough(UPS_MATERIAL_METAL, 0.8, 0.3));
  Shape ball = icosphere({1.2, 1.4, 0.6}, 0.25, 3);
  for (const P3& v : ball.vertices) ball.normals.push_back(normalize(v - P3{1.2, 1.4, 0.6}));
  scene.add(ball, glass(1.5));
  scene.add_point_light({1, 1, 2.2}, 150);
  scene.add_spot({3, 1.5, 2.5}, {0, 0, -1}, 400, 0.5, 1.2);
  scene.add(quad({1.8, 1.2, 2.59}, {0, 0.4, 0}, {0.4, 0, 0}), emitter(800));
}
TEST(FlatMirrorsAmongAllElse, TheLightIsTheSame) {
  Scene with_meters, with_camera;
  add_all_else(with_meters), add_all_else(with_camera);
  std::vector<P3> at;
  for (int i = 0; i < 48; ++i) at.push_back({0.25 + 0.5 * (i % 8), 0.25 + 0.5 * (i / 8 % 6), 0.02 + 0.9 * (i % 2)});
  const Sensor meters = with_meters.add_meters(at, {0, 0, 1}),
               camera = with_camera.add_camera({3.6, 0.4, 1.8}, {-0.7, 0.6, -0.3}, 48, 36, 1.2);
  const auto measure = [&](uint32_t techniques, uint32_t iterations, uint64_t seed) {
    return with_meters.render({.iterations = iterations, .seed = seed, .merge_radius_m = 0.08, .light_paths = 1u << 13,
                               .techniques = techniques});
  };
  constexpr uint32_t all = all_but_mirrors | UPS_TECHNIQUE_MIRROR_SAMPLE;
  const Result with = measure(all, 16, 1), without = measure(all_but_mirrors, 64, 2);
  EXPECT_TRUE(with.info().techniques & UPS_TECHNIQUE_MIRROR_SAMPLE);
  EXPECT_FALSE(without.info().techniques & UPS_TECHNIQUE_MIRROR_SAMPLE);
  const auto expect_same = [](const Mean& x, const Mean& y, const char* what) {
    EXPECT_LE(x.standard_error, 0.0015 * y.value) << what << ": too noisy to judge";
    EXPECT_LE(y.standard_error, 0.002 * y.value) << what << ": too noisy to judge";
    EXPECT_GE(0.01 * y.value - std::abs(x.value - y.value), 2.04 * std::hypot(x.standard_error, y.standard_error))
        << what << ": " << x.value << " +- " << x.standard_error << " and " << y.value << " +- " << y.standard_error;
  };
  const auto a = with.statistics(meters), b = without.statistics(meters);
  expect_same({a.mean_lx, a.mean_standard_error_lx}, {b.mean_lx, b.mean_standard_error_lx}, "meters");
  const RenderOptions of_picture{.iterations = 6, .light_paths = 1u << 12};
  RenderOptions mirrors = of_picture, none = of_picture;
  mirrors.techniques = all, none.techniques = all_but_mirrors;
  expect_same(image_mean(with_camera, camera, mirrors), image_mean(with_camera, camera, none), "picture");
}

// A court in the sun with a mirror and a window in one plane, for which `auto` needs no light paths; the same judgement.
// Over cells, on which photons land without blur.
TEST(FlatMirrorsAmongAllElse, TheLightOfTheSunIsTheSame) {
  Scene scene;
  scene.add(quad({0, 0, 0}, {4, 0, 0}, {0, 3, 0}), matte(0.6));
  for (const Shape& wall : {quad({0, 0, 0}, {0, 3, 0}, {0, 0, 2.6}), quad({4, 0, 0}, {0, 0, 2.6}, {0, 3, 0}),
                            quad({0, 0, 0}, {0, 0, 2.6}, {4, 0, 0}), quad({0, 3, 0}, {4, 0, 0}, {0, 0, 2.6})})
    scene.add(wall, matte(0.5));
  scene.add(quad({0.01, 0.5, 0.5}, {0, 1.2, 0}, {0, 0, 1.6}), mirror(0.9));
  scene.add(quad({0.01, 1.8, 0.5}, {0, 1, 0}, {0, 0, 1.6}), clear_pane());
  scene.add_directional(normalize(P3{-0.7, 0.1, -0.7}), 1000);
  std::vector<P3> at;
  for (int i = 0; i < 24; ++i) at.push_back({0.5 + 0.6 * (i % 6), 0.4 + 0.7 * (i / 6), 0.02});
  const Sensor meters =
      scene.add_cells(at, std::vector<P3>(at.size(), {0, 0, 1}), std::vector<P3>(at.size(), {1, 0, 0}), 0.3, 0.3);
  const auto measure = [&](ups_method method, uint32_t techniques, uint32_t iterations, uint64_t seed) {
    return scene.render({.method = method, .iterations = iterations, .seed = seed, .merge_radius_m = 0.08,
                         .light_paths = 1u << 13, .techniques = techniques});
  };
  const Result plain = measure(UPS_METHOD_UPS, all_but_mirrors, 128, 2);
  const auto b = plain.statistics(meters);
  EXPECT_LE(b.mean_standard_error_lx, 0.002 * b.mean_lx) << "too noisy to judge";
  for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_AUTO}) {
    const Result with = measure(method, 0, 64, 1);
    const bool automatic = method == UPS_METHOD_AUTO;
    EXPECT_EQ(!(with.info().techniques & UPS_TECHNIQUE_MERGE), automatic);
    const auto a = with.statistics(meters);
    const double s = std::hypot(a.mean_standard_error_lx, b.mean_standard_error_lx);
    EXPECT_LE(a.mean_standard_error_lx, 0.0015 * b.mean_lx) << "too noisy to judge, " << automatic;
    EXPECT_GE(0.01 * b.mean_lx - std::abs(a.mean_lx - b.mean_lx), 2.04 * s)
        << automatic << ": " << a.mean_lx << " and " << b.mean_lx << " +- " << s;
  }
}

// Ninety lamps, whose images are a tree's, in a window and in a mirror; the same judgement. No meter lies at the edge of
// what the mirror shows of a lamp, where photons are blurred.
TEST(FlatMirrorsAmongAllElse, TheLightOfManyLampsIsTheSame) {
  Scene scene;
  scene.add(box({0, 0, 0}, {6, 5, 3}).flipped(), matte(0.6));
  scene.add(quad({0.01, 1, 0.5}, {0, 3, 0}, {0, 0, 1.6}), mirror(0.9));
  scene.add(quad({1, 0.01, 0.5}, {0, 0, 2}, {4, 0, 0}), clear_pane());
  for (int i = 0; i < 90; ++i)
    scene.add_spot({0.3 + 0.6 * (i % 10), 0.3 + 0.55 * (i / 10), 2.9}, {0, 0, -1}, 20, 0.5, 1.2);
  std::vector<P3> at;
  for (int i = 0; i < 24; ++i) at.push_back({0.7 + 0.9 * (i % 6), 0.5 + (i / 6), 0.75});
  const Sensor meters = scene.add_meters(at, {0, 0, 1});
  const auto measure = [&](uint32_t techniques, uint64_t seed) {
    const RenderOptions options{.iterations = 32, .seed = seed, .light_paths = 1u << 13, .techniques = techniques};
    return scene.render(options).statistics(meters);
  };
  const auto a = measure(all_but_mirrors | UPS_TECHNIQUE_MIRROR_SAMPLE, 1), b = measure(all_but_mirrors, 2);
  const double s = std::hypot(a.mean_standard_error_lx, b.mean_standard_error_lx),
               difference = std::abs(a.mean_lx - b.mean_lx);
  EXPECT_LE(s, 0.0025 * b.mean_lx) << "too noisy to judge";
  EXPECT_GE(0.01 * b.mean_lx - difference, 2.04 * s) << a.mean_lx << " and " << b.mean_lx << " +- " << s;
}

}  // namespace
}  // namespace ups::test
