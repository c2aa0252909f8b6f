// The samples that weigh most in a result, and each of them traced again alone.
#include <gtest/gtest.h>

#include <cstdio>
#include <map>
#include <set>
#include <sstream>
#include <string>

#include "../support/fresnel.h"
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
  ups_instance_id walls, ball;
  explicit Room(int threads = 0) : scene(threads) {
    walls = scene.add(box({0, 0, 0}, {4, 3, 2.5}).flipped(), matte(0.6));
    scene.add(quad({1, 2.9, 0.5}, {2, 0, 0}, {0, 0, 1.5}), mirror(0.9));
    ball = scene.add(icosphere({1.2, 1.2, 0.6}, 0.4, 3), glass(1.5));
    scene.add_point_light({2, 1.5, 2.2}, 100);
    points = scene.add_meters({{1.2, 1.2, 0}, {3, 2, 0}, {0.5, 0.5, 1}}, {0, 0, 1});
    cells =
        scene.add_cells({{1.2, 1.2, 0.001}, {2.5, 1, 0.8}}, {{0, 0, 1}, {0, 0, 1}}, {{1, 0, 0}, {1, 0, 0}}, 0.2, 0.2);
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

// cos / pi where a matte wall has scattered, at glass the probabilities of its Fresnel choice, 1 at a mirror. Counts
// what it has judged, by event.
void expect_known_densities(const std::vector<ups_path_vertex>& path, const Room& room, std::map<int, int>& judged) {
  const auto place = [](const ups_path_vertex& v) { return P3{v.position_m[0], v.position_m[1], v.position_m[2]}; };
  for (size_t i = 1; i + 1 < path.size(); ++i) {
    const ups_path_vertex& v = path[i];
    if (v.event == UPS_EVENT_START || v.event == UPS_EVENT_END || path[i + 1].walk != v.walk) continue;
    EXPECT_GT(v.pdf, 0) << "event " << v.event;
    // A ray starts up to so far off its surface, which turns the way to a place right beside it.
    constexpr double lifted_m = 1e-5;
    const P3 way = place(path[i + 1]) - place(v);
    const P3 normal{v.normal[0], v.normal[1], v.normal[2]};
    double known = 1;  // of the mirror
    if (v.instance.v == room.walls.v)
      known = std::abs(dot(normal, normalize(way))) / pi_d;
    else if (v.instance.v == room.ball.v) {
      const P3 outward = place(v) - P3{1.2, 1.2, 0.6}, to = normalize(place(path[i - 1]) - place(v));
      const double cosine = dot(normal, to) * (dot(normal, outward) > 0 ? 1 : -1);
      const double reflected = fresnel(cosine, 1.5);
      known = v.event == UPS_EVENT_MIRRORED ? reflected : 1 - reflected;
    }
    EXPECT_NEAR(v.pdf, known, 2e-3 * known + 1e-5 + lifted_m / (pi_d * std::sqrt(dot(way, way))))
        << "event " << v.event << " of instance " << v.instance.v;
    ++judged[v.event];
  }
}

// Those that begin with the start of a walk, or with a vertex's number and its instance.
size_t lines_of_vertices(const std::string& text) {
  size_t lines = 0;
  std::istringstream in(text);
  for (std::string line; std::getline(in, line);) {
    unsigned number = 0, instance = 0;
    lines += line.starts_with("Eye path from ") || line.starts_with("Light path ") ||
             std::sscanf(line.c_str(), "%u instance %u at", &number, &instance) == 2;
  }
  return lines;
}

// Contributions whose densities the text tells.
size_t told_in_full(const std::string& text) {
  size_t count = 0;
  const std::string told = "densities of all techniques over its own";
  for (size_t at = 0; (at = text.find(told, at)) != std::string::npos; ++at) ++count;
  return count;
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
  std::map<int, int> judged;
  uint32_t most_walks = 0;
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
    // What is not told in full, with the vertices of its light path, is a hundredth at most.
    const size_t told = told_in_full(path.text());
    double untold = 0;
    for (size_t i = 0; i < contributions.size(); ++i)
      if (i >= told || (contributions[i].light_path != UINT32_MAX && contributions[i].walk == 0))
        untold += contributions[i].value;
    EXPECT_LE(untold, 0.0101 * sum) << path.text();
    most_walks = std::max(most_walks, info.walks);
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
    expect_known_densities(vertices, room, judged);
    EXPECT_EQ(lines_of_vertices(path.text()), vertices.size()) << path.text();
    EXPECT_NE(path.text().find("weight"), std::string::npos);
  }
  for (const int event : {UPS_EVENT_SCATTERED, UPS_EVENT_MIRRORED, UPS_EVENT_REFRACTED}) EXPECT_GT(judged[event], 5);
  EXPECT_GE(seen.size(), 3u);
  if (GetParam() == UPS_METHOD_PPM) EXPECT_GT(most_walks, 20u) << "pixels merge with more photons than a handful";
}

INSTANTIATE_TEST_SUITE_P(Methods, ReplayedSamples,
                         testing::Values(UPS_METHOD_UPS, UPS_METHOD_BIDIRECTIONAL, UPS_METHOD_AUTO,
                                         UPS_METHOD_LIGHT_TRACING, UPS_METHOD_SPPM, UPS_METHOD_PPM,
                                         UPS_METHOD_PATH_TRACING),
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
