// Is emission_square the inverse of sample_emission? Directions are floats: beside an axis about which a map turns, the
// angle has as many digits as the distance from the axis leaves it, and a narrow beam as many as its width.
#include <gtest/gtest.h>

#include "emitter/test_emitters.h"

namespace ups::test {
namespace {

constexpr int samples = 50000;

uint32_t primitive_of(const EmissionSample& s) { return s.primitive == EmissionSample::invalid ? 0 : s.primitive; }

bool is_same_cell(const Vec2& a, const Vec2& b, int n) {
  const auto cell = [n](float u) { return std::min(int(u * float(n)), n - 1); };
  return cell(a.x) == cell(b.x) && cell(a.y) == cell(b.y);
}

// 0 and 1 are the same angle.
float apart(float a, float b) { return std::abs(std::remainder(a - b, 1.0f)); }

TEST(EmissionSquare, IsWhatTheSampleCameFrom) {
  for (const NamedEmitter& named : all_emitters()) {
    SCOPED_TRACE(named.name);
    const Emitter& e = *named.emitter;
    const bool narrow = named.name == std::string("narrow spot");
    Random random(30);
    int beside = 0, far = 0;
    for (int i = 0; i < samples; ++i) {
      EmissionSample s;
      const Vec2 u_position = random.pair(), u_direction = random.pair();
      if (!e.sample_emission(u_position, u_direction, s)) continue;
      const Vec2 u = e.is_directional() ? u_position : u_direction;
      Vec2 found;
      ASSERT_TRUE(e.emission_square(s.p, primitive_of(s), s.direction, found));
      ASSERT_TRUE(found.x >= 0 && found.x <= 1 && found.y >= 0 && found.y <= 1);
      far += std::max(apart(found.x, u.x), apart(found.y, u.y)) > 1e-4f;
      beside += !is_same_cell(found, u, 64);
      ASSERT_LT(apart(found.x, u.x), narrow ? 1e-3f : 1e-4f);
    }
    EXPECT_LE(far, narrow ? samples / 200 : 0);
    EXPECT_LE(beside, narrow ? samples / 200 : 5);
  }
}

// Next-event estimation knows points and primitives: the emission towards the reference runs along its edge.
TEST(EmissionSquare, FollowsWhatNextEventEstimationSamples) {
  for (const NamedEmitter& named : all_emitters()) {
    SCOPED_TRACE(named.name);
    const Emitter& e = *named.emitter;
    if (!named.coplanar || named.name == std::string("narrow spot")) continue;
    Random random(31);
    int found = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 reference = e.center() + random.in_box(3);
      DirectSample d;
      if (!e.sample_direct(reference, random.pair(), d) || d.cos_0 < 1e-3f) continue;
      Vec2 u;
      ASSERT_TRUE(e.emission_square(d.p, d.primitive, -d.wi, u));
      u = {std::min(u.x, largest_u), std::min(u.y, largest_u)};
      EmissionSample s;
      ASSERT_TRUE(e.sample_emission(u, u, s));
      // A float u has a third of its digits at a spot's rim, half of them where a surface is grazed or a table dark.
      const float tolerance = e.kind() == EmitterKind::spot ? 3e-3f : 1e-3f;
      ASSERT_LT(length(s.direction + d.wi), tolerance);
      if (e.is_directional()) {
        ASSERT_LT(length(cross(s.p - reference, s.direction)), 1e-4f * e.radius());
      }
      ++found;
    }
    EXPECT_GT(found, 100);
  }
}

TEST(EmissionSquare, KnowsWhatIsNotEmitted) {
  const Frame f = tilted_frame();
  Vec2 u;
  EXPECT_FALSE(AreaEmitter(rectangle({}, f.s, f.t), Rgb(1), false, 0).emission_square({}, 0, -f.n, u));
  EXPECT_FALSE(AreaEmitter(rectangle({}, f.s, f.t), Rgb(1), false, 0).emission_square({}, 2, f.n, u));
  EXPECT_FALSE(SpotEmitter({}, f.n, Rgb(1), 0.1f, 0.2f, 0).emission_square({}, 0, f.s, u));
  EXPECT_FALSE(DirectionalEmitter(f.n, Rgb(1), 2).emission_square(f.s * 2.1f, 0, f.n, u));
  EXPECT_FALSE(ProfilePointEmitter(lambertian(100), f, {}, Rgb(1), 0).emission_square({}, 0, f.n, u));
  EXPECT_FALSE(RayEmitter(one_ray(), f, {}, Rgb(1)).emission_square({}, 0, -f.n, u));
}

}  // namespace
}  // namespace ups::test
