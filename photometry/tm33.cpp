// Reads ANSI/IES TM-33 files: of 2018 (also ATLA S001, UNI 11733) and of 2023. Called by programs and by read().
//
// Of the structure, what matters to light: Header, Luminaire, Equipment / Gonioradiometer / Type, and of each Emitter
// RatedLumens, InputWattage, BallastFactor, EmissionAreas and LuminousData / LuminousIntensity with a value a direction
// (h, v). Some writers of 2018 have IntensityDistribution / IntensityData instead. A C0 area is Length x Height, so
// Length lies along C90-C270, local y, and Width along x. Metres.
#include <cmath>

#include "photometry/planes.h"
#include "photometry/tm33_table.h"
#include "photometry/xml.h"

namespace photometry {
namespace {

constexpr double largest_intensity_cd = 1e12;

// "Symm _ Bi _ 0" and "symm_bi_0" are the same.
std::string token(const std::string& text) {
  std::string out;
  for (char c : upper_case(text))
    if (c != ' ' && c != '_' && c != '\t' && c != '\r' && c != '\n') out += c;
  return out;
}

struct Intensity {
  size_t line = 0;  // 0: the emitter has none
  enum { unstated, absolute, relative } photometry = unstated;
  std::string symmetry;
  double multiplier = 1, measured = -1, horizontal = -1, vertical = -1;
  std::vector<DirectedValue> values;
};

struct EmitterPart {
  size_t line = 0;
  LampSet lamp;
  double ballast_factor = 1;
  Intensity intensity;
  std::string other_data;  // the last of those that are not read
};

class Tm33Reader {
 public:
  explicit Tm33Reader(std::string text) : xml_(std::move(text)) {}
  Photometry read();

 private:
  void warn(size_t line, const std::string& what) { warnings_.push_back(at_line(line, what)); }
  double number();
  double positive_number(const char* what, double otherwise);
  double attribute(std::initializer_list<const char*> names);
  template <class Child>
  void children(const Child& child) {
    while (xml_.enter_child()) child(xml_.name());
  }
  void read_root();
  void read_header();
  void read_luminaire();
  void read_type();
  void read_equipment();
  void read_emitter();
  void read_intensity(Intensity& out);
  void read_value(Intensity& out, size_t& negative);
  void read_areas();
  void read_area(int face);
  void add_keyword(const char* name) {
    const std::string value(trimmed(xml_.text()));
    if (!value.empty()) keywords_.push_back({name, value});
  }
  double scale_of(const EmitterPart& emitter);
  void check_counts(const Intensity& intensity);
  void check_symmetry(const Intensity& intensity, Symmetry found);
  Distribution distribution_of_emitter(EmitterPart& emitter, Symmetry& symmetry);
  Photometry finish();

  XmlReader xml_;
  std::string format_;
  PhotometricType type_ = PhotometricType::c;
  std::vector<Keyword> keywords_;
  std::vector<std::string> warnings_;
  std::vector<EmitterPart> emitters_;
  float extent_m_[3] = {0, 0, 0};  // of the areas that emit
  bool round_ = false;
  size_t area_line_ = 0;
};

double Tm33Reader::number() {
  const std::string name(xml_.name());
  const size_t line = xml_.line();
  const std::string text = xml_.text();
  double value = 0;
  if (!parse_number(trimmed(text), value) || !std::isfinite(value))
    fail_at(line, "<" + name + "> is \"" + std::string(trimmed(text).substr(0, 40)) + "\"; it must be a number");
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

double Tm33Reader::attribute(std::initializer_list<const char*> names) {
  for (const char* name : names)
    if (const std::string* text = xml_.attribute(name)) {
      double value = 0;
      if (!parse_number(trimmed(*text), value) || !std::isfinite(value))
        xml_.fail("the attribute " + std::string(name) + " of <" + std::string(xml_.name()) + "> is \"" +
                  text->substr(0, 40) + "\"; it must be a number");
      return value;
    }
  xml_.fail("<" + std::string(xml_.name()) + "> has no attribute " + *names.begin() +
            "; each intensity has its direction");
}

void Tm33Reader::read_root() {
  xml_.enter_root();
  const std::string root(xml_.name()), key = token(root);
  if (key.rfind("IESTM33", 0) == 0)
    format_ = "IES TM-33-23";
  else if (key == "LUMINAIREOPTICALDATA" || key == "UNI11733" || key == "ATLAS001")
    format_ = "IES TM-33-18";
  else
    throw UnsupportedError(at_line(xml_.line(), "an XML file whose first element is <" + root +
                                                    "> is not read; those of "
                                                    "TM-33 have <IESTM33-22> or <LuminaireOpticalData>"));
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
    if (name != "LuminousOpening") return xml_.skip();
    read_area(2);
  });
}

void Tm33Reader::read_type() {
  const size_t line = xml_.line();
  const std::string text = token(xml_.text());
  const char last = text.empty() ? 'C' : text.back();
  if (text == "CUSTOM" || last < 'A' || last > 'C')
    warn(line, "the goniometer's type is \"" + text + "\"; the directions are taken as of type C");
  else
    type_ = last == 'A' ? PhotometricType::a : last == 'B' ? PhotometricType::b : PhotometricType::c;
}

void Tm33Reader::read_equipment() {
  children([&](std::string_view name) {
    if (name != "Gonioradiometer" && name != "Goniometer") return xml_.skip();
    children([&](std::string_view part) { part == "Type" || part == "GoniometerType" ? read_type() : xml_.skip(); });
  });
}

void Tm33Reader::read_value(Intensity& out, size_t& negative) {
  if (out.values.size() >= Distribution::max_values) xml_.fail("there are more than 4000000 intensities");
  DirectedValue v{attribute({"h", "horz", "horizontal"}), attribute({"v", "vert", "vertical"}), 0, xml_.line()};
  v.value = number();
  if (v.value < 0) {
    if (negative++ == 0) warn(v.line, "an intensity is negative; it and all like it are taken as 0");
    v.value = 0;
  }
  out.values.push_back(v);
}

void Tm33Reader::read_intensity(Intensity& out) {
  if (out.line) xml_.fail("the emitter has luminous intensities twice");
  out.line = xml_.line();
  size_t negative = 0;
  children([&](std::string_view name) {
    if (name == "IntData" || name == "IntensityData") return read_value(out, negative);
    if (name == "Multiplier") {
      out.multiplier = positive_number("the Multiplier", 1);
    } else if (name == "AbsolutePhotometry") {
      const std::string flag = token(xml_.text());
      if (flag != "TRUE" && flag != "FALSE" && flag != "1" && flag != "0")
        fail_at(xml_.line(), "<AbsolutePhotometry> is \"" + flag + "\"; it must be true or false");
      out.photometry = flag == "TRUE" || flag == "1" ? Intensity::absolute : Intensity::relative;
    } else if (name == "Units") {
      const std::string units = token(xml_.text());
      if (units.find("KLM") != units.npos || units.find("/1000") != units.npos) out.photometry = Intensity::relative;
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
}

// face: the axis that it is normal to; C0 and C180 x, C90 and C270 y, top and bottom z.
void Tm33Reader::read_area(int face) {
  area_line_ = xml_.line();
  double x = 0, y = 0, z = 0;
  children([&](std::string_view name) {
    if (name == "Length")
      y = number();
    else if (name == "Width")
      x = number();
    else if (name == "Height")
      z = number();
    else if (name == "Diameter")
      x = y = number(), round_ = true;
    else if (name == "Circular" || name == "Shape") {
      const std::string text = token(xml_.text());
      round_ |= face == 2 && (text == "TRUE" || text == "1" || text.rfind("CIRC", 0) == 0 || text == "ROUND");
    } else {
      xml_.skip();
    }
  });
  if (round_ && face == 2) {  // a diameter may stand in one of the two
    if (!(x > 0)) x = y;
    if (!(y > 0)) y = x;
  }
  const double size[3] = {x, y, z};
  for (int k = 0; k < 3; ++k) {
    if (!(size[k] >= 0 && size[k] <= 1e6))
      fail_at(area_line_, "an emission area has a size of " + shown(size[k]) + " m; it must be from 0 to a million");
    extent_m_[k] = std::max(extent_m_[k], float(size[k]));
  }
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

void Tm33Reader::read_emitter() {
  EmitterPart e;
  e.line = xml_.line();
  children([&](std::string_view name) {
    if (name == "Quantity") {
      const double n = number();
      e.lamp.count = n >= 1 && n <= 1e6 ? int(n) : 0;
    } else if (name == "Description") {
      e.lamp.type = std::string(trimmed(xml_.text()));
      if (!e.lamp.type.empty()) keywords_.push_back({"LAMP", e.lamp.type});
    } else if (name == "CatalogNumber") {
      add_keyword("LAMPCAT");
    } else if (name == "RatedLumens") {
      e.lamp.flux_lm = positive_number("RatedLumens", -1);
    } else if (name == "InputWattage" || name == "InputWatts") {
      e.lamp.power_w = positive_number("the input power", -1);
    } else if (name == "BallastFactor") {
      e.ballast_factor = positive_number("the BallastFactor", 1);
    } else if (name == "CCT") {
      e.lamp.colour = std::string(trimmed(xml_.text()));
    } else if (name == "ColorTemperature") {
      children([&](std::string_view) { e.lamp.colour = std::string(trimmed(xml_.text())); });
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
  emitters_.push_back(std::move(e));
}

// What the values of an emitter are multiplied with to be candelas.
double Tm33Reader::scale_of(const EmitterPart& e) {
  const Intensity& in = e.intensity;
  double scale = in.multiplier * e.ballast_factor;
  if (e.ballast_factor != 1) warn(e.line, "the BallastFactor of " + shown(e.ballast_factor) + " is applied");
  if (in.photometry != Intensity::relative) return scale;
  if (e.lamp.flux_lm < 0)
    fail_at(in.line,
            "the photometry is relative, in cd per 1000 lm; <RatedLumens> of the emitter must say of how many");
  return scale * e.lamp.flux_lm / 1000;
}

void Tm33Reader::check_counts(const Intensity& in) {
  const double found = double(in.values.size());
  if (found == 0) fail_at(in.line, "there are no intensities");
  const double expected = in.horizontal > 0 && in.vertical > 0 ? in.horizontal * in.vertical : -1;
  if (expected > found && in.measured != found)
    fail_at(in.line, "there are " + shown(found) + " intensities; NumberHorz x NumberVert asks for " + shown(expected));
  if (in.measured > 1 && in.measured != found)
    warn(in.line, "there are " + shown(found) + " intensities; NumberMeasured is " + shown(in.measured));
}

void Tm33Reader::check_symmetry(const Intensity& in, Symmetry found) {
  static constexpr std::pair<std::string_view, Symmetry> names[] = {
      {"SYMMNONE", Symmetry::none},     {"SYMMARBITRARY", Symmetry::none}, {"SYMMBI0", Symmetry::c0_c180},
      {"SYMMBI90", Symmetry::c90_c270}, {"SYMMQUAD", Symmetry::quadrants}, {"SYMMFULL", Symmetry::axial}};
  if (in.symmetry.empty() || type_ != PhotometricType::c) return;
  for (const auto& [name, symmetry] : names)
    if (in.symmetry == name) {
      if (symmetry == found) return;
      if (symmetry == Symmetry::none)
        fail_at(in.line, "Symm says that nothing is symmetric, but the angles h do not go round the circle");
      return warn(in.line,
                  "Symm is " + in.symmetry + ", which the angles h do not agree with; they are used as they are");
    }
  warn(in.line, "Symm is \"" + in.symmetry.substr(0, 40) + "\", which is not known; the angles h tell the symmetry");
}

Distribution Tm33Reader::distribution_of_emitter(EmitterPart& e, Symmetry& symmetry) {
  check_counts(e.intensity);
  const double scale = scale_of(e);
  for (DirectedValue& v : e.intensity.values) {
    v.value *= scale;
    if (!(v.value <= largest_intensity_cd)) fail_at(v.line, "an intensity of " + shown(v.value) + " cd is too large");
  }
  Distribution d = table_of(std::move(e.intensity.values), type_, e.intensity.line, symmetry, warnings_);
  check_symmetry(e.intensity, symmetry);
  const double flux = d.band_flux_lm();
  if (e.lamp.flux_lm > 0 && flux > 1.05 * e.lamp.flux_lm)
    warn(e.intensity.line,
         "the intensities add up to " + shown(flux) + " lm, more than RatedLumens, " + shown(e.lamp.flux_lm) +
             " lm; they are used as they are" +
             (e.intensity.photometry == Intensity::unstated ? " (AbsolutePhotometry is not stated; taken as true)"
                                                            : ""));
  return d;
}

Photometry Tm33Reader::finish() {
  std::vector<Distribution> parts;
  std::vector<Symmetry> symmetries;
  double rated = 0, power = 0;
  bool all_rated = true, all_relative = true;
  std::vector<LampSet> lamps;
  for (EmitterPart& e : emitters_) {
    lamps.push_back(e.lamp);
    if (e.lamp.power_w > 0) power += e.lamp.power_w;
    if (!e.intensity.line) {
      warn(e.line, "an emitter has no luminous intensities" +
                       (e.other_data.empty() ? std::string() : "; its " + e.other_data + " is not read") +
                       "; it adds nothing");
      continue;
    }
    Symmetry symmetry = Symmetry::none;
    all_relative &= e.intensity.photometry == Intensity::relative;
    parts.push_back(distribution_of_emitter(e, symmetry));
    symmetries.push_back(symmetry);
    all_rated &= e.lamp.flux_lm > 0;
    rated += std::max(0.0, e.lamp.flux_lm);
  }
  if (parts.empty())
    throw UnsupportedError(at_line(emitters_[0].line,
                                   "no emitter has luminous intensities; radiant, photon, spectral and "
                                   "illuminance data alone are not read"));
  if (parts.size() > 1 && type_ != PhotometricType::c)
    throw UnsupportedError(at_line(emitters_[1].line, "several emitters with directions of types A or B are not read"));
  if (parts.size() > 1)
    warn(emitters_[1].line, "the light of all " + std::to_string(parts.size()) + " emitters is added up");
  Photometry out{parts.size() == 1 ? std::move(parts[0]) : sum_of(parts)};
  out.type = type_;
  out.symmetry = parts.size() == 1 ? symmetries[0] : symmetry_of(out.distribution);
  if (all_rated && all_relative) out.rated_flux_lm = rated;
  if (power > 0) out.input_power_w = power;
  out.format = format_;
  out.keywords = std::move(keywords_);
  out.lamp_sets = std::move(lamps);
  return out;
}

Opening opening_of(const float (&size)[3], bool round) {
  Opening out;
  std::copy(std::begin(size), std::end(size), out.size_m);
  const int extents = (size[0] > 0) + (size[1] > 0) + (size[2] > 0);
  if (extents < 2)
    out = {};
  else if (extents == 2)
    out.shape = round && size[2] == 0 ? OpeningShape::disc : OpeningShape::rectangle;
  else
    out.shape = round ? OpeningShape::cylinder : OpeningShape::box;
  return out;
}

Photometry Tm33Reader::read() {
  read_root();
  const size_t line = xml_.line();
  children([&](std::string_view name) {
    if (name == "Header")
      read_header();
    else if (name == "Luminaire")
      read_luminaire();
    else if (name == "Equipment")
      read_equipment();
    else if (name == "Emitter")
      read_emitter();
    else
      xml_.skip();
  });
  if (emitters_.empty()) fail_at(line, "the file has no <Emitter>; at least one is needed");
  try {
    Photometry out = finish();
    out.opening = opening_of(extent_m_, round_);
    const float largest = std::max({extent_m_[0], extent_m_[1], extent_m_[2]});
    if (largest > 10)
      warn(area_line_, "a luminous opening of " + shown(largest) + " m is doubtful; are its units metres?");
    if (out.distribution.band_flux_lm() == 0) warn(emitters_[0].line, "all intensities are 0");
    out.warnings = std::move(warnings_);
    return out;
  } catch (const std::invalid_argument& e) {
    fail_at(emitters_[0].line, e.what());
  }
}

}  // namespace

Photometry read_tm33(const void* bytes, size_t size, const ReadOptions& options) {
  if (options.lamp_set != 0)
    throw std::invalid_argument("lamp_set is " + std::to_string(options.lamp_set) +
                                "; the emitters of a TM-33 file shine together, so that it must be 0");
  return Tm33Reader(decode_text(bytes, size)).read();
}

}  // namespace photometry
