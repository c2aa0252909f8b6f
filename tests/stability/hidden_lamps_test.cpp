// Lamps whose light eye paths hardly ever meet, where something else makes them look harmless: `auto` must take light
// paths for them. Another lamp in view hides in the stated error what is missing.
#include "../support/expect_same.h"
#include "../support/figures.h"
#include "../support/fresnel.h"

namespace ups::test {
namespace {

ups_material_desc diffuser(double transmittance) {
  ups_material_desc m = material(UPS_MATERIAL_DIFFUSER, 0);
  std::fill(std::begin(m.transmittance_rgb), std::end(m.transmittance_rgb), float(transmittance));
  return m;
}
Shape walls() { return box({-3, -3, 0}, {3, 3, 3}).flipped(); }

// The mean of 64 meters below the lamp, by expect_lx.h: 1 % is found. lx: at a place so far from right below.
template <class Lx>
void expect_auto(Scene& scene, const P3& below, const Lx& lx, const std::string& what) {
  const std::vector<P3> at = grid_about(below, {1, 0, 0}, {0, 1, 0}, 1.6, 8);
  const Sensor meters = scene.add_meters(at, {0, 0, 1});
  double expected = 0;
  for (const P3& p : at) expected += lx(p) / double(at.size());
  const auto s = scene.render({.method = UPS_METHOD_AUTO, .iterations = 256}).statistics(meters);
  measured("%s: bound of the mean %.2f %%", what.c_str(), 100 * s.mean_error_bound_lx / expected);
  EXPECT_LE(std::abs(s.mean_lx - expected), 2 * s.mean_error_bound_lx) << what;
  expect_lx(s.mean_lx, s.mean_standard_error_lx, expected, quiet, what);
}

// A lamp of 2 cm right behind a diffuser in a room without windows; the sun outside, whose flux is that of the whole
// scene's disc (before: lamps of less than a ten-thousandth of that were not looked at, and 0.01 of 20 lx found). Right
// below E = tau flux / (pi d^2).
TEST(Taught, ASunOutsideHidesNoLampBehindADiffuser) {
  const double luminance = 5e5, radius = 0.01, distance = 2, transmittance = 0.5;
  constexpr int corners = 64;
  const double area = radius * radius * corners / 2 * std::sin(2 * pi_d / corners);
  for (const bool sun : {false, true}) {
    Scene scene;
    scene.add(walls(), matte(0));
    scene.add(disc({0, 0, 2.5001}, {0, 0, -1}, radius, corners), emitter(luminance));
    scene.add(quad({-0.1, -0.1, 2.5}, {0.2, 0, 0}, {0, 0.2, 0}), diffuser(transmittance));
    if (sun) scene.add_directional({0.3, 0.2, -1}, 1e5);
    const auto lx = [=](const P3& p) {  // with both cosines
      const double d2 = p.x * p.x + p.y * p.y + distance * distance;
      return transmittance * luminance * area * distance * distance / (d2 * d2);
    };
    expect_auto(scene, {0, 0, 0.5}, lx, sun ? "with a sun" : "without");
  }
}

// A lamp in a bulb in a shade, both of which scatter: what the bulb sends on sees the shade, and only that the room
// (before: 9 of 59 lx missing within a bound of 1 %). Both spheres are lit evenly: a Lambertian sphere's flux goes
// evenly to all sides.
TEST(Taught, ALampInABulbInAShadeIsNotMissed) {
  const double candela = 100, bulb = 0.8, shade = 0.6, down = 2, beside = 300;
  Scene scene;
  scene.add(walls(), matte(0));
  const P3 lamp{0, 0, 2.5}, other{1, 0, 2.5};
  scene.add_point_light(lamp, candela);
  scene.add(icosphere(lamp, 0.01, 4), diffuser(bulb));
  scene.add(icosphere(lamp, 0.04, 4), diffuser(shade));
  scene.add_point_light(other, beside);
  const auto lx = [&](const P3& p) {
    return down * (bulb * shade * candela / std::pow(length(lamp - p), 3) + beside / std::pow(length(other - p), 3));
  };
  expect_auto(scene, lamp - P3{0, 0, down}, lx, "bulb in a shade");
}

// A cell that a small mirror lights by a fifth, where eye paths may carry that light, too, but hardly ever do: a lamp of
// 4 mm and a mirror, a point and a plate of polished metal, also of one that is no pure metal.
class SmallMirrorOnACell {
 public:
  enum Kind { small_lamp, metal, mostly_metal };
  static constexpr double metallic = 0.95, reflectance = 0.95;

  // What the mirror brings of the lamp, whose image is 5 m away and 3.7 m above; roughness scatters little beyond it.
  static double by_mirror(Kind kind) { return mirrored(kind) * candela * 3.7 / std::pow(5 * 5 + 3.7 * 3.7, 1.5); }
  // And of the ceiling, on which the lamp's light, half a metre below, is bright where the mirror shows it. The small
  // lamp lights no ceiling.
  static double ceiling_in_mirror(Kind kind) {
    if (kind == small_lamp) return 0;
    const double slope = 2.96 / 4, above = 0.5, lx = candela * above / std::pow(std::hypot(above / slope, above), 3);
    const double d2 = 1 + slope * slope, solid_angle = size * size / (d2 * std::sqrt(d2));
    return mirrored(kind) * 0.5 / pi_d * lx * solid_angle * slope / std::sqrt(d2);
  }
  static ups_meter_reading read(Kind kind, bool with_mirror, double roughness, uint32_t iterations, uint64_t seed) {
    const bool has_extent = kind == small_lamp;
    ups_material_desc plate = has_extent      ? photon_mirror(reflectance)
                              : kind == metal ? rough(UPS_MATERIAL_METAL, reflectance, roughness)
                                              : rough(UPS_MATERIAL_PLASTIC, reflectance, roughness);
    if (kind == mostly_metal) plate.metallic = float(metallic);
    Scene scene;
    scene.add(box({-5, -5, 0}, {5, 5, 5}).flipped(), matte(0.5));
    if (with_mirror) scene.add(quad({-1, -size / 2, 1.54 - size / 2}, {0, size, 0}, {0, 0, size}), plate);
    const double area = radius * radius * corners / 2 * std::sin(2 * pi_d / corners);
    const P3 lamp{3, 0, 4.5};
    if (has_extent)
      scene.add(disc(lamp, normalize(P3{-1, 0, 1.54} - lamp), radius, corners), emitter(candela / area));
    else
      scene.add_point_light(lamp, candela);
    const Sensor cell = scene.add_cells({{0, 0, 0.8}}, {{0, 0, 1}}, {{1, 0, 0}}, size, size);
    const Result result = scene.render({.method = UPS_METHOD_AUTO, .iterations = iterations, .seed = seed});
    if (with_mirror) {
      EXPECT_TRUE(result.choice(cell).techniques & UPS_TECHNIQUE_SENSOR_HIT) << "kind " << kind;
    }
    return result.readings(cell)[0];
  }

 private:
  static double mirrored(Kind kind) {
    const double coat = (1 - metallic) * fresnel(1 / std::hypot(1, 0.74), 1.5);
    return kind == mostly_metal ? metallic * reflectance + coat : reflectance;
  }
  static constexpr double candela = 800, size = 0.05, radius = 0.002;
  static constexpr int corners = 16;
};

// `auto` lets light land there (before: with some seeds none of it was found, or a tenth, within bounds of less). That
// it does is judged, and bounds of at most 0.3 of the mirror's light, with seeds that missed them.
TEST(Taught, LightOfSmallMirrorsLandsOnCells) {
  using M = SmallMirrorOnACell;
  for (const auto& [kind, seed] : {std::pair(M::small_lamp, 2), std::pair(M::metal, 3), std::pair(M::metal, 7),
                                   std::pair(M::mostly_metal, 7)}) {
    const ups_meter_reading dark = M::read(kind, false, 0.03, 128, 1), r = M::read(kind, true, 0.03, 128, uint64_t(seed));
    const double by_mirror = M::by_mirror(kind), expected = dark.illuminance_lx + by_mirror;
    measured("of the mirror's light %.2f, bound %.2f", (r.illuminance_lx - dark.illuminance_lx) / by_mirror,
             r.error_bound_lx / by_mirror);
    expect_inside_bound(r, expected, 0.3 * by_mirror / expected, "kind " + std::to_string(kind));
  }
}

// The same within what expect_lx.h allows, so that 1 % of the reading is found. Polished so well that images have edges.
TEST(Taught, LightOfSmallMirrorsOnCellsIsRight) {
  using M = SmallMirrorOnACell;
  for (const M::Kind kind : {M::small_lamp, M::metal, M::mostly_metal}) {
    const ups_meter_reading dark = M::read(kind, false, 0.01, 512, 1), r = M::read(kind, true, 0.01, 512, 2);
    const double noise = std::hypot(dark.standard_error_lx, r.standard_error_lx);
    expect_lx(r.illuminance_lx, noise, dark.illuminance_lx + M::by_mirror(kind) + M::ceiling_in_mirror(kind), quiet,
              "kind " + std::to_string(kind));
  }
}

// A lamp that meters see in a mirror alone, asked of methods whose eye paths have to run into it: some do in all, or
// none, and a dim panel, whose hits are many, hides that (before: 89 of 255 lx within a bound of 0.3 %). The panel's light
// is that of a render without the lamp's; the lamp's, through its image, E = rho L A h^2 / d^4. Of 40 bounds of 95 % more
// than five miss in 1 of 100 cases; seeds are fixed.
TEST(Taught, ALampThatEyePathsHardlyHitByWayOfAMirrorIsInTheBound) {
  constexpr double rho = 0.9, luminance = 1e5, h = 4.5, x = 0.5;
  constexpr int corners = 64;
  const auto read = [&](double radius, bool shines, const RenderOptions& options) {
    Scene scene;
    scene.add(quad({-6, -6, 0}, {12, 0, 0}, {0, 12, 0}), photon_mirror(rho));
    scene.add(disc({0, 0, 3}, {0, 0, -1}, radius, corners), shines ? emitter(luminance) : matte(0));
    scene.add(quad({2, -0.5, 0.1}, {0, 0, 1}, {0, 1, 0}), emitter(100));
    const Sensor meter = scene.add_meters({{x, 0, 1.5}}, {0, 0, -1});
    return scene.render(options).readings(meter)[0];
  };
  for (const double radius : {0.02, 0.1}) {
    const double area = radius * radius * corners / 2 * std::sin(2 * pi_d / corners), d2 = h * h + x * x;
    const ups_meter_reading panel =
        read(radius, false, {.method = UPS_METHOD_PATH_TRACING, .iterations = 4096, .seed = 100});
    ASSERT_GT(panel.illuminance_lx, 1);
    const double expected = panel.illuminance_lx + rho * luminance * area * h * h / (d2 * d2);
    for (const ups_method method : {UPS_METHOD_PATH_TRACING, UPS_METHOD_BIDIRECTIONAL}) {
      int missed = 0;
      double found = 0;
      for (uint64_t seed = 1; seed <= 40; ++seed) {
        const ups_meter_reading r = read(radius, true, {.method = method, .iterations = 32, .seed = seed});
        missed += std::abs(r.illuminance_lx - expected) > r.error_bound_lx;
        found += r.illuminance_lx / (40 * expected);
      }
      measured("a lamp of %g m in a mirror, %s: %d of 40 bounds missed, mean %.2f of it", radius, method_name(method),
               missed, found);
      EXPECT_LE(missed, 5) << radius << " " << method_name(method);
    }
  }
}

}  // namespace
}  // namespace ups::test
