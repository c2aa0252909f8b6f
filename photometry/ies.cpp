// Reads IES LM-63 files of 1986, 1991, 1995, 2002 and 2019, of photometric types A, B and C, as strictly as their data
// allows: what would change the light is an error, what is only odd is a warning, each with its line. Called by
// programs and the API.
//
// Layout: label lines, TILT=, then numbers alone: 10 fields, 3 fields, vertical angles, horizontal angles, candelas
// plane by plane. Records may wrap anywhere.
#include <algorithm>
#include <cmath>

#include "photometry/ies_header.h"
#include "photometry/ies_opening.h"
#include "photometry/ies_planes.h"
#include "photometry/metrics.h"

namespace photometry {
namespace {

constexpr double largest_intensity_cd = 1e12, most_ballast_factor = 2;

class IesReader {
 public:
  IesReader(std::string text, const ReadOptions& options) : in_(std::move(text)), options_(options) {}
  Photometry read();

 private:
  void warn(size_t line, const std::string& what) { warnings_.push_back(at_line(line, what)); }
  double number(const std::string& name) { return in_.number(name); }
  double number_or_one(const std::string& name);
  double read_tilt();
  void read_lamps();
  void read_opening();
  double read_factors();
  std::vector<double> read_angles(const char* kind, size_t n, bool& descending);
  void read_candelas(double scale);
  void check_flux(const Photometry& photometry);
  void read_lamp_keywords(const std::vector<Keyword>& keywords);
  Photometry finish();

  TextReader in_;
  const ReadOptions& options_;
  IesHeader header_;
  std::vector<std::string> warnings_;
  Tilt tilt_;
  std::string tilt_file_name_;
  LampSet lamps_;
  double rated_flux_lm_ = -1, input_power_w_ = -1, file_generation_ = -1, multiplier_ = 1;
  size_t vertical_count_ = 0, horizontal_count_ = 0, flux_line_ = 0, vertical_line_ = 0, table_line_ = 0;
  Opening opening_;
  IesTable table_;
};

// TILT= and, where it names a table, what it multiplies the intensities with.
double IesReader::read_tilt() {
  const size_t line = header_.tilt_line;
  const std::string kind = upper_case(header_.tilt);
  if (in_.detect_decimal_commas()) warn(line + 1, "the numbers have decimal commas");
  if (kind == "NONE") {
    if (options_.tilt_deg >= 0) warn(line, no_tilt_table(options_.tilt_deg));
    return 1;
  }
  if (kind == "INCLUDE") {
    tilt_ = read_tilt_table(in_, warnings_);
  } else {
    tilt_file_name_ = header_.tilt;
    if (header_.edition == IesEdition::y2019)
      warn(line, "TILT= names a file, which LM-63-2019 does not have; read as earlier editions mean it");
    const std::string name = "the TILT file \"" + header_.tilt + "\"";
    if (!options_.tilt_file) {
      warn(line, name + " is not read; taken as TILT=NONE");
      return 1;
    }
    std::vector<std::string> warnings;
    try {
      TextReader file(decode_text(options_.tilt_file, options_.tilt_file_size));
      file.detect_decimal_commas();
      tilt_ = read_tilt_table(file, warnings);
    } catch (const ParseError& e) {
      fail_at(line, name + ": " + e.what());
    }
    for (const std::string& w : warnings) warn(line, name + ": " + w);
  }
  if (!(options_.tilt_deg >= 0)) {
    warn(line, "the TILT factors are not applied");
    return 1;
  }
  const double factor = tilt_factor(tilt_, options_.tilt_deg);
  warn(line, "the intensities are multiplied by " + shown(factor) + ", the TILT factor at " +
                 shown(options_.tilt_deg) + " degrees");
  tilt_ = {};  // the intensities hold for that tilt alone
  return factor;
}

double IesReader::number_or_one(const std::string& name) {
  const double value = number(name);
  if (!std::isfinite(value) || value < 0)
    fail_at(in_.line(), name + " is " + shown(value) + "; it must be greater than 0");
  if (value == 0) warn(in_.line(), name + " is 0; taken as 1");
  return value == 0 ? 1 : value;
}

// The first fields: lamps, lumens, multiplier, counts, photometric type.
void IesReader::read_lamps() {
  const double lamps = number("the number of lamps"), lumens = number("the lumens per lamp");
  flux_line_ = in_.line();
  if (!(std::abs(lamps) <= 1e9) || !(std::abs(lumens) <= 1e12))
    fail_at(flux_line_, "the lamps and their lumens are " + shown(lamps) + " and " + shown(lumens) +
                            "; more than 1e9 lamps or 1e12 lm are not read");
  lamps_.count = std::abs(lamps - std::round(lamps)) < 1e-6 ? int(std::lround(lamps)) : 0;
  if (lamps > 0 && lumens > 0) {
    rated_flux_lm_ = lamps_.flux_lm = lamps * lumens;
  } else if (lumens >= 0) {
    warn(flux_line_, "the rated flux is " + shown(lamps) + " x " + shown(lumens) + " lm; read as absolute photometry");
  }
  multiplier_ = number_or_one("the candela multiplier");
  vertical_count_ = in_.count("the number of vertical angles", 2);
  horizontal_count_ = in_.count("the number of horizontal angles", 1);
  if (vertical_count_ > Distribution::max_values / horizontal_count_)
    fail_at(in_.line(), std::to_string(vertical_count_) + " x " + std::to_string(horizontal_count_) +
                            " candelas are too many; at most 4000000 are read");
  const size_t type = in_.count("the photometric type", 0);
  table_.type = type == 2 ? PhotometricType::b : type == 3 ? PhotometricType::a : PhotometricType::c;
  if (type == 0) warn(in_.line(), "the photometric type is 0; taken as type C");
  if (type > 3)
    fail_at(in_.line(), "the photometric type is " + std::to_string(type) + "; it must be 1 (C), 2 (B) or 3 (A)");
}

void IesReader::read_opening() {
  const size_t units = in_.count("the units type", 0);
  if (units != 1 && units != 2)
    fail_at(in_.line(), "the units type is " + std::to_string(units) + "; it must be 1 (feet) or 2 (metres)");
  const double metre = units == 1 ? 0.3048 : 1.0;
  const double width = metre * number("the opening's width"), length = metre * number("the opening's length"),
               height = metre * number("the opening's height");
  const double largest = std::fmax(std::fmax(std::abs(width), std::abs(length)), std::abs(height));
  if (!std::isfinite(width + length + height) || largest > 1e6)
    fail_at(in_.line(), "the luminous opening's dimensions must be finite and below a million metres");
  if (largest > 10)
    warn(in_.line(), "a luminous opening of " + shown(largest) + " m is doubtful; are its units right?");
  const OpeningMatch match = ies_opening(header_.edition, width, length, height, opening_);
  // The direction (0, 0), forward, is vertical in types B and C, but horizontal in type A (LM-63-2002, "photometric
  // zero" and "photometric horizontal"): there the length lies along forward and the height along up. Without a height
  // that would be a sheet edge-on to the aim; writers mean the face.
  if (table_.type == PhotometricType::a && height != 0) {
    std::swap(opening_.size_m[0], opening_.size_m[2]);
    if (opening_.shape == OpeningShape::cylinder) opening_.axis = 2 - opening_.axis;  // y stays y
  }
  const std::string written = shown(width) + ", " + shown(length) + ", " + shown(height) + " m";
  if (match == OpeningMatch::other_edition)
    warn(in_.line(), "the opening " + written + " is a code of another edition; read as that edition means it");
  if (match == OpeningMatch::unknown)
    warn(in_.line(), "the opening " + written + " is no known code; taken as a box of that size");
}

// Ballast factor, the field whose meaning changed in 1995, watts. Returns what the candelas are multiplied with.
double IesReader::read_factors() {
  const double ballast = number_or_one("the ballast factor");
  if (ballast > most_ballast_factor)
    warn(in_.line(), "a ballast factor of " + shown(ballast) + " is doubtful; it is applied");
  double scale = multiplier_ * ballast;
  if (header_.edition <= IesEdition::y1991) {
    scale *= number_or_one("the ballast-lamp photometric factor");
  } else {
    const double value =
        number(header_.edition == IesEdition::y2019 ? "the file generation type" : "the field for future use");
    static constexpr double types[] = {1.00001, 1.0001, 1.0, 1.001, 1.01, 1.011, 1.1, 1.101, 1.11, 1.111};
    const bool known =
        std::any_of(std::begin(types), std::end(types), [&](double t) { return std::isless(std::abs(value - t), 5e-6); });
    if (header_.edition == IesEdition::y2019 && known) file_generation_ = value;
    if (header_.edition == IesEdition::y2019 ? !known : value != 1)
      warn(in_.line(), "the field after the ballast factor is " + shown(value) + "; it is no factor in " +
                           name_of(header_.edition) + " and is not applied");
  }
  const double watts = number("the input watts");
  if (std::isfinite(watts) && watts > 0) input_power_w_ = watts;
  if (!std::isfinite(watts) || watts < 0)
    warn(in_.line(), "the input power is " + shown(watts) + " W; taken as not stated");
  return scale;
}

std::vector<double> IesReader::read_angles(const char* kind, size_t n, bool& descending) {
  std::vector<double> angle;
  for (size_t i = 0; i < n; ++i) {
    angle.push_back(number(std::string(kind) + " angle " + std::to_string(i + 1) + " of " + std::to_string(n)));
    if (!std::isfinite(angle[i])) fail_at(in_.line(), std::string("a ") + kind + " angle is not finite");
    if (i == 1) descending = angle[1] < angle[0];
    if (i > 0 && (descending ? !(angle[i] < angle[i - 1]) : !(angle[i] > angle[i - 1])))
      fail_at(in_.line(), std::string(kind) + " angle " + std::to_string(i + 1) + " is " + shown(angle[i]) + " after " +
                              shown(angle[i - 1]) + "; angles must ascend" +
                              (vertical_count_ != horizontal_count_
                                   ? " (are the numbers of vertical and horizontal angles swapped?)"
                                   : ""));
  }
  if (descending) warn(in_.line(), std::string("the ") + kind + " angles descend; their order is turned round");
  return angle;
}

void IesReader::read_candelas(double scale) {
  size_t negative = 0, negative_line = 0;
  const size_t all = table_.planes.size() * vertical_count_;
  for (size_t h = 0; h < table_.planes.size(); ++h) {
    for (size_t v = 0; v < vertical_count_; ++v) {
      double value = in_.number("candela value ", h * vertical_count_ + v + 1, all) * scale;
      if (std::isnan(value) || value < 0) {
        if (negative++ == 0) negative_line = in_.line();
        value = 0;
      }
      if (!(value <= largest_intensity_cd)) fail_at(in_.line(), "an intensity of " + shown(value) + " cd is too large");
      table_.planes[h].intensity_cd.push_back(value + 0);  // no -0
    }
  }
  if (negative > 0)
    warn(negative_line, counted(negative, "candela value is", "candela values are") + " negative or NaN; taken as 0");
}

void IesReader::check_flux(const Photometry& photometry) {
  const double flux = photometry.distribution.band_flux_lm();
  if (flux == 0) warn(table_line_, "all intensities are 0");
  if (rated_flux_lm_ > 0 && flux > most_output_ratio * rated_flux_lm_)
    warn(flux_line_, "the candelas add up to " + shown(flux) + " lm, more than the lamps' " + shown(rated_flux_lm_) +
                         " lm; the candelas are used as they are");
}

Photometry IesReader::read() {
  if (options_.lamp_set != 0)
    throw std::invalid_argument("lamp_set is " + std::to_string(options_.lamp_set) + "; an IES file has one, 0");
  header_ = read_ies_header(in_, warnings_);
  const double tilt = read_tilt();
  read_lamps();
  read_opening();
  const double scale = read_factors() * tilt;

  bool vertical_descends = false, horizontal_descends = false;
  table_.vertical_deg = read_angles("vertical", vertical_count_, vertical_descends);
  vertical_line_ = in_.line();
  for (double h : read_angles("horizontal", horizontal_count_, horizontal_descends)) table_.planes.push_back({h, {}});
  table_line_ = in_.line();
  read_candelas(scale);
  std::string_view token;
  if (in_.next_token(token)) {
    if (double surplus; parse_number(token, surplus))
      fail_at(in_.line(), "numbers go on after the last of " + std::to_string(horizontal_count_ * vertical_count_) +
                              " candela values; a value before, or the count of angles, is wrong");
    warn(in_.line(), "what follows the candelas is ignored");
  }
  if (vertical_descends) {
    std::reverse(table_.vertical_deg.begin(), table_.vertical_deg.end());
    for (Plane& p : table_.planes) std::reverse(p.intensity_cd.begin(), p.intensity_cd.end());
  }
  if (horizontal_descends) std::reverse(table_.planes.begin(), table_.planes.end());
  return finish();
}

// Colour has no keyword of the standard's; those of users begin with an underscore.
void IesReader::read_lamp_keywords(const std::vector<Keyword>& keywords) {
  static constexpr std::string_view temperatures[] = {"CCT", "COLORTEMP", "COLORTEMPERATURE", "COLOURTEMPERATURE",
                                                      "COLOR", "COLOUR"};
  static constexpr std::string_view renderings[] = {"CRI", "RA", "COLORRENDERING", "COLOURRENDERING",
                                                    "COLORRENDERINGINDEX", "COLOURRENDERINGINDEX"};
  for (const Keyword& k : keywords) {
    if (k.name == "LAMP") lamps_.type = k.value;
    std::string name;
    for (char c : k.name)
      if (c != '_' && c != ' ' && c != '-') name += c;
    const auto is_one_of = [&](const auto& names) {
      return std::find(std::begin(names), std::end(names), name) != std::end(names);
    };
    if (is_one_of(temperatures)) lamps_.colour = k.value;
    if (is_one_of(renderings)) lamps_.colour_rendering = k.value;
  }
}

Photometry IesReader::finish() {
  try {
    const PhotometricType type = table_.type;
    Symmetry symmetry = Symmetry::none;
    Photometry out{
        arrange_ies_table(std::move(table_), header_.edition, {vertical_line_, table_line_}, symmetry, warnings_)};
    check_flux(out);
    out.type = type;
    out.opening = opening_;
    out.symmetry = symmetry;
    out.rated_flux_lm = rated_flux_lm_;
    out.input_power_w = input_power_w_;
    out.format = name_of(header_.edition);
    out.keywords = std::move(header_.keywords);
    out.tilt = std::move(tilt_);
    out.tilt_file_name = std::move(tilt_file_name_);
    out.file_generation = file_generation_;
    read_lamp_keywords(out.keywords);
    lamps_.power_w = input_power_w_;
    out.lamp_sets = {std::move(lamps_)};
    out.warnings = std::move(warnings_);
    return out;
  } catch (const std::invalid_argument& e) {
    fail_at(table_line_, e.what());
  }
}

}  // namespace

Photometry read_ies(const void* bytes, size_t size, const ReadOptions& options) {
  return IesReader(decode_text(bytes, size), options).read();
}

}  // namespace photometry
