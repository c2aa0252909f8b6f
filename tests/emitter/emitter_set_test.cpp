// Is the choice among emitters a probability, the same from both sides, and sensible? Chi-square tests have fixed seeds
// and a false-alarm rate of 1e-4 each; probabilities that are off by 3.2 %, root mean square, are found in 97.7 of 100
// cases, of a choice together with what is left of its number by 4.4 %. Without chance: light_tree_test.cpp.
#include "emitter/emitter_set.h"

#include <gtest/gtest.h>

#include "emitter/rays.h"
#include "emitter/test_emitters.h"
#include "support/chi_square.h"

namespace ups::test {
namespace {

// Lengths scaled, as are areas and the sun's disc; radiance and illuminance stay, points' intensities grow with them.
EmitterSet mixed_set(float scale = 1) {
  const float s2 = scale * scale;
  std::vector<std::shared_ptr<const Emitter>> e;
  e.push_back(std::make_unique<PointEmitter>(Vec3(0, 0, 3) * scale, Rgb(0), 0.0f));  // dark, first
  e.push_back(std::make_unique<PointEmitter>(Vec3(2, 0, 3) * scale, Rgb(10) * s2, 0.0f));
  e.push_back(std::make_unique<PointEmitter>(Vec3(-20, 5, 3) * scale, Rgb(100) * s2, 0.0f));
  e.push_back(std::make_unique<AreaEmitter>(
      rectangle(Vec3(1, 1, 1) * scale, Vec3(3, 0, 0) * scale, Vec3(0, 2, 0) * scale), Rgb(5), false, 0));
  e.push_back(std::make_unique<DirectionalEmitter>(Vec3(0, 0, -1), Rgb(0.05f), 30 * scale));
  e.push_back(std::make_unique<PointEmitter>(Vec3(0, 0, 2) * scale, Rgb(0), 0.0f));  // dark, last
  return EmitterSet(std::move(e));
}

EmitterSet many_points(int n) {
  Random random(30);
  std::vector<std::shared_ptr<const Emitter>> e;
  for (int i = 0; i < n; ++i) {
    const Vec3 p = random.in_box(10);
    e.push_back(std::make_unique<PointEmitter>(p, Rgb(random()), 0.0f));
  }
  return EmitterSet(std::move(e));
}

template <class Choose, class Probability>
void expect_choice(size_t n, const Choose& choose, const Probability& probability, uint32_t seed) {
  constexpr int samples = 300000;
  const size_t cells = n > 100 ? 4 : 16;
  Random random(seed);
  std::vector<double> observed(n, 0.0), expected, joint(n * cells, 0.0), joint_expected;
  double sum = 0;
  for (size_t i = 0; i < n; ++i) {
    sum += probability(i);
    expected.push_back(samples * double(probability(i)));
    joint_expected.insert(joint_expected.end(), cells, expected.back() / double(cells));
  }
  EXPECT_NEAR(sum, 1, 1e-6);
  for (int i = 0; i < samples; ++i) {
    const EmitterSet::Choice c = choose(random());
    ASSERT_EQ(c.probability, probability(c.index));  // the same bits
    ASSERT_GT(c.probability, 0);
    ASSERT_GE(c.u, 0);
    ASSERT_LT(c.u, 1);
    observed[c.index] += 1;
    joint[c.index * cells + size_t(c.u * double(cells))] += 1;  // u is uniform again for every emitter
  }
  const auto judge = [](const std::vector<double>& found, const std::vector<double>& right, double worst) {
    const ChiSquareResult r = chi_square_test(found, right);
    EXPECT_GT(r.p_value, false_alarm) << r.statistic << " / " << r.degrees_of_freedom;
    if (r.degrees_of_freedom > 0) {
      EXPECT_LE(smallest_found(samples, r.degrees_of_freedom, false_alarm), worst) << "too few samples to judge";
    }
  };
  judge(observed, expected, 0.032);
  judge(joint, joint_expected, 0.044);
}

TEST(EmitterSet, ChoosesWithTheProbabilityThatItStates) {
  const EmitterSet few = mixed_set(), many = many_points(1000), some = many_points(64);
  uint32_t seed = 31;
  for (const EmitterSet* set : {&few, &many, &some}) {
    expect_choice(
        set->size(), [&](float u) { return set->choose_emission(u); },
        [&](size_t i) { return set->emission_probability(i); }, seed++);
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(2, 0, 2.9f), Vec3(-500, 20, 1)})
      expect_choice(
          set->size(), [&](float u) { return set->choose_direct({p}, u); },
          [&](size_t i) { return (*set)[i].is_directional() ? 0.0f : set->direct_probability({p}, i); }, seed++);
  }
  EXPECT_FALSE(many.has_direct(true));
  EXPECT_TRUE(few.has_direct(true) && few.has_direct(false));
  const EmitterSet::Choice sun = few.choose_direct({Vec3(2, 0, 2.9f)}, 0.25f, true);
  EXPECT_EQ(sun.index, 4u);
  EXPECT_EQ(sun.probability, 1);
  EXPECT_EQ(sun.u, 0.25f);
}

// Less than one of the 2^24 values that a number has: it would get all of a value, or none.
TEST(EmitterSet, ChoosesWeakEmittersAmongStrongOnes) {
  std::vector<std::shared_ptr<const Emitter>> both;
  for (const float candela : {1.0f, 1e-9f})
    both.push_back(std::make_shared<PointEmitter>(Vec3(0, 0, 0), Rgb(candela), 0.0f));
  const EmitterSet set(std::move(both));
  const double p = double(set.emission_probability(1));
  EXPECT_NEAR(p, 1e-9, 1e-12);
  EXPECT_EQ(set.choose_emission(1 - 0.5 * p).index, 1u);
  EXPECT_EQ(set.choose_emission(1 - 2 * p).index, 0u);
}

std::shared_ptr<const RaySet> ray_set() {
  photometry::Photometry p{photometry::Distribution({0}, {0, 180}, {1, 1})};
  for (int i = 0; i < 4; ++i) p.rays.push_back({{float(i), 0, 0}, {0, 0, -1}, 10.0f * float(i + 1)});
  return std::make_shared<RaySet>(std::make_shared<photometry::Photometry>(std::move(p)));
}

// Next-event estimation never chooses a ray emitter, and chooses the others as if it were not there.
TEST(EmitterSet, LooksAtNoRays) {
  for (int points : {2, 100}) {
    Random random(40);
    std::vector<std::shared_ptr<const Emitter>> with, without;
    with.push_back(std::make_unique<RayEmitter>(ray_set(), Frame(), Vec3(1, 2, 3), Rgb(1)));
    for (int i = 0; i < points; ++i) {
      const Vec3 p = random.in_box(5);
      const Rgb intensity(random());
      with.push_back(std::make_unique<PointEmitter>(p, intensity, 0.0f));
      without.push_back(std::make_unique<PointEmitter>(p, intensity, 0.0f));
    }
    const EmitterSet all(std::move(with)), rest(std::move(without));
    EXPECT_GT(all.emission_probability(0), 0);
    for (const Vec3& p : {Vec3(0, 0, 0), Vec3(1, 2, 3), Vec3(-50, 2, 1)}) {
      EXPECT_EQ(all.direct_probability({p}, 0), 0);
      for (size_t i = 0; i < rest.size(); ++i)
        EXPECT_NEAR(all.direct_probability({p}, i + 1), rest.direct_probability({p}, i), 1e-6) << i;
      expect_choice(
          all.size(), [&](float u) { return all.choose_direct({p}, u); },
          [&](size_t i) { return all.direct_probability({p}, i); }, uint32_t(41 + points));
    }
  }
  std::vector<std::shared_ptr<const Emitter>> rays;
  rays.push_back(std::make_unique<RayEmitter>(ray_set(), Frame(), Vec3(1, 2, 3), Rgb(1)));
  const EmitterSet alone(std::move(rays));
  EXPECT_EQ(alone.choose_direct({}, 0.5f).probability, 0);
  EXPECT_EQ(alone.direct_probability({}, 0), 0);
  EXPECT_EQ(alone.choose_emission(0.5f).probability, 1);
}

// Each ray by its flux, placed by the frame; more rays than 24 bits tell apart would still be reached.
TEST(EmitterSet, RaysStartByTheirFlux) {
  const Frame f = tilted_frame();
  const auto set = ray_set();
  EXPECT_NEAR(set->effective_size(), 100.0 * 100 / (100 + 400 + 900 + 1600), 1e-4);
  const RayEmitter emitter(set, f, Vec3(1, 2, 3), Rgb(2));
  EXPECT_NEAR(emitter.flux_lm(), 200, 1e-3);
  EXPECT_NEAR(length(emitter.center() - (Vec3(1, 2, 3) + f.s * 1.5f)), 0, 1e-5);
  Random random(42);
  std::vector<double> observed(4, 0.0);
  constexpr int samples = 500000;
  for (int i = 0; i < samples; ++i) {
    EmissionSample s;
    ASSERT_TRUE(emitter.sample_emission(random.pair(), {}, s));
    const float x = dot(s.p - Vec3(1, 2, 3), f.s);
    const int ray = int(std::lround(x));
    ASSERT_NEAR(length(s.p - (Vec3(1, 2, 3) + f.s * float(ray))), 0, 1e-5);
    ASSERT_NEAR(length(s.direction + f.n), 0, 1e-6);
    ASSERT_NEAR(luminance(s.flux), 200, 1e-3);
    observed[size_t(ray)] += 1;
  }
  const std::vector<double> expected = {0.1 * samples, 0.2 * samples, 0.3 * samples, 0.4 * samples};
  EXPECT_GT(chi_square_test(observed, expected).p_value, false_alarm);
  EXPECT_LE(smallest_found(samples, 3, false_alarm), 0.01);
  EXPECT_EQ(set->choose(0.1 - 1e-12).p_m[0], 0);
  EXPECT_EQ(set->choose(0.1 + 1e-12).p_m[0], 1);
}

// Of many million rays, each is chosen by more digits than the first number has.
TEST(EmitterSet, TheSecondNumberGoesOnWhereTheFirstEnds) {
  photometry::Photometry p{photometry::Distribution({0}, {0, 180}, {1, 1})};
  p.rays.push_back({{0, 0, 0}, {0, 0, -1}, 0x1p-25f});  // half of what the first number resolves
  p.rays.push_back({{1, 0, 0}, {0, 0, -1}, 1});
  const auto set = std::make_shared<RaySet>(std::make_shared<photometry::Photometry>(std::move(p)));
  const RayEmitter emitter(set, Frame(), Vec3(), Rgb(1));
  for (const float y : {0.0f, 0.4f, 0.6f, 0.9f}) {
    EmissionSample s;
    ASSERT_TRUE(emitter.sample_emission({0, y}, {}, s));
    EXPECT_EQ(s.p.x, y < 0.5f ? 0 : 1) << y;
  }
}

// A sheet that emits to both sides is chosen alike from both.
TEST(EmitterSet, SheetsAreChosenFromBothSides) {
  std::vector<std::shared_ptr<const Emitter>> e;
  e.push_back(std::make_unique<AreaEmitter>(rectangle(Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)), Rgb(5), true, 0));
  e.push_back(std::make_unique<PointEmitter>(Vec3(4, 0, 0), Rgb(5), 0.0f));
  const EmitterSet set(std::move(e));
  for (const float x : {0.5f, -2.0f}) {
    const float above = set.direct_probability({Vec3(x, 0.5f, 2)}, 0),
                below = set.direct_probability({Vec3(x, 0.5f, -2)}, 0);
    EXPECT_GT(above, 0.2f);
    EXPECT_NEAR(below, above, 1e-5f);
  }
}

// In order of u, u after the choice rises from 0 to 1 within each emitter: strata stay strata.
TEST(EmitterSet, KeepsStratification) {
  const EmitterSet set = mixed_set();
  constexpr int steps = 10000;
  EmitterSet::Choice before = set.choose_direct({Vec3(0, 0, 1)}, 0);
  EXPECT_EQ(before.u, 0);
  int emitters = 1;
  for (int i = 1; i < steps; ++i) {
    const EmitterSet::Choice c = set.choose_direct({Vec3(0, 0, 1)}, float(i) / steps);
    const float step = 1.01f / (steps * c.probability), last_step = 1.01f / (steps * before.probability);
    if (c.index == before.index) {
      ASSERT_NEAR(c.u, before.u + step, 0.05f * step);
    } else {
      ASSERT_GT(c.index, before.index);
      ASSERT_GT(before.u, 1 - last_step);
      ASSERT_LT(c.u, step);
      ++emitters;
    }
    before = c;
  }
  EXPECT_EQ(emitters, 3);  // all that are not dark, nor directional
}

TEST(EmitterSet, EmissionIsByFlux) {
  const EmitterSet mixed = mixed_set();
  std::vector<std::shared_ptr<const Emitter>> lamps;
  for (size_t i = 0; i < mixed.size(); ++i)
    if (!mixed[i].is_directional()) lamps.push_back(mixed.shared(i));
  ASSERT_GE(lamps.size(), 3u);
  const EmitterSet set(lamps);
  double flux = 0;
  for (size_t i = 0; i < set.size(); ++i) flux += set[i].flux_lm();
  EXPECT_NEAR(set.flux_lm(), flux, 1e-6 * flux);
  for (size_t i = 0; i < set.size(); ++i) EXPECT_NEAR(set.emission_probability(i), set[i].flux_lm() / flux, 1e-6);
}

// The sun and lamps have a quarter of the light paths each at least, and by flux beyond that; among lamps by flux.
TEST(EmitterSet, EmissionForgetsNeitherTheSunNorTheLamps) {
  for (const float sun_lx : {1e-3f, 3.0f, 1e6f}) {
    std::vector<std::shared_ptr<const Emitter>> emitters;
    for (const float candela : {1.0f, 3.0f})
      emitters.push_back(std::make_shared<PointEmitter>(Vec3(0, 0, 0), Rgb(candela), 0.0f));
    emitters.push_back(std::make_shared<DirectionalEmitter>(Vec3(0, 0, -1), Rgb(sun_lx), 2.0f));
    const EmitterSet set(std::move(emitters));
    const double sun = set[2].flux_lm(), lamps = set[0].flux_lm() + set[1].flux_lm(),
                 share = std::clamp(sun / (sun + lamps), 0.25, 0.75);
    EXPECT_NEAR(set.flux_lm(), sun + lamps, 1e-6 * (sun + lamps));
    EXPECT_NEAR(set.emission_probability(2), share, 1e-6) << sun_lx;
    EXPECT_NEAR(set.emission_probability(0), 0.25 * (1 - share), 1e-6) << sun_lx;
    EXPECT_NEAR(set.emission_probability(1), 0.75 * (1 - share), 1e-6) << sun_lx;
  }
}

TEST(EmitterSet, DirectPrefersTheNearAndForgetsNone) {
  const EmitterSet set = mixed_set();
  EXPECT_GT(set.direct_probability({Vec3(2, 0, 2.5f)}, 1), 0.75);
  EXPECT_GT(set.direct_probability({Vec3(-20, 5, 2)}, 2), 0.75);
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(2, 0, 3), Vec3(1e5f, 0, 0)})
    for (size_t i = 0; i < set.size(); ++i)
      EXPECT_GE(set.direct_probability({p}, i), 0.0249f * set.emission_probability(i));
}

// A lamp of a millionth of another's flux, which may be hidden: 2.5 % of the choices go by number.
TEST(EmitterSet, DirectForgetsNoWeakOneBesideAStrongOne) {
  std::vector<std::shared_ptr<const Emitter>> e;
  e.push_back(std::make_unique<PointEmitter>(Vec3(2, 2, 2.5f), Rgb(1), 0.0f));
  e.push_back(std::make_unique<PointEmitter>(Vec3(6, 2, 2.5f), Rgb(1e6f), 0.0f));
  const EmitterSet set(std::move(e));
  for (const Vec3& p : {Vec3(0, 0, 0), Vec3(4, 2, 1)}) EXPECT_GE(set.direct_probability({p}, 0), 0.0124f);
}

TEST(EmitterSet, DependsOnNoUnitOfLength) {
  const EmitterSet metre = mixed_set();
  Random random(50);
  for (float scale : {0x1p-10f, 0x1p14f}) {
    const EmitterSet scaled = mixed_set(scale);
    for (int i = 0; i < 1000; ++i) {
      const Vec3 p = random.in_box(10);
      const float u = random();
      const EmitterSet::Choice a = metre.choose_direct({p}, u), b = scaled.choose_direct({p * scale}, u);
      ASSERT_EQ(a.index, b.index);
      ASSERT_FLOAT_EQ(a.probability, b.probability);
    }
  }
}

TEST(EmitterSet, NothingAndOneAndCoincidentOnes) {
  EXPECT_EQ(EmitterSet().choose_emission(0.5f).probability, 0);
  EXPECT_EQ(EmitterSet().choose_direct({}, 0.5f).probability, 0);
  std::vector<std::shared_ptr<const Emitter>> dark;
  dark.push_back(std::make_unique<PointEmitter>(Vec3(), Rgb(0), 0.0f));
  const EmitterSet dark_set(std::move(dark));
  EXPECT_EQ(dark_set.choose_emission(0.5f).probability, 0);
  EXPECT_EQ(dark_set.choose_direct({}, 0.5f).probability, 0);
  EXPECT_EQ(dark_set.direct_probability({}, 0), 0);

  std::vector<std::shared_ptr<const Emitter>> one, three;
  one.push_back(std::make_unique<PointEmitter>(Vec3(1, 2, 3), Rgb(1), 0.0f));
  const EmitterSet single(std::move(one));
  EXPECT_EQ(single.choose_direct({Vec3(1, 2, 3)}, 0.5f).probability, 1);
  EXPECT_EQ(single.choose_direct({Vec3(1, 2, 3)}, 0.5f).u, 0.5f);

  // Looking from the very place of two of them: finite, and told apart by flux, of which number takes 2.5 %:
  // (0.95 * 3 / 4 + 0.025 * (3 / 8 + 1 / 3)) / (0.95 / 4 + 0.025 * (1 / 8 + 1 / 3)).
  three.push_back(std::make_unique<PointEmitter>(Vec3(1, 2, 3), Rgb(1), 0.0f));
  three.push_back(std::make_unique<PointEmitter>(Vec3(1, 2, 3), Rgb(3), 0.0f));
  three.push_back(std::make_unique<PointEmitter>(Vec3(5, 2, 3), Rgb(4), 0.0f));
  const EmitterSet set(std::move(three));
  const float p0 = set.direct_probability({Vec3(1, 2, 3)}, 0), p1 = set.direct_probability({Vec3(1, 2, 3)}, 1);
  EXPECT_NEAR(p1 / p0, 2.9335, 1e-3);
  EXPECT_NEAR(p0 + p1 + set.direct_probability({Vec3(1, 2, 3)}, 2), 1, 1e-6);
}

}  // namespace
}  // namespace ups::test
