// What accuracy costs, through the C API: predictions against what longer renders took, criteria of the target, the
// curve. Times are iterations: the same bits on any machine.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <functional>

#include "../support/scene_builder.h"

namespace ups::test {
namespace {

struct Outcome {
  std::unique_ptr<ups_result, decltype(&ups_result_destroy)> result{nullptr, ups_result_destroy};

  ups_prediction predict(double error) const {
    ups_prediction p{};
    p.struct_size = sizeof p;
    check(ups_result_get_prediction(result.get(), error, &p), "ups_result_get_prediction");
    return p;
  }
  std::vector<ups_curve_point> curve() const {
    uint32_t count = 0;
    check(ups_result_get_curve_count(result.get(), &count), "ups_result_get_curve_count");
    std::vector<ups_curve_point> all(count);
    for (uint32_t i = 0; i < count; ++i) {
      all[i].struct_size = sizeof all[i];
      check(ups_result_get_curve_point(result.get(), i, &all[i]), "ups_result_get_curve_point");
    }
    return all;
  }
};

Outcome render(const Scene& scene, const std::function<void(ups_render_desc&)>& set) {
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  set(d);
  ups_result* result = nullptr;
  check(ups_render(scene.get(), &d, &result), "ups_render");
  Outcome o;
  o.result.reset(result);
  return o;
}

// By path tracing; the caller owns the job.
ups_job* start(const Scene& scene, const std::function<void(ups_render_desc&)>& set) {
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  d.method = UPS_METHOD_PATH_TRACING;
  set(d);
  ups_job* job = nullptr;
  check(ups_job_start(scene.get(), &d, &job), "ups_job_start");
  return job;
}

// Matte, two spots.
void make_room(Scene& scene) {
  scene.add(box({0, 0, 0}, {4, 3, 2.6}).flipped(), matte(0.5));
  for (double x : {1.0, 3.0}) scene.add_spot({x, 1.5, 2.5}, {0, 0, -1}, 1000, 0.3, 1.2);
}

// 6 meters in it.
void make_office(Scene& scene) {
  make_room(scene);
  std::vector<P3> points;
  for (int i = 0; i < 6; ++i) points.push_back({0.7 + 1.3 * (i % 3), 0.7 + 1.6 * (i / 3), 0.75});
  scene.add_meters(points, {0, 0, 1});
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
}

// Iterations to the error that a render ends with, from one of a quarter of them.
struct Foretold {
  double ratio;  // over the real ones
  double low, high;
  bool was_reached;  // within that quarter
  bool holds() const { return low <= 1 && (high < 0 || high >= 1); }
};

Foretold foretold_from_a_quarter(const Scene& scene, uint32_t iterations, const ups_render_desc& desc) {
  const auto of = [&](uint32_t count) {
    return render(scene, [&](ups_render_desc& d) {
      d = desc;
      d.iteration_count = count;
    });
  };
  const ups_curve_point end = of(iterations).curve().back();
  const Outcome quarter = of(iterations / 4);
  const ups_prediction p = quarter.predict(end.worst_relative_error);
  const double ratio = p.iterations / end.iterations;
  const auto relative = [&](double seconds) { return seconds < 0 ? -1 : seconds / p.seconds * ratio; };
  return {ratio, relative(p.seconds_low), relative(p.seconds_high),
          p.iterations <= quarter.curve().back().iterations};
}

// One render's own last look strays by some 10 % itself, that is 20 % of the time; and of six meters, which take 256 paths
// an iteration each, stratification makes noise fall faster than it is foretold to: 1.24 times too long a time, in the
// geometric mean of 24 seeds. Of 6, no more than one is off from that by more than a factor of 1.6, and their mean by 1.3.
TEST(Accuracy, NoiseOfAnOfficeIsForetold) {
  Scene scene;
  make_office(scene);
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  d.method = UPS_METHOD_PATH_TRACING;
  constexpr double too_long = 1.24;
  int far = 0;
  double mean = 0;
  const uint32_t seeds = less_with_effort(6, 2);
  for (d.seed = 1; d.seed <= seeds; ++d.seed) {
    const double ratio = foretold_from_a_quarter(scene, 124, d).ratio;
    ASSERT_GT(ratio, 0);
    far += std::abs(std::log(ratio / too_long)) > std::log(1.6);
    mean += std::log(ratio) / seeds;
  }
  EXPECT_LE(far, 1);
  EXPECT_NEAR(mean, std::log(too_long), std::log(1.3));
}

// A mirror throws a patch of light into a black room; the outer meters stand near its edge, so that bias is what
// remains. A disc is kept until its bias shows, and then a narrower one is taken: no power of the time, so that the worst
// meter's error falls by leaps and now and then rises. A time foretold of that is no good (3.7 times too long in the median
// of 29 renders), but its interval must say so: from a half of it to ten times it and more. It holds in 26 of 29, and two
// of 8 may miss it. Where the error was as low once before by chance that is told, which foretells nothing.
TEST(Accuracy, BiasAtAnEdgeIsForetoldByAnInterval) {
  Scene scene;
  scene.add(box({0, 0, 0}, {6, 6, 3}).flipped(), matte(0));
  scene.add(quad({2.8, 2.8, 2.999}, {0, 0.4, 0}, {0.4, 0, 0}), photon_mirror(0.9));
  scene.add_point_light({2.9, 3, 0.9}, 1000);
  std::vector<P3> points;
  for (int i = 0; i < 25; ++i) points.push_back({2.75 + 0.175 * (i / 5), 2.65 + 0.175 * (i % 5), 0.95});
  scene.add_meters(points, {0, 0, 1});
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  d.light_paths_per_iteration = paths_with_effort(16384);
  int foretold = 0, missed = 0;
  for (d.seed = 1; d.seed <= 8; ++d.seed) {
    const Foretold f = foretold_from_a_quarter(scene, 243, d);
    foretold += !f.was_reached;
    missed += !f.was_reached && !f.holds();
  }
  EXPECT_GE(foretold, 5);
  EXPECT_LE(missed, 2);
}

// An eye beside a camera is soon known: the picture decides, as it does without. (A picture of many pixels is visited in
// parts: an eye would be known long before every pixel is.) Nor does one in a dark box of its own keep meters waiting.
TEST(Accuracy, ObserversDecideNothing) {
  for (const bool meters : {false, true}) {
    uint32_t iterations[2];
    for (const bool eye : {false, true}) {
      Scene scene;
      make_room(scene);
      scene.add(box({20, 20, 0}, {22, 22, 2}).flipped(), matte(0.5));
      const Sensor sensor = meters ? scene.add_meters({{1, 1, 0.75}, {2, 2, 0.75}}, {0, 0, 1})
                                   : scene.add_camera({0.5, 0.5, 1.5}, {1, 0.9, -0.1}, 200, 180, 1.2);
      if (eye) scene.add_observer({meters ? 21 : 0.5, meters ? 21 : 1.5, 1.2}, {1, 0, 0});
      check(ups_scene_commit(scene.get()), "ups_scene_commit");
      const Outcome o = render(scene, [&](ups_render_desc& d) {
        d.method = UPS_METHOD_PATH_TRACING;
        d.target_relative_error = meters ? 0.01f : 0.2f;
      });
      iterations[eye] = o.curve().back().iterations;
      ups_largest_error worst{};
      worst.struct_size = sizeof worst;
      if (meters) {
        check(ups_result_get_largest_error(o.result.get(), &worst), "ups_result_get_largest_error");
        EXPECT_EQ(worst.sensor.v, sensor.id.v);
        continue;
      }
      std::vector<float> bounds(size_t(200) * 180);
      check(ups_result_read_image(o.result.get(), sensor.id, UPS_CHANNEL_ERROR_BOUND, bounds.data(), 0,
                                  bounds.size() * sizeof(float)),
            "ups_result_read_image");
      EXPECT_GE(*std::min_element(bounds.begin(), bounds.end()), 0) << "a pixel of unknown error";
    }
    EXPECT_EQ(iterations[0], iterations[1]);
  }
}

// Each criterion ends a render at the second look in a row at which its own error is below.
TEST(Accuracy, TargetsAreOfTheirCriterion) {
  Scene scene;
  make_office(scene);
  const auto by = [](ups_criterion criterion, const ups_curve_point& p) {
    return criterion == UPS_CRITERION_P95      ? p.p95_relative_error
           : criterion == UPS_CRITERION_MEAN   ? p.mean_relative_error
           : criterion == UPS_CRITERION_MEDIAN ? p.median_relative_error
                                               : p.worst_relative_error;
  };
  uint32_t of_worst = 0;
  for (ups_criterion c = UPS_CRITERION_DEFAULT; c <= UPS_CRITERION_MEDIAN; ++c) {
    constexpr float target = 0.0012f;
    const Outcome o = render(scene, [&](ups_render_desc& d) {
      d.method = UPS_METHOD_PATH_TRACING;
      d.target_relative_error = target;
      d.target_criterion = c;
    });
    const std::vector<ups_curve_point> all = o.curve();
    ASSERT_GE(all.size(), 3u);
    size_t passed = 0;
    for (size_t i = 0; i < all.size(); ++i) {
      EXPECT_FALSE(passed >= 2 && all[i - 1].iterations >= 32) << "it should have ended, criterion " << c;
      passed = by(c, all[i]) <= target ? passed + 1 : 0;
    }
    EXPECT_GE(passed, 2u) << c;
    EXPECT_EQ(o.predict(target).iterations, all[all.size() - passed].iterations) << "when it was met";
    if (c == UPS_CRITERION_DEFAULT) of_worst = all.back().iterations;
    if (c == UPS_CRITERION_WORST) EXPECT_EQ(all.back().iterations, of_worst) << "the default";
    if (c == UPS_CRITERION_MEDIAN) EXPECT_LT(all.back().iterations, of_worst) << "or the test shows nothing";
  }
}

// A large surface in little light beside a small one in much: what the target is held against is the error that the
// result's statistics tell, which is relative to the mean by area.
TEST(Accuracy, SurfacesAreJudgedByTheirMeanByArea) {
  Scene scene;
  scene.add(box({0, 0, 0}, {10, 10, 3}).flipped(), matte(0.5));
  Shape surface = quad({0.5, 0.5, 0.01}, {8, 0, 0}, {0, 8, 0});
  for (int i = 0; i < 50; ++i) surface.append(quad({9 + 0.01 * i, 9, 0.02}, {0.003, 0, 0}, {0, 0.003, 0}));
  const ups_instance_id id = scene.add(surface, matte(0.5));
  scene.add_point_light({9.25, 9, 0.12}, 100);
  const Sensor meters = scene.add_surface_meters({id}, uint32_t(surface.triangles.size()));
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  const Outcome o = render(scene, [](ups_render_desc& d) {
    d.method = UPS_METHOD_PATH_TRACING;
    d.iteration_count = 32;
  });
  ups_meter_statistics s{};
  s.struct_size = sizeof s;
  check(ups_result_get_meter_statistics(o.result.get(), meters.id, &s), "ups_result_get_meter_statistics");
  const std::vector<ups_curve_point> curve = o.curve();
  EXPECT_EQ(curve.back().iterations, 32u);
  EXPECT_NEAR(curve.back().worst_relative_error / s.worst_relative_error_bound, 1, 1e-3);
}

TEST(Accuracy, TargetsOfPixels) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 3, 2.6}).flipped(), matte(0.5));
  scene.add_spot({1, 1.5, 2.5}, {0, 0, -1}, 1000, 0.3, 1.2);
  scene.add_camera({3.9, 1.5, 1.5}, {-1, 0, 0}, 24, 16, 1);
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  for (const ups_criterion c : {UPS_CRITERION_DEFAULT, UPS_CRITERION_MEDIAN}) {
    const Outcome o = render(scene, [&](ups_render_desc& d) {
      d.method = UPS_METHOD_PATH_TRACING;
      d.target_relative_error = 0.2f;
      d.target_criterion = c;
    });
    const ups_curve_point end = o.curve().back();
    EXPECT_LE(c == UPS_CRITERION_MEDIAN ? end.median_relative_error : end.mean_relative_error, 0.2f);
    EXPECT_EQ(o.predict(0.01).limited_by, UPS_LIMIT_NOISE);
    EXPECT_GT(o.predict(0.01).iterations, end.iterations);
    ups_largest_error e{};
    e.struct_size = sizeof e;
    EXPECT_EQ(ups_result_get_largest_error(o.result.get(), &e), UPS_ERROR_INVALID_STATE) << "there are no meters";
  }
}

// Where nothing is left to chance rounding alone has errors, and the meter that is told has the largest of them.
TEST(Accuracy, TheLargestErrorIsOfItsMeterWhereAllIsExact) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 3, 2.6}).flipped(), matte(0));
  scene.add_spot({3, 1.5, 2.5}, {0, 0, -1}, 1000, 0.3, 1.2);
  scene.add_meters({{0.2, 0.2, 0.75}, {3, 1.5, 0.75}}, {0, 0, 1});  // the first is in the dark
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  const Outcome o = render(scene, [](ups_render_desc& d) { d.iteration_count = 40; });
  ups_largest_error worst{};
  worst.struct_size = sizeof worst;
  check(ups_result_get_largest_error(o.result.get(), &worst), "ups_result_get_largest_error");
  EXPECT_GT(worst.relative_error, 0);
  EXPECT_LT(worst.relative_error, 1e-3);
  EXPECT_EQ(worst.index, 1u);
}

// An image of which each iteration visits a third: its error is looked at, and its render ends, by visits of all
// pixels.
TEST(Accuracy, VisitsOfManyPixelsCount) {
  Scene scene;
  scene.add(box({0, 0, 0}, {4, 3, 2.6}).flipped(), matte(0.5));
  scene.add_spot({1, 1.5, 2.5}, {0, 0, -1}, 1000, 0.3, 1.2);
  scene.add_camera({3.9, 1.5, 1.5}, {-1, 0, 0}, 192, 172, 1);
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  const Outcome o = render(scene, [](ups_render_desc& d) {
    d.method = UPS_METHOD_PATH_TRACING;
    d.target_relative_error = 50;  // met at once
  });
  std::vector<uint32_t> looks;
  for (const ups_curve_point& p : o.curve()) looks.push_back(p.iterations);
  EXPECT_EQ(looks, (std::vector<uint32_t>{16, 3 * 7, 3 * 9, 3 * 12, 3 * 15, 3 * 19, 3 * 24, 3 * 30, 3 * 38}));
}

// The last look by the rule may be old when a render ends: then there is one more.
TEST(Accuracy, ARenderLooksAtItsEnd) {
  Scene scene;
  make_office(scene);
  const auto looks_of = [&](uint32_t count) {
    const Outcome o = render(scene, [&](ups_render_desc& d) {
      d.method = UPS_METHOD_PATH_TRACING;
      d.iteration_count = count;
    });
    std::vector<uint32_t> looks;
    for (const ups_curve_point& p : o.curve()) looks.push_back(p.iterations);
    return looks;
  };
  EXPECT_EQ(looks_of(15), std::vector<uint32_t>());
  EXPECT_EQ(looks_of(19), (std::vector<uint32_t>{16, 19}));
  EXPECT_EQ(looks_of(25), (std::vector<uint32_t>{16, 20, 25}));
  EXPECT_EQ(looks_of(27), (std::vector<uint32_t>{16, 20, 25}));
  EXPECT_EQ(looks_of(31), (std::vector<uint32_t>{16, 20, 25, 31}));
}

TEST(Accuracy, ACancelledRenderLooksNoMore) {
  Scene scene;
  make_office(scene);
  ups_job* job = start(scene, [](ups_render_desc& d) { d.time_limit_s = 1000; });
  ups_progress progress{};
  progress.struct_size = sizeof progress;
  do check(ups_job_poll(job, &progress), "ups_job_poll");
  while (progress.iterations_done < 30);
  ups_job_cancel(job);
  EXPECT_EQ(ups_job_wait(job, 60000), UPS_CANCELLED);
  uint32_t looks = 0;
  check(ups_job_get_curve_count(job, &looks), "ups_job_get_curve_count");
  ups_curve_point point{};
  point.struct_size = sizeof point;
  for (uint32_t i = 0, by_rule = 16; i < looks; ++i, by_rule = (5 * by_rule + 3) / 4) {
    check(ups_job_get_curve_point(job, i, &point), "ups_job_get_curve_point");
    EXPECT_EQ(point.iterations, by_rule);
  }
  ups_job_destroy(job);
}

// In a closed room whose walls emit L and reflect half of all light, every illuminance is 2 pi L. Of 60 renders that a
// target ended, no more miss it than 5 %, 3 renders, allow: above 6 the chance is 3 % were the share that.
TEST(Accuracy, TargetsAreMetByTheTrueError) {
  Scene scene;
  scene.add(box({0, 0, 0}, {2, 2, 2}).flipped(), emitter(10, 0.5));
  const Sensor meters = scene.add_meters({{0.6, 0.7, 0.5}}, {0, 0, 1});
  check(ups_scene_commit(scene.get()), "ups_scene_commit");
  constexpr float target = 0.006f;
  int wrong = 0;
  const uint32_t seeds = less_with_effort(60, 8);
  for (uint64_t seed = 1; seed <= seeds; ++seed) {
    const Outcome o = render(scene, [&](ups_render_desc& d) {
      d.method = UPS_METHOD_PATH_TRACING;
      d.target_relative_error = target;
      d.seed = seed;
    });
    ups_meter_reading r{};
    check(ups_result_read_meters(o.result.get(), meters.id, &r, 1), "ups_result_read_meters");
    wrong += std::abs(r.illuminance_lx / (20 * pi_d) - 1) > target;
  }
  EXPECT_LE(wrong, 6);
}

TEST(Accuracy, CurveAndLargestErrorAreToldLive) {
  Scene scene;
  make_office(scene);
  ups_job* job = start(scene, [](ups_render_desc& d) { d.iteration_count = 40; });
  ups_prediction p{};
  p.struct_size = sizeof p;
  uint32_t before = 0, looks = 0;
  do {
    EXPECT_EQ(ups_job_get_curve_count(job, &looks), UPS_OK);
    EXPECT_EQ(ups_job_get_prediction(job, 1e-4, &p), UPS_OK);
    EXPECT_GE(looks, before);
    if (before > 0) EXPECT_EQ(p.limited_by, UPS_LIMIT_NOISE);
    before = looks;
  } while (ups_job_wait(job, 1) == UPS_TIMEOUT);
  ups_progress progress{};
  progress.struct_size = sizeof progress;
  check(ups_job_poll(job, &progress), "ups_job_poll");
  EXPECT_EQ(ups_job_get_curve_count(job, &looks), UPS_OK);
  ASSERT_EQ(looks, 5u) << "16, 20, 25, 32, 40";
  uint64_t rays = 0;
  ups_curve_point point{};
  point.struct_size = sizeof point;
  for (uint32_t i = 0; i < looks; ++i) {
    EXPECT_EQ(ups_job_get_curve_point(job, i, &point), UPS_OK);
    EXPECT_GT(point.rays, rays);
    EXPECT_GT(point.eye_paths, 0u);
    EXPECT_GT(point.resident_bytes, 1u << 20);
    EXPECT_LE(point.median_relative_error, point.worst_relative_error);
    rays = point.rays;
  }
  EXPECT_EQ(point.worst_relative_error, progress.worst_relative_error);
  ups_largest_error worst{};
  worst.struct_size = sizeof worst;
  EXPECT_EQ(ups_job_get_largest_error(job, &worst), UPS_OK);
  EXPECT_EQ(worst.relative_error, point.worst_relative_error);
  ASSERT_LT(worst.index, 6u);
  EXPECT_NEAR(worst.position_m[0], 0.7 + 1.3 * (worst.index % 3), 1e-5);
  EXPECT_NEAR(worst.position_m[1], 0.7 + 1.6 * (worst.index / 3), 1e-5);
  EXPECT_NEAR(worst.position_m[2], 0.75, 1e-5);
  ups_job_destroy(job);
}

TEST(Accuracy, RefusesWhatMakesNoSense) {
  Scene scene;
  make_office(scene);
  const auto message = [](ups_status status) { return std::string(ups_status_name(status)) + ": " + ups_last_error(); };
  auto d = make_desc<ups_render_desc>(ups_render_desc_init);
  d.iteration_count = 4;
  d.target_criterion = 5;
  ups_result* none = nullptr;
  EXPECT_NE(message(ups_render(scene.get(), &d, &none)).find("target_criterion: 5"), std::string::npos);
  const Outcome o = render(scene, [](ups_render_desc& desc) {
    desc.iteration_count = 4;
    desc.struct_size = offsetof(ups_render_desc, target_criterion);  // a program of before
  });
  ups_prediction p{};
  p.struct_size = sizeof p;
  for (const double error : {0.0, -1.0, double(NAN), double(INFINITY)})
    EXPECT_NE(message(ups_result_get_prediction(o.result.get(), error, &p)).find("relative_error"), std::string::npos);
  EXPECT_EQ(o.predict(0.01).limited_by, UPS_LIMIT_UNKNOWN) << "4 iterations say nothing";
  EXPECT_EQ(o.predict(0.01).seconds, -1);
  EXPECT_TRUE(o.curve().empty());
  ups_curve_point point{};
  point.struct_size = sizeof point;
  EXPECT_NE(message(ups_result_get_curve_point(o.result.get(), 0, &point)).find("there are 0 points"),
            std::string::npos);
  ups_largest_error e{};
  e.struct_size = sizeof e;
  EXPECT_EQ(ups_result_get_largest_error(o.result.get(), &e), UPS_ERROR_INVALID_STATE);
}

}  // namespace
}  // namespace ups::test
