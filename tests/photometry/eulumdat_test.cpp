// Do EULUMDAT files read as they should: flux, symmetry, lamp sets, opening, keywords; and like their IES twins?
#include "photometry/eulumdat_parts.h"

namespace photometry {
namespace {

using namespace test;

constexpr double lambertian_lm = 3141.593;

TEST(Eulumdat, FluxIsAsExpected) {
  for (const char* file : {"l01_isym1.ldt", "l02_isym1_decimal_comma.ldt", "l03_isym0_asym.ldt", "l04_isym3.ldt",
                           "l05_isym3_absolute.ldt", "l06_cfli_2.ldt"}) {
    const Photometry p = read_file(file);
    EXPECT_EQ(p.format, "EULUMDAT") << file;
    // The files round to 0.001 cd/klm and state the lamps' flux to 0.001 lm;
    // the band rule of 5 degrees is exact to 1e-5.
    EXPECT_NEAR(p.distribution.band_flux_lm() / lambertian_lm, 1, 5e-5) << file;
    EXPECT_TRUE(p.warnings.empty()) << file << ": " << p.warnings[0];
    EXPECT_EQ(p.input_power_w, 10) << file;
    EXPECT_EQ(p.rated_flux_lm, std::string(file) == "l05_isym3_absolute.ldt" ? -1 : lambertian_lm) << file;
  }
}

// Written to 0.001 cd and 0.001 cd/klm: 0.001 + 0.0031 / 2 at most between them.
void expect_twins(const char* ldt, const char* ies) {
  const Distribution a = read_file(ldt).distribution, b = read_file(ies).distribution;
  ASSERT_EQ(a.c_deg(), b.c_deg());
  ASSERT_EQ(a.gamma_deg(), b.gamma_deg());
  for (size_t c = 0; c < a.c_deg().size(); ++c)
    for (size_t g = 0; g < a.gamma_deg().size(); ++g) ASSERT_NEAR(a.at(c, g), b.at(c, g), 2.5e-3) << c << " " << g;
}

TEST(Eulumdat, TwinsOfIesFilesAreTheSame) {
  expect_twins("l03_isym0_asym.ldt", "s08_typeC_asym.ies");
  expect_twins("l04_isym3.ldt", "s19_90_270_as_0_360.ies");
  expect_twins("l05_isym3_absolute.ldt", "s19_90_270_as_0_360.ies");
}

TEST(Eulumdat, KeywordsHaveTheNamesOfIes) {
  const Photometry p = read_file("l01_isym1.ldt");
  EXPECT_EQ(keyword(p, "MANUFAC"), "synthetic");
  EXPECT_EQ(keyword(p, "TEST"), "rep");
  EXPECT_EQ(keyword(p, "LUMINAIRE"), "name");
  EXPECT_EQ(keyword(p, "LUMCAT"), "no");
  EXPECT_EQ(keyword(p, "ISSUEDATE"), "date");
  EXPECT_EQ(keyword(p, "LAMP"), "LED");
  EXPECT_EQ(keyword(p, "_LENGTH_MM"), "600");
  ASSERT_EQ(p.lamp_sets.size(), 1u);
  EXPECT_EQ(p.lamp_sets[0].count, 1);
  EXPECT_EQ(p.lamp_sets[0].colour, "3000");
  EXPECT_EQ(p.lamp_sets[0].colour_rendering, "80");
}

using Planes = std::vector<std::pair<double, double>>;

Planes planes(const Photometry& p) {  // at the second gamma
  Planes out;
  for (size_t c = 0; c < p.distribution.c_deg().size(); ++c)
    out.push_back({p.distribution.c_deg()[c], p.distribution.at(c, 1)});
  return out;
}

TEST(Eulumdat, ExpandsSymmetries) {
  EulumdatParts parts;  // 1000 lm: the values are candelas
  parts.c = {0, 90, 180, 270}, parts.gamma = {0, 90};
  parts.isym = "0", parts.intensity = {9, 1, 9, 2, 9, 3, 9, 4};
  EXPECT_EQ(planes(read_text(parts.text())), (Planes{{0, 1}, {90, 2}, {180, 3}, {270, 4}}));
  parts.isym = "1", parts.intensity = {9, 5};
  EXPECT_EQ(planes(read_text(parts.text())), (Planes{{0, 5}}));
  EXPECT_EQ(read_text(parts.text()).symmetry, Symmetry::axial);
  parts.isym = "2", parts.intensity = {9, 1, 9, 2, 9, 3};
  EXPECT_EQ(planes(read_text(parts.text())), (Planes{{0, 1}, {90, 2}, {180, 3}, {270, 2}}));
  EXPECT_EQ(read_text(parts.text()).symmetry, Symmetry::c0_c180);
  parts.isym = "3";  // 270, 0, 90
  EXPECT_EQ(planes(read_text(parts.text())), (Planes{{0, 2}, {90, 3}, {180, 2}, {270, 1}}));
  EXPECT_EQ(read_text(parts.text()).symmetry, Symmetry::c90_c270);
  parts.isym = "4", parts.intensity = {9, 1, 9, 2};
  EXPECT_EQ(planes(read_text(parts.text())), (Planes{{0, 1}, {90, 2}, {180, 1}, {270, 2}}));
  EXPECT_EQ(read_text(parts.text()).symmetry, Symmetry::quadrants);
}

TEST(Eulumdat, IrregularPlanesAreTakenFromTheirList) {
  EulumdatParts parts;
  parts.c = {0, 10, 90, 170, 180, 190, 270, 350}, parts.gamma = {0, 90};
  parts.isym = "3", parts.intensity = {9, 1, 9, 2, 9, 3, 9, 4, 9, 5};  // 270, 350, 0, 10, 90
  EXPECT_EQ(planes(read_text(parts.text())),
            (Planes{{0, 3}, {10, 4}, {90, 5}, {170, 4}, {180, 3}, {190, 2}, {270, 1}, {350, 2}}));
  EXPECT_TRUE(read_text(parts.text()).warnings.empty());
}

TEST(Eulumdat, LampSetsAreAlternatives) {
  EulumdatParts parts;
  parts.lamps = {"1\nsmall\n1000\n3000\n80\n10", "2\nlarge\n3000\n4000\n90\n25"};
  const Photometry first = read_text(parts.text());
  EXPECT_EQ(first.rated_flux_lm, 1000);
  EXPECT_EQ(first.input_power_w, 10);
  EXPECT_TRUE(has_warning(first, "line 26: 2 lamp sets, which are alternatives; number 1 is taken: small, 1000 lm"));
  ReadOptions options;
  options.lamp_set = 1;
  const Photometry second = read_text(parts.text(), options);
  EXPECT_EQ(second.rated_flux_lm, 3000);
  EXPECT_EQ(second.input_power_w, 25);
  EXPECT_EQ(keyword(second, "LAMP"), "large");
  EXPECT_NEAR(second.distribution.peak_cd(), 3 * first.distribution.peak_cd(), 1e-9);
  EXPECT_EQ(second.lamp_sets.size(), 2u);
  options.lamp_set = 2;
  EXPECT_EQ(refusal<std::invalid_argument>(parts.text(), options), "lamp_set is 2; the file has 2 sets, from 0");
  parts.lamps = {"1\n2\nsmall\nlarge\n1000\n3000", "3000\n4000\n80\n90\n10\n25"};
  const Photometry grouped = read_text(parts.text());
  EXPECT_TRUE(has_warning(grouped, "line 26: the lamp sets are given field by field"));
  ASSERT_EQ(grouped.lamp_sets.size(), 2u);
  EXPECT_EQ(grouped.lamp_sets[1].type, "large");
  EXPECT_EQ(grouped.lamp_sets[1].flux_lm, 3000);
  EXPECT_EQ(grouped.lamp_sets[1].power_w, 25);
}

TEST(Eulumdat, OpeningIsInMetresLengthAlongC90) {
  const struct {
    const char *area, *heights;
    OpeningShape shape;
    float x, y, z;
    const char* warning;
  } cases[] = {
      {"600\n300", "0\n0\n0\n0", OpeningShape::rectangle, .3f, .6f, 0, nullptr},
      {"600\n300", "50\n50\n50\n50", OpeningShape::box, .3f, .6f, .05f, nullptr},
      {"600\n300", "0\n50\n0\n20", OpeningShape::box, .3f, .6f, .05f,
       "line 21: the luminous heights are from 0 to 50 mm"},
      {"600\n0", "0\n0\n0\n0", OpeningShape::disc, .6f, .6f, 0, nullptr},
      {"600\n", "80\n80\n80\n80", OpeningShape::cylinder, .6f, .6f, .08f, nullptr},
      {"0\n0", "0\n0\n0\n0", OpeningShape::point, 0, 0, 0, nullptr},
      {"0\n0", "9\n9\n9\n9", OpeningShape::point, 0, 0, 0, "line 21: luminous heights without"},
      {"-60\n30", "0\n0\n0\n0", OpeningShape::rectangle, .03f, .06f, 0, "line 16: the luminous length is -60 mm"},
      {"60000\n30", "0\n0\n0\n0", OpeningShape::rectangle, .03f, 60, 0, "line 16: the luminous length of 60000 mm"},
  };
  for (const auto& c : cases) {
    EulumdatParts parts;
    parts.area = c.area, parts.heights = c.heights;
    const Photometry p = read_text(parts.text());
    EXPECT_EQ(p.opening.shape, c.shape) << c.area;
    EXPECT_FLOAT_EQ(p.opening.size_m[0], c.x);
    EXPECT_FLOAT_EQ(p.opening.size_m[1], c.y);
    EXPECT_FLOAT_EQ(p.opening.size_m[2], c.z);
    EXPECT_EQ(p.opening.axis, 2);
    if (c.warning)
      EXPECT_TRUE(has_warning(p, c.warning)) << c.warning;
    else
      EXPECT_TRUE(p.warnings.empty()) << p.warnings[0];
  }
}

TEST(Eulumdat, SameDataInOtherWordsNeedsNoWarning) {
  EulumdatParts reference, other;
  other.mc = " 1,0 ", other.type = "1.", other.lamps = {"1\nLED\n1_000,0\n3000\n80\n10"};
  other.end = "\n\n  \n\x1a junk\n";
  const Photometry p = read_text(other.text());
  EXPECT_TRUE(p.warnings.empty()) << p.warnings[0];
  expect_same(p.distribution, read_text(reference.text()).distribution);
}

TEST(Eulumdat, ReadsLatin1) {
  EulumdatParts parts;
  parts.name = "Leuchte f\xFCr 30\xB0";
  EXPECT_EQ(keyword(read_text(parts.text()), "LUMINAIRE"), "Leuchte f\xC3\xBCr 30\xC2\xB0");
}

}  // namespace
}  // namespace photometry
