// Results of ups.hpp: readings, statistics, sources, images, goniometers, glare, samples traced again.
#include <algorithm>
#include <cmath>
#include <cstring>

#include "room.h"

namespace {

TEST(Results, OfMeters) {
  Room room;
  ups::MeterDesc vectors(room.points, room.up);
  vectors.kind = UPS_METER_VECTOR;
  const auto vector_meters = room.scene.add_meters(vectors);
  ups::MeterDesc cylinders(room.points, room.up);
  cylinders.kind = UPS_METER_CYLINDRICAL;
  const auto cylindrical = room.scene.add_meters(cylinders);
  room.scene.commit();
  const ups::Result result = room.scene.render(Room::few(20));
  EXPECT_EQ(result.get_info().iterations, 20u);
  EXPECT_EQ(result.get_info().method, UPS_METHOD_UPS);
  EXPECT_NE(result.get_text(UPS_TEXT_TECHNIQUES), "");
  EXPECT_NE(result.get_choice(room.meters).techniques, 0u);

  const auto readings = result.read_meters(room.meters);
  ASSERT_EQ(readings.size(), 4u);
  std::vector<ups_meter_reading> filled(4);
  result.read_meters(room.meters, filled);
  EXPECT_EQ(filled[3].illuminance_lx, readings[3].illuminance_lx);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"count"}, [&] { result.read_meters(room.meters, {filled.data(), 3}); });
  const auto direct = result.read_meter_part(room.meters, UPS_LIGHT_PART_DIRECT);
  EXPECT_EQ(direct[2].illuminance_lx, readings[2].direct_lx);
  EXPECT_EQ(result.read_meter_part(room.meters, UPS_LIGHT_PART_ALL)[2].error_bound_lx, readings[2].error_bound_lx);
  EXPECT_EQ(result.read_meter_flags(room.meters).size(), 4u);
  const auto light = result.read_vectors(vector_meters);
  const auto whole = result.read_vector_part(vector_meters, UPS_LIGHT_PART_ALL);
  ASSERT_EQ(whole.size(), light.size());
  EXPECT_EQ(whole[0].vector_lx[2], light[0].vector_lx[2]);
  const float *const v = light[0].vector_lx;
  EXPECT_GT(std::min({v[0], v[1], v[2]}), 0) << "towards the luminaire";
  EXPECT_NEAR(std::hypot(v[0], v[1], v[2]), result.read_meters(vector_meters)[0].illuminance_lx, 1e-3);

  const ups_meter_statistics statistics = result.get_meter_statistics(room.meters);
  EXPECT_EQ(result.get_meter_percentile(room.meters, 0).value, statistics.min_lx);
  EXPECT_EQ(result.get_meter_share(room.meters, 0.5 * statistics.min_lx).value, 1);
  EXPECT_EQ(result.get_meter_ratio(room.meters, room.meters).value, 1);
  const auto modelling = result.read_meter_ratios(cylindrical, room.meters);
  ASSERT_EQ(modelling.size(), 4u);
  EXPECT_NEAR(modelling[1].value, result.read_meters(cylindrical)[1].illuminance_lx / readings[1].illuminance_lx, 1e-6);

  EXPECT_FALSE(result.curve().empty());
  EXPECT_FALSE(result.read_convergence().empty());
  EXPECT_GT(result.get_prediction(0.5).seconds, 0);
  EXPECT_LT(result.get_largest_error().index, 4u);
}

TEST(Results, OfSourcesApartAddUp) {
  Room room;
  const auto second = room.scene.add_luminaire({downlight(room.context), ups::Transform::translation(3, 1, 2.4)});
  room.scene.commit();
  ups::RenderDesc desc = Room::few();
  desc.separation = UPS_SEPARATE_LUMINAIRES;
  const ups::Result result = room.scene.render(desc);
  const auto sources = result.sources();
  ASSERT_EQ(sources.size(), 2u);
  EXPECT_EQ(sources[1].id, second.v);
  const auto all = result.read_meters(room.meters), first = result.read_source_meters(0, room.meters);
  std::vector<ups_meter_reading> other(4);
  result.read_source_meters(1, room.meters, other);
  const auto own = result.view_meters(room.meters);
  ASSERT_EQ(own.size(), all.size());
  EXPECT_EQ(std::memcmp(own.data(), all.data(), all.size() * sizeof all[0]), 0);
  for (std::size_t i = 0; i < 4; ++i)
    EXPECT_NEAR(first[i].illuminance_lx + other[i].illuminance_lx, all[i].illuminance_lx, 1e-5 * all[i].illuminance_lx);
}

template <class R, class = void>
constexpr bool shows_meters = false;
template <class R>
constexpr bool shows_meters<R, std::void_t<decltype(std::declval<R>().view_meters({}))>> = true;
template <class R, class = void>
constexpr bool shows_images = false;
template <class R>
constexpr bool shows_images<R, std::void_t<decltype(std::declval<R>().view_image({}, UPS_CHANNEL_DEPTH))>> = true;

TEST(Results, ShowNothingThatEndsBeforeItsView) {
  static_assert(shows_meters<ups::Result &> && shows_meters<const ups::Result &>);
  static_assert(!shows_meters<ups::Result> && !shows_meters<const ups::Result>);
  static_assert(shows_images<ups::Result &> && shows_images<const ups::Result &>);
  static_assert(!shows_images<ups::Result> && !shows_images<const ups::Result>);
}

TEST(Results, OfCameras) {
  Room room;
  ups::CameraDesc camera = room.scene.get_camera(room.camera);
  camera.layers = UPS_LAYER_DEPTH | UPS_LAYER_NORMAL;
  room.scene.set_camera(room.camera, camera);
  room.scene.commit();
  ups::RenderDesc desc = Room::few();
  desc.technique_images = 3;
  const ups::Result result = room.scene.render(desc);
  const auto rgb = result.read_image(room.camera, UPS_CHANNEL_LUMINANCE_RGB, 8, 6);
  ASSERT_EQ(rgb.size(), 8u * 6 * 3);
  EXPECT_GT(*std::min_element(rgb.begin(), rgb.end()), 0);
  std::vector<float> filled(rgb.size());
  result.read_image(room.camera, UPS_CHANNEL_LUMINANCE_RGB, filled);
  EXPECT_EQ(filled, rgb);
  const auto own = result.view_image(room.camera, UPS_CHANNEL_LUMINANCE_RGB);
  EXPECT_EQ(std::vector<float>(own.begin(), own.end()), rgb);
  const auto depth = result.read_image(room.camera, UPS_CHANNEL_DEPTH, 8, 6);
  ASSERT_EQ(depth.size(), 8u * 6);
  // 3.5 m to the wall, 3.543 in the pixel's mean, of which 8 rays have a standard error of 0.3 % at most.
  EXPECT_NEAR(depth[8 * 3 + 4], 3.543, 0.035) << "straight on, to the wall";
  EXPECT_EQ(result.read_image(room.camera, UPS_CHANNEL_NORMAL, 8, 6).size(), 8u * 6 * 3);
  EXPECT_EQ(result.read_image(room.camera, UPS_CHANNEL_LUMINANCE_RGB), rgb);
  EXPECT_EQ(result.image_size(room.camera).width, 8u);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"height", "expected 6"},
               [&] { result.read_image(room.camera, UPS_CHANNEL_DEPTH, 8, 5); });
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"width", "expected 8"},
               [&] { result.read_image(room.camera, UPS_CHANNEL_DEPTH, 6, 8); });
  std::vector<float> larger(rgb.size() + 1);
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {"out"},
               [&] { result.read_image(room.camera, UPS_CHANNEL_LUMINANCE_RGB, larger); });

  const auto techniques = result.techniques(room.camera);
  ASSERT_FALSE(techniques.empty());
  double found = 0;
  for (std::uint32_t i = 0; i < techniques.size(); ++i) {
    EXPECT_LE(techniques[i].edges, 3u);
    result.read_technique(room.camera, i, UPS_CONTRIBUTION_WEIGHTED, filled);
    for (const float value : filled) found += value;
  }
  EXPECT_GT(found, 0);
}

TEST(Results, OfGoniometersAreProfiles) {
  Room room;
  ups::Scene scene(room.context);
  scene.add_luminaire({downlight(room.context), ups::Transform()});
  const std::vector<float> c_deg = {0}, gamma_deg = {0, 30, 60, 90, 120, 150, 180};
  ups::GoniometerDesc desc(c_deg, gamma_deg);
  desc.symmetry = UPS_SYMMETRY_AXIAL;
  const auto goniometer = scene.add_goniometer(desc);
  scene.commit();
  const ups::Result result = scene.render(Room::few(16));
  const ups_goniometer_info info = result.get_goniometer_info(goniometer);
  const ups::GoniometerAngles angles = result.get_goniometer_angles(goniometer);
  EXPECT_EQ(angles.gamma_deg, gamma_deg);
  EXPECT_EQ(angles.c_deg, c_deg);
  const auto intensity = result.read_goniometer(goniometer);
  ASSERT_EQ(intensity.size(), std::size_t{info.c_count} * info.gamma_count);
  EXPECT_GT(intensity[0].intensity_cd, 500);
  EXPECT_GT(result.get_goniometer_beam(goniometer, 0, 0.5f).angle_deg, 60);
  EXPECT_NEAR(result.get_goniometer_profile(goniometer).get_info().interpolated_flux_lm, info.flux_lm,
              1e-5 * info.flux_lm);
}

TEST(Results, OfObserversNameTheirSources) {
  Room room;
  const std::vector<float> c_deg = {0}, gamma_deg = {0, 90}, intensity_cd = {1000, 300};
  ups::ProfileDesc panel(c_deg, gamma_deg, intensity_cd);
  panel.opening_shape = UPS_OPENING_RECTANGLE;
  panel.opening_m[0] = panel.opening_m[1] = 0.6f;
  const ups::Profile profile(room.context, panel);
  const auto lamp = room.scene.add_luminaire({profile, ups::Transform::translation(3, 1.5, 2.4)});
  room.scene.remove_luminaire(room.lamp);
  const auto eye = room.scene.add_observer(ups::ObserverDesc(ups::Transform::look_at({0.3, 1.5, 1.2}, {3, 1.5, 1.2})));
  room.scene.commit();
  const ups::Result result = room.scene.render(Room::few(16));
  const ups_observer_reading reading = result.get_observer(eye);
  EXPECT_GT(reading.ugr, 5);
  const auto sources = result.glare_sources(eye);
  ASSERT_EQ(sources.size(), 1u);
  EXPECT_EQ(sources[0].id, lamp.v);
  EXPECT_GT(result.read_meters(eye)[0].illuminance_lx, 1) << "an eye is a meter too";
}

TEST(Results, HaveSamplesThatAreTracedAgain) {
  Room room;
  room.scene.commit();
  const ups::Result result = room.scene.render(Room::few());
  const auto samples = result.read_largest_samples(room.meters);
  ASSERT_FALSE(samples.empty());
  const ups::Path path = room.scene.replay(Room::few(), samples[0]);
  EXPECT_NEAR(path.get_info().value, samples[0].value, 1e-3 * samples[0].value);
  EXPECT_FALSE(path.read_vertices().empty());
  EXPECT_EQ(path.read_contributions().size(), path.get_info().contributions);
  EXPECT_NE(path.get_text(), "");
  ups_sample other = samples[0];
  other.iteration = 0;
  other.index = 1000;
  expect_error(UPS_ERROR_INVALID_ARGUMENT, {}, [&] { room.scene.replay(Room::few(), other); });
}

}  // namespace
