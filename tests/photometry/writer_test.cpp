// Does what the writers write read back as the same light, the same lamps, the same opening, in the fewest planes?
#include <algorithm>
#include <filesystem>

#include "photometry/c_gamma.h"
#include "photometry/eulumdat_parts.h"
#include "photometry/text_reader.h"

namespace photometry {
namespace {

using namespace test;

Photometry again(const std::string& text) { return read_text(text); }

void expect_round_trip(const Photometry& p, const std::string& name) {
  SCOPED_TRACE(name);
  const Photometry ies = again(write_ies(p));
  EXPECT_EQ(ies.format, "IES LM-63-2019");
  EXPECT_TRUE(std::none_of(ies.warnings.begin(), ies.warnings.end(), [](const std::string& w) {
    return w.find("opening") != w.npos || w.find("angle") != w.npos || w.find("plane") != w.npos;
  })) << ies.warnings[0];
  EXPECT_NEAR(ies.rated_flux_lm, p.rated_flux_lm, 1e-12 * std::abs(p.rated_flux_lm));
  EXPECT_EQ(ies.input_power_w, p.input_power_w);
  EXPECT_EQ(ies.opening.shape, p.opening.shape);
  for (int k = 0; k < 3; ++k) EXPECT_EQ(ies.opening.size_m[k], p.opening.size_m[k]) << k;
  EXPECT_EQ(ies.opening.axis, p.opening.axis);
  EXPECT_EQ(keyword(ies, "LUMCAT"), keyword(p, "LUMCAT"));
  EXPECT_EQ(ies.tilt.factor, p.tilt.factor);
  expect_same(ies.distribution, p.distribution);
  const Photometry ldt = again(write_eulumdat(p));
  EXPECT_EQ(ldt.format, "EULUMDAT");
  EXPECT_TRUE(ldt.warnings.empty()) << ldt.warnings[0];
  EXPECT_EQ(ldt.rated_flux_lm, p.rated_flux_lm);
  EXPECT_EQ(ldt.input_power_w, p.input_power_w);
  expect_same(ldt.distribution, in_c_gamma(p.distribution), six_characters);
}

TEST(Writer, EveryTestFileReadsBack) {
  int files = 0;
  for (const char* folder : {TEST_DATA, PROFILE_DATA})
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string(), extension = entry.path().extension().string();
      if ((extension != ".ies" && extension != ".ldt") || name.rfind("s16", 0) == 0) continue;
      expect_round_trip(read_text(contents(entry.path().string())), name);
      ++files;
    }
  EXPECT_EQ(files, 27);
}

TEST(Writer, OpeningsOfAllCodesReadBack) {
  const float sizes[][3] = {{.3f, .2f, .1f}, {.2f, .2f, .1f}, {.2f, .2f, .2f},
                            {.3f, .2f, 0},   {.2f, .2f, 0},   {0, .2f, .1f}};
  for (OpeningShape shape : {OpeningShape::rectangle, OpeningShape::disc, OpeningShape::box, OpeningShape::cylinder,
                             OpeningShape::sphere})
    for (const auto& size : sizes)
      for (int axis = 0; axis < 3; ++axis)
        for (PhotometricType type : {PhotometricType::c, PhotometricType::b, PhotometricType::a}) {
          const bool solid = size[0] > 0 && size[2] > 0,
                     flat = shape == OpeningShape::rectangle || shape == OpeningShape::disc;
          if (solid == flat || (axis != 2 && shape != OpeningShape::cylinder)) continue;
          if (type == PhotometricType::a && size[0] == 0) continue;  // a sheet edge-on to the aim has no code
          Photometry p{type == PhotometricType::c ? Distribution({0}, {0, 90}, {1, 1})
                                                  : Distribution(type, {-90, 90}, {-90, 90}, {1, 2, 3, 4})};
          p.type = type;
          p.opening.shape = shape;
          p.opening.axis = axis;
          std::copy(size, size + 3, p.opening.size_m);
          const Opening o = again(write_ies(p)).opening;
          EXPECT_EQ(o.shape, shape) << write_ies(p);
          EXPECT_EQ(o.size_m[0], size[0]);
          EXPECT_EQ(o.size_m[1], size[1]);
          EXPECT_EQ(o.size_m[2], size[2]);
          EXPECT_TRUE(o.axis == axis || shape != OpeningShape::cylinder);
        }
}

// The line of ten fields has the counts; line 3 to 6 of an EULUMDAT file.
TEST(Writer, SymmetriesTakeTheFewestPlanes) {
  const auto table = [](double (*intensity)(double)) {
    std::vector<double> c, cd;
    for (int i = 0; i < 24; ++i) c.push_back(15 * i), cd.push_back(10), cd.push_back(intensity(rad(15 * i)));
    return Photometry{Distribution(c, {0, 90}, cd)};
  };
  const struct {
    double (*intensity)(double);
    const char *ies, *ldt;
  } cases[] = {
      {[](double) { return 5.0; }, " 2 1 1 2\r\n", "\r\n1\r\n1\r\n0\r\n"},
      {[](double c) { return 5 + std::round(1000 * std::cos(2 * c)) / 1000; }, " 2 7 1 2\r\n", "\r\n4\r\n24\r\n15\r\n"},
      {[](double c) { return 5 + std::round(1000 * std::cos(c)) / 1000; }, " 2 13 1 2\r\n", "\r\n2\r\n24\r\n15\r\n"},
      {[](double c) { return 5 + std::round(1000 * std::sin(c)) / 1000; }, " 2 25 1 2\r\n", "\r\n3\r\n24\r\n15\r\n"},
      {[](double c) { return 5 + std::cos(c) + std::sin(2 * c); }, " 2 25 1 2\r\n", "\r\n0\r\n24\r\n15\r\n"},
  };
  for (const auto& c : cases) {
    const Photometry p = table(c.intensity);
    EXPECT_NE(write_ies(p).find(c.ies), std::string::npos) << write_ies(p).substr(0, 300);
    EXPECT_NE(write_eulumdat(p).find(c.ldt), std::string::npos) << write_eulumdat(p).substr(0, 60);
    if (std::string(c.ies) == " 2 1 1 2\r\n") continue;  // one plane for 24
    expect_same(again(write_ies(p)).distribution, p.distribution);
    expect_same(again(write_eulumdat(p)).distribution, p.distribution, six_characters);
  }
  std::vector<double> c, cd;  // 5.625 degrees fit their field, 354.375 do not
  for (int i = 0; i < 64; ++i)
    c.push_back(5.625 * i), cd.push_back(10), cd.push_back(5 + std::round(1000 * std::cos(2 * rad(c[size_t(i)]))) / 1000);
  const Photometry fine{Distribution(c, {0, 90}, cd)};
  EXPECT_NE(write_eulumdat(fine).find("\r\n4\r\n64\r\n"), std::string::npos) << write_eulumdat(fine).substr(0, 60);
  EXPECT_EQ(again(write_eulumdat(fine)).symmetry, Symmetry::quadrants);
}

// Planes that lack the place where mirror images meet, or are not evenly spaced, are written whole.
TEST(Writer, OddPlanesReadBack) {
  for (const Distribution& d :
       {Distribution({0, 120, 240}, {0, 90}, {1, 2, 1, 3, 1, 3}), Distribution({0, 180}, {0, 90}, {1, 2, 1, 3}),
        Distribution({0, 359.95}, {0, 0.0005, 90}, {1, 2, 3, 4, 5, 6}),
        Distribution({0, 90, 180, 270}, {90, 180}, {1, 2, 3, 4, 5, 6, 7, 8})}) {
    expect_same(again(write_ies(Photometry{d})).distribution, d);
    expect_same(again(write_eulumdat(Photometry{d})).distribution, d, six_characters);
  }
}

// An angle of six characters would be the circle's end.
TEST(Writer, OnePlaneStandsForAllWhateverItsAngle) {
  const Distribution d({359.9999}, {0, 90}, {1, 2}), axial({0}, {0, 90}, {1, 2});
  expect_same(again(write_eulumdat(Photometry{d})).distribution, axial, six_characters);
}

TEST(Writer, AnOpeningOfAnotherShapeIsTold) {
  Photometry p{Distribution({0}, {0, 90}, {1, 2})};
  p.opening = {OpeningShape::cylinder, {1.2, 0.03, 0.03}, 0};
  std::vector<std::string> ies, ldt;
  write_ies(p, &ies), write_eulumdat(p, &ldt);
  EXPECT_TRUE(ies.empty()) << ies[0];
  ASSERT_EQ(ldt.size(), 1u);
  EXPECT_NE(ldt[0].find("the opening of the written file has"), std::string::npos) << ldt[0];
  p.opening = {OpeningShape::box, {1.2, 0.3, 0.03}, 2};
  write_eulumdat(p, &(ldt = {}));
  EXPECT_TRUE(ldt.empty()) << ldt[0];
}

TEST(Writer, AMakersNameMayBeginAsRayFilesDo) {
  for (const char* maker : {"LTRF GmbH", "TM25 Ltd"}) {
    Photometry p{Distribution({0}, {0, 90}, {1, 2})};
    p.keywords.push_back({"MANUFAC", maker});
    std::vector<std::string> warnings;
    const std::string text = write_eulumdat(p, &warnings);
    EXPECT_TRUE(warnings.empty()) << warnings[0];
    EXPECT_EQ(keyword(again(text), "MANUFAC"), maker);
  }
}

// Which the reader of EULUMDAT would refuse.
TEST(Writer, AnOpenCircleHasAnInterpolatedPlaneMore) {
  const Distribution d({0, 90}, {10, 20}, {1, 2, 3, 4});
  expect_same(again(write_ies(Photometry{d})).distribution, d);
  const Photometry p = again(write_eulumdat(Photometry{d}));
  expect_same(p.distribution, Distribution({0, 90, 225}, {10, 20}, {1, 2, 3, 4, 2, 3}), six_characters);
  expect_same(again(write_eulumdat(p)).distribution, p.distribution, six_characters);
}

TEST(Writer, TypesAAndBAreWrittenAsTheyAre) {
  for (const char* file : {"s09_typeB_asym.ies", "s10_typeA_asym.ies"}) {
    const Photometry p = read_file(file), q = again(write_ies(p));
    EXPECT_EQ(q.type, p.type);
    expect_same(q.distribution, p.distribution);
    EXPECT_EQ(q.distribution.band_flux_lm(), p.distribution.band_flux_lm());
  }
  for (PhotometricType type : {PhotometricType::a, PhotometricType::b}) {
    const Photometry p{
        Distribution(type, {-90, 0, 90}, {-90, -30, 0, 30, 90}, {1, 2, 3, 2, 1, 4, 5, 6, 5, 4, 1, 2, 3, 2, 1})};
    const std::string text = write_ies(p);
    EXPECT_NE(text.find(type == PhotometricType::a ? " 3 2 3 2\r\n" : " 2 3 2 2\r\n"), std::string::npos) << text;
    expect_same(again(text).distribution, p.distribution);
  }
  EXPECT_THROW(write_ies(Photometry{Distribution(PhotometricType::b, {0, 90}, {-90, 90}, {1, 2, 3, 4})}),
               std::invalid_argument);
}

// exp(-r^2 / 2) with r in degrees from (h0, v0): cd at the angles of a table that is fine there alone.
Photometry narrow_beam(PhotometricType type, double h0, double v0) {
  const auto angles = [](double centre) {
    std::vector<double> out;
    for (double a = -90; a <= 90; a += 5)
      if (std::abs(a - centre) >= 5) out.push_back(a);
    for (double a = centre - 4.5; a <= centre + 4.5; a += 0.5) out.push_back(a);
    std::sort(out.begin(), out.end());
    return out;
  };
  const bool type_a = type == PhotometricType::a;
  const double plane0 = type_a ? h0 : v0, row0 = type_a ? v0 : h0;
  const std::vector<double> planes = angles(plane0), rows = angles(row0);
  std::vector<double> cd;
  for (double p : planes)
    for (double r : rows) {
      const double away = std::pow(p - plane0, 2) + std::pow(r - row0, 2);
      cd.push_back(std::round(1e10 * std::exp(-away / 2)) / 1e4);
    }
  Photometry out{Distribution(type, planes, rows, cd)};
  out.type = type;
  return out;
}

// A beam of 2.4 degrees, ahead and 54 degrees off, and a wide table of 5 degrees.
TEST(Writer, ResampledTablesKeepFluxAndPeak) {
  std::vector<Photometry> all;
  for (PhotometricType type : {PhotometricType::a, PhotometricType::b})
    for (double angle : {0, 40}) all.push_back(narrow_beam(type, angle, angle));
  for (const char* file : {"s09_typeB_asym.ies", "s10_typeA_asym.ies"}) all.push_back(read_file(file));
  for (const Photometry& p : all) {
    std::vector<std::string> warnings;
    const Photometry q = again(write_eulumdat(p, &warnings));
    const Distribution &before = p.distribution, &after = q.distribution;
    EXPECT_NEAR(after.band_flux_lm() / before.band_flux_lm(), 1, 1e-3);
    EXPECT_NEAR(after.peak_cd() / before.peak_cd(), 1, 1e-3);
    EXPECT_TRUE(warnings.empty()) << warnings[0];
    ASSERT_EQ(q.lamp_sets.size(), 1u);
    EXPECT_NEAR(q.lamp_sets[0].flux_lm / before.band_flux_lm(), 1, 1e-9) << "the flux of the source is stated";
  }
  const Photometry ahead = again(write_eulumdat(narrow_beam(PhotometricType::b, 0, 0)));
  EXPECT_EQ(ahead.symmetry, Symmetry::quadrants) << "the mirror images of the source are kept";
}

// What no angles of six characters hold: light that ends where a table ends, on a slanting line.
TEST(Writer, WhatAFileLacksIsTold) {
  Photometry p{Distribution(PhotometricType::b, {20, 20.2}, {30, 30.2}, {1000, 1000, 1000, 1000})};
  p.type = PhotometricType::b;
  p.keywords = {{"LUMCAT", std::string(80, 'x')}, {"_FILENAME", "twelve chars"}};
  p.opening.shape = OpeningShape::rectangle;
  p.opening.size_m[0] = 0.5f, p.opening.size_m[1] = 12;
  std::vector<std::string> warnings;
  const Photometry q = again(write_eulumdat(p, &warnings));
  const auto told = [&](const std::string& start) {
    return std::any_of(warnings.begin(), warnings.end(), [&](const std::string& w) { return w.rfind(start, 0) == 0; });
  };
  EXPECT_TRUE(told("the luminaire's number is cut to the 78 characters of the format: \"" + std::string(78, 'x') + "\""));
  EXPECT_TRUE(told("the file's name is cut to the 8 characters of the format: \"twelve c\""));
  EXPECT_TRUE(told("the luminous length in mm, 12000, does not fit the 4 characters of the format; 9999 is written"));
  const double before = p.distribution.band_flux_lm(), after = q.distribution.band_flux_lm();
  ASSERT_GT(std::abs(after / before - 1), 1e-3) << "a case that parts";
  EXPECT_TRUE(told("the flux of the written table is " + shown(after) + " lm, that of the light " + shown(before) + " lm"));
  warnings.clear();
  write_ies(p, &warnings);
  EXPECT_TRUE(warnings.empty()) << warnings[0];
}

// The lengths of the format's description, line by line; of the counts Mc and Ng it has two, see eulumdat_writer.cpp.
void expect_field_lengths(const std::string& text) {
  std::vector<size_t> lengths = {78, 1, 1, 3, 5, 3, 5, 78, 78, 78, 8, 78, 4, 4, 4, 4, 4,  4, 4, 4, 4,
                                 4,  4, 6, 6, 4, 4, 24, 12, 16, 6,  8, 7, 7, 7, 7, 7, 7, 7, 7, 7, 7};
  size_t line = 0;
  for (size_t at = 0; at < text.size(); ++line) {
    const size_t end = text.find("\r\n", at);
    ASSERT_NE(end, text.npos) << "every line ends";
    ASSERT_LE(end - at, line < lengths.size() ? lengths[line] : 6) << "line " << line + 1 << ": " << text.substr(at, 90);
    at = end + 2;
  }
  EXPECT_GT(line, lengths.size());
}

TEST(Writer, EveryEulumdatFieldHasItsLength) {
  for (const char* folder : {TEST_DATA, PROFILE_DATA})
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      const std::string name = entry.path().filename().string(), extension = entry.path().extension().string();
      if ((extension != ".ies" && extension != ".ldt") || name.rfind("s16", 0) == 0) continue;
      SCOPED_TRACE(name);
      expect_field_lengths(write_eulumdat(read_text(contents(entry.path().string()))));
    }
  Photometry odd{Distribution({0, 360.0 / 7, 1000.0 / 7, 333.3333}, {0, 1.0 / 3, 100.0 / 3, 122.12345, 179.99999},
                              {1e9 / 7, 1, 2, 3, 4, 5, 6, 7, 8, 9, 0.1, 0.12345678, 1 / 3., 12345.678, 0, 1, 2, 3, 4, 5})};
  odd.rated_flux_lm = 1234567.8912345, odd.input_power_w = 1e5 / 3;
  odd.lamp_sets = {{12345, "a lamp of a name longer than it may be", 1234567.8912345, "warm white, tunable", "excellent"}};
  odd.opening.shape = OpeningShape::box;
  odd.opening.size_m[0] = 0.3048f, odd.opening.size_m[1] = 1.2192f, odd.opening.size_m[2] = 1e-7f;
  odd.keywords = {{"MANUFAC", std::string(100, 'm')}, {"_TILT_DEG", "0.123456789"}, {"_LENGTH_MM", "1234.56"},
                  {"_DIRECT_RATIOS", "0.123456789 1e-9 3 4 5 6 7 8 9 10"}};
  expect_field_lengths(write_eulumdat(odd));
  const Photometry q = again(write_eulumdat(odd));
  EXPECT_EQ(q.opening.shape, OpeningShape::box) << "no size becomes 0";
  EXPECT_NEAR(q.opening.size_m[0], 0.3048, 0.0005);
  EXPECT_NEAR(q.distribution.peak_cd(), 1e9 / 7, 1e-4 * 1e9 / 7);
  for (double peak : {1e-3, 1e3, 1e9}) {  // a conversion factor keeps five digits
    Photometry p{Distribution({0}, {0, 30, 90}, {peak, 0.7654321 * peak, 0})};
    p.rated_flux_lm = 5000;
    expect_field_lengths(write_eulumdat(p));
    expect_same(again(write_eulumdat(p)).distribution, p.distribution, six_characters);
  }
}

// Width 0 would make a luminaire round, and of no size.
TEST(Writer, EulumdatOfABodyThatNobodyStatedHasItsOpenings) {
  Photometry p{Distribution({0}, {0, 90}, {100, 0})};
  p.opening.shape = OpeningShape::rectangle;
  p.opening.size_m[0] = 0.6f, p.opening.size_m[1] = 0.3f;
  Photometry ldt = again(write_eulumdat(p));
  EXPECT_EQ(keyword(ldt, "_LENGTH_MM"), "300");
  EXPECT_EQ(keyword(ldt, "_WIDTH_MM"), "600");
  EXPECT_EQ(keyword(ldt, "_HEIGHT_MM"), "(none)");
  p.keywords = {{"_LENGTH_MM", "400"}, {"_HEIGHT_MM", "50"}};
  ldt = again(write_eulumdat(p));
  EXPECT_EQ(keyword(ldt, "_LENGTH_MM"), "400");
  EXPECT_EQ(keyword(ldt, "_WIDTH_MM"), "(none)") << "0: round";
  EXPECT_EQ(keyword(ldt, "_HEIGHT_MM"), "50");
}

TEST(Writer, EulumdatOfWhatEndsAboveTheHorizonGoesDown) {
  for (const double last : {60.0, 85.0}) {
    const std::vector<double> g = steps(0, last, size_t(last / 5));
    const Photometry ldt = again(write_eulumdat(Photometry{Distribution({0}, g, std::vector<double>(g.size(), 100.0))}));
    EXPECT_EQ(keyword(ldt, "_DFF_PERCENT"), "100") << last;
    for (const std::string& w : ldt.warnings) EXPECT_EQ(w.find("downward"), w.npos) << w;
  }
}

TEST(Writer, LinesOfIesFilesAreShort) {
  Photometry p{Distribution({0, 90}, steps(0, 90, 500), std::vector<double>(1002, 1 / 3.))};
  std::string words;
  for (int i = 0; i < 120; ++i) words += "word" + std::to_string(i) + " ";
  words += "end";
  p.keywords = {{"OTHER", words}, {"LUMCAT", std::string(600, 'x')}, {"LUMINAIRE", ""}};
  for (int i = 0; i < 300; ++i) p.keywords[2].value += "\xC3\xA4";
  const std::string text = write_ies(p);
  for (size_t at = 0; at < text.size();) {
    const size_t end = text.find("\r\n", at);
    ASSERT_NE(end, text.npos);
    EXPECT_LE(end + 2 - at, 256u) << text.substr(at, end - at);
    at = end + 2;
  }
  const Photometry q = again(text);
  EXPECT_EQ(keyword(q, "OTHER"), words);
  std::string catalogue = keyword(q, "LUMCAT");
  EXPECT_EQ(std::count(catalogue.begin(), catalogue.end(), 'x'), 600) << "without blanks there is no place to part";
  EXPECT_EQ(keyword(q, "LUMINAIRE").find("\xC3 "), std::string::npos) << "no character is parted";
}

TEST(Writer, KeywordsLampsAndCodesAreKept) {
  const Photometry p = read_file("s05_lm63_2019_filegen_1p1.ies");
  EXPECT_DOUBLE_EQ(p.file_generation, 1.1);
  EXPECT_DOUBLE_EQ(again(write_ies(p)).file_generation, 1.1);
  Photometry own{Distribution({0}, {0, 90}, {100, 0})};
  EXPECT_DOUBLE_EQ(again(write_ies(own)).file_generation, 1.00001) << "undefined";
  own.file_generation = 1.0001;  // computer simulation
  own.keywords = {{"LUMCAT", "A\r\nTILT=INCLUDE"}, {"MANUFAC", "maker"}, {"MANUFAC", "second"}, {"LABEL", "free text"}};
  own.rated_flux_lm = 1800, own.input_power_w = 26;
  own.lamp_sets = {{2, "tube", 1800, "830", "1B", 26}};
  const Photometry q = again(write_ies(own));
  EXPECT_DOUBLE_EQ(q.file_generation, 1.0001);
  EXPECT_EQ(keyword(q, "LUMCAT"), "A  TILT=INCLUDE");
  EXPECT_EQ(keyword(q, "MANUFAC"), "maker");
  EXPECT_EQ(keyword(q, "TEST"), "not stated");
  EXPECT_EQ(keyword(q, "OTHER"), "free text");
  EXPECT_EQ(std::count_if(q.keywords.begin(), q.keywords.end(), [](const Keyword& k) { return k.name == "MANUFAC"; }),
            2);
  EXPECT_EQ(q.lamp_sets[0].count, 2);
  EXPECT_EQ(q.rated_flux_lm, 1800);
  const Photometry r = again(write_eulumdat(own));
  EXPECT_EQ(keyword(r, "MANUFAC"), "maker");
  EXPECT_EQ(r.lamp_sets[0].count, 2);
  EXPECT_EQ(r.lamp_sets[0].type, "tube");
  EXPECT_EQ(r.lamp_sets[0].colour, "830");
  EXPECT_EQ(r.lamp_sets[0].colour_rendering, "1B");
  EXPECT_EQ(r.rated_flux_lm, 1800);
}

TEST(Writer, EulumdatKeepsItsOwnFields) {
  const Photometry p = read_file("l03_isym0_asym.ldt"), q = again(write_eulumdat(p));
  ASSERT_EQ(p.keywords.size(), q.keywords.size());
  for (size_t i = 0; i < p.keywords.size(); ++i) {
    EXPECT_EQ(p.keywords[i].name, q.keywords[i].name);
    EXPECT_EQ(p.keywords[i].value, q.keywords[i].value) << p.keywords[i].name;
  }
  EulumdatParts parts;
  parts.name = "\374ber";  // Latin-1 stays Latin-1
  EXPECT_NE(write_eulumdat(read_text(parts.text())).find("\r\n\374ber\r\n"), std::string::npos);
  Photometry greek{Distribution({0}, {0, 90}, {1, 0})};
  greek.keywords = {{"LUMINAIRE", "\xCE\xBB"}};
  EXPECT_EQ(keyword(again(write_eulumdat(greek)), "LUMINAIRE"), "\xCE\xBB");
}

TEST(Writer, AbsoluteEulumdatStatesTheLuminairesFlux) {
  const Photometry p = read_file("s17_isotropic_10000lm.ies"), q = again(write_eulumdat(p));
  EXPECT_LT(q.rated_flux_lm, 0);
  ASSERT_EQ(q.lamp_sets.size(), 1u);
  EXPECT_EQ(q.lamp_sets[0].count, -1);
  EXPECT_NEAR(q.lamp_sets[0].flux_lm, 10000, 0.01);
  EXPECT_EQ(keyword(q, "_LORL_PERCENT"), "100");
  EXPECT_EQ(keyword(q, "_DFF_PERCENT"), "50");
}

// Intensities are per 1000 lm of what the field holds.
TEST(Writer, AFluxThatItsFieldCannotHoldIsRefused) {
  const std::string table = " 1 2 1 1 2 0 0 0\n1 1 1\n0 90\n0\n1e9 1e9\n";
  const auto file = [&](const char* lamps) {
    return read_text("IESNA:LM-63-2002\n[TEST] x\nTILT=NONE\n" + std::string(lamps) + table);
  };
  const Photometry fits = file("1 999999999999"), none = file("1000 1e12");
  EXPECT_EQ(again(write_eulumdat(fits)).rated_flux_lm, fits.rated_flux_lm);
  try {
    write_eulumdat(none);
    ADD_FAILURE() << "was written";
  } catch (const std::invalid_argument& e) {
    EXPECT_NE(std::string(e.what()).find("the flux, 1e+15 lm, has more than"), std::string::npos) << e.what();
  }
}

}  // namespace
}  // namespace photometry
