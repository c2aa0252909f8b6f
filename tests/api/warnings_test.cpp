// What a commit tells of a scene that is no error but hardly meant, through the C API; and what it keeps silent about.
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "../support/scene_warnings.h"

namespace ups::test {
namespace {

using Profile = std::unique_ptr<ups_profile, decltype(&ups_profile_destroy)>;

// A downlight, 1000 cd at nadir; all round where `sphere`. Its opening is a rectangle; 0: a point.
Profile profile(const Scene& scene, double width, double length, bool sphere = false) {
  const float gamma[] = {0, 45, sphere ? 180.f : 90.f}, c = 0, intensity[] = {1000, 700, sphere ? 700.f : 0.f};
  auto d = make_desc<ups_profile_desc>(ups_profile_desc_init);
  d.c_count = 1, d.gamma_count = 3;
  d.c_deg = &c, d.gamma_deg = gamma, d.intensity_cd = intensity;
  if (width > 0) {
    d.opening_shape = UPS_OPENING_RECTANGLE;
    d.opening_m[0] = float(width), d.opening_m[1] = float(length);
  }
  ups_profile* out = nullptr;
  check(ups_profile_create(scene.context(), &d, &out), "ups_profile_create");
  return {out, ups_profile_destroy};
}

const P3 down{0, 0, -1}, up{0, 0, 1};
constexpr double w = 4, l = 5, h = 3;  // of the room

// A room of sheets that face inwards (or outwards), lit by luminaire 1, with a meter on a desk.
struct Room {
  Scene scene;
  Profile point, panel, strip, bulb;
  P3 at;
  Sensor meter;

  explicit Room(bool inwards = true, const P3& offset = {})
      : point(profile(scene, 0, 0)), panel(profile(scene, 0.6, 0.6)), strip(profile(scene, 1.2, 0.03)),
        bulb(profile(scene, 0, 0, true)), at(offset) {
    const Shape walls = box({0, 0, 0}, {w, l, h});
    add(inwards ? walls.flipped() : walls);
    luminaire(point, {1, 1, 2.5}, down);
    meter = scene.add_meters({P3{1.5, 1.5, 0.75} + at}, up);
  }
  void add(const Shape& shape, const ups_material_desc& material = matte(0.5)) { scene.add(shape, material, at); }
  void luminaire(const Profile& p, const P3& position, const P3& direction) {
    scene.add_luminaire(p.get(), position + at, direction, true);
  }
  std::string warnings() { return scene_warnings(scene); }
};

testing::AssertionResult tells(const std::string& text, const std::vector<std::string>& words) {
  size_t from = 0;
  for (const std::string& word : words) {
    const size_t found = text.find(word, from);
    if (found == text.npos) return testing::AssertionFailure() << "no '" << word << "' there in: '" << text << "'";
    from = found + word.size();
  }
  return testing::AssertionSuccess();
}

// ---- light that is swallowed at once ----

TEST(SwallowedLight, AHairAboveTheCeiling) {
  for (const P3& offset : {P3{}, P3{20000, -30000, 100}})
    for (const bool opening : {false, true}) {
      Room room(true, offset);
      room.luminaire(opening ? room.panel : room.point, {2, 2, h + 0.0001}, down);
      EXPECT_TRUE(tells(room.warnings(), {"luminaire 2: the light is swallowed at once: it meets the back of instance "
                                          "1 within 0.1 mm"}));
    }
}
TEST(SwallowedLight, APanelOnTopOfTheCeiling) {
  Room room;
  room.luminaire(room.panel, {2, 2, h + 0.03}, down);
  EXPECT_TRUE(tells(room.warnings(), {"luminaire 2: ", "the back of instance 1 within 30 mm"}));
}
TEST(SwallowedLight, BetweenTheCeilingAndTheSlab) {
  Room room;
  Shape above = box({0, 0, h}, {w, l, h + 0.3}).flipped();
  above.triangles.erase(above.triangles.begin(), above.triangles.begin() + 2);  // its bottom is the room's ceiling
  room.add(above);
  room.luminaire(room.panel, {2, 3, h + 0.15}, down);
  EXPECT_TRUE(tells(room.warnings(), {"luminaire 2: ", "closed space"}));
}
TEST(SwallowedLight, WithinAWall) {
  for (const double thickness : {0.05, 0.2}) {
    Room room;
    room.add(box({w, 0, 0}, {w + thickness, l, h}));
    room.luminaire(room.strip, {w + thickness / 2, 2, 1.5}, {-1, 0, 0});
    room.luminaire(room.bulb, {w + thickness / 2, 3, 1.5}, down);
    EXPECT_TRUE(tells(room.warnings(), {"luminaires 2 and 3: ", "instance 2", "closed space"}));
  }
}
TEST(SwallowedLight, WithinItsOwnHousing) {
  Room room;
  room.add(box({1.7, 1.7, 2.4}, {2.3, 2.3, 2.5}));
  room.luminaire(room.panel, {2, 2, 2.45}, down);
  room.luminaire(room.bulb, {1.9, 1.9, 2.45}, down);
  EXPECT_TRUE(tells(room.warnings(),
                    {"luminaires 2 and 3: ", "back of instance 2", "closed space of 0.6 m x 0.6 m x 0.1 m around"}));
}
TEST(SwallowedLight, FacingAWall) {
  Room room;
  room.luminaire(room.panel, {2, 0.005, 1.5}, {0, -1, 0});
  room.luminaire(room.point, {3, 0.0005, 1.5}, {0, -1, 0});
  EXPECT_TRUE(
      tells(room.warnings(), {"luminaires 2 and 3: ", "it meets instance 1 within 5 mm", "that of luminaire 2"}));
}
TEST(SwallowedLight, OfAnEmissiveSurface) {
  Room room;
  room.add(quad({2, 2, h + 0.0002}, {0, 0.3, 0}, {0.3, 0, 0}), emitter(1000));
  EXPECT_TRUE(tells(room.warnings(), {"instance 2: the light is swallowed", "back of instance 1 within 0.2 mm"}));
}
TEST(SwallowedLight, IsToldOnceForAll) {
  Room room;
  for (int i = 0; i < 20; ++i) room.luminaire(room.point, {0.1 + 0.15 * i, 2, h + 0.0001}, down);
  const std::string text = room.warnings();
  EXPECT_TRUE(tells(text, {"luminaires 2, 3, 4 and 17 more: the light is swallowed at once"}));
  EXPECT_EQ(text.find("swallowed"), text.rfind("swallowed")) << text;
}

// A box with sides that are t thick, or sheets; a square hole in the middle of its bottom.
Shape box_with_hole(const P3& low, const P3& high, double hole) {
  Shape s;
  const P3 d = high - low;
  for (const Shape& side : {quad(low + P3{0, 0, d.z}, {d.x, 0, 0}, {0, d.y, 0}), quad(low, {d.x, 0, 0}, {0, 0, d.z}),
                            quad(low + P3{0, d.y, 0}, {0, 0, d.z}, {d.x, 0, 0}), quad(low, {0, 0, d.z}, {0, d.y, 0}),
                            quad(low + P3{d.x, 0, 0}, {0, d.y, 0}, {0, 0, d.z})})
    s.append(side);
  const double a = (d.x - hole) / 2, b = (d.y - hole) / 2;
  s.append(quad(low, {0, d.y, 0}, {a, 0, 0}));
  s.append(quad(low + P3{a + hole, 0, 0}, {0, d.y, 0}, {a, 0, 0}));
  s.append(quad(low + P3{a, 0, 0}, {0, b, 0}, {hole, 0, 0}));
  s.append(quad(low + P3{a, b + hole, 0}, {0, b, 0}, {hole, 0, 0}));
  return s;
}

// Each in a room that faces inwards, as it should, and in one that was modelled inside out, with all that is in it.
struct Fine {
  const char* name;
  void (*add)(Room&, bool inwards);
};
void PrintTo(const Fine& f, std::ostream* out) { *out << f.name; }

const Fine fine[] = {
    {"FlushWithTheCeiling",
     [](Room& r, bool) {
       r.luminaire(r.panel, {2, 2, h}, down);
       r.luminaire(r.point, {3, 2, h}, down);
     }},
    {"OnAWall", [](Room& r, bool) { r.luminaire(r.strip, {2, 0.001, 2}, down); }},
    {"WallWasher", [](Room& r, bool) { r.luminaire(r.strip, {2, 0.1, 2.9}, normalize({0, -1, -0.4})); }},
    {"FacingAWallAtAFootsLength", [](Room& r, bool) { r.luminaire(r.panel, {2, 0.3, 1.5}, {0, -1, 0}); }},
    {"Cove", [](Room& r, bool) { r.luminaire(r.strip, {2, 0.05, h - 0.1}, up); }},
    {"HaloOnTheWall", [](Room& r, bool) { r.luminaire(r.point, {2, 0.02, 1.5}, {0, -1, 0}); }},
    {"RecessedInAHousing",
     [](Room& r, bool inwards) {
       const Shape can = box_with_hole({1.9, 1.9, 2.7}, {2.1, 2.1, 2.9}, 0.15);
       r.add(inwards ? can.flipped() : can);
       r.luminaire(r.point, {2, 2, 2.85}, down);
     }},
    {"BulbInALantern",
     [](Room& r, bool inwards) {
       const Shape box = box_with_hole({1.9, 1.9, 2}, {2.1, 2.1, 2.2}, 0.05);
       r.add(inwards ? box.flipped() : box);
       r.luminaire(r.bulb, {2, 2, 2.1}, down);
     }},
    {"UnderACabinetNearAWall",
     [](Room& r, bool inwards) {
       const Shape cabinet = box({1, 0, 1.5}, {3, 0.35, 2.2});
       r.add(inwards ? cabinet : cabinet.flipped());
       r.luminaire(r.strip, {2, 0.03, 1.49}, down);
     }},
    {"BeforeAPane",
     [](Room& r, bool) {
       r.add(quad({1, 1, 1.5}, {1, 0, 0}, {0, 0, 1}), material(UPS_MATERIAL_GLAZING, 0.08));
       r.luminaire(r.panel, {1.5, 1.0005, 2}, {0, -1, 0});
     }},
    {"InAGlassDome",
     [](Room& r, bool) {
       r.add(icosphere({2, 2, 2}, 0.005, 3), glass(1.5));
       r.luminaire(r.bulb, {2, 2, 2}, down);
     }},
    {"BehindADiffuser",
     [](Room& r, bool) {
       auto opal = material(UPS_MATERIAL_DIFFUSER, 0.4);
       for (float& t : opal.transmittance_rgb) t = 0.4f;
       r.add(quad({1.7, 1.7, 2.4995}, {0, 0.6, 0}, {0.6, 0, 0}), opal);
       r.luminaire(r.panel, {2, 2, 2.5}, down);
     }},
    {"EmissivePanelUnderTheCeiling",
     [](Room& r, bool) { r.add(quad({2, 2, h - 0.0002}, {0, 0.3, 0}, {0.3, 0, 0}), emitter(1000)); }},
    {"EmissiveBoxOnTheFloor", [](Room& r, bool) { r.add(box({2, 2, 0}, {2.3, 2.3, 0.3}), emitter(1000)); }},
    {"ChipInACup",
     [](Room& r, bool inwards) {
       const Shape cup = box_with_hole({1.9985, 1.9985, 2}, {2.0015, 2.0015, 2.001}, 0.0025);
       r.add(inwards ? cup.flipped() : cup);
       r.add(quad({1.9995, 1.9995, 2.0009}, {0, 0.001, 0}, {0.001, 0, 0}), emitter(1e6));
     }},
    {"ASmallRoomBeside",
     [](Room& r, bool inwards) {
       const Shape closet = box({w + 1, 0, 0}, {w + 2, 1.5, 2.3});
       r.add(inwards ? closet.flipped() : closet);
       r.luminaire(r.panel, {w + 1.5, 0.75, 2.3}, down);
     }},
    {"AnIntegratingSphereWithAMeter",
     [](Room& r, bool inwards) {
       const Shape sphere = icosphere({2, 2, 1}, 0.15, 3);
       r.add(inwards ? sphere.flipped() : sphere);
       r.luminaire(r.bulb, {2, 2, 1}, down);
       r.scene.add_meters({P3{2, 2, 0.9} + r.at}, up);
     }},
};

class FineLuminaire : public testing::TestWithParam<Fine> {};
TEST_P(FineLuminaire, HasNoWarning) {
  for (const bool inwards : {true, false})
    for (const P3& offset : {P3{}, P3{3000, -2000, 50}}) {
      Room room(inwards, offset);
      GetParam().add(room, inwards);
      EXPECT_EQ(room.warnings(), "") << (inwards ? "" : "inside out, ") << "at " << offset.x;
    }
}
INSTANTIATE_TEST_SUITE_P(SwallowedLight, FineLuminaire, testing::ValuesIn(fine),
                         [](const auto& test) { return test.param.name; });

// A fixture on the goniometer, whose scene is itself as small as a gap.
TEST(SwallowedLight, IsNotThatOfAFixtureOnAGoniometer) {
  Scene scene;
  scene.add(box_with_hole({-0.005, -0.005, 0}, {0.005, 0.005, 0.006}, 0.009), matte(0.9));
  scene.add(quad({-0.001, -0.001, 0.0055}, {0, 0.002, 0}, {0.002, 0, 0}), emitter(1e6));
  scene.add_goniometer(24, 37);
  EXPECT_EQ(scene_warnings(scene), "");
}

// ---- units ----

void add_scaled_room(Scene& scene, const Profile& p, double scale) {
  scene.add(box({0, 0, 0}, P3{w, l, h} * scale).flipped(), matte(0.5));
  scene.add_luminaire(p.get(), P3{2, 2, 2.5} * scale, down, true);
  scene.add_meters({P3{1.5, 1.5, 0.75} * scale}, up);
}

TEST(SceneWarnings, ARoomInMillimetres) {
  for (const double size : {0.0, 0.6}) {
    Scene scene;
    const Profile p = profile(scene, size, size);
    add_scaled_room(scene, p, 1000);
    EXPECT_TRUE(tells(scene_warnings(scene), {"the scene is 5 km wide", "about 0.00014 lx", "metres"}));
  }
}
TEST(SceneWarnings, ALargeSiteInMetres) {
  Scene scene;
  const Profile p = profile(scene, 0.6, 0.3);
  scene.add(quad({-3000, -3000, 0}, {6000, 0, 0}, {0, 6000, 0}), matte(0.2));
  for (int i = 0; i < 8; ++i) scene.add_luminaire(p.get(), {30.0 * i, 0, 8}, down, true);
  scene.add_meters({{10, 2, 0}}, up);
  EXPECT_EQ(scene_warnings(scene), "");
}
// Daylight alone is the same whatever the unit.
TEST(SceneWarnings, ALargeSiteInTheSun) {
  Scene scene;
  scene.add(quad({-3000, -3000, 0}, {6000, 0, 0}, {0, 6000, 0}), matte(0.2));
  scene.add_directional({0, 0.5, -1}, 50000);
  scene.add_meters({{10, 2, 0}}, up);
  EXPECT_EQ(scene_warnings(scene), "");
}

// ---- triangles ----

TEST(SceneWarnings, TrianglesWithoutArea) {
  Scene scene;
  const Profile p = profile(scene, 0, 0);
  add_scaled_room(scene, p, 1);
  Shape odd = quad({1, 1, 0.7}, {1, 0, 0}, {0, 1, 0});
  odd.vertices.push_back({1.5, 1.5, 0.7});
  odd.triangles.insert(odd.triangles.begin() + 1, {0, 4, 2});  // on the diagonal
  odd.triangles.push_back({1, 1, 3});
  scene.add(odd, matte(0.5));
  EXPECT_EQ(scene_warnings(scene), "2 triangles of mesh 2 have no area, the first triangle 1: nothing is seen of them\n");
  scene.add(Shape{{{3, 3, 1}, {3, 3, 1}, {3, 4, 1}}, {{0, 1, 2}}}, matte(0.5));
  EXPECT_EQ(scene_warnings(scene),
            "3 triangles of 2 meshes have no area, the first triangle 1 of mesh 2: nothing is seen of them\n");
}
TEST(SceneWarnings, ThinTrianglesHaveAnArea) {
  Scene scene;
  const Profile p = profile(scene, 0, 0);
  add_scaled_room(scene, p, 1);
  scene.add(quad({1, 1, 1}, {2, 0, 0}, {0, 1e-5, 0}), matte(0.5));
  EXPECT_EQ(scene_warnings(scene), "");
}

// As exported windows have it: the pane's transmittance is of what meets it.
TEST(SceneWarnings, PanesWithABlendedAlpha) {
  const auto told = [](float alpha) {
    Room room;
    auto pane = material(UPS_MATERIAL_GLAZING, 1);
    pane.alpha_mode = UPS_ALPHA_BLEND;
    pane.alpha = alpha;
    room.add(quad({1, 1, 1}, {0, 0, 1}, {1, 0, 0}), pane);
    return room.warnings();
  };
  EXPECT_TRUE(tells(told(0.25f), {"material 2", "blended alpha (0.25)", "alpha of 1"}));
  EXPECT_EQ(told(1), "");
}

// What goes through it would start beneath the floor.
TEST(SceneWarnings, ADiffuserOnTheFloor) {
  const auto told = [](double z) {
    Room room;
    auto sheet = material(UPS_MATERIAL_DIFFUSER, 0.35);
    for (float& t : sheet.transmittance_rgb) t = 0.6f;
    room.add(quad({1, 1, z}, {2, 0, 0}, {0, 2, 0}), sheet);
    return room.warnings();
  };
  for (const double z : {0.0, 2e-6})
    EXPECT_TRUE(tells(told(z), {"instance 2: it lets light through, and lies on instance 1", "move it off by"})) << z;
  EXPECT_EQ(told(0.001), "");
}

// Before: the mean of the texture's corners was taken without a word.
TEST(SceneWarnings, TexturesOfAMeshWithoutUvs) {
  const auto told = [](uint32_t side, bool uvs) {
    Room room;
    auto m = matte(1);
    m.reflectance_texture = room.scene.add_texture(side, 1, std::vector<float>(3 * side, 0.4f));
    Shape tile = quad({1, 1, 1}, {1, 0, 0}, {0, 1, 0});
    if (uvs) tile.uvs = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    room.add(tile, m);
    return room.warnings();
  };
  EXPECT_TRUE(tells(told(2, false), {"instance", "textures", "no uvs"}));
  EXPECT_EQ(told(2, true), "");
  EXPECT_EQ(told(1, false), "");
}

TEST(SceneWarnings, TransmittanceAboveThatOfAClearPane) {
  const auto told = [](double transmittance) {
    Room room;
    auto pane = material(UPS_MATERIAL_GLAZING, 1);
    pane.ior = 1.52f;
    for (float& t : pane.transmittance_rgb) t = float(transmittance);
    room.add(quad({1, 1, 1}, {0, 0, 1}, {1, 0, 0}), pane);
    return room.warnings();
  };
  const double reflectance = std::pow(0.52 / 2.52, 2), clear = (1 - reflectance) / (1 + reflectance);
  EXPECT_TRUE(tells(told(1), {"material 2", "transmittance of 1 ", "ior 1.52", "0.92 is taken"}));
  EXPECT_EQ(told(clear), "");
  EXPECT_EQ(told(-1), "");
}

// A room of rough white plastic of ior 10 returned 1.5 times the light that arrives.
TEST(SceneWarnings, RoughnessOfAnIndexBeyondItsTables) {
  const auto room = [](double ior, double roughness) {
    auto room = std::make_unique<Room>();
    auto plastic = material(UPS_MATERIAL_PLASTIC, 0.5);
    plastic.ior = float(ior), plastic.roughness = float(roughness);
    room->add(quad({1, 1, 1}, {1, 0, 0}, {0, 1, 0}), plastic);
    return room;
  };
  EXPECT_TRUE(tells(room(10, 0.5)->warnings(), {"material 2", "rough", "ior of 10", "3 is taken"}));
  EXPECT_EQ(room(3, 0.5)->warnings(), "");
  EXPECT_EQ(room(10, 0)->warnings(), "");
  const auto lx = [&](double ior) {
    const auto lit = room(ior, 0.5);
    lit->warnings();
    return lit->scene.render({.method = UPS_METHOD_PATH_TRACING, .iterations = 8}).readings(lit->meter)[0].illuminance_lx;
  };
  EXPECT_EQ(lx(10), lx(3));
}

}  // namespace
}  // namespace ups::test
