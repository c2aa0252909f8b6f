// Does the reader of TM-33 files find every direction, symmetry and unit of both generations, and refuse what it cannot
// know the meaning of?
#include <gtest/gtest.h>

#include <cmath>

#include "photometry/files.h"

namespace ups::test {
namespace {

using photometry::OpeningShape;
using photometry::ParseError;
using photometry::Photometry;
using photometry::Symmetry;
using photometry::UnsupportedError;
using photometry::test::expect_refused;
using photometry::test::warned;

constexpr double degree = 3.14159265358979323846 / 180;

// The lamp: 1000 (1 + cos v) / 2 (1 + a cos h + b cos 2h) candelas.
struct Lamp {
  double a = 0, b = 0;
  double cd(double h, double v) const {
    return 500 * (1 + std::cos(v * degree)) * (1 + a * std::cos(h * degree) + b * std::cos(2 * h * degree));
  }
};

std::string number(double value) {
  char text[40];
  std::snprintf(text, sizeof text, "%.12g", value);
  return text;
}

std::string values(const Lamp& lamp, double h0, double h1, double factor = 1, double v1 = 180) {
  std::string out;
  for (double v = v1; v >= 0; v -= 15)  // in no order that a grid would have
    for (double h = h0; h <= h1; h += 30)
      out +=
          "<IntData v=\"" + number(v) + "\" h='" + number(h) + "'>" + number(lamp.cd(h, v) * factor) + "</IntData>\n";
  return out;
}

std::string emitter(const std::string& intensity, const std::string& more = "") {
  return "<Emitter><Quantity>1</Quantity><Description>LED</Description>" + more + "<LuminousData><LuminousIntensity>" +
         intensity + "</LuminousIntensity></LuminousData></Emitter>\n";
}

std::string file(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<IESTM33-22><Version>1.1</Version>\n<Header><Manufacturer>A &amp; B</Manufacturer>"
         "<CatalogNumber>C1</CatalogNumber><Description>Spot</Description><ReportNumber>7</ReportNumber></Header>\n" +
         content + "</IESTM33-22>\n";
}

Photometry read(const std::string& text) { return photometry::test::read_text(text); }

void expect_lamp(const Photometry& p, const Lamp& lamp, double factor = 1) {
  for (double h = 0; h < 360; h += 30)
    for (double v = 15; v < 180; v += 15) {
      const double s = std::sin(v * degree);
      EXPECT_NEAR(p.distribution.eval(s * std::cos(h * degree), s * std::sin(h * degree), -std::cos(v * degree)),
                  factor * lamp.cd(h, v), 1e-6)
          << h << " " << v;
    }
}

TEST(Tm33, EverySymmetry) {
  struct Case {
    const char* name;
    Lamp lamp;
    double h0, h1;
    Symmetry symmetry;
  };
  for (const Case& c :
       {Case{"Symm_None", {0.3, 0.2}, 0, 330, Symmetry::none}, Case{"Symm_None", {0.3, 0.2}, 0, 360, Symmetry::none},
        Case{"Symm _ Bi _ 0", {0.3, 0.2}, 0, 180, Symmetry::c0_c180},
        Case{"Symm_Bi_90", {0, 0.2}, 90, 270, Symmetry::c90_c270},
        Case{"Symm_Quad", {0, 0.2}, 0, 90, Symmetry::quadrants}, Case{"Symm_Full", {}, 0, 0, Symmetry::axial}}) {
    const Photometry p = read(file(emitter("<Symm>" + std::string(c.name) + "</Symm>" + values(c.lamp, c.h0, c.h1))));
    expect_lamp(p, c.lamp);
    EXPECT_EQ(p.symmetry, c.symmetry) << c.name;
    for (const std::string& w : p.warnings)  // this lamp's planes also differ at the nadir
      EXPECT_TRUE(w.find("plane 360 is missing") != w.npos || w.find("at the nadir") != w.npos) << c.name << ": " << w;
  }
  EXPECT_TRUE(warned(read(file(emitter("<Symm>Symm_Quad</Symm>" + values({}, 0, 180)))), "which the angles h do not"));
  expect_refused<ParseError>(file(emitter("<Symm>Symm_None</Symm>" + values({}, 0, 90))), "nothing is symmetric");
}

TEST(Tm33, ATiltChangesNothingAndSaysSo) {
  photometry::ReadOptions options;
  options.tilt_deg = 20;
  const Photometry p = photometry::test::read_text(file(emitter("<Symm>Symm_Full</Symm>" + values({}, 0, 0))), options);
  EXPECT_TRUE(warned(p, "there is no TILT table; the tilt of 20 degrees changes nothing"));
}

TEST(Tm33, UnitsAndWhatTheFileSays) {
  const Lamp lamp;
  const std::string rated =
      "<RatedLumens>2000</RatedLumens><InputWattage>21</InputWattage><ColorTemperature>"
      "<FixedCCT>3000</FixedCCT></ColorTemperature>";
  const std::string table = values(lamp, 0, 0);
  const Photometry relative = read(file(emitter("<AbsolutePhotometry>false</AbsolutePhotometry>" + table, rated)));
  expect_lamp(relative, lamp, 2);
  EXPECT_EQ(relative.rated_flux_lm, 2000);
  EXPECT_EQ(relative.input_power_w, 21);
  ASSERT_EQ(relative.lamp_sets.size(), 1u);
  EXPECT_EQ(relative.lamp_sets[0].colour, "3000");
  EXPECT_EQ(relative.format, "IES TM-33-23");
  ASSERT_EQ(relative.keywords.size(), 5u);
  EXPECT_EQ(relative.keywords[0].name, "MANUFAC");
  EXPECT_EQ(relative.keywords[0].value, "A & B");
  EXPECT_EQ(relative.keywords[2].name, "LUMINAIRE");
  EXPECT_EQ(relative.keywords[4].name, "LAMP");
  const Photometry absolute =
      read(file(emitter("<AbsolutePhotometry>true</AbsolutePhotometry><Multiplier>0.5</Multiplier>" + table, rated)));
  expect_lamp(absolute, lamp, 0.5);
  EXPECT_EQ(absolute.rated_flux_lm, -1);
  expect_lamp(read(file(emitter(table, rated + "<BallastFactor>0.9</BallastFactor>"))), lamp, 0.9);
  EXPECT_TRUE(warned(read(file(emitter(table, rated))), "AbsolutePhotometry is not stated; taken as true"));
  expect_refused<ParseError>(file(emitter("<AbsolutePhotometry>0</AbsolutePhotometry>" + table)), "<RatedLumens>");
}

TEST(Tm33, GenerationOf2018) {
  const Lamp lamp{0.3, 0};
  std::string table = values(lamp, 0, 180);
  for (size_t at = 0; (at = table.find("IntData", at)) != table.npos; at += 13) table.replace(at, 7, "IntensityData");
  for (const char* root : {"LuminaireOpticalData", "tm33:UNI11733"}) {
    const std::string name = root;
    const Photometry p = read("\xEF\xBB\xBF<!-- a lamp -->\n"
                              "<!DOCTYPE x [<!-- it's > --><?it's?><!ENTITY y \"z><!--\">]>\n<" + name +
                              " version='1.0' xmlns:tm33='urn:x'><Header/><Emitter><InputWatts>3</InputWatts>"
                              "<IntensityDistribution><PhotometryType>TypeC</PhotometryType><Metric>Luminous</Metric>"
                              "<Units><![CDATA[cd]]></Units>" +
                              table + "</IntensityDistribution></Emitter></" + name + ">");
    expect_lamp(p, lamp);
    EXPECT_EQ(p.format, "IES TM-33-18");
    EXPECT_EQ(p.input_power_w, 3);
  }
}

// One shines down, one up; one has steps of its own.
TEST(Tm33, EveryNameOfTheFirstGenerationIsRead) {
  const Lamp lamp;
  for (const char* root : {"IESTM33", "IESTM33-18", "ATLA-S001-A", "ATLA_S001", "LuminaireOpticalData"}) {
    const std::string name = root;
    const Photometry p = read("<" + name + "><Version>1.0</Version>" + emitter(values(lamp, 0, 0)) + "</" + name + ">");
    expect_lamp(p, lamp);
    EXPECT_EQ(p.format, "IES TM-33-18") << root;
    EXPECT_TRUE(p.warnings.empty()) << root << ": " << p.warnings[0];
  }
}

// 2 pi 500 lm of the lamp, were they candelas: a table per 1000 lm of 20,000 says no more.
TEST(Tm33, ATableThatMustBeRelativeIsToldSo) {
  const auto told = [](const std::string& flag, double rated, double factor) {
    return read(file(emitter(flag + values({}, 0, 0, factor), "<RatedLumens>" + number(rated) + "</RatedLumens>")));
  };
  const std::string start = "far below RatedLumens, 20000 lm, as those in cd per 1000 lm do; they are used as they are";
  const Photometry unstated = told("", 20000, 0.15);
  EXPECT_TRUE(warned(unstated, start + " (AbsolutePhotometry is not stated; taken as true)"));
  EXPECT_TRUE(warned(told("<AbsolutePhotometry>true</AbsolutePhotometry>", 20000, 0.15),
                     start + ", as AbsolutePhotometry says"));
  ASSERT_EQ(unstated.lamp_sets.size(), 1u);
  EXPECT_EQ(unstated.lamp_sets[0].flux_lm, 20000) << "shown beside";
  expect_lamp(unstated, {}, 0.15);
  EXPECT_FALSE(warned(told("<AbsolutePhotometry>false</AbsolutePhotometry>", 20000, 0.15), "far below"));
  EXPECT_FALSE(warned(told("", 20000, 1), "far below")) << "more than 1000 lm";
  EXPECT_FALSE(warned(told("", 1200, 0.15), "far below")) << "a luminaire of poor efficiency";
}

TEST(Tm33, OddFilesAreReadWithAWarning) {
  const std::string table = values({}, 0, 0), good = emitter(table);
  const auto dimensions = [&](const std::string& length) {
    return read(file("<Luminaire><Dimensions><Length>" + length + "</Length><Width>0.3</Width><Height>0</Height>" +
                     "</Dimensions><NumEmitter>1</NumEmitter></Luminaire>" + good));
  };
  EXPECT_TRUE(dimensions("1.2").warnings.empty());
  EXPECT_TRUE(warned(dimensions("1200"), "the luminaire's Length of 1200 m is doubtful; are its units metres?"));
  EXPECT_TRUE(warned(dimensions("-1"), "the luminaire's Length is \"-1\"; it must be metres"));
  EXPECT_TRUE(warned(dimensions("4 ft"), "the luminaire's Length is \"4 ft\""));
  std::string version = file(good);
  version.replace(version.find("1.1"), 3, "7.5");
  EXPECT_TRUE(warned(read(version), "line 2: the version is \"7.5\"; read as 1.1 of IES TM-33-23"));
  EXPECT_TRUE(warned(read("<LuminaireOpticalData version='3'>" + good + "</LuminaireOpticalData>"), "version is \"3\""));
  EXPECT_TRUE(warned(read("<IESTM33-99>" + good + "</IESTM33-99>"), "<IESTM33-99> is no known edition"));
  EXPECT_TRUE(read(file(good) + "<!-- made by hand -->\n<?end?>\n").warnings.empty());
  EXPECT_TRUE(warned(read(file(good) + "<IESTM33-22>" + good + "</IESTM33-22>"), "more follows the end of the first"));
  EXPECT_TRUE(warned(read(file(emitter("<Multiplier>0</Multiplier>" + table))), "the Multiplier is 0; taken as 1"));
  expect_refused<ParseError>(file(emitter("<Multiplier>-1</Multiplier>" + table)),
                             "the Multiplier is -1; it must be greater than 0");
  expect_refused<ParseError>(file(emitter(table, "<BallastFactor>-1</BallastFactor>")), "the BallastFactor is -1");
  expect_refused<ParseError>(file(emitter("<Multiplier>2</Multiplier><Multiplier>3</Multiplier>" + table)),
                             "<Multiplier> stands twice");
  expect_refused<ParseError>(file(emitter(table, "<RatedLumens>2</RatedLumens><RatedLumens>3</RatedLumens>")),
                             "<RatedLumens> stands twice");
}

TEST(Tm33, LampsHaveColours) {
  const auto lamps = [](const std::string& more) { return read(file(emitter(values({}, 0, 0), more))).lamp_sets.at(0); };
  const photometry::LampSet fixed = lamps(
      "<ColorTemperature><FixedCCT>4000</FixedCCT></ColorTemperature>"
      "<ColorRendering><CIE_CRI><Ra>92</Ra><R9>50</R9></CIE_CRI><IES_TM30><Rf>90</Rf></IES_TM30></ColorRendering>");
  EXPECT_EQ(fixed.colour, "4000");
  EXPECT_EQ(fixed.colour_rendering, "92");
  const photometry::LampSet tunable = lamps(
      "<ColorTemperature><MinCCT>2700</MinCCT><MaxCCT>6500</MaxCCT></ColorTemperature>"
      "<ColorRendering><Ra>83</Ra></ColorRendering>");
  EXPECT_EQ(tunable.colour, "2700-6500");
  EXPECT_EQ(tunable.colour_rendering, "83");
}

TEST(Tm33, EmittersAddUp) {
  const std::string down = values({0.3, 0}, 0, 180, 1, 90),
                    up = "<IntData h='0' v='120'>100</IntData><IntData h='0' v='180'>160</IntData>";
  const Photometry both = read(file(emitter(down, "<RatedLumens>5000</RatedLumens>") + emitter(up)));
  const Photometry one = read(file(emitter(down))), other = read(file(emitter(up)));
  EXPECT_TRUE(warned(both, "the light of all 2 emitters is added up"));
  ASSERT_EQ(both.lamp_sets.size(), 2u);
  EXPECT_EQ(both.lamp_sets[0].flux_lm, 5000);
  EXPECT_NEAR(both.distribution.interpolated_flux_lm(),
              one.distribution.interpolated_flux_lm() + other.distribution.interpolated_flux_lm(), 1e-4);
  for (double v : {0.0, 40.0, 89.9, 90.1, 119.9, 120.1, 150.0, 180.0}) {
    const double x = std::sin(v * degree), z = -std::cos(v * degree);
    EXPECT_NEAR(both.distribution.eval(x, 0, z), one.distribution.eval(x, 0, z) + other.distribution.eval(x, 0, z),
                1e-6)
        << v;
  }
  EXPECT_THROW(photometry::read(file(emitter(up)).data(), file(emitter(up)).size(), {.lamp_set = 1}),
               std::invalid_argument);
}

TEST(Tm33, TypesAAndB) {
  std::string table;
  for (int h = -90; h <= 90; h += 15)
    for (int v = -90; v <= 90; v += 15)
      table += "<IntData h='" + number(h) + "' v='" + number(v) + "'>" + number(100 + h + 0.1 * v) + "</IntData>";
  const Photometry p =
      read(file("<Equipment><Gonioradiometer><Type>IES _ B</Type></Gonioradiometer></Equipment>" + emitter(table)));
  EXPECT_EQ(p.type, photometry::PhotometricType::b);
  const double h = 30 * degree, v = 45 * degree;  // right is -y, up is x
  EXPECT_NEAR(p.distribution.eval(std::cos(h) * std::sin(v), -std::sin(h), -std::cos(h) * std::cos(v)), 134.5, 1e-9);
}

std::string with_prefix(std::string text, const std::string& prefix) {
  for (size_t at = 0; (at = text.find('<', at)) != text.npos;) {
    at += text[at + 1] == '/' ? 2 : 1;
    if (text[at] != '?') text.insert(at, prefix);
  }
  return text;
}

// However long a prefix makes their names.
TEST(Tm33, OpeningsWithAnyPrefix) {
  const std::string lamp = file(emitter(
      values({}, 0, 0), "<EmissionAreas><BottomFace><BottomArea><Length>1.2</Length><Width>0.3</Width>"
                        "<LengthOffset>0</LengthOffset><WidthOffset>0</WidthOffset></BottomArea></BottomFace>"
                        "</EmissionAreas>"));
  for (const char* prefix : {"", "tm:", "luminaire:", "photometry:", "a_prefix_of_more_than_thirty_letters:"}) {
    const photometry::Opening opening = read(with_prefix(lamp, prefix)).opening;
    EXPECT_EQ(opening.shape, OpeningShape::rectangle) << prefix;
    EXPECT_FLOAT_EQ(opening.size_m[0], 0.3f) << prefix;
    EXPECT_FLOAT_EQ(opening.size_m[1], 1.2f) << prefix;
  }
}

TEST(Tm33, Openings) {
  const auto opening = [](const std::string& areas) {
    return read(file(emitter(values({}, 0, 0), "<EmissionAreas>" + areas + "</EmissionAreas>"))).opening;
  };
  const std::string bottom =
      "<BottomFace><NumberBottom>1</NumberBottom><BottomArea><Length>1.2</Length><Width>0.3</Width>"
      "<LengthOffset>0</LengthOffset></BottomArea></BottomFace>";
  const photometry::Opening flat = opening(bottom);
  EXPECT_EQ(flat.shape, OpeningShape::rectangle);
  EXPECT_FLOAT_EQ(flat.size_m[0], 0.3f);
  EXPECT_FLOAT_EQ(flat.size_m[1], 1.2f);
  const photometry::Opening box =
      opening(bottom + "<C0Face><C0Area><Length>1</Length><Height>0.1</Height></C0Area></C0Face>");
  EXPECT_EQ(box.shape, OpeningShape::box);
  EXPECT_FLOAT_EQ(box.size_m[2], 0.1f);
  const photometry::Opening disc = opening(
      "<BottomFace><BottomArea><Length>0.2</Length><Width>0</Width><Circular>true"
      "</Circular></BottomArea></BottomFace>");
  EXPECT_EQ(disc.shape, OpeningShape::disc);
  EXPECT_FLOAT_EQ(disc.size_m[0], 0.2f);
  EXPECT_FLOAT_EQ(disc.size_m[1], 0.2f);
  EXPECT_EQ(read(file(emitter(values({}, 0, 0)))).opening.shape, OpeningShape::point);
  const photometry::Opening line = opening("<BottomFace><BottomArea><Length>1.2</Length></BottomArea></BottomFace>");
  EXPECT_EQ(line.shape, OpeningShape::rectangle);
  EXPECT_FLOAT_EQ(line.size_m[1], 1.2f);
  EXPECT_EQ(line.size_m[0], 0);
}

// Half a circle about plane 0 may run from 270 across it to 90, as in EULUMDAT; a circle need not close evenly.
TEST(Tm33, PartsOfACircleAsOthersCountThem) {
  const Lamp half{0.3, 0.2};  // mirrored about the plane 0-180
  Lamp across;                // about the plane 90-270
  across.b = 0.2;
  std::string table = values(across, 270, 360) + values(across, 30, 90);
  const Photometry bi = read(file(emitter("<Symm>Symm_Bi_90</Symm>" + table)));
  expect_lamp(bi, across);
  EXPECT_EQ(bi.symmetry, Symmetry::c90_c270);
  table = values(half, 0, 330);
  for (double v = 0; v <= 180; v += 15)
    table += "<IntData h='345' v='" + number(v) + "'>" + number(half.cd(345, v)) + "</IntData>";
  expect_lamp(read(file(emitter("<Symm>Symm_Arbitrary</Symm>" + table))), half);
}

TEST(Tm33, UnitsAndTypesThatAreNotKnownAreNotGuessed) {
  const std::string table = values({}, 0, 0), rated = "<RatedLumens>2000</RatedLumens>";
  for (const char* unit : {"W/sr", "kcd", "mcd", "cd/m2"})
    expect_refused<UnsupportedError>(file(emitter("<Units>" + std::string(unit) + "</Units>" + table)),
                                     "; cd and cd/klm are read");
  for (const char* unit : {"cd", "Candela", "lm/sr", ""})
    expect_lamp(read(file(emitter("<Units>" + std::string(unit) + "</Units>" + table))), {});
  expect_lamp(read(file(emitter("<Units>cd / klm</Units>" + table, rated))), {}, 2);
  const std::string klm = "<Units>cd/klm</Units>", absolute = "<AbsolutePhotometry>true</AbsolutePhotometry>";
  expect_refused<ParseError>(file(emitter(klm + absolute + table, rated)), "one of them must be wrong");
  expect_refused<ParseError>(file(emitter(absolute + klm + table, rated)), "one of them must be wrong");
  const auto of_type = [&](const std::string& type) {
    return read(file("<Equipment><Goniometer><Type>" + type + "</Type></Goniometer></Equipment>" + emitter(table)));
  };
  for (const char* type : {"C-Gamma", "Far-field camera", "Custom"}) {
    const Photometry p = of_type(type);
    EXPECT_EQ(p.type, photometry::PhotometricType::c) << type;
    EXPECT_TRUE(warned(p, "the directions are taken as of type C")) << type;
  }
  for (const char* type : {"C", "CIE C", "Type C", "IES Type C"}) EXPECT_TRUE(of_type(type).warnings.empty()) << type;
}

// The luminaire's is what its emitters with light take, or not known.
TEST(Tm33, InputPowerIsOfEveryEmitterOrNotKnown) {
  const std::string table = values({}, 0, 0), watts = "<InputWatts>20</InputWatts>";
  EXPECT_EQ(read(file(emitter(table, watts) + emitter(table, watts))).input_power_w, 40);
  const Photometry partly = read(file(emitter(table, watts) + emitter(table)));
  EXPECT_EQ(partly.input_power_w, -1);
  EXPECT_TRUE(warned(partly, "not every emitter with light states its input power"));
  EXPECT_EQ(read(file(emitter(table, watts) + "<Emitter>" + watts + "</Emitter>")).input_power_w, 20);
}

TEST(Tm33, SeveralAreasAreTheBoxAroundThem) {
  const auto area = [](const std::string& size, const char* offset) {
    return "<BottomArea>" + size + "<WidthOffset>" + offset + "</WidthOffset></BottomArea>";
  };
  const auto opening = [](const std::string& areas) {
    return read(file(emitter(values({}, 0, 0), "<EmissionAreas><BottomFace>" + areas + "</BottomFace></EmissionAreas>")));
  };
  const std::string strip = "<Length>1.2</Length><Width>0.1</Width>", spot = "<Diameter>0.2</Diameter>";
  const Photometry two = opening(area(strip, "-0.3") + area(strip, "0.3"));
  EXPECT_FLOAT_EQ(two.opening.size_m[0], 0.7f);
  EXPECT_FLOAT_EQ(two.opening.size_m[1], 1.2f);
  EXPECT_TRUE(warned(two, "the luminous opening is the box around them, 0.7 x 1.2 x 0 m"));
  const Photometry mixed = opening(area(strip, "0") + area(spot, "0"));
  EXPECT_EQ(mixed.opening.shape, OpeningShape::rectangle);
  EXPECT_FLOAT_EQ(mixed.opening.size_m[0], 0.2f);
  EXPECT_TRUE(warned(mixed, "differ in size or place"));
  const Photometry same = opening(area(spot, "0") + area(spot, "0"));
  EXPECT_EQ(same.opening.shape, OpeningShape::disc);
  EXPECT_TRUE(same.warnings.empty());
}

TEST(Tm33, DirectionsThatAreMissingOrTwice) {
  const Lamp lamp{0.2, 0.1};
  std::string table = values(lamp, 0, 330);
  const auto without = [&](const std::string& direction) {
    std::string out = table;
    const size_t at = out.find("<IntData " + direction);
    out.erase(at, out.find('\n', at) - at);
    return file(emitter(out));
  };
  expect_refused<ParseError>(without("v=\"90\" h='60'"), "the direction h = 60, v = 90 is missing");
  expect_lamp(read(without("v=\"0\" h='60'")), lamp);  // the nadir, which other planes have
  EXPECT_TRUE(warned(read(file(emitter(table + "<IntData h='0' v='90'>" + number(lamp.cd(0, 90)) + "</IntData>"))),
                     "1 directions are stated twice"));
  expect_refused<ParseError>(file(emitter(table + "<IntData h='0' v='90'>1</IntData>")),
                             "has the intensity 1 here and");
  expect_refused<ParseError>(file(emitter("<NumberHorz>12</NumberHorz><NumberVert>14</NumberVert>" + table)),
                             "asks for 168");
  EXPECT_TRUE(warned(read(file(emitter("<NumberMeasured>7</NumberMeasured>" + table))), "NumberMeasured is 7"));
  EXPECT_TRUE(warned(read(file(emitter(values(lamp, 0, 0) + "<IntData h='0' v='7'>-1</IntData>"))), "is negative"));
}

TEST(Tm33, Refusals) {
  const std::string good = emitter(values({}, 0, 0));
  expect_refused<UnsupportedError>("<svg/>", "line 1: an XML file whose first element is <svg>");
  expect_refused<ParseError>("<IESTM33-22>\n</IESTM33-22>", "no <Emitter>");
  expect_refused<UnsupportedError>(file("<Emitter><RadiantData/></Emitter>"), "no emitter has luminous intensities");
  expect_refused<UnsupportedError>(
      file("<Emitter><IntensityDistribution><Metric>Radiant</Metric></IntensityDistribution></Emitter>"), "RADIANT");
  expect_refused<ParseError>(file(emitter("")), "there are no intensities");
  // A thousand tables of two directions each and one of a hundred planes: 200 million look-ups and more.
  std::string many;
  for (int i = 0; i < 1000; ++i)
    many += emitter("<IntData h='0' v='" + number(0.05 + 0.05 * i) + "'>1</IntData><IntData h='0' v='" +
                    number(60.03 + 0.05 * i) + "'>1</IntData>");
  std::string planes;
  for (int h = 0; h < 360; h += 3)
    for (const int v : {0, 90}) planes += "<IntData h='" + number(h) + "' v='" + number(v) + "'>1</IntData>";
  expect_refused<ParseError>(file(many + emitter(planes)), "the sum of the 1001 emitters has too many directions");
  expect_refused<ParseError>(file(emitter("<IntData h='0'>1</IntData>")), "has no attribute v");
  expect_refused<ParseError>(file(emitter("<IntData h='0' v='x'>1</IntData>")),
                             "the attribute v of <IntData> is \"x\"");
  expect_refused<ParseError>(file(emitter("<IntData h='0' v='0'>1,5</IntData>")), "<IntData> is \"1,5\"");
  expect_refused<ParseError>(file(emitter("<IntData h='0' v='0'>1</IntData>")), "fewer than 2 angles v");
  expect_refused<ParseError>(file(emitter("<IntData h='0' v='0'>1e20</IntData><IntData h='0' v='9'>1</IntData>")),
                             "too large");
  expect_refused<ParseError>(file(emitter(values({}, 0, 0) + "<IntData h='0' v='200'>1</IntData>")),
                             "not within 0 to 180");
  EXPECT_TRUE(
      warned(read(file(good + "<Emitter><SpectralData><x/></SpectralData></Emitter>")), "SpectralData is not read"));
}

}  // namespace
}  // namespace ups::test
