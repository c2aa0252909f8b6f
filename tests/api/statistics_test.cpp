// Percentiles, shares and ratios of meters, and the maintenance factor, through the C API.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/scene_builder.h"

namespace ups::test {
namespace {

constexpr int count = 40;

// Matte, lit from the middle of the ceiling: a row of meters and one of the wall.
struct Room {
  Scene scene;
  Sensor floor, wall;

  Room() {
    scene.add(box({0, 0, 0}, {4, 3, 2.6}).flipped(), matte(0.5));
    scene.add_luminaire(table_profile(scene.context(), 0).get(), {2, 1.5, 2.5}, {0, 0, -1}, false);
    std::vector<P3> points, on_wall;
    for (int i = 0; i < count; ++i) points.push_back({0.2 + 0.09 * i, 0.7, 0.75}), on_wall.push_back({0.2 + 0.09 * i, 0, 1});
    floor = scene.add_meters(points, {0, 0, 1});
    wall = scene.add_meters(on_wall, {0, 1, 0});
  }
  Result render(uint32_t iterations = 64) { return scene.render({.iterations = iterations, .light_paths = 1u << 12}); }
};

// Also of an observer's eye.
TEST(Statistics, OfOneMeterAreItsReading) {
  Room room;
  const Sensor one = room.scene.add_meters({{1, 1, 0.75}}, {0, 0, 1});
  const Result r = room.render();
  const ups_meter_reading m = r.readings(one)[0];
  const ups_meter_statistics s = r.statistics(one);
  ASSERT_GT(m.error_bound_lx, 0.001f * m.illuminance_lx) << "or the test shows nothing";
  const double low = double(m.illuminance_lx) - double(m.error_bound_lx),
               high = double(m.illuminance_lx) + double(m.error_bound_lx), near = 1e-5 * high;
  for (const double value : {s.mean_lx, s.min_lx, s.max_lx, s.percentile_5_lx})
    EXPECT_NEAR(value, double(m.illuminance_lx), near);
  for (const double end : {s.min_low_lx, s.max_low_lx, s.percentile_5_low_lx}) EXPECT_NEAR(end, low, near);
  for (const double end : {s.min_high_lx, s.max_high_lx, s.percentile_5_high_lx}) EXPECT_NEAR(end, high, near);
  for (const double one_of_two : {s.uniformity, s.uniformity_low, s.uniformity_high, s.diversity, s.diversity_low,
                                  s.diversity_high})
    EXPECT_EQ(one_of_two, 1);
  ups_interval median{};
  check(ups_result_get_meter_percentile(r.get(), one.id, 0.5, &median), "ups_result_get_meter_percentile");
  EXPECT_NEAR(median.low, low, near);
  EXPECT_NEAR(median.high, high, near);
}

using Read = ups_status (*)(const ups_result*, ups_sensor_id, double, ups_interval*);
ups_interval ask(Read read, const Result& r, const Sensor& s, double at) {
  ups_interval i{};
  check(read(r.get(), s.id, at, &i), "a statistic");
  return i;
}

TEST(Statistics, PercentilesAreThoseOfTheReadings) {
  Room room;
  const Result r = room.render();
  std::vector<float> sorted;
  for (const auto& m : r.readings(room.floor)) sorted.push_back(m.illuminance_lx);
  std::sort(sorted.begin(), sorted.end());
  const std::pair<double, size_t> ranks[] = {{0, 0}, {0.05, 2}, {0.5, 20}, {0.9, 36}, {1, 39}};
  for (const auto& [share, rank] : ranks) {
    const ups_interval i = ask(ups_result_get_meter_percentile, r, room.floor, share);
    EXPECT_NEAR(i.value, sorted[rank], 1e-4 * sorted[rank]) << share;
    EXPECT_LE(i.low, i.value);
    EXPECT_GE(i.high, i.value);
    EXPECT_LT(i.high - i.low, 0.1 * i.value) << "or it says nothing";
  }
  const ups_meter_statistics s = r.statistics(room.floor);
  const ups_interval fifth = ask(ups_result_get_meter_percentile, r, room.floor, 0.05);
  EXPECT_EQ(fifth.value, s.percentile_5_lx);
  EXPECT_EQ(fifth.low, s.percentile_5_low_lx);
  EXPECT_EQ(fifth.high, s.percentile_5_high_lx);
  EXPECT_NEAR(s.diversity, sorted.front() / sorted.back(), 1e-6);
  EXPECT_LE(s.diversity_low, s.diversity);
  EXPECT_GE(s.diversity_high, s.diversity);
}

// Many meters are visited in turn: a fifth of these four times, for which there are errors, the others three times.
TEST(Statistics, ErrorsOfSomeMetersAreNotThoseOfTheSet) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 3, 2.6}).flipped(), matte(0.5));
  scene.add_luminaire(table_profile(scene.context(), 0).get(), {2, 1.5, 2.5}, {0, 0, -1}, false);
  std::vector<P3> points;
  for (int i = 0; i < 100000; ++i) points.push_back({0.2 + 0.01 * (i % 350), 0.2 + 0.009 * (i / 350), 0.75});
  const Sensor floor = scene.add_meters(points, {0, 0, 1});
  for (const uint32_t iterations : {16u, 20u}) {
    const Result r = scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = iterations, .max_path_length = 2});
    const auto readings = r.readings(floor);
    const auto known =
        std::count_if(readings.begin(), readings.end(), [](const auto& m) { return m.error_bound_lx >= 0; });
    EXPECT_EQ(known, iterations == 16 ? 20000 : 100000);
    const ups_meter_statistics s = r.statistics(floor);
    for (const double error : {s.median_relative_error_bound, s.p95_relative_error_bound, s.worst_relative_error_bound,
                               s.mean_error_bound_lx})
      EXPECT_EQ(error >= 0, iterations == 20) << error;
  }
}

TEST(Statistics, SharesCountReadings) {
  Room room;
  const Result r = room.render();
  std::vector<float> sorted;
  for (const auto& m : r.readings(room.floor)) sorted.push_back(m.illuminance_lx);
  std::sort(sorted.begin(), sorted.end());
  const ups_interval half = ask(ups_result_get_meter_share, r, room.floor, 0.5 * (sorted[19] + sorted[20]));
  EXPECT_EQ(half.value, 0.5);
  EXPECT_LE(half.low, 0.5);
  EXPECT_GE(half.high, 0.5);
  EXPECT_GT(half.high - half.low, 0);
  const ups_interval all = ask(ups_result_get_meter_share, r, room.floor, 0), none = ask(ups_result_get_meter_share, r,
                                                                                         room.floor, 1e6);
  for (const double v : {all.value, all.low, all.high}) EXPECT_EQ(v, 1);
  for (const double v : {none.value, none.low, none.high}) EXPECT_EQ(v, 0);
}

TEST(Statistics, RatiosAreThoseOfMeansAndOfMeters) {
  Room room;
  const Result r = room.render();
  ups_interval means{};
  check(ups_result_get_meter_ratio(r.get(), room.wall.id, room.floor.id, &means), "ups_result_get_meter_ratio");
  EXPECT_NEAR(means.value, r.statistics(room.wall).mean_lx / r.statistics(room.floor).mean_lx, 1e-6);
  EXPECT_LT(means.low, means.value);
  EXPECT_GT(means.high, means.value);
  std::vector<ups_interval> each(count);
  check(ups_result_read_meter_ratios(r.get(), room.wall.id, room.floor.id, each.data(), count), "of meters");
  const auto wall = r.readings(room.wall), floor = r.readings(room.floor);
  for (int i = 0; i < count; ++i)
    EXPECT_NEAR(each[size_t(i)].value, wall[size_t(i)].illuminance_lx / floor[size_t(i)].illuminance_lx, 1e-4) << i;
}

TEST(Statistics, OfTooFewIterationsNoIntervalIsKnown) {
  Room room;
  const Result r = room.render(4);
  const ups_interval p = ask(ups_result_get_meter_percentile, r, room.floor, 0.5);
  EXPECT_GT(p.value, 0);
  EXPECT_EQ(p.low, -1);
  EXPECT_EQ(p.high, -1);
  EXPECT_EQ(ask(ups_result_get_meter_share, r, room.floor, 1).low, -1);
}

TEST(Statistics, WrongArgumentsAreTold) {
  Room room;
  const Result r = room.render(4);
  ups_interval i{};
  const auto expect = [](ups_status status, const std::string& text) {
    EXPECT_EQ(status, UPS_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(ups_last_error()).find(text), std::string::npos) << ups_last_error();
  };
  expect(ups_result_get_meter_percentile(r.get(), room.floor.id, 1.5, &i), "share is 1.5");
  expect(ups_result_get_meter_percentile(r.get(), room.floor.id, NAN, &i), "share is nan");
  expect(ups_result_get_meter_percentile(r.get(), {0}, 0.5, &i), "sensor id 0");
  expect(ups_result_get_meter_percentile(nullptr, room.floor.id, 0.5, &i), "result is NULL");
  expect(ups_result_get_meter_percentile(r.get(), room.floor.id, 0.5, nullptr), "out is NULL");
  expect(ups_result_get_meter_share(r.get(), room.floor.id, INFINITY, &i), "threshold_lx");
  expect(ups_result_read_meter_ratios(r.get(), room.floor.id, room.wall.id, &i, 1), "the numerator has 40");
}

// ---- maintenance factor ----

double mean_with(Scene& scene, const Sensor& meters, double factor) {
  check(ups_scene_set_maintenance_factor(scene.get(), factor), "ups_scene_set_maintenance_factor");
  const Result r = scene.render({.iterations = 16});
  EXPECT_EQ(r.info().maintenance_factor, factor);
  return r.statistics(meters).mean_lx;
}

std::string warnings_of(const Scene& scene) {
  size_t needed = 0;
  ups_scene_get_text(scene.get(), UPS_SCENE_TEXT_WARNINGS, nullptr, 0, &needed);
  std::string text(needed, ' ');
  check(ups_scene_get_text(scene.get(), UPS_SCENE_TEXT_WARNINGS, text.data(), needed, &needed), "ups_scene_get_text");
  return text;
}

TEST(MaintenanceFactor, MultipliesLuminairesInEveryReading) {
  Room room;
  const double initial = mean_with(room.scene, room.floor, 1), maintained = mean_with(room.scene, room.floor, 0.8);
  EXPECT_NEAR(maintained / initial, 0.8, 1e-5);  // the same paths
  EXPECT_EQ(warnings_of(room.scene).find("maintenance"), std::string::npos);
}

TEST(MaintenanceFactor, LeavesLightsAlone) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 3, 2.6}).flipped(), matte(0.5));
  scene.add_spot({2, 1.5, 2.5}, {0, 0, -1}, 1000, 0.3, 1.2);
  const Sensor meters = scene.add_meters({{1, 1, 0.75}, {2, 1, 0.75}}, {0, 0, 1});
  const double initial = mean_with(scene, meters, 1), maintained = mean_with(scene, meters, 0.8);
  EXPECT_EQ(initial, maintained);
  const std::string told = warnings_of(scene);
  EXPECT_NE(told.find("maintenance factor 0.8"), std::string::npos) << told;
  EXPECT_NE(told.find("1 light or emitting surface keeps"), std::string::npos) << told;
}

TEST(MaintenanceFactor, MustBeAShare) {
  Scene scene;
  for (const double factor : {0.0, -1.0, 1.01, double(NAN), double(INFINITY)}) {
    EXPECT_EQ(ups_scene_set_maintenance_factor(scene.get(), factor), UPS_ERROR_INVALID_ARGUMENT);
    EXPECT_NE(std::string(ups_last_error()).find("above 0 and at most 1"), std::string::npos) << ups_last_error();
  }
}

}  // namespace
}  // namespace ups::test
