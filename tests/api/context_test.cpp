// Version, status names, messages, sizes of structs, the log, and the life of handles.
#include <cmath>
#include <cstring>
#include <thread>

#include "fixture.h"

namespace ups_test {
namespace {

TEST(Base, VersionAndStatusNames) {
  EXPECT_EQ(ups_version(), uint32_t(UPS_VERSION_MAJOR * 10000 + UPS_VERSION_MINOR * 100 + UPS_VERSION_PATCH));
  EXPECT_STREQ(ups_status_name(UPS_ERROR_PARSE), "UPS_ERROR_PARSE");
  EXPECT_STREQ(ups_status_name(UPS_CANCELLED), "UPS_CANCELLED");
  EXPECT_NE(ups_status_name(12345), nullptr);
}

TEST(Base, MessagesBelongToTheirThread) {
  std::thread([] { EXPECT_STREQ(ups_last_error(), ""); }).join();
  expect_error(ups_context_create(nullptr, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"ups_context_create", "out is NULL"});
  const std::string mine = ups_last_error();
  std::thread([] {
    expect_error(ups_scene_create(nullptr, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"ups_scene_create"});
  }).join();
  EXPECT_EQ(mine, ups_last_error());
  EXPECT_GT(ups_version(), 0u);
  EXPECT_EQ(mine, ups_last_error()) << "a call that succeeds must leave the message";
}

TEST(Base, ThreadCount) {
  for (const int32_t bad : {-1, 1025}) {
    auto d = make(&ups_context_desc_init);
    d.thread_count = bad;
    ups_context* context = nullptr;
    expect_error(ups_context_create(&d, &context), UPS_ERROR_INVALID_ARGUMENT,
                 {"thread_count", std::to_string(bad), "1024"});
    EXPECT_EQ(context, nullptr);
  }
  ups_context* context = nullptr;
  ASSERT_EQ(ups_context_create(nullptr, &context), UPS_OK);
  int32_t count = 0;
  EXPECT_EQ(ups_context_get_thread_count(context, &count), UPS_OK);
  EXPECT_GE(count, 1);
  EXPECT_EQ(ups_context_get_thread_count(context, nullptr), UPS_ERROR_INVALID_ARGUMENT);
  ups_context_destroy(context);
  ups_context_destroy(nullptr);
}

// ---- struct_size ----

TEST(StructSize, InitWritesNoMoreThanItIsTold) {
  unsigned char bytes[sizeof(ups_material_desc)];
  std::memset(bytes, 0xcd, sizeof bytes);
  auto* d = reinterpret_cast<ups_material_desc*>(bytes);
  ups_material_desc_init(d, 16);
  EXPECT_EQ(d->struct_size, 16u);
  EXPECT_EQ(d->reflectance_rgb[0], 0.5f);
  for (size_t i = 16; i < sizeof bytes; ++i) ASSERT_EQ(bytes[i], 0xcd) << i;
  ups_material_desc_init(nullptr, 16);
  std::memset(bytes, 0xcd, sizeof bytes);
  ups_material_desc_init(d, 2);
  EXPECT_EQ(bytes[0], 0xcd);
}

TEST_F(Api, ShorterStructsTakeDefaultsForTheRest) {
  // A caller whose material ends after the reflectance; what follows in memory is poison.
  auto d = make(&ups_material_desc_init);
  std::memset(reinterpret_cast<char*>(&d) + 24, 0xff, sizeof d - 24);
  d.struct_size = 24;
  ups_material_id id{};
  EXPECT_OK(ups_scene_add_material(scene, &d, &id));
  EXPECT_GT(id.v, material.v);
  d.struct_size = sizeof d;
  EXPECT_EQ(ups_scene_add_material(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT);
}

// Half of a pointer would be read as one.
TEST_F(Api, AStructMayNotEndInsideAPointer) {
  auto luminaire = make(&ups_luminaire_desc_init);
  luminaire.struct_size = 12;
  ups_luminaire_id id{};
  expect_error(ups_scene_add_luminaire(scene, &luminaire, &id), UPS_ERROR_INVALID_ARGUMENT,
               {"struct_size is 12", "a multiple of 8"});
  auto mesh = make(&ups_mesh_desc_init);
  mesh.struct_size = 20;
  ups_mesh_id mesh_id{};
  expect_error(ups_scene_add_mesh(scene, &mesh, &mesh_id), UPS_ERROR_INVALID_ARGUMENT, {"struct_size is 20"});
}

TEST_F(Api, FieldsOfALaterVersionMustBeZero) {
  struct {
    ups_material_desc desc;
    char future[64];
  } longer;
  std::memset(&longer, 0xff, sizeof longer);
  ups_material_desc_init(&longer.desc, uint32_t(sizeof longer));  // leaves 0 in what it does not know
  EXPECT_EQ(longer.desc.struct_size, sizeof longer);
  ups_material_id id{}, none{};
  EXPECT_OK(ups_scene_add_material(scene, &longer.desc, &id));
  EXPECT_EQ(id.v, material.v + 1);
  for (const size_t at : {size_t(0), size_t(10), sizeof longer.future - 1}) {
    longer.future[at] = 1;
    expect_error(ups_scene_add_material(scene, &longer.desc, &none), UPS_ERROR_UNSUPPORTED,
                 {"struct_size is " + std::to_string(sizeof longer), std::to_string(sizeof longer.desc) + " bytes",
                  "byte " + std::to_string(sizeof longer.desc + at)});
    longer.future[at] = 0;
  }
  EXPECT_EQ(none.v, 0u);
  longer.future[3] = 1;  // a desc within a desc
  auto part = make(&ups_fixture_part_desc_init);
  part.finish = UPS_FINISH_CUSTOM, part.material = &longer.desc;
  ups_fixture* fixture = nullptr;
  ASSERT_EQ(ups_fixture_create(context, &fixture), UPS_OK);
  expect_error(ups_fixture_add_part(fixture, &part, nullptr), UPS_ERROR_UNSUPPORTED, {"material->struct_size"});
  ups_fixture_destroy(fixture);
}

TEST_F(Api, FieldsOfALaterVersionAreReadAsZero) {
  struct {
    ups_material_desc desc;
    char future[64];
  } longer;
  std::memset(&longer, 0xff, sizeof longer);
  longer.desc.struct_size = sizeof longer;
  ASSERT_EQ(ups_scene_get_material(scene, material, &longer.desc), UPS_OK);
  EXPECT_EQ(longer.desc.struct_size, sizeof longer);
  for (const char byte : longer.future) ASSERT_EQ(byte, 0);
  EXPECT_OK(ups_scene_set_material(scene, material, &longer.desc));  // so it can be handed back
}

TEST_F(Api, SizesThatCannotBeAreErrors) {
  for (const uint32_t size : {0u, 4u, 21u, 4100u, 0xcdcdcdccu}) {
    auto d = make(&ups_material_desc_init);
    d.struct_size = size;
    ups_material_id id{};
    expect_error(ups_scene_add_material(scene, &d, &id), UPS_ERROR_INVALID_ARGUMENT,
                 {"struct_size", std::to_string(size)});
    EXPECT_EQ(id.v, 0u);
  }
}

TEST_F(Api, InfosWriteNoMoreThanTheyAreTold) {
  ups_profile_info info;
  std::memset(&info, 0xcd, sizeof info);
  info.struct_size = 16;
  EXPECT_OK(ups_profile_get_info(profile, &info));
  EXPECT_EQ(info.struct_size, 16u);
  EXPECT_NEAR(info.flux_lm, 4 * 3.14159265, 1e-6);
  const auto* bytes = reinterpret_cast<const unsigned char*>(&info);
  for (size_t i = 16; i < sizeof info; ++i) ASSERT_EQ(bytes[i], 0xcd) << i;
  info.struct_size = 0;
  expect_error(ups_profile_get_info(profile, &info), UPS_ERROR_INVALID_ARGUMENT, {"info", "struct_size"});
}

// ---- log ----

TEST_F(Api, LogHandsOutWholeMessagesOldestFirst) {
  size_t needed = 99;
  while (true) {  // whatever is there from before
    char drain[4096];
    ASSERT_EQ(ups_context_pop_log(context, drain, sizeof drain, &needed, nullptr), UPS_OK);
    if (needed == 0) break;
  }
  EXPECT_OK(ups_scene_commit(scene));  // without emitters and sensors: two warnings
  ASSERT_EQ(ups_context_pop_log(context, nullptr, 0, &needed, nullptr), UPS_OK);
  ASSERT_GT(needed, 10u);
  std::string text(needed, '?');
  size_t again = 0;
  expect_error(ups_context_pop_log(context, text.data(), needed - 1, &again, nullptr), UPS_ERROR_BUFFER_TOO_SMALL,
               {"capacity"});
  EXPECT_EQ(again, needed);
  ups_log_level level = -1;
  ASSERT_EQ(ups_context_pop_log(context, text.data(), text.size(), &needed, &level), UPS_OK);
  EXPECT_EQ(level, UPS_LOG_WARNING);
  EXPECT_NE(text.find("nothing in the scene emits light"), std::string::npos) << text;
  text.assign(4096, '?');
  ASSERT_EQ(ups_context_pop_log(context, text.data(), text.size(), &needed, &level), UPS_OK);
  EXPECT_NE(text.find("nothing to measure"), std::string::npos) << text;
  ASSERT_EQ(ups_context_pop_log(context, text.data(), text.size(), &needed, &level), UPS_OK);
  EXPECT_EQ(needed, 0u);
  EXPECT_EQ(ups_context_pop_log(context, nullptr, 5, &needed, nullptr), UPS_ERROR_INVALID_ARGUMENT);
}

// ---- lifetimes ----

TEST_F(Api, ParentsMayGoFirst) {
  auto d = make(&ups_luminaire_desc_init);
  d.profile = profile;
  ups_luminaire_id id{};
  EXPECT_OK(ups_scene_add_luminaire(scene, &d, &id));
  ups_context_destroy(context);
  context = nullptr;
  float up[3] = {0, 0, 1}, value = 0;
  EXPECT_OK(ups_profile_eval(profile, up, 1, &value));
  EXPECT_EQ(value, 1);
  ups_profile_destroy(profile);
  profile = nullptr;
  EXPECT_OK(ups_scene_commit(scene));
  ups_scene_info info{};
  info.struct_size = sizeof info;
  EXPECT_OK(ups_scene_get_info(scene, &info));
  EXPECT_NEAR(info.emitted_flux_lm, 4 * 3.14159265, 1e-4);
  ups_scene_destroy(scene);
  scene = nullptr;
  ups_scene_destroy(nullptr);
  ups_profile_destroy(nullptr);
}

// ---- profiles ----

TEST_F(Api, ProfileFromATable) {
  ups_profile_info info{};
  info.struct_size = sizeof info;
  EXPECT_OK(ups_profile_get_info(profile, &info));
  EXPECT_NEAR(info.interpolated_flux_lm, 4 * 3.14159265, 1e-6);
  EXPECT_EQ(info.peak_cd, 1);
  EXPECT_LT(info.rated_flux_lm, 0);
  EXPECT_LT(info.input_power_w, 0);
  EXPECT_EQ(info.opening_shape, UPS_OPENING_POINT);
  EXPECT_EQ(info.symmetry, UPS_SYMMETRY_AXIAL);
  char text[16];
  size_t needed = 0;
  EXPECT_OK(ups_profile_get_text(profile, UPS_PROFILE_TEXT_FORMAT, text, sizeof text, &needed));
  EXPECT_STREQ(text, "table");
  expect_error(ups_profile_get_text(profile, 8, text, sizeof text, &needed), UPS_ERROR_INVALID_ARGUMENT,
               {"topic is 8"});
}

TEST_F(Api, ProfileErrorsNameTheirField) {
  const auto expect = [&](ups_profile_desc d, const std::vector<std::string>& words) {
    ups_profile* out = nullptr;
    expect_error(ups_profile_create(context, &d, &out), UPS_ERROR_INVALID_ARGUMENT, words);
    EXPECT_EQ(out, nullptr);
  };
  auto d = uniform_profile();
  d.c_count = 0, expect(d, {"c_count", "at least 1"});
  d = uniform_profile(), d.gamma_count = 1, expect(d, {"gamma_count", "at least 2"});
  d = uniform_profile(), d.gamma_count = 5'000'000, expect(d, {"gamma_count", "4000000"});
  d = uniform_profile(), d.c_count = 0xffffffff, d.gamma_count = 0xffffffff, expect(d, {"c_count"});
  d = uniform_profile(), d.reserved = 1, expect(d, {"reserved"});
  d = uniform_profile(), d.c_deg = nullptr, expect(d, {"c_deg is NULL"});
  d = uniform_profile(), d.gamma_deg = nullptr, expect(d, {"gamma_deg is NULL"});
  d = uniform_profile(), d.intensity_cd = nullptr, expect(d, {"intensity_cd is NULL"});
  intensity_cd[1] = -1, expect(uniform_profile(), {"intensity_cd[1]"});
  intensity_cd[1] = NAN, expect(uniform_profile(), {"intensity_cd[1]"});
  intensity_cd[1] = 1, gamma_deg[1] = 181, expect(uniform_profile(), {"gamma_deg[1]", "181"});
  gamma_deg[1] = 0, expect(uniform_profile(), {"gamma_deg[1]"});
  gamma_deg[1] = 180, c_deg[1] = 360;
  d = uniform_profile(), d.c_count = 2, expect(d, {"c_deg[1]"});
}

TEST_F(Api, ProfileParseErrors) {
  ups_profile* out = nullptr;
  const char text[] = "IESNA:LM-63-2002\nTILT=NONE\nnot a number\n";
  expect_error(ups_profile_parse(context, text, sizeof text - 1, UPS_PROFILE_AUTO, &out), UPS_ERROR_PARSE, {"line 3"});
  expect_error(ups_profile_parse(context, text, sizeof text - 1, UPS_PROFILE_EULUMDAT, &out), UPS_ERROR_PARSE,
               {"line 3", "Isym"});
  expect_error(ups_profile_parse(context, text, sizeof text - 1, 9, &out), UPS_ERROR_INVALID_ARGUMENT, {"format is 9"});
  expect_error(ups_profile_parse(context, nullptr, 5, UPS_PROFILE_AUTO, &out), UPS_ERROR_INVALID_ARGUMENT,
               {"bytes is NULL"});
  for (const char* nothing : {"", static_cast<const char*>(nullptr)})
    expect_error(ups_profile_parse(context, nothing, 0, UPS_PROFILE_AUTO, &out), UPS_ERROR_PARSE, {"file ends"});
  EXPECT_EQ(out, nullptr);
}

TEST_F(Api, ProfileEvalChecksDirections) {
  const float directions[6] = {0, 0, 1, 0, 0, 0};
  float values[2] = {7, 7};
  expect_error(ups_profile_eval(profile, directions, 2, values), UPS_ERROR_INVALID_ARGUMENT,
               {"directions_xyz: element 1"});
  EXPECT_EQ(values[0], 7) << "outputs are untouched on failure";
  EXPECT_OK(ups_profile_eval(profile, nullptr, 0, nullptr));
  expect_error(ups_profile_eval(profile, directions, 1, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"intensity_cd is NULL"});
}

}  // namespace
}  // namespace ups_test
