// The photometry of ANSI/IES TM-33 files from their elements (tm33_elements.h, which says what is read): the emitters'
// intensities in candelas, added up, what the file says of them checked against each other, and the luminous opening.
// Called by programs and by read().
#include "photometry/tm33_elements.h"

#include <algorithm>
#include <cmath>

#include "photometry/planes.h"
#include "photometry/text_reader.h"

namespace photometry {
namespace {

constexpr double largest_intensity_cd = 1e12;
constexpr double most_relative_lm = 1050;  // of a table per 1000 lm

// Half a circle from 270 across 0 to 90 is one from -90 to 90.
void join_halves(std::vector<DirectedValue>& values) {
  const auto has = [&](const auto& is) {
    return std::any_of(values.begin(), values.end(), [&](const DirectedValue& v) { return is(v.h_deg); });
  };
  if (has([](double h) { return h < 0 || (h > 90 && h < 270) || h > 360; }) || !has([](double h) { return h == 90; }) ||
      !has([](double h) { return h == 270; }))
    return;
  for (DirectedValue& v : values)
    if (v.h_deg >= 270) v.h_deg -= 360;
}

class Tm33Light {
 public:
  explicit Tm33Light(Tm33File file) : file_(std::move(file)) {}
  Photometry photometry();

 private:
  void warn(size_t line, const std::string& what) { file_.warnings.push_back(at_line(line, what)); }
  double scale_of(const Tm33Emitter& emitter);
  void check_counts(const Tm33Intensity& intensity);
  void check_symmetry(const Tm33Intensity& intensity, Symmetry found);
  Distribution distribution_of_emitter(Tm33Emitter& emitter, Symmetry& symmetry);
  Photometry sum_of_emitters();
  Opening opening();

  Tm33File file_;
};

// What the values of an emitter are multiplied with to be candelas.
double Tm33Light::scale_of(const Tm33Emitter& e) {
  const Tm33Intensity& in = e.intensity;
  double scale = in.multiplier * e.ballast_factor;
  if (e.ballast_factor != 1) warn(e.line, "the BallastFactor of " + shown(e.ballast_factor) + " is applied");
  if (in.photometry != Tm33Intensity::relative) return scale;
  if (e.lamp.flux_lm < 0)
    fail_at(in.line,
            "the photometry is relative, in cd per 1000 lm; <RatedLumens> of the emitter must say of how many");
  return scale * e.lamp.flux_lm / 1000;
}

void Tm33Light::check_counts(const Tm33Intensity& in) {
  const double found = double(in.values.size());
  if (found == 0) fail_at(in.line, "there are no intensities");
  const double expected = in.horizontal > 0 && in.vertical > 0 ? in.horizontal * in.vertical : -1;
  if (expected > found && in.measured != found)
    fail_at(in.line, "there are " + shown(found) + " intensities; NumberHorz x NumberVert asks for " + shown(expected));
  if (in.measured > 1 && in.measured != found)
    warn(in.line, "there are " + shown(found) + " intensities; NumberMeasured is " + shown(in.measured));
}

void Tm33Light::check_symmetry(const Tm33Intensity& in, Symmetry found) {
  static constexpr std::pair<std::string_view, Symmetry> names[] = {
      {"SYMMNONE", Symmetry::none},     {"SYMMARBITRARY", Symmetry::none}, {"SYMMBI0", Symmetry::c0_c180},
      {"SYMMBI90", Symmetry::c90_c270}, {"SYMMQUAD", Symmetry::quadrants}, {"SYMMFULL", Symmetry::axial}};
  if (in.symmetry.empty() || file_.type != PhotometricType::c) return;
  for (const auto& [name, symmetry] : names)
    if (in.symmetry == name) {
      if (symmetry == found) return;
      if (symmetry == Symmetry::none)
        fail_at(in.line, "Symm says that nothing is symmetric, but the angles h do not go round the circle");
      return warn(in.line,
                  "Symm is " + in.symmetry + ", which the angles h do not agree with; they are used as they are");
    }
  warn(in.line, "Symm is \"" + cut(in.symmetry) + "\", which is not known; the angles h tell the symmetry");
}

Distribution Tm33Light::distribution_of_emitter(Tm33Emitter& e, Symmetry& symmetry) {
  check_counts(e.intensity);
  const double scale = scale_of(e);
  for (DirectedValue& v : e.intensity.values) {
    v.value *= scale;
    if (!(v.value <= largest_intensity_cd)) fail_at(v.line, "an intensity of " + shown(v.value) + " cd is too large");
  }
  if (file_.type == PhotometricType::c && e.intensity.symmetry == "SYMMBI90") join_halves(e.intensity.values);
  Distribution d = table_of(std::move(e.intensity.values), file_.type, e.intensity.line, symmetry, file_.warnings);
  check_symmetry(e.intensity, symmetry);
  check_poles(d, e.intensity.line, file_.warnings);
  const double flux = d.band_flux_lm();
  if (e.lamp.flux_lm > 0 && flux > 1.05 * e.lamp.flux_lm)
    warn(e.intensity.line,
         "the intensities add up to " + shown(flux) + " lm, more than RatedLumens, " + shown(e.lamp.flux_lm) +
             " lm; they are used as they are" +
             (e.intensity.photometry == Tm33Intensity::unstated ? " (AbsolutePhotometry is not stated; taken as true)"
                                                                : ""));
  if (e.intensity.photometry != Tm33Intensity::relative && flux < most_relative_lm && flux < 0.5 * e.lamp.flux_lm)
    warn(e.intensity.line,
         "the intensities add up to " + shown(flux) + " lm, far below RatedLumens, " + shown(e.lamp.flux_lm) +
             " lm, as those in cd per 1000 lm do; they are used as they are" +
             (e.intensity.photometry == Tm33Intensity::unstated ? " (AbsolutePhotometry is not stated; taken as true)"
                                                                : ", as AbsolutePhotometry says"));
  return d;
}

Photometry Tm33Light::sum_of_emitters() {
  std::vector<Distribution> parts;
  std::vector<Symmetry> symmetries;
  double rated = 0, power = 0;
  bool all_rated = true, all_relative = true, all_powered = true;
  std::vector<LampSet> lamps;
  for (Tm33Emitter& e : file_.emitters) {
    lamps.push_back(e.lamp);
    if (!e.intensity.line) {
      warn(e.line, "an emitter has no luminous intensities" +
                       (e.other_data.empty() ? std::string() : "; its " + e.other_data + " is not read") +
                       "; it adds nothing");
      continue;
    }
    Symmetry symmetry = Symmetry::none;
    all_relative &= e.intensity.photometry == Tm33Intensity::relative;
    parts.push_back(distribution_of_emitter(e, symmetry));
    symmetries.push_back(symmetry);
    all_rated &= e.lamp.flux_lm > 0;
    all_powered &= e.lamp.power_w > 0;
    power += std::max(0.0, e.lamp.power_w);
    rated += std::max(0.0, e.lamp.flux_lm);
  }
  if (parts.empty())
    throw UnsupportedError(at_line(file_.emitters[0].line,
                                   "no emitter has luminous intensities; radiant, photon, spectral and "
                                   "illuminance data alone are not read"));
  if (parts.size() > 1 && file_.type != PhotometricType::c)
    throw UnsupportedError(
        at_line(file_.emitters[1].line, "several emitters with directions of types A or B are not read"));
  if (parts.size() > 1)
    warn(file_.emitters[1].line, "the light of all " + std::to_string(parts.size()) + " emitters is added up");
  Photometry out{parts.size() == 1 ? std::move(parts[0]) : sum_of(parts)};
  out.type = file_.type;
  out.symmetry = parts.size() == 1 ? symmetries[0] : symmetry_of(out.distribution);
  if (all_rated && all_relative) out.rated_flux_lm = rated;
  if (all_powered)
    out.input_power_w = power;
  else if (power > 0)
    warn(file_.emitters[0].line, "not every emitter with light states its input power; the sum is not known");
  out.format = file_.format;
  out.keywords = std::move(file_.keywords);
  out.lamp_sets = std::move(lamps);
  out.lamps_shine_together = true;
  return out;
}

void check(const Tm33Area& area) {
  for (int k = 0; k < 3; ++k) {
    if (!(area.size_m[k] >= 0 && area.size_m[k] <= 1e6))
      fail_at(area.line, "an emission area has a size of " + shown(area.size_m[k]) +
                             " m; it must be from 0 to a million");
    if (!(std::abs(area.offset_m[k]) <= 1e6))
      fail_at(area.line, "an emission area has an offset of " + shown(area.offset_m[k]) +
                             " m; it must be within a million");
  }
}

// The box that holds all areas; round where those of top and bottom are one disc. An opening is about the luminaire's
// middle, so that where the box lies does not matter.
Opening Tm33Light::opening() {
  if (file_.areas.empty()) return {};
  for (const Tm33Area& area : file_.areas) check(area);
  Opening out;
  const Tm33Area* level = nullptr;  // the first of top and bottom
  bool round = false, differ = false;
  float (&size)[3] = out.size_m;
  for (int k = 0; k < 3; ++k) {
    double low = INFINITY, high = -INFINITY;
    for (const Tm33Area& a : file_.areas) {
      low = std::min(low, a.offset_m[k] - 0.5 * a.size_m[k]), high = std::max(high, a.offset_m[k] + 0.5 * a.size_m[k]);
      if (a.face != 2) continue;
      if (!level) level = &a, round = a.round;
      differ |= a.round != round || a.size_m[k] != level->size_m[k] || a.offset_m[k] != level->offset_m[k];
    }
    size[k] = float(high - low);
  }
  if (differ) {
    round = false;
    warn(level->line, "the emission areas differ in size or place; the luminous opening is the box around them, " +
                          shown(size[0]) + " x " + shown(size[1]) + " x " + shown(size[2]) + " m");
  }
  const float largest = std::max({size[0], size[1], size[2]});
  if (largest > 10)
    warn(file_.areas.back().line,
         "a luminous opening of " + shown(largest) + " m is doubtful; are its units metres?");
  const int extents = (size[0] > 0) + (size[1] > 0) + (size[2] > 0);
  if (extents == 0)
    out = {};
  else if (extents < 3)  // one extent: a line
    out.shape = round && size[2] == 0 ? OpeningShape::disc : OpeningShape::rectangle;
  else
    out.shape = round ? OpeningShape::cylinder : OpeningShape::box;
  return out;
}

Photometry Tm33Light::photometry() {
  try {
    Photometry out = sum_of_emitters();
    out.opening = opening();
    if (out.distribution.band_flux_lm() == 0) warn(file_.emitters[0].line, "all intensities are 0");
    out.warnings = std::move(file_.warnings);
    return out;
  } catch (const std::invalid_argument& e) {
    fail_at(file_.emitters[0].line, e.what());
  }
}

}  // namespace

Photometry read_tm33(const void* bytes, size_t size, const ReadOptions& options) {
  if (options.lamp_set != 0)
    throw std::invalid_argument("lamp_set is " + std::to_string(options.lamp_set) +
                                "; the emitters of a TM-33 file shine together, so that it must be 0");
  Photometry out = Tm33Light(read_tm33_elements(decode_text(bytes, size))).photometry();
  if (options.tilt_deg >= 0) out.warnings.push_back(no_tilt_table(options.tilt_deg));
  return out;
}

}  // namespace photometry
