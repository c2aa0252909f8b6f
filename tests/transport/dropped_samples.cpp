// Is every path that ends because its throughput is not finite counted, and are the books and readings free of it? The
// API lets no such scene in: the snapshot is poisoned after its commit. (Materials take what is no number as 0, so that
// of what scatters alone nothing comes that is not finite.)
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../support/snapshot_room.h"
#include "emitter/point.h"
#include "transport/integrator.h"

namespace ups {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr uint32_t all_techniques = UPS_TECHNIQUE_EMITTER_HIT | UPS_TECHNIQUE_LIGHT_SAMPLE | UPS_TECHNIQUE_CONNECT |
                                    UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT;

IterationTally run(std::shared_ptr<Snapshot> scene, uint32_t techniques) {
  ThreadPool pool(2);
  TransportSettings settings{.method = *method_of(UPS_METHOD_UPS)};
  settings.techniques = techniques;
  settings.light_paths = 1024;
  settings.merge_radius = 0.1f;
  const StopSignal stop;
  Integrator integrator(std::move(scene), settings, pool, stop);
  IterationTally tally;
  EXPECT_TRUE(integrator.run(0, stop, tally));
  const WorkCounts& w = tally.work;
  EXPECT_TRUE(std::isfinite(w.flux.absorbed)) << w.flux.absorbed;
  EXPECT_TRUE(std::isfinite(w.flux.escaped)) << w.flux.escaped;
  for (const auto& set : tally.meters)
    for (const MeterTally& m : set) EXPECT_TRUE(std::isfinite(m.value) && std::isfinite(m.bias));
  for (const auto& image : tally.pixels)
    for (const Rgb& pixel : image) EXPECT_TRUE(is_finite(pixel));
  for (const auto& image : tally.splats)
    for (const Splat& splat : image) EXPECT_TRUE(is_finite(splat.value));
  return tally;
}

uint64_t dropped(const IterationTally& tally, Drop where) { return tally.work.dropped[size_t(where)]; }

TEST(DroppedSamples, AreNoneWhereAllIsFinite) {
  for (const ups_material_model model : {UPS_MATERIAL_MATTE, UPS_MATERIAL_GLASS, UPS_MATERIAL_MIRROR})
    for (const uint64_t n : run(test::room(model), all_techniques).work.dropped) EXPECT_EQ(n, 0u);
}

// A medium whose absorption is not a number fills the room; meters and the camera are in it.
TEST(DroppedSamples, CountPathsThatAMediumLeavesWithoutAFiniteThroughput) {
  const auto scene = test::room(UPS_MATERIAL_GLASS);
  for (Material& m : scene->materials) m.absorption_per_m = Rgb(nan);
  const IterationTally tally = run(scene, all_techniques);
  EXPECT_GT(tally.work.eye_paths, 0u);
  EXPECT_EQ(dropped(tally, Drop::light_walk), tally.work.light_paths);
  EXPECT_EQ(dropped(tally, Drop::eye_walk), tally.work.eye_paths);
}

class InfiniteEmitter : public PointEmitter {
 public:
  using PointEmitter::PointEmitter;
  bool sample_emission(const Vec2& u, const Vec2& v, EmissionSample& out) const override {
    const bool emits = PointEmitter::sample_emission(u, v, out);
    out.flux = Rgb(std::numeric_limits<float>::infinity());
    return emits;
  }
};

TEST(DroppedSamples, CountLightPathsThatStartWithoutAFiniteFlux) {
  const auto scene = test::room(UPS_MATERIAL_MATTE);
  std::vector<std::unique_ptr<Emitter>> emitters;
  emitters.push_back(std::make_unique<InfiniteEmitter>(Vec3(), Rgb(1.0f), 0.0f));
  scene->emitters = EmitterSet(std::move(emitters), {});
  const IterationTally tally = run(scene, all_techniques);
  EXPECT_EQ(dropped(tally, Drop::emission), tally.work.light_paths);
  EXPECT_EQ(dropped(tally, Drop::light_walk), 0u);
}

}  // namespace
}  // namespace ups
