// Profiles through the C API: files with options, what the info says of them, keywords, writing, whole luminaires.
#include <cmath>
#include <cstring>

#include "fixture.h"

namespace ups_test {
namespace {

const std::string ies_with_tilt =
    "IESNA:LM-63-2002\n[TEST] one\n[MANUFAC] maker\n[OTHER] first\n[OTHER] second\nTILT=hid.tlt\n"
    "2 500 1 2 1 1 2 0.2 0.4 0\n1 1 25\n0 90\n0\n100 100\n";
const std::string tilt_table = "1 2 0 90 1 0.5";
const std::string type_b =
    "IESNA:LM-63-2002\nTILT=NONE\n1 -1 1 3 3 2 2 0 0 0\n1 1 25\n-90 0 90\n-90 0 90\n0 0 0 0 100 50 0 0 0\n";

std::string eulumdat() {
  std::string text = "maker\n1\n1\n1\n0\n2\n90\nreport\nname\nnumber\nfile\ndate\n";
  for (const char* field : {"600", "300", "50", "600", "300", "0", "0", "0", "0", "100", "0", "1", "0", "2"})
    text += std::string(field) + "\n";
  text += "1\nsmall\n1000\n3000\n80\n10\n1\nlarge\n2000\n3000\n80\n20\n";
  for (int i = 0; i < 10; ++i) text += "0\n";
  return text + "0\n0\n90\n100\n100\n";
}

class Profile : public Api {
 protected:
  ~Profile() override { ups_profile_destroy(read); }
  ups_profile_parse_desc desc(const std::string& text) {
    auto d = make(&ups_profile_parse_desc_init);
    d.bytes = text.data(), d.size = text.size();
    return d;
  }
  ups_profile_info parse(const ups_profile_parse_desc& d) {
    ups_profile_destroy(read);
    read = nullptr;
    EXPECT_OK(ups_profile_parse_with(context, &d, &read));
    return info();
  }
  ups_profile_info info() {
    ups_profile_info i{};
    i.struct_size = sizeof i;
    EXPECT_OK(ups_profile_get_info(read, &i));
    return i;
  }
  std::string keyword(const char* name) {
    char text[64];
    size_t needed;
    EXPECT_OK(ups_profile_get_keyword(read, name, text, sizeof text, &needed));
    EXPECT_EQ(needed, std::strlen(text) + 1);
    return text;
  }
  std::string written(ups_profile_format format) {
    size_t needed = 0;
    EXPECT_OK(ups_profile_write(read, format, nullptr, 0, &needed));
    std::string text(needed, '?');
    EXPECT_OK(ups_profile_write(read, format, text.data(), needed, &needed));
    text.resize(needed - 1);
    return text;
  }
  ups_profile* read = nullptr;
};

// A NUL in a file ends no text early.
TEST_F(Profile, NamesHaveNoNulInTheirTexts) {
  std::string text = ies_with_tilt;
  text.replace(text.find("MANUFAC"), 7, std::string("MANU\0AC", 7));
  text.replace(text.find("hid.tlt"), 7, std::string("hid\0tlt", 7));
  parse(desc(text));
  for (const auto& [topic, expected] : {std::pair(UPS_PROFILE_TEXT_KEYWORDS, "OTHER=second\n"),
                                        std::pair(UPS_PROFILE_TEXT_TILT_FILE, "tlt")}) {
    char told[256];
    size_t needed;
    EXPECT_OK(ups_profile_get_text(read, topic, told, sizeof told, &needed));
    EXPECT_EQ(needed, std::strlen(told) + 1);
    EXPECT_TRUE(std::string(told).ends_with(expected)) << told;
  }
}

TEST_F(Profile, TiltFileIsNamedReadAndApplied) {
  auto d = desc(ies_with_tilt);
  const double flux = parse(d).flux_lm;
  char name[16];
  size_t needed;
  EXPECT_OK(ups_profile_get_text(read, UPS_PROFILE_TEXT_TILT_FILE, name, sizeof name, &needed));
  EXPECT_STREQ(name, "hid.tlt");
  d.tilt_file = tilt_table.data(), d.tilt_file_size = tilt_table.size();
  EXPECT_EQ(parse(d).flux_lm, flux) << "the table alone changes nothing";
  EXPECT_OK(ups_profile_get_text(read, UPS_PROFILE_TEXT_TILT_TABLE, name, sizeof name, &needed));
  EXPECT_STREQ(name, "0 1\n90 0.5\n");
  d.tilt_deg = 45;
  EXPECT_NEAR(parse(d).flux_lm, 0.75 * flux, 1e-9);
  EXPECT_OK(ups_profile_get_text(read, UPS_PROFILE_TEXT_TILT_TABLE, name, sizeof name, &needed));
  EXPECT_STREQ(name, "") << "it is applied";
  d.tilt_file = nullptr;
  expect_error(ups_profile_parse_with(context, &d, &read), UPS_ERROR_INVALID_ARGUMENT, {"tilt_file is NULL"});
  d = desc(ies_with_tilt), d.tilt_deg = NAN;
  expect_error(ups_profile_parse_with(context, &d, &read), UPS_ERROR_INVALID_ARGUMENT, {"tilt_deg"});
}

TEST_F(Profile, LampSetsAreChosen) {
  const std::string text = eulumdat();
  auto d = desc(text);
  const ups_profile_info small = parse(d);
  EXPECT_EQ(small.lamp_set_count, 2u);
  EXPECT_EQ(small.rated_flux_lm, 1000);
  d.lamp_set = 1, d.format = UPS_PROFILE_EULUMDAT;
  const ups_profile_info large = parse(d);
  EXPECT_NEAR(large.flux_lm, 2 * small.flux_lm, 1e-9);
  EXPECT_EQ(large.input_power_w, 20);
  d.lamp_set = 2;
  ups_profile* out = nullptr;
  expect_error(ups_profile_parse_with(context, &d, &out), UPS_ERROR_INVALID_ARGUMENT, {"lamp_set is 2", "2 sets"});
}

TEST_F(Profile, LampSetsAreTold) {
  const std::string text = eulumdat();
  auto d = desc(text);
  d.lamp_set = 1;
  parse(d);
  const auto lamps = [&](uint32_t index) {
    ups_profile_lamp_set set{};
    set.struct_size = sizeof set;
    EXPECT_OK(ups_profile_get_lamp_set(read, index, &set));
    return set;
  };
  const ups_profile_lamp_set small = lamps(0), large = lamps(1);
  EXPECT_EQ(small.count, 1);
  EXPECT_EQ(small.flux_lm, 1000);
  EXPECT_EQ(small.input_power_w, 10);
  EXPECT_EQ(small.colour_temperature_k, 3000);
  EXPECT_EQ(small.colour_rendering_index, 80);
  EXPECT_EQ(small.chosen, 0);
  EXPECT_EQ(large.flux_lm, 2000);
  EXPECT_EQ(large.chosen, 1);
  char types[32], colours[32], renderings[32];
  size_t needed;
  EXPECT_OK(ups_profile_get_text(read, UPS_PROFILE_TEXT_LAMP_TYPES, types, sizeof types, &needed));
  EXPECT_OK(ups_profile_get_text(read, UPS_PROFILE_TEXT_LAMP_COLOURS, colours, sizeof colours, &needed));
  EXPECT_OK(ups_profile_get_text(read, UPS_PROFILE_TEXT_LAMP_RENDERINGS, renderings, sizeof renderings, &needed));
  EXPECT_STREQ(types, "small\nlarge\n");
  EXPECT_STREQ(colours, "3000\n3000\n");
  EXPECT_STREQ(renderings, "80\n80\n");
  ups_profile_lamp_set none{};
  none.struct_size = sizeof none;
  expect_error(ups_profile_get_lamp_set(read, 2, &none), UPS_ERROR_INVALID_ARGUMENT, {"index is 2", "2 lamp sets"});
  expect_error(ups_profile_get_lamp_set(read, 0, nullptr), UPS_ERROR_INVALID_ARGUMENT, {"set is NULL"});
}

TEST_F(Profile, KeywordsHaveOneNameInBothFormats) {
  parse(desc(ies_with_tilt));
  EXPECT_EQ(keyword("manufac"), "maker");
  EXPECT_EQ(keyword("OTHER"), "first\nsecond");
  EXPECT_EQ(keyword("LUMCAT"), "");
  const std::string text = eulumdat();
  parse(desc(text));
  EXPECT_EQ(keyword("Manufac"), "maker");
  EXPECT_EQ(keyword("LUMCAT"), "number");
  size_t needed;
  expect_error(ups_profile_get_keyword(read, nullptr, nullptr, 0, &needed), UPS_ERROR_INVALID_ARGUMENT,
               {"name is NULL"});
}

TEST_F(Profile, ACopyHasAnotherKeyword) {
  ups_profile* copy = nullptr;
  parse(desc(ies_with_tilt));
  EXPECT_OK(ups_profile_with_keyword(read, "Other", "third", &copy));
  EXPECT_EQ(keyword("OTHER"), "first\nsecond") << "the profile itself stays";
  std::swap(read, copy);
  ups_profile_destroy(copy);
  EXPECT_EQ(keyword("OTHER"), "third");
  EXPECT_OK(ups_profile_with_keyword(read, "lumcat", "A 1", &copy));
  std::swap(read, copy);
  ups_profile_destroy(copy);
  const std::string ies = written(UPS_PROFILE_IES_LM63), ldt = written(UPS_PROFILE_EULUMDAT);
  EXPECT_NE(ies.find("[LUMCAT] A 1\r\n"), std::string::npos);
  EXPECT_NE(ldt.find("\r\nA 1\r\n"), std::string::npos);
  const auto refused = [&](const char* name, const char* value, const std::vector<std::string>& words) {
    ups_profile* none = nullptr;
    expect_error(ups_profile_with_keyword(read, name, value, &none), UPS_ERROR_INVALID_ARGUMENT, words);
    EXPECT_EQ(none, nullptr);
  };
  refused("", "x", {"name", "letters"});
  refused("TEST] [LAMP", "x", {"name", "TEST] [LAMP"});
  refused(std::string(65, 'A').c_str(), "x", {"name"});
  refused("TEST", "two\nlines", {"value", "TEST", "one line"});
  refused("TEST", std::string(1001, 'x').c_str(), {"value", "1000"});
  refused("TEST", "\xff", {"value", "TEST", "UTF-8"});
  refused(nullptr, "x", {"name is NULL"});
  refused("TEST", nullptr, {"value is NULL"});
  expect_error(ups_profile_with_keyword(read, "TEST", "x", nullptr), UPS_ERROR_INVALID_ARGUMENT, {"out is NULL"});
}

TEST_F(Profile, InfoTellsTypeAndRatio) {
  const ups_profile_info c = parse(desc(ies_with_tilt));
  EXPECT_EQ(c.photometric_type, UPS_PHOTOMETRIC_C);
  EXPECT_NEAR(c.light_output_ratio, c.flux_lm / 1000, 1e-12);
  EXPECT_EQ(c.ray_count, 0u);
  const ups_profile_info b = parse(desc(type_b));
  EXPECT_EQ(b.photometric_type, UPS_PHOTOMETRIC_B);
  EXPECT_LT(b.light_output_ratio, 0);
  EXPECT_EQ(b.peak_cd, 100);
  EXPECT_EQ(b.peak_gamma_deg, 0);
  const float up[3] = {1, 0, -1};  // H 0, V 45: halfway from 100 to 50
  float value = 0;
  EXPECT_OK(ups_profile_eval(read, up, 1, &value));
  EXPECT_NEAR(value, 75, 1e-4);
}

TEST_F(Profile, WritesBothFormats) {
  parse(desc(type_b));
  const std::string ies = written(UPS_PROFILE_IES_LM63), ldt = written(UPS_PROFILE_EULUMDAT);
  const double flux = info().flux_lm;
  auto d = desc(ies);
  const ups_profile_info again = parse(d);
  EXPECT_EQ(again.photometric_type, UPS_PHOTOMETRIC_B);
  EXPECT_EQ(again.flux_lm, flux);
  EXPECT_EQ(again.warning_count, 0u);
  d = desc(ldt);
  EXPECT_EQ(parse(d).photometric_type, UPS_PHOTOMETRIC_C);
  char small[8] = "unread";
  size_t needed = 0;
  expect_error(ups_profile_write(read, UPS_PROFILE_IES_LM63, small, sizeof small, &needed), UPS_ERROR_BUFFER_TOO_SMALL,
               {"capacity is 8"});
  EXPECT_GT(needed, 100u);
  EXPECT_STREQ(small, "unread");
  for (int format : {UPS_PROFILE_AUTO, UPS_PROFILE_TM33_XML, UPS_PROFILE_LIGHTTOOLS_RAYS})
    expect_error(ups_profile_write(read, format, nullptr, 0, &needed), UPS_ERROR_UNSUPPORTED, {"format"});
  expect_error(ups_profile_write(read, 7, nullptr, 0, &needed), UPS_ERROR_INVALID_ARGUMENT, {"format is 7"});
}

TEST_F(Profile, ATableMakesAWholeLuminaire) {
  auto d = uniform_profile();
  d.opening_shape = UPS_OPENING_CYLINDER, d.opening_axis = 0, d.input_power_w = 12;
  d.opening_m[0] = 1.2f, d.opening_m[1] = d.opening_m[2] = 0.1f;
  EXPECT_OK(ups_profile_create(context, &d, &read));
  const std::string ies = written(UPS_PROFILE_IES_LM63);
  for (int turn = 0; turn < 2; ++turn) {
    const ups_profile_info i = info();
    EXPECT_EQ(i.opening_shape, UPS_OPENING_CYLINDER);
    EXPECT_EQ(i.opening_axis, 0);
    EXPECT_EQ(i.opening_m[0], 1.2f);
    EXPECT_EQ(i.opening_m[2], 0.1f);
    EXPECT_EQ(i.input_power_w, 12);
    parse(desc(ies));
  }
  const auto refused = [&](auto change, const std::vector<std::string>& words) {
    auto bad = d;
    change(bad);
    ups_profile* out = nullptr;
    expect_error(ups_profile_create(context, &bad, &out), UPS_ERROR_INVALID_ARGUMENT, words);
  };
  refused([](ups_profile_desc& b) { b.opening_shape = 6; }, {"opening_shape is 6"});
  refused([](ups_profile_desc& b) { b.opening_axis = 3; }, {"opening_axis"});
  refused([](ups_profile_desc& b) { b.opening_m[1] = -1; }, {"opening_m[1]"});
  refused([](ups_profile_desc& b) { b.opening_m[2] = NAN; }, {"opening_m[2]"});
  refused([](ups_profile_desc& b) { b.input_power_w = INFINITY; }, {"input_power_w"});
}

}  // namespace
}  // namespace ups_test
