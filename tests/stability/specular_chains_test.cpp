// Hazard 11: light behind long chains of mirrors and total reflections, which a cap on depth or eager roulette loses. A
// square duct 25 times as long as it is wide, an emitter over all of its one end, meters at the other.
//
// Unfolded, the duct's walls become a grid of images of the emitter, seen through |i| + |j| walls:
//   E = L sum_ij R_x^|i| R_y^|j| cos^4(theta) dA / d^2,
// by the midpoint rule over the images; a distance of 25 widths makes that exact to 3e-4.
//
// Acceptance: 1 %, with standard errors of at most 0.15 %; here 0.5 %, so that an error of 1 % is found with certainty and
// a false alarm takes 3.3 standard errors, P(|t_15| > 3.3) = 0.5 % for a reading at its limit.
#include <functional>

#include "../support/expect_same.h"

namespace ups::test {
namespace {

constexpr double width = 0.08, length_m = 2, luminance = 1000;

// r(cosine to the wall's normal): what one reflection leaves. absorption: 1/m. sub: points across an image.
double through_duct(const P3& at, const std::function<double(double)>& r, double absorption, double steepest, int sub) {
  const int reach = int(steepest * length_m / width) + 1;
  const double step = width / sub;
  double sum = 0;
  std::vector<double> place;
  std::vector<int> walls;
  for (int i = -reach; i <= reach; ++i)
    for (int k = 0; k < sub; ++k) place.push_back(i * width + (k + 0.5) * step), walls.push_back(std::abs(i));
  for (size_t a = 0; a < place.size(); ++a)
    for (size_t b = 0; b < place.size(); ++b) {
      const double x = place[a] - at.x, y = place[b] - at.y, d2 = x * x + y * y + length_m * length_m, d = std::sqrt(d2);
      const double left = std::pow(r(std::abs(x) / d), walls[a]) * std::pow(r(std::abs(y) / d), walls[b]);
      sum += left * std::exp(-absorption * d) * length_m * length_m / (d2 * d2);
    }
  return luminance * sum * step * step;
}

void expect_close(double value, double standard_error, double expected, const std::string& what) {
  EXPECT_GE(standard_error, 0) << what;
  EXPECT_LE(standard_error, 0.0015 * expected) << what << ": too noisy to judge " << value;
  EXPECT_NEAR(value, expected, 0.005 * expected) << what << " +- " << standard_error;
  std::printf("  %s: %.5g +- %.2g lx, expected %.5g (%+.2f %%)\n", what.c_str(), value, standard_error, expected,
              100 * (value / expected - 1));
}

// The walls' inside, open at both ends.
Shape walls_of_duct() {
  Shape s = quad({0, 0, 0}, {0, width, 0}, {0, 0, length_m});
  s.append(quad({width, 0, 0}, {0, 0, length_m}, {0, width, 0}));
  s.append(quad({0, 0, 0}, {0, 0, length_m}, {width, 0, 0}));
  s.append(quad({0, width, 0}, {width, 0, 0}, {0, 0, length_m}));
  return s;
}
Shape lamp_over_the_end() { return quad({0, 0, 0}, {width, 0, 0}, {0, width, 0}); }

void judge(Scene& scene, const std::function<double(const P3&)>& lx) {
  const std::vector<P3> at = {{0.5 * width, 0.5 * width, length_m}, {0.1 * width, 0.7 * width, length_m}};
  const P3 back{0, 0, -1}, middle{0.5 * width, 0.5 * width, length_m};
  const Sensor points = scene.add_meters(at, back), cell = scene.add_cells({middle}, {back}, {{1, 0, 0}}, width, width);
  double expected = 0;
  const auto over = grid_about(middle, {1, 0, 0}, {0, 1, 0}, width, 2);  // it hardly varies over the cell
  for (const P3& p : over) expected += lx(p) / double(over.size());
  std::vector<double> at_points;
  for (const P3& p : at) at_points.push_back(lx(p));
  for (const ups_method method : cell_methods) {
    const bool light = method == UPS_METHOD_LIGHT_TRACING;
    const Result r = scene.render({.method = method,
                                   .iterations = light ? 32u : 32u,
                                   .light_paths = light ? 1u << 15 : 1u << 12});
    const auto of_points = r.readings(points);
    for (size_t i = 0; i < at.size() && !light; ++i)
      expect_close(of_points[i].illuminance_lx, of_points[i].standard_error_lx, at_points[i],
                   std::string(method_name(method)) + ", meter " + std::to_string(i));
    const auto of_cell = r.readings(cell)[0];
    expect_close(of_cell.illuminance_lx, of_cell.standard_error_lx, expected, std::string(method_name(method)) + ", cell");
  }
}

TEST(Hazard11, ADuctOfMirrors) {
  const double rho = 0.99;
  Scene scene;
  scene.add(walls_of_duct(), mirror(rho));
  scene.add(lamp_over_the_end(), emitter(luminance));
  judge(scene, [&](const P3& p) { return through_duct(p, [&](double) { return rho; }, 0, 20, 1); });
}

// Glass with an emitter inside: beyond the critical angle nothing is lost, and no absorption shortens the chain.
double fresnel_inside(double cosine) {
  const double n = 1.5, outside2 = 1 - n * n * (1 - cosine * cosine);
  if (outside2 <= 0) return 1;
  const double out = std::sqrt(outside2), s = (n * cosine - out) / (n * cosine + out), p = (cosine - n * out) / (cosine + n * out);
  return (s * s + p * p) / 2;
}
TEST(Hazard11, ALightGuide) {
  for (const double absorption : {0.0, 0.5}) {
    Scene scene;
    ups_material_desc rod = glass(1.5);
    for (float& a : rod.absorption_per_m_rgb) a = float(absorption);
    scene.add(box({0, 0, -0.1}, {width, width, length_m + 0.1}), rod);
    scene.add(lamp_over_the_end(), emitter(luminance));
    judge(scene, [&](const P3& p) { return through_duct(p, fresnel_inside, absorption, 3, 4); });
  }
}

}  // namespace
}  // namespace ups::test
