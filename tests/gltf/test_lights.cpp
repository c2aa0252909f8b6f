// Punctual lights and luminaires of files that are right: every word in the field of the C API that it names.
#include "good_file.h"

namespace {

TEST_F(GoodFile, GroupIsOfAllThatTheNodeEmits) {
  SceneBuilder builder;
  builder.doc["extensions"]["KHR_lights_punctual"]["lights"] = json::array({{{"type", "point"}}});
  builder.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}, {"extras", {{"ups", {{"group", 5}}}}}});
  builder.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
  import(builder);
  EXPECT_EQ(scene.lights[0].group, 5u);
  EXPECT_EQ(scene.lights[1].group, 0u);
}

TEST_F(GoodFile, PunctualLights) {
  SceneBuilder builder;
  builder.doc["extensions"]["KHR_lights_punctual"]["lights"] =
      json::array({{{"type", "point"}, {"intensity", 100}, {"color", {1, 0.5, 0}}},
                   {{"type", "spot"}, {"intensity", 50}, {"spot", {{"innerConeAngle", 0.2}, {"outerConeAngle", 0.4}}}},
                   {{"type", "directional"}, {"intensity", 80000}}});
  for (int i = 0; i < 3; ++i) {
    builder.add_node({{"translation", {0, 3, 0}}, {"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  }
  import(builder);
  ASSERT_EQ(scene.lights.size(), 3u);
  EXPECT_EQ(scene.lights[0].kind, UPS_LIGHT_POINT);
  EXPECT_FLOAT_EQ(scene.lights[0].intensity_rgb[0], 100);
  EXPECT_FLOAT_EQ(scene.lights[0].intensity_rgb[1], 50);
  EXPECT_FLOAT_EQ(scene.lights[0].intensity_rgb[2], 0);
  EXPECT_EQ(scene.lights[1].kind, UPS_LIGHT_SPOT);
  EXPECT_FLOAT_EQ(scene.lights[1].inner_cone_rad, 0.2f);
  EXPECT_FLOAT_EQ(scene.lights[1].outer_cone_rad, 0.4f);
  EXPECT_EQ(scene.lights[2].kind, UPS_LIGHT_DIRECTIONAL);
  EXPECT_FLOAT_EQ(scene.lights[2].intensity_rgb[2], 80000);
  expect_near(point(scene.lights[0].to_world, 0, 0, -1), {0, 1, 3});  // local -Z without rotation is north
}

// As Blender and three.js write spots with a sharp edge, and of 180 degrees.
TEST_F(GoodFile, SpotsMayHaveSharpEdges) {
  SceneBuilder builder;
  const double wide = double(float(1.57079632679489662));
  builder.doc["extensions"]["KHR_lights_punctual"]["lights"] =
      json::array({{{"type", "spot"}, {"spot", {{"innerConeAngle", 1.0471975511965976}, {"outerConeAngle", 1.0471975511965976}}}},
                   {{"type", "spot"}, {"spot", {{"innerConeAngle", 0.1}, {"outerConeAngle", wide}}}}});
  for (int i = 0; i < 2; ++i) builder.add_node({{"extensions", {{"KHR_lights_punctual", {{"light", i}}}}}});
  import(builder);
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_LT(scene.lights[0].inner_cone_rad, scene.lights[0].outer_cone_rad);
  EXPECT_FLOAT_EQ(scene.lights[0].inner_cone_rad, 1.0471976f);
  EXPECT_FLOAT_EQ(scene.lights[1].outer_cone_rad, float(wide));
}

// A room that is mirrored with all that is in it: C0 points where its mirror image does, as in the C API (before: the
// other way). The node's own scale is ignored.
TEST_F(GoodFile, WhatMirrorsMirrorsTheLight) {
  SceneBuilder builder;
  write("lamp.ies", "table");
  const json luminaire = {{"luminaire", {{"file", "lamp.ies"}}}},
             grid = {{"meters", {{"points_m", json::array({{1, 2, 0}})}, {"normals", json::array({{0, 0, 1}})}}}};
  const json up = {-0.7071067811865476, 0, 0, 0.7071067811865476};  // local +Z is world +Z
  builder.add_node({{"scale", {1, 1, -1}}, {"children", {1, 2}}});
  builder.doc["nodes"].push_back({{"rotation", up}, {"extras", {{"ups", luminaire}}}});
  builder.doc["nodes"].push_back({{"rotation", up}, {"extras", {{"ups", grid}}}});
  builder.add_node({{"rotation", up}, {"scale", {1, -1, 1}}, {"extras", {{"ups", luminaire}}}});
  import(builder);
  EXPECT_FALSE(warned("node 1")) << "nothing is ignored";
  EXPECT_TRUE(warned("its scale is ignored"));
  ASSERT_EQ(scene.luminaires.size(), 2u);
  const auto direction = [&](size_t i, double x, double y) {
    return point(scene.luminaires[i].desc.to_world, x, y, 0);
  };
  expect_near(direction(0, 1, 0), {1, 0, 0});
  expect_near(direction(0, 0, 1), {0, -1, 0});
  expect_near(direction(1, 1, 0), {1, 0, 0});
  expect_near(direction(1, 0, 1), {0, 1, 0});
  ASSERT_EQ(scene.meters.size(), 1u);
  EXPECT_NEAR(scene.meters[0].positions[0], 1, 1e-6);
  EXPECT_NEAR(scene.meters[0].positions[1], -2, 1e-6);
}

TEST_F(GoodFile, LuminairesTakeTheTiltFileBesideThem) {
  SceneBuilder builder;
  write("lamp.ies", "TILT=C:\\data\\HID.tlt");
  write("hid.TLT", "table");
  write("other.ies", "TILT=none.tlt");
  for (const json& luminaire :
       {json{{"file", "lamp.ies"}}, json{{"file", "lamp.ies"}, {"tilt_deg", 30}, {"lamp_set", 2}},
        json{{"file", "other.ies"}}})
    builder.add_node({{"extras", {{"ups", {{"luminaire", luminaire}}}}}});
  builder.add_node({{"extensions", {{"EXT_lights_ies", {{"light", 0}}}}}});
  builder.doc["extensions"]["EXT_lights_ies"]["lights"] = json::array({{{"uri", "lamp.ies"}}});
  import(builder);
  ASSERT_EQ(scene.luminaires.size(), 4u);
  EXPECT_EQ(scene.luminaires[0].profile_bytes, "TILT=C:\\data\\HID.tlt+table");
  EXPECT_EQ(scene.luminaires[1].profile_bytes, "TILT=C:\\data\\HID.tlt+table@30#2");
  EXPECT_EQ(scene.luminaires[2].profile_bytes, "TILT=none.tlt");
  EXPECT_EQ(scene.luminaires[3].profile_bytes, scene.luminaires[0].profile_bytes);
}

TEST_F(GoodFile, FilesNamedAsOthersAreFoundAreNotThose) {
  SceneBuilder builder;
  write("lamp.ies", "by uri");
  write("uri lamp.ies", "by name");
  write("EXT_lights_ies light 1", "by another name");
  const std::string text = "from view";
  const int view = builder.add_view(text.data(), text.size());
  builder.doc["extensions"]["EXT_lights_ies"]["lights"] = json::array({{{"uri", "lamp.ies"}}, {{"bufferView", view}}});
  for (const int light : {0, 1}) builder.add_node({{"extensions", {{"EXT_lights_ies", {{"light", light}}}}}});
  for (const char* file : {"uri lamp.ies", "EXT_lights_ies light 1"})
    builder.add_node({{"extras", {{"ups", {{"luminaire", {{"file", file}}}}}}}});
  import(builder);
  ASSERT_EQ(scene.luminaires.size(), 4u);
  const char* expected[] = {"by uri", "from view", "by name", "by another name"};
  for (size_t i = 0; i < 4; ++i) EXPECT_EQ(scene.luminaires[i].profile_bytes, expected[i]);
}

TEST_F(GoodFile, TheTiltFileIsFoundBesideASceneNamedWithoutItsFolder) {
  SceneBuilder builder;
  write("lamp.ies", "TILT=HID.tlt");
  write("hid.tlt", "table");
  builder.add_node({{"extras", {{"ups", {{"luminaire", {{"file", "lamp.ies"}}}}}}}});
  const std::string text = builder.gltf();
  write("scene.bin", builder.bytes);
  const std::filesystem::path given = folder, before = std::filesystem::current_path();
  std::filesystem::current_path(given);
  folder.clear();
  EXPECT_EQ(import_text(text), UPS_OK) << error;
  std::filesystem::current_path(before);
  folder = given;
  ASSERT_EQ(scene.luminaires.size(), 1u);
  EXPECT_EQ(scene.luminaires[0].profile_bytes, "TILT=HID.tlt+table");
}

// A black body's chromaticity at 1500 K is (0.5857, 0.3931), as tables of Planck's locus have it: blue is clipped.
// Where fit and law meet neither jumps; beyond, colours go on.
TEST_F(GoodFile, ColoursOfBlackBodies) {
  SceneBuilder builder;
  write("lamp.ies", "profile");
  for (const double kelvin : {1500.0, 1666.9, 1667.1, 24999.0, 25001.0, 1e6})
    builder.add_node({{"extras",
                       {{"ups", {{"luminaire", {{"file", "lamp.ies"}, {"colour_temperature_k", kelvin}}}}}}}});
  import(builder);
  ASSERT_EQ(scene.luminaires.size(), 6u);
  const auto colour = [&](size_t i) { return scene.luminaires[i].desc.color_rgb; };
  EXPECT_NEAR(colour(0)[1] / colour(0)[0], 0.4341 / 3.2641, 0.002);
  EXPECT_EQ(colour(0)[2], 0);
  for (const size_t i : {1u, 3u})
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(colour(i + 1)[k], colour(i)[k], 0.01 * double(colour(i)[k])) << i << k;
  EXPECT_GT(colour(5)[2], 1.05f * colour(4)[2]) << "bluer still";
  for (size_t i = 0; i < 6; ++i)
    EXPECT_NEAR(0.2126 * double(colour(i)[0]) + 0.7152 * double(colour(i)[1]) + 0.0722 * double(colour(i)[2]), 1, 1e-6);
}

TEST_F(GoodFile, Luminaires) {
  SceneBuilder builder;
  write("spot light.ies", "profile");
  const json all = {{"file", "spot light.ies"},
                    {"flux_lm", 900},
                    {"colour_temperature_k", 2856},
                    {"opening", false},
                    {"dimming", 0.5}};
  builder.add_node({{"translation", {0, 3, 0}}, {"rotation", upward}, {"extras", {{"ups", {{"luminaire", all}}}}}});
  builder.add_node({{"extras", {{"ups", {{"luminaire", {{"file", "spot light.ies"}}}}}}}});
  const json red = {{"file", "spot light.ies"}, {"color", {0.75, 0.25, 0}}};
  builder.add_node({{"extras", {{"ups", {{"luminaire", red}}}}}});
  import(builder);
  ASSERT_EQ(scene.luminaires.size(), 3u);
  EXPECT_EQ(scene.luminaires[2].desc.color_rgb[0], 0.75f);
  EXPECT_EQ(scene.luminaires[2].desc.color_rgb[1], 0.25f);
  EXPECT_EQ(scene.luminaires[2].desc.color_rgb[2], 0);
  EXPECT_FLOAT_EQ(scene.luminaires[2].desc.intensity_scale, 1);
  const ups_luminaire_desc& first = scene.luminaires[0].desc;
  EXPECT_EQ(scene.luminaires[0].profile_bytes, "profile");
  EXPECT_FLOAT_EQ(first.flux_lm, 900);
  EXPECT_FLOAT_EQ(first.dimming, 0.5f);
  EXPECT_FLOAT_EQ(first.intensity_scale, 1);
  EXPECT_EQ(first.use_opening, 0);
  expect_near(point(first.to_world, 0, 0, -1), {0, 0, 2});  // nadir is down
  expect_near(point(first.to_world, 1, 0, 0), {1, 0, 3});   // C0 is east
  expect_near(point(first.to_world, 0, 1, 0), {0, 1, 3});   // C90 is north
  const ups_luminaire_desc& second = scene.luminaires[1].desc;
  EXPECT_LT(second.flux_lm, 0);
  EXPECT_EQ(second.use_opening, 1);
  EXPECT_EQ(second.color_rgb[2], 1);
  EXPECT_TRUE(warned("spot light.ies: recorded warning")) << warnings();

  // CIE illuminant A is a Planckian radiator of 2856 K: x, y = 0.4476, 0.4074 (CIE 15).
  const float* c = first.color_rgb;
  const double X = 0.4124564 * c[0] + 0.3575761 * c[1] + 0.1804375 * c[2];
  const double Y = 0.2126729 * c[0] + 0.7151522 * c[1] + 0.0721750 * c[2];
  const double Z = 0.0193339 * c[0] + 0.1191920 * c[1] + 0.9503041 * c[2];
  EXPECT_NEAR(Y, 1, 1e-3);
  EXPECT_NEAR(X / (X + Y + Z), 0.4476, 2e-3);
  EXPECT_NEAR(Y / (X + Y + Z), 0.4074, 2e-3);
}

TEST_F(GoodFile, IesExtension) {
  SceneBuilder builder;
  write("lamp.ies", "from file");
  const std::string text = "from view";
  const int view = builder.add_view(text.data(), text.size());
  builder.doc["extensionsRequired"] = {"EXT_lights_ies"};
  builder.doc["extensions"]["EXT_lights_ies"]["lights"] =
      json::array({{{"uri", "lamp.ies"}},
                   {{"bufferView", view}, {"mimeType", "application/x-ies-lm-63"}},
                   {{"uri", "data:application/x-ies-lm-63;base64,ZnJvbSB1cmk="}}});
  const auto node = [&](const json& use) { builder.add_node({{"extensions", {{"EXT_lights_ies", use}}}}); };
  node({{"light", 0}, {"multiplier", 2}, {"color", {1, 0.5, 0.25}}});
  node({{"light", 1}, {"color", {3, 1, 0.5}}});  // which the extension clamps
  node({{"light", 2}, {"color", {0, 0, 0}}});
  import(builder);
  ASSERT_EQ(scene.luminaires.size(), 3u);
  EXPECT_EQ(scene.luminaires[0].profile_bytes, "from file");
  EXPECT_EQ(scene.luminaires[1].profile_bytes, "from view");
  EXPECT_EQ(scene.luminaires[2].profile_bytes, "from uri");
  const ups_luminaire_desc& d = scene.luminaires[0].desc;
  const float y = 0.2126f * d.color_rgb[0] + 0.7152f * d.color_rgb[1] + 0.0722f * d.color_rgb[2];
  EXPECT_EQ(d.use_opening, 0);
  for (int i = 0; i < 3; ++i) {  // what the core makes of it: scale * color / luminance(color)
    EXPECT_NEAR(d.intensity_scale * d.color_rgb[i] / y, std::vector<double>({2, 1, 0.5})[size_t(i)], 1e-5);
  }
  const ups_luminaire_desc& clamped = scene.luminaires[1].desc;
  EXPECT_EQ(clamped.color_rgb[0], 1);
  EXPECT_EQ(clamped.color_rgb[2], 0.5f);
  EXPECT_TRUE(warned("color is more than 1")) << warnings();
  EXPECT_EQ(scene.luminaires[2].desc.intensity_scale, 0);
}

}  // namespace
