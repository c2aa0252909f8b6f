// Writes EULUMDAT: the planes that the symmetry needs, one lamp set, numbers of as few digits as read back to the same
// bits. In the code page of its age, Latin-1, where the text allows it. Called by programs and the API.
#include <cmath>

#include "photometry/planes.h"
#include "photometry/writer_text.h"

namespace photometry {
namespace {

class Lines {
 public:
  void text(const std::string& value) { text_ += one_line(value) + "\r\n"; }
  void number(double value) { text(shortest(value)); }
  void numbers(const std::vector<double>& values) {
    for (double v : values) number(v);
  }
  std::string all() && { return std::move(text_); }

 private:
  std::string text_;
};

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

// All C angles, and the planes that are stored, in the format's order.
struct StoredPlanes {
  int isym;
  std::vector<double> c_deg;
  std::vector<size_t> index;
};
StoredPlanes stored_planes(const Distribution& d) {
  const std::vector<double>& c = d.c_deg();
  StoredPlanes out{0, c, {}};
  const auto add = [&](double a, double b) {
    for (size_t i = 0; i < c.size(); ++i)
      if (c[i] >= a - 1e-9 && c[i] <= b + 1e-9) out.index.push_back(i);
  };
  for (double& angle : out.c_deg)
    for (double nominal : {90.0, 180.0, 270.0})
      if (std::abs(angle - nominal) < 1e-9) angle = nominal;
  switch (symmetry_of(d)) {
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
  const double step = angle[1] - angle[0];
  for (size_t i = 1; i < angle.size(); ++i)
    if (std::abs(angle[i] - angle[0] - double(i) * step) > 1e-9) return 0;
  return end == 0 || std::abs(angle.back() + step - end) < 1e-9 ? step : 0;
}

// The flux that the intensities are per 1000 lm of, and whether it is the luminaire's (absolute photometry).
double reference_flux(const Photometry& p, const Distribution& d, bool& absolute) {
  constexpr double least = 1e-3;  // a rating below it is none, and the quotients stay within a double's range
  absolute = !(p.rated_flux_lm >= least);
  if (!absolute) return p.rated_flux_lm;
  const double stated = p.lamp_set < p.lamp_sets.size() && p.lamp_sets[p.lamp_set].count < 0
                            ? p.lamp_sets[p.lamp_set].flux_lm
                            : d.band_flux_lm();
  return stated >= least ? stated : 1000;
}

void add_opening(const Opening& o, Lines& out) {
  const bool round = o.shape == OpeningShape::disc || o.shape == OpeningShape::sphere ||
                     (o.shape == OpeningShape::cylinder && o.axis == 2);
  const bool circle = round && o.size_m[0] == o.size_m[1];
  const bool none = o.shape == OpeningShape::point;
  const auto mm = [&](int axis) { return none ? 0 : 1000 * shorter(o.size_m[axis]); };
  out.number(mm(1));
  out.number(circle ? 0 : mm(0) == 0 && mm(1) > 0 ? 1 : mm(0));  // 0 would make it round: a sheet has 1 mm
  for (int side = 0; side < 4; ++side) out.number(mm(2));
}

void add_lamps(const Photometry& p, double flux, bool absolute, Lines& out) {
  const LampSet lamps = p.lamp_set < p.lamp_sets.size() ? p.lamp_sets[p.lamp_set] : LampSet{};
  const int count = std::max(1, std::abs(lamps.count));
  out.number(1);
  out.number(absolute ? -count : count);
  out.text(lamps.type.empty() ? keyword_value(p.keywords, "LAMP") : lamps.type);
  out.number(flux);
  out.text(lamps.colour.empty() ? keyword_value(p.keywords, "_COLOUR") : lamps.colour);
  out.text(lamps.colour_rendering.empty() ? keyword_value(p.keywords, "_COLOUR_RENDERING") : lamps.colour_rendering);
  out.number(std::max(0.0, p.input_power_w));
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

}  // namespace

std::string write_eulumdat(const Photometry& p, std::vector<std::string>* warnings) {
  const Distribution d = p.distribution.in_c_gamma();
  const StoredPlanes planes = stored_planes(d);
  bool absolute;
  const double flux = reference_flux(p, d, absolute);
  const auto keyword = [&](const char* name) { return keyword_value(p.keywords, name); };
  const auto percent = [](double value) { return std::round(10 * value) / 10; };
  Lines out;
  out.text(keyword("MANUFAC"));
  out.number(planes.isym == 1 ? 1 : kept_number(p.keywords, "_ITYP") == 2 ? 2 : 3);
  out.number(planes.isym);
  out.number(double(planes.c_deg.size()));
  out.number(even_step(planes.c_deg, 360));
  out.number(double(d.gamma_deg().size()));
  out.number(even_step(d.gamma_deg(), 0));
  for (const char* name : {"TEST", "LUMINAIRE", "LUMCAT", "_FILENAME", "ISSUEDATE"}) out.text(keyword(name));
  for (const char* name : {"_LENGTH_MM", "_WIDTH_MM", "_HEIGHT_MM"}) out.number(kept_number(p.keywords, name));
  add_opening(p.opening, out);
  out.number(percent(downward_percent(d)));
  out.number(absolute && flux == d.band_flux_lm() ? 100 : percent(100 * d.band_flux_lm() / flux));
  out.number(1);  // conversion factor
  out.number(kept_number(p.keywords, "_TILT_DEG"));
  add_lamps(p, flux, absolute, out);
  std::string_view ratios = "";
  const std::string kept = keyword("_DIRECT_RATIOS");
  TextReader ratio_text(kept);
  for (int i = 0; i < 10; ++i) {
    double value = 0;
    out.number(ratio_text.next_token(ratios) && parse_number(ratios, value) && std::isfinite(value) ? value : 0);
  }
  out.numbers(planes.c_deg);
  out.numbers(d.gamma_deg());
  for (size_t i : planes.index)
    for (size_t j = 0; j < d.gamma_deg().size(); ++j) out.number(d.at(i, j) * 1000 / flux);
  std::string text = in_latin_1(std::move(out).all());
  if (warnings) check_written(p, text, *warnings);
  return text;
}

}  // namespace photometry
