// What ups_result_get_choice says of each kind of sensor: where a pilot chose, where nothing was chosen, and what is
// refused.
#include <gtest/gtest.h>

#include <cmath>

#include "../support/scene_builder.h"

namespace ups::test {
namespace {

constexpr uint32_t eye = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE;

// Matte, four spots below the ceiling; point meters on the work plane, so many that a choice is clear.
class Choice : public ::testing::Test {
 protected:
  void SetUp() override {
    scene.add(box({0, 0, 0}, {5, 4, 2.8}).flipped(), matte(0.3));
    for (double x : {1.25, 3.75})
      for (double y : {1.0, 3.0}) scene.add_spot({x, y, 2.79}, {0, 0, -1}, 1000, 0.6, 1.3);
    std::vector<P3> on_desks;
    for (int i = 0; i < 768; ++i) on_desks.push_back({(i % 32 + 0.5) / 32 * 5, (double(i / 32) + 0.5) / 24 * 4, 0.75});
    points = scene.add_meters(on_desks, {0, 0, 1});
  }
  Sensor add_cell() { return scene.add_cells({{2.5, 2, 0.75}}, {{0, 0, 1}}, {{1, 0, 0}}, 0.05, 0.05); }

  static ups_sensor_choice choice_of(const Result& result, const Sensor& sensor) {
    const ups_sensor_choice c = result.choice(sensor);
    EXPECT_TRUE(std::isfinite(c.predicted_gain) && c.predicted_gain > 0) << c.predicted_gain;
    EXPECT_EQ(c.techniques & ~result.info().techniques, 0u);
    EXPECT_EQ(c.photons == UPS_PHOTONS_NONE, !(c.techniques & UPS_TECHNIQUE_MERGE));
    return c;
  }
  // Where nothing was chosen.
  void expect_given(const Result& result, const Sensor& sensor, uint32_t techniques, ups_photons photons) {
    const ups_sensor_choice c = choice_of(result, sensor);
    EXPECT_EQ(c.techniques, techniques);
    EXPECT_EQ(c.photons, photons);
    EXPECT_EQ(c.predicted_gain, 1.0);
    EXPECT_EQ(c.light_paths_per_iteration * uint64_t(result.info().iterations), result.info().light_paths);
  }

  Scene scene;
  Sensor points;
};

TEST_F(Choice, AMatteOfficeNeedsNoLightPaths) {
  const Sensor cell = add_cell();
  const Result result = scene.render({.method = UPS_METHOD_AUTO, .iterations = 2});
  for (const Sensor& sensor : {points, cell}) {
    const ups_sensor_choice c = choice_of(result, sensor);
    EXPECT_EQ(c.techniques, eye);
    EXPECT_EQ(c.light_paths_per_iteration, 0u);
    EXPECT_EQ(c.photons, UPS_PHOTONS_NONE);
    EXPECT_GE(c.predicted_gain, 1);
  }
  EXPECT_EQ(result.info().light_paths, 0u);
}

TEST_F(Choice, APictureGlassNeedsNoLightPathsEither) {
  auto glazing = material(UPS_MATERIAL_GLAZING, 1);
  for (float& t : glazing.transmittance_rgb) t = 0.84f;
  scene.add(quad({2, 0.01, 1.1}, {0, 0, 0.8}, {0.8, 0, 0}), glazing);
  const Result result = scene.render({.method = UPS_METHOD_AUTO, .iterations = 2});
  EXPECT_EQ(choice_of(result, points).techniques, eye | UPS_TECHNIQUE_MIRROR_SAMPLE);
  EXPECT_EQ(result.info().method, UPS_METHOD_UPS);  // path tracing, as a method, has no images
  EXPECT_EQ(result.info().light_paths, 0u);
}

// One that shows no images, see photon_mirror().
TEST_F(Choice, ACasterNeedsCausticPhotonsAlone) {
  auto glazing = material(UPS_MATERIAL_GLAZING, 1);
  for (float& t : glazing.transmittance_rgb) t = 0.84f;
  glazing.alpha_mode = UPS_ALPHA_MASK;
  scene.add(quad({2, 0.01, 1.1}, {0, 0, 0.8}, {0.8, 0, 0}), glazing);
  const Result result = scene.render({.method = UPS_METHOD_AUTO, .iterations = 2});
  const ups_sensor_choice c = choice_of(result, points);
  EXPECT_EQ(c.photons, UPS_PHOTONS_CAUSTIC);
  EXPECT_GT(c.predicted_gain, 1);
  EXPECT_EQ(2 * c.light_paths_per_iteration, result.info().light_paths);
}

TEST_F(Choice, ANumberOfLightPathsThatIsAskedForStays) {
  auto glazing = material(UPS_MATERIAL_GLAZING, 1);
  for (float& t : glazing.transmittance_rgb) t = 0.84f;
  glazing.alpha_mode = UPS_ALPHA_MASK;
  scene.add(quad({2, 0.01, 1.1}, {0, 0, 0.8}, {0.8, 0, 0}), glazing);
  const Result result = scene.render({.method = UPS_METHOD_AUTO, .iterations = 2, .light_paths = 2048});
  EXPECT_EQ(choice_of(result, points).light_paths_per_iteration, 2048u);
  EXPECT_EQ(result.info().light_paths, 4096u);
  const Result few = scene.render({.method = UPS_METHOD_AUTO, .iterations = 2, .light_paths = 16});
  EXPECT_EQ(few.info().light_paths, 32u);
}

// What a camera also measures as illuminance is no part of what its picture's techniques are judged by.
TEST_F(Choice, IlluminanceLeavesThePicturesChoiceAsItIs) {
  auto glazing = material(UPS_MATERIAL_GLAZING, 1);
  glazing.alpha_mode = UPS_ALPHA_MASK;
  std::vector<ups_sensor_choice> choices;
  for (const bool illuminance : {false, true}) {
    Scene room;
    room.add(box({0, 0, 0}, {5, 4, 2.8}).flipped(), matte(0.3));
    room.add(quad({2, 0.01, 1.1}, {0, 0, 0.8}, {0.8, 0, 0}), glazing);
    for (double x : {1.25, 3.75}) room.add_spot({x, 2, 2.79}, {0, 0, -1}, 1000, 0.6, 1.3);
    const Sensor camera = room.add_camera({0.3, 2, 1.5}, {1, 0, -0.1}, 96, 64, 1, illuminance);
    choices.push_back(choice_of(room.render({.method = UPS_METHOD_AUTO, .iterations = 2}), camera));
  }
  EXPECT_EQ(choices[0].techniques, choices[1].techniques);
  EXPECT_EQ(choices[0].photons, choices[1].photons);
}

// Why light paths are off: no words of what eye paths find where none are traced, or where the caller wants none.
TEST_F(Choice, WordsSayWhyATechniqueIsOff) {
  const auto words = [](Scene& of, ups_method method, uint32_t techniques) {
    return of.render({.method = method, .iterations = 2, .techniques = techniques}).text(UPS_TEXT_TECHNIQUES);
  };
  const auto has = [](const std::string& text, const char* words) { return text.find(words) != std::string::npos; };
  EXPECT_TRUE(has(words(scene, UPS_METHOD_AUTO, 0), "eye paths find all light"));
  EXPECT_TRUE(has(words(scene, UPS_METHOD_PATH_TRACING, 0), "the method asked for leaves it out"));
  const std::string masked = words(scene, UPS_METHOD_AUTO, eye);
  EXPECT_TRUE(has(masked, "merge: off, not in the set (the techniques asked for leave it out)")) << masked;
  EXPECT_FALSE(has(masked, "eye paths find all light")) << masked;
  Scene lamp;
  lamp.add_point_light({0, 0, 0}, 100);
  lamp.add(quad({1, 1, 1}, {1, 0, 0}, {0, 1, 0}), matte(0.5));
  lamp.add_goniometer(4, 7);
  const std::string measured = words(lamp, UPS_METHOD_AUTO, 0);
  EXPECT_FALSE(has(measured, "eye paths find all light")) << measured;
  scene.add(icosphere({2, 2, 1}, 0.3, 2), mirror(0.9));
  scene.add(quad({2, 2, 2.7}, {0, 0.5, 0}, {0.5, 0, 0}), emitter(2000));
  const std::string mixed = words(scene, UPS_METHOD_AUTO, 0);
  EXPECT_TRUE(has(mixed, "merge: on")) << mixed;
  EXPECT_FALSE(has(mixed, "eye paths find all light")) << mixed;
}

// What fits each kind of sensor of a method's techniques, as tests of what each method measures have it.
TEST_F(Choice, AMethodThatWasAskedForIsNoChoice) {
  const Sensor cell = add_cell(), camera = scene.add_camera({0.3, 2, 1.5}, {1, 0, -0.1}, 32, 24, 1);
  const uint32_t landing = UPS_TECHNIQUE_SENSOR_HIT, splat = UPS_TECHNIQUE_SENSOR_CONNECT, merge = UPS_TECHNIQUE_MERGE,
                 connect = UPS_TECHNIQUE_CONNECT, hit = UPS_TECHNIQUE_EMITTER_HIT;
  const struct {
    ups_method method;
    uint32_t of_points, of_cell, of_camera;
  } cases[] = {{UPS_METHOD_UPS, eye | connect | merge, eye | connect | merge | landing, eye | connect | merge | splat},
               {UPS_METHOD_PATH_TRACING, eye, eye, eye},
               {UPS_METHOD_LIGHT_TRACING, connect, landing, splat},
               {UPS_METHOD_BIDIRECTIONAL, eye | connect, eye | connect, eye | connect | splat},
               {UPS_METHOD_PPM, merge, landing, hit | merge},
               {UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING, merge, merge | landing, hit | merge}};
  for (const auto& c : cases) {
    SCOPED_TRACE(c.method);
    const Result result = scene.render({.method = c.method, .iterations = 2});
    const auto photons = [](uint32_t t) { return t & UPS_TECHNIQUE_MERGE ? UPS_PHOTONS_ALL : UPS_PHOTONS_NONE; };
    expect_given(result, points, c.of_points, photons(c.of_points));
    expect_given(result, cell, c.of_cell, photons(c.of_cell));
    expect_given(result, camera, c.of_camera, photons(c.of_camera));
  }
  const Result masked = scene.render({.method = UPS_METHOD_AUTO, .iterations = 2, .techniques = eye | splat | landing});
  expect_given(masked, points, eye, UPS_PHOTONS_NONE);
}

// A lamp a tenth of a millimetre below the ceiling, which it lights above all: paths from the meters hardly find it.
TEST(ChoiceByTheCaller, IsToldOfFirstLightThatEyePathsMiss) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 3, 2.5}).flipped(), matte(0.5));
  scene.add_point_light({2, 1.5, 2.4999}, 1000);
  scene.add_meters({{1, 1, 0.75}}, {0, 0, 1});
  const auto warnings = [&](ups_method method) {
    return scene.render({.method = method, .iterations = 64}).text(UPS_TEXT_WARNINGS);
  };
  EXPECT_NE(warnings(UPS_METHOD_PATH_TRACING).find("readings may be too low, whatever their bounds say"),
            std::string::npos);
  for (const ups_method finds : {UPS_METHOD_AUTO, UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL})
    EXPECT_EQ(warnings(finds).find("too low"), std::string::npos) << finds;
}

TEST_F(Choice, BesideAGoniometerNothingIsChosen) {
  const Sensor goniometer = scene.add_goniometer(4, 7);
  const Result result = scene.render({.method = UPS_METHOD_AUTO, .iterations = 2});
  expect_given(result, goniometer, UPS_TECHNIQUE_SENSOR_HIT, UPS_PHOTONS_NONE);
  EXPECT_EQ(choice_of(result, points).predicted_gain, 1.0);
}

// The same view of a white room that is lit by way of its ceiling and of one lit from there, with one of 21 pixels a visit
// and with all of them: between two visits of a pixel as many splats fall on it. In the first one, where eye paths alone
// take four times as long to the same noise as all techniques, light paths are taken; in the second one not, where they
// take a fifth. A wrong count of splats errs by the subsets or their square.
TEST(ChoiceOfImages, ALargeOneIsJudgedAsASmallOne) {
  for (const bool upwards : {true, false}) {
    double gain[2];
    for (const int large : {0, 1}) {
      Scene scene;
      scene.add(box({0, 0, 0}, {5, 4, 2.8}).flipped(), matte(0.95));
      for (double x : {1.25, 3.75})
        for (double y : {1.0, 3.0})
          scene.add_spot({x, y, upwards ? 2.5 : 2.79}, {0, 0, upwards ? 1.0 : -1.0}, 1000, 0.6, 1.3);
      const uint32_t k = large ? 9 : 1;
      const Sensor view = scene.add_camera({0.5, 0.5, 1.5}, {1, 0.9, -0.1}, 124 * k, 64 * k, 1.2);
      const ups_sensor_choice c = scene.render({.method = UPS_METHOD_AUTO, .iterations = 1}).choice(view);
      const uint32_t light = UPS_TECHNIQUE_CONNECT | UPS_TECHNIQUE_SENSOR_CONNECT;
      EXPECT_EQ((c.techniques & light) != 0, upwards) << large;
      gain[large] = c.predicted_gain;
    }
    EXPECT_GE(gain[1] / gain[0], 0.5) << upwards << ": " << gain[0];
    EXPECT_LE(gain[1] / gain[0], 1.25) << upwards << ": " << gain[0];
  }
}

// It would wait for ever.
TEST(ChoiceOfGoniometers, ATargetIsRefusedThatNothingWouldMeet) {
  Scene lamp;
  lamp.add_point_light({0, 0, 0}, 100);
  lamp.add_goniometer(4, 7);
  check(ups_scene_commit(lamp.get()), "ups_scene_commit");
  auto desc = make_desc<ups_render_desc>(ups_render_desc_init);
  desc.method = UPS_METHOD_PATH_TRACING, desc.target_relative_error = 0.05, desc.iteration_count = 0;
  desc.time_limit_s = 0;
  ups_result* result = nullptr;
  EXPECT_EQ(ups_render(lamp.get(), &desc, &result), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_NE(std::string(ups_last_error()).find("the goniometer measures nothing"), std::string::npos);
  desc.iteration_count = 1;
  EXPECT_EQ(ups_render(lamp.get(), &desc, &result), UPS_OK) << ups_last_error();
  ups_result_destroy(result);
}

TEST_F(Choice, WrongArgumentsAreNamed) {
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  auto desc = make_desc<ups_render_desc>(ups_render_desc_init);
  desc.iteration_count = 1, desc.method = UPS_METHOD_PATH_TRACING;
  ups_result* result = nullptr;
  check(ups_render(scene.get(), &desc, &result), "ups_render");
  const auto refuses = [](ups_status status, const char* words) {
    EXPECT_EQ(status, UPS_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(ups_last_error()).find(words), std::string::npos) << ups_last_error();
  };
  ups_sensor_choice c{};
  refuses(ups_result_get_choice(result, points.id, &c), "choice->struct_size is 0");
  c.struct_size = sizeof c;
  refuses(ups_result_get_choice(nullptr, points.id, &c), "result is NULL");
  refuses(ups_result_get_choice(result, points.id, nullptr), "choice is NULL");
  refuses(ups_result_get_choice(result, {points.id.v + 50}, &c), "is not a sensor of the scene");
  refuses(ups_result_get_choice(result, {0}, &c), "sensor");
  // A caller that was built against a shorter struct.
  c.struct_size = 8, c.predicted_gain = -7;
  EXPECT_EQ(ups_result_get_choice(result, points.id, &c), UPS_OK) << ups_last_error();
  EXPECT_EQ(c.techniques, eye);
  EXPECT_EQ(c.struct_size, 8u);
  EXPECT_EQ(c.predicted_gain, -7);
  ups_result_destroy(result);
}

}  // namespace
}  // namespace ups::test
