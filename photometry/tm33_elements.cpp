// The elements of ANSI/IES TM-33 files: of 2018 (also ATLA S001, UNI 11733) and of 2023. Called by tm33.cpp.
//
// Of the structure, what matters to light: Header, Luminaire, Equipment / Gonioradiometer / Type, and of each Emitter
// RatedLumens, InputWattage, BallastFactor, EmissionAreas and LuminousData / LuminousIntensity with a value a direction
// (h, v). Some writers of 2018 have IntensityDistribution / IntensityData instead. A C0 area is Length x Height, so
// Length lies along C90-C270, local y, and Width along x. Metres.
#include "photometry/tm33_elements.h"

#include <algorithm>
#include <cmath>

#include "photometry/writer_text.h"
#include "photometry/xml.h"

namespace photometry {
namespace {

// "Symm _ Bi _ 0" and "symm_bi_0" are the same.
std::string token(const std::string& text) {
  std::string out;
  for (char c : upper_case(text))
    if (c != ' ' && c != '_' && c != '\t' && c != '\r' && c != '\n') out += c;
  return out;
}

class Tm33Reader {
 public:
  explicit Tm33Reader(std::string text) : xml_(std::move(text)) {}
  Tm33File read();

 private:
  void warn(size_t line, const std::string& what) { file_.warnings.push_back(at_line(line, what)); }
  double number();
  double positive_number(const char* what, double otherwise);
  double factor(const char* what);
  double attribute(std::initializer_list<const char*> names);
  template <class Child>
  void children(const Child& child) {
    while (xml_.enter_child()) child(xml_.name());
  }
  void take_once(std::vector<std::string>& seen);  // seen: of the parent's children before
  void read_root();
  void check_version(const std::string& version, size_t line);
  void read_header();
  void read_luminaire();
  void check_dimensions();
  void read_type();
  void read_equipment();
  void read_emitter();
  void read_intensity(Tm33Intensity& out);
  bool is_per_klm();
  void read_value(Tm33Intensity& out, size_t& negative);
  void read_areas();
  std::string colour_temperature();
  std::string colour_rendering();
  void read_area(int face);
  void add_keyword(const char* name) {
    const std::string value(trimmed(xml_.text()));
    if (!value.empty()) file_.keywords.push_back({name, value});
  }

  XmlReader xml_;
  Tm33File file_;
};

// What scales the light or says what the values are stands once: of two, neither is known to be meant.
void Tm33Reader::take_once(std::vector<std::string>& seen) {
  static constexpr std::string_view once[] = {"AbsolutePhotometry", "BallastFactor", "Metric", "Multiplier",
                                              "NumberHorz", "NumberMeasured", "NumberVert", "PhotometryType",
                                              "Quantity", "RatedLumens", "Symm", "Units"};
  const std::string name(xml_.name());
  if (std::find(std::begin(once), std::end(once), name) == std::end(once)) return;
  if (std::find(seen.begin(), seen.end(), name) != seen.end()) xml_.fail("<" + name + "> stands twice");
  seen.push_back(name);
}

double Tm33Reader::number() {
  const std::string name(xml_.name());
  const size_t line = xml_.line();
  const std::string text = xml_.text();
  double value = 0;
  if (!parse_number(trimmed(text), value) || !std::isfinite(value))
    fail_at(line, "<" + name + "> is \"" + cut(trimmed(text)) + "\"; it must be a number");
  return value;
}

double Tm33Reader::positive_number(const char* what, double otherwise) {
  const size_t line = xml_.line();
  const double value = number();
  if (value > 0) return value;
  warn(line,
       std::string(what) + " is " + shown(value) + "; taken as " + (otherwise < 0 ? "not stated" : shown(otherwise)));
  return otherwise;
}

// As in IES files: 0 is taken as 1, a negative one would turn light into darkness.
double Tm33Reader::factor(const char* what) {
  const size_t line = xml_.line();
  const double value = number();
  if (value < 0) fail_at(line, std::string(what) + " is " + shown(value) + "; it must be greater than 0");
  if (value == 0) warn(line, std::string(what) + " is 0; taken as 1");
  return value == 0 ? 1 : value;
}

double Tm33Reader::attribute(std::initializer_list<const char*> names) {
  const std::string element(xml_.name());
  for (const char* name : names)
    if (const std::string* text = xml_.attribute(name)) {
      double value = 0;
      if (!parse_number(trimmed(*text), value) || !std::isfinite(value))
        xml_.fail("the attribute " + std::string(name) + " of <" + element + "> is \"" + cut(*text) +
                  "\"; it must be a number");
      return value;
    }
  xml_.fail("<" + element + "> has no attribute " + *names.begin() + "; each intensity has its direction");
}

void Tm33Reader::read_root() {
  xml_.enter_root();
  const std::string root(xml_.name());
  std::string key = token(root);
  key.erase(std::remove(key.begin(), key.end(), '-'), key.end());
  if (key == "IESTM3322" || key == "IESTM3323")
    file_.format = "IES TM-33-23";
  else if (key == "IESTM33" || key == "IESTM3318" || key == "LUMINAIREOPTICALDATA" || key == "UNI11733" ||
           key.rfind("ATLAS001", 0) == 0)
    file_.format = "IES TM-33-18";
  else if (key.rfind("IESTM33", 0) == 0)
    file_.format = "IES TM-33-23", warn(xml_.line(), "<" + root + "> is no known edition; read as TM-33-23");
  else
    throw UnsupportedError(at_line(xml_.line(), "an XML file whose first element is <" + root +
                                                    "> is not read; those of "
                                                    "TM-33 have <IESTM33-22> or <LuminaireOpticalData>"));
  if (const std::string* version = xml_.attribute("version")) check_version(*version, xml_.line());
}

// 1.0 of 2018, 1.1 of 2023.
void Tm33Reader::check_version(const std::string& version, size_t line) {
  const std::string known = file_.format == "IES TM-33-18" ? "1.0" : "1.1";
  if (token(version) != known && !(token(version) + ".0" == known))
    warn(line, "the version is \"" + one_line(cut(trimmed(version))) + "\"; read as " + known +
                   " of " + file_.format);
}

void Tm33Reader::read_header() {
  static constexpr std::pair<std::string_view, const char*> names[] = {{"Manufacturer", "MANUFAC"},
                                                                       {"CatalogNumber", "LUMCAT"},
                                                                       {"Description", "LUMINAIRE"},
                                                                       {"Laboratory", "TESTLAB"},
                                                                       {"ReportNumber", "TEST"},
                                                                       {"ReportDate", "ISSUEDATE"},
                                                                       {"IssueDate", "ISSUEDATE"},
                                                                       {"TestDate", "TESTDATE"},
                                                                       {"GTIN", "_GTIN"},
                                                                       {"UUID", "_UUID"},
                                                                       {"UniqueIdentifier", "_UUID"},
                                                                       {"DocumentCreator", "_CREATOR"},
                                                                       {"DocumentCreationDate", "DATE"},
                                                                       {"LuminaireType", "_LUMINAIRETYPE"},
                                                                       {"Comment", "OTHER"},
                                                                       {"Comments", "OTHER"},
                                                                       {"Reference", "_REFERENCE"},
                                                                       {"MoreInfoURI", "_URI"}};
  children([&](std::string_view name) {
    for (const auto& [element, keyword] : names)
      if (element == name) return add_keyword(keyword);
    xml_.skip();
  });
}

// LuminousOpening of some files of 2018; the housing's dimensions say nothing of the light.
void Tm33Reader::read_luminaire() {
  children([&](std::string_view name) {
    if (name == "LuminousOpening") return read_area(2);
    name == "Dimensions" ? check_dimensions() : xml_.skip();
  });
}

void Tm33Reader::check_dimensions() {
  constexpr double largest_m = 10;
  children([&](std::string_view name) {
    const std::string of = "the luminaire's " + std::string(name);
    const size_t line = xml_.line();
    const std::string text = cut(trimmed(xml_.text()));
    double value = 0;
    if (!parse_number(text, value) || !(value >= 0) || !std::isfinite(value))
      warn(line, of + " is \"" + text + "\"; it must be metres, and is not read");
    else if (value > largest_m)
      warn(line, of + " of " + shown(value) + " m is doubtful; are its units metres?");
  });
}

void Tm33Reader::read_type() {
  const size_t line = xml_.line();
  const std::string text = token(xml_.text());
  std::string letter = text;  // "CIE A", "Type B", "IES Type C", "C"
  for (const std::string_view word : {"CIE", "IES", "TYPE"})
    if (letter.rfind(word, 0) == 0) letter.erase(0, word.size());
  const char last = text.empty() ? 'C' : letter.size() == 1 ? letter[0] : '?';
  if (last < 'A' || last > 'C')
    warn(line, "the goniometer's type is \"" + text + "\"; the directions are taken as of type C");
  else
    file_.type = last == 'A' ? PhotometricType::a : last == 'B' ? PhotometricType::b : PhotometricType::c;
}

void Tm33Reader::read_equipment() {
  children([&](std::string_view name) {
    if (name != "Gonioradiometer" && name != "Goniometer") return xml_.skip();
    children([&](std::string_view part) { part == "Type" || part == "GoniometerType" ? read_type() : xml_.skip(); });
  });
}

void Tm33Reader::read_value(Tm33Intensity& out, size_t& negative) {
  if (out.values.size() >= Distribution::max_values) xml_.fail("there are more than 4000000 intensities");
  DirectedValue v{attribute({"h", "horz", "horizontal"}), attribute({"v", "vert", "vertical"}), 0, xml_.line()};
  v.value = number();
  if (v.value < 0) {
    if (negative++ == 0) warn(v.line, "an intensity is negative; it and all like it are taken as 0");
    v.value = 0;
  }
  out.values.push_back(v);
}

void Tm33Reader::read_intensity(Tm33Intensity& out) {
  if (out.line) xml_.fail("the emitter has luminous intensities twice");
  out.line = xml_.line();
  size_t negative = 0;
  std::vector<std::string> seen;
  bool per_klm = false;
  children([&](std::string_view name) {
    if (name == "IntData" || name == "IntensityData") return read_value(out, negative);
    take_once(seen);
    if (name == "Multiplier") {
      out.multiplier = factor("the Multiplier");
    } else if (name == "AbsolutePhotometry") {
      const std::string flag = token(xml_.text());
      if (flag != "TRUE" && flag != "FALSE" && flag != "1" && flag != "0")
        fail_at(xml_.line(), "<AbsolutePhotometry> is \"" + flag + "\"; it must be true or false");
      out.photometry = flag == "TRUE" || flag == "1" ? Tm33Intensity::absolute : Tm33Intensity::relative;
    } else if (name == "Units") {
      per_klm = is_per_klm();
    } else if (name == "Metric") {
      const size_t line = xml_.line();
      const std::string metric = token(xml_.text());
      if (metric != "LUMINOUS")
        throw UnsupportedError(
            at_line(line, "the intensities are of the metric \"" + metric + "\"; luminous ones are read"));
    } else if (name == "PhotometryType") {
      read_type();
    } else if (name == "Symm") {
      out.symmetry = token(xml_.text());
    } else if (name == "NumberMeasured") {
      out.measured = number();
    } else if (name == "NumberHorz") {
      out.horizontal = number();
    } else if (name == "NumberVert") {
      out.vertical = number();
    } else {
      xml_.skip();
    }
  });
  if (per_klm && out.photometry == Tm33Intensity::absolute)
    fail_at(out.line, "<Units> are cd per 1000 lm, where <AbsolutePhotometry> is true; one of them must be wrong");
  if (per_klm) out.photometry = Tm33Intensity::relative;
}

// Whether <Units> are cd per 1000 lm; else they are cd.
bool Tm33Reader::is_per_klm() {
  const size_t line = xml_.line();
  const std::string units = token(xml_.text());
  if (units == "CD/KLM" || units == "CD/1000LM" || units == "CANDELA/KLM" || units == "CANDELAPERKLM") return true;
  for (const std::string_view cd : {"", "CD", "CANDELA", "CANDELAS", "LM/SR"})
    if (units == cd) return false;
  throw UnsupportedError(at_line(line, "the intensities' unit is \"" + cut(units) +
                                           "\"; cd and cd/klm are read"));
}

// face: the axis that it is normal to; C0 and C180 x, C90 and C270 y, top and bottom z.
void Tm33Reader::read_area(int face) {
  Tm33Area area;
  area.line = xml_.line(), area.face = face;
  double &x = area.size_m[0], &y = area.size_m[1];
  children([&](std::string_view name) {
    if (name == "Length")  // gone once the number is read, as all names
      y = number();
    else if (name == "LengthOffset")
      area.offset_m[1] = number();
    else if (name == "Width")
      x = number();
    else if (name == "WidthOffset")
      area.offset_m[0] = number();
    else if (name == "Height")
      area.size_m[2] = number();
    else if (name == "HeightOffset" && face != 2)  // top and bottom are one sheet
      area.offset_m[2] = number();
    else if (name == "Diameter")
      x = y = number(), area.round = true;
    else if (name == "Circular" || name == "Shape") {
      const std::string text = token(xml_.text());
      area.round |= face == 2 && (text == "TRUE" || text == "1" || text.rfind("CIRC", 0) == 0 || text == "ROUND");
    } else {
      xml_.skip();
    }
  });
  if (area.round && face == 2) {  // a diameter may stand in one of the two
    if (!(x > 0)) x = y;
    if (!(y > 0)) y = x;
  }
  file_.areas.push_back(area);
}

void Tm33Reader::read_areas() {
  children([&](std::string_view face) {
    const std::string side(face.substr(0, face.find("Face")));
    const int axis = side == "Top" || side == "Bottom" ? 2 : side == "C90" || side == "C270" ? 1 : 0;
    children([&](std::string_view area) {
      const bool is_area = area.size() > 4 && area.substr(area.size() - 4) == "Area";
      is_area ? read_area(axis) : xml_.skip();
    });
  });
}

// FixedCCT, or MinCCT and MaxCCT.
std::string Tm33Reader::colour_temperature() {
  std::string out;
  children([&](std::string_view) {
    const std::string text(trimmed(xml_.text()));
    if (!text.empty()) out += (out.empty() ? "" : "-") + text;
  });
  return out;
}

// Ra, in CIE_CRI or by itself.
std::string Tm33Reader::colour_rendering() {
  std::string ra;
  const auto take = [&](std::string_view name) { name == "Ra" ? void(ra = trimmed(xml_.text())) : xml_.skip(); };
  children([&](std::string_view name) { token(std::string(name)) == "CIECRI" ? children(take) : take(name); });
  return ra;
}

void Tm33Reader::read_emitter() {
  Tm33Emitter e;
  e.line = xml_.line();
  std::vector<std::string> seen;
  children([&](std::string_view name) {
    take_once(seen);
    if (name == "Quantity") {
      const double n = number();
      e.lamp.count = n >= 1 && n <= 1e6 ? int(n) : 0;
    } else if (name == "Description") {
      e.lamp.type = std::string(trimmed(xml_.text()));
      if (!e.lamp.type.empty()) file_.keywords.push_back({"LAMP", e.lamp.type});
    } else if (name == "CatalogNumber") {
      add_keyword("LAMPCAT");
    } else if (name == "RatedLumens") {
      e.lamp.flux_lm = positive_number("RatedLumens", -1);
    } else if (name == "InputWattage" || name == "InputWatts") {
      e.lamp.power_w = positive_number("the input power", -1);
    } else if (name == "BallastFactor") {
      e.ballast_factor = factor("the BallastFactor");
    } else if (name == "CCT") {
      e.lamp.colour = std::string(trimmed(xml_.text()));
    } else if (name == "ColorTemperature") {
      e.lamp.colour = colour_temperature();
    } else if (name == "ColorRendering") {
      e.lamp.colour_rendering = colour_rendering();
    } else if (name == "TiltAngles") {
      warn(xml_.line(), "the TiltAngles are not applied");
      xml_.skip();
    } else if (name == "EmissionAreas") {
      read_areas();
    } else if (name == "LuminousData") {
      children([&](std::string_view part) { part == "LuminousIntensity" ? read_intensity(e.intensity) : xml_.skip(); });
    } else if (name == "IntensityDistribution") {
      read_intensity(e.intensity);
    } else {
      if (name.find("Data") != name.npos && name != "CustomData" && name != "DataGeneration") e.other_data = name;
      xml_.skip();
    }
  });
  file_.emitters.push_back(std::move(e));
}

Tm33File Tm33Reader::read() {
  read_root();
  const size_t line = xml_.line();
  children([&](std::string_view name) {
    if (name == "Header")
      read_header();
    else if (name == "Version")
      check_version(xml_.text(), xml_.line());
    else if (name == "Luminaire")
      read_luminaire();
    else if (name == "Equipment")
      read_equipment();
    else if (name == "Emitter")
      read_emitter();
    else
      xml_.skip();
  });
  if (xml_.has_more()) warn(xml_.line(), "more follows the end of the first element; it is not read");
  if (file_.emitters.empty()) fail_at(line, "the file has no <Emitter>; at least one is needed");
  return std::move(file_);
}

}  // namespace

Tm33File read_tm33_elements(std::string text) { return Tm33Reader(std::move(text)).read(); }

}  // namespace photometry
