// Writes IES LM-63-2019: the planes that the symmetry needs, numbers that read back to the same bits, the opening by
// the codes of 2002 and 2019. Called by programs and the API.
#include <algorithm>

#include "photometry/planes.h"
#include "photometry/writer_text.h"

namespace photometry {
namespace {

// Rows of numbers, in lines of at most 100 characters.
class Numbers {
 public:
  void add(double value) {
    const std::string number = shortest(value);
    if (!line_.empty() && line_.size() + 1 + number.size() > 100) end();
    if (!line_.empty()) line_ += ' ';
    line_ += number;
  }
  void add(const std::vector<double>& values) {
    for (double v : values) add(v);
    end();
  }
  void end() {
    if (!line_.empty()) text_ += line_ + "\r\n";
    line_.clear();
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string line_, text_;
};

// A keyword in lines of at most 256 bytes with their end, as LM-63-2002 has it (2019 has no limit): parted at blanks
// where there are some, and gone on with [MORE].
void add_keyword(const std::string& name, const std::string& value, std::string& text) {
  constexpr size_t longest = 254;
  std::string_view rest = value;
  for (std::string head = "[" + name + "] ";; head = "[MORE] ") {
    const size_t room = head.size() + 32 < longest ? longest - head.size() : rest.size();
    size_t n = std::min(rest.size(), room);
    if (n < rest.size()) {
      const size_t blank = rest.rfind(' ', n);
      if (blank != rest.npos && blank > 0) n = blank;
      while (n > 1 && (rest[n] & 0xC0) == 0x80) --n;  // no character of UTF-8 is parted
    }
    text.append(head).append(rest.substr(0, n)).append("\r\n");
    rest = trimmed(rest.substr(n));
    if (rest.empty()) return;
  }
}

// The keywords that LM-63-2019 requires come first, "not stated" where there is none; free lines become [OTHER].
std::string keyword_lines(const std::vector<Keyword>& keywords) {
  std::string text;
  for (const char* required : {"TEST", "TESTLAB", "ISSUEDATE", "MANUFAC"}) {
    const std::string value = one_line(keyword_value(keywords, required));
    add_keyword(required, value.empty() ? "not stated" : value, text);
  }
  std::vector<std::string> written = {"TEST", "TESTLAB", "ISSUEDATE", "MANUFAC"};
  for (const Keyword& k : keywords) {
    const auto first = std::find(written.begin(), written.end(), k.name);
    if (first != written.end()) {
      written.erase(first);  // a second one of its name is written
      continue;
    }
    const bool free = k.name == "LABEL" || k.name == "MORE";
    add_keyword(free ? "OTHER" : one_line(k.name), one_line(k.value), text);
  }
  return text;
}

// Width, length and height, signed as the codes of 2002 and 2019 have them. A lying cylinder that no code has (along z,
// other than upright) does not exist; a vertical disc has a code along x alone.
std::string opening_line(const Photometry& p) {
  double x = shorter(p.opening.size_m[0]), y = shorter(p.opening.size_m[1]), z = shorter(p.opening.size_m[2]);
  int axis = p.opening.axis;
  if (p.type == PhotometricType::a) std::swap(x, z), axis = axis == 1 ? 1 : 2 - axis;
  const bool round = p.opening.shape == OpeningShape::disc || p.opening.shape == OpeningShape::cylinder ||
                     p.opening.shape == OpeningShape::sphere;
  if (p.opening.shape == OpeningShape::point) x = y = z = 0;
  if (p.opening.shape == OpeningShape::cylinder) {
    if (axis != 0) x = -x;
    if (axis != 1) y = -y;
    if (axis != 2) z = -z;
  } else if (round) {
    x = -x, y = -y, z = -z;
  }
  Numbers line;
  line.add({y + 0, x + 0, z + 0});
  return std::move(line).text();
}

void add_lamps(const Photometry& p, Numbers& out) {
  const int count = p.lamp_set < p.lamp_sets.size() ? std::abs(p.lamp_sets[p.lamp_set].count) : 0;
  const bool relative = p.rated_flux_lm > 0;
  const double lamps = std::max(count, 1);
  out.add(lamps);
  out.add(relative ? p.rated_flux_lm / lamps : -1);
}

// What a file of type A or B states: H and V that are not the mirror image of others.
struct Half {
  std::vector<size_t> index;
  std::vector<double> angle;
};
Half stated(const std::vector<double>& angle, bool mirrored) {
  Half out;
  for (size_t i = 0; i < angle.size(); ++i) {
    if (mirrored && angle[i] < -1e-9) continue;
    out.index.push_back(i);
    out.angle.push_back(mirrored && out.angle.empty() ? 0 : angle[i]);
  }
  if (!mirrored && std::abs(out.angle.front()) < 1e-3)
    throw std::invalid_argument(
        "a table of type A or B that starts at an angle of 0 without being half of a symmetric one "
        "cannot be written; LM-63 would mirror it");
  return out;
}

void add_table_a_or_b(const Distribution& d, std::vector<double>& vertical, std::vector<double>& horizontal,
                      std::vector<double>& table) {
  const Symmetry symmetry = mirror_symmetry_of(d);
  const bool h = symmetry == Symmetry::c0_c180 || symmetry == Symmetry::quadrants;
  const bool v = symmetry == Symmetry::c90_c270 || symmetry == Symmetry::quadrants;
  const bool type_a = d.type() == PhotometricType::a;
  const Half planes = stated(d.c_deg(), type_a ? h : v), rows = stated(d.gamma_deg(), type_a ? v : h);
  const Half &across = type_a ? planes : rows, &upright = type_a ? rows : planes;
  horizontal = across.angle;
  vertical = upright.angle;
  for (size_t i : across.index)
    for (size_t j : upright.index) table.push_back(type_a ? d.at(i, j) : d.at(j, i));
}

void add_table_c(const Distribution& d, std::vector<double>& vertical, std::vector<double>& horizontal,
                 std::vector<double>& table) {
  const Symmetry symmetry = symmetry_of(d);
  const double last = symmetry == Symmetry::axial       ? d.c_deg().front()
                      : symmetry == Symmetry::quadrants ? 90
                      : symmetry == Symmetry::c0_c180   ? 180
                                                        : 360;
  vertical = d.gamma_deg();
  for (size_t i = 0; i < d.c_deg().size() && d.c_deg()[i] <= last + 1e-9; ++i) {
    horizontal.push_back(symmetry == Symmetry::axial ? 0 : d.c_deg()[i]);
    for (size_t j = 0; j < vertical.size(); ++j) table.push_back(d.at(i, j));
  }
  if (last != 360) return;
  horizontal.push_back(360);
  for (size_t j = 0; j < vertical.size(); ++j) table.push_back(d.at(0, j));
}

std::string tilt_lines(const Tilt& tilt) {
  if (tilt.angle_deg.empty()) return "TILT=NONE\r\n";
  Numbers out;
  out.add(double(tilt.lamp_geometry));
  out.add(double(tilt.angle_deg.size()));
  out.add(tilt.angle_deg);
  out.add(tilt.factor);
  return "TILT=INCLUDE\r\n" + std::move(out).text();
}

}  // namespace

std::string write_ies(const Photometry& p, std::vector<std::string>* warnings) {
  const Distribution& d = p.distribution;
  std::vector<double> vertical, horizontal, table;
  (d.type() == PhotometricType::c ? add_table_c : add_table_a_or_b)(d, vertical, horizontal, table);
  Numbers head, factors, numbers;
  add_lamps(p, head);
  const int type = d.type() == PhotometricType::c ? 1 : d.type() == PhotometricType::b ? 2 : 3;
  for (double v : {1.0, double(vertical.size()), double(horizontal.size()), double(type), 2.0}) head.add(v);
  head.end();
  factors.add({1, p.file_generation > 0 ? p.file_generation : 1.00001, std::max(0.0, p.input_power_w)});
  numbers.add(vertical);
  numbers.add(horizontal);
  for (size_t i = 0; i < horizontal.size(); ++i) {
    for (size_t j = 0; j < vertical.size(); ++j) numbers.add(table[i * vertical.size() + j]);
    numbers.end();
  }
  std::string text = "IES:LM-63-2019\r\n" + keyword_lines(p.keywords) + tilt_lines(p.tilt) + std::move(head).text() +
         opening_line(p) + std::move(factors).text() + std::move(numbers).text();
  if (warnings) check_written(p, text, *warnings);
  return text;
}

}  // namespace photometry
