// Recognises the format of a photometric file by its content and reads it. Called by programs and the API.
#include <cmath>

#include "photometry/eulumdat_text.h"

namespace photometry {
namespace {

// EULUMDAT has no signature; its lines 2 to 6 are small numbers: type 0-3, symmetry 0-4, planes, step, angles. A field
// may be empty, which is 0.
bool looks_like_eulumdat(const std::string& text) {
  TextReader in(text);
  std::string_view line;
  double value[7] = {};
  for (int i = 1; i <= 6; ++i) {
    if (!in.next_line(line)) return false;
    if (i > 1 && !parse_eulumdat_number(line, value[i])) return false;
  }
  return value[2] >= 0 && value[2] <= 9 && value[3] >= 0 && value[3] <= 9 && value[4] >= 1 && value[6] >= 2;
}

// A damaged one, which lacks what no IES file is without: its errors tell more than those of an IES file would.
bool may_be_eulumdat(const std::string& text) {
  TextReader in(text);
  std::string_view line;
  double value;
  int numbers = 0;
  for (int i = 1; i <= 6 && in.next_line(line); ++i)
    numbers += i > 1 && !trimmed(line).empty() && parse_eulumdat_number(line, value);
  return numbers >= 3 && upper_case(text).find("TILT") == std::string::npos;
}

}  // namespace

Photometry read(const void* bytes, size_t size, const ReadOptions& options) {
  if (is_ray_file(bytes, size)) return read_ray_file(bytes, size, options);
  const std::string text = decode_text(bytes, size);
  if (looks_like_eulumdat(text)) return read_eulumdat(bytes, size, options);
  if (trimmed(std::string_view(text).substr(0, 200)).substr(0, 1) == "<") return read_tm33(bytes, size, options);
  return may_be_eulumdat(text) ? read_eulumdat(bytes, size, options) : read_ies(bytes, size, options);
}

}  // namespace photometry
