// Which light can a set of techniques sample? The support table of every method, by patterns of paths.
#include "render/coverage.h"

#include <gtest/gtest.h>

#include "render/method.h"

namespace {

using namespace ups;

TransportSettings settings(int32_t method, uint32_t techniques) {
  return settings_of({.method = method}, {method, techniques, {}, {}});
}
constexpr uint32_t hit = UPS_TECHNIQUE_EMITTER_HIT, light_sample = UPS_TECHNIQUE_LIGHT_SAMPLE,
                   join = UPS_TECHNIQUE_CONNECT, splat = UPS_TECHNIQUE_SENSOR_CONNECT, merge = UPS_TECHNIQUE_MERGE,
                   land = UPS_TECHNIQUE_SENSOR_HIT;
const TransportSettings pt = settings(UPS_METHOD_PATH_TRACING, hit | light_sample),
                        bpt = settings(UPS_METHOD_BIDIRECTIONAL, hit | light_sample | join | splat),
                        lt = settings(UPS_METHOD_LIGHT_TRACING, join | splat | land),
                        ppm = settings(UPS_METHOD_PPM, hit | merge | land),
                        sppm = settings(UPS_METHOD_SPPM, hit | merge | land),
                        bpm = settings(UPS_METHOD_BIDIRECTIONAL_PHOTON_MAPPING, hit | merge | land),
                        all = settings(UPS_METHOD_UPS, hit | light_sample | join | splat | merge | land);
constexpr SourceKind hittable = SourceKind::hittable, punctual = SourceKind::punctual, rays = SourceKind::rays;
constexpr SensorKind camera = SensorKind::camera, point = SensorKind::point_meter, cell = SensorKind::cell;

std::vector<std::string> all_patterns() {
  std::vector<std::string> p = {""};
  for (size_t i = 0; i < p.size(); ++i)
    if (p[i].size() < 4)
      for (char c : {'S', 'G', 'D'}) p.push_back(p[i] + c);
  return p;
}

void expect_all_light(const TransportSettings& s) {
  for (const std::string& v : all_patterns())
    for (SourceKind source : {hittable, punctual, rays})
      for (SensorKind sensor : {camera, point, cell})
        if (is_measurable(v, source, sensor)) {
          EXPECT_TRUE(can_sample(v, source, sensor, s)) << v << " " << int(source) << " " << int(sensor);
        }
}

TEST(Coverage, UnifiedPathSamplingHasATechniqueForAllLight) { expect_all_light(all); }

// PPM merges at the first vertex that is not specular, and bidirectional photon mapping at all: they need extent only
// where an emitter is seen directly.
TEST(Coverage, PhotonMappingHasATechniqueForAllLight) {
  expect_all_light(ppm);
  expect_all_light(bpm);
}

TEST(Coverage, PathTracingNeedsExtentOrADiffuseFirstVertex) {
  for (const std::string& v : all_patterns()) {
    EXPECT_TRUE(can_sample(v, hittable, camera, pt)) << v;
    if (!v.empty()) {
      EXPECT_EQ(can_sample(v, punctual, camera, pt), v[0] != 'S') << v;
      EXPECT_EQ(can_sample(v, punctual, point, pt), v[0] != 'S') << v;
    }
  }
  EXPECT_TRUE(can_sample("", punctual, point, pt));
}

TEST(Coverage, BidirectionalPathTracingCannotSampleSpecularDiffuseSpecular) {
  EXPECT_FALSE(can_sample("SDS", punctual, camera, bpt));
  EXPECT_FALSE(can_sample("SDSDS", punctual, camera, bpt));
  EXPECT_FALSE(can_sample("S", punctual, point, bpt));
  EXPECT_FALSE(can_sample("S", punctual, cell, bpt));
  EXPECT_TRUE(can_sample("SD", punctual, camera, bpt));    // t = 1
  EXPECT_TRUE(can_sample("SD", punctual, point, bpt));     // a connection to the meter
  EXPECT_TRUE(can_sample("SDDS", punctual, camera, bpt));  // a connection between the two
  EXPECT_TRUE(can_sample("DS", punctual, camera, bpt));    // next-event estimation
  EXPECT_TRUE(can_sample("SDS", hittable, camera, bpt));    // an eye path that runs into the emitter
}

TEST(Coverage, LightTracingNeedsADiffuseLastVertexOrACell) {
  for (const std::string& v : all_patterns()) {
    const bool last = !v.empty() && v.back() != 'S';
    EXPECT_EQ(can_sample(v, hittable, camera, lt), v.empty() || last) << v;
    EXPECT_EQ(can_sample(v, punctual, point, lt), v.empty() || last) << v;
    EXPECT_TRUE(can_sample(v, punctual, cell, lt)) << v;
  }
}

TEST(Coverage, StochasticPhotonMappingLosesPointSourcesInGlossySurfaces) {
  EXPECT_FALSE(can_sample("G", punctual, camera, sppm));
  EXPECT_FALSE(can_sample("SG", punctual, camera, sppm));
  EXPECT_TRUE(can_sample("G", hittable, camera, sppm));
  EXPECT_TRUE(can_sample("DG", punctual, camera, sppm));
  EXPECT_TRUE(can_sample("GD", punctual, camera, sppm));
  EXPECT_TRUE(can_sample("G", punctual, point, sppm));
}

// Neither hits nor next-event estimation: what merging, splats, connections and landing leave.
TEST(Coverage, RaysNeedLightPaths) {
  for (const std::string& v : all_patterns())
    for (SensorKind sensor : {camera, point, cell}) EXPECT_FALSE(can_sample(v, rays, sensor, pt)) << v;
  EXPECT_FALSE(can_sample("", rays, point, bpt));
  EXPECT_FALSE(can_sample("", rays, cell, bpt));
  EXPECT_TRUE(can_sample("D", rays, camera, bpt));  // t = 1 is not gated
  EXPECT_FALSE(can_sample("DS", rays, camera, bpt));
  EXPECT_TRUE(can_sample("D", rays, point, bpt));
  EXPECT_FALSE(can_sample("", rays, point, lt));
  EXPECT_TRUE(can_sample("", rays, cell, lt));
  EXPECT_TRUE(can_sample("D", rays, camera, settings(UPS_METHOD_UPS, merge | light_sample)));
  EXPECT_FALSE(is_measurable("S", rays, camera));
}

TEST(Coverage, MasksTakeTechniquesAway) {
  const TransportSettings merges = settings(UPS_METHOD_UPS, merge);
  EXPECT_FALSE(can_sample("", hittable, camera, merges));
  EXPECT_FALSE(can_sample("S", hittable, camera, merges));
  EXPECT_TRUE(can_sample("D", hittable, camera, merges));  // without next-event estimation there is no gate
  const TransportSettings gated = settings(UPS_METHOD_UPS, merge | light_sample);
  EXPECT_TRUE(can_sample("D", punctual, camera, gated));
  EXPECT_FALSE(can_sample("DS", punctual, camera, settings(UPS_METHOD_UPS, splat | join)));
}

}  // namespace
