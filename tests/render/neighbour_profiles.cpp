// Does a row of meters show together what none of them shows alone: an edge beside it, within the disc that each would
// take? Photons fall on discs of 0.5 m by a Poisson process, in 16 batches; fixed seeds.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "render/meter_sums.h"

namespace {

using namespace ups;

constexpr size_t meters = 24;
constexpr int renders = 30;
constexpr float radius = 0.5f;
constexpr double pi_d = 3.14159265358979323846;
using Light = std::function<double(size_t meter, double x)>;

struct Figures {
  double error = 0;  // rms over the truth
  double held = 0;   // share of the bounds
  double bound = 0;  // mean, over the truth
};

// Every meter by itself and with what its neighbours tell. The light is brightest at `most`; its truth is that at 0.
struct Row {
  Figures alone, together;

  Row(const Light& light, double most, double photons) {
    std::mt19937_64 random(7);
    for (int i = 0; i < renders; ++i) render(light, most, photons, random);
    for (Figures* f : {&alone, &together})
      f->error = std::sqrt(f->error / count), f->held /= count, f->bound /= count;
  }

 private:
  static constexpr double count = double(meters) * renders;

  void render(const Light& light, double most, double photons, std::mt19937_64& random) {
    const MeterDiscs discs(meters, max_rings, radius);
    const Rings rings = discs.rings(0, 0);
    MeterRings sums(meters, max_rings, false);
    std::uniform_real_distribution<double> uniform(0, 1);
    std::exponential_distribution<double> size(1);
    for (size_t m = 0; m < meters; ++m)
      for (int n = std::poisson_distribution<int>(photons * most)(random); n > 0; --n) {
        const double r = radius * std::sqrt(uniform(random)), phi = 2 * pi_d * uniform(random),
                     x = r * std::cos(phi), y = r * std::sin(phi);
        if (uniform(random) * most >= light(m, x)) continue;
        const uint32_t ring = discs.ring_at(0, float(x), float(y));
        const double lm = size(random) * pi_d * radius * radius / photons * batch_count;
        const uint8_t octant = MeterDiscs::octant_of(float(x), float(y));
        if (ring != none) sums.add(m, uint32_t(random() % batch_count), {0, 0, uint8_t(ring), false, octant, lm});
      }
    std::vector<RingProfile> profiles;
    for (size_t m = 0; m < meters; ++m) profiles.push_back(sums.profile(m, rings, batch_count));
    const NeighbourProfiles neighbours(profiles);
    for (size_t m = 0; m < meters; ++m) {
      MeterRings::Told told;
      add(sums, rings, m, told, nullptr, light(m, 0), alone);
      told.steps = [&](const RingProfile& own, uint32_t ring) { return neighbours.bias(m, own, ring); };
      add(sums, rings, m, told, &neighbours, light(m, 0), together);
    }
  }

  static void add(const MeterRings& sums, const Rings& rings, size_t m, const MeterRings::Told& told,
                  const NeighbourProfiles* neighbours, double truth, Figures& figures) {
    const MeterRings::Choice discs = sums.choose(m, rings, batch_count, told);
    MeterLight read{{}, sums.read(m, rings, discs, batch_count), batch_count, {}, {}, true, {}};
    read.sums.add(read.photons);
    read.bias = read.own_bias().bias;
    if (neighbours) read.bias = neighbours->added_to(read.bias, m, discs);
    read.largest.fill(read.photons.paths.largest);
    const ups_meter_reading r = read.reading();
    const double error = (double(r.illuminance_lx) - truth) / truth, bound = double(r.error_bound_lx) / truth;
    figures.error += error * error;
    figures.held += std::abs(error) <= bound;
    figures.bound += bound;
  }
};

TEST(NeighbourSteps, ShowAnEdgeAlongARow) {
  const Row row([](size_t, double x) { return x < 0.12 ? 10 : 13; }, 13, 400);
  std::printf("edge alone %g %g %g together %g %g %g\n", row.alone.error, row.alone.held, row.alone.bound,
              row.together.error, row.together.held, row.together.bound);
}
TEST(NeighbourSteps, ShowEdgesHereAndThere) {
  const Row row([](size_t m, double x) { return x < 0.02 * double(m % 8 + 2) ? 10 : m % 3 ? 14 : 8; }, 14, 400);
  std::printf("edges alone %g %g %g together %g %g %g\n", row.alone.error, row.alone.held, row.alone.bound,
              row.together.error, row.together.held, row.together.bound);
}
TEST(NeighbourSteps, Lean) {
  const Row row([](size_t, double x) { return x < 0.01 ? 10 : 12; }, 12, 400);
  std::printf("lean alone %g %g %g together %g %g %g\n", row.alone.error, row.alone.held, row.alone.bound,
              row.together.error, row.together.held, row.together.bound);
}
TEST(NeighbourSteps, LeaveEvenLightAsItIs) {
  const Row row([](size_t, double) { return 10; }, 10, 400);
  std::printf("even alone %g %g %g together %g %g %g\n", row.alone.error, row.alone.held, row.alone.bound,
              row.together.error, row.together.held, row.together.bound);
}
TEST(NeighbourSteps, Slope) {
  const Row row([](size_t, double x) { return 10 + 10 * x; }, 15, 400);
  std::printf("slope alone %g %g %g together %g %g %g\n", row.alone.error, row.alone.held, row.alone.bound,
              row.together.error, row.together.held, row.together.bound);
}

}  // namespace
