// Hazard 13: roulette that lets few paths live gives them weights that explode.
#include <gtest/gtest.h>

#include <random>

#include "../oracle/replay_room.h"
#include "../support/figures.h"
#include "transport/direct_light.h"
#include "transport/eye_pass.h"
#include "transport/integrator.h"
#include "transport/light_pass.h"
#include "transport/path_recorder.h"
#include "transport/sensor_index.h"
#include "transport/techniques.h"

namespace ups::test {
namespace {

// A path that lives carries no more than it started with, whatever it met, after a game no more than 1 / reserve of that;
// chains of lossless mirrors and glass, which are exempt, no more than ((n + 1) / 62.5)^1.5 times that after n edges.
// Bounces take away up to all but 1e-6, in colours.
TEST(Hazard13, SurvivorsCarryNoMoreThanTheyStartedWith) {
  std::mt19937 rng(3);
  std::uniform_real_distribution<float> uniform(0, 1);
  for (int path = 0; path < 20000; ++path) {
    const Rgb start{uniform(rng) + 0.01f, uniform(rng) + 0.01f, uniform(rng) + 0.01f};
    const float lowest = std::pow(10.0f, -6 * uniform(rng)), delta_share = uniform(rng);
    Rgb carried = start;
    float largest = 0;
    for (uint32_t edges = 1; edges <= 600; ++edges) {
      const auto share = [&] { return lowest + (1 - lowest) * uniform(rng); };
      const Rgb bounce = path % 8 == 0 ? Rgb(1.0f) : Rgb{share(), share(), share()};
      const bool lossless = max_component(bounce) > 0.9f && uniform(rng) < delta_share;
      carried *= bounce;
      const float reserve = path % 2 ? eye_reserve : light_reserve;
      const float q = survival(carried, start, reserve, edges, lossless);
      ASSERT_GT(q, 0);
      ASSERT_LE(q, 1);
      if (uniform(rng) >= q) break;
      carried *= 1 / q;
      largest = max_component(carried) / max_component(start);
      if (q < 1 && edges < 64) { ASSERT_LE(largest, (1 + 1e-4f) / reserve) << edges; }
      ASSERT_LE(largest, (1 + 1e-4f) * std::max(1.0f, std::pow(float(edges + 1) / 62.5f, 1.5f))) << edges;
    }
  }
}

// What eye paths bring, path by path, and each contribution.
class Contributions : public PathRecorder {
 public:
  std::vector<double> of_path;
  double largest = 0, largest_of_long = 0;
  uint32_t longest = 0;

  void start_light(uint32_t, const EmissionSample&, const Rgb&) override {}
  void start_eye(const EyeSensor&, const Vec3&, const Vec3&, float) override { of_path.push_back(0); }
  void meet(const Encounter&) override {}
  void scatter(const BsdfSample&, float, const Rgb&) override {}
  void store() override {}
  void found(const Contribution& c, const Brought& brought, uint32_t) override {
    const double lx = luminance(brought.unweighted) * brought.weight;
    of_path.back() += lx;
    largest = std::max(largest, lx);
    longest = std::max(longest, c.technique.edges);
    if (c.technique.edges > 8) largest_of_long = std::max(largest_of_long, lx);
  }
  void splatted(const Contribution&, const Brought&, size_t, uint32_t) override {}
  void landed(const Contribution&, const Brought&, const Vec3&, uint32_t, uint32_t) override {}
};

// A long white corridor, lit at one end: the dark end's light is all of many bounces. One sample of next-event
// estimation brings at most rho L A / d^2, with d the least distance of a surface from the lamp, and roulette must not
// add to that; nor may a light path carry more than the lamp's flux. Single paths are judged, of random numbers that are
// fixed: the largest, and the kurtosis, are a third of what is allowed.
TEST(Hazard13, NoPathOfALongCorridorBringsMoreThanOneSampleOfTheLamp) {
  constexpr float rho = 0.9f, luminance_cd_m2 = 4000;
  constexpr double area = 0.25, least_distance = 0.7;  // the lamp's edge to the walls beside it
  RoomBuilder b;
  b.add(box({0, 0, 0}, {12, 2, 2.5}).flipped(), RoomBuilder::material(UPS_MATERIAL_MATTE, rho));
  ups_material_desc lamp = RoomBuilder::material(UPS_MATERIAL_MATTE, 0);
  std::fill_n(lamp.luminance_cd_m2, 3, luminance_cd_m2);
  b.add(quad({1, 0.75, 2.3}, {0, 0.5, 0}, {0.5, 0, 0}), lamp);
  b.add_meters({11.5, 1, 0.8, 11, 0.5, 1, 11.9, 1.5, 0.2}, {0, 0, 1, 0, 0, 1, 1, 0, 0.1f});
  const Room room = b.build();

  TransportSettings settings;
  settings.method = *method_of(UPS_METHOD_UPS);
  settings.techniques = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT;
  settings.light_paths = 1u << 12;
  Plan plan = make_plan(*room.scene, settings);
  plan.meter_samples = 4096;
  Contributions found;
  ThreadPool pool(1);
  const StopSignal stop;
  double brightest_lm = 0;
  for (uint32_t number = 0; number < 16; ++number) {
    Iteration in(*room.scene, plan, settings, number, stop);
    in.recorder = &found;
    IterationTally tally;
    for (const MeterSet& set : room.scene->meter_sets) tally.meters.emplace_back(set.meters.size());
    tally.landings.resize(1), tally.separated.resize(1);
    const SensorIndex sensors(in);
    Photons photons;
    LightPass light;
    photons.paths = light.trace(in, sensors, pool, tally);
    photons.paths.each([&](uint32_t, const LightVertex& v) {
      brightest_lm = std::max(brightest_lm, double(luminance(v.flux)));
    });
    const DirectLight direct(*room.scene, plan, settings);
    trace_meter_paths(in, photons, direct, 0, 0, pool, tally);
  }
  const double most = rho * luminance_cd_m2 * area / (least_distance * least_distance);
  const double flux = double(pi) * luminance_cd_m2 * area;
  EXPECT_LE(found.largest, most);
  EXPECT_GT(found.longest, 40u) << "roulette had nothing to do";
  EXPECT_LE(brightest_lm, flux * (1 + 1e-5));
  double mean = 0, second = 0, fourth = 0, largest = 0;
  for (const double v : found.of_path) mean += v / double(found.of_path.size()), largest = std::max(largest, v);
  for (const double v : found.of_path) second += std::pow(v - mean, 2), fourth += std::pow(v - mean, 4);
  const double kurtosis = fourth / (second * second) * double(found.of_path.size());
  test::measured("%zu paths of up to %u edges, mean %.4g lx, largest of a path %.3g means, kurtosis %.3g; largest "
                 "contribution %.3g of %.3g lx, of more than 8 edges %.3g",
                 found.of_path.size(), found.longest, mean, largest / mean, kurtosis, found.largest, most,
                 found.largest_of_long);
  EXPECT_LT(largest, 50 * mean);
  EXPECT_LT(kurtosis, 50);
}

}  // namespace
}  // namespace ups::test
