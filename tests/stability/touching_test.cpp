// Emitters that touch glass, or nearly: with air between, however thin, or told. Seeds are fixed (expect_lx.h).
#include <gtest/gtest.h>

#include "../analytic/ies_text.h"
#include "../support/expect_lx.h"
#include "../support/scene_warnings.h"
#include "../support/figures.h"

namespace ups::test {
namespace {

constexpr double luminance = 1000, radius = 0.5, thickness = 0.2, ior = 1.5, below = 0.8;
constexpr int corners = 256;
const double top = 7.0 / 3;  // which no float holds

double fresnel(double cos_1) {  // unpolarised, from air
  const double cos_2 = std::sqrt(1 - (1 - cos_1 * cos_1) / (ior * ior));
  const double s = (cos_1 - ior * cos_2) / (cos_1 + ior * cos_2), p = (cos_2 - ior * cos_1) / (cos_2 + ior * cos_1);
  return 0.5 * (s * s + p * p);
}

// Of an even disc that shines through a slab below it, `off` its axis: luminance is kept but for reflections, of which
// those within the slab carry light sideways; what the disc is given back it absorbs.
double expected_lx(double off, double gap) {
  constexpr int steps = 5000;
  // The area of the polygon that stands for it.
  const double a = radius * std::sqrt(corners / (2 * pi_d) * std::sin(2 * pi_d / corners));
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double theta = (i + 0.5) / steps * (pi_d / 2), sine = std::sin(theta), r = fresnel(std::cos(theta));
    const double inner = sine / ior / std::sqrt(1 - sine * sine / (ior * ior));
    double share = (1 - r) * (1 - r);
    for (int k = 0; k < 4; ++k, share *= r * r) {
      const double reach = (below + gap) * std::tan(theta) + (2 * k + 1) * thickness * inner;
      const double seen = reach + off <= a ? 1
                          : std::abs(reach - off) >= a
                              ? 0
                              : std::acos((reach * reach + off * off - a * a) / (2 * reach * off)) / pi_d;
      sum += share * seen * std::cos(theta) * sine;
    }
  }
  return 2 * pi_d * luminance * sum * (pi_d / 2 / steps);
}

double expected_over_square_lx(double side, double gap) {
  constexpr int n = 12;  // of a quarter
  double sum = 0;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) sum += expected_lx(std::hypot(i + 0.5, k + 0.5) * side / 2 / n, gap);
  return sum / (n * n);
}

enum class Source { surface, opening };

struct Slab {
  Scene scene;
  Sensor meters, cell;
  // A disc that shines down, and glass below it; meters in a circle below that, and a cell.
  Slab(Source source, double gap, bool backed = false) {
    scene.add(box({-2, -2, top - gap - thickness}, {2, 2, top - gap}), glass(ior));
    if (backed) scene.add(quad({-1, -1, top}, {0, 2, 0}, {2, 0, 0}), matte(0));
    if (source == Source::surface) {
      scene.add(disc({0, 0, 0}, {0, 0, -1}, radius, corners), emitter(luminance), {0, 0, top});
    } else {
      const double intensity = luminance * pi_d * radius * radius;
      const Profile profile = parse(scene.context(), ies_text([=](double g) { return intensity * std::cos(g); }, 90,
                                                              2 * radius));
      scene.add_luminaire(profile.get(), {0, 0, top}, {0, 0, -1}, true);
    }
    std::vector<P3> at;
    for (int i = 0; i < count; ++i)
      at.push_back({off * std::cos(2 * pi_d * i / count), off * std::sin(2 * pi_d * i / count),
                    top - gap - thickness - below});
    meters = scene.add_meters(at, {0, 0, 1});
    cell = scene.add_cells({{0, 0, top - gap - thickness - below}}, {{0, 0, 1}}, {{1, 0, 0}}, side, side);
  }
  static constexpr double off = 0.1, side = 2;
  static constexpr int count = 16;
};

// Without air the light would be 1 / 2.25 of it. In contact: standard errors are at most 0.16 %, and 0.5 % or four of
// them are allowed: an error of 1 % is found in 98 of 100 cases at the least. The mean over meters, and over a cell
// that photons land on. With gaps: the same within 0.1 %, from the same random numbers.
void expect_air(Source source) {
  for (const ups_method method : {UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_PATH_TRACING, UPS_METHOD_PPM}) {
    const bool lands = method == UPS_METHOD_PPM;
    const auto read = [&](double gap, uint32_t iterations) {
      Slab slab(source, gap);
      return slab.scene
          .render({.method = method, .iterations = iterations, .merge_radius_m = 0.1,
                   .light_paths = lands ? 1u << 11 : 1u << 6})
          .statistics(lands ? slab.cell : slab.meters);
    };
    const std::string what = std::string(source == Source::surface ? "surface, " : "opening, ") + method_name(method);
    const double expected = lands ? expected_over_square_lx(Slab::side, 0) : expected_lx(Slab::off, 0);
    const auto s = read(0, method == UPS_METHOD_UPS ? 48 : 32);
    measured("%s: %+.2f %% (+- %.2f %%)", what.c_str(), 100 * (s.mean_lx / expected - 1),
             100 * s.mean_standard_error_lx / expected);
    expect_lx(s.mean_lx, s.mean_standard_error_lx, expected, 0.0016, what);
    const double touching = read(0, 4).mean_lx;
    for (const double gap : {1e-9, 1e-7, 1e-6, 5e-6, 1e-5, 1e-4})
      expect_ratio(read(gap, 4).mean_lx, touching, 1e-3, what + (", gap " + short_number(gap)));
  }
}

TEST(Taught, SurfacesThatTouchGlassShineThroughAir) { expect_air(Source::surface); }
TEST(Taught, OpeningsThatTouchGlassShineThroughAir) { expect_air(Source::opening); }

std::string warnings_of(Source source, double gap, bool backed = false) {
  Slab slab(source, gap, backed);
  return scene_warnings(slab.scene);
}

TEST(Taught, EmittersThatTouchGlassAreTold) {
  for (const Source source : {Source::surface, Source::opening}) {
    EXPECT_NE(warnings_of(source, 0).find(": on what lets light through (instance 1), closer"),
              std::string::npos);
    EXPECT_NE(warnings_of(source, 3e-6).find("set back by 0.0"), std::string::npos);
    EXPECT_EQ(warnings_of(source, 1e-3), "");
    EXPECT_NE(warnings_of(source, -3e-5).find("below its surface"), std::string::npos);
    EXPECT_EQ(warnings_of(source, -1e-3), "");
  }
}

// On a board, and its glass in the board's plane: what is set back would be behind the board.
TEST(Taught, EmittersThatCannotBeSetBackAreTold) {
  for (const Source source : {Source::surface, Source::opening})
    EXPECT_NE(warnings_of(source, 0, true).find("no room to be set back"), std::string::npos);
}

// One has room, and a second one is brought to where there is none; then nothing but the light of one changes. The
// scene is what one is that was built so.
TEST(Taught, EmittersThatAnEditBringsToGlassHaveTheRoomThatThereIs) {
  const auto place = [](double x, double z) { return facing({x, 0, z}, {0, 0, -1}); };
  const auto build = [&](Scene& scene, double height_of_second, ups_luminaire_id& second) {
    for (const double x : {-3.0, 3.0})
      scene.add(box({x - 1, -1, top - thickness}, {x + 1, 1, top}), glass(ior));
    scene.add(quad({2, -1, top}, {0, 2, 0}, {2, 0, 0}), matte(0));
    const Profile profile = parse(scene.context(), ies_text([](double g) { return 100 * std::cos(g); }, 90, 0.4));
    auto d = make_desc<ups_luminaire_desc>(ups_luminaire_desc_init);
    d.profile = profile.get(), d.use_opening = 1;
    for (const auto& m : {place(-3, top), place(3, height_of_second)}) {
      std::copy(m.begin(), m.end(), d.to_world);
      check(ups_scene_add_luminaire(scene.get(), &d, &second), "ups_scene_add_luminaire");
    }
    scene.add_meters({{-3, 0, 0}, {3, 0, 0}}, {0, 0, 1});
  };
  Scene whole, edited;
  ups_luminaire_id of_whole{}, second{};
  build(whole, top, of_whole);
  build(edited, top + 0.5, second);
  const std::string expected = scene_warnings(whole);
  EXPECT_NE(expected.find("no room to be set back"), std::string::npos) << expected;
  EXPECT_EQ(scene_warnings(edited).find("no room"), std::string::npos);
  const auto moved = place(3, top);
  double m[12];
  std::copy(moved.begin(), moved.end(), m);
  check(ups_scene_set_luminaire_transform(edited.get(), second, m), "ups_scene_set_luminaire_transform");
  EXPECT_EQ(scene_warnings(edited), expected);
  for (Scene* scene : {&whole, &edited})
    for (const float dimming : {0.5f, 1.0f}) {
      check(ups_scene_set_dimming(scene->get(), scene == &whole ? of_whole : second, dimming), "ups_scene_set_dimming");
      EXPECT_EQ(scene_warnings(*scene), expected);
    }
}

}  // namespace
}  // namespace ups::test
