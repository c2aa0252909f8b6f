// Hazard 12: series that are cut short. In a closed sphere of reflectance rho light goes round 1 / (1 - rho) times on
// the average: ten bounces at 0.95 lose 60 % of it.
//
// The wall itself emits, Phi = pi L A in all, so that E = Phi / (A (1 - rho)) = pi L / (1 - rho) at every place and in
// every direction, of the mesh as of the sphere; and a path's every vertex brings as much as any other, so that the
// length of paths is all the noise there is. By every subset of techniques that can carry all light without blur: with
// emitter hits or next-event estimation, cells also with light that lands; at points also by photons on the meters' own
// discs, and by merging alone, which the mesh's edges blur by some tenths of a percent.
//
// Within 0.3 %, at standard errors of at most 0.1 %: an error of 0.6 % is found in 99 cases of 100, of 1 % with
// certainty. False alarms take 3 standard errors at the limit of noise: P(|t| > 3) is 2.0 % of 8 batches, 1.2 % of 12 and
// 0.9 % of 16.
//
// One number decides how long a path gets (PathSampler::roulette): lengths are stratified, which leaves little noise.
#include "../support/expect_lx.h"
#include "../support/full.h"
#include "../support/image_mean.h"

namespace ups::test {
namespace {

constexpr double tolerance = 0.003, largest_noise = 0.001;
constexpr uint32_t both_ends = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE;
constexpr uint32_t of_points = both_ends | UPS_TECHNIQUE_CONNECT | UPS_TECHNIQUE_MERGE;
constexpr uint32_t of_cells = of_points | UPS_TECHNIQUE_SENSOR_HIT;

struct Sphere {
  static constexpr double luminance = 100, side = 0.5;
  Scene scene;
  const double rho, balance;
  explicit Sphere(double reflectance) : rho(reflectance), balance(pi_d * luminance / (1 - rho)) {
    scene.add(icosphere({0, 0, 0}, 1, 4).flipped(), emitter(luminance, rho));
  }
  const Points points = points_inside(icosphere({0, 0, 0}, 0.5, 2), 16, 1);
  Sensor add_points() { return scene.add_meters(points.positions, points.normals); }
  Sensor add_cells() {
    std::vector<P3> tangents;
    for (const P3& n : points.normals)
      tangents.push_back(normalize(cross(n, std::abs(n.x) < 0.5 ? P3{1, 0, 0} : P3{0, 1, 0})));
    return scene.add_cells(points.positions, points.normals, tangents, side, side);
  }

  // As many iterations as the noise asks for. (Stated errors are those of the last render.)
  void expect(const Sensor& meters, uint32_t subset) {
    const uint32_t landing = rho > 0.94 ? 1u << 11 : 1u << 12;
    const bool by_eye = subset & both_ends, quiet = by_eye && !(subset & UPS_TECHNIQUE_CONNECT);
    const uint32_t merging = subset & UPS_TECHNIQUE_MERGE ? 1u << 11 : 1u << 7;  // so that its weights count, if judged
    RenderOptions options{.iterations = quiet ? 8u : by_eye ? 12u : 16u, .merge_radius_m = 0.01,
                          .light_paths = low_effort() ? 1u << 7 : by_eye ? merging : landing, .techniques = subset};
    const std::string what = "subset " + std::to_string(subset);
    const Result result = render_until_quiet(scene, options, 16u << 8, [&](const Result& r) {
      return r.statistics(meters).mean_standard_error_lx / (largest_noise * balance);
    });
    EXPECT_EQ(result.info().techniques, subset) << what;
    const auto s = result.statistics(meters);
    EXPECT_GT(s.mean_standard_error_lx, 0) << what;
    expect_within(s.mean_lx, s.mean_standard_error_lx, balance, tolerance, largest_noise, what);
  }
};

class Hazard12 : public ::testing::TestWithParam<int> {
 protected:
  void SetUp() override {
    if (GetParam() != 50 && GetParam() != 95 && !full() && !low_effort()) GTEST_SKIP() << "in the full form";
  }
  // The fast form has no merging, and over cells only what emitter hits are a part of: the rest takes most of the time.
  // Over cells, what does not land there comes to the same as at points.
  void expect_all(Sphere& sphere, const Sensor& meters, uint32_t all, uint32_t complete) {
    if (!full()) all &= ~UPS_TECHNIQUE_MERGE;
    for (uint32_t subset = 1; subset <= all; ++subset)
      if ((subset & complete) && !(subset & ~all)) sphere.expect(meters, subset);
  }
};
INSTANTIATE_TEST_SUITE_P(Reflectances, Hazard12, ::testing::Values(50, 90, 95, 98),
                         [](const auto& i) { return "rho_0" + std::to_string(i.param); });

TEST_P(Hazard12, EverySubsetOfTechniquesReachesTheEnergyBalanceAtPoints) {
  Sphere sphere(0.01 * GetParam());
  expect_all(sphere, sphere.add_points(), of_points, both_ends);
}
TEST_P(Hazard12, EverySubsetOfTechniquesReachesTheEnergyBalanceOverCells) {
  Sphere sphere(0.01 * GetParam());
  const uint32_t complete = full() ? uint32_t(UPS_TECHNIQUE_SENSOR_HIT) : uint32_t(UPS_TECHNIQUE_EMITTER_HIT);
  expect_all(sphere, sphere.add_cells(), of_cells, complete);
}

// What a camera in the middle sees of the wall, L / (1 - rho) everywhere (less L where no path of the eye may end on
// emitters): by every subset that has light paths end in its pixels. Within 0.3 % or three standard errors, of at most
// 0.2 %: an error of 1 % is found in 97 of 100 cases; P(|t_7| > 3) = 2 % for each comparison at the limit of noise.
TEST_P(Hazard12, EverySubsetWithLightThatEndsInPixelsReachesTheEnergyBalance) {
  if (GetParam() != 50 && !full() && !low_effort()) GTEST_SKIP() << "in the full form";
  Sphere sphere(0.01 * GetParam());
  const Sensor camera = sphere.scene.add_camera({0.1, 0.05, -0.1}, {1, 0.3, 0.2}, 16, 16, 1);
  for (uint32_t others = 0; others <= of_points; ++others) {
    if (others & ~of_points) continue;
    const uint32_t subset = others | UPS_TECHNIQUE_SENSOR_CONNECT;
    const uint32_t landing = sphere.rho < 0.6 ? 1u << 14 : sphere.rho < 0.92 ? 1u << 13 : 1u << 11;
    RenderOptions options{.method = UPS_METHOD_UPS, .iterations = sphere.rho < 0.94 ? 16u : 24u, .merge_radius_m = 0.01,
                          .light_paths = subset & both_ends ? 1u << 10 : landing, .techniques = subset};
    if (low_effort()) options.light_paths = 1u << 7;
    const Mean m = image_mean(sphere.scene, camera, options);
    const double expected = sphere.balance / pi_d - (subset & UPS_TECHNIQUE_EMITTER_HIT ? 0 : Sphere::luminance);
    expect_within(m.value, m.standard_error, expected, std::max(tolerance, 3 * m.standard_error / expected), 0.002,
                  "picture, subset " + std::to_string(subset));
  }
}

// Photons that land on the meters' own discs and nothing else, whose light is alike all over them: by SPPM.
TEST_P(Hazard12, LightThatLandsOnTheMetersReachesTheEnergyBalance) {
  if (GetParam() != 50 && !full() && !low_effort()) GTEST_SKIP() << "in the full form";
  Sphere sphere(0.01 * GetParam());
  const Sensor points = sphere.add_points();
  RenderOptions options{.method = UPS_METHOD_SPPM, .iterations = 16, .merge_radius_m = 0.2, .light_paths = 1u << 12};
  const auto s = render_until_quiet(sphere.scene, options, 16u << 8, [&](const Result& r) {
                   return r.statistics(points).mean_standard_error_lx / (largest_noise * sphere.balance);
                 }).statistics(points);
  expect_within(s.mean_lx, s.mean_standard_error_lx, sphere.balance, tolerance, largest_noise, "SPPM");
}

// Merging alone, also with connections, at the meters and on the wall, within discs in which it is hardly bent. Many
// meters, whose eye paths meet the same photons.
TEST_P(Hazard12, LightThatIsMergedReachesTheEnergyBalance) {
  if (!full() && !low_effort()) GTEST_SKIP() << "in the full form";
  Sphere sphere(0.01 * GetParam());
  const Points many = points_inside(icosphere({0, 0, 0}, 0.5, 2), low_effort() ? 4 : GetParam() == 98 ? 128 : 512, 1);
  const Sensor points = sphere.scene.add_meters(many.positions, many.normals);
  const double radius = GetParam() == 50 ? 0.1 : GetParam() == 98 ? 0.02 : 0.03;
  for (const uint32_t with : {0u, uint32_t(UPS_TECHNIQUE_CONNECT)}) {
    RenderOptions options{.iterations = 16, .merge_radius_m = radius, .light_paths = 1u << 12,
                          .techniques = UPS_TECHNIQUE_MERGE | with};
    const auto s = render_until_quiet(sphere.scene, options, 16u << 6, [&](const Result& r) {
                     return r.statistics(points).mean_standard_error_lx / (largest_noise * sphere.balance);
                   }).statistics(points);
    expect_within(s.mean_lx, s.mean_standard_error_lx, sphere.balance, tolerance, largest_noise,
                  "subset " + std::to_string(options.techniques));
  }
}

// Around a point source: its flux over the mesh's own area. Roulette alone makes noise, as every point of the wall gets
// the same light straight from the source, within what the facets lean: hence the mean over 16 points. As above; P(|t_15| >
// 3) = 0.9 % at the limit of noise.
class Hazard12PointSource : public ::testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Reflectances, Hazard12PointSource, ::testing::Values(50, 90, 95, 98),
                         [](const auto& i) { return "rho_0" + std::to_string(i.param); });
TEST_P(Hazard12PointSource, ReachesTheEnergyBalance) {
  if (!full() && !low_effort() && GetParam() > 90) GTEST_SKIP() << "in the full form";
  constexpr double flux_lm = 10000;
  const double rho = 0.01 * GetParam();
  const Shape wall = icosphere({0, 0, 0}, 1, 4);
  const Points points = points_inside(wall, 16, 1);
  Scene scene;
  scene.add(wall, matte(rho));
  scene.add_point_light({0, 0, 0}, flux_lm / (4 * pi_d));
  const Sensor meters = scene.add_meters(points.positions, points.normals);
  const double expected = flux_lm / (wall.area() * (1 - rho));
  for (const ups_method method : eye_methods) {
    if (method == UPS_METHOD_BIDIRECTIONAL && GetParam() > 90) continue;  // nothing merges here: UPS gives the same bits
    RenderOptions options{.method = method, .iterations = 16, .light_paths = 1u << 11};
    const Result result = render_until_quiet(scene, options, 16u << 4, [&](const Result& r) {
      return r.statistics(meters).mean_standard_error_lx / (largest_noise * expected);
    });
    const auto s = result.statistics(meters);
    expect_within(s.mean_lx, s.mean_standard_error_lx, expected, tolerance, largest_noise, method_name(method));
    EXPECT_NEAR(result.info().emitted_flux_lm, flux_lm, 1e-5 * flux_lm);
  }
}

}  // namespace
}  // namespace ups::test
