// The samples that weigh most in a result, and each of them traced again alone.
#include <gtest/gtest.h>

#include <map>
#include <set>
#include <string>

#include "../support/scene_builder.h"

namespace ups::test {
namespace {

class Path {
 public:
  Path(const Scene& scene, const RenderOptions& options, const ups_sample& sample) {
    const ups_render_desc desc = Scene::desc_of(options);
    ups_path* path = nullptr;
    check(ups_replay(scene.get(), &desc, &sample, &path), "ups_replay");
    path_.reset(path);
  }
  ups_path_info info() const {
    ups_path_info i{};
    i.struct_size = sizeof i;
    check(ups_path_get_info(path_.get(), &i), "ups_path_get_info");
    return i;
  }
  std::vector<ups_path_vertex> vertices() const { return read<ups_path_vertex>(&ups_path_read_vertices); }
  std::vector<ups_path_contribution> contributions() const {
    return read<ups_path_contribution>(&ups_path_read_contributions);
  }
  std::string text() const {
    size_t needed = 0;
    check(ups_path_get_text(path_.get(), nullptr, 0, &needed), "ups_path_get_text");
    std::string out(needed, ' ');
    check(ups_path_get_text(path_.get(), out.data(), needed, &needed), "ups_path_get_text");
    return out.c_str();
  }

 private:
  template <class T>
  std::vector<T> read(ups_status (*function)(const ups_path*, T*, size_t, size_t*)) const {
    size_t count = 0;
    check(function(path_.get(), nullptr, 0, &count), "size of an array");
    std::vector<T> out(count);
    check(function(path_.get(), out.data(), count, &count), "array");
    return out;
  }
  std::unique_ptr<ups_path, decltype(&ups_path_destroy)> path_{nullptr, ups_path_destroy};
};

// A closed room with a mirror and a glass ball under a point light, meters that light paths land on and are merged at,
// and a small camera: samples of every technique.
struct Room {
  Scene scene;
  Sensor points, cells, camera, solid, vectors;
  explicit Room(int threads = 0) : scene(threads) {
    scene.add(box({0, 0, 0}, {4, 3, 2.5}).flipped(), matte(0.6));
    scene.add(quad({1, 2.9, 0.5}, {2, 0, 0}, {0, 0, 1.5}), mirror(0.9));
    scene.add(icosphere({1.2, 1.2, 0.6}, 0.4, 3), glass(1.5));
    scene.add_point_light({2, 1.5, 2.2}, 100);
    points = scene.add_meters({{1.2, 1.2, 0}, {3, 2, 0}, {0.5, 0.5, 1}}, {0, 0, 1});
    cells = scene.add_cells({{1.2, 1.2, 0.001}, {2.5, 1, 0.8}}, {{0, 0, 1}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 0}}, 0.2, 0.2);
    scene.set_meter_kind(UPS_METER_CYLINDRICAL);
    solid = scene.add_meters({{1.2, 1.2, 0.1}, {3, 2, 1.2}}, {0, 0, 1});
    scene.set_meter_kind(UPS_METER_VECTOR);
    vectors = scene.add_meters({{1.2, 1.2, 0.1}, {3, 2, 1.2}}, {0, 0, 1});
    camera = scene.add_camera({3.5, 0.5, 1.6}, {-1, 0.5, -0.6}, 12, 8, 1.0);
  }
};

constexpr RenderOptions by_ups{.method = UPS_METHOD_UPS, .iterations = 12, .seed = 3, .light_paths = 4096};

TEST(LargestSamples, AreSharesOfTheirReadingsInOrder) {
  Room room;
  const Result result = room.scene.render(by_ups);
  EXPECT_EQ(result.largest_samples(room.camera).size(), 64u);
  for (const Sensor& sensor : {room.points, room.cells}) {
    const std::vector<ups_sample> samples = result.largest_samples(sensor);
    ASSERT_EQ(samples.size(), sensor.count);
    const double mean = result.statistics(sensor).mean_lx;
    std::set<uint32_t> meters;
    for (size_t i = 0; i < samples.size(); ++i) {
      const ups_sample& s = samples[i];
      if (i > 0) EXPECT_LE(s.share, samples[i - 1].share);
      EXPECT_TRUE(meters.insert(s.index).second) << "twice: " << s.index;
      EXPECT_LT(s.iteration, by_ups.iterations);
      EXPECT_EQ(s.seed, by_ups.seed);
      const double lx = double(result.readings(sensor)[s.index].illuminance_lx);
      EXPECT_FLOAT_EQ(s.share, float(double(s.value) / by_ups.iterations / std::max(lx, 0.05 * mean)));
    }
  }
}

TEST(LargestSamples, AreTheSameForAnyThreadCount) {
  Room room(2), alone(1);
  const Result by_two = room.scene.render(by_ups), by_one = alone.scene.render(by_ups);
  for (Sensor Room::*sensor : {&Room::points, &Room::cells, &Room::camera}) {
    const std::vector<ups_sample> a = by_two.largest_samples(room.*sensor), b = by_one.largest_samples(alone.*sensor);
    ASSERT_EQ(a.size(), b.size());
    for (size_t i = 0; i < a.size(); ++i) {
      EXPECT_EQ(a[i].index, b[i].index);
      EXPECT_EQ(a[i].iteration, b[i].iteration);
      EXPECT_EQ(a[i].walk, b[i].walk);
      EXPECT_EQ(a[i].path, b[i].path);
      EXPECT_EQ(a[i].value, b[i].value);
    }
  }
}

class ReplayedSamples : public testing::TestWithParam<ups_method> {};

TEST_P(ReplayedSamples, BringWhatTheyBroughtBefore) {
  Room room;
  RenderOptions options = by_ups;
  options.method = GetParam();
  const Result result = room.scene.render(options);
  std::vector<ups_sample> samples;
  for (const Sensor& sensor : {room.points, room.cells, room.camera, room.solid, room.vectors})
    for (const ups_sample& s : result.largest_samples(sensor)) samples.push_back(s);
  std::map<std::pair<uint32_t, ups_walk>, int> seen;
  for (const ups_sample& s : samples) {
    if (++seen[{s.sensor.v, s.walk}] > 3) continue;
    const Path path(room.scene, options, s);
    const ups_path_info info = path.info();
    const bool disc = s.sensor.v != room.cells.id.v && s.sensor.v != room.camera.id.v && s.walk == UPS_WALK_LIGHT;
    // Of a disc the reading takes the middle, which makes its photons count for more.
    if (disc)
      EXPECT_GE(s.value, info.value * (1 - 1e-5));
    else
      EXPECT_NEAR(s.value, info.value, 1e-5 * info.value);
    const auto contributions = path.contributions();
    ASSERT_EQ(contributions.size(), info.contributions);
    ASSERT_FALSE(contributions.empty());
    double sum = 0;
    for (const auto& c : contributions) {
      sum += c.value;
      EXPECT_GT(c.weight, 0);
      EXPECT_LE(c.weight, 1);
      EXPECT_LT(c.walk, info.walks);
    }
    EXPECT_NEAR(s.walk == UPS_WALK_EYE ? sum : double(contributions[0].value), info.value, 1e-4 * info.value);
    const auto vertices = path.vertices();
    ASSERT_FALSE(vertices.empty());
    EXPECT_EQ(vertices[0].event, UPS_EVENT_START);
    EXPECT_EQ(vertices.back().walk + 1, info.walks);
    for (const auto& v : vertices) {
      EXPECT_TRUE(std::isfinite(v.pdf) && std::isfinite(v.throughput));
      EXPECT_EQ(v.instance.v == 0, v.event == UPS_EVENT_START);
      for (const double x : v.position_m) EXPECT_TRUE(x > -0.01 && x < 4.01) << x;
    }
    EXPECT_NE(path.text().find("weight"), std::string::npos);
  }
  EXPECT_GE(seen.size(), 3u);
}

INSTANTIATE_TEST_SUITE_P(Methods, ReplayedSamples,
                         testing::Values(UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_AUTO,
                                         UPS_METHOD_LIGHT_TRACING, UPS_METHOD_SPPM),
                         [](const auto& i) { return "method" + std::to_string(i.param); });

TEST(Replay, SaysWhatIsWrongWithAnAddress) {
  Room room;
  ups_sample good = room.scene.render(by_ups).largest_samples(room.camera)[0];
  const ups_render_desc desc = Scene::desc_of(by_ups);
  ups_path* path = nullptr;
  const auto expect = [&](const ups_sample& s, const char* word) {
    EXPECT_EQ(ups_replay(room.scene.get(), &desc, &s, &path), UPS_ERROR_INVALID_ARGUMENT) << word;
    EXPECT_NE(std::string(ups_last_error()).find(word), std::string::npos) << ups_last_error();
  };
  ups_sample bad = good;
  bad.sensor.v = 0;
  expect(bad, "sensor");
  bad = good, bad.index = 100000;
  expect(bad, "index");
  bad = good, bad.walk = 2;
  expect(bad, "walk");
  bad = good, bad.walk = UPS_WALK_LIGHT, bad.path = 1u << 20;
  expect(bad, "no such path");
  bad = good, bad.walk = UPS_WALK_EYE, bad.path = 1;
  expect(bad, "eye paths of a pixel are 1");
  bad.sensor = room.points.id, bad.index = 0, bad.path = 1u << 20;
  expect(bad, "eye paths of a meter are ");
  EXPECT_EQ(ups_replay(room.scene.get(), &desc, nullptr, &path), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(ups_replay(nullptr, &desc, &good, &path), UPS_ERROR_INVALID_ARGUMENT);
  EXPECT_EQ(path, nullptr);
  ups_path_destroy(nullptr);
}

}  // namespace
}  // namespace ups::test
