// Cells that are not square, under a point light: the mean over their area, by eye paths that start all over them and
// by light paths that land on them: six comparisons as in expect_lx.h, with its false alarms and what it finds.
#include "../support/expect_lx.h"

namespace ups::test {
namespace {

TEST(OblongCells, MeasureTheMeanOverTheirArea) {
  constexpr double candela = 1000, width = 0.8, height = 0.2;
  const std::vector<P3> centers = {{0.4, 0.1, 0}, {-0.3, 0.5, 0}};
  Scene scene;
  scene.add(quad({-2, -2, -0.5}, {4, 0, 0}, {0, 4, 0}), matte(0));
  scene.add_point_light({0, 0, 1}, candela);
  const Sensor cells = scene.add_cells(centers, {2, P3{0, 0, 1}}, {2, P3{1, 0, 0}}, width, height);
  for (const ups_method method : {UPS_METHOD_PATH_TRACING, UPS_METHOD_LIGHT_TRACING, UPS_METHOD_UPS}) {
    const Result result = scene.render({.method = method, .iterations = 64, .light_paths = 1u << 15});
    for (size_t i = 0; i < centers.size(); ++i) {
      constexpr int n = 100;
      double expected = 0;
      for (int a = 0; a < n; ++a)
        for (int b = 0; b < n; ++b) {
          const double x = centers[i].x + ((a + 0.5) / n - 0.5) * width,
                       y = centers[i].y + ((b + 0.5) / n - 0.5) * height;
          expected += candela * std::pow(1 + x * x + y * y, -1.5) / (n * n);
        }
      expect_lx(result.readings(cells)[i], expected, quiet, std::string(method_name(method)) + std::to_string(i));
    }
  }
}

}  // namespace
}  // namespace ups::test
