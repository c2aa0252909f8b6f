// Do files of every edition read as they should: flux, symmetry, opening, keywords, TILT?
#include <sstream>

#include "photometry/files.h"

namespace photometry {
namespace {

using namespace test;

constexpr double lambertian_lm = 3141.593;

struct FluxCase {
  const char* file;
  double flux_lm;
  const char* format;
};

class IesFlux : public testing::TestWithParam<FluxCase> {};

TEST_P(IesFlux, IsAsExpected) {
  const Photometry p = read_file(GetParam().file);
  EXPECT_NEAR(p.distribution.band_flux_lm() / GetParam().flux_lm, 1, 5e-4);
  EXPECT_EQ(p.format, GetParam().format);
}

INSTANTIATE_TEST_SUITE_P(
    Synthetic, IesFlux,
    testing::Values(FluxCase{"s01_lm63_1986.ies", 2827.43, "IES LM-63-1986"},          // count 1.0; ballast factor 0.9
                    FluxCase{"s02_iesna91_blpf_0p95.ies", 2984.51, "IES LM-63-1991"},  // ballast-lamp factor applies
                    FluxCase{"s03_lm63_1995.ies", lambertian_lm, "IES LM-63-1995"},
                    FluxCase{"s04_lm63_2002_feet.ies", lambertian_lm, "IES LM-63-2002"},
                    FluxCase{"s05_lm63_2019_filegen_1p1.ies", lambertian_lm, "IES LM-63-2019"},  // 1.1 is no factor
                    FluxCase{"s06_tilt_include.ies", lambertian_lm, "IES LM-63-2002"},
                    FluxCase{"s07_tilt_file.ies", lambertian_lm, "IES LM-63-1995"},
                    FluxCase{"s08_typeC_asym.ies", lambertian_lm, "IES LM-63-2002"},
                    FluxCase{"s11_commas_tabs_crlf.ies", lambertian_lm, "IES LM-63-2002"},
                    FluxCase{"s12_commas_no_space.ies", lambertian_lm, "IES LM-63-2002"},
                    FluxCase{"s13_bom_lf_trailing.ies", lambertian_lm, "IES LM-63-2002"},
                    FluxCase{"s14_latin1.ies", lambertian_lm, "IES LM-63-2002"},
                    FluxCase{"s15_missing_360.ies", lambertian_lm, "IES LM-63-2002"},
                    FluxCase{"s17_isotropic_10000lm.ies", 10000.00, "IES LM-63-2002"},
                    FluxCase{"s18_90_270.ies", lambertian_lm, "IES LM-63-1995"},
                    FluxCase{"s19_90_270_as_0_360.ies", lambertian_lm, "IES LM-63-2002"}),
    [](const auto& test) { return std::string(test.param.file).substr(0, 3); });

// The table of photometry/data/README.md: | `file` | what | opening | flux | peak |
TEST(Ies, ProfilesOfTheProjectHaveTheFluxThatTheyState) {
  std::istringstream readme(contents(PROFILE_DATA "/README.md"));
  int files = 0;
  for (std::string line; std::getline(readme, line);) {
    if (line.rfind("| `", 0) != 0) continue;
    std::istringstream row(line.substr(1));
    std::vector<std::string> cells;
    for (std::string cell; std::getline(row, cell, '|');) cells.push_back(cell);
    ASSERT_EQ(cells.size(), 5u);
    const std::string name = cells[0].substr(2, cells[0].rfind('`') - 2);
    const Photometry p = read_text(contents(PROFILE_DATA "/" + name));
    EXPECT_NEAR(p.distribution.band_flux_lm(), std::stod(cells[3]), 5e-4 * std::stod(cells[3])) << name;
    EXPECT_NEAR(p.distribution.peak_cd(), std::stod(cells[4]), 0.051) << name;
    EXPECT_TRUE(p.warnings.empty()) << name << ": " << p.warnings[0];
    ++files;
  }
  EXPECT_EQ(files, 3);
}

// Planes 90 to 270 mean I(C) = I(180 - C); a reader that relabels them turns the luminaire by 90 degrees.
TEST(Ies, Planes90To270AreMirroredNotTurned) {
  const Photometry a = read_file("s18_90_270.ies"), b = read_file("s19_90_270_as_0_360.ies");
  EXPECT_EQ(a.symmetry, Symmetry::c90_c270);
  EXPECT_EQ(b.symmetry, Symmetry::none);
  ASSERT_EQ(a.distribution.c_deg(), b.distribution.c_deg());
  ASSERT_EQ(a.distribution.gamma_deg(), b.distribution.gamma_deg());
  for (size_t c = 0; c < a.distribution.c_deg().size(); ++c)
    for (size_t g = 0; g < a.distribution.gamma_deg().size(); ++g)
      ASSERT_NEAR(a.distribution.at(c, g), b.distribution.at(c, g), 1.5e-3) << c << " " << g;  // written to 0.001
}

// I = 1000 f (1 + 0.25 a + 0.5 b): f down, a towards C0 = +x, b towards C90 = +y.
TEST(Ies, AsymmetricFileKeepsItsAxes) {
  for (const char* file : {"s08_typeC_asym.ies", "s15_missing_360.ies"}) {
    const Distribution d = read_file(file).distribution;
    for (double c : {0.0, 60.0, 90.0, 195.0, 270.0})
      for (double g : {0.0, 25.0, 45.0, 85.0}) {
        const double cr = c * M_PI / 180, gr = g * M_PI / 180;
        const double x = std::sin(gr) * std::cos(cr), y = std::sin(gr) * std::sin(cr), z = -std::cos(gr);
        EXPECT_NEAR(d.eval(x, y, z), -1000 * z * (1 + 0.25 * x + 0.5 * y), 1e-3) << file << " " << c << " " << g;
      }
  }
}

// Of the year some programs write two digits, and ANSI/ before all (before: read as 1986, whose twelfth number is a
// factor: 1.1 more light than there is, where it says how the file was made).
TEST(Ies, ReadsYearsOfTwoDigits) {
  const auto of = [](const std::string& version) {
    return read_text(version + "\n[TEST] x\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1.1 9\n0 90\n0\n9 9\n");
  };
  const double flux = of("IES:LM-63-2019").distribution.band_flux_lm();
  for (const char* version : {"IES:LM-63-19", "ANSI/IES LM-63-2019", "ANSI/IES LM-63-19", "IESNA:LM-63-02"}) {
    const Photometry p = of(version);
    EXPECT_EQ(p.format, std::string(version).ends_with("02") ? "IES LM-63-2002" : "IES LM-63-2019") << version;
    if (p.format != "IES LM-63-2019") continue;
    EXPECT_NEAR(p.distribution.band_flux_lm(), flux, 1e-9) << version;
    EXPECT_TRUE(p.warnings.empty()) << version;
  }
  EXPECT_EQ(of("IESNA:LM-63-95").format, "IES LM-63-1995");
}

TEST(Ies, ReadsKeywordsInAnyEncoding) {
  const std::string street =
      "Stra\xC3\x9F"
      "enleuchte 30\xC2\xB0";  // UTF-8
  EXPECT_EQ(keyword(read_file("s13_bom_lf_trailing.ies"), "LUMINAIRE"), street);
  EXPECT_EQ(keyword(read_file("s14_latin1.ies"), "LUMINAIRE"), street);
  // What only looks like UTF-8 (RFC 3629, section 4) is Latin-1, of which each byte is a letter.
  const auto with = [](const std::string& text) {
    return read_text("IESNA:LM-63-2002\n[TEST] " + text +
                     "\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0\n1 1 1\n0 90\n0\n1 1\n");
  };
  for (const std::string odd : {"\xC0\xA9", "\xC1\xBF", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xF0\x8F\xBF\xBF",
                                "\xF4\x90\x80\x80", "\xF5\x80\x80\x80"}) {
    std::string decoded;
    for (const char c : odd) decoded += char(0xC0 | (uint8_t(c) >> 6)), decoded += char(0x80 | (c & 0x3F));
    EXPECT_EQ(keyword(with(odd), "TEST"), decoded) << int(uint8_t(odd[0]));
  }
  for (const std::string fine : {"\xC2\x80", "\xE0\xA0\x80", "\xED\x9F\xBF", "\xF0\x90\x80\x80", "\xF4\x8F\xBF\xBF"})
    EXPECT_EQ(keyword(with(fine), "TEST"), fine);
  const Photometry p = read_file("s03_lm63_1995.ies");
  EXPECT_EQ(keyword(p, "TEST"), "synthetic");
  EXPECT_EQ(keyword(p, "MANUFAC"), "synthetic");
  EXPECT_EQ(p.input_power_w, 10);
  EXPECT_LT(p.rated_flux_lm, 0);
  EXPECT_TRUE(p.warnings.empty());
  EXPECT_EQ(keyword(read_file("s01_lm63_1986.ies"), "LABEL"), "FREE TEXT LABEL");
  EXPECT_NEAR(read_file("s01_lm63_1986.ies").rated_flux_lm, 3490.66, 1e-9);
}

TEST(Ies, ReadsTiltTableAndIgnoresTiltInKeywords) {
  const Photometry p = read_file("s06_tilt_include.ies");
  EXPECT_EQ(keyword(p, "LUMINAIRE"), "text with TILT=NONE inside");
  EXPECT_EQ(p.tilt.lamp_geometry, 1);
  EXPECT_EQ(p.tilt.angle_deg, (std::vector<double>{0, 15, 30, 45, 60, 75, 90}));
  EXPECT_EQ(p.tilt.factor, (std::vector<double>{1, .95, .94, .9, .88, .87, .98}));
  EXPECT_TRUE(has_warning(p, "line 7: the TILT factors"));
  EXPECT_TRUE(has_warning(read_file("s07_tilt_file.ies"), "line 6: the TILT file \"mh400.tlt\""));
}

TEST(Ies, ReadsATiltFileAndAppliesItWhereAsked) {
  const std::string text = data("s07_tilt_file.ies"), table = data("mh400.tlt");
  EXPECT_EQ(read_text(text).tilt_file_name, "mh400.tlt");
  EXPECT_TRUE(read_text(text).tilt.angle_deg.empty());
  ReadOptions options;
  options.tilt_file = table.data(), options.tilt_file_size = table.size();
  const Photometry p = read_text(text, options);
  EXPECT_EQ(p.tilt.factor, (std::vector<double>{1, .95, .94, .9, .88, .87, .98}));
  EXPECT_NEAR(p.distribution.band_flux_lm(), lambertian_lm, 0.01);
  const struct {
    double tilt_deg, factor;
  } cases[] = {{0, 1}, {15, .95}, {37.5, .92}, {90, .98}, {120, .98}};  // linear between; the last beyond
  for (const auto& c : cases) {
    options.tilt_deg = c.tilt_deg;
    const Photometry tilted = read_text(text, options);
    EXPECT_NEAR(tilted.distribution.band_flux_lm(), c.factor * p.distribution.band_flux_lm(), 1e-9) << c.tilt_deg;
    EXPECT_TRUE(tilted.tilt.angle_deg.empty()) << "the table no longer applies";
    EXPECT_TRUE(has_warning(tilted, "line 6: the intensities are multiplied by"));
  }
  ReadOptions included;
  included.tilt_deg = 45;
  EXPECT_NEAR(read_text(data("s06_tilt_include.ies"), included).distribution.band_flux_lm(), 0.9 * lambertian_lm, 0.01);
  const std::string broken = "1 3\n0 15 15\n1 1 1\n";
  options.tilt_file = broken.data(), options.tilt_file_size = broken.size();
  EXPECT_EQ(refusal<ParseError>(text, options).rfind("line 6: the TILT file \"mh400.tlt\": line 2: tilt angle 3", 0),
            0u);
}

TEST(Ies, ATiltWithoutATableIsAWarning) {
  ReadOptions options;
  options.tilt_deg = 30;
  const std::string without = data("s03_lm63_1995.ies"), missing = data("s07_tilt_file.ies");
  EXPECT_TRUE(warned(read_text(without, options), "there is no TILT table; the tilt of 30 degrees changes nothing"));
  EXPECT_FALSE(warned(read_text(without), "TILT"));
  EXPECT_TRUE(warned(read_text(missing, options), "is not read; taken as TILT=NONE"));
  EXPECT_FALSE(warned(read_text(missing), "which LM-63-2019 does not have"));
  const std::string of_2019 = "IES:LM-63-2019\n[TEST] x\nTILT=a.tlt\n1 -1 1 2 1 1 2 0 0 0\n1 1.1 9\n0 90\n0\n9 9\n";
  EXPECT_TRUE(has_warning(read_text(of_2019), "line 3: TILT= names a file, which LM-63-2019 does not have"));
}

TEST(Ies, OtherUnitsThanCandelasAreAWarning) {
  EXPECT_TRUE(has_warning(read_text("IESNA:LM-63-2002\n[_INTENSITYUNITS] mW/sr\nTILT=NONE\n1 -1 1 2 1 1 2 0 0 0 1 1 5\n"
                                    "0 90 0 1 1\n"),
                          "line 2: the file says that its intensities are in mW/sr"));
}

TEST(Ies, FeetBecomeMetres) {
  const Opening o = read_file("s04_lm63_2002_feet.ies").opening;
  EXPECT_EQ(o.shape, OpeningShape::disc);
  EXPECT_NEAR(o.size_m[0], 0.3048, 1e-7);
  EXPECT_NEAR(o.size_m[1], 0.3048, 1e-7);
  EXPECT_EQ(o.size_m[2], 0);
}

// A small file; `tail` follows the vertical angles.
std::string file(const std::string& version, const std::string& dimensions, const std::string& tail = "0\n100 50 0\n",
                 const std::string& counts = "3 1") {
  return version + "\n[TEST] x\nTILT=NONE\n1 -1 1 " + counts + " 1 2 " + dimensions + "\n1 1 10\n0 45 90\n" + tail;
}

struct OpeningCase {
  const char *version, *dimensions;
  OpeningShape shape;
  float x, y, z;  // length, width, height
  int axis = 2;
  bool warns = false;
};

class IesOpening : public testing::TestWithParam<OpeningCase> {};

TEST_P(IesOpening, IsAsTheEditionMeansIt) {
  const OpeningCase& c = GetParam();
  const Photometry p = read_text(file(c.version, c.dimensions));
  EXPECT_EQ(p.opening.shape, c.shape);
  EXPECT_FLOAT_EQ(p.opening.size_m[0], c.x);
  EXPECT_FLOAT_EQ(p.opening.size_m[1], c.y);
  EXPECT_FLOAT_EQ(p.opening.size_m[2], c.z);
  EXPECT_EQ(p.opening.axis, c.axis);
  EXPECT_EQ(has_warning(p, "line 4: the opening"), c.warns);
}

constexpr const char *e86 = "old file", *e91 = "IESNA91", *e95 = "IESNA:LM-63-1995", *e02 = "IESNA:LM-63-2002",
                     *e19 = "IES:LM-63-2019";
using S = OpeningShape;
INSTANTIATE_TEST_SUITE_P(
    Codes, IesOpening,
    testing::Values(
        // Width, length, height as written; length lies along x.
        OpeningCase{e86, "0 0 0", S::point, 0, 0, 0}, OpeningCase{e86, ".3 .6 0", S::rectangle, .6f, .3f, 0},
        OpeningCase{e86, ".3 .6 .1", S::box, .6f, .3f, .1f}, OpeningCase{e86, "-.2 0 0", S::disc, .2f, .2f, 0},
        OpeningCase{e91, "-.2 0 .4", S::cylinder, .2f, .2f, .4f}, OpeningCase{e91, "-.2 .3 0", S::disc, .3f, .2f, 0},
        OpeningCase{e91, "-.2 .3 .4", S::sphere, .3f, .2f, .4f}, OpeningCase{e95, "-.2 0 0", S::disc, .2f, .2f, 0},
        OpeningCase{e95, "-.2 0 -.2", S::sphere, .2f, .2f, .2f},
        OpeningCase{e95, "-.2 0 .5", S::cylinder, .2f, .2f, .5f},
        OpeningCase{e95, "0 1.2 -.1", S::cylinder, 1.2f, .1f, .1f, 0},
        OpeningCase{e95, "1.2 0 -.1", S::cylinder, .1f, 1.2f, .1f, 1},
        OpeningCase{e95, "-.2 .3 .4", S::cylinder, .3f, .2f, .4f},
        OpeningCase{e95, "-.2 .3 -.4", S::sphere, .3f, .2f, .4f}, OpeningCase{e02, "-.2 -.2 0", S::disc, .2f, .2f, 0},
        OpeningCase{e02, "-.2 -.3 0", S::disc, .3f, .2f, 0}, OpeningCase{e02, "-.2 -.2 .5", S::cylinder, .2f, .2f, .5f},
        OpeningCase{e02, "-.2 -.2 -.2", S::sphere, .2f, .2f, .2f},
        OpeningCase{e19, "-.1 1.2 -.1", S::cylinder, 1.2f, .1f, .1f, 0},
        OpeningCase{e19, "1.2 -.1 -.1", S::cylinder, .1f, 1.2f, .1f, 1},
        OpeningCase{e19, "-.2 0 -.2", S::disc, 0, .2f, .2f},
        // Codes of other editions, and of none.
        OpeningCase{e02, "-.2 0 0", S::disc, .2f, .2f, 0, 2, true},
        OpeningCase{e02, "0 1.2 -.1", S::cylinder, 1.2f, .1f, .1f, 0, true},
        OpeningCase{e95, "-.2 -.2 0", S::disc, .2f, .2f, 0, 2, true},
        OpeningCase{e02, "0 -.2 .3", S::box, .2f, 0, .3f, 2, true},
        // Sheets, upright too, and lines.
        OpeningCase{e02, "0 .6 .3", S::rectangle, .6f, 0, .3f}, OpeningCase{e02, ".6 0 .3", S::rectangle, 0, .6f, .3f},
        OpeningCase{e02, "0 1.2 0", S::rectangle, 1.2f, 0, 0}, OpeningCase{e02, "0 0 1.2", S::rectangle, 0, 0, 1.2f},
        OpeningCase{e95, "+.3 -.2 .4", S::cylinder, .2f, .3f, .4f},
        OpeningCase{e95, ".3 -.2 -.4", S::sphere, .2f, .3f, .4f},
        OpeningCase{e95, "-.2 .3 0", S::disc, .3f, .2f, 0}, OpeningCase{e95, ".3 -.2 0", S::disc, .2f, .3f, 0},
        OpeningCase{e02, "-.2 -.3 .5", S::cylinder, .3f, .2f, .5f},
        OpeningCase{e02, "-.2 -.3 -.5", S::sphere, .3f, .2f, .5f},
        OpeningCase{e02, "-.1 1.2 -.2", S::cylinder, 1.2f, .1f, .2f, 0},
        OpeningCase{e02, "1.2 -.1 -.2", S::cylinder, .1f, 1.2f, .2f, 1},
        OpeningCase{e02, "-.2 0 -.3", S::disc, 0, .2f, .3f}));

// The planes of a file by the range of its horizontal angles, at gamma = 45 degrees.
std::vector<std::pair<double, double>> planes(const Photometry& p) {
  std::vector<std::pair<double, double>> out;
  for (size_t c = 0; c < p.distribution.c_deg().size(); ++c)
    out.push_back({p.distribution.c_deg()[c], p.distribution.at(c, 1)});
  return out;
}

using Planes = std::vector<std::pair<double, double>>;

TEST(Ies, ExpandsSymmetries) {
  const Photometry quadrants = read_text(file(e02, "0 0 0", "0 30 90\n9 1 0\n9 2 0\n9 3 0\n", "3 3"));
  EXPECT_EQ(quadrants.symmetry, Symmetry::quadrants);
  EXPECT_EQ(planes(quadrants), (Planes{{0, 1}, {30, 2}, {90, 3}, {150, 2}, {180, 1}, {210, 2}, {270, 3}, {330, 2}}));
  const Photometry lateral = read_text(file(e02, "0 0 0", "0 30 180\n9 1 0\n9 2 0\n9 3 0\n", "3 3"));
  EXPECT_EQ(lateral.symmetry, Symmetry::c0_c180);
  EXPECT_EQ(planes(lateral), (Planes{{0, 1}, {30, 2}, {180, 3}, {330, 2}}));
  const Photometry bilateral = read_text(file(e95, "0 0 0", "90 180 240 270\n9 1 0\n9 2 0\n9 3 0\n9 4 0\n", "3 4"));
  EXPECT_EQ(bilateral.symmetry, Symmetry::c90_c270);
  EXPECT_EQ(planes(bilateral), (Planes{{0, 2}, {90, 1}, {180, 2}, {240, 3}, {270, 4}, {300, 3}}));
  EXPECT_TRUE(bilateral.warnings.empty());
  EXPECT_EQ(read_text(file(e02, "0 0 0")).symmetry, Symmetry::axial);
}

TEST(Ies, ExpandsOddRangesWithAWarning) {
  const Photometry p2002 = read_text(file(e02, "0 0 0", "90 180 270\n9 1 0\n9 2 0\n9 3 0\n", "3 3"));
  EXPECT_EQ(planes(p2002), (Planes{{0, 2}, {90, 1}, {180, 2}, {270, 3}}));
  EXPECT_TRUE(has_warning(p2002, "line 7: horizontal angles from 90 to 270"));
  const Photometry back = read_text(file(e02, "0 0 0", "180 240 360\n9 1 0\n9 2 0\n9 3 0\n", "3 3"));
  EXPECT_EQ(planes(back), (Planes{{0, 3}, {120, 2}, {180, 1}, {240, 2}}));
  EXPECT_TRUE(has_warning(back, "line 7: horizontal angles from 180 to 360"));
  // Without a plane at 0 the interpolated one is added: between 60 (3) and 300 (2) through 0.
  const Photometry right = read_text(file(e02, "0 0 0", "-90 -60 60 90\n9 1 0\n9 2 0\n9 3 0\n9 4 0\n", "3 4"));
  EXPECT_EQ(planes(right), (Planes{{0, 2.5}, {60, 3}, {90, 4}, {120, 3}, {240, 2}, {270, 1}, {300, 2}}));
  EXPECT_TRUE(has_warning(right, "line 7: horizontal angles from -90 to 90"));
  const Photometry open = read_text(file(e02, "0 0 0", "0 120 240\n9 1 0\n9 2 0\n9 3 0\n", "3 3"));
  EXPECT_EQ(planes(open), (Planes{{0, 1}, {120, 2}, {240, 3}}));
  EXPECT_TRUE(has_warning(open, "line 7: the plane 360 is missing"));
  const Photometry seam = read_text(file(e02, "0 0 0", "0 200 360\n9 1 0\n9 2 0\n9 3 0\n", "3 3"));
  EXPECT_EQ(planes(seam), (Planes{{0, 2}, {200, 2}}));
  EXPECT_TRUE(has_warning(seam, "line 7: the planes 0 and 360 differ"));
}

}  // namespace
}  // namespace photometry
