// Writes EULUMDAT: the planes that the symmetry needs, one lamp set, every field in the length that the format gives it:
// intensities and angles have six characters. In the code page of its age, Latin-1, where the text allows it. Called by
// programs and the API.
#include <algorithm>
#include <cmath>

#include "photometry/c_gamma.h"
#include "photometry/eulumdat_fields.h"
#include "photometry/metrics.h"
#include "photometry/planes.h"

namespace photometry {
namespace {

// Latin-1 where that reads back as the same text, else UTF-8 as it is.
std::string in_latin_1(const std::string& utf8) {
  std::string out;
  for (size_t i = 0; i < utf8.size(); ++i) {
    const auto byte = [&](size_t k) { return static_cast<unsigned char>(utf8[k]); };
    if (byte(i) < 0x80) {
      out += utf8[i];
    } else if (byte(i) <= 0xC3 && i + 1 < utf8.size()) {
      out += char(byte(i) << 6 | (byte(i + 1) & 0x3F));
      ++i;
    } else {
      return utf8;
    }
  }
  return decode_text(out.data(), out.size()) == utf8 ? out : utf8;
}

// A keyword that the reader kept as a number; else 0.
double kept_number(const std::vector<Keyword>& keywords, std::string_view name) {
  double value = 0;
  return parse_number(keyword_value(keywords, name), value) && std::isfinite(value) ? value : 0;
}

// The number that a field of that length says.
double in_field(double value, size_t length) {
  double out = 0;
  parse_number(number_field(value, length), out);
  return out;
}

// The indices of the angles that are still apart, and below the end, when they have six characters; the angles then.
struct FieldAngles {
  std::vector<size_t> index;
  std::vector<double> deg;
};
FieldAngles field_angles(const std::vector<double>& angle, double end) {
  FieldAngles out;
  for (size_t i = 0; i < angle.size(); ++i) {
    const double deg = in_field(angle[i], 6);
    if (deg >= end || (i > 0 && !(deg > out.deg.back()))) continue;
    out.index.push_back(i);
    out.deg.push_back(deg);
  }
  return out;
}

// The table by the angles that the fields hold: not moved, but called so.
Distribution in_fields(const Distribution& d) {
  const bool axial = d.c_deg().size() == 1;  // its plane stands for all, whatever its angle
  const FieldAngles c = axial ? FieldAngles{{0}, {0}} : field_angles(d.c_deg(), 360),
                    gamma = field_angles(d.gamma_deg(), 361);
  if (c.deg == d.c_deg() && gamma.deg == d.gamma_deg()) return d;
  if (gamma.deg.size() < 2)
    throw std::invalid_argument("the rows of the table lie too close together for the six characters of an angle");
  std::vector<double> table;
  for (size_t i : c.index)
    for (size_t j : gamma.index) table.push_back(d.at(i, j));
  return Distribution(c.deg, gamma.deg, std::move(table));
}

// A table that leaves a part of the circle open, which readers take for a file that lacks a symmetry, has a plane more
// in the middle of it. It is interpolated, and changes nothing.
Distribution closed(const Distribution& d) {
  const double open = open_end_deg(d.c_deg());
  if (open == 0 || symmetry_of(d) != Symmetry::none) return d;
  std::vector<double> c = d.c_deg(), table;
  for (size_t i = 0; i < c.size(); ++i)
    for (size_t j = 0; j < d.gamma_deg().size(); ++j) table.push_back(d.at(i, j));
  for (size_t j = 0; j < d.gamma_deg().size(); ++j) table.push_back(0.5 * (d.at(c.size() - 1, j) + d.at(0, j)));
  c.push_back(c.back() + open / 2);
  return Distribution(std::move(c), d.gamma_deg(), std::move(table));
}

// All C angles, and the planes that are stored, in the format's order.
struct StoredPlanes {
  int isym;
  std::vector<double> c_deg;
  std::vector<size_t> index;
};
StoredPlanes stored_planes(const Distribution& d, Symmetry symmetry) {
  const std::vector<double>& c = d.c_deg();
  StoredPlanes out{0, c, {}};
  const auto add = [&](double a, double b) {
    for (size_t i = 0; i < c.size(); ++i)
      if (c[i] >= a - 1e-9 && c[i] <= b + 1e-9) out.index.push_back(i);
  };
  for (double& angle : out.c_deg)
    for (double nominal : {90.0, 180.0, 270.0})
      if (std::abs(angle - nominal) < 1e-9) angle = nominal;
  switch (symmetry) {
    case Symmetry::axial:
      return {1, {0}, {0}};
    case Symmetry::c0_c180:
      out.isym = 2, add(0, 180);
      break;
    case Symmetry::c90_c270:
      out.isym = 3, add(270, 360), add(0, 90);
      break;
    case Symmetry::quadrants:
      out.isym = 4, add(0, 90);
      break;
    default:
      add(0, 360);
  }
  return out;
}

// The step of evenly spaced angles, 0 for others.
double even_step(const std::vector<double>& angle, double end) {
  if (angle.size() < 2) return 0;
  const double step = in_field(angle[1] - angle[0], 5);
  for (size_t i = 1; i < angle.size(); ++i)
    if (std::abs(angle[i] - angle[0] - double(i) * step) > 1e-9) return 0;
  return end == 0 || std::abs(angle.back() + step - end) < 1e-9 ? step : 0;
}

// The flux that the intensities are per 1000 lm of, as its field has it, and whether it is the luminaire's (absolute
// photometry).
double reference_flux(const Photometry& p, bool& absolute) {
  constexpr double least = 1e-3;  // a rating below it is none, and the quotients stay within a double's range
  absolute = !(p.rated_flux_lm >= least);
  double stated = p.rated_flux_lm;
  if (absolute)
    stated = p.lamp_set < p.lamp_sets.size() && p.lamp_sets[p.lamp_set].count < 0 ? p.lamp_sets[p.lamp_set].flux_lm
                                                                                  : flux_lm(p);
  if (!(stated >= least)) return 1000;
  const double field = in_field(stated, 12);
  if (!(field > 0))
    throw std::invalid_argument("the flux, " + shortest(stated) + " lm, has more than the 12 characters of its field");
  return field;
}

// The factor on all intensities, 1 unless those of six characters would be too small or too large for five digits.
double conversion_factor(double peak_per_klm) {
  constexpr double least = 1, most = 999999, least_factor = 1e-4, most_factor = 1e5;
  double factor = 1;
  while (peak_per_klm / factor >= most && factor < most_factor) factor *= 10;
  while (peak_per_klm > 0 && peak_per_klm / factor < least && factor > 1.5 * least_factor) factor /= 10;
  return factor;
}

struct Millimetres {
  double length, width, height;
};
Millimetres in_mm(const Opening& o) {
  const bool round = o.shape == OpeningShape::disc || o.shape == OpeningShape::sphere ||
                     (o.shape == OpeningShape::cylinder && o.axis == 2);
  const bool circle = round && o.size_m[0] == o.size_m[1];
  const bool none = o.shape == OpeningShape::point;
  const auto mm = [&](int axis) {
    constexpr double least = 0.01;  // 0 would make another shape
    return none || o.size_m[axis] == 0 ? 0 : std::max(least, 1000 * shorter(o.size_m[axis]));
  };
  return {mm(1), circle ? 0 : mm(0) == 0 && mm(1) > 0 ? 1 : mm(0), mm(2)};  // width 0: round; a sheet has 1 mm
}

void add_opening(const Millimetres& opening, EulumdatFields& out) {
  out.number(opening.length, 4, "the luminous length in mm");
  out.number(opening.width, 4, "the luminous width in mm");
  for (int side = 0; side < 4; ++side) out.number(opening.height, 4, "a luminous height in mm");
}

void add_lamps(const Photometry& p, double flux, bool absolute, EulumdatFields& out) {
  const LampSet lamps = p.lamp_set < p.lamp_sets.size() ? p.lamp_sets[p.lamp_set] : LampSet{};
  const int count = std::max(1, std::abs(lamps.count));
  const auto stated = [&](const std::string& text, const char* name) {
    return text.empty() ? keyword_value(p.keywords, name) : text;
  };
  out.number(1, 4, "the number of lamp sets");
  out.number(absolute ? -count : count, 4, "the number of lamps");
  out.text(stated(lamps.type, "LAMP"), 24, "the lamps' type");
  out.number(flux, 12, "the lamps' flux");
  out.text(stated(lamps.colour, "_COLOUR"), 16, "the lamps' colour");
  out.text(stated(lamps.colour_rendering, "_COLOUR_RENDERING"), 6, "the lamps' colour rendering");
  out.number(std::max(0.0, p.input_power_w), 8, "the lamps' power");
}

// Percent of the light below the horizon: of the part of the table up to 90 degrees, by the band rule.
double downward_percent(const Distribution& d) {
  std::vector<double> gamma;
  for (double g : d.gamma_deg())
    if (g < 90) gamma.push_back(g);
  if (d.gamma_deg().back() >= 90 && !gamma.empty()) gamma.push_back(90);
  if (gamma.size() < 2 || !(d.band_flux_lm() > 0)) return 0;
  return std::min(100.0, 100 * d.resampled(d.c_deg(), gamma).band_flux_lm() / d.band_flux_lm());
}

// 0, not stated, where four characters cannot say it within a percent, which a reader would check.
double light_output_percent(double flux, double reference) {
  const double percent = 100 * flux / reference, tenths = std::round(10 * percent) / 10, written = in_field(tenths, 4);
  return std::abs(written - percent) <= 0.01 * percent ? written : 0;
}

void add_head(const Photometry& p, const Distribution& d, const StoredPlanes& planes, EulumdatFields& out) {
  const auto keyword = [&](const char* name) { return keyword_value(p.keywords, name); };
  out.text(keyword("MANUFAC"), 78, "the maker");
  out.number(planes.isym == 1 ? 1 : kept_number(p.keywords, "_ITYP") == 2 ? 2 : 3, 1, "Ityp");
  out.number(planes.isym, 1, "Isym");
  // The description has two characters for the counts; tables of a degree need three, and readers take them.
  out.number(double(planes.c_deg.size()), 7, "Mc");
  out.number(even_step(planes.c_deg, 360), 5, "Dc");
  out.number(double(d.gamma_deg().size()), 7, "Ng");
  out.number(even_step(d.gamma_deg(), 0), 5, "Dg");
  out.text(keyword("TEST"), 78, "the report's number");
  out.text(keyword("LUMINAIRE"), 78, "the luminaire's name");
  out.text(keyword("LUMCAT"), 78, "the luminaire's number");
  out.text(keyword("_FILENAME"), 8, "the file's name");
  out.text(keyword("ISSUEDATE"), 78, "the date");
  // That of a luminaire whose body nobody has stated is its opening's: width 0 would make it round.
  Millimetres body{kept_number(p.keywords, "_LENGTH_MM"), kept_number(p.keywords, "_WIDTH_MM"),
                   kept_number(p.keywords, "_HEIGHT_MM")};
  if (body.length == 0 && body.width == 0 && body.height == 0) body = in_mm(p.opening);
  out.number(body.length, 4, "the luminaire's length in mm");
  out.number(body.width, 4, "the luminaire's width in mm");
  out.number(body.height, 4, "the luminaire's height in mm");
}

void add_direct_ratios(const std::vector<Keyword>& keywords, EulumdatFields& out) {
  const std::string kept = keyword_value(keywords, "_DIRECT_RATIOS");
  TextReader text(kept);
  std::string_view ratio;
  for (int i = 0; i < 10; ++i) {
    double value = 0;
    const bool stated = text.next_token(ratio) && parse_number(ratio, value) && std::isfinite(value);
    out.number(stated ? value : 0, 7, "a direct ratio");
  }
}

}  // namespace

std::string write_eulumdat(const Photometry& p, std::vector<std::string>* warnings) {
  std::vector<std::string> cut;
  EulumdatFields out(cut);
  // The symmetry is that of the angles as they are: 354.375, the image of 5.625, is 354.38 in its field.
  const Distribution exact = closed(in_c_gamma(p.distribution)), d = in_fields(exact);
  const StoredPlanes planes = stored_planes(d, symmetry_of(exact));
  bool absolute;
  const double flux = reference_flux(p, absolute), per_klm = 1000 / flux,
               factor = conversion_factor(d.peak_cd() * per_klm);
  add_head(p, d, planes, out);
  add_opening(in_mm(p.opening), out);
  out.number(std::round(10 * downward_percent(d)) / 10, 4, "the downward flux fraction");
  out.number(light_output_percent(d.band_flux_lm(), flux), 4, "the light output ratio");
  out.number(factor, 6, "the conversion factor");
  out.number(kept_number(p.keywords, "_TILT_DEG"), 6, "the tilt");
  add_lamps(p, flux, absolute, out);
  add_direct_ratios(p.keywords, out);
  for (double c : planes.c_deg) out.number(c, 6, "a C angle");
  for (double gamma : d.gamma_deg()) out.number(gamma, 6, "an angle gamma");
  for (size_t i : planes.index)
    for (size_t j = 0; j < d.gamma_deg().size(); ++j) out.number(d.at(i, j) * per_klm / factor, 6, "an intensity");
  std::string text = in_latin_1(std::move(out).all());
  if (warnings) {
    warnings->insert(warnings->end(), cut.begin(), cut.end());
    check_written(p, text, *warnings);
  }
  return text;
}

}  // namespace photometry
