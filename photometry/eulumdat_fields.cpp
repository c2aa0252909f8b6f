// See eulumdat_fields.h.
#include "photometry/eulumdat_fields.h"

namespace photometry {

std::string number_field(double value, size_t length) {
  std::string text = shortest(value);
  if (text.size() <= length && text.find('e') == text.npos) return text;
  char digits[400];  // a double has up to 309 before the point
  for (int decimals = int(length) - 2; decimals >= 0; --decimals) {
    const auto end = std::to_chars(digits, digits + sizeof digits, value, std::chars_format::fixed, decimals).ptr;
    text.assign(digits, end);
    if (decimals > 0) text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    if (text == "-0") text = "0";
    if (text.size() <= length) return text;
  }
  return {};
}

void EulumdatFields::text(const std::string& value, size_t length, const char* name) {
  const std::string all = one_line(value);
  size_t end = 0, characters = 0;  // of UTF-8
  for (; end < all.size(); ++end)
    if ((all[end] & 0xC0) != 0x80 && characters++ == length) break;
  const std::string_view kept(all.data(), end);
  if (end < all.size())
    warnings_.push_back(std::string(name) + " is cut to the " + std::to_string(length) +
                        " characters of the format: \"" + std::string(kept) + "\"");
  line(kept);
}

void EulumdatFields::number(double value, size_t length, const char* name) {
  std::string field = number_field(value, length);
  if (field.empty()) {
    field.assign(length, '9');
    if (value < 0) field.front() = '-';
    warnings_.push_back(std::string(name) + ", " + shown(value) + ", does not fit the " + std::to_string(length) +
                        " characters of the format; " + field + " is written");
  }
  line(field);
}

}  // namespace photometry
