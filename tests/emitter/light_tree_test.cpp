// Is the choice of an emitter for next-event estimation a probability, the same from both walks, never 0 where there is
// light, and close to what the emitters bring? All kinds of emitters, weighed one by one and by the tree. No chance is
// involved: u runs through a fine row of strata.
#include <gtest/gtest.h>

#include <map>

#include "emitter/emitter_set.h"
#include "emitter/test_emitters.h"

namespace ups::test {
namespace {

constexpr double share_by_flux = 0.05;  // half of it by number

Frame random_frame(Random& random) {
  Vec3 n;
  do n = random.in_box(1);
  while (!(length2(n) > 0.01f));
  return Frame(normalize(n));
}

// All kinds in turn, anywhere in a box of 20 m x 20 m x 20 m, in any direction.
std::vector<std::shared_ptr<const Emitter>> all_kinds(int n, uint32_t seed) {
  Random random(seed);
  const auto distribution = up_and_down();
  const auto openings = all_openings();
  std::vector<std::shared_ptr<const Emitter>> out;
  for (int i = 0; i < n; ++i) {
    const Frame f = random_frame(random);
    const Vec3 p = random.in_box(10);
    const Rgb colour(random(), 0.1f, random());
    const auto add = [&](auto emitter) { out.push_back(std::move(emitter)); };
    switch (i % 10) {
      case 0: add(std::make_unique<PointEmitter>(p, colour, 1e-6f)); break;
      case 1: add(std::make_unique<SpotEmitter>(p, f.n, colour * 9, 0.3f, 0.7f, 1e-6f)); break;
      case 2: add(std::make_unique<SpotEmitter>(p, f.n, colour * 900, 0.0f, 0.02f, 1e-6f)); break;
      case 3: add(std::make_unique<ProfilePointEmitter>(distribution, f, p, colour, 1e-6f)); break;
      case 4: add(std::make_unique<AreaEmitter>(rectangle(p, f.s * 2.0f, f.t * 0.5f), colour, false, 7)); break;
      case 5: add(std::make_unique<AreaEmitter>(rectangle(p, f.s * 0.2f, f.t * 0.5f), colour, true, 7)); break;
      case 6: {
        auto triangles = tetrahedron();
        for (EmitterTriangle& t : triangles) t.p0 += p, t.p1 += p, t.p2 += p;
        add(std::make_unique<AreaEmitter>(triangles, colour, false, 8));
        break;
      }
      case 7: add(std::make_unique<DirectionalEmitter>(f.n, colour * 0.01f, 20.0f)); break;
      default: {
        const photometry::Opening& opening = openings[size_t(i / 10) % openings.size()].opening;
        add(std::make_unique<ProfileOpeningEmitter>(distribution, f, p, opening, colour, 1e-6f));
      }
    }
  }
  return out;
}

// On a plane, seen from everywhere, and with both sides, in turn.
Receiver random_receiver(int i, Random& random) {
  const Vec3 p = random.in_box(i % 7 == 0 ? 100.0f : 10.0f);
  if (i % 3 == 0) return {p};
  return {p, random_frame(random).n, i % 3 == 1};
}

// What the emitter brings, unoccluded.
double brought(const Emitter& emitter, const Receiver& r, int numbers) {
  double sum = 0;
  for (int i = 0; i < numbers; ++i) {
    const double turn = i * 0.6180339887498949;
    DirectSample s;
    if (!emitter.sample_direct(r.p, {float((i + 0.5) / numbers), float(turn - std::floor(turn))}, s)) continue;
    const float cosine = dot(s.wi, r.n);
    sum += luminance(s.weight) * (max_abs(r.n) == 0 ? 1 : r.both_sides ? std::abs(cosine) : std::max(0.0f, cosine));
  }
  return sum / numbers;
}

struct Case {
  int emitters;
  bool exposed;
};
class LightTreeOf : public ::testing::TestWithParam<Case> {
 protected:
  EmitterSet set() const {
    std::vector<float> exposed;
    Random random(60);
    for (int i = 0; GetParam().exposed && i < GetParam().emitters; ++i) exposed.push_back(i % 5 ? random() : 0);
    return EmitterSet(all_kinds(GetParam().emitters, 61), exposed);
  }
};

TEST_P(LightTreeOf, IsAProbabilityThatForgetsNone) {
  const EmitterSet emitters = set();
  Random random(62);
  for (int k = 0; k < 60; ++k) {
    const Receiver r = random_receiver(k, random);
    double sum[2] = {};  // of directional ones apart
    bool any[2] = {};
    for (size_t i = 0; i < emitters.size(); ++i) {
      const double p = emitters.direct_probability(r, i);
      const bool far = emitters[i].is_directional();
      sum[far] += p;
      if (!(brought(emitters[i], r, 16) > 0)) continue;
      any[far] = true;
      const double of_all = (emitters.emission_probability(i) + 1 / double(emitters.size())) / 2;
      EXPECT_GE(p, 0.999 * share_by_flux * of_all) << k << " " << i;
    }
    for (const int far : {0, 1})
      EXPECT_TRUE(sum[far] == 0 ? !any[far] : std::abs(sum[far] - 1) < 2e-5) << k << " " << sum[far];
  }
}

// Each emitter has one stretch of u as long as its probability, and u starts there again from 0.
TEST_P(LightTreeOf, ChoosesWithTheProbabilityThatItStates) {
  const EmitterSet emitters = set();
  Random random(63);
  constexpr int steps = 1 << 14;
  for (int k = 0; k < 12; ++k) {
    const Receiver r = random_receiver(k, random);
    const bool far = k % 2;
    std::vector<int> chosen(emitters.size());
    EmitterSet::Choice before;
    for (int i = 0; i < steps; ++i) {
      const EmitterSet::Choice c = emitters.choose_direct(r, (float(i) + 0.5f) / steps, far);
      if (!(c.probability > 0)) continue;
      ASSERT_EQ(c.probability, emitters.direct_probability(r, c.index));  // the same bits
      ASSERT_GE(c.u, 0);
      ASSERT_LT(c.u, 1);
      if (chosen[c.index]++ > 0) {
        ASSERT_EQ(c.index, before.index);
        ASSERT_NEAR(c.u, before.u + 1 / (steps * c.probability), 1e-3 / c.probability / steps + 1e-5) << c.index;
      }
      before = c;
    }
    for (size_t i = 0; i < emitters.size(); ++i) {
      const double stated = emitters[i].is_directional() == far ? double(emitters.direct_probability(r, i)) : 0.0;
      ASSERT_NEAR(double(chosen[i]) / steps, stated, 1.1 / steps) << k << " " << i;
    }
  }
}

// A point right beside the receiver among 10,000, of which each has some 2.5e-6: numbers of 24 bits would give it up to
// 2.4 % too much or too little, and sums of floats the last one 20 %.
TEST(LightTreeOfMany, GivesEachItsShareHoweverSmall) {
  std::vector<std::shared_ptr<const Emitter>> points;
  Random random(66);
  for (int i = 0; i < 10'000; ++i) points.push_back(std::make_unique<PointEmitter>(random.in_box(10), Rgb(1), 1e-6f));
  points.push_back(std::make_unique<PointEmitter>(Vec3(20, 0, 0.001f), Rgb(1), 1e-6f));
  const EmitterSet set(std::move(points));
  const Receiver r{Vec3(20, 0, 0), Vec3(0, 0, 1)};
  std::map<uint32_t, double> met;  // where
  for (int i = 0; i < 1'000'000; ++i) met.emplace(set.choose_direct(r, (i + 0.5) * 1e-6).index, (i + 0.5) * 1e-6);
  const auto is_chosen = [&](double u, uint32_t which) { return set.choose_direct(r, u).index == which; };
  // From within to beyond, where it ends.
  const auto edge = [&](uint32_t which, double within, double beyond) {
    for (int i = 0; i < 60; ++i) (is_chosen((within + beyond) / 2, which) ? within : beyond) = (within + beyond) / 2;
    return within;
  };
  int weak = 0;
  for (const auto& [which, u] : met) {
    const double p = set.direct_probability(r, which);
    if (p > 1e-5 || which % 8 > 0) continue;
    const double first = edge(which, u, u - 1.5 * p), last = edge(which, u, std::min(u + 1.5 * p, 1.0));
    EXPECT_NEAR(last - first, p, 1e-4 * p) << which;
    // What is left of the number chooses again, among images in mirrors: not to a float's steps either.
    const double middle = (first + last) / 2;
    EXPECT_NEAR(set.choose_direct(r, middle + 1e-8 * p).u - set.choose_direct(r, middle).u, 1e-8, 1e-9) << which;
    ++weak;
  }
  EXPECT_GT(weak, 100);
}

TEST_P(LightTreeOf, IsBuiltAlikeAgain) {
  const EmitterSet a = set(), b = set();
  Random random(64);
  for (int k = 0; k < 30; ++k) {
    const Receiver r = random_receiver(k, random);
    for (size_t i = 0; i < a.size(); ++i) ASSERT_EQ(a.direct_probability(r, i), b.direct_probability(r, i));
  }
}

INSTANTIATE_TEST_SUITE_P(Sizes, LightTreeOf,
                         ::testing::Values(Case{1, false}, Case{8, false}, Case{64, false}, Case{65, false},
                                           Case{1000, false}, Case{8, true}, Case{64, true}, Case{65, true},
                                           Case{1000, true}),
                         [](const auto& about) {
                           return std::to_string(about.param.emitters) + (about.param.exposed ? "Exposed" : "");
                         });

// A switch: one emitter is not weighed.
TEST(LightTreeOfOne, IsAsIfItWereWeighed) {
  const auto emitters = all_kinds(40, 64);
  Random random(65);
  for (const auto& emitter : emitters) {
    const std::vector<LightTree::Entry> entry = {{emitter->outline(), emitter->flux_lm(), 1, 0}};
    const LightTree quick(entry, 1), weighed(entry, 1, true);
    for (int k = 0; k < 200; ++k) {
      const Receiver r = random_receiver(k, random);
      const float u = random();
      const EmitterChoice a = quick.choose(r, u), b = weighed.choose(r, u);
      ASSERT_EQ(a.probability, b.probability) << k;
      ASSERT_EQ(a.u, b.u) << k;
      ASSERT_EQ(quick.probability(r, 0), weighed.probability(r, 0)) << k;
    }
  }
}

// What brings a part of the light is chosen about as often as that part says: the variance of one sample, relative to
// the squared illuminance, is the sum of share^2 / probability - 1. n x n downlights in a hall of 40 m x 40 m x 5 m,
// I = I0 cos^4 gamma.
class Hall : public ::testing::TestWithParam<int> {
 protected:
  EmitterSet luminaires() const {
    std::vector<double> gamma, table;
    for (int j = 0; j <= 36; ++j) {
      gamma.push_back(5 * j);
      table.push_back(j < 18 ? 1000 * std::pow(std::cos(5 * j * pi_d / 180), 4) : 0);
    }
    const auto downlight = std::make_shared<photometry::Distribution>(std::vector<double>{0}, gamma, table);
    std::vector<std::shared_ptr<const Emitter>> out;
    const int n = GetParam();
    for (int i = 0; i < n * n; ++i)
      out.push_back(std::make_unique<ProfilePointEmitter>(
          downlight, Frame(), Vec3((float(i % n) + 0.5f) * 40 / float(n), (float(i / n) + 0.5f) * 40 / float(n), 4.9f),
          Rgb(1), 1e-6f));
    return EmitterSet(std::move(out));
  }
  struct Quality {
    double variance = 0, least = 1e9;  // least: probability over share, of emitters with a hundredth of the light
  };
  static Quality quality(const EmitterSet& set, const Receiver& r) {
    std::vector<double> light;
    double sum = 0, squares = 0;
    for (size_t i = 0; i < set.size(); ++i) sum += light.emplace_back(brought(set[i], r, 1));
    Quality q;
    for (size_t i = 0; i < set.size(); ++i) {
      if (!(light[i] > 0)) continue;
      const double p = set.direct_probability(r, i), share = light[i] / sum;
      squares += share * share / p;
      if (share > 0.01) q.least = std::min(q.least, p / share);
    }
    q.variance = squares - 1;
    return q;
  }
};

TEST_P(Hall, IsLitByWhatIsChosen) {
  const EmitterSet set = luminaires();
  Random random(70);
  double floor = 0, wall = 0, least_on_floor = 1e9;
  constexpr int receivers = 100;
  for (int k = 0; k < receivers; ++k) {
    const Quality on_floor = quality(set, {Vec3(40 * random(), 40 * random(), 0), Vec3(0, 0, 1)});
    floor += on_floor.variance / receivers;
    least_on_floor = std::min(least_on_floor, on_floor.least);
    wall += quality(set, {Vec3(0, 40 * random(), 3 * random()), Vec3(1, 0, 0)}).variance / receivers;
  }
  EXPECT_LT(floor, 0.15);
  EXPECT_LT(wall, 0.25);
  EXPECT_GT(least_on_floor, set.size() <= LightTree::max_listed ? 0.5 : 0.2);
}

INSTANTIATE_TEST_SUITE_P(Of, Hall, ::testing::Values(3, 8, 9, 32),
                         [](const auto& about) { return std::to_string(about.param * about.param); });

// Nothing is spent on what lies behind the receiver, nor where there is no light at all.
TEST(LightTree, LooksAheadOnly) {
  for (int n : {10, 200}) {
    std::vector<std::shared_ptr<const Emitter>> e;
    for (int i = 0; i < n; ++i)
      e.push_back(std::make_unique<PointEmitter>(Vec3(float(i % 10), float(i / 10), i % 2 ? 1.0f : -1.0f), Rgb(1), 0));
    const EmitterSet set(std::move(e));
    for (int i = 0; i < n; ++i) {
      EXPECT_EQ(set.direct_probability({Vec3(), Vec3(0, 0, 1)}, size_t(i)) > 0, i % 2 == 1);
      EXPECT_GT(set.direct_probability({Vec3(), Vec3(0, 0, 1), true}, size_t(i)), 0);
      EXPECT_EQ(set.direct_probability({Vec3(0, 0, 2), Vec3(0, 0, 1)}, size_t(i)), 0);
    }
    EXPECT_EQ(set.choose_direct({Vec3(0, 0, 2), Vec3(0, 0, 1)}, 0.5f).probability, 0);
  }
}

// Hidden ones are left to a hundredth of their part.
TEST(LightTree, LeavesTheHiddenAside) {
  for (int n : {2, 200}) {
    std::vector<std::shared_ptr<const Emitter>> e;
    std::vector<float> exposed;
    for (int i = 0; i < n; ++i) {
      e.push_back(std::make_unique<PointEmitter>(Vec3(float(i % 10), float(i / 10), 5), Rgb(1), 0.0f));
      exposed.push_back(i % 2 ? 1.0f : 0.0f);
    }
    const EmitterSet set(std::move(e), exposed);
    double hidden = 0;
    for (int i = 0; i < n; i += 2) hidden += set.direct_probability({Vec3(4, 4, 0), Vec3(0, 0, 1)}, size_t(i));
    EXPECT_LT(hidden, 0.5 * share_by_flux + 0.02);
    EXPECT_GT(hidden, 0.4 * share_by_flux);
  }
}

// A peak half a degree wide, between the directions by which a luminaire's table is made, 3 degrees apart.
TEST(Lobe, PeaksBetweenItsDirectionsAreSeen) {
  constexpr size_t planes = 12, rows = 361, plane = 1, row = 83;  // C 30, gamma 41.5
  std::vector<double> c, gamma, cd(planes * rows);
  for (size_t i = 0; i < planes; ++i) c.push_back(30.0 * double(i));
  for (size_t i = 0; i < rows; ++i) gamma.push_back(0.5 * double(i));
  cd[plane * rows + row] = 1000;
  const FineTable table = fine_table(photometry::Distribution(c, gamma, cd));
  const double turn = pi_d / 180 * c[plane], down = pi_d / 180 * gamma[row];
  const Vec3 w(float(std::sin(down) * std::cos(turn)), float(std::sin(down) * std::sin(turn)), float(-std::cos(down)));
  EXPECT_FLOAT_EQ(table[size_t(Lobe::Fine::texel(w))], 1000);
}

// A spot of half a degree between the four directions by which a texel of a group is asked.
TEST(Lobe, BeamsNarrowerThanATexelCountInAGroup) {
  const Vec3 axis = Lobe::Coarse::direction(20, 0.45f, 0.55f);
  const double versine = 1 - std::cos(pi_d / 360);
  CoarseTable table{};
  add_to(table, cone_lobe(Frame(axis), 0.5 * versine, versine), 100);
  EXPECT_GE(table[20], 25);
}

}  // namespace
}  // namespace ups::test
