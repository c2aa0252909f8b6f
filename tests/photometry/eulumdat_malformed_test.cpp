// Is every broken EULUMDAT file refused with its line, and every odd one read with a warning that has its line?
#include <functional>
#include <random>

#include "photometry/eulumdat_parts.h"

namespace photometry {
namespace {

using namespace test;

struct Case {
  const char* name;
  std::function<void(EulumdatParts&)> change;
  const char* message;  // how it starts
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.name; }
const auto case_name = [](const auto& test) { return std::string(test.param.name); };
using P = EulumdatParts;

std::string ldt_refusal(const std::string& text) {
  try {
    read_eulumdat(text.data(), text.size());
  } catch (const ParseError& e) {
    return e.what();
  }
  return "read without an error";
}

// 12,500 lm: read as 12.5 lm a lamp was a thousandth as bright, without a word.
TEST(Eulumdat, ACommaThatMayMarkThousandsNeedsAnotherThatIsDecimal) {
  const auto with = [](const std::string& flux, const std::string& conversion, const std::string& ratio) {
    EulumdatParts parts;
    parts.lamps = {"1\nLED\n" + flux + "\n3000\n80\n10"}, parts.conversion = conversion;
    std::string text = parts.text();
    for (size_t at; (at = text.find("0.5\n")) != text.npos;) text.replace(at, 3, ratio);
    return ldt_refusal(text);
  };
  EXPECT_EQ(with("12,500", "1", "0"), "line 29: \"12,500\" has a comma inside, which may be decimal or a thousands mark, "
                                      "as in all numbers that have one");
  EXPECT_EQ(with("12,500", "1", "0,5"), "read without an error");
  EXPECT_EQ(with("12500", "1,000", "0"), "read without an error");  // no factor is a thousand
}

class EulumdatRefused : public testing::TestWithParam<Case> {};

// Lines: 3 Isym, 4 Mc, 6 Ng, 24 conversion, 26 sets, 27-32 lamps, 33-42 ratios, 43 C, 44-46 gamma, 47-49 intensities.
TEST_P(EulumdatRefused, WithItsLine) {
  EulumdatParts parts;
  GetParam().change(parts);
  const std::string message = ldt_refusal(parts.text());
  EXPECT_EQ(message.rfind(GetParam().message, 0), 0u) << message;
}

INSTANTIATE_TEST_SUITE_P(
    Eulumdat, EulumdatRefused,
    testing::Values(
        Case{"symmetry", [](P& p) { p.isym = "5"; },
             "line 3: the symmetry indicator Isym is 5; it must be a whole number"},
        Case{"no_planes", [](P& p) { p.mc = "0"; }, "line 4: the number Mc of C planes is 0"},
        Case{"text", [](P& p) { p.mc = "many"; }, "line 4: \"many\" is not a number; the number Mc"},
        Case{"one_gamma", [](P& p) { p.ng = "1"; }, "line 6: the number Ng of intensities in a plane is 1"},
        Case{"fraction", [](P& p) { p.ng = "2.5"; }, "line 6: the number Ng of intensities in a plane is 2.5"},
        Case{"too_many", [](P& p) { p.mc = "4000", p.ng = "4000"; }, "line 6: 4000 x 4000 intensities are too many"},
        Case{"billions", [](P& p) { p.mc = "4e9"; }, "line 4: the number Mc of C planes is 4e+09"},
        Case{"conversion", [](P& p) { p.conversion = "-1"; },
             "line 24: the conversion factor for the intensities is -1"},
        Case{"thousands", [](P& p) { p.conversion = "1.0", p.lamps = {"1\nLED\n3,500\n3000\n80\n10"}; },
             "line 29: \"3,500\" has a comma inside, which may be decimal or a thousands mark"},
        Case{"thousands_before_points", [](P& p) { p.conversion = "1,000", p.lamps = {"1\nLED\n3.5\n3000\n80\n10"}; },
             "line 24: \"1,000\" has a comma inside, which may be decimal or a thousands mark"},
        Case{"infinite", [](P& p) { p.conversion = "inf"; }, "line 24: \"inf\" is not a number"},
        Case{"no_sets", [](P& p) { p.sets = "0"; }, "line 26: the number of lamp sets is 0"},
        Case{"sets_beyond_the_end", [](P& p) { p.sets = "99"; }, "line 26: the number of lamp sets is 99, but"},
        Case{"no_flux", [](P& p) { p.lamps = {"1\nLED\n0\n3000\n80\n10"}; }, "line 29: the flux of lamp set 1 is 0"},
        Case{"flux_text", [](P& p) { p.lamps = {"1\nLED\nx\n3000\n80\n10"}; },
             "line 29: \"x\" is not a number; the lamps'"},
        Case{"shifted",
             [](P& p) {
               p.sets = "2", p.isym = "0", p.c = {0, 90, 180, 270}, p.intensity = {3, 2, 1, 3, 2, 1, 3, 2, 1, 3, 2, 1};
             },
             "line 50: C angle 2 is 3 after 90; angles must ascend (is the number of lamp sets in line 26 right?)"},
        Case{"c_start", [](P& p) { p.c = {5}; }, "line 43: the C angles run from 5 to 5"},
        Case{"c_order", [](P& p) { p.isym = "0", p.c = {0, 90, 80}; }, "line 45: C angle 3 is 80 after 90"},
        Case{"c_range", [](P& p) { p.isym = "0", p.c = {0, 400}; }, "line 44: the C angles run from 0 to 400"},
        Case{"half_circle", [](P& p) { p.isym = "0", p.c = {0, 90, 180}; },
             "line 45: the C angles end at 180 and leave 180 degrees without a plane, at least twice their own steps; "
             "without a symmetry (Isym 0 in line 3) they must go all round; planes that are mirrored about C0-C180"},
        Case{"quarter_circle", [](P& p) { p.isym = "0", p.c = {0, 90}; },
             "line 44: the C angles end at 90 and leave 270 degrees"},
        Case{"no_180", [](P& p) { p.isym = "2", p.c = {0, 90, 200}; }, "line 45: there is no C angle 180"},
        Case{"no_270", [](P& p) { p.isym = "3", p.c = {0, 90, 180}; }, "line 45: there is no C angle 270"},
        Case{"no_90", [](P& p) { p.isym = "4", p.c = {0, 180}; }, "line 44: there is no C angle 90"},
        Case{"gamma_order", [](P& p) { p.gamma = {0, 45, 45}; }, "line 46: gamma 3 is 45 after 45"},
        Case{"gamma_range", [](P& p) { p.gamma = {0, 45, 200}; }, "line 46: the angles gamma run from 0 to 200"},
        Case{"truncated", [](P& p) { p.intensity = {300, 200}; }, "line 48: the file ends before intensity 3 of 3"},
        Case{"huge", [](P& p) { p.conversion = "1e30"; }, "line 47: an intensity of"}),
    case_name);

// Which is no signature any more: the error is that of the field all the same, and whole.
TEST(EulumdatMalformed, AHeadThatIsDamagedIsStillOfEulumdat) {
  EulumdatParts parts;
  parts.isym = std::string("n\0n", 3);
  const std::string text = parts.text();
  expect_refused<ParseError>(text, "line 3: \"n?n\" is not a number; the symmetry indicator Isym is expected here");
  expect_refused<ParseError>("a\n1\n2\n3\n4\n5\nTILT=NONE\n", "the file ends before");
}

class EulumdatDoubtful : public testing::TestWithParam<Case> {};

TEST_P(EulumdatDoubtful, IsReadWithAWarning) {
  EulumdatParts parts;
  GetParam().change(parts);
  const std::string text = parts.text();
  const Photometry p = read_eulumdat(text.data(), text.size());
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_EQ(p.warnings[0].rfind(GetParam().message, 0), 0u) << p.warnings[0];
}

INSTANTIATE_TEST_SUITE_P(
    Eulumdat, EulumdatDoubtful,
    testing::Values(
        Case{"type", [](P& p) { p.type = "7"; }, "line 2: the type indicator Ityp is 7"},
        Case{"type_text", [](P& p) { p.type = "point"; }, "line 2: the type indicator Ityp is \"point\""},
        Case{"opening_in_metres", [](P& p) { p.area = "0.6\n0.3"; },
             "line 21: the luminous opening is 0.6 mm at its longest, the luminaire 600 mm"},
        Case{"long_opening_in_metres", [](P& p) { p.size = "1580\n60\n60", p.area = "1.5\n0.05"; },
             "line 21: the luminous opening is 1.5 mm at its longest, the luminaire 1580 mm"},
        Case{"tiny_opening", [](P& p) { p.size = "90\n0\n100", p.area = "0.08\n0"; },
             "line 21: the luminous opening is 0.08 mm at its longest, the luminaire 100 mm"},
        Case{"all_in_metres", [](P& p) { p.size = "1.2\n0.3\n0.08", p.area = "1.15\n0.25"; },
             "line 21: the luminous opening is 1.15 mm at its longest, the luminaire 1.2 mm"},
        Case{"fraction_text", [](P& p) { p.dff = "100 %"; }, "line 22: the downward flux fraction is \"100 %\""},
        Case{"fraction", [](P& p) { p.dff = "0"; },
             "line 22: the downward flux fraction is 0 %, but of the intensities' light 100 % goes down"},
        Case{"fraction_of_half",
             [](P& p) { p.dff = "53", p.gamma = {0, 90, 180}, p.intensity = {100, 100, 100}; },
             "line 22: the downward flux fraction is 53 %, but of the intensities' light 50 % goes down"},
        Case{"plane_left_out",
             [](P& p) { p.isym = "0", p.c = {0, 40, 80, 120, 160, 200, 240, 280}, p.intensity.assign(24, 100); },
             "line 50: the C angles end at 280 and leave 80 degrees without a plane, at least twice their own steps; "
             "the intensities between are interpolated"},
        Case{"plane_step", [](P& p) { p.isym = "0", p.dc = "90", p.c = {0, 120, 240}, p.intensity.assign(9, 100); },
             "line 5: the distance Dc of the C planes is 90 degrees, but the C angles have a step of 120"},
        Case{"gamma_step", [](P& p) { p.dg = "30"; },
             "line 7: the distance Dg of the intensities is 30 degrees, but the angles gamma have a step of 45"},
        Case{"blank_symmetry", [](P& p) { p.isym = ""; }, "line 3: the symmetry indicator Isym is blank; taken as 0"},
        Case{"ratio", [](P& p) { p.lor = "50"; },
             "line 23: the light output ratio is 50 %, but the intensities add up to"},
        Case{"conversion", [](P& p) { p.conversion = "0"; }, "line 24: the conversion factor for the intensities is 0"},
        Case{"negative", [](P& p) { p.intensity = {300, -2, 0}; }, "line 48: 1 intensity is negative"},
        Case{"tilt", [](P& p) { p.tilt = "15"; }, "line 25: the tilt during measurement is 15 degrees; it is not"},
        Case{"power", [](P& p) { p.lamps = {"1\nLED\n1000\n3000\n80\n-7"}; }, "line 32: the lamps' power is -7 W"},
        Case{"nadir", [](P& p) { p.isym = "0", p.c = {0, 180}, p.intensity = {300, 200, 0, 290, 200, 0}; },
             "line 47: at the nadir, which is one direction, the planes are from 290 to 300 cd"},
        Case{"dark", [](P& p) { p.intensity = {0, 0, 0}; }, "line 46: all intensities are 0"},
        Case{"short_range", [](P& p) { p.gamma = {0, 45, 80}; }, "line 46: the angles gamma from 0 to 80"},
        Case{"trailing", [](P& p) { p.end = "5\n\n6\n"; }, "line 49: 2 lines follow the intensities"},
        Case{"closed", [](P& p) { p.isym = "0", p.c = {0, 180, 360}, p.intensity = {3, 2, 0, 3, 1, 0, 3, 2, 0}; },
             "line 48: the C angles end with 360"}),
    case_name);

// A narrow slot, a pinhole in a spotlight, a light-emitting diode.
TEST(EulumdatMalformed, SmallOpeningsInMillimetresNeedNoWarning) {
  EulumdatParts parts;
  for (const auto& [size, area] : {std::pair{"1200\n60\n60", "1150\n0.8"}, std::pair{"120\n0\n150", "4\n0"},
                                   std::pair{"3.5\n2.8\n0.7", "1\n1"}, std::pair{"0\n0\n0", "0.6\n0.3"},
                                   std::pair{"600\n600\n80", "0\n0"}}) {
    parts.size = size, parts.area = area;
    EXPECT_TRUE(read_text(parts.text()).warnings.empty()) << size << ", " << area;
  }
}

TEST(EulumdatMalformed, ATiltChangesNothingAndSaysSo) {
  ReadOptions options;
  options.tilt_deg = 20;
  EXPECT_TRUE(has_warning(read_text(EulumdatParts().text(), options), "line 25: there is no TILT table"));
}

TEST(EulumdatMalformed, LightOutputRatioWithinTwoPercentIsNoWarning) {
  EulumdatParts parts;
  const double percent = read_text(parts.text()).distribution.band_flux_lm() / 10;  // of 1000 lm
  for (const auto& [factor, warnings] : {std::pair{1.0, 0u}, std::pair{1.019, 0u}, std::pair{1.03, 1u}}) {
    parts.lor = std::to_string(percent / factor);
    EXPECT_EQ(read_text(parts.text()).warnings.size(), warnings) << factor;
  }
}

TEST(EulumdatMalformed, StatementsThatAgreeAreNoWarning) {
  EulumdatParts parts;
  for (const char* dff : {"", "100", "98.5"}) {
    parts.dff = dff;
    EXPECT_TRUE(read_text(parts.text()).warnings.empty()) << dff;
  }
  parts.dg = "45";
  EXPECT_TRUE(read_text(parts.text()).warnings.empty());
  parts.dg = "33.33", parts.gamma = {0, 33.33, 66.67}, parts.intensity = {300, 200, 0};
  EXPECT_EQ(read_text(parts.text()).warnings.size(), 1u) << "that the angles end early, alone";
}

TEST(EulumdatMalformed, EmptyIntensitiesAreZeroWithAWarning) {
  EulumdatParts parts;
  parts.intensity = {300, 200};
  const Photometry p = read_text(parts.text() + "\n" + "\n");
  ASSERT_EQ(p.warnings.size(), 1u);
  EXPECT_EQ(p.warnings[0], "line 49: 1 intensity is an empty line; taken as 0");
}

// Any bytes give a distribution or one of the two errors. Fixed seed.
TEST(EulumdatMalformed, BrokenBytesNeverCrash) {
  std::mt19937 random(1);
  const std::string whole = EulumdatParts().text();
  int read_count = 0, refused = 0;
  for (int i = 0; i < 20000; ++i) {
    std::string text = whole.substr(0, i % 4 == 0 ? random() % whole.size() : whole.size());
    for (uint32_t k = random() % 6; k > 0 && !text.empty(); --k) text[random() % text.size()] = char(random());
    try {
      read_eulumdat(text.data(), text.size());
      ++read_count;
    } catch (const ParseError& e) {
      EXPECT_EQ(std::string(e.what()).rfind("line ", 0), 0u) << e.what();
      ++refused;
    }
  }
  EXPECT_GT(read_count, 100);
  EXPECT_GT(refused, 100);
  EXPECT_THROW(read_eulumdat(nullptr, 0), ParseError);
}

}  // namespace
}  // namespace photometry
