// Are an iteration's sizes and radii what the plan says?
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

#include "transport/iteration.h"
#include "transport/pilot.h"

namespace {

using namespace ups;

TEST(Plan, RadiusFollowsTheRecurrence) {
  for (const double alpha : {0.1, 0.5, 2.0 / 3, 0.8, 0.99}) {
    double r2 = 1;  // r^2_{i+1} = r^2_i (i + alpha) / (i + 1), i from 1
    for (uint32_t i = 1; i < 5000; ++i) {
      ASSERT_NEAR(Plan::radius2_factor(i - 1, alpha) / r2, 1.0, 1e-10) << i << ", alpha " << alpha;
      r2 *= (i + alpha) / (i + 1);
    }
    const double limit = std::pow(1e6, alpha - 1) / std::tgamma(1 + alpha);
    EXPECT_NEAR(Plan::radius2_factor(1000000, alpha) / limit, 1.0, 1e-4) << alpha;
  }
}

TEST(Plan, SaysWhichRadiiStandAtTheLeastAndSinceWhen) {
  Plan plan;
  plan.min_radius = 0.01f;
  const double alpha = 2.0 / 3;
  const std::vector<float> radii = {0.1f, 0, 0.012f, 0.02f};  // 0: no merging
  EXPECT_EQ(plan.at_floor(radii, 0, alpha).count, 0u);
  for (const uint32_t visits : {1u, 10u, 1000u, 1000000u}) {
    size_t count = 0;
    uint32_t since = visits + 1;
    for (float r : radii)
      for (uint32_t n = 0; r > 0 && n <= visits; ++n)
        if (plan.radius2(r, Plan::radius2_factor(n, alpha)) > double(r) * r * Plan::radius2_factor(n, alpha)) {
          ++count;
          since = std::min(since, n);
          break;
        }
    const Plan::AtFloor at = plan.at_floor(radii, visits, alpha);
    EXPECT_EQ(at.count, count) << visits;
    if (count > 0) {
      EXPECT_EQ(at.since, since) << visits;
    }
  }
}

// What no path has found of caustics is left open but where images of lamps in flat mirrors are all there is of them.
TEST(Plan, SeeksCausticsThatImagesDoNotBring) {
  Snapshot scene;
  scene.effects.sharp_caster = scene.effects.images_suffice = true;
  TransportSettings s{.method = *method_of(UPS_METHOD_UPS)};
  s.techniques = UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_MIRROR_SAMPLE;
  EXPECT_FALSE(make_plan(scene, s).seeks_caustics);
  s.techniques = UPS_TECHNIQUE_LIGHT_SAMPLE;  // nobody draws them
  EXPECT_TRUE(make_plan(scene, s).seeks_caustics);
  s.techniques |= UPS_TECHNIQUE_MIRROR_SAMPLE;
  scene.effects.images_suffice = false;
  EXPECT_TRUE(make_plan(scene, s).seeks_caustics);
  s.max_path_length = 1;  // straight from emitters alone
  EXPECT_FALSE(make_plan(scene, s).seeks_caustics);
  s.max_path_length = 0;
  scene.effects.sharp_caster = false;
  EXPECT_FALSE(make_plan(scene, s).seeks_caustics);
}

TEST(Plan, EveryPixelIsVisitedOncePerPass) {
  for (uint32_t subsets : {1u, 2u, 3u, 4u, 5u, 10u, 17u}) {
    Plan plan;
    plan.camera_subsets = subsets;
    const uint32_t width = 37, height = 23;
    std::vector<int> visits(width * height);
    for (uint32_t i = 5 * subsets; i < 6 * subsets; ++i) {
      uint32_t expected = 0;
      plan.for_visited_pixels(i, width, height, [&](uint32_t number, uint32_t pixel) {
        ASSERT_EQ(number, expected++);
        ASSERT_LT(pixel, width * height);
        ASSERT_EQ(plan.pixel_subset(pixel % width, pixel / width), i % subsets);
        ++visits[pixel];
      });
    }
    for (uint32_t p = 0; p < width * height; ++p)
      ASSERT_EQ(visits[p], 1) << "pixel " << p << " of " << subsets << " subsets";
  }
}

// A pixel meets all batches of the light paths, each of which may have rays of its own of a file, in turn.
TEST(Plan, PixelsMeetAllBatchesOfLight) {
  for (const uint32_t side : {4u, 182u, 257u, 363u, 512u, 1024u, 1920u}) {
    Snapshot scene;
    scene.cameras.emplace_back(Affine(), side, side, 1.0f, false);
    Plan plan;
    set_path_counts(scene, {}, UINT32_MAX, plan);
    EXPECT_LE(side * side / plan.camera_subsets, 1u << 15) << side;
    const TransportSettings settings{};
    const StopSignal stop;
    for (uint32_t subset = 0; subset < plan.camera_subsets; ++subset) {
      std::set<uint32_t> batches;
      for (uint32_t pass = 0; pass < batch_count; ++pass) {
        const Iteration in(scene, plan, settings, subset + pass * plan.camera_subsets, stop);
        EXPECT_EQ(in.camera_visit.batch, pass);
        batches.insert(in.light_visit.batch);
      }
      EXPECT_EQ(batches.size(), batch_count) << side << ", subset " << subset;
    }
  }
}

// A pixel's eye path is of one iteration of a pass, what falls on it of all: their weights add up to 1 by one radius
// alone.
TEST(Plan, MergesOfOnePassHaveOneRadius) {
  Snapshot scene;
  scene.cameras.emplace_back(Affine(), 512, 512, 1.0f, false);
  Plan plan;
  set_path_counts(scene, {}, UINT32_MAX, plan);
  plan.walk_radius = 0.1f;
  ASSERT_GT(plan.camera_subsets, 2u);
  const TransportSettings settings{};
  const StopSignal stop;
  const auto radius2 = [&](uint32_t number) { return Iteration(scene, plan, settings, number, stop).walk_radius2; };
  for (uint32_t pass = 0; pass < 3; ++pass) {
    const uint32_t first = pass * plan.camera_subsets, last = first + plan.camera_subsets - 1;
    EXPECT_EQ(radius2(first), radius2(last));
    EXPECT_LT(radius2(last + 1), radius2(last));
  }
}

// Tiles are judged with their neighbours: each of these squares has a pixel that a pilot visits, up to 1920 x 1080.
TEST(Plan, APilotSeesAllOfAnImage) {
  const std::pair<uint32_t, uint32_t> sizes[] = {{640, 480}, {1280, 720}, {1000, 1000}, {1920, 1080}, {4000, 300}};
  for (const auto& [width, height] : sizes) {
    Snapshot scene;
    scene.cameras.emplace_back(Affine(), width, height, 1.0f, false);
    Plan plan;
    set_path_counts(scene, {}, pilot_paths, plan);
    plan.pilot_shift = spread_shift(plan.camera_subsets);
    const auto tiles = [](uint32_t pixels) { return int((pixels + Units::side - 1) / Units::side); };
    const int columns = tiles(width), rows = tiles(height);
    std::vector<bool> visited(size_t(columns) * size_t(rows));
    plan.for_visited_pixels(0, width, height, [&](uint32_t, uint32_t pixel) {
      visited[pixel / width / Units::side * size_t(columns) + pixel % width / Units::side] = true;
    });
    int without = 0;
    for (int y = 0; y < rows; ++y)
      for (int x = 0; x < columns; ++x) {
        bool any = false;
        for (int j = std::max(0, y - 1); j <= std::min(rows - 1, y + 1); ++j)
          for (int i = std::max(0, x - 1); i <= std::min(columns - 1, x + 1); ++i)
            any |= visited[size_t(j * columns + i)];
        without += !any;
      }
    EXPECT_EQ(without, 0) << width << " x " << height;
  }
}

TEST(Plan, EveryMeterIsVisitedOncePerPass) {
  for (uint32_t subsets : {1u, 3u, 5u, 31u}) {
    Plan plan;
    plan.meter_subsets = subsets;
    for (const size_t meters : {1u, 4u, 31u, 100u}) {
      std::vector<int> visits(meters);
      for (uint32_t i = 2 * subsets; i < 3 * subsets; ++i)
        for (size_t k = 0; k < plan.visited_meters(i, meters); ++k) {
          ASSERT_LT(plan.visited_meter(i, k), meters);
          ++visits[plan.visited_meter(i, k)];
        }
      for (const int n : visits) ASSERT_EQ(n, 1) << meters << " meters of " << subsets << " subsets";
    }
  }
}

TEST(Plan, CountsFollowTheTechniques) {
  Snapshot scene;
  scene.cameras.emplace_back(Affine{}, 4, 4, 1.0f, false);
  scene.meter_sets.resize(2);
  scene.meter_sets[1].cell_width = scene.meter_sets[1].cell_height = 1;
  TransportSettings s{.method = *method_of(UPS_METHOD_UPS)};
  s.techniques =
      UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_SENSOR_HIT;
  Plan plan;
  plan.units = Units(scene);
  plan.light_paths = 1024;
  plan.camera_subsets = 4;
  plan.meter_samples = 16;
  plan.lands = true;
  plan.walk_radius = std::sqrt(0.5f);
  plan.pixel_radius = {std::vector<float>(16, 0.5f)};
  const StopSignal stop;
  const mis::Counts c = Iteration(scene, plan, s, 0, stop).camera_counts(0, 0);
  EXPECT_EQ(c.hit, 1);
  EXPECT_EQ(c.light_sample, 0);
  EXPECT_EQ(c.connect, 0);
  EXPECT_EQ(c.sensor_connect, 4096);  // light paths for each visit of a pixel
  EXPECT_EQ(c.land, 0);
  EXPECT_NEAR(c.eta_first, 1024 * 3.14159265358979 * 0.25, 1e-3);
  EXPECT_NEAR(c.eta, 1024 * 3.14159265358979 * 0.5, 1e-3);
  EXPECT_EQ(Iteration(scene, plan, s, 0, stop).meter_counts(1).land, 64);
  EXPECT_EQ(Iteration(scene, plan, s, 0, stop).meter_counts(0).land, 0);
  // A part of the sensors may take fewer.
  plan.shares.assign(plan.units.count, {true, false, TechniqueShare::merge_caustics});
  EXPECT_EQ(Iteration(scene, plan, s, 0, stop).camera_counts(0, 0).sensor_connect, 0);
  EXPECT_EQ(Iteration(scene, plan, s, 0, stop).camera_counts(0, 0).merge_all, 0);
  EXPECT_EQ(Iteration(scene, plan, s, 0, stop).camera_counts(0, 0).eta, c.eta);
  EXPECT_EQ(Iteration(scene, plan, s, 0, stop).meter_counts(1).land, 0);
}

}  // namespace
