// Reads IES LM-63 files of 1986, 1991, 1995, 2002 and 2019 with type C photometry, as strictly as their data allows:
// what would change the light is an error, what is only odd is a warning, each with its line. Called by programs and
// the API.
//
// Layout: label lines, TILT=, then numbers alone: 10 fields, 3 fields, vertical angles, horizontal angles, candelas
// plane by plane. Records may wrap anywhere.
#include <algorithm>
#include <cmath>

#include "photometry/ies_opening.h"
#include "photometry/ies_planes.h"
#include "photometry/text_reader.h"

namespace photometry {
namespace {

constexpr double largest_intensity_cd = 1e12;

class IesReader {
 public:
  explicit IesReader(std::string text) : in_(std::move(text)) {}
  Photometry read();

 private:
  void warn(size_t line, const std::string& what) { warnings_.push_back(at_line(line, what)); }
  double number(const std::string& name) { return in_.number(name); }
  double number_or_one(const std::string& name);
  size_t count(const std::string& name, size_t least);
  void read_edition(std::string_view first_line);
  void read_label();
  void add_label_line(std::string_view line);
  bool find_numbers_without_tilt();
  void read_tilt(std::string_view value);
  void read_lamps();
  void read_opening();
  double read_factors();
  std::vector<double> read_angles(const char* kind, size_t n, bool& descending);
  void read_candelas(double scale);
  void check_flux(const Photometry& photometry);

  TextReader in_;
  IesEdition edition_ = IesEdition::y1986;
  std::vector<Keyword> keywords_;
  std::vector<std::string> warnings_;
  Tilt tilt_;
  double rated_flux_lm_ = -1, input_power_w_ = -1, multiplier_ = 1;
  size_t vertical_count_ = 0, horizontal_count_ = 0, flux_line_ = 0, table_line_ = 0;
  Opening opening_;
  std::vector<double> vertical_deg_;
  std::vector<IesPlane> planes_;
};

IesEdition edition_of_year(int year) {
  return year < 1991   ? IesEdition::y1986
         : year < 1995 ? IesEdition::y1991
         : year < 2002 ? IesEdition::y1995
         : year < 2019 ? IesEdition::y2002
                       : IesEdition::y2019;
}

// IESNA91, IESNA95, IESNA:LM-63-YYYY or IES:LM-63-YYYY, with blanks anywhere and anything after. Anything else is 1986,
// the edition that had no such line.
void IesReader::read_edition(std::string_view first_line) {
  std::string key = upper_case(first_line);
  key.erase(std::remove_if(key.begin(), key.end(), [](char c) { return c == ' ' || c == '\t'; }), key.end());
  if (key.rfind("IES", 0) != 0) return;
  const size_t tag = key.find("LM-63-");
  std::string year;
  for (size_t i = tag != key.npos ? tag + 6 : 5; i < key.size() && key[i] >= '0' && key[i] <= '9'; ++i) year += key[i];
  const bool complete = tag != key.npos ? year.size() == 4 : key.rfind("IESNA", 0) == 0 && year.size() == 2;
  double number = 0;
  if (!complete || !parse_number(year, number)) {
    warn(in_.line(), "unknown version \"" + std::string(first_line) + "\"; read as LM-63-1986");
    return;
  }
  const int full = int(number) + (year.size() == 2 ? 1900 : 0);
  edition_ = edition_of_year(full);
  if (full != 1986 && full != 1991 && full != 1995 && full != 2002 && full != 2019)
    warn(in_.line(), "there is no edition of " + std::to_string(full) + "; read as " + name_of(edition_));
  else if (tag == key.npos && full != 1991)
    warn(in_.line(), "odd version line \"" + std::string(first_line) + "\"; read as " + name_of(edition_));
}

bool is_version_line(std::string_view line) {
  const std::string key = upper_case(line);
  return key.rfind("IESNA", 0) == 0 || (key.rfind("IES", 0) == 0 && key.find("LM-63") != key.npos);
}

// True for a line "TILT=...", blanks and case free; never for TILT= inside a keyword's value.
bool is_tilt_line(std::string_view line, std::string_view& value) {
  line = trimmed(line);
  if (line.size() < 5 || upper_case(line.substr(0, 4)) != "TILT") return false;
  const std::string_view rest = trimmed(line.substr(4));
  if (rest.empty() || rest[0] != '=') return false;
  value = trimmed(rest.substr(1));
  return true;
}

void IesReader::add_label_line(std::string_view line) {
  line = trimmed(line);
  if (line.empty()) return;
  const size_t close = line.find(']');
  if (line[0] != '[' || close == line.npos) {
    keywords_.push_back({"LABEL", std::string(line)});
    return;
  }
  const std::string name = upper_case(trimmed(line.substr(1, close - 1)));
  const std::string value(trimmed(line.substr(close + 1)));
  if (name == "MORE" && !keywords_.empty()) {
    if (!value.empty()) keywords_.back().value += (keywords_.back().value.empty() ? "" : " ") + value;
  } else {
    keywords_.push_back({name, value});
  }
}

// For files without a TILT line: goes to the first line with at least ten numbers and nothing else.
bool IesReader::find_numbers_without_tilt() {
  std::string_view line;
  for (TextReader::Mark before = in_.mark(); in_.next_line(line); before = in_.mark()) {
    TextReader tokens{std::string(line)};
    std::string_view token;
    double value;
    size_t numbers = 0;
    bool only = true;
    while (only && tokens.next_token(token)) (only = parse_number(token, value)) && ++numbers;
    if (only && numbers >= 10) {
      warn(in_.line(), "no TILT= line before the numbers; read as TILT=NONE");
      in_.go_to(before);
      return true;
    }
  }
  return false;
}

void IesReader::read_label() {
  const TextReader::Mark start = in_.mark();
  std::string_view line, tilt;
  bool first = true;
  while (in_.next_line(line)) {
    if (is_tilt_line(line, tilt)) return read_tilt(tilt);
    if (first && trimmed(line).empty()) continue;
    if (first && is_version_line(trimmed(line)))
      read_edition(trimmed(line));
    else
      add_label_line(line);
    first = false;
  }
  const size_t last = in_.line();
  in_.go_to(start);
  if (!find_numbers_without_tilt())
    fail_at(last,
            "the file ends without a TILT= line; an IES LM-63 file has TILT=NONE (or another) before its numbers");
}

void IesReader::read_tilt(std::string_view value) {
  const size_t line = in_.line();
  const std::string kind = upper_case(value);
  if (in_.detect_decimal_commas()) warn(line + 1, "the numbers have decimal commas");
  if (kind == "INCLUDE") {
    tilt_.lamp_geometry = int(count("the lamp-to-luminaire geometry", 0));
    if (tilt_.lamp_geometry < 1 || tilt_.lamp_geometry > 3)
      warn(in_.line(), "lamp-to-luminaire geometry " + std::to_string(tilt_.lamp_geometry) + " is not 1, 2 or 3");
    const size_t pairs = count("the number of tilt angles", 1);
    for (size_t i = 0; i < pairs; ++i) tilt_.angle_deg.push_back(number("tilt angle " + std::to_string(i + 1)));
    for (size_t i = 0; i < pairs; ++i) tilt_.factor.push_back(number("tilt factor " + std::to_string(i + 1)));
    warn(line, "the TILT factors are not applied");
  } else if (kind != "NONE") {
    warn(line, "the TILT file \"" + std::string(value) + "\" is not read; taken as TILT=NONE");
  }
}

// Integers may be written 1.0.
size_t IesReader::count(const std::string& name, size_t least) {
  const double value = number(name);
  if (!(std::abs(value - std::round(value)) < 1e-6) || value < double(least) ||
      value > double(Distribution::max_values))
    fail_at(in_.line(), name + " is " + shown(value) + "; it must be a whole number of at least " +
                            std::to_string(least) +
                            (value > double(Distribution::max_values) ? " and no more than 4000000" : ""));
  return size_t(std::lround(value));
}

double IesReader::number_or_one(const std::string& name) {
  const double value = number(name);
  if (!(value >= 0) || !std::isfinite(value))
    fail_at(in_.line(), name + " is " + shown(value) + "; it must be greater than 0");
  if (value == 0) warn(in_.line(), name + " is 0; taken as 1");
  return value == 0 ? 1 : value;
}

// The first fields: lamps, lumens, multiplier, counts, photometric type.
void IesReader::read_lamps() {
  const double lamps = number("the number of lamps"), lumens = number("the lumens per lamp");
  flux_line_ = in_.line();
  if (!std::isfinite(lamps) || !std::isfinite(lumens)) fail_at(flux_line_, "the lamps and their lumens must be finite");
  if (lamps > 0 && lumens > 0) {
    rated_flux_lm_ = lamps * lumens;
  } else if (lumens >= 0) {
    warn(flux_line_, "the rated flux is " + shown(lamps) + " x " + shown(lumens) + " lm; read as absolute photometry");
  }
  multiplier_ = number_or_one("the candela multiplier");
  vertical_count_ = count("the number of vertical angles", 2);
  horizontal_count_ = count("the number of horizontal angles", 1);
  if (vertical_count_ > Distribution::max_values / horizontal_count_)
    fail_at(in_.line(), std::to_string(vertical_count_) + " x " + std::to_string(horizontal_count_) +
                            " candelas are too many; at most 4000000 are read");
  const size_t type = count("the photometric type", 0);
  if (type == 2 || type == 3)
    throw UnsupportedError(at_line(in_.line(), "photometric type " + std::string(type == 2 ? "B (2)" : "A (3)") +
                                                   " is not supported; only type C (1) is"));
  if (type == 0) warn(in_.line(), "the photometric type is 0; taken as type C");
  if (type > 3)
    fail_at(in_.line(), "the photometric type is " + std::to_string(type) + "; it must be 1 (C), 2 (B) or 3 (A)");
}

void IesReader::read_opening() {
  const size_t units = count("the units type", 0);
  if (units != 1 && units != 2)
    fail_at(in_.line(), "the units type is " + std::to_string(units) + "; it must be 1 (feet) or 2 (metres)");
  const double metre = units == 1 ? 0.3048 : 1.0;
  const double width = metre * number("the opening's width"), length = metre * number("the opening's length"),
               height = metre * number("the opening's height");
  const double largest = std::max({std::abs(width), std::abs(length), std::abs(height)});
  if (!(largest <= 1e6))
    fail_at(in_.line(), "the luminous opening's dimensions must be finite and below a million metres");
  if (largest > 10)
    warn(in_.line(), "a luminous opening of " + shown(largest) + " m is doubtful; are its units right?");
  const OpeningMatch match = ies_opening(edition_, width, length, height, opening_);
  const std::string written = shown(width) + ", " + shown(length) + ", " + shown(height) + " m";
  if (match == OpeningMatch::other_edition)
    warn(in_.line(), "the opening " + written + " is a code of another edition; read as that edition means it");
  if (match == OpeningMatch::unknown)
    warn(in_.line(), "the opening " + written + " is no known code; taken as a box of that size");
}

// Ballast factor, the field whose meaning changed in 1995, watts. Returns what the candelas are multiplied with.
double IesReader::read_factors() {
  double scale = multiplier_ * number_or_one("the ballast factor");
  if (edition_ <= IesEdition::y1991) {
    scale *= number_or_one("the ballast-lamp photometric factor");
  } else {
    const double value =
        number(edition_ == IesEdition::y2019 ? "the file generation type" : "the field for future use");
    static constexpr double types[] = {1.00001, 1.0001, 1.0, 1.001, 1.01, 1.011, 1.1, 1.101, 1.11, 1.111};
    const bool known =
        std::any_of(std::begin(types), std::end(types), [&](double t) { return std::abs(value - t) < 5e-6; });
    if (edition_ == IesEdition::y2019 ? !known : value != 1)
      warn(in_.line(), "the field after the ballast factor is " + shown(value) + "; it is no factor in " +
                           name_of(edition_) + " and is not applied");
  }
  const double watts = number("the input watts");
  if (watts > 0 && std::isfinite(watts)) input_power_w_ = watts;
  if (watts < 0) warn(in_.line(), "the input power is negative; taken as not stated");
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
                              shown(angle[i - 1]) + "; angles must ascend");
  }
  if (descending) warn(in_.line(), std::string("the ") + kind + " angles descend; their order is turned round");
  return angle;
}

void IesReader::read_candelas(double scale) {
  size_t negative = 0, negative_line = 0;
  for (size_t h = 0; h < planes_.size(); ++h) {
    for (size_t v = 0; v < vertical_count_; ++v) {
      const size_t i = h * vertical_count_ + v;
      double value =
          number("candela value " + std::to_string(i + 1) + " of " + std::to_string(planes_.size() * vertical_count_)) *
          scale;
      if (std::isnan(value) || value < 0) {
        if (negative++ == 0) negative_line = in_.line();
        value = 0;
      }
      if (!(value <= largest_intensity_cd)) fail_at(in_.line(), "an intensity of " + shown(value) + " cd is too large");
      planes_[h].intensity_cd.push_back(value);
    }
  }
  if (negative > 0) warn(negative_line, std::to_string(negative) + " candelas are negative or NaN; taken as 0");
}

void IesReader::check_flux(const Photometry& photometry) {
  const double flux = photometry.distribution.band_flux_lm();
  if (flux == 0) warn(table_line_, "all intensities are 0");
  if (rated_flux_lm_ > 0 && flux > 1.05 * rated_flux_lm_)
    warn(flux_line_, "the candelas add up to " + shown(flux) + " lm, more than the lamps' " + shown(rated_flux_lm_) +
                         " lm; the candelas are used as they are");
}

Photometry IesReader::read() {
  read_label();
  read_lamps();
  read_opening();
  const double scale = read_factors();

  bool vertical_descends = false, horizontal_descends = false;
  vertical_deg_ = read_angles("vertical", vertical_count_, vertical_descends);
  if (vertical_descends) std::reverse(vertical_deg_.begin(), vertical_deg_.end());
  double &lowest = vertical_deg_.front(), &highest = vertical_deg_.back();
  if (is_near(lowest, 0)) lowest = 0;
  if (is_near(highest, 180)) highest = 180;
  if (lowest < 0 || highest > 180)
    fail_at(in_.line(),
            "vertical angles from " + shown(lowest) + " to " + shown(highest) + " are not within 0 to 180 of type C");
  if (!(is_near(lowest, 0) || is_near(lowest, 90)) || !(is_near(highest, 90) || is_near(highest, 180)))
    warn(in_.line(), "vertical angles from " + shown(lowest) + " to " + shown(highest) +
                         " do not reach the poles or the horizon; nothing is emitted beyond them");
  for (double c : read_angles("horizontal", horizontal_count_, horizontal_descends)) planes_.push_back({c, {}});
  table_line_ = in_.line();

  read_candelas(scale);
  std::string_view token;
  if (in_.next_token(token)) warn(in_.line(), "what follows the candelas is ignored");
  if (vertical_descends)
    for (IesPlane& p : planes_) std::reverse(p.intensity_cd.begin(), p.intensity_cd.end());
  if (horizontal_descends) std::reverse(planes_.begin(), planes_.end());
  const Symmetry symmetry = arrange_ies_planes(planes_, edition_, table_line_, warnings_);

  std::vector<double> c_deg, table;
  for (const IesPlane& p : planes_) {
    c_deg.push_back(p.c_deg);
    table.insert(table.end(), p.intensity_cd.begin(), p.intensity_cd.end());
  }
  try {
    Photometry out{Distribution(std::move(c_deg), std::move(vertical_deg_), std::move(table)),
                   opening_,
                   symmetry,
                   rated_flux_lm_,
                   input_power_w_,
                   name_of(edition_),
                   std::move(keywords_),
                   std::move(tilt_),
                   {}};
    check_flux(out);
    out.warnings = std::move(warnings_);
    return out;
  } catch (const std::invalid_argument& e) {
    fail_at(table_line_, e.what());
  }
}

// EULUMDAT has no signature; its lines 2 to 6 are small numbers: type 0-3, symmetry 0-4, planes, step, angles.
bool looks_like_eulumdat(const std::string& text) {
  TextReader in(text);
  std::string_view line;
  double value[7] = {};
  for (int i = 1; i <= 6; ++i) {
    if (!in.next_line(line)) return false;
    std::string field(trimmed(line));
    std::replace(field.begin(), field.end(), ',', '.');
    if (i > 1 && !parse_number(field, value[i])) return false;
  }
  return value[2] >= 0 && value[2] <= 3 && value[3] >= 0 && value[3] <= 4 && value[4] >= 1 && value[6] >= 2;
}

}  // namespace

Photometry read_ies(const void* bytes, size_t size) { return IesReader(decode_text(bytes, size)).read(); }

Photometry read(const void* bytes, size_t size) {
  if (is_ray_file(bytes, size)) return read_ray_file(bytes, size);
  std::string text = decode_text(bytes, size);
  if (looks_like_eulumdat(text))
    throw UnsupportedError("line 1: EULUMDAT (.ldt) files are not supported; an IES LM-63 file (.ies) is");
  if (trimmed(std::string_view(text).substr(0, 200)).substr(0, 1) == "<")
    throw UnsupportedError("line 1: XML photometry (TM-33, UNI 11733) is not supported; an IES LM-63 file (.ies) is");
  return IesReader(std::move(text)).read();
}

}  // namespace photometry
