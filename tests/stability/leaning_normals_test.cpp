// Shading normals that lean from their faces: normal maps finer than the merge radius, smooth normals on coarse meshes,
// and what of the light such normals lose, which the result states.
//
// Methods are compared in pairs: each standard error is at most 0.15 % of the value, and half a percent or 3 standard
// errors of the difference is allowed (expect_same.h, with its false alarms; of images, whose errors come from eight
// seeds, P(|t_14| > 3) = 1 % at the limit): an error of 1 % is found in 95 of 100 cases at the least.
#include <algorithm>
#include <cstdlib>
#include <numeric>
#include <random>

#include "../support/expect_same.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

// A floor of 3 m whose 8 x 8 texels are 4 mm wide each and lean by up to 45 degrees, independently.
void add_bumpy_floor(Scene& scene, ups_material_desc material) {
  constexpr uint32_t size = 8;
  constexpr float tiles = 94;
  std::mt19937 engine(5);
  const auto uniform = [&] { return std::generate_canonical<double, 53>(engine) * 2 - 1; };
  std::vector<float> texels;
  for (uint32_t i = 0; i < size * size; ++i) {
    const P3 n = normalize({uniform(), uniform(), 1});
    texels.insert(texels.end(), {float(n.x / 2 + 0.5), float(n.y / 2 + 0.5), float(n.z / 2 + 0.5)});
  }
  material.normal_texture = scene.add_texture(size, size, texels);
  Shape floor = quad({-1.5, -1.5, 0}, {3, 0, 0}, {0, 3, 0});
  floor.uvs = {{0, 0}, {tiles, 0}, {tiles, tiles}, {0, tiles}};
  scene.add(floor, material);
}

// Photons that fall on a texel from behind its normal are merged where the texel beside it sees them: within the radius
// of 40 mm lie 300 texels. (Without them merging lost 1.6 and 1.8 % here.)
TEST(Taught, BumpMapsFinerThanTheMergeRadius) {
  for (const ups_material_desc& material : {matte(0.8), rough(UPS_MATERIAL_METAL, 0.9, 0.7)}) {
    Scene scene;
    add_bumpy_floor(scene, material);
    scene.add(quad({-0.8, -0.8, 0.6}, {0, 1.6, 0}, {1.6, 0, 0}), emitter(1000));
    scene.add_directional({1, 0, -0.5}, 500);
    const Sensor points = scene.add_meters(grid_about({0, 0, 0.3}, {1, 0, 0}, {0, 1, 0}, 0.8, 24), {0, 0, -1});
    std::vector<Estimate> means;
    for (const Trial& t : {trial(UPS_METHOD_PATH_TRACING, 64), trial(UPS_METHOD_BIDIRECTIONAL, 48, 1u << 13),
                           trial(UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING, 16, 1u << 16, 0.04)})
      means.push_back(estimate(t.name, render_quietly(scene, t.options, {points}), points));
    for (const Estimate& m : means) measured("%s %+.2f %%", m.name.c_str(), 100 * (m.mean / means[0].mean - 1));
    expect_same(means, 0, "meters above the floor");
  }
}

// The illuminance on what a camera sees is that of its face, whatever its normal map: a sun's is known. Mean of 256
// pixels over eight seeds, without noise where the method sees the sun by next-event estimation. At a standard error of
// 0.16 %, asserted, 0.5 % or four of them are allowed: 1 % is found in 97 of 100 cases. P(|t_7| > 4) = 0.5 % is the
// chance of a false alarm where noise decides.
TEST(Taught, BumpMapsDoNotChangeTheIlluminanceOfAnImage) {
  const double expected = 500 * 0.5 / std::sqrt(1.25);
  Scene scene;
  add_bumpy_floor(scene, matte(0.8));
  scene.add_directional({1, 0, -0.5}, 500);
  const Sensor camera = scene.add_camera({0, 0, 0.5}, {0, 0, -1}, 16, 16, 0.8, true);
  for (const Trial& t : {trial(UPS_METHOD_PATH_TRACING, 4), trial(UPS_METHOD_UPS, 4, 1u << 12, 0.04),
                         trial(UPS_METHOD_PPM, 12, 1u << 16, 0.04)}) {
    std::vector<double> means;
    RenderOptions options = t.options;
    for (options.seed = 1; options.seed <= 8; ++options.seed) {
      const auto pixels = scene.render(options).image(camera).illuminance;
      means.push_back(std::accumulate(pixels.begin(), pixels.end(), 0.0) / double(pixels.size()));
    }
    const Mean mean = mean_of(means);
    expect_lx(mean.value, mean.standard_error, expected, 0.0016, t.name);
  }
}

Shape smooth_sphere(const P3& center, double radius, int subdivisions) {
  Shape s = icosphere(center, radius, subdivisions);
  for (const P3& v : s.vertices) s.normals.push_back(normalize(v - center));
  return s;
}

// Shading normals up to 40 degrees off the facets: light that comes from the light and from the eye must be bent alike
// (Veach 1997, 5.3), also where it grazes. Image means over 8 seeds.
TEST(Taught, SmoothNormalsOnCoarseMeshesAreAlikeFromBothEnds) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 3, 2.5}).flipped(), matte(0.5));
  for (const P3& center : {P3{2.1, 1.9, 0.9}, P3{2.8, 1.0, 0.8}}) scene.add(smooth_sphere(center, 0.4, 0), matte(0.8));
  scene.add_point_light({1.5, 1.5, 2}, 100);
  const Sensor camera = scene.add_camera({0.3, 0.2, 1.6}, {1, 0.8, -0.35}, 32, 24, 0.6);
  std::vector<Estimate> means;
  for (const Trial& t : {trial(UPS_METHOD_PATH_TRACING, 40), trial(UPS_METHOD_BIDIRECTIONAL, 16, 1u << 12),
                         trial(UPS_METHOD_UPS, 16, 1u << 12, 0.02), trial(UPS_METHOD_LIGHT_TRACING, 12, 1u << 14)})
    means.push_back(estimate(t.name, image_mean(scene, camera, t.options)));
  for (const Estimate& m : means) measured("%s %+.2f %%", m.name.c_str(), 100 * (m.mean / means[0].mean - 1));
  expect_same(means, 0, "image");
}

// All normals of a quad lean the same way, so that nothing averages out.
Shape leaning(Shape s, const P3& normal) {
  s.normals.assign(s.vertices.size(), normalize(normal));
  return s;
}

// A spot straight down on a floor whose normals lean by 30 degrees towards a wall; the wall's lean up as far. Meters
// and a camera see the wall alone, which reaches below the floor, where its light does not come. Each technique alone,
// so that what one forgets of the normals no other hides: corrections at the floor are halves, at the wall two thirds.
// No edge is lit where photons are merged. Each technique is held against connections: the difference's standard error
// is at most 0.2 %, and half a percent or three of it are allowed, so that 1 % is found in 97 of 100 cases at the
// least; P(|t_15| > 3) = 0.9 % is the chance of a false alarm where noise decides.
TEST(Taught, LeaningNormalsByEachTechniqueAlone) {
  constexpr Limits limits{0.0018, 0.005};
  const double sine = 0.5, cosine = std::sqrt(0.75);
  Scene scene;
  scene.add(leaning(quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {sine, 0, cosine}), matte(0.8));
  scene.add(leaning(quad({1.3, -1, -1}, {0, 0, 3}, {0, 3, 0}), {-cosine, 0, sine}), matte(0.8));
  scene.add_spot({0.5, 0.5, 1.2}, {0, 0, -1}, 1000, 0.3, 0.35);
  Trial connections = trial(UPS_METHOD_UPS, 640, 1u << 12);
  connections.name = "connections alone";
  connections.options.techniques = UPS_TECHNIQUE_CONNECT;
  std::vector<Estimate> in_image, at_meters;
  const Sensor camera = scene.add_camera({1.02, 0.5, 0.2}, {1, 0, 0}, 8, 8, 1.2);
  for (const Trial& t : {connections, trial(UPS_METHOD_LIGHT_TRACING, 64, 1u << 14)})
    in_image.push_back(estimate(t.name, image_mean(scene, camera, t.options)));
  connections.options.iterations = 64;
  const Sensor meters = scene.add_meters(grid_about({1.02, 0.5, 0.2}, {0, 0, 1}, {0, 1, 0}, 0.8, 8), {1, 0, 0});
  for (const Trial& t : {connections, trial(UPS_METHOD_PATH_TRACING, 512), merge_only(32, 1u << 16, 0.02)})
    at_meters.push_back(estimate(t.name, render_quietly(scene, t.options, {meters}, limits), meters));
  for (const std::vector<Estimate>& all : {in_image, at_meters})
    for (const Estimate& m : all) measured("%s %+.2f %%", m.name.c_str(), 100 * (m.mean / all[0].mean - 1));
  for (const std::vector<Estimate>& all : {in_image, at_meters})
    for (const Estimate& m : std::vector<Estimate>(all.begin() + 1, all.end())) {
      EXPECT_LE(std::hypot(m.standard_error, all[0].standard_error), 0.002 * all[0].mean) << m.name << ": too noisy";
      expect_pair(m, all[0], all.size() == in_image.size() ? "image" : "meters", limits);
    }
}

// A spot straight down on a floor whose normals lean by 45 degrees towards a wall of rough metal: of what the floor
// scatters about its normal nothing may leave below its face. The wall below the floor is dark, exactly.
TEST(Taught, NothingGlowsBelowAFloorWhoseNormalsLean) {
  Scene scene;
  scene.add(leaning(quad({0, 0, 0}, {1, 0, 0}, {0, 1, 0}), {1, 0, 1}), matte(0.8));
  scene.add(quad({1.3, -1, -1}, {0, 0, 3}, {0, 3, 0}), rough(UPS_MATERIAL_METAL, 0.9, 0.5));
  scene.add_spot({0.5, 0.5, 1.2}, {0, 0, -1}, 1000, 0.3, 0.35);
  const Sensor above = scene.add_camera({1.02, 0.5, 0.4}, {1, 0, 0}, 8, 8, 0.8);
  const Sensor below = scene.add_camera({1.02, 0.5, -0.4}, {1, 0, 0}, 8, 8, 0.8);
  Trial connections = trial(UPS_METHOD_UPS, 16, 1u << 12);
  connections.name = "connections alone";
  connections.options.techniques = UPS_TECHNIQUE_CONNECT;
  for (const Trial& t : {connections, trial(UPS_METHOD_LIGHT_TRACING, 16, 1u << 12),
                         trial(UPS_METHOD_PATH_TRACING, 16), merge_only(16, 1u << 12, 0.02)}) {
    const Result result = scene.render(t.options);
    const auto largest = [&](const Sensor& camera) {
      const auto pixels = result.image(camera).luminance;
      return *std::max_element(pixels.begin(), pixels.end());
    };
    EXPECT_GT(largest(above), 1) << t.name;
    EXPECT_EQ(largest(below), 0) << t.name;
  }
}

double stated_loss(const Result& result) {
  const std::string text = result.text(UPS_TEXT_WARNINGS), words = "lean from their faces lose ";
  const size_t at = text.find(words);
  EXPECT_NE(at, text.npos) << text;
  return at == text.npos ? 0 : std::atof(text.c_str() + at + words.size()) / 100;
}

// A furnace, where all surfaces emit and reflect half: 20 pi lx everywhere. A sphere in it with smooth normals on a
// coarse mesh loses light where the two kinds of normals disagree and where the terminator is softened: what is missing
// at the walls is what the result states, by the books of light paths as by the importance that eye paths lose: within a
// tenth of it and the noise of both, 0.04 % of the readings. At the limit of noise, 0.02 %, a false alarm takes 3 standard
// errors, P(|t_15| > 3) = 0.9 %; 0.1 % that is not stated is found. With a normal of its own for each face nothing is
// lost, and nothing stated; nor where paths end at the first surface.
struct Furnace {
  static constexpr double rho = 0.5, luminance = 10;
  Scene scene;
  const Points walls = points_inside(box({0, 0, 0}, {4, 3, 2.5}), 64, 1);
  explicit Furnace(const Shape& sphere) {
    scene.add(box({0, 0, 0}, {4, 3, 2.5}).flipped(), emitter(luminance, rho));
    scene.add(sphere, emitter(luminance, rho));
  }
  // The share that path tracing misses of the mean of those meters, which it states.
  double expect_stated_by_eye(const Sensor& meters, double expected, const char* what) {
    const Result result = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 256});
    const auto s = result.statistics(meters);
    EXPECT_GE(s.mean_standard_error_lx, 0) << what;
    EXPECT_LE(s.mean_standard_error_lx, 2e-4 * expected) << what;
    const double missing = 1 - s.mean_lx / expected, stated = stated_loss(result);
    EXPECT_NEAR(stated, missing, 0.1 * missing + 4e-4) << what;
    measured("%s: %.2f %% missing, %.2f %% stated by path tracing", what, 100 * missing, 100 * stated);
    return missing;
  }
};

TEST(Taught, TerminatorLossesInWhiteRoomsAreStated) {
  const double expected = pi_d * Furnace::luminance / (1 - Furnace::rho);
  double before = 1;
  for (const int subdivisions : {0, 2}) {
    Furnace of(smooth_sphere({2, 1.5, 1.25}, 0.8, subdivisions));
    const Sensor meters = of.scene.add_meters(of.walls.positions, of.walls.normals);
    const double missing = of.expect_stated_by_eye(meters, expected, subdivisions ? "320 faces" : "20 faces");
    const double stated =
        stated_loss(of.scene.render({.method = UPS_METHOD_UPS, .iterations = 64, .light_paths = 1u << 14}));
    EXPECT_NEAR(stated, missing, 0.1 * missing + 4e-4) << subdivisions;
    measured("%.2f %% stated by light paths", 100 * stated);
    EXPECT_GT(missing, 0.001) << "nothing to state";
    EXPECT_LT(missing, before) << "finer meshes lose less";
    before = missing;
  }
}

// Whose importance is 3/4 pi, not pi.
TEST(Taught, TerminatorLossesAreStatedOfHemisphericalMeters) {
  Furnace of(smooth_sphere({2, 1.5, 1.25}, 0.8, 0));
  of.scene.set_meter_kind(UPS_METER_HEMISPHERICAL);
  const Sensor meters = of.scene.add_meters(of.walls.positions, of.walls.normals);
  const double expected = 0.75 * pi_d * Furnace::luminance / (1 - Furnace::rho);
  EXPECT_GT(of.expect_stated_by_eye(meters, expected, "hemispherical meters"), 0.001) << "nothing to state";
}

TEST(Taught, NoTerminatorLossesAreStatedWhereThereAreNone) {
  for (const bool smooth : {false, true}) {
    Furnace of(smooth ? smooth_sphere({2, 1.5, 1.25}, 0.8, 0) : icosphere({2, 1.5, 1.25}, 0.8, 0));
    of.scene.add_meters({P3{1, 1, 0}}, {0, 0, 1});
    for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_PATH_TRACING}) {
      const Result result = of.scene.render({.method = method, .iterations = 16, .max_path_length = smooth ? 1u : 0u});
      EXPECT_EQ(result.text(UPS_TEXT_WARNINGS).find("lean from"), std::string::npos) << smooth;
    }
  }
}

}  // namespace
}  // namespace ups::test
