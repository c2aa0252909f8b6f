// Do second moments of a set of techniques follow from those of another? And what is chosen by them.
#include "transport/selection.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <random>

#include "transport/pilot.h"

namespace {

using namespace ups;

// The integral of f over [0, 1) by balance-heuristic samples of two densities, eye (uniform) and light (2 x), with a
// count of each: E[sum v^2], which is the integral of f^2 / (1 + 2 count x), by the midpoint rule.
double second_moment(double light_count, double f_power) {
  constexpr int steps = 20000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) {
    const double x = (i + 0.5) / steps;
    sum += std::pow(x, 2 * f_power) / (1 + light_count * 2 * x) / steps;
  }
  return sum;
}

// Predicted from samples of two light samples an eye sample; judged against the moments of other counts, of a camera of
// twice as many light samples. Jittered samples of one dimension leave no noise that counts (1e-5): 0.2 % is found.
TEST(Moments, OfOtherCountsArePredicted) {
  constexpr double traced = 2;
  const std::vector<double> counts = {1e-9, 0.5, 1, 2};
  std::vector<mis::Classes> sets;
  for (const double n : counts) sets.push_back({.eye = 1, .light = n / traced});
  struct Case {
    double power;
    bool camera;
  };
  for (const Case& c : {Case{0.5, false}, {1, false}, {3, false}, {1, true}}) {
    const double power = c.power, times = c.camera ? 2 : 1;
    const Moments moments(sets, 2);
    std::vector<double> row(moments.row());
    std::mt19937_64 engine(7);
    const auto uniform = [&] { return std::generate_canonical<double, 53>(engine); };
    constexpr int samples = 50000;
    double own = 0;
    const auto take = [&](double x, bool light) {
      const double p_light = traced * 2 * x, all = 1 + p_light, v = std::pow(x, power) / all;
      own += v * v;
      const double base = light ? p_light : 1;
      moments.add(v, {.eye = 1 / base, .light = p_light / base}, c.camera, row.data());
    };
    for (int i = 0; i < samples; ++i) {
      take((i + uniform()) / samples, false);
      for (int k = 0; k < int(traced); ++k) take(std::sqrt((i + uniform()) / samples), true);
    }
    for (size_t j = 0; j < counts.size(); ++j) {
      const double predicted = (own + row[j]) / samples, right = second_moment(counts[j] * times, power);
      EXPECT_NEAR(predicted / right, 1, 0.002) << "count " << counts[j] << ", power " << power;
    }
  }
}

TEST(Moments, AreInfiniteWhereASetHasNoTechnique) {
  const Moments moments({{.eye = 1}, {.eye = 1, .caustic = 1}});
  std::vector<double> row(moments.row());
  moments.add(1, {.caustic = 1, .merge = 3}, false, row.data());
  EXPECT_TRUE(std::isinf(row[0]));
  EXPECT_DOUBLE_EQ(row[1], 3);  // a quarter of the density is left
}

TEST(Moments, TakeAPathForRoundingWhereEverySetIsProvedToHaveATechnique) {
  const Moments moments(std::vector<mis::Classes>{{.eye = 1}}, 1, true);
  std::vector<double> row(moments.row());
  moments.add(1, {.merge = 1}, false, row.data());
  EXPECT_EQ(row[0], 0);
  moments.add(1, {.eye = 1, .merge = 1}, false, row.data());
  EXPECT_DOUBLE_EQ(row[0], 1);
}

// What is chosen by what two pilots tell: that of all techniques, and that of eye paths with photons of caustics. 256
// point meters a set, of which 52 are visited; each reads 10 lx give or take the noise.
class Chosen : public ::testing::Test {
 protected:
  static constexpr double eye_rays = 10000, light_rays = 1e6, all_eye_paths = 16384, photons = 4;
  struct Told {  // of a meter, an iteration
    double noise = 1, independent = 1, excess = 0, reading = 10;
    double caustic_of_first = 0, photons_of_first = 100;  // lx of the first meter, by so many
    double landed = 0;  // squares of what light paths brought
  };

  void add_sets(size_t count) {
    scene.meter_sets.resize(count);
    for (size_t s = 0; s < count; ++s) scene.meter_sets[s].meters.resize(256);
    all.resize(count), eye.resize(count);
    settings.method = *method_of(UPS_METHOD_UPS);
    plan.units = Units(scene);
    set_path_counts(scene, settings, UINT32_MAX, plan);
  }
  Selection choose() {
    return select_techniques(scene, plan, settings, {}, stop, [this](const Iteration& in, IterationTally& tally) {
      trace(in, tally);
      return true;
    });
  }
  double gain() {
    const Selection chosen = choose();
    EXPECT_FALSE(chosen.shares.empty());
    return chosen.shares.empty() ? 0.0 : chosen.sensors[0].predicted_gain;
  }
  void trace(const Iteration& in, IterationTally& tally) {
    const bool by_eye = !in.plan.shares.empty();
    const uint32_t round = in.number / (in.plan.camera_subsets * in.plan.meter_subsets);
    const size_t sets = in.moments->count(), row = in.moments->row();
    tally = {};
    for (size_t s = 0; s < scene.meter_sets.size(); ++s) {
      const Told& told = (by_eye ? eye : all)[s];
      const size_t visited = in.plan.visited_meters(in.number, 256);
      const double paths = double(pilot_rounds) * in.plan.meter_samples;
      tally.meters.emplace_back(visited);
      tally.excess_of_meters.emplace_back(visited * row);
      for (size_t i = 0; i < visited; ++i) {
        tally.meters[s][i].value = told.reading + (double(round) - 1) * told.noise;
        double* sums = &tally.excess_of_meters[s][i * row];
        for (size_t j = 0; j < sets && !by_eye; ++j)
          sums[j] = j == 0 ? 0.0 : j + 2 >= sets ? told.excess : others.count(j) ? others[j] : INFINITY;
        sums[sets + 1] = told.independent * (paths - 1) / paths;
        sums[sets + 2] = told.landed;
        sums[sets + 3] = told.reading;
        if (i > 0) continue;
        sums[sets + 4] = told.caustic_of_first;
        sums[sets + 2] += told.caustic_of_first * told.caustic_of_first / told.photons_of_first;
      }
      tally.work.eye_paths += visited * in.plan.meter_samples;
    }
    tally.light_work.light_paths = 4096, tally.light_work.brightest_lm = brightest_lm;
    if (!by_eye) tally.light_work.rays = uint64_t(light_rays);
    tally.work.rays = uint64_t(eye_rays) + tally.light_work.rays;
    if (by_eye) return;
    probe.assign(row, 0.0);
    in.moments->add(1, {.caustic = 1, .merge = 3}, false, probe.data());
  }
  // By the counts above, of one set.
  double of_eye() const { return all_eye_paths * eye_rays / (52 * 64); }
  double of_light() const { return photons * (2 * 4096 + light_rays); }

  Snapshot scene;
  TransportSettings settings{.techniques = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE |
                                           UPS_TECHNIQUE_CONNECT | UPS_TECHNIQUE_MERGE};
  Plan plan;
  std::vector<Told> all, eye;
  std::map<size_t, double> others;  // excess of other sets of techniques than all, and than eye paths with caustics
  std::vector<double> probe;        // excess of a path that caustic photons and others find
  float brightest_lm = 0;
  const StopSignal stop;
};

// A quarter of the plan's light paths are as many as the pilot's.
TEST_F(Chosen, PhotonsAreCountedAgainstThosePilotsTrace) {
  add_sets(1);
  choose();
  const size_t sets = probe.size() - 5;
  EXPECT_DOUBLE_EQ(probe[sets - 1], 3);           // a quarter: all of the pilot's, a quarter of the path's density
  EXPECT_DOUBLE_EQ(probe[sets - 2], 4 * 16 - 1);  // a 64th
}

TEST_F(Chosen, EyePathsPayNoLightPathsThatNothingTakes) {
  settings.techniques &= ~uint32_t(UPS_TECHNIQUE_MERGE);
  add_sets(1);
  EXPECT_NEAR(gain(), 1 + of_light() / of_eye(), 1e-9 * gain());
}

// Whole light paths take 0.74 of what eye paths do, a quarter of them 0.66: both pay, and the quarter more.
TEST_F(Chosen, TheBestIsTakenOfTheWholeSets) {
  settings.prefers_eye_paths = true;
  add_sets(1);
  const double besides = 1.1 * of_eye(), whole = besides + of_light(), quarter = besides + 0.25 * of_light(),
               plain = 1.02 * of_eye() + photons * 2 * 4096 / 8;  // an eighth of the light paths: a tenth of the rest
  others[4] = 0.886 * whole / quarter - 1;  // all techniques at a quarter
  eye[0].noise = std::sqrt(whole / (0.74 * plain));
  EXPECT_EQ(choose().light_paths, plan.light_paths / 4);
}

// Eye paths alone take half of what all techniques do, unless all of these' noise is of what lands, a quarter of which is
// left by four times the light paths of the pilot.
TEST_F(Chosen, NoiseOfWhatLandsFallsWithTheLightPaths) {
  settings.prefers_eye_paths = true;
  add_sets(1);
  const double whole = 1.1 * of_eye() + of_light(), plain = 1.02 * of_eye() + photons * 2 * 4096 / 8;
  eye[0].noise = std::sqrt(0.5 * whole / plain);
  EXPECT_LT(choose().light_paths, plan.light_paths);
  all[0].independent = 0, all[0].landed = 1;
  EXPECT_EQ(choose().light_paths, plan.light_paths);
}

// Eye paths alone take half of what all techniques do, but may miss what casters bring to cells.
TEST_F(Chosen, LightLandsOnCellsThatEyePathsMayLeaveDark) {
  settings.prefers_eye_paths = true;
  settings.techniques |= UPS_TECHNIQUE_SENSOR_HIT;
  add_sets(1);
  const double whole = 1.1 * of_eye() + of_light(), plain = 1.02 * of_eye() + photons * 2 * 4096 / 8;
  eye[0].noise = std::sqrt(0.5 * whole / plain);
  for (const bool cells : {false, true})
    for (const bool complete : {false, true}) {
      scene.meter_sets[0].disc_radius = cells ? 0.1f : 0, scene.effects.path_tracing_complete = complete;
      EXPECT_EQ(choose().shares.at(0).light, cells && !complete) << cells << complete;
    }
}

// 2 % of all meters' light together, but all of one meter's: a hundred photons are no chance.
TEST_F(Chosen, ACausticOfOneMeterIsSeen) {
  add_sets(1);
  eye[0].caustic_of_first = 10;
  EXPECT_TRUE(choose().shares.empty());
  eye[0].photons_of_first = 1;
  EXPECT_FALSE(choose().shares.empty());
}

TEST_F(Chosen, ADarkSetDecidesNothing) {
  add_sets(2);
  all[1].noise = all[1].independent = 0;
  EXPECT_FALSE(choose().shares.empty());
  all[1].noise = 1e-5;  // nobody sees it, of 10 lx elsewhere
  EXPECT_FALSE(choose().shares.empty());
  all[1].noise = 0.01;
  EXPECT_TRUE(choose().shares.empty());
}

// However large an image is, no tile is judged by few pixels.
TEST(Pilot, TilesArePooledUntilPixelsAreMany) {
  for (const auto& [width, height] : {std::pair(124u, 64u), {1920u, 1080u}, {4000u, 3000u}}) {
    Snapshot scene;
    scene.cameras.emplace_back(Affine(), width, height, 1.0f, false);
    const TransportSettings settings{.method = *method_of(UPS_METHOD_UPS)};
    Plan plan;
    plan.units = Units(scene);
    set_path_counts(scene, settings, UINT32_MAX, plan);
    const auto trace = [](const Iteration& in, IterationTally& tally) {
      const Camera& camera = in.scene.cameras[0];
      size_t visited = 0;
      in.plan.for_visited_pixels(in.number, camera.width(), camera.height(), [&](uint32_t, uint32_t) { ++visited; });
      tally = {};
      tally.pixels = {std::vector<Rgb>(visited, Rgb(1, 1, 1))};
      tally.excess_of_pixels = {std::vector<double>(visited * in.moments->row())};
      tally.excess_of_splats = {std::vector<double>(in.plan.units.tiles(0) * in.moments->row())};
      tally.splats.resize(1);
      return true;
    };
    Measured m;
    const Moments moments(std::vector<mis::Classes>{{.eye = 1}});
    ASSERT_TRUE(run_pilot(scene, pilot_plan(scene, plan, settings), settings, {}, trace, moments, m));
    double fewest = INFINITY;
    for (const double visited : m.visited) fewest = std::min(fewest, visited);
    EXPECT_GE(fewest, 4) << width << ", of a corner's square and its three neighbours";
    EXPECT_GE(m.visited[m.visited.size() / 2], 12) << width;
    EXPECT_NEAR(m.reading[0] / m.visited[0], 1, 1e-6);
  }
}

}  // namespace
