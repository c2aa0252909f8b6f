// What a commit builds: the origin, which side emits, meters and luminaires on surfaces, media, and what is complete.
#include <gtest/gtest.h>

#include "things.h"

namespace ups {
namespace {

// A quarter of the power of two above the scene's extent, 4 m, is the grid that it lies on.
TEST(Prepare, OriginIsNearTheCentre) {
  Things t;
  t.box(t.material(UPS_MATERIAL_MATTE), {5e5, 1e5, 0}, {5e5 + 10, 1e5 + 6, 3});
  t.meter({5e5 + 1, 1e5 + 1, 0.8}, {0, 0, 1});
  t.point_light({5e5 + 5, 1e5 + 3, 5});  // above the box
  const auto s = t.build();
  EXPECT_EQ(s->extent, 16);
  EXPECT_EQ(s->origin.x, 5e5 + 4);
  EXPECT_EQ(s->origin.y, 1e5 + 4);
  EXPECT_EQ(s->origin.z, 4);
  EXPECT_LT(length(s->centre - Vec3(1, -1, -1.5f)), 1e-6f);
  EXPECT_NEAR(s->radius, std::sqrt(25 + 9 + 6.25), 1e-4);
  EXPECT_LT(length(s->meter_sets[0].meters[0].p - Vec3(-3, -3, -3.2f)), 1e-6f);
  EXPECT_LT(length(s->raytracer->bounds_min() - Vec3(-4, -4, -4)), 1e-6f);
  EXPECT_EQ(s->emitters.size(), 1u);
  EXPECT_EQ(s->meter_set_ids[0], 1u);
}

// Wherever the vertices lie that no triangle has: of a mesh that two instances show, and of one that is alone.
TEST(Prepare, BoundsAreOfTheTriangles) {
  Things t;
  const float p[15] = {3e38f, 0, 0, 0, 0, 1, 1, 0, 1, 0, 1, 1, 0, 0, 40};
  const uint32_t i[3] = {1, 2, 3};
  ups_mesh_desc m{};
  m.vertex_count = 5, m.triangle_count = 1;
  m.material.v = t.material(UPS_MATERIAL_MATTE, 10);
  m.positions_m = p, m.indices = i;
  const ups_mesh_id shared = t.description.add_mesh(m), alone = t.description.add_mesh(m);
  const auto add = [&](ups_mesh_id mesh, double scale, double x) {
    ups_instance_desc d{};
    d.mesh = mesh;
    d.to_world[0] = d.to_world[5] = d.to_world[10] = scale, d.to_world[3] = x;
    t.description.add_instance(d);
  };
  add(shared, 1, 0), add(shared, 1, 2), add(alone, 2, 4);
  const auto s = t.build();
  const auto expect = [](const Vec3d& found, const Vec3d& expected) { EXPECT_LT(length(found - expected), 1e-4); };
  EXPECT_EQ(s->extent, 8);
  expect(Vec3d(s->raytracer->bounds_min()) + s->origin, {0, 0, 1});
  expect(Vec3d(s->raytracer->bounds_max()) + s->origin, {6, 2, 2});
  ASSERT_EQ(s->sources.size(), 3u);
  expect(s->sources[0].bounds_min, {0, 0, 1}), expect(s->sources[0].bounds_max, {1, 1, 1});
  expect(s->sources[2].bounds_min, {4, 0, 2}), expect(s->sources[2].bounds_max, {6, 2, 2});
}

TEST(Prepare, EmissionLeavesTheFrontOfMirroredBoxesToo) {
  for (const bool mirrored : {false, true}) {
    Things t;
    t.box(t.material(UPS_MATERIAL_MATTE, 10), {-1, -1, -1}, {1, 1, 1}, mirrored);
    const auto s = t.build();
    ASSERT_EQ(s->emitters.size(), 1u);
    EXPECT_EQ(s->emitter_of_instance[0], 0u);
    EXPECT_NEAR(s->emitters.flux_lm(), 3.14159265 * 10 * 24, 1e-2);
    for (int i = 0; i < 50; ++i) {
      EmissionSample e;
      ASSERT_TRUE(s->emitters[0].sample_emission({(float(i) + 0.5f) / 50, 0.4f}, {0.3f, 0.6f}, e));
      EXPECT_GT(dot(e.n, e.p), 0) << "inwards";
      EXPECT_GT(dot(e.direction, e.n), 0);
      // The emitter's triangles are the ray tracer's: the same front.
      EXPECT_LT(length(s->raytracer->surface_at(0, e.primitive, 0.3f, 0.3f).ng - e.n), 1e-5f);
    }
  }
}

TEST(Prepare, MetersOnSurfacesStandOnTheirNormalsSide) {
  Things t;
  const uint32_t matte = t.material(UPS_MATERIAL_MATTE);
  t.box(matte, {0.1, 0.1, 0.3}, {40.1, 30.1, 3.3});
  t.point_light({20, 20, 2});
  for (const double step : {-3e-7, 0.0, 3e-7})
    for (const float up : {1.0f, -1.0f}) {
      t.meter({17.3, 11.7, 0.3 + step}, {0, 0, up});
      t.meter({17.3, 11.7, 3.3 + step}, {0, 0, up});
    }
  t.meter({17.3, 11.7, 1}, {0, 0, 1});
  const auto s = t.build();
  for (const MeterSet& set : s->meter_sets) {
    const Meter& m = set.meters[0];
    const Vec3 start = m.p + m.frame.n * (2 * m.error);
    Hit hit;
    // Back through itself a ray must find the surface at once; ahead and at a grazing angle it must not.
    const bool free_standing = std::abs(m.p.z - float(1 - s->origin.z)) < 0.1f;
    EXPECT_EQ(s->raytracer->intersect(start, -m.frame.n, 1e-3f, hit), !free_standing);
    EXPECT_FALSE(s->raytracer->intersect(start, m.frame.n, 1e-3f, hit));
    EXPECT_FALSE(s->raytracer->intersect(start, normalize(m.frame.s + m.frame.n * 1e-4f), 1, hit));
    EXPECT_LT(m.error, 3e-4f);
  }
}

TEST(Prepare, LuminairesScaleAndPlace) {
  Things t;
  t.box(t.material(UPS_MATERIAL_MATTE), {0, 0, 0}, {8, 6, 3});
  t.downlight({2, 3, 3}, {photometry::OpeningShape::rectangle, {0.6f, 0.3f, 0}}, 1000);  // flush with the ceiling
  t.downlight({5, 3, 3}, {}, -1);
  t.downlight({6, 3, 2}, {photometry::OpeningShape::box, {0.6f, 0.3f, 0.1f}}, 0);  // 0 lm: left out
  t.downlight({6, 3, 2}, {photometry::OpeningShape::box, {0.6f, 0.3f, 0.1f}}, 10);
  const auto s = t.build();
  ASSERT_EQ(s->emitters.size(), 3u);
  EXPECT_EQ(s->luminaire_count, 4u);
  EXPECT_EQ(s->emitters[0].kind(), EmitterKind::profile_opening);
  EXPECT_EQ(s->emitters[1].kind(), EmitterKind::profile_point);
  const photometry::Distribution d({0}, {0, 90}, {100, 0});
  const double band_to_true = d.interpolated_flux_lm() / d.band_flux_lm();
  EXPECT_NEAR(s->emitters[0].flux_lm(), 400 * band_to_true, 1e-3 * 400);
  EXPECT_NEAR(s->emitters[1].flux_lm(), 0.4 * d.interpolated_flux_lm(), 1e-3 * d.band_flux_lm());
  const Rgb flux = s->emitters[0].flux_rgb();
  EXPECT_NEAR(flux.r / flux.g, 2, 1e-5f);
  EXPECT_NEAR(luminance(flux), s->emitters[0].flux_lm(), 1e-2);
  EXPECT_TRUE(s->effects.coloured);

  // Discs stand for openings, in front of the ceiling; a ball for the box's.
  ASSERT_EQ(s->emitter_of_opening, (std::vector<uint32_t>{0, 2}));
  std::vector<DiscIndex::Crossing> crossings;
  const Vec3 o = Vec3(Vec3d(2, 3, 0.5) - s->origin);
  Hit hit;
  ASSERT_TRUE(s->raytracer->intersect(o, {0, 0, 1}, INFINITY, hit));
  s->openings->intersect_all(o, {0, 0, 1}, hit.t, crossings);
  ASSERT_EQ(crossings.size(), 1u);
  EXPECT_EQ(crossings[0].disc, 0u);
  EXPECT_NEAR(s->openings->disc(0).radius, 0.5f * std::hypot(0.6f, 0.3f), 1e-5f);
  EXPECT_EQ(s->openings->disc(0).normal.z, -1);
  EXPECT_EQ(length(s->openings->disc(1).normal), 0);
  EXPECT_NEAR(s->openings->disc(1).radius, 0.5f * std::sqrt(0.36f + 0.09f + 0.01f), 1e-5f);
  ASSERT_EQ(s->warnings.size(), 1u);
  EXPECT_NE(s->warnings[0].find("nothing to measure"), std::string::npos) << s->warnings[0];

  // The point in the ceiling shines down into the room.
  DirectSample direct;
  const Vec3 floor = Vec3(Vec3d(5.5, 3, 0.1) - s->origin);
  ASSERT_TRUE(s->emitters[1].sample_direct(floor, {0.5f, 0.5f}, direct));
  EXPECT_FALSE(s->raytracer->occluded(direct.p, -direct.wi, direct.distance));
}

// A thousand luminaires of one type: none has tables of its own, whoever holds them.
TEST(Prepare, LuminairesShareTheirProfile) {
  constexpr int count = 1000;
  Things t;
  t.box(t.material(UPS_MATERIAL_MATTE), {0, 0, 0}, {100, 40, 3});
  photometry::Photometry data{photometry::Distribution({0}, {0, 90}, {100, 0})};
  data.opening = {photometry::OpeningShape::box, {1.2f, 0.3f, 0.1f}};
  data.warnings = {"odd"};
  const auto profile = std::make_shared<photometry::Photometry>(std::move(data));
  for (int i = 0; i < count; ++i) {
    ups_luminaire_desc d{};
    const double place[12] = {1, 0, 0, 2.0 * (i % 50) + 1, 0, 1, 0, 2.0 * (i / 50) + 1, 0, 0, 1, 2.9};
    std::copy(std::begin(place), std::end(place), d.to_world);
    d.use_opening = 1, d.flux_lm = -1, d.dimming = d.intensity_scale = 1;
    std::fill(std::begin(d.color_rgb), std::end(d.color_rgb), 1.0f);
    t.description.add_luminaire(d, profile);
  }
  EXPECT_EQ(profile.use_count(), 1 + count);
  const auto s = t.build();
  EXPECT_EQ(s->emitters.size(), size_t(count));
  EXPECT_EQ(s->emitter_of_opening.size(), size_t(count));
  EXPECT_EQ(profile.use_count(), 1 + 3 * count);  // the emitters hold the same one, and the list of what emits
  const auto odd = std::count_if(s->warnings.begin(), s->warnings.end(),
                                 [](const std::string& w) { return w.find("odd") != w.npos; });
  EXPECT_EQ(odd, 1) << "a profile's warnings are told once";
}

TEST(Prepare, RefusesMoreLightThanAFloatHolds) {
  for (const float green : {1.0f, 0.0f})  // of an infinity a share of zero is no number
    for (const float scale : {1e15f, 1e20f}) {
      Things t;
      ups_luminaire_desc d{};
      const double place[12] = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 2};
      std::copy(std::begin(place), std::end(place), d.to_world);
      d.flux_lm = -1, d.dimming = d.intensity_scale = scale;
      d.color_rgb[0] = 1, d.color_rgb[1] = d.color_rgb[2] = green;
      t.description.add_luminaire(d, std::make_shared<photometry::Photometry>(
                                         photometry::Photometry{photometry::Distribution({0}, {0, 90}, {100, 0})}));
      try {
        t.build();
        ADD_FAILURE() << green << " " << scale;
      } catch (const Error& e) {
        EXPECT_EQ(e.status(), UPS_ERROR_INVALID_ARGUMENT);
        EXPECT_NE(std::string(e.what()).find("luminaire 1: emits more than 1e20 lm"), std::string::npos) << e.what();
      }
    }
}

TEST(Prepare, FindsTheGlassThatThingsLieIn) {
  Things t;
  const uint32_t matte = t.material(UPS_MATERIAL_MATTE), water = t.material(UPS_MATERIAL_GLASS, 0, 0.3f);
  t.box(matte, {-10, -10, -10}, {10, 10, 10});
  t.box(water, {-1, -1, -1}, {1, 1, 1});
  t.box(matte, {-0.5, -0.5, 0.5}, {0.5, 0.5, 0.6});  // a lid within the water, above the meter
  t.meter({0, 0, 0}, {0, 0, 1});
  t.meter({3, 0, 0}, {0, 0, 1});
  t.meter({0, 0, -2}, {0, 0, 1});  // below the water: sees it from outside
  t.point_light({0.2, 0.1, 0.8});
  const auto s = t.build();
  const auto material = [&](uint32_t stack) {
    const uint32_t top = s->media_stacks[stack].top();
    return top == none ? none : s->media.by_rank[top].material;
  };
  EXPECT_FALSE(s->media.nest);
  EXPECT_EQ(material(s->media_of_meter[0][0]), water - 1);
  EXPECT_EQ(material(s->media_of_meter[1][0]), none);
  EXPECT_EQ(material(s->media_of_meter[2][0]), none);
  EXPECT_EQ(material(s->media_of_emitter[0]), water - 1);
  EXPECT_TRUE(s->effects.transmits_solid);
  EXPECT_FALSE(s->effects.path_tracing_complete) << "a point light and smooth water";
  EXPECT_TRUE(s->effects.sharp_caster);
}

// Set back by what rays need, and no further as builds go on; where it would end up behind a board it stays.
TEST(Prepare, SetsEmittersBackFromGlassThatTheyTouch) {
  const auto build = [](bool board, bool apart, bool glass, const std::shared_ptr<const Snapshot>& earlier) {
    Things t;
    t.box(t.material(UPS_MATERIAL_MATTE, 100), {0, 0, 1}, {1, 1, 2});
    if (glass) t.box(t.material(UPS_MATERIAL_GLASS), {-1, -1, 0}, {2, 2, apart ? 0.99 : 1});
    if (board) t.box(t.material(UPS_MATERIAL_MATTE), {-1, -1, 1}, {3, 3, 1.5});
    t.meter({0.5, 0.5, -1}, {0, 0, 1});
    ThreadPool pool(2);
    return prepare(t.description, pool, earlier);
  };
  const auto height = [](const auto& s) { return s->instances[0].to_scene.m[11] + s->origin.z; };
  const auto touching = build(false, false, true, nullptr), alone = build(false, false, false, nullptr);
  const double set_back = height(touching);
  EXPECT_GT(set_back, 1 + 5e-6);
  EXPECT_LT(set_back, 1 + 1e-4);
  const auto again = build(false, false, true, touching), apart = build(false, true, true, touching),
             behind = build(true, false, true, touching), cleared = build(false, false, true, behind);
  EXPECT_EQ(height(again), set_back);
  EXPECT_EQ(height(apart), height(alone));
  EXPECT_LT(height(behind), 1 + 1e-6);
  EXPECT_EQ(height(cleared), set_back);
  EXPECT_NE(behind->warnings.at(0).find("no room to be set back"), std::string::npos);
  const auto still_behind = build(true, false, true, behind);
  EXPECT_EQ(height(still_behind), height(behind));
  EXPECT_EQ(still_behind->warnings, behind->warnings);
}

TEST(Prepare, PathTracingIsCompleteWithoutDeltaSurfacesOrWithoutDeltaEmitters) {
  Things diffuse;
  diffuse.box(diffuse.material(UPS_MATERIAL_MATTE), {-1, -1, -1}, {1, 1, 1});
  diffuse.point_light({0, 0, 0});
  EXPECT_TRUE(diffuse.build()->effects.path_tracing_complete);
  EXPECT_FALSE(diffuse.build()->effects.sharp_caster);
  Things area;
  area.box(area.material(UPS_MATERIAL_MIRROR), {-1, -1, -1}, {1, 1, 1});
  area.box(area.material(UPS_MATERIAL_MATTE, 5), {-0.1, -0.1, -0.1}, {0.1, 0.1, 0.1});
  EXPECT_TRUE(area.build()->effects.path_tracing_complete);
  EXPECT_TRUE(area.build()->effects.sharp_caster);
}

// The integral of E^2 dA times 4 pi D^2 / flux^2; in this box light goes D^2 = 2.5 m^2 in the mean from wall to wall.
TEST(Prepare, TellsHowSmallThePatchesAreThatLightMeetsFirst) {
  Things even;
  even.box(even.material(UPS_MATERIAL_MATTE), {-1, -1, -1}, {1, 1, 1});
  even.point_light({0, 0, 0});
  double face = 0;  // of a cube around the light, E = (1 + x^2 + y^2)^(-3/2)
  for (int i = 0; i < 200; ++i)
    for (int k = 0; k < 200; ++k)
      face += 1e-4 / std::pow(1 + std::pow(i / 100.0 - 0.995, 2) + std::pow(k / 100.0 - 0.995, 2), 3);
  const double bounds = 4 * pi * 2.5, flux2 = 16 * pi * pi;
  EXPECT_NEAR(even.build()->effects.concentration, bounds * 6 * face / flux2, 0.5);  // 256 rays: a fifth or two
  Things near_a_wall;
  const double h = 0.01;  // E = h / (h^2 + r^2)^(3/2) on the wall, integral of E^2 dA = pi / (2 h^2)
  near_a_wall.box(near_a_wall.material(UPS_MATERIAL_MATTE), {-1, -1, -1}, {1, 1, 1});
  near_a_wall.point_light({0, 0, 1 - h});
  const double expected = bounds * pi / (2 * h * h) / flux2;
  // Discs as large as the patch blur it a little.
  EXPECT_GT(near_a_wall.build()->effects.concentration, 0.6 * expected);
  EXPECT_LT(near_a_wall.build()->effects.concentration, 1.5 * expected);
}

// Of 3000 lamps every third is looked at, and the one that has nearly all the flux, wherever it stands among them.
TEST(Prepare, TellsOfTheSmallPatchThatOneOfThousandsMakes) {
  for (const int strong : {0, 1001}) {
    Things things;
    things.box(things.material(UPS_MATERIAL_MATTE), {-1, -1, -1}, {1, 1, 1});
    for (int i = 0; i < 3000; ++i)
      if (i == strong) things.point_light({0, 0, 0.99}, 1e6);
      else things.point_light({0, 0, 0}, 1);
    EXPECT_GT(things.build()->effects.concentration, 1000) << strong;
  }
}

}  // namespace
}  // namespace ups
