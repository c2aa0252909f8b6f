// How luminaires stand where they are placed: what mirrors a luminaire mirrors its light.
#include <cmath>

#include "fixture.h"

namespace ups_test {
namespace {

class LuminairePlaces : public Api {
 protected:
  // Strong towards C0 and C90, each in its way; with a luminous opening that is longer than wide.
  ups_profile* lopsided() {
    static const float c[4] = {0, 90, 180, 270}, gamma[3] = {0, 45, 90};
    static const float cd[12] = {100, 400, 50, 100, 900, 500, 100, 10, 5, 100, 30, 20};
    auto d = make(&ups_profile_desc_init);
    d.c_count = 4, d.gamma_count = 3, d.c_deg = c, d.gamma_deg = gamma, d.intensity_cd = cd;
    d.opening_shape = UPS_OPENING_RECTANGLE, d.opening_m[0] = 0.6f, d.opening_m[1] = 0.2f;
    ups_profile* out = nullptr;
    EXPECT_OK(ups_profile_create(context, &d, &out));
    return out;
  }
  // Readings at points in a plane 2 m below, of a luminaire whose x and y run along these axes.
  std::vector<ups_meter_reading> readings(const double (&x)[3], const double (&y)[3], bool mirror_points,
                                          int32_t use_opening) {
    ups_scene* scene = nullptr;
    EXPECT_OK(ups_scene_create(context, &scene));
    ups_profile* profile = lopsided();
    auto l = make(&ups_luminaire_desc_init);
    l.profile = profile, l.use_opening = use_opening;
    for (int i = 0; i < 3; ++i) l.to_world[4 * i] = x[i], l.to_world[4 * i + 1] = y[i];
    ups_luminaire_id luminaire;
    EXPECT_OK(ups_scene_add_luminaire(scene, &l, &luminaire));
    std::vector<double> positions;
    for (const auto& [px, py] : {std::pair(1.5, 0.2), {-0.3, 1.4}, {-1.1, -0.7}, {0.9, -1.3}})
      positions.insert(positions.end(), {mirror_points ? -px : px, py, -2.0});
    auto m = make(&ups_meter_desc_init);
    m.count = 4, m.positions_m = positions.data();
    const std::vector<float> up = {0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
    m.normals = up.data();
    ups_sensor_id sensor;
    EXPECT_OK(ups_scene_add_meters(scene, &m, &sensor));
    EXPECT_OK(ups_scene_commit(scene));
    auto r = make(&ups_render_desc_init);
    r.iteration_count = use_opening ? 256 : 16;
    ups_result* result = nullptr;
    EXPECT_OK(ups_render(scene, &r, &result));
    std::vector<ups_meter_reading> found(4);
    EXPECT_OK(ups_result_read_meters(result, sensor, found.data(), 4));
    ups_result_destroy(result);
    ups_profile_destroy(profile);
    ups_scene_destroy(scene);
    return found;
  }
};

TEST_F(LuminairePlaces, AShearIsWarnedOf) {
  ups_profile* profile = lopsided();
  for (const double along : {0.0, 1e-4, 0.5}) {
    ups_scene* scene = nullptr;
    EXPECT_OK(ups_scene_create(context, &scene));
    auto l = make(&ups_luminaire_desc_init);
    l.profile = profile;
    l.to_world[0] = 2, l.to_world[4] = 2 * along;  // x; scale is no shear
    ups_luminaire_id luminaire;
    EXPECT_OK(ups_scene_add_luminaire(scene, &l, &luminaire));
    EXPECT_OK(ups_scene_commit(scene));
    char text[4096] = {};
    size_t needed = 0;
    EXPECT_OK(ups_scene_get_text(scene, UPS_SCENE_TEXT_WARNINGS, text, sizeof text, &needed));
    const char* told = "luminaire 1: to_world is sheared, its axes are 27 degrees off right angles";
    EXPECT_EQ(std::string(text).find(told) != std::string::npos, along == 0.5) << text;
    ups_scene_destroy(scene);
  }
  ups_profile_destroy(profile);
}

// A point exactly; an opening to 0.3 %, a ratio has at most 0.1 % of noise: a false alarm has P(|t_30| > 3) = 0.5 %
// at that limit, and 1 % is found for certain, 7 standard errors beyond.
TEST_F(LuminairePlaces, WhatIsMirroredShinesMirrored) {
  for (const int32_t use_opening : {0, 1}) {
    const double x[3] = {1, 0, 0}, y[3] = {0, 1, 0}, back[3] = {-1, 0, 0}, tenth[3] = {-0.1, 0, 0};
    const auto straight = readings(x, y, false, use_opening), mirrored = readings(back, y, true, use_opening),
               scaled = readings(tenth, y, true, use_opening), turned = readings(back, y, false, use_opening);
    const auto ratio = [](const ups_meter_reading& a, const ups_meter_reading& b) {
      return double(a.illuminance_lx) / double(b.illuminance_lx);
    };
    double largest = 0;
    for (size_t i = 0; i < straight.size(); ++i) {
      EXPECT_GT(straight[i].illuminance_lx, 1);
      for (const auto* set : {&mirrored, &scaled}) {
        const ups_meter_reading &a = (*set)[i], &b = straight[i];
        const double noise = std::hypot(double(a.standard_error_lx), double(b.standard_error_lx));
        EXPECT_LE(noise, 0.001 * double(b.illuminance_lx)) << i << ": too noisy to judge";
        EXPECT_NEAR(ratio(a, b), 1, use_opening ? 0.003 : 1e-5) << i;
      }
      largest = std::max(largest, std::abs(ratio(turned[i], straight[i]) - 1));
    }
    EXPECT_GT(largest, 0.2) << "the places tell one from the other";
  }
}

// What is asked for and set again is the same, bit by bit.
TEST_F(LuminairePlaces, AColourThatIsReadAndSetStays) {
  auto l = make(&ups_luminaire_desc_init);
  l.profile = profile;
  for (int k = 1; k <= 200; ++k) {
    l.color_rgb[0] = 0.3f + 0.007f * float(k), l.color_rgb[1] = 1.1f - 0.003f * float(k % 17), l.color_rgb[2] = 0.37f;
    ups_luminaire_id id;
    EXPECT_OK(ups_scene_add_luminaire(scene, &l, &id));
    auto before = make(&ups_luminaire_desc_init), after = before;
    EXPECT_OK(ups_scene_get_luminaire(scene, id, &before));
    auto again = before;
    again.group = 3;
    EXPECT_OK(ups_scene_set_luminaire(scene, id, &again));
    EXPECT_OK(ups_scene_get_luminaire(scene, id, &after));
    for (int i = 0; i < 3; ++i) EXPECT_EQ(before.color_rgb[i], after.color_rgb[i]) << k;
  }
}

}  // namespace
}  // namespace ups_test
