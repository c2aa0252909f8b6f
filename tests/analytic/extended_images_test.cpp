// Lamps with extent in flat mirrors and panes: next-event estimation asks for their images, and shares their light with
// eye paths that run into them by way of the mirror and with light paths. In black surroundings closed forms tell it all.
//
// Judged as expect_lx.h says, with its false alarms and what it finds: an error of 1 %.
#include "../support/expect_same.h"

namespace ups::test {
namespace {

constexpr uint32_t all_but_mirrors = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT |
                                     UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT,
                   mirror_sample = UPS_TECHNIQUE_MIRROR_SAMPLE, none_of_it = 0;
constexpr double luminance = 3000;
const std::vector<P3> points = {{0.3, 0.8, 0}, {-0.5, 1.6, 0.1}, {1.1, 0.5, -0.2}};
const P3 up{0, 0, 1};
const Shape wall_mirror = quad({-3, 0, -3}, {0, 0, 8}, {6, 0, 0});  // y = 0

P3 in_mirror(const P3& p) { return {p.x, -p.y, p.z}; }
Shape in_mirror(Shape s) {
  for (P3& v : s.vertices) v = in_mirror(v);
  return s.flipped();
}

struct Lamp {
  const char* name;
  Shape shape;
  bool both_sides;
  double straight(const P3& p, const P3& n) const {
    return convex_irradiance_factor(shape, p, n) + (both_sides ? convex_irradiance_factor(shape.flipped(), p, n) : 0);
  }
  double mirrored(const P3& p, const P3& n) const { return Lamp{name, in_mirror(shape), both_sides}.straight(p, n); }
};
void PrintTo(const Lamp& lamp, std::ostream* out) { *out << lamp.name; }

const Lamp lamps[] = {{"panel", quad({0.1, 1.0, 2.0}, {0, 0.5, 0.1}, {0.6, 0, 0}), false},
                      {"both_sides", quad({0.1, 1.2, 1.7}, {0.1, 0, 0.5}, {0.5, 0.1, 0}), true},
                      {"ball", icosphere({0.4, 1.2, 2}, 0.15, 1), false},
                      {"small", quad({0.4, 1.2, 2.0}, {0, 0.01, 0}, {0.01, 0, 0}), false}};

class ExtendedImages : public ::testing::TestWithParam<std::tuple<Lamp, ups_method>> {
 protected:
  const Lamp& lamp() const { return std::get<0>(GetParam()); }
  Result render(Scene& scene, uint32_t techniques = none_of_it) const {
    return scene.render(
        {.method = std::get<1>(GetParam()), .iterations = 128, .light_paths = 64, .techniques = techniques});
  }
  ups_material_desc shining() const {
    ups_material_desc d = emitter(luminance);
    d.emits_both_sides = lamp().both_sides;
    return d;
  }
  void expect(Scene& scene, const Sensor& meters, double reflectance, uint32_t techniques = none_of_it) const {
    const Result result = render(scene, techniques);
    EXPECT_TRUE(result.info().techniques & mirror_sample);
    EXPECT_EQ(result.text(UPS_TEXT_WARNINGS).find("is missing"), std::string::npos) << result.text(UPS_TEXT_WARNINGS);
    for (size_t i = 0; i < points.size(); ++i) {
      EXPECT_LT(result.readings(meters)[i].error_bound_lx, 0.01 * result.readings(meters)[i].illuminance_lx) << i;
      expect_lx(result.readings(meters)[i],
                luminance * (lamp().straight(points[i], up) + reflectance * lamp().mirrored(points[i], up)), quiet,
                lamp().name + (" at " + std::to_string(i)));
    }
  }
};

TEST_P(ExtendedImages, ShowLampsAsTheyAre) {
  Scene scene;
  scene.add(lamp().shape, shining());
  scene.add(wall_mirror, mirror(0.85));
  expect(scene, scene.add_meters(points, up), 0.85);
}

// Without eye paths that run into lamps: next-event estimation alone brings all of it.
TEST_P(ExtendedImages, AreAllThatIsNeeded) {
  Scene scene;
  scene.add(lamp().shape, shining());
  scene.add(wall_mirror, mirror(0.85));
  expect(scene, scene.add_meters(points, up), 0.85, UPS_TECHNIQUE_LIGHT_SAMPLE | mirror_sample);
}

INSTANTIATE_TEST_SUITE_P(
    Of, ExtendedImages, ::testing::Combine(::testing::ValuesIn(lamps), ::testing::Values(UPS_METHOD_UPS, UPS_METHOD_AUTO)),
    [](const auto& p) {
      return std::string(std::get<0>(p.param).name) + (std::get<1>(p.param) == UPS_METHOD_UPS ? "_UPS" : "_auto");
    });

// A long lamp that faces a small mirror, which shows a part of it to each meter; nothing else comes to them.
TEST(PartsOfExtendedImages, AreSeenInSmallMirrors) {
  const double x0 = -0.2, x1 = 0.1, z0 = 0.6, z1 = 0.8;  // of the mirror
  const double lamp_y = 1.2, left = -0.9, right = 0.9, low = 0.9, high = 1.0;
  const std::vector<P3> at = {{0.0, 0.6, 0.5}, {0.25, 0.5, 0.6}, {-0.4, 0.8, 0.55}};
  const P3 n{0, -1, 0};
  for (const uint32_t techniques : {none_of_it, uint32_t(UPS_TECHNIQUE_LIGHT_SAMPLE | mirror_sample)}) {
    Scene scene;
    scene.add(quad({left, lamp_y, low}, {right - left, 0, 0}, {0, 0, high - low}), emitter(luminance));
    scene.add(quad({x0, 0, z0}, {0, 0, z1 - z0}, {x1 - x0, 0, 0}), mirror(0.9));
    const Sensor meters = scene.add_meters(at, n);
    const Result result = scene.render({.iterations = 256, .techniques = techniques});
    for (size_t i = 0; i < at.size(); ++i) {
      const P3& p = at[i];
      const auto beyond = [&](double from, double mirror) { return from + (mirror - from) * (p.y + lamp_y) / p.y; };
      const double a = std::max(left, beyond(p.x, x0)), b = std::min(right, beyond(p.x, x1)),
                   c = std::max(low, beyond(p.z, z0)), d = std::min(high, beyond(p.z, z1));
      ASSERT_TRUE(a < b && c < d && (a > left || b < right)) << i;
      const std::vector<P3> seen = {{a, -lamp_y, c}, {a, -lamp_y, d}, {b, -lamp_y, d}, {b, -lamp_y, c}};
      expect_lx(result.readings(meters)[i], 0.9 * luminance * polygon_irradiance_factor(seen, p, n), quiet,
                "meter " + std::to_string(i) + " by techniques " + std::to_string(techniques));
    }
  }
}

// A luminaire with its luminous opening, of which rotation about its axis makes no difference: its image is one that
// stands behind the mirror. Judged in pairs: expect_same.h.
TEST(ExtendedImagesOfLuminaires, ShineByTheirTables) {
  const P3 place{0.4, 1.2, 2.0};
  std::vector<Estimate> images;
  for (const bool mirrored : {true, false}) {
    Scene scene;
    const auto profile = table_profile(scene.context(), 0.2f);
    scene.add_luminaire(profile.get(), place, {0, 0, -1}, true);
    if (mirrored) scene.add(wall_mirror, mirror(0.85));
    else scene.add_luminaire(profile.get(), in_mirror(place), {0, 0, -1}, true);
    const Sensor meters = scene.add_meters(points, up);
    const Result result = scene.render({.iterations = 192, .separation = UPS_SEPARATE_LUMINAIRES});
    if (mirrored) {
      EXPECT_TRUE(result.info().techniques & mirror_sample);
      for (const auto& r : result.readings(meters)) images.push_back({"image", r.illuminance_lx, r.standard_error_lx});
      continue;
    }
    for (size_t i = 0; i < points.size(); ++i) {
      const auto own = result.readings_of_source(0, meters)[i], other = result.readings_of_source(1, meters)[i];
      const double sum = double(own.illuminance_lx) + 0.85 * double(other.illuminance_lx),
                   error = std::hypot(double(own.standard_error_lx), 0.85 * double(other.standard_error_lx));
      expect_same({images[i], {"own and 0.85 of the other", sum, error}}, 0, "meter " + std::to_string(i));
    }
  }
}

// Balls, a part of which shines towards each meter, share the choice among images: none is asked for so seldom that its
// light is rare.
TEST(ImagesOfLamps, OfSeveralLampsAreAllAskedFor) {
  Scene scene;
  scene.add(wall_mirror, mirror(0.85));
  const P3 at[] = {{0.4, 1.2, 2}, {-0.8, 0.6, 1.5}, {0.9, 1.6, 1.2}};
  for (const P3& p : at) scene.add(icosphere(p, 0.05, 1), emitter(luminance));
  scene.add_point_light({0, 2, 2}, 10);
  const Sensor meters = scene.add_meters(points, up);
  const Result result =
      scene.render({.iterations = 256, .techniques = UPS_TECHNIQUE_LIGHT_SAMPLE | mirror_sample});
  for (size_t i = 0; i < points.size(); ++i) {
    const auto from_point = [&](const P3& p) {
      const P3 way = p - points[i];
      return 10 * dot(way, up) / std::pow(dot(way, way), 1.5);
    };
    double expected = from_point({0, 2, 2}) + 0.85 * from_point({0, -2, 2});
    for (const P3& p : at) {
      const Lamp one{"", icosphere(p, 0.05, 1), false};
      expected += luminance * (one.straight(points[i], up) + 0.85 * one.mirrored(points[i], up));
    }
    expect_lx(result.readings(meters)[i], expected, quiet, "meter " + std::to_string(i));
  }
}

// What images are for: the light of a small lamp in a mirror, which eye paths hardly ever run into.
TEST(ImagesOfLamps, MakeSmallLampsLessNoisy) {
  Scene scene;
  scene.add(quad({0.4, 1.2, 2.0}, {0, 0.03, 0}, {0.03, 0, 0}), emitter(1e5));
  scene.add(wall_mirror, mirror(0.85));
  const Sensor meters = scene.add_meters(points, up);
  const auto noise = [&](uint32_t techniques) {
    const Result result = scene.render({.iterations = 64, .techniques = techniques});
    return result.statistics(meters).mean_standard_error_lx / result.statistics(meters).mean_lx;
  };
  EXPECT_LT(noise(all_but_mirrors | mirror_sample), 0.2 * noise(all_but_mirrors));
}

}  // namespace
}  // namespace ups::test
