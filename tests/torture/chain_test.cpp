// Chains of total reflection and of mirrors, whose light is known by unfolding them: integrals without a scene.
#include "../support/fresnel.h"
#include "torture.h"

namespace ups::test {
namespace {

// Of as many rays as give a mean to 1e-4: their place in the unit square, their direction of a Lambertian emitter along
// +Z as (tan x, tan y, cosine). Points of an additive recurrence (Roberts 2018).
template <class Weight>
double mean_over_rays(const Weight& weight) {
  constexpr int count = 1 << 20;
  constexpr double g = 1.1673039782614187;  // g^5 = g + 1
  double sum = 0;
  for (int i = 1; i <= count; ++i) {
    const auto u = [&](int k) { return std::fmod(0.5 + i / std::pow(g, k), 1.0); };
    const double sine2 = u(3), angle = 2 * pi_d * u(4), tangent = std::sqrt(sine2 / (1 - sine2));
    sum += weight(u(1), u(2), tangent * std::cos(angle), tangent * std::sin(angle), std::sqrt(1 - sine2));
  }
  return sum / count;
}

bool is_in(double x, double from, double to) { return x >= from && x <= to; }

// Where a path that walls at 0 and `side` throw back is, and its slope there.
struct Folded {
  double at, slope;
};
Folded fold(double x, double slope, double side) {
  const double turns = std::floor(x / side), rest = x - turns * side;
  return std::fmod(std::abs(turns), 2) < 0.5 ? Folded{rest, slope} : Folded{side - rest, -slope};
}

// E / (pi L) over cells as wide as the rod, `gap` beyond its end; the emitter is as wide and as far before its other
// end. All that enters is guided, to and fro between the ends, and leaves at the angle at which it came.
double guided(double side, double length, double gap, double ior) {
  return mean_over_rays([&](double u, double v, double tx, double ty, double cosine) {
    const double x = side * u + gap * tx, y = side * v + gap * ty;
    if (!is_in(x, 0, side) || !is_in(y, 0, side)) return 0.0;
    const double r = fresnel(cosine, ior), inside = std::sqrt(1 - (1 - cosine * cosine) / (ior * ior)),
                 slower = cosine / (ior * inside);  // tangent inside over outside
    double sum = 0, weight = (1 - r) * (1 - r);
    for (int ways = 1; weight > 1e-7; ways += 2, weight *= r * r) {
      const Folded a = fold(x + ways * length * slower * tx, tx, side),
                   b = fold(y + ways * length * slower * ty, ty, side);
      if (is_in(a.at + gap * a.slope, 0, side) && is_in(b.at + gap * b.slope, 0, side)) sum += weight;
    }
    return sum;
  });
}

// Of a rod of glass, 10 mm by 10 mm by 1 m, between an emitter and cells: total reflection guides all that enters, by
// paths of a hundred edges and more. The fast form's rod is a fifth as long.
TEST(Torture, ALightGuideOfGlass) {
  constexpr double side = 0.01, luminance = 1e6;
  const double length = fast_or_full(0.2, 1.0);
  Scene scene;
  scene.add(box({0, 0, 0}, {side, side, length}), glass(1.5));
  scene.add(quad({0, 0, -0.001}, {side, 0, 0}, {0, side, 0}), emitter(luminance));
  const Sensor end = add_cells(scene, {0, 0, length + 0.001}, {0, side, 0}, {side, 0, 0}, 4);
  add_small_camera(scene, {0.005, 0.005, length + 0.2}, {0, 0, -1});
  scene.add_goniometer(4, 19);
  survive("light guide of glass", scene,
          {{.meters = end, .truth_lx = pi_d * luminance * guided(side, length, 0.001, 1.5), .truth_error = 5e-4}},
          {.iterations = 48, .balance_error = 0.01});
}

// Of a mirror's reflectance to the power of the reflections; by symmetry each axis has its own mean over the places.
double through_duct(double side, double length, double reflectance) {
  const auto along = [&](double tangent) {
    const double way = length * std::abs(tangent) / side, whole = std::floor(way);
    return std::pow(reflectance, whole) * (1 - (way - whole) * (1 - reflectance));
  };
  return mean_over_rays([&](double, double, double tx, double ty, double) { return along(tx) * along(ty); });
}

// 50 mm by 50 mm by 1 m, the emitter at one end, cells at the other.
TEST(Torture, ADuctOfMirrorsThatLoseAThousandth) {
  constexpr double side = 0.05, luminance = 1e4, reflectance = 0.999;
  Scene duct;
  for (const Shape& wall : {quad({0, 0, 0}, {0, side, 0}, {0, 0, 1}), quad({side, 0, 0}, {0, 0, 1}, {0, side, 0}),
                            quad({0, 0, 0}, {0, 0, 1}, {side, 0, 0}), quad({0, side, 0}, {side, 0, 0}, {0, 0, 1})})
    duct.add(wall, mirror(reflectance));
  duct.add(quad({0, 0, 0}, {side, 0, 0}, {0, side, 0}), emitter(luminance));
  const Sensor end = add_cells(duct, {0, 0, 1}, {0, side, 0}, {side, 0, 0}, 4);
  add_small_camera(duct, {0.025, 0.025, 1.2}, {0, 0, -1});
  survive("duct of mirrors", duct, {{end, pi_d * luminance * through_duct(side, 1, reflectance), 2e-4}},
          {.sppm_factor = fast_or_full(4u, 8u), .balance_error = 0.01});
}

// E / (pi L) over cells at x = 0.3, 3.6 m wide, from an emitter of 2 m at 0.15, between mirrors of 4 m at 0 and 0.5.
double between_mirrors(double reflectance) {
  const double emitter_over_cells = 4 / (3.6 * 3.6);
  return emitter_over_cells * mean_over_rays([&](double u, double v, double ty, double tz, double) {
           const auto is_within = [&](double way, double from, double to) {
             return is_in(1 + 2 * u + way * ty, from, to) && is_in(1 + 2 * v + way * tz, from, to);
           };
           double sum = 0, weight = 1;
           // Up past the cells, back from 0.5, past the emitter, back from 0, past the emitter's back: 1 m a round.
           for (double way = 0;; way += 1) {
             if (is_within(way + 0.15, 0.2, 3.8)) sum += weight;
             if (!is_within(way + 0.35, 0, 4) || is_within(way + 0.7, 1, 3) || !is_within(way + 0.85, 0, 4) ||
                 is_within(way + 1, 1, 3))
               return sum;
             weight *= reflectance * reflectance;
           }
         });
}

TEST(Torture, FacingMirrorsThatLoseAThousandth) {
  Scene scene;
  scene.add(quad({0, 0, 0}, {0, 4, 0}, {0, 0, 4}), mirror(0.999));
  scene.add(quad({0.5, 0, 0}, {0, 0, 4}, {0, 4, 0}), mirror(0.999));
  scene.add(quad({0.15, 1, 1}, {0, 2, 0}, {0, 0, 2}), emitter(1e4));
  const Sensor between = add_cells(scene, {0.3, 0.2, 0.2}, {0, 0, 3.6}, {0, 3.6, 0}, 4);
  add_small_camera(scene, {0.25, 0.5, 0.5}, {-1, 0.3, 0.3});
  survive("facing mirrors", scene, {{between, pi_d * 1e4 * between_mirrors(0.999), 2e-4}});
}

}  // namespace
}  // namespace ups::test
