// Is every broken file refused with its line, and every odd one read with a warning that has its line?
#include <random>

#include "photometry/files.h"

namespace photometry {
namespace {

using namespace test;

// A valid file, one record a line from line 4, in which a record can be replaced.
struct Parts {
  std::string version = "IESNA:LM-63-2002", tilt = "TILT=NONE", lamps = "1 -1 1 3 2 1 2 .1 .2 0", ballast = "1 1 10",
              vertical = "0 45 90", horizontal = "0 90", first = "100 50 10", second = "100 60 10", more = "";
  std::string text() const {
    return version + "\n[TEST] x\n" + tilt + "\n" + lamps + "\n" + ballast + "\n" + vertical + "\n" + horizontal +
           "\n" + first + "\n" + second + "\n" + more;
  }
};

struct Case {
  const char* name;
  std::string Parts::*part;
  const char *value, *message;  // how the message starts
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
const auto case_name = [](const auto& test) { return std::string(test.param.name); };

class Refused : public testing::TestWithParam<Case> {};

TEST_P(Refused, WithItsLine) {
  Parts parts;
  parts.*GetParam().part = GetParam().value;
  const std::string message = refusal<ParseError>(parts.text());
  EXPECT_EQ(message.rfind(GetParam().message, 0), 0u) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Ies, Refused,
    testing::Values(
        Case{"text", &Parts::vertical, "0 abc 90", "line 6: \"abc\" is not a number; vertical angle 2 of 3"},
        Case{"missing", &Parts::second, "100 60", "line 9: the file ends before candela value 6 of 6"},
        Case{"cut_word", &Parts::vertical, "0 aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\u00e9 90",
             "line 6: \"aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa\" is not a number"},
        Case{"infinite", &Parts::second, "100 inf 20", "line 9: an intensity"},
        Case{"huge", &Parts::second, "100 1e999 20", "line 9: \"1e999\" is not a number"},
        Case{"fraction", &Parts::lamps, "1 -1 1 3.5 2 1 2 0 0 0", "line 4: the number of vertical angles is 3.5"},
        Case{"no_angles", &Parts::lamps, "1 -1 1 3 0 1 2 0 0 0", "line 4: the number of horizontal angles is 0"},
        Case{"one_vertical", &Parts::lamps, "1 -1 1 1 2 1 2 0 0 0", "line 4: the number of vertical angles is 1"},
        Case{"billions", &Parts::lamps, "1 -1 1 3 9e9 1 2 0 0 0", "line 4: the number of horizontal angles is 9e+09"},
        Case{"too_many", &Parts::lamps, "1 -1 1 3000 3000 1 2 0 0 0", "line 4: 3000 x 3000 candelas are too many"},
        Case{"type", &Parts::lamps, "1 -1 1 3 2 7 2 0 0 0", "line 4: the photometric type is 7"},
        Case{"units", &Parts::lamps, "1 -1 1 3 2 1 3 0 0 0", "line 4: the units type is 3"},
        Case{"dimension", &Parts::lamps, "1 -1 1 3 2 1 2 nan 0 0", "line 4: the luminous opening's dimensions"},
        Case{"multiplier", &Parts::lamps, "1 -1 -1 3 2 1 2 0 0 0", "line 4: the candela multiplier is -1"},
        Case{"ballast", &Parts::ballast, "nan 1 10", "line 5: the ballast factor is nan"},
        Case{"constant", &Parts::vertical, "25 25 25", "line 6: vertical angle 2 is 25 after 25"},
        Case{"unsorted", &Parts::vertical, "0 60 45", "line 6: vertical angle 3 is 45 after 60"},
        Case{"type_b_range", &Parts::vertical, "-90 0 90", "line 6: vertical angles from -90 to 90"},
        Case{"open_circle", &Parts::horizontal, "0 100", "line 7: horizontal angles from 0 to 100"},
        Case{"odd_start", &Parts::horizontal, "10 90", "line 7: horizontal angles from 10 to 90"},
        Case{"lamps", &Parts::lamps, "1 1e300 1 3 2 1 2 0 0 0", "line 4: the lamps and their lumens are 1 and 1e+300"},
        Case{"tilt_angle", &Parts::tilt, "TILT=INCLUDE\n1\n2\n0 0\n1 1", "line 6: tilt angle 2 is 0"},
        Case{"tilt_factor", &Parts::tilt, "TILT=INCLUDE\n1\n2\n0 9\n1 -1", "line 7: tilt factor 2 is -1"},
        Case{"tilt_count", &Parts::tilt, "TILT=INCLUDE\n1\n0", "line 5: the number of tilt angles is 0"},
        Case{"surplus", &Parts::more, "1 2 3", "line 10: numbers go on after the last of 6 candela values"},
        Case{"decimal_comma", &Parts::second, "100 59,5 10", "line 9: \"59,5\" has a comma inside, while blanks part"},
        Case{"thousands", &Parts::first, "1,000 996 985", "line 8: \"1,000\" has a comma inside, while blanks part"},
        Case{"surplus_by_comma", &Parts::second, "100,60,10,5", "line 9: numbers go on after the last of 6"}),
    case_name);

class Doubtful : public testing::TestWithParam<Case> {};

TEST_P(Doubtful, IsReadWithAWarning) {
  Parts parts;
  parts.*GetParam().part = GetParam().value;
  const Photometry p = read_text(parts.text());
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_EQ(p.warnings[0].rfind(GetParam().message, 0), 0u) << p.warnings[0];
}

INSTANTIATE_TEST_SUITE_P(
    Ies, Doubtful,
    testing::Values(Case{"negative", &Parts::second, "100 -1 nan", "line 9: 2 candela values are negative or NaN"},
                    Case{"one_negative", &Parts::second, "100 -1 20", "line 9: 1 candela value is negative or NaN"},
                    Case{"nadir", &Parts::second, "97 60 20", "line 7: at the nadir, which is one direction"},
                    Case{"ballast", &Parts::ballast, "2.5 1 10", "line 5: a ballast factor of 2.5 is doubtful"},
                    Case{"power_nan", &Parts::ballast, "1 1 nan", "line 5: the input power is nan W; taken as not"},
                    Case{"multiplier", &Parts::lamps, "1 -1 0 3 2 1 2 .1 .2 0", "line 4: the candela multiplier is 0"},
                    Case{"lumens", &Parts::lamps, "1 0 1 3 2 1 2 .1 .2 0", "line 4: the rated flux is 1 x 0 lm"},
                    Case{"rated", &Parts::lamps, "1 50 1 3 2 1 2 .1 .2 0", "line 4: the candelas add up to"},
                    Case{"type", &Parts::lamps, "1 -1 1 3 2 0 2 .1 .2 0", "line 4: the photometric type is 0"},
                    Case{"size", &Parts::lamps, "1 -1 1 3 2 1 2 100 200 0", "line 4: a luminous opening of 200 m"},
                    Case{"reserved", &Parts::ballast, "1 0.9 10", "line 5: the field after the ballast factor is 0.9"},
                    Case{"power", &Parts::ballast, "1 1 -5", "line 5: the input power is -5 W; taken as not stated"},
                    Case{"short_range", &Parts::vertical, "0 30 65", "line 6: vertical angles from 0 to 65"},
                    Case{"descending", &Parts::vertical, "90 45 0", "line 6: the vertical angles descend"},
                    Case{"trailing", &Parts::more, "end, of 1.5 pages", "line 10: what follows the candelas is ignored"},
                    Case{"edition", &Parts::version, "IESNA:LM-63-2005", "line 1: there is no edition of 2005"},
                    Case{"odd_version", &Parts::version, "IESNA95", "line 1: odd version line"},
                    Case{"tilt_file", &Parts::tilt, "TILT = x.tlt", "line 3: the TILT file \"x.tlt\""}),
    case_name);

TEST(IesMalformed, SameDataInOtherWordsNeedsNoWarning) {
  const Photometry reference = read_text(Parts().text());
  ASSERT_TRUE(reference.warnings.empty()) << reference.warnings[0];
  const auto same = [&](const Parts& parts) {
    const Photometry p = read_text(parts.text());
    EXPECT_TRUE(p.warnings.empty()) << p.warnings[0];
    EXPECT_EQ(p.distribution.band_flux_lm(), reference.distribution.band_flux_lm());
  };
  Parts parts;
  parts.tilt = "  tilt = none";
  parts.lamps = "1.0 -1 +1 3. 2.0 1 2 .1 .2 0.";
  parts.vertical = "0\t45;90";
  parts.first = "1.0E+0002 5e1\r\r\n10";
  parts.second = "100 ,60, 10";
  parts.more = "\x1a junk";
  same(parts);
  Parts one_line;
  one_line.lamps += " " + one_line.ballast + " " + one_line.vertical;
  one_line.ballast = one_line.horizontal + " " + one_line.first;
  one_line.vertical = one_line.horizontal = one_line.first = "";
  same(one_line);
}

TEST(IesMalformed, DescendingAnglesAreTurnedRound) {
  Parts parts;
  parts.vertical = "90 45 0";
  parts.first = "10 50 100";
  parts.second = "10 60 100";
  EXPECT_EQ(read_text(parts.text()).distribution.band_flux_lm(), read_text(Parts().text()).distribution.band_flux_lm());
}

TEST(IesMalformed, DecimalCommasAreRecognised) {
  Parts parts;
  parts.lamps = "1 -1 1,0 3 2 1 2 0,1 0,2 0";
  parts.first = "100 50,0 10";
  const Photometry p = read_text(parts.text());
  EXPECT_EQ(p.distribution.band_flux_lm(), read_text(Parts().text()).distribution.band_flux_lm());
  EXPECT_FLOAT_EQ(p.opening.size_m[0], 0.2f);
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_EQ(p.warnings[0], "line 4: the numbers have decimal commas");
}

TEST(IesMalformed, CommasThatMayBeEitherAreRefused) {
  Parts parts;
  parts.lamps = "1 -1 1 3 2 1 2 0 0 0";
  parts.first = "1,000 996 985";
  parts.second = "1,000 980 970";
  EXPECT_EQ(refusal<ParseError>(parts.text()),
            "line 9: \"1,000\" has a comma inside, which may be decimal or a thousands mark, as in all numbers that "
            "have one");
  parts.second = "1,000 0,980 970";  // no thousands begin with 0
  EXPECT_EQ(read_text(parts.text()).distribution.peak_cd(), 996);
  parts.second = "1,000 2000 970";
  EXPECT_EQ(read_text(parts.text()).distribution.peak_cd(), 2000);
}

// Each line by its own separators, and blanks beside commas.
TEST(IesMalformed, CommasSeparate) {
  Parts parts;
  parts.vertical = "0,45,90";
  parts.first = "100, 50 ,10";
  parts.second = "100,60, 10";
  parts.more = "made by A, B and C";
  EXPECT_EQ(read_text(parts.text()).distribution.band_flux_lm(), read_text(Parts().text()).distribution.band_flux_lm());
}

TEST(IesMalformed, MissingTiltLineIsFoundByTheNumbers) {
  Parts parts;
  parts.tilt = "[OTHER] nothing";
  parts.lamps = "1 -1 1 3 2 1 2 .1 .2 0";
  const Photometry p = read_text(parts.text());
  EXPECT_EQ(p.distribution.band_flux_lm(), read_text(Parts().text()).distribution.band_flux_lm());
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_EQ(p.warnings[0], "line 4: no TILT= line before the numbers; read as TILT=NONE");
  ASSERT_EQ(p.keywords.size(), 2u) << "the numbers are none";
  EXPECT_EQ(p.keywords[1].name, "OTHER");
}

TEST(IesMalformed, WithoutTiltAndNumbersItIsNoIesFile) {
  Parts parts;
  parts.tilt = "[OTHER] TILT=NONE";
  parts.lamps = "1 -1 1 3 2 1 2";
  EXPECT_EQ(refusal<ParseError>(parts.text()).rfind("line 9: the file ends without a TILT= line", 0), 0u);
}

TEST(IesMalformed, DarknessIsAWarning) {
  Parts parts;
  parts.first = parts.second = "0 0 0";
  const Photometry p = read_text(parts.text());
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_EQ(p.warnings[0], "line 7: all intensities are 0");
}

TEST(IesMalformed, Utf16IsRead) {
  std::string wide = "\xFF\xFE";
  for (char c : Parts().text()) wide += {c, '\0'};
  EXPECT_EQ(read_text(wide).distribution.band_flux_lm(), read_text(Parts().text()).distribution.band_flux_lm());
}

TEST(IesMalformed, TruncatedFileIsRefusedWithItsLine) {
  EXPECT_EQ(refusal<ParseError>(data("s16_truncated.ies")), "line 14: the file ends before candela value 18 of 19");
}
TEST(IesMalformed, SwappedCountsAreGuessed) {
  Parts parts;
  parts.lamps = "1 -1 1 2 3 1 2 .1 .2 0";
  EXPECT_NE(refusal<ParseError>(parts.text()).find("swapped"), std::string::npos) << refusal<ParseError>(parts.text());
}

TEST(IesMalformed, AnotherLampSetThanTheFirstIsRefused) {
  ReadOptions options;
  options.lamp_set = 1;
  EXPECT_EQ(refusal<std::invalid_argument>(Parts().text(), options), "lamp_set is 1; an IES file has one, 0");
}

// Any bytes give a distribution or one of the two errors. Fixed seed.
TEST(IesMalformed, BrokenBytesNeverCrash) {
  std::mt19937 random(1);
  const std::string whole = Parts().text();
  int read_count = 0, refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = whole.substr(0, i % 4 == 0 ? random() % whole.size() : whole.size());
    for (uint32_t k = random() % 6; k > 0 && !text.empty(); --k) text[random() % text.size()] = char(random());
    try {
      read_text(text);
      ++read_count;
    } catch (const ParseError& e) {
      EXPECT_EQ(std::string(e.what()).rfind("line ", 0), 0u) << e.what();
      ++refused;
    } catch (const UnsupportedError&) {
      ++refused;
    }
  }
  EXPECT_GT(read_count, 100);
  EXPECT_GT(refused, 100);
  EXPECT_THROW(read(nullptr, 0), ParseError);
}

}  // namespace
}  // namespace photometry
