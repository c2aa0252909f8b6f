// Hazard 11: light behind long chains of mirrors and total reflections, which a cap on depth or eager roulette loses. A
// square duct 25 times as long as it is wide, an emitter over all of its one end, meters at the other: 40 reflections
// at 45 degrees, hundreds for what runs across.
//
// Unfolded, the duct's walls become a grid of images of the emitter. A direction from the meter that reaches the one in
// column i and row j has met |i| + |j| walls, each at its own angle:
//   E = L integral R(w_x)^|i| R(w_y)^|j| exp(-a d) cos(theta) dw.
//
// Acceptance: 1 %; here 0.5 % for means with standard errors of at most 0.15 %, so that an error of 1 % is found with
// certainty (3.3 standard errors beyond the limit); a false alarm takes 3.3, P(|t_15| > 3.3) = 0.5 % at the limit of
// noise, which only path tracing comes near to: it runs in the full form.
#include <functional>

#include "../support/expect_same.h"
#include "../support/full.h"

namespace ups::test {
namespace {

constexpr double width = 0.08, length_m = 2, luminance = 1000;

// r(cosine to the wall's normal): what one reflection leaves. By the midpoint rule over the projected hemisphere.
double through_duct(const P3& at, const std::function<double(double)>& r, double absorption) {
  constexpr int rings = 1500, sectors = 1500;
  double sum = 0;
  for (int k = 0; k < rings; ++k) {
    const double sine2 = (k + 0.5) / rings, sine = std::sqrt(sine2), cosine = std::sqrt(1 - sine2);
    for (int m = 0; m < sectors; ++m) {
      const double phi = 2 * pi_d * (m + 0.5) / sectors, x = sine * std::cos(phi), y = sine * std::sin(phi);
      const double i = std::abs(std::floor((at.x + length_m * x / cosine) / width)),
                   j = std::abs(std::floor((at.y + length_m * y / cosine) / width));
      sum += std::pow(r(std::abs(x)), i) * std::pow(r(std::abs(y)), j) * std::exp(-absorption * length_m / cosine);
    }
  }
  return luminance * pi_d * sum / (rings * sectors);
}

void expect_close(double value, double standard_error, double expected, const std::string& what) {
  expect_within(value, standard_error, expected, 0.005, 0.0015, what);
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
  const P3 back{0, 0, -1}, s{1, 0, 0}, t{0, 1, 0}, middle{0.5 * width, 0.5 * width, length_m};
  const auto at = grid_about(middle, s, t, width, 2);
  double expected = 0;  // it hardly varies over the end
  for (const P3& p : at) expected += lx(p) / double(at.size());
  const Sensor cell = scene.add_cells({middle}, {back}, {s}, width, width);
  for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_LIGHT_TRACING}) {
    const uint32_t light_paths = fast_or_full(1u << 12, 1u << 14);
    const auto r = scene.render({.method = method, .iterations = 32, .light_paths = light_paths}).readings(cell)[0];
    expect_close(r.illuminance_lx, r.standard_error_lx, expected, std::string(method_name(method)) + ", cell");
  }
  if (!full()) return;
  const Sensor points = scene.add_meters(at, back);
  const auto mean = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 192}).statistics(points);
  expect_close(mean.mean_lx, mean.mean_standard_error_lx, expected, "PT, points");
}

TEST(Hazard11, ADuctOfMirrors) {
  const double rho = 0.99;
  Scene scene;
  scene.add(walls_of_duct(), mirror(rho));
  scene.add(lamp_over_the_end(), emitter(luminance));
  judge(scene, [&](const P3& p) { return through_duct(p, [&](double) { return rho; }, 0); });
}

// Glass with an emitter inside: beyond the critical angle nothing is lost, and no absorption shortens the chain.
double fresnel_inside(double cosine) {
  const double n = 1.5, outside2 = 1 - n * n * (1 - cosine * cosine);
  if (outside2 <= 0) return 1;
  const double out = std::sqrt(outside2), s = (n * cosine - out) / (n * cosine + out),
               p = (cosine - n * out) / (cosine + n * out);
  return (s * s + p * p) / 2;
}
TEST(Hazard11, ALightGuide) {
  for (const double absorption : {0.0, 0.5}) {
    Scene scene;
    ups_material_desc rod = glass(1.5);
    for (float& a : rod.absorption_per_m_rgb) a = float(absorption);
    scene.add(box({0, 0, -0.1}, {width, width, length_m + 0.1}), rod);
    scene.add(lamp_over_the_end(), emitter(luminance));
    judge(scene, [&](const P3& p) { return through_duct(p, fresnel_inside, absorption); });
  }
}

}  // namespace
}  // namespace ups::test
