// Recognises the edition, collects the keywords and finds TILT=, wherever a line of text may look like it.
#include "photometry/ies_header.h"

#include <algorithm>
#include <cmath>

namespace photometry {
namespace {

IesEdition edition_of_year(int year) {
  return year < 1991   ? IesEdition::y1986
         : year < 1995 ? IesEdition::y1991
         : year < 2002 ? IesEdition::y1995
         : year < 2019 ? IesEdition::y2002
                       : IesEdition::y2019;
}

std::string upper_case_without_ansi(std::string_view line) {
  std::string key = upper_case(line);
  if (key.rfind("ANSI/", 0) == 0) key.erase(0, 5);
  return key;
}

// IESNA91, IESNA95, IESNA:LM-63-YYYY or IES:LM-63-YYYY, with blanks anywhere and anything after; of years some programs
// write two digits, and ANSI/ before it. Anything else is 1986, the edition that had no such line.
void read_edition(std::string_view first_line, size_t line, IesHeader& header, std::vector<std::string>& warnings) {
  const auto warn = [&](const std::string& what) { warnings.push_back(at_line(line, what)); };
  std::string key = upper_case_without_ansi(first_line);
  key.erase(std::remove_if(key.begin(), key.end(), [](char c) { return c == ' ' || c == '\t'; }), key.end());
  if (key.rfind("IES", 0) != 0) return;
  const size_t tag = key.find("LM-63-");
  std::string year;
  for (size_t i = tag != key.npos ? tag + 6 : 5; i < key.size() && key[i] >= '0' && key[i] <= '9'; ++i) year += key[i];
  const bool complete = tag != key.npos ? year.size() == 4 || year.size() == 2
                                        : key.rfind("IESNA", 0) == 0 && year.size() == 2;
  double number = 0;
  if (!complete || !parse_number(year, number)) {
    warn("unknown version \"" + std::string(first_line) + "\"; read as LM-63-1986");
    return;
  }
  const int full = int(number) + (year.size() == 4 ? 0 : number < 86 ? 2000 : 1900);
  header.edition = edition_of_year(full);
  if (full != 1986 && full != 1991 && full != 1995 && full != 2002 && full != 2019)
    warn("there is no edition of " + std::to_string(full) + "; read as " + name_of(header.edition));
  else if (tag == key.npos && full != 1991)
    warn("odd version line \"" + std::string(first_line) + "\"; read as " + name_of(header.edition));
}

bool is_version_line(std::string_view line) {
  const std::string key = upper_case_without_ansi(line);
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

void add_label_line(std::string_view line, std::vector<Keyword>& keywords) {
  line = trimmed(line);
  if (line.empty()) return;
  const size_t close = line.find(']');
  if (line[0] != '[' || close == line.npos) {
    keywords.push_back({"LABEL", std::string(line)});
    return;
  }
  const std::string name = upper_case(trimmed(line.substr(1, close - 1)));
  const std::string value(trimmed(line.substr(close + 1)));
  if (name == "MORE" && !keywords.empty()) {
    if (!value.empty()) keywords.back().value += (keywords.back().value.empty() ? "" : " ") + value;
  } else {
    keywords.push_back({name, value});
  }
}

// For files without a TILT line: goes to the first line with at least ten numbers and nothing else.
bool find_numbers_without_tilt(TextReader& in, std::vector<std::string>& warnings) {
  std::string_view line;
  for (TextReader::Mark before = in.mark(); in.next_line(line); before = in.mark()) {
    TextReader tokens{std::string(line)};
    std::string_view token;
    double value;
    size_t numbers = 0;
    bool only = true;
    while (only && tokens.next_token(token)) (only = parse_number(token, value)) && ++numbers;
    if (only && numbers >= 10) {
      warnings.push_back(at_line(in.line(), "no TILT= line before the numbers; read as TILT=NONE"));
      in.go_to(before);
      return true;
    }
  }
  return false;
}

// The unit of the table where a keyword states another than the candela, as files of invisible radiation do.
void check_unit(const Keyword& keyword, size_t line, std::vector<std::string>& warnings) {
  if (keyword.name != "_INTENSITYUNITS" && keyword.name != "INTENSITYUNITS") return;
  const std::string unit = upper_case(keyword.value);
  if (unit.empty() || unit == "CD" || unit.rfind("CANDELA", 0) == 0) return;
  warnings.push_back(at_line(line, "the file says that its intensities are in " + keyword.value + "; read as cd"));
}

}  // namespace

IesHeader read_ies_header(TextReader& in, std::vector<std::string>& warnings) {
  IesHeader header;
  const TextReader::Mark start = in.mark();
  std::string_view line, tilt;
  std::vector<size_t> lines;  // of the keywords
  bool first = true;
  while (in.next_line(line)) {
    if (is_tilt_line(line, tilt)) {
      header.tilt = tilt;
      header.tilt_line = in.line();
      return header;
    }
    if (first && trimmed(line).empty()) continue;
    if (first && is_version_line(trimmed(line))) {
      read_edition(trimmed(line), in.line(), header, warnings);
    } else {
      const size_t before = header.keywords.size();
      add_label_line(line, header.keywords);
      if (header.keywords.size() > before) {
        lines.push_back(in.line());
        check_unit(header.keywords.back(), in.line(), warnings);
      }
    }
    first = false;
  }
  const size_t last = in.line();
  in.go_to(start);
  if (!find_numbers_without_tilt(in, warnings))
    fail_at(last,
            "the file ends without a TILT= line; an IES LM-63 file has TILT=NONE (or another) before its numbers");
  // The numbers were taken for label lines.
  while (!lines.empty() && lines.back() > in.line()) {
    lines.pop_back();
    header.keywords.pop_back();
  }
  header.tilt = "NONE";
  header.tilt_line = in.line();
  return header;
}

Tilt read_tilt_table(TextReader& in, std::vector<std::string>& warnings) {
  Tilt tilt;
  tilt.lamp_geometry = int(in.count("the lamp-to-luminaire geometry", 0));
  if (tilt.lamp_geometry < 1 || tilt.lamp_geometry > 3)
    warnings.push_back(at_line(
        in.line(), "lamp-to-luminaire geometry " + std::to_string(tilt.lamp_geometry) + " is not 1, 2 or 3"));
  const size_t pairs = in.count("the number of tilt angles", 1);
  for (size_t i = 0; i < pairs; ++i) {
    const double angle = in.number("tilt angle " + std::to_string(i + 1));
    if (!std::isfinite(angle) || (i > 0 && !(angle > tilt.angle_deg.back())))
      fail_at(in.line(), "tilt angle " + std::to_string(i + 1) + " is " + shown(angle) + "; the angles must ascend");
    tilt.angle_deg.push_back(angle);
  }
  for (size_t i = 0; i < pairs; ++i) {
    const double factor = in.number("tilt factor " + std::to_string(i + 1));
    if (!(factor >= 0) || !std::isfinite(factor))
      fail_at(in.line(), "tilt factor " + std::to_string(i + 1) + " is " + shown(factor) + "; it must be at least 0");
    tilt.factor.push_back(factor);
  }
  return tilt;
}

double tilt_factor(const Tilt& tilt, double tilt_deg) {
  const std::vector<double>& angle = tilt.angle_deg;
  const size_t i = size_t(std::upper_bound(angle.begin(), angle.end(), tilt_deg) - angle.begin());
  if (i == 0) return tilt.factor.front();
  if (i == angle.size()) return tilt.factor.back();
  const double t = (tilt_deg - angle[i - 1]) / (angle[i] - angle[i - 1]);
  return tilt.factor[i - 1] * (1 - t) + tilt.factor[i] * t;
}

}  // namespace photometry
