// Hazard 14. Refraction from both ends: radiance is scaled by the square of the relative index on its way through an
// interface, flux is not (Veach 1997, 5.2). Meters inside solid dielectrics, emitters inside them, slabs in between:
// path tracing, light tracing, bidirectional path tracing and photon merging measure the same, and what the closed form
// says.
#include <functional>

#include "../support/expect_same.h"
#include "../support/fresnel.h"
#include "../support/full.h"

namespace ups::test {
namespace {

// How much light of an angle passes flat interfaces, and how far aside it arrives; `bounces`: between two of them.
struct Passage {
  double share = 0, aside = 0;
};
using Layers = std::function<Passage(double angle_at_the_meter, int bounces)>;

// E at `offset` from the axis of a disc of `radius` and luminance 1, seen through flat layers that face it:
//   E = scale * int sin cos sum_k share_k phi_k d theta,
// phi_k the range of azimuths whose light comes from the disc: all points at `aside` from the meter that lie in it.
double through_layers(double offset, double radius, double scale, int bounces, const Layers& layers) {
  constexpr int steps = 1000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double a = (i + 0.5) / steps * pi_d / 2;
    for (int k = 0; k <= bounces; ++k) {
      const Passage p = layers(a, k);
      if (!(p.share > 0)) continue;
      const double c = (offset * offset + p.aside * p.aside - radius * radius) / (2 * offset * p.aside);
      sum += std::sin(a) * std::cos(a) * p.share * 2 * std::acos(std::clamp(c, -1.0, 1.0));
    }
  }
  return scale * sum * (pi_d / 2 / steps);
}

double refracted(double angle, double eta) {  // eta = n_t / n_i; NaN beyond the critical angle
  const double sine = std::sin(angle) / eta;
  return sine <= 1 ? std::asin(sine) : NAN;
}

// Points over the square about (0, 0, z), and cells that tile it.
struct Square {
  static constexpr int points_across = 16, cells_across = 16;
  double side;
  Sensor points, cells;
  double expected_points = 0, expected_cells = 0;

  Square(Scene& scene, double z, double facing, double width = 0.6) : side(width) {
    const P3 n{0, 0, facing}, x{1, 0, 0}, y{0, 1, 0};
    points = scene.add_meters(grid_about({0, 0, z}, x, y, side, points_across), n);
    const auto centers = grid_about({0, 0, z}, x, y, side, cells_across);
    cells = scene.add_cells(centers, std::vector<P3>(centers.size(), n), std::vector<P3>(centers.size(), x),
                            side / cells_across, side / cells_across);
  }
  // Both means of a function of the distance from the axis; over the square by its midpoints, 24 x 24.
  void expect(const std::function<double(double)>& lx) {
    const auto mean = [&](int n) {
      double sum = 0;
      for (const P3& p : grid_about({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, side, n)) sum += lx(std::hypot(p.x, p.y));
      return sum / (n * n);
    };
    expected_points = mean(points_across);
    expected_cells = mean(24);
  }
  // Pairs within 0.5 % (see expect_same.h); in the full form within 0.3 % whatever their noise, 3 standard errors of a
  // difference where both are at their limit of 0.07 %: then an error of 0.6 % is found in 99 cases of 100, and a pair
  // at its limit gives a false alarm with P(|t_30| > 3) = 0.5 %. Where noise falls slowly, behind rough interfaces and
  // in the cube, the limit is 0.1 %: 0.65 % is found in 99 cases, and a pair at it gives a false alarm in 4 of 100.
  void judge(Scene& scene, std::vector<Trial> trials, double full_error = 0.0007) {
    for (Trial& t : trials) t.options.iterations *= !full() ? 1 : full_error < 0.001 ? 4 : 2;
    expect_same(scene, trials, points, cells, expected_points, expected_cells,
                full() ? Limits{full_error, 0.003, 0} : usual);
  }
};
constexpr double costly = 0.001;  // limit of noise in the full form

constexpr double luminance = 1000, lamp_radius = 0.5;
Shape lamp(double z, double facing) { return disc({0, 0, z}, {0, 0, facing}, lamp_radius, 512); }

// Without a rough surface bidirectional path tracing has nothing to join and is path tracing, and merging alone is PPM.
// Iterations are those that standard errors of 0.15 % take, so that no render is repeated.
struct Iterations {
  uint32_t pt, lt, ups, ppm, bpt = 0, merging = 0;
};
std::vector<Trial> smooth_trials(double merge_radius,
                                 const Iterations& n = {.pt = 32, .lt = 20, .ups = 32, .ppm = 24}) {
  return {trial(UPS_METHOD_PATH_TRACING, n.pt), trial(UPS_METHOD_LIGHT_TRACING, n.lt, 1u << 15),
          trial(UPS_METHOD_UPS, n.ups, 1u << 13, merge_radius), trial(UPS_METHOD_PPM, n.ppm, 1u << 15, merge_radius)};
}
std::vector<Trial> rough_trials(const Iterations& n) {
  return {trial(UPS_METHOD_PATH_TRACING, n.pt),         trial(UPS_METHOD_LIGHT_TRACING, n.lt, 1u << 15),
          trial(UPS_METHOD_BIDIRECTIONAL, n.bpt),       trial(UPS_METHOD_UPS, n.ups, 1u << 12, 0.03),
          trial(UPS_METHOD_PPM, n.ppm, 1u << 15, 0.03), merge_only(n.merging, 1u << 13, 0.04)};
}

// A meter d below a water surface, a lamp h above it: L in the water is n^2 T L.
TEST(Hazard14, MetersUnderWater) {
  constexpr double n = 1.33, h = 0.1, d = 0.15;
  Scene scene;
  scene.add(quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}), glass(n));
  scene.add(lamp(h, -1), emitter(luminance));
  Square square(scene, -d, 1);
  square.expect([&](double offset) {
    return through_layers(offset, lamp_radius, luminance * n * n, 0, [&](double a, int) -> Passage {
      const double out = refracted(a, 1 / n);
      if (!std::isless(out, pi_d / 2)) return {};
      return {1 - fresnel(std::cos(a), 1 / n), d * std::tan(a) + h * std::tan(out)};
    });
  });
  square.judge(scene, smooth_trials(0.04));
}

// What lands on cells is the same light, counted alike, for light tracing and PPM.
TEST(Hazard14, PpmCountsOnCellsWhatLightTracingCounts) {
  Scene scene;
  scene.add(quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}), glass(1.33));
  scene.add(lamp(0.1, -1), emitter(luminance));
  const Square square(scene, -0.15, 1);
  const double landed =
      scene.render(trial(UPS_METHOD_LIGHT_TRACING, 4, 1u << 13).options).statistics(square.cells).mean_lx;
  EXPECT_GT(landed, 0);
  EXPECT_EQ(scene.render(trial(UPS_METHOD_PPM, 4, 1u << 13).options).statistics(square.cells).mean_lx, landed);
}

// The lamp in the water, the meter in the air: L in the air is T L / n^2.
TEST(Hazard14, LampUnderWater) {
  constexpr double n = 1.33, h = 0.1, d = 0.15;
  Scene scene;
  scene.add(quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}), glass(n));
  scene.add(lamp(-d, 1), emitter(luminance));
  Square square(scene, h, -1);
  square.expect([&](double offset) {
    return through_layers(offset, lamp_radius, luminance / (n * n), 0, [&](double a, int) -> Passage {
      return {1 - fresnel(std::cos(a), n), h * std::tan(a) + d * std::tan(refracted(a, n))};
    });
  });
  square.judge(scene, smooth_trials(0.04));
}

// An absorbing slab of glass between lamp and meter, reflections between its faces included.
TEST(Hazard14, SlabBetween) {
  constexpr double n = 1.5, thickness = 0.1, h = 0.05, d = 0.1, absorption = 2;
  Scene scene;
  ups_material_desc block = glass(n);
  for (float& a : block.absorption_per_m_rgb) a = absorption;
  scene.add(box({-5, -5, 0}, {5, 5, thickness}), block);
  scene.add(lamp(thickness + h, -1), emitter(luminance));
  Square square(scene, -d, 1);
  square.expect([&](double offset) {
    return through_layers(offset, lamp_radius, luminance, 4, [&](double a, int k) -> Passage {
      const double inside = refracted(a, n), r = fresnel(std::cos(a), n), way = (1 + 2 * k) * thickness;
      return {(1 - r) * (1 - r) * std::pow(r, 2 * k) * std::exp(-absorption * way / std::cos(inside)),
              (d + h) * std::tan(a) + way * std::tan(inside)};
    });
  });
  square.judge(scene, smooth_trials(0.04));
}

// A solid cube under a sky of luminance L on all sides: inside, every direction that can leave has the radiance n^2 L,
// whatever it met on its way (Snell's law conserves L / n^2, and all light comes from the sky). Directions whose three
// components are all below sqrt(1 - 1/n^2) are reflected totally for ever and are dark.
TEST(Hazard14, MetersInACubeUnderASky) {
  constexpr double n = 1.5;
  Scene scene;
  scene.add(box({-0.5, -0.5, -0.5}, {0.5, 0.5, 0.5}), glass(n));
  scene.add(box({-0.55, -0.55, -0.55}, {0.55, 0.55, 0.55}).flipped(), emitter(luminance));
  Square square(scene, -0.2, 1, 0.9);
  const double limit = std::sqrt(1 - 1 / (n * n));
  constexpr int steps = 2000;
  double seen = 0;  // over the projected hemisphere
  for (int i = 0; i < steps; ++i)
    for (int j = 0; j < steps; ++j) {
      const double r = std::sqrt((i + 0.5) / steps), phi = 2 * pi_d * (j + 0.5) / steps;
      seen += std::max({r * std::abs(std::cos(phi)), r * std::abs(std::sin(phi)), std::sqrt(1 - r * r)}) > limit;
    }
  square.expect([&](double) { return pi_d * n * n * luminance * seen / steps / steps; });
  square.judge(scene, smooth_trials(0.06, {.pt = 18, .lt = 40, .ups = 34, .ppm = 40}), costly);
}

// The same water, ground: no closed form, but the two walks must agree on what a rough interface lets through.
TEST(Hazard14, MetersUnderRoughWater) {
  Scene scene;
  scene.add(quad({-5, -5, 0}, {10, 0, 0}, {0, 10, 0}), glass(1.33, 0.4));
  scene.add(lamp(0.1, -1), emitter(luminance));
  Square(scene, -0.15, 1).judge(
      scene, rough_trials({.pt = 48, .lt = 16, .ups = 32, .ppm = 20, .bpt = 48, .merging = 48}), costly);
}
TEST(Hazard14, RoughAbsorbingSlabBetween) {
  Scene scene;
  ups_material_desc block = glass(1.5, 0.4);
  for (float& a : block.absorption_per_m_rgb) a = 15;
  scene.add(box({-5, -5, 0}, {5, 5, 0.1}), block);
  scene.add(lamp(0.15, -1), emitter(luminance));
  Square(scene, -0.1, 1).judge(
      scene, rough_trials({.pt = 30, .lt = 80, .ups = 70, .ppm = 120, .bpt = 40, .merging = 140}), costly);
}

}  // namespace
}  // namespace ups::test
