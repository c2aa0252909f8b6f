// Hazard 4, through the whole engine: a furnace in which everything emits or absorbs nothing has one illuminance, E =
// pi L / (1 - rho), however rough the metal and the glass in it are. A lobe that one walk takes for a delta lobe and
// the other does not would show.
#include "../support/expect_same.h"
#include "../support/full.h"

namespace ups::test {
namespace {

class Hazard04 : public ::testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Alphas, Hazard04, ::testing::Values(1e-2, 1e-4, 3.1e-5, 1e-5), [](const auto& i) {
  return "of_" + std::to_string(std::lround(1e7 * i.param)) + "e_7";
});

// Within 0.5 % at standard errors of at most 0.17 %: errors of 1 % are found in 995 cases of 1000; a false alarm takes
// 3 standard errors, P(|t_15| > 3) = 0.9 % where one is at its limit.
TEST_P(Hazard04, AFurnaceHasOneIlluminance) {
  if (!full() && !low_effort() && GetParam() > 1e-3) GTEST_SKIP() << "in the full form";
  const double rho = 0.5, luminance = 100, expected = pi_d * luminance / (1 - rho), roughness = std::sqrt(GetParam());
  Scene scene;
  scene.add(icosphere({0, 0, 0}, 1, 3).flipped(), emitter(luminance, rho));
  scene.add(box({-0.6, -0.2, -0.3}, {-0.3, 0.2, 0.1}), rough(UPS_MATERIAL_METAL, 1, roughness));
  scene.add(box({0.3, -0.2, -0.3}, {0.6, 0.2, 0.1}), glass(1.5, roughness));
  const std::vector<P3> at = {{0, 0, 0}, {-0.45, 0, 0.2}, {0.45, 0, 0.2}, {0.1, 0.1, -0.2}};
  const std::vector<P3> normals = {{-1, 0, 0}, {0, 0, -1}, {0, 0, -1}, {1, 0, 0}};
  const std::vector<P3> tangents = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  const Sensor points = scene.add_meters(at, normals), cells = scene.add_cells(at, normals, tangents, 0.3, 0.3);
  for (const ups_method method : {UPS_METHOD_PATH_TRACING, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_UPS}) {
    const bool light = method == UPS_METHOD_LIGHT_TRACING, unified = method == UPS_METHOD_UPS;
    const Result r = scene.render({.method = method,
                                   .iterations = unified ? 64u : 128u,
                                   .merge_radius_m = 0.01,
                                   .light_paths = light ? 1u << 15 : 1u << 11});
    const auto judge = [&](const Sensor& set, const std::string& what) {
      const auto s = r.statistics(set);
      EXPECT_GT(s.mean_standard_error_lx, 0) << what;
      expect_within(s.mean_lx, s.mean_standard_error_lx, expected, 0.005, 0.0017, what);
    };
    judge(cells, std::string(method_name(method)) + ", cells");
    if (!light) judge(points, std::string(method_name(method)) + ", points");
  }
}

}  // namespace
}  // namespace ups::test
