// See lamps.h.
#include "photometry/lamps.h"

#include "photometry/text_reader.h"

namespace photometry {
namespace {

struct FoundNumber {
  double value;
  std::string before, after;  // the words beside it, in capitals
};

bool is_letter(char c) { return c >= 'A' && c <= 'Z'; }

std::vector<FoundNumber> numbers_in(const std::string& given) {
  const std::string text = upper_case(given);
  std::vector<FoundNumber> out;
  for (size_t i = 0; i < text.size();) {
    if (!is_digit(text[i])) {
      ++i;
      continue;
    }
    const size_t first = i;
    while (i < text.size() && (is_digit(text[i]) || text[i] == '.')) ++i;
    FoundNumber number{};
    parse_number(std::string_view(text).substr(first, i - first), number.value);
    const size_t word_end = text.find_last_not_of(" >=:", first > 0 ? first - 1 : text.npos);
    if (first > 0) {
      size_t begin = word_end + 1;
      while (begin > 0 && is_letter(text[begin - 1])) --begin;
      number.before = text.substr(begin, word_end + 1 - begin);
    }
    for (size_t k = text.find_first_not_of(' ', i); k < text.size() && is_letter(text[k]); ++k) number.after += text[k];
    out.push_back(std::move(number));
  }
  return out;
}

bool ends_with(const std::string& text, std::string_view end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

// The one number of the text that the test admits; -1 for none or several.
template <class Admits>
double only_number(const std::string& text, const Admits& admits) {
  double found = -1;
  for (const FoundNumber& n : numbers_in(text)) {
    if (!admits(n)) continue;
    if (found >= 0 && n.value != found) return -1;
    found = n.value;
  }
  return found;
}

}  // namespace

double colour_temperature_k(const LampSet& lamps) {
  const auto is_kelvin = [](const FoundNumber& n) { return n.value >= 1000 && n.value <= 40000; };
  const double kelvin = only_number(lamps.colour, is_kelvin);
  if (kelvin >= 0) return kelvin;
  const std::string_view code = trimmed(lamps.colour);  // ILCOS (IEC TS 61231): Ra / 10, K / 100
  double value = 0;
  if (code.size() == 3 && parse_number(code, value) && value >= 500 && value == double(int(value)))
    return 100 * double(int(value) % 100);
  return lamps.colour.empty() ? only_number(lamps.type, [&](const FoundNumber& n) {
    return is_kelvin(n) && n.after == "K";
  }) : -1;
}

double colour_rendering_index(const LampSet& lamps) {
  const auto is_index = [](const FoundNumber& n) { return n.value >= 10 && n.value <= 100; };
  if (!lamps.colour_rendering.empty())
    return only_number(lamps.colour_rendering, [&](const FoundNumber& n) { return is_index(n) && n.after.empty(); });
  return only_number(lamps.type, [&](const FoundNumber& n) {
    return is_index(n) && (ends_with(n.before, "CRI") || ends_with(n.before, "RA"));
  });
}

}  // namespace photometry
