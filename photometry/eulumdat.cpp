// Reads EULUMDAT files (A. W. Stockmar, "EULUMDAT - ein Leuchtendatenformat fuer den europaeischen Beleuchtungsplaner",
// Licht '90): one field a line, intensities in cd per 1000 lm of the lamps. Wrong data are errors, odd ones warnings,
// each with its line. Called by read.cpp and the API.
#include <algorithm>
#include <cmath>

#include "photometry/eulumdat_text.h"
#include "photometry/metrics.h"
#include "photometry/planes.h"

namespace photometry {
namespace {

constexpr double largest_intensity_cd = 1e12;

class EulumdatReader {
 public:
  EulumdatReader(std::string text, const ReadOptions& options) : in_(std::move(text)), options_(options) {}
  Photometry read();

 private:
  void warn(size_t line, const std::string& what) { warnings_.push_back(at_line(line, what)); }
  void keep(const char* keyword, const char* name);
  double keep_number(const char* keyword, const char* name);
  void read_head();
  void read_opening();
  void check_unit();
  void read_ratios();
  void read_lamps();
  bool grouped_by_field(size_t sets);
  void choose_lamps();
  std::vector<double> read_angles(const char* name, size_t n);
  std::vector<double> stored_planes(const std::vector<double>& c_deg);
  void read_intensities(const std::vector<double>& stored);
  void check_circle(const std::vector<double>& c_deg);
  void check_step(const std::vector<double>& angle, double stated, size_t line, const char* distance,
                  const char* angles);
  void check_flux(const Photometry& photometry);

  EulumdatText in_;
  const ReadOptions& options_;
  std::vector<std::string> warnings_;
  std::vector<Keyword> keywords_;
  size_t isym_ = 0, plane_count_ = 0, gamma_count_ = 0, lamp_line_ = 0, table_line_ = 0, ratio_line_ = 0;
  size_t opening_line_ = 0, plane_step_line_ = 0, gamma_step_line_ = 0, down_line_ = 0;
  double luminaire_mm_ = 0, opening_mm_ = 0;  // the longest of each
  Opening opening_;
  double light_output_percent_ = 0, conversion_ = 1, plane_step_ = 0, gamma_step_ = 0;
  double down_percent_ = -1;  // < 0: not stated
  std::vector<LampSet> lamps_;
  std::vector<size_t> flux_lines_;  // of each
  std::vector<double> gamma_deg_;
  std::vector<Plane> planes_;
};

void EulumdatReader::keep(const char* keyword, const char* name) {
  const std::string_view text = in_.line(name);
  if (!text.empty()) keywords_.push_back({keyword, std::string(text)});
}

double EulumdatReader::keep_number(const char* keyword, const char* name) {
  const double value = in_.number_or_zero(name, warnings_);
  in_.may_be_thousands();
  if (value != 0) keywords_.push_back({keyword, shortest(value)});
  return value;
}

// Lines 1 to 15.
void EulumdatReader::read_head() {
  keep("MANUFAC", "the maker");
  const double type = in_.number_or_zero("the type indicator Ityp", warnings_);
  if (!(type == 0 || type == 1 || type == 2 || type == 3))
    warn(in_.at(), "the type indicator Ityp is " + shown(type) + ", not 1, 2 or 3; it changes nothing");
  keywords_.push_back({"_ITYP", shortest(type)});
  const std::vector<std::string_view> isym = in_.peek(1);
  isym_ = in_.count("the symmetry indicator Isym", 0, 4);
  if (!isym.empty() && isym[0].empty())
    warn(in_.at(), "the symmetry indicator Isym is blank; taken as 0, so that the table must have all C planes");
  plane_count_ = in_.count("the number Mc of C planes", 1, Distribution::max_values);
  plane_step_ = in_.number_or_zero("the distance Dc of the C planes", warnings_);
  plane_step_line_ = in_.at();
  gamma_count_ = in_.count("the number Ng of intensities in a plane", 2, Distribution::max_values);
  if (plane_count_ > Distribution::max_values / gamma_count_)
    fail_at(in_.at(), std::to_string(plane_count_) + " x " + std::to_string(gamma_count_) +
                          " intensities are too many; at most 4000000 are read");
  gamma_step_ = in_.number_or_zero("the distance Dg of the intensities", warnings_);
  gamma_step_line_ = in_.at();
  keep("TEST", "the report's number");
  keep("LUMINAIRE", "the luminaire's name");
  keep("LUMCAT", "the luminaire's number");
  keep("_FILENAME", "the file's name");
  keep("ISSUEDATE", "the date");
  luminaire_mm_ = keep_number("_LENGTH_MM", "the luminaire's length");
  luminaire_mm_ = std::max(luminaire_mm_, keep_number("_WIDTH_MM", "the luminaire's width"));
  luminaire_mm_ = std::max(luminaire_mm_, keep_number("_HEIGHT_MM", "the luminaire's height"));
}

// Lines 16 to 21, mm. Length lies along C90-C270, width along C0-C180; without a width the length is a diameter.
void EulumdatReader::read_opening() {
  const auto size = [&](const char* name) {
    double mm = in_.number_or_zero(name, warnings_);
    in_.may_be_thousands();
    if (mm < 0) warn(in_.at(), std::string(name) + " is " + shown(mm) + " mm; its sign is ignored");
    mm = std::abs(mm);
    if (mm > 1e9) fail_at(in_.at(), std::string(name) + " is " + shown(mm) + " mm; it must be below a million metres");
    if (mm > 10000) warn(in_.at(), std::string(name) + " of " + shown(mm) + " mm is doubtful");
    return mm;
  };
  const double length = size("the luminous length"), width = size("the luminous width");
  double low = 1e9, high = 0;
  for (const char* name : {"the luminous height at C0", "the luminous height at C90", "the luminous height at C180",
                           "the luminous height at C270"}) {
    const double height = size(name);
    low = std::min(low, height), high = std::max(high, height);
  }
  if (high > low)
    warn(in_.at(), "the luminous heights are from " + shown(low) + " to " + shown(high) +
                       " mm; all sides are taken as the highest");
  const bool round = width == 0 && length > 0;
  if (length == 0 && width == 0) {
    if (high > 0) warn(in_.at(), "luminous heights without a luminous length or width; taken as a point");
    return;
  }
  opening_.shape = round ? (high > 0 ? OpeningShape::cylinder : OpeningShape::disc)
                         : (high > 0 ? OpeningShape::box : OpeningShape::rectangle);
  opening_.size_m[0] = float(0.001 * (round ? length : width));
  opening_.size_m[1] = float(0.001 * length);
  opening_.size_m[2] = float(0.001 * high);
  opening_mm_ = std::max({length, width, high});
  opening_line_ = in_.at();
}

// Metres where the format has millimetres: an opening a thousandth of its luminaire, or less than a millimetre and
// nothing beside it; or a luminaire smaller than any of its flux.
void EulumdatReader::check_unit() {
  if (!(opening_mm_ > 0) || !(luminaire_mm_ > 0)) return;
  const double ratio = luminaire_mm_ / opening_mm_;
  const bool opening_in_metres = (opening_mm_ < 1 && ratio > 100) || (opening_mm_ < 5 && ratio > 900 && ratio < 5000),
             all_in_metres = luminaire_mm_ < 2.5 && lamps_[options_.lamp_set].flux_lm > 300;
  if (opening_in_metres || all_in_metres)
    warn(opening_line_, "the luminous opening is " + shown(opening_mm_) + " mm at its longest, the luminaire " +
                            shown(luminaire_mm_) + " mm; both fields are in millimetres: were metres meant?");
}

// Lines 22 to 25.
void EulumdatReader::read_ratios() {
  const std::vector<std::string_view> fraction = in_.peek(1);
  const double down = in_.number_or_zero("the downward flux fraction", warnings_);
  down_line_ = in_.at();
  if (down != 0) keywords_.push_back({"_DFF_PERCENT", shortest(down)});
  double stated;
  if (!fraction.empty() && !fraction[0].empty() && parse_eulumdat_number(fraction[0], stated)) down_percent_ = down;
  light_output_percent_ = in_.number_or_zero("the light output ratio", warnings_);
  ratio_line_ = in_.at();
  if (light_output_percent_ != 0) keywords_.push_back({"_LORL_PERCENT", shortest(light_output_percent_)});
  conversion_ = in_.number("the conversion factor for the intensities");
  if (conversion_ < 0)
    fail_at(in_.at(), "the conversion factor for the intensities is " + shown(conversion_) +
                          "; it must be greater than 0");
  if (conversion_ == 0) {
    warn(in_.at(), "the conversion factor for the intensities is 0; taken as 1");
    conversion_ = 1;
  }
  const double tilt = in_.number_or_zero("the tilt during measurement", warnings_);
  if (tilt != 0) {
    keywords_.push_back({"_TILT_DEG", shortest(tilt)});
    warn(in_.at(), "the tilt during measurement is " + shown(tilt) + " degrees; it is not applied");
  }
  if (options_.tilt_deg >= 0) warn(in_.at(), no_tilt_table(options_.tilt_deg));
}

// Some writers give all counts, then all types, and so on: known by numbers where those have theirs and texts where set
// after set would have numbers.
bool EulumdatReader::grouped_by_field(size_t sets) {
  const std::vector<std::string_view> lines = in_.peek(6 * sets);
  if (sets < 2 || lines.size() < 6 * sets) return false;
  double value;
  const auto numeric = [&](size_t i) { return !lines[i].empty() && parse_eulumdat_number(lines[i], value); };
  bool by_set = true, by_field = true;
  for (size_t i = 0; i < sets; ++i) {
    by_set = by_set && numeric(6 * i) && numeric(6 * i + 2);
    by_field = by_field && numeric(i) && numeric(2 * sets + i);
  }
  return by_field && !by_set;
}

void EulumdatReader::read_lamps() {
  const size_t n = in_.count("the number of lamp sets", 1, 1000);
  lamp_line_ = in_.at();
  if (in_.peek(6 * n).size() < 6 * n)
    fail_at(lamp_line_, "the number of lamp sets is " + std::to_string(n) + ", but the file ends within them");
  lamps_.resize(n);
  const auto count = [&](LampSet& s) {
    const double value = in_.number("the number of lamps");
    if (!(std::abs(value) <= 1e9)) fail_at(in_.at(), "the number of lamps is " + shown(value) + "; more than 1e9");
    s.count = int(std::lround(value));
    if (value != s.count)
      warn(in_.at(), "the number of lamps is " + shown(value) + "; taken as " + std::to_string(s.count));
  };
  const auto type = [&](LampSet& s) { s.type = in_.line("the lamps' type"); };
  const auto flux = [&](LampSet& s) {
    s.flux_lm = in_.number("the lamps' flux");
    in_.may_be_thousands();
    flux_lines_.push_back(in_.at());
  };
  const auto colour = [&](LampSet& s) { s.colour = in_.line("the lamps' colour"); };
  const auto rendering = [&](LampSet& s) { s.colour_rendering = in_.line("the lamps' colour rendering"); };
  const auto power = [&](LampSet& s) {
    const double watts = in_.number_or_zero("the lamps' power", warnings_);
    s.power_w = watts > 0 && std::isfinite(watts) ? watts : -1;
    if (watts < 0 || !std::isfinite(watts))
      warn(in_.at(), "the lamps' power is " + shown(watts) + " W; taken as not stated");
  };
  if (grouped_by_field(n)) {
    warn(lamp_line_, "the lamp sets are given field by field; read so");
    for (LampSet& s : lamps_) count(s);
    for (LampSet& s : lamps_) type(s);
    for (LampSet& s : lamps_) flux(s);
    for (LampSet& s : lamps_) colour(s);
    for (LampSet& s : lamps_) rendering(s);
    for (LampSet& s : lamps_) power(s);
  } else {
    for (LampSet& s : lamps_) count(s), type(s), flux(s), colour(s), rendering(s), power(s);
  }
}

void EulumdatReader::choose_lamps() {
  const size_t n = lamps_.size(), i = options_.lamp_set;
  if (i >= n)
    throw std::invalid_argument("lamp_set is " + std::to_string(i) + "; the file has " + std::to_string(n) +
                                (n == 1 ? " set, 0" : " sets, from 0"));
  const LampSet& s = lamps_[i];
  if (n > 1)
    warn(lamp_line_, std::to_string(n) + " lamp sets, which are alternatives; number " + std::to_string(i + 1) +
                         " is taken: " + s.type + ", " + shown(s.flux_lm) + " lm");
  if (!(s.flux_lm > 0) || s.flux_lm > 1e12)
    fail_at(flux_lines_[i],
            "the flux of lamp set " + std::to_string(i + 1) + " is " + shown(s.flux_lm) +
                " lm; the intensities are per 1000 lm of it, so it must be greater than 0 and at most 1e12");
  const auto add = [&](const char* name, const std::string& text) {
    if (!text.empty()) keywords_.push_back({name, text});
  };
  add("LAMP", s.type);
  add("_COLOUR", s.colour);
  add("_COLOUR_RENDERING", s.colour_rendering);
}

std::vector<double> EulumdatReader::read_angles(const char* name, size_t n) {
  std::vector<double> angle;
  bool empty;
  for (size_t i = 0; i < n; ++i) {
    angle.push_back(in_.element(name, i + 1, n, empty));
    if (i > 0 && !(angle[i] > angle[i - 1]))
      fail_at(in_.at(), name + std::to_string(i + 1) + " is " + shown(angle[i]) + " after " + shown(angle[i - 1]) +
                            "; angles must ascend (is the number of lamp sets in line " + std::to_string(lamp_line_) +
                            " right?)");
  }
  return angle;
}

// Without a symmetry the planes go all round.
void EulumdatReader::check_circle(const std::vector<double>& c_deg) {
  constexpr double most_deg = 90;  // wider ones are no planes that were left out, but a half or a quarter of the circle
  const double open = open_end_deg(c_deg), last = c_deg.back();
  if (open == 0) return;
  const std::string what = "the C angles end at " + shown(last) + " and leave " + shown(open) +
                           " degrees without a plane, at least twice their own steps";
  if (open <= most_deg) return warn(in_.at(), what + "; the intensities between are interpolated");
  const char* meant = last == 180  ? "; planes that are mirrored about C0-C180 have Isym 2"
                      : last == 90 ? "; planes that are mirrored about both axes have Isym 4"
                                   : "";
  fail_at(in_.at(), what + "; without a symmetry (Isym 0 in line 3) they must go all round" + meant);
}

// The C angles of the planes that are stored, in the file's order; 360 stands for the closing plane.
std::vector<double> EulumdatReader::stored_planes(const std::vector<double>& c_deg) {
  if (c_deg.front() != 0 || c_deg.back() > 360)
    fail_at(in_.at(), "the C angles run from " + shown(c_deg.front()) + " to " + shown(c_deg.back()) +
                          "; they must start at 0 and end below 360");
  const auto between = [&](double a, double b) {
    std::vector<double> out;
    for (double c : c_deg)
      if (c >= a && c <= b && c < 360) out.push_back(c);
    return out;
  };
  const auto need = [&](std::initializer_list<double> angles, const char* symmetry) {
    for (double a : angles)
      if (std::find(c_deg.begin(), c_deg.end(), a) == c_deg.end())
        fail_at(in_.at(), "there is no C angle " + shown(a) + ", which the " + symmetry + " needs");
  };
  switch (isym_) {
    case 0:
      check_circle(c_deg);
      return c_deg;
    case 1:
      return {0};
    case 2:
      need({180}, "symmetry about C0-C180 (Isym 2)");
      return between(0, 180);
    case 3: {
      need({90, 270}, "symmetry about C90-C270 (Isym 3)");
      std::vector<double> out = between(270, 360);
      for (double c : between(0, 90)) out.push_back(c);
      return out;
    }
    default:
      need({90}, "symmetry about both planes (Isym 4)");
      return between(0, 90);
  }
}

void EulumdatReader::read_intensities(const std::vector<double>& stored) {
  const double scale = conversion_ * lamps_[options_.lamp_set].flux_lm / 1000;
  const size_t n = stored.size() * gamma_count_;
  size_t negative = 0, negative_line = 0, empties = 0, empty_line = 0;
  for (size_t p = 0; p < stored.size(); ++p) {
    planes_.push_back({stored[p], {}});
    for (size_t g = 0; g < gamma_count_; ++g) {
      bool empty;
      double value = in_.element("intensity ", p * gamma_count_ + g + 1, n, empty) * scale;
      in_.may_be_thousands();
      if (empty && empties++ == 0) empty_line = in_.at();
      if (value < 0) {
        if (negative++ == 0) negative_line = in_.at();
        value = 0;
      }
      if (!(value <= largest_intensity_cd)) fail_at(in_.at(), "an intensity of " + shown(value) + " cd is too large");
      planes_.back().intensity_cd.push_back(value + 0);  // no -0
    }
  }
  if (negative > 0) warn(negative_line, counted(negative, "intensity is", "intensities are") + " negative; taken as 0");
  if (empties > 0)
    warn(empty_line, counted(empties, "intensity is an empty line", "intensities are empty lines") + "; taken as 0");
  if (const size_t more = in_.remaining())
    warn(in_.at(), counted(more, "line follows", "lines follow") + " the intensities; ignored");
}

// Dc or Dg, which is 0 where the steps differ.
void EulumdatReader::check_step(const std::vector<double>& angle, double stated, size_t line, const char* distance,
                                const char* angles) {
  constexpr double tolerance = 0.02;  // degrees: two angles and the distance, each to two decimals
  if (stated == 0) return;
  for (size_t i = 0; i + 1 < angle.size(); ++i) {
    const double step = angle[i + 1] - angle[i];
    if (std::abs(step - stated) <= tolerance) continue;
    return warn(line, std::string("the distance ") + distance + " is " + shown(stated) + " degrees, but the " + angles +
                          " have a step of " + shown(step) + "; they are used as they are");
  }
}

void EulumdatReader::check_flux(const Photometry& p) {
  constexpr double tolerance = 2;  // percent
  const double flux = flux_lm(p);
  if (flux == 0) return warn(table_line_, "all intensities are 0");
  const double percent = 100 * flux / lamps_[options_.lamp_set].flux_lm;
  if (light_output_percent_ > 0 && std::abs(percent / light_output_percent_ - 1) > 0.01 * tolerance)
    warn(ratio_line_, "the light output ratio is " + shown(light_output_percent_) +
                          " %, but the intensities add up to " + shown(percent) +
                          " % of the lamps' flux; they are used as they are");
  const double down = 100 * zonal_flux_lm(p, 0, 90, FluxRule::band) / flux;
  if (down_percent_ >= 0 && std::abs(down - down_percent_) > tolerance)
    warn(down_line_, "the downward flux fraction is " + shown(down_percent_) + " %, but of the intensities' light " +
                         shown(std::round(10 * down) / 10) + " % goes down; they are used as they are");
}

Photometry EulumdatReader::read() {
  read_head();
  read_opening();
  read_ratios();
  read_lamps();
  choose_lamps();
  check_unit();
  std::string direct_ratios;
  for (int i = 0; i < 10; ++i)
    direct_ratios.append(i ? " " : "").append(shortest(in_.number_or_zero("a direct ratio", warnings_)));
  keywords_.push_back({"_DIRECT_RATIOS", direct_ratios});

  const std::vector<double> c_deg = read_angles("C angle ", plane_count_), stored = stored_planes(c_deg);
  gamma_deg_ = read_angles("gamma ", gamma_count_);
  table_line_ = in_.at();
  if (gamma_deg_.front() < 0 || gamma_deg_.back() > 180)
    fail_at(table_line_, "the angles gamma run from " + shown(gamma_deg_.front()) + " to " + shown(gamma_deg_.back()) +
                             "; they must lie from 0 to 180");
  if (!(gamma_deg_.front() == 0 || gamma_deg_.front() == 90) || !(gamma_deg_.back() == 90 || gamma_deg_.back() == 180))
    warn(table_line_, "the angles gamma from " + shown(gamma_deg_.front()) + " to " + shown(gamma_deg_.back()) +
                          " do not reach the poles or the horizon; nothing is emitted beyond them");
  if (isym_ != 1) check_step(c_deg, plane_step_, plane_step_line_, "Dc of the C planes", "C angles");
  check_step(gamma_deg_, gamma_step_, gamma_step_line_, "Dg of the intensities", "angles gamma");
  read_intensities(stored);
  in_.check_commas();
  if (planes_.size() > 1 && planes_.back().c_deg == 360) {
    warn(table_line_, "the C angles end with 360, which is C0 again");
    join_ends(planes_, table_line_, warnings_);
  }
  constexpr Symmetry symmetries[] = {Symmetry::none, Symmetry::axial, Symmetry::c0_c180, Symmetry::c90_c270,
                                     Symmetry::quadrants};
  const Symmetry symmetry = planes_.size() == 1 ? Symmetry::axial : symmetries[isym_];
  complete_circle(planes_, symmetry);
  try {
    Photometry out{distribution_of(PhotometricType::c, std::move(planes_), std::move(gamma_deg_))};
    check_flux(out);
    check_poles(out.distribution, table_line_, warnings_);
    const LampSet& lamps = lamps_[options_.lamp_set];
    out.opening = opening_;
    out.symmetry = symmetry;
    out.rated_flux_lm = lamps.count < 0 ? -1 : lamps.flux_lm;
    out.input_power_w = lamps.power_w;
    out.format = "EULUMDAT";
    out.keywords = std::move(keywords_);
    out.lamp_sets = std::move(lamps_);
    out.lamp_set = options_.lamp_set;
    out.warnings = std::move(warnings_);
    return out;
  } catch (const std::invalid_argument& e) {
    fail_at(table_line_, e.what());
  }
}

}  // namespace

Photometry read_eulumdat(const void* bytes, size_t size, const ReadOptions& options) {
  return EulumdatReader(decode_text(bytes, size), options).read();
}

}  // namespace photometry
