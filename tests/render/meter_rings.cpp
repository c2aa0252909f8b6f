// Does a point meter's reading take the disc that serves it, and does its bound hold? Photons of known fields fall on a
// disc of 0.5 m by a Poisson process, in 16 batches; fixed seeds.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

#include "render/meter_sums.h"

namespace {

using namespace ups;

constexpr float radius = 0.5f;

struct Part {
  std::function<double(double, double)> lx;
  double most;
  double half = radius;  // within so far of the meter, along both axes
};
struct Field {
  const char* name;
  std::vector<Part> parts;
  double density;      // photons a lumen
  double worst_error;  // over the root mean square error of the best single disc, which knows the truth
  double truth() const {
    double sum = 0;
    for (const Part& p : parts) sum += p.lx(0, 0);
    return sum;
  }
};
void PrintTo(const Field& f, std::ostream* out) { *out << f.name; }

double smooth(double x, double y) {
  return 17 * std::pow(1 + ((x - 0.8) * (x - 0.8) + (y + 0.5) * (y + 0.5)) / 23, -1.5);
}
double edge(double x, double) { return x < 0.12 ? 17 : 3; }
double caustic(double x, double y) { return 400 * std::exp(-(x * x + y * y) / 2e-4); }
Part even(double lx, double half = radius) {
  return {[lx](double, double) { return lx; }, lx, half};
}

struct Rig {
  MeterDiscs discs{1, max_rings, radius};
  Rings rings = discs.rings(0, 0);
  MeterRings sums{1, 1, max_rings, true}, caustics{1, 1, max_rings, false, true};
  std::mt19937_64 random;
  explicit Rig(uint64_t seed) : random(seed) {}

  void add(uint32_t batch, double x, double y, double lm, bool direct = false, bool caustic = false) {
    const uint32_t ring = discs.ring_at(0, float(x), float(y));
    if (ring != none)
      (caustic ? caustics : sums)
          .add(0, batch, {0, 0, uint8_t(ring), direct, MeterDiscs::octant_of(float(x), float(y)), 0, lm, caustic}, batch);
  }
  void fill(const Field& f, bool caustic = false, bool alike = false) {
    std::uniform_real_distribution<double> uniform(0, 1);
    std::exponential_distribution<double> size(1);
    for (const Part& p : f.parts) {
      const int n = std::poisson_distribution<int>(f.density * p.most * 4 * p.half * p.half)(random);
      for (int i = 0; i < n; ++i) {
        const double x = (2 * uniform(random) - 1) * p.half, y = (2 * uniform(random) - 1) * p.half;
        if (uniform(random) * p.most >= p.lx(x, y)) continue;
        const double lm = (alike ? 1 : size(random)) / f.density * batch_count;  // a visit each batch
        add(uint32_t(random() % batch_count), x, y, lm, false, caustic);
      }
    }
  }
  ups_meter_reading read(uint32_t visits = batch_count) const {
    MeterLight light{{}, sums.read(0, rings, sums.choose(0, rings, visits), visits), visits, {}, {}, true, {}};
    light.sums.add(light.photons);
    light.bias = light.own_bias().bias;
    const MeterRings::Photons c = caustics.read(0, rings, caustics.choose(0, rings, visits), visits);
    const Spread bias = spread(c.bias.data(), visits);
    light.sums.add(c);
    light.photons.add(c);
    if (c.lx > 0 && bias.standard_error >= 0)
      light.bias = {light.bias.mean + bias.mean, std::hypot(light.bias.standard_error, bias.standard_error)};
    light.largest.fill(light.photons.paths.largest);
    return light.reading();
  }
  double mean_to(uint32_t ring) const {
    const MeterRings::Photons p = sums.read(0, rings, {ring, ring}, batch_count);
    double sum = 0;
    for (const double v : p.value) sum += v / batch_count;
    return sum;
  }
};

TEST(MeterRings, ShareOutTheDisc) {
  const MeterDiscs discs(2, max_rings, radius);
  const Rings rings = discs.rings(1, 0.001f);
  double area = 0;
  for (uint32_t k = 0; k < max_rings; ++k) {
    area += rings.area[k];
    const double outer = radius * std::pow(2, -0.5 * (max_rings - 1 - k));
    EXPECT_NEAR(area / (pi_d * outer * outer), 1, 1e-12);
    EXPECT_EQ(discs.ring_at(1, float(0.999 * outer), 0), k);
    EXPECT_EQ(discs.ring_at(1, 0, float(-1.001 * outer)), k + 1 < max_rings ? k + 1 : none);
    if (k == rings.narrowest) {
      EXPECT_GE(outer, 0.001);
      EXPECT_LT(outer, 0.001 * std::sqrt(2.0));
    }
  }
  EXPECT_EQ(discs.ring_at(1, 0, 0), 0u);
  EXPECT_NEAR(discs.area(1), pi_d * radius * radius, 1e-7);
}

// A ring without area, as behind a wall, makes no disc wider.
TEST(MeterRings, TellWhetherTheirDiscIsTheWidest) {
  Rig rig(1);
  rig.add(0, 0.01, 0.01, 2);
  const auto widest = [&](uint32_t even, uint32_t odd) {
    return rig.sums.read(0, rig.rings, {even, odd}, batch_count).widest;
  };
  constexpr uint32_t last = max_rings - 1;
  EXPECT_TRUE(widest(last, last));
  EXPECT_FALSE(widest(last, last - 1));
  EXPECT_FALSE(widest(last - 1, last));
  rig.rings.area[last] = 0;
  EXPECT_TRUE(widest(last, last - 1));
  EXPECT_FALSE(widest(last - 2, last - 1));
}

// Four visits are the least that say anything of noise: before, a reading is of the whole disc.
TEST(MeterRings, TakeTheWholeDiscFirst) {
  Rig rig(1);
  rig.add(0, 0.1, 0.1, 2, true);
  rig.add(1, 0.3, -0.2, 4);
  const ups_meter_reading r = rig.read(2);
  EXPECT_NEAR(r.illuminance_lx, 3 / (pi_d * radius * radius), 1e-5);
  EXPECT_NEAR(r.direct_lx, 1 / (pi_d * radius * radius), 1e-5);
  EXPECT_EQ(r.standard_error_lx, -1);
}

// What one half chose its disc by does not bias what the other reads: 4000 readings of uniform light, whose mean must
// be right within 4 standard errors (P < 1e-4) of at most 0.15 %, asserted: 0.9 % is found in 97.7 of 100 cases, 0.5 %
// at the 0.08 % that they are. And the errors stated are those made: a chi-square ratio of 4000 over many more degrees
// of freedom has a standard deviation of 2.3 %, so that a variance is found that is wrong by more than a third. Of
// caustics the same.
class MeterRingsOfAClass : public ::testing::TestWithParam<bool> {};
INSTANTIATE_TEST_SUITE_P(Classes, MeterRingsOfAClass, ::testing::Bool());

TEST_P(MeterRingsOfAClass, ChoiceDoesNotBiasTheReading) {
  const bool caustic = GetParam();
  const Field uniform{"", {even(10)}, 100, 0};
  Rig rig(3);
  double sum = 0, square = 0, stated = 0;
  constexpr int runs = 4000;
  for (int i = 0; i < runs; ++i) {
    rig.sums = MeterRings(1, 1, max_rings, true), rig.caustics = MeterRings(1, 1, max_rings, false, true);
    rig.fill(uniform, caustic);
    const ups_meter_reading r = rig.read();
    sum += r.illuminance_lx, square += std::pow(r.illuminance_lx - 10, 2);
    stated += std::pow(r.standard_error_lx, 2);
  }
  const double error = std::sqrt(square) / runs;
  EXPECT_LE(error, 0.0015 * 10) << "too noisy to judge";
  EXPECT_NEAR(sum / runs, 10, 4 * error);
  EXPECT_NEAR(stated / square, 1, 0.3);
}

// A caustic of 10 lx in even light of 17 lx, far narrower than the disc that serves the latter, whose noise hides it: it
// has a disc of its own, and of few photons the bound holds it. The same photons as those of other light do not show.
TEST(MeterRings, ANarrowCausticShowsThoughOtherLightWouldHideIt) {
  constexpr double spot = radius / 32, lx = 10, lm = lx * pi_d * spot * spot * batch_count;
  const Field field{"", {even(17)}, 40, 0};
  for (const int photons : {2, 8, 20, 200})
    for (const bool caustic : {false, true}) {
      if (!caustic && photons > 20) continue;
      Rig rig(5);
      rig.fill(field);
      for (int i = 0; i < photons; ++i) {
        const double r = spot * std::sqrt((i + 0.5) / photons), a = 2.4 * i;
        rig.add(uint32_t(i) % batch_count, r * std::cos(a), r * std::sin(a), lm / photons, false, caustic);
      }
      const ups_meter_reading reading = rig.read();
      EXPECT_EQ(std::abs(reading.illuminance_lx - 17 - lx) <= reading.error_bound_lx, caustic) << photons;
      if (photons == 200) {
        EXPECT_NEAR(reading.illuminance_lx, 17 + lx, 3);
        EXPECT_LT(reading.error_bound_lx, 5);
      }
    }
}

// Seven close together are found though three others lie elsewhere.
TEST(MeterRings, StrayPhotonsHideNoNarrowCaustic) {
  constexpr double spot = radius / 32, lx = 10, lm = lx * pi_d * spot * spot * batch_count / 7;
  Rig rig(5);
  rig.fill({"", {even(17)}, 40, 0});
  for (int i = 0; i < 7; ++i) {
    const double r = spot * std::sqrt((i + 0.5) / 7), a = 2.4 * i;
    rig.add(uint32_t(i), r * std::cos(a), r * std::sin(a), lm, false, true);
  }
  for (int i = 0; i < 3; ++i) rig.add(uint32_t(8 + i), 0, (0.6 + 0.15 * i) * radius, lm, false, true);
  const ups_meter_reading r = rig.read();
  EXPECT_LE(std::abs(r.illuminance_lx - 17 - lx), r.error_bound_lx);
}

// Light of caustics that is even leaves holes about the meter by chance, and clusters: they widen no bound. 20,000 readings of
// 470 photons, four standard deviations, and some eight discs, most of whose photons are the same: one is to be expected,
// more than four in 4 of 1000 cases; seeds are fixed (15 where the roots of numbers told photons apart).
TEST(MeterRings, HolesThatChanceLeavesWidenNoBound) {
  const Field uniform{"", {even(10)}, 60, 0};
  int wide = 0;
  for (uint64_t seed = 0; seed < 20000; ++seed) {
    Rig rig(seed);
    rig.fill(uniform, true, true);
    const MeterRings::Choice choice = rig.caustics.choose(0, rig.rings, batch_count);
    wide += rig.caustics.read(0, rig.rings, choice, batch_count).caustic.size() > 0;
  }
  EXPECT_LE(wide, 4);
}

// Few of them far apart say nothing of light that is narrow.
TEST(MeterRings, FewCausticPhotonsFarApartWidenNoBound) {
  const Field field{"", {even(17)}, 40, 0};
  const auto bound = [&](bool caustic) {
    Rig rig(5);
    rig.fill(field);
    rig.add(1, 0.4 * radius, 0, 0.01, false, caustic);
    rig.add(2, 0, 0.8 * radius, 0.01, false, caustic);
    return rig.read().error_bound_lx;
  };
  EXPECT_NEAR(bound(true), bound(false), 0.01 * bound(false));
}

class MeterRingsOf : public ::testing::TestWithParam<Field> {};
INSTANTIATE_TEST_SUITE_P(Fields, MeterRingsOf,
                         ::testing::Values(Field{"smooth", {{smooth, 17}}, 1000, 1.8},
                                           Field{"edge", {{edge, 17}}, 1000, 2},
                                           Field{"patch", {even(20, 0.02)}, 30000, 1.8},
                                           Field{"caustic", {even(1), {caustic, 400, 0.06}}, 3000, 1.8}),
                         [](const auto& i) { return i.param.name; });

// 100 renders. A bound of 95 % holds in 87 % or more but for 1 in 1000 such tests.
TEST_P(MeterRingsOf, ReadWellAndBoundTheirError) {
  const Field& field = GetParam();
  const double truth = field.truth();
  constexpr int runs = 100;
  double square = 0, single[max_rings] = {};
  int inside = 0;
  std::vector<double> widths;
  Rig rig(11);
  for (int i = 0; i < runs; ++i) {
    rig.sums = MeterRings(1, 1, max_rings, false);
    rig.fill(field);
    const ups_meter_reading r = rig.read();
    const double error = std::abs(r.illuminance_lx - truth);
    square += error * error;
    inside += error <= r.error_bound_lx;
    widths.push_back(r.error_bound_lx / error);
    for (uint32_t k = 0; k < max_rings; ++k) single[k] += std::pow(rig.mean_to(k) - truth, 2);
  }
  const double best = *std::min_element(std::begin(single), std::end(single));
  std::nth_element(widths.begin(), widths.begin() + runs / 2, widths.end());
  RecordProperty("error", std::to_string(std::sqrt(square / best)));
  RecordProperty("width", std::to_string(widths[runs / 2]));
  EXPECT_LT(std::sqrt(square / best), field.worst_error);
  EXPECT_GE(inside, 87);
  EXPECT_GT(widths[runs / 2], 2);
  EXPECT_LT(widths[runs / 2], 5);
}

}  // namespace
