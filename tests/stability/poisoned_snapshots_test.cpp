// Hazard 2: infinities and what is no number, within transport. Is every path that ends because its throughput is not
// finite counted, and are the books and readings free of it? The API lets no such scene in: the snapshot is poisoned
// after its commit. (Materials take what is no number as 0, so that of what scatters alone nothing comes that is not
// finite.)
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <numeric>
#include <random>

#include "../support/snapshot_room.h"
#include "base/floating_point.h"
#include "emitter/area.h"
#include "emitter/point.h"
#include "../support/figures.h"
#include "transport/integrator.h"

namespace ups {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr uint32_t all_techniques = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT |
                                    UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT;

#ifdef UPS_FLOAT_TRAPS
constexpr int threads = 1;  // the one that masks its traps
#else
constexpr int threads = 2;
#endif

IterationTally run(std::shared_ptr<Snapshot> scene, uint32_t techniques, uint32_t longest = 0,
                   float merge_radius = 0.1f) {
  ThreadPool pool(threads);
  TransportSettings settings{.method = *method_of(UPS_METHOD_UPS)};
  settings.techniques = techniques;
  settings.light_paths = 1024;
  settings.merge_radius = merge_radius;
  settings.max_path_length = longest;
  const StopSignal stop;
  Integrator integrator(std::move(scene), settings, pool, stop);
  IterationTally tally;
  EXPECT_TRUE(integrator.run(0, stop, tally));
  const WorkCounts& w = tally.work;
  for (const FluxBooks& b : {w.flux, w.importance})
    for (const double part : {b.started, b.absorbed, b.escaped, b.cut, b.roulette, b.roulette_variance})
      EXPECT_TRUE(std::isfinite(part)) << part;
  EXPECT_TRUE(std::isfinite(w.leaning_lm.sum) && std::isfinite(w.leaning_eye.sum));
  for (const auto& set : tally.meters)
    for (const MeterTally& m : set)
      for (const double part : {m.value, m.direct, m.bias, m.exact, m.exact_mirrored, double(m.rounding),
                                double(m.paths[whole_light].largest)})
        EXPECT_TRUE(std::isfinite(part)) << part;
  for (const auto& set : tally.landings)
    for (const MeterLanding& l : set) EXPECT_TRUE(std::isfinite(l.lm)) << l.lm;
  for (const auto& image : tally.pixel_merges)
    for (const PixelMerges& m : image)
      for (const float part : {m.bias, m.disc_m2, m.caustics, m.caustics_met, m.caustic_light})
        EXPECT_TRUE(std::isfinite(part)) << part;
  for (const auto& image : tally.pixels)
    for (const Rgb& pixel : image) EXPECT_TRUE(is_finite(pixel));
  for (const auto& image : tally.splats)
    for (const Splat& splat : image) EXPECT_TRUE(is_finite(splat.value));
  return tally;
}

uint64_t dropped(const IterationTally& tally, Drop where) { return tally.work.dropped[size_t(where)]; }

// So many there, and none elsewhere.
void expect_dropped(const IterationTally& tally, Drop where, uint64_t count) {
  EXPECT_GT(count, 0u);
  for (size_t k = 0; k < size_t(Drop::count); ++k)
    EXPECT_EQ(tally.work.dropped[k], Drop(k) == where ? count : 0u) << drop_names[k];
}

void shine_alone(Snapshot& scene, std::shared_ptr<const Emitter> emitter) {
  std::vector<std::shared_ptr<const Emitter>> emitters;
  emitters.push_back(std::move(emitter));
  scene.emitters = EmitterSet(std::move(emitters), {});
}

TEST(Hazard02, NoSampleIsDroppedWhereAllIsFinite) {
  for (const ups_material_model model : {UPS_MATERIAL_MATTE, UPS_MATERIAL_GLASS, UPS_MATERIAL_MIRROR})
    for (const uint64_t n : run(test::room(model), all_techniques).work.dropped) EXPECT_EQ(n, 0u);
}

// A medium whose absorption is not a number fills the room; meters and the camera are in it.
TEST(Hazard02, PathsThatAMediumLeavesWithoutAFiniteThroughputAreCounted) {
  const auto scene = test::room(UPS_MATERIAL_GLASS);
  for (Material& m : scene->materials) m.absorption_per_m = Rgb(nan);
  const IterationTally tally = run(scene, all_techniques);
  EXPECT_GT(tally.work.eye_paths, 0u);
  EXPECT_EQ(dropped(tally, Drop::light_walk), tally.work.light_paths);
  EXPECT_EQ(dropped(tally, Drop::eye_walk), tally.work.eye_paths);
}

class PoisonedEmitter : public PointEmitter {
 public:
  explicit PoisonedEmitter(std::function<void(EmissionSample&)> poison)
      : PointEmitter(Vec3(), Rgb(1.0f), 0.0f), poison_(std::move(poison)) {}
  PoisonedEmitter(const Vec3& p, float value) : PointEmitter(p, Rgb(1.0f), 0.0f), value_(value) {}
  bool sample_emission(const Vec2& u, const Vec2& v, EmissionSample& out) const override {
    const bool emits = PointEmitter::sample_emission(u, v, out);
    if (poison_) poison_(out);
    return emits;
  }
  bool sample_direct(const Vec3& reference, const Vec2& u, DirectSample& out) const override {
    const bool emits = PointEmitter::sample_direct(reference, u, out);
    out.weight *= value_;
    return emits;
  }

 private:
  std::function<void(EmissionSample&)> poison_;
  float value_ = 1;
};

TEST(Hazard02, LightPathsThatStartWithoutAFiniteFluxPlaceOrDirectionAreCounted) {
  for (const auto poison : {+[](EmissionSample& s) { s.flux = Rgb(std::numeric_limits<float>::infinity()); },
                            +[](EmissionSample& s) { s.p.y = nan; }, +[](EmissionSample& s) { s.direction.z = nan; }}) {
    const auto scene = test::room(UPS_MATERIAL_MATTE);
    shine_alone(*scene, std::make_shared<PoisonedEmitter>(poison));
    const IterationTally tally = run(scene, all_techniques);
    EXPECT_EQ(dropped(tally, Drop::emission), tally.work.light_paths);
    EXPECT_EQ(dropped(tally, Drop::light_walk), 0u);
  }
}

// In a convex room every vertex of a path sees the lamp, which is above the meters: its light is dropped at each, and
// at the two meters, whose light comes straight by a shadow ray, once.
TEST(Hazard02, LightSamplesThatAreNotFiniteAreCounted) {
  for (const float value : {nan, std::numeric_limits<float>::infinity()}) {
    const TrapsMasked masked;
    const auto scene = test::room(UPS_MATERIAL_MATTE);
    const Vec3 lamp = scene->emitters[0].center();
    shine_alone(*scene, std::make_shared<PoisonedEmitter>(lamp, value));
    const IterationTally straight = run(scene, UPS_TECHNIQUE_LIGHT_SAMPLE, 1);
    EXPECT_EQ(dropped(straight, Drop::light_sample), 2u);
    const IterationTally all = run(scene, UPS_TECHNIQUE_LIGHT_SAMPLE);
    EXPECT_GE(dropped(all, Drop::light_sample), all.work.eye_paths + 2);
    for (const Drop other : {Drop::emitter_hit, Drop::eye_walk, Drop::light_walk}) EXPECT_EQ(dropped(all, other), 0u);
    for (const auto& set : all.meters)
      for (const MeterTally& m : set) EXPECT_EQ(m.value, 0);
  }
}

// What an eye path sees of it.
class PoisonedSurface : public AreaEmitter {
 public:
  explicit PoisonedSurface(float value)
      : AreaEmitter(std::vector<EmitterTriangle>{{Vec3(), Vec3(1, 0, 0), Vec3(0, 1, 0)}}, Rgb(1.0f), false, 0),
        value_(value) {}
  bool eval_hit(const Vec3&, const Vec3&, uint32_t, const Vec3&, EmitterHit& out) const override {
    out.radiance = Rgb(value_);
    out.pdf_nee_a = out.pdf_position_a = out.pdf_direction_w = 1;
    return true;
  }

 private:
  float value_;
};

// All surfaces of the room shine: of one edge every eye path sees it once.
TEST(Hazard02, EmitterHitsThatAreNotFiniteAreCounted) {
  for (const float value : {nan, std::numeric_limits<float>::infinity()}) {
    const TrapsMasked masked;
    const auto scene = test::room(UPS_MATERIAL_MATTE);
    shine_alone(*scene, std::make_shared<PoisonedSurface>(value));
    scene->emitter_of_instance.assign(scene->instances.size(), 0u);
    const IterationTally straight = run(scene, UPS_TECHNIQUE_EMITTER_HIT, 1);
    expect_dropped(straight, Drop::emitter_hit, straight.work.eye_paths);
    const IterationTally all = run(scene, UPS_TECHNIQUE_EMITTER_HIT);
    EXPECT_GT(dropped(all, Drop::emitter_hit), all.work.eye_paths);
    expect_dropped(all, Drop::emitter_hit, dropped(all, Drop::emitter_hit));
    for (const auto& set : all.meters)
      for (const MeterTally& m : set) EXPECT_EQ(m.value, 0);
  }
}

// All light paths leave p in one direction, each with nearly as much flux as floats hold: what a narrow kernel, a small
// cell or a short edge makes of it is infinite, while what goes on is not.
std::shared_ptr<const Emitter> beam(const Vec3& p, const Vec3& direction) {
  return std::make_shared<PoisonedEmitter>(
      [=](EmissionSample& s) { s.p = p, s.direction = direction, s.flux = Rgb(3e38f); });
}

// 2 cm wide: flux over area and number of paths is 7e38.
TEST(Hazard02, LandingsOnCellsThatAreNotFiniteAreCounted) {
  const TrapsMasked masked;
  const auto scene = test::room(UPS_MATERIAL_MATTE);
  MeterSet& set = scene->meter_sets[0];
  const Meter meter = set.meters[0];
  set.cell_width = set.cell_height = 0.02f;
  shine_alone(*scene, beam(meter.p + meter.frame.n * 0.5f, -meter.frame.n));
  const IterationTally tally = run(scene, UPS_TECHNIQUE_SENSOR_HIT, 1);
  expect_dropped(tally, Drop::sensor_hit, tally.work.light_paths);
}

// The same on a point meter's disc of 1 cm.
TEST(Hazard02, PhotonsOnMetersThatAreNotFiniteAreCounted) {
  const TrapsMasked masked;
  const auto scene = test::room(UPS_MATERIAL_MATTE);
  const Meter meter = scene->meter_sets[0].meters[0];
  shine_alone(*scene, beam(meter.p + meter.frame.n * 0.5f, -meter.frame.n));
  const IterationTally tally = run(scene, UPS_TECHNIQUE_MERGE, 1, 0.01f);
  expect_dropped(tally, Drop::merge, tally.work.light_paths);
}

// A camera of 16 pixels, 2.5 m above the floor and not above a meter, that sees 5 mm of it.
Camera narrow_camera(const Snapshot& scene) {
  const Vec3 p = scene.cameras[0].position() + Vec3(0.7f, 0.9f, 0);
  Affine to_scene;
  to_scene.m[3] = p.x, to_scene.m[7] = p.y, to_scene.m[11] = p.z;
  return Camera(to_scene, 4, 4, 0.002f, false);
}

// Every pixel's path finds every photon within 5 mm of where it meets the floor.
TEST(Hazard02, MergesThatAreNotFiniteAreCounted) {
  const TrapsMasked masked;
  const auto scene = test::room(UPS_MATERIAL_MATTE);
  scene->cameras = {narrow_camera(*scene)};
  shine_alone(*scene, beam(scene->cameras[0].position(), scene->cameras[0].forward()));
  const IterationTally tally = run(scene, UPS_TECHNIQUE_MERGE, 2, 0.005f);
  expect_dropped(tally, Drop::merge, 16 * tally.work.light_paths);
}

TEST(Hazard02, SplatsThatAreNotFiniteAreCounted) {
  const TrapsMasked masked;
  const auto scene = test::room(UPS_MATERIAL_MATTE);
  scene->cameras = {narrow_camera(*scene)};
  shine_alone(*scene, beam(scene->cameras[0].position(), scene->cameras[0].forward()));
  const IterationTally tally = run(scene, UPS_TECHNIQUE_SENSOR_CONNECT, 2);
  expect_dropped(tally, Drop::sensor_connect, tally.work.light_paths);
}

// From a meter a centimetre below the ceiling to where all light paths meet that, right above it. The other meter has
// as many paths, and sees the place from afar; paths of the camera would have three edges.
TEST(Hazard02, ConnectionsThatAreNotFiniteAreCounted) {
  const TrapsMasked masked;
  const auto scene = test::room(UPS_MATERIAL_MATTE);
  Meter& meter = scene->meter_sets[0].meters[0];
  ASSERT_EQ(scene->meter_sets[0].meters.size(), 2u);
  meter.p += Vec3(0, 0, 1.99f);
  shine_alone(*scene, beam(meter.p, meter.frame.n));
  const IterationTally tally = run(scene, UPS_TECHNIQUE_CONNECT, 2);
  expect_dropped(tally, Drop::connect, (tally.work.eye_paths - scene->cameras[0].pixel_count()) / 2);
}

// Values of the material or the light: not a number, infinite, out of all range, or no more than denormal. Whatever
// comes of it, nothing that is not finite comes out (run() looks), and what is dropped has a reason. (Not places: the
// API takes none that is not finite, and builds of Embree with assertions end the process for a ray from there.)
class Poison {
 public:
  explicit Poison(uint32_t seed) : rng_(seed) {}

  void apply(Snapshot& scene) {
    Material& m = scene.materials[0];
    float* const values[] = {&m.reflectance.r,  &m.reflectance.g,      &m.transmittance.b, &m.absorption_per_m.r,
                             &m.roughness,      &m.ior,                &m.metallic,        &m.absorption_per_m.b,
                             &m.ior_rgb.g,      &m.ior_k_rgb.r};
    for (int i = 0; i < 1 + pick(2); ++i) *values[pick(int(std::size(values)))] = value();
    if (pick(4) > 0) return;
    std::vector<std::shared_ptr<const Emitter>> emitters;
    emitters.push_back(std::make_unique<PointEmitter>(Vec3(), Rgb(value()), 0.0f));
    scene.emitters = EmitterSet(std::move(emitters), {});
  }

 private:
  int pick(int n) { return std::uniform_int_distribution<int>(0, n - 1)(rng_); }
  float value() {
    constexpr float inf = std::numeric_limits<float>::infinity();
    constexpr float values[] = {nan, inf, -inf, -1, 0, -0.0f, 3e38f, -3e38f, 1e20f, 1e-38f, 1e-45f, 1e-20f};
    return values[pick(int(std::size(values)))];
  }
  std::mt19937 rng_;
};

TEST(Hazard02, NothingThatIsNotFiniteComesOutOfAPoisonedScene) {
  const TrapsMasked masked;
  size_t with_drops = 0;
  const uint32_t cases = test::fast_or_full(250u, 400u);
  for (uint32_t i = 0; i < cases; ++i) {
    constexpr ups_material_model models[] = {UPS_MATERIAL_MATTE,  UPS_MATERIAL_GLASS,   UPS_MATERIAL_MIRROR,
                                             UPS_MATERIAL_METAL,  UPS_MATERIAL_PLASTIC, UPS_MATERIAL_GLAZING,
                                             UPS_MATERIAL_DIFFUSER};
    const auto scene = test::room(models[i % std::size(models)]);
    Poison(i).apply(*scene);
    const IterationTally tally = run(scene, all_techniques);
    const auto& drops = tally.work.dropped;
    with_drops += std::accumulate(drops.begin(), drops.end(), uint64_t(0)) > 0;
    ASSERT_FALSE(::testing::Test::HasFailure()) << "case " << i;
  }
  test::measured("%u scenes, samples dropped in %zu", cases, with_drops);
  EXPECT_GT(with_drops, 0u);
}

}  // namespace
}  // namespace ups
