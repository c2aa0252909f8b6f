// See profile_data.h: openings, beams and symmetries in words.
#include <algorithm>
#include <cmath>
#include <iterator>

#include "report/profile_data.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

std::string plane_text(const ProfileReport& report, int plane) {
  const size_t others = report.other_lobes[plane].size();
  return angle_text(report, report.beam[plane], " deg") +
         (others > 0 ? format(" in one of %zu lobes", others + 1) : "");
}

}  // namespace

const char* shape_word(ups_opening_shape shape) {
  constexpr const char* words[] = {"point", "rectangle", "disc", "box", "cylinder", "sphere"};
  return shape >= 0 && shape < int(std::size(words)) ? words[shape] : "unknown";
}

const char* opening_axis_word(const ups_profile_info& info) {
  constexpr const char* words[] = {"x", "y", "z"};
  if (info.opening_shape == UPS_OPENING_CYLINDER && info.opening_axis >= 0 && info.opening_axis < 3)
    return words[info.opening_axis];
  const auto* m = info.opening_m;
  const bool line = info.opening_shape == UPS_OPENING_RECTANGLE &&
                    std::count_if(m, m + 3, [](float length) { return length > 0; }) == 1;
  return line ? words[std::max_element(m, m + 3) - m] : "";
}

std::string opening_text(const ups_profile_info& info) {
  const float* m = info.opening_m;
  const bool ellipsoid = info.opening_shape == UPS_OPENING_SPHERE && (m[0] != m[1] || m[0] != m[2]);
  const std::string text = ellipsoid ? "ellipsoid" : shape_word(info.opening_shape);
  switch (info.opening_shape) {
    case UPS_OPENING_POINT:
      return text;
    case UPS_OPENING_CYLINDER:
      return format("%s %g x %g x %g m along %s", text.c_str(), m[0], m[1], m[2], opening_axis_word(info));
    case UPS_OPENING_RECTANGLE:
      if (const char* axis = opening_axis_word(info); *axis)
        return format("line %g m along %s", std::max({m[0], m[1], m[2]}), axis);
      [[fallthrough]];
    case UPS_OPENING_DISC:
      if (m[2] == 0) return format("%s %g x %g m", text.c_str(), m[0], m[1]);
      [[fallthrough]];  // upright
    default:
      return format("%s %g x %g x %g m", text.c_str(), m[0], m[1], m[2]);
  }
}

const char* symmetry_word(ups_profile_symmetry symmetry) {
  constexpr const char* words[] = {"none", "axial", "c0_c180", "c90_c270", "quadrants"};
  return symmetry >= 0 && symmetry < int(std::size(words)) ? words[symmetry] : "unknown";
}

std::string angle_text(const ProfileReport& report, const ups_profile_beam& beam, const char* unit) {
  if (!report.is_lit(beam)) return "no light";
  if (beam.angle_deg < 0) return "none";
  const bool centred = std::abs(beam.from_deg + beam.to_deg) < 0.05f;
  return format("%.1f%s", beam.angle_deg, unit) +
         (centred ? "" : format(" (%.1f to %.1f)", beam.from_deg, beam.to_deg));
}

std::string beams_text(const ProfileReport& report) {
  const char* pattern = "%s angle (%s of the plane's peak): C0-C180 %s, C90-C270 %s\n";
  const auto field = [&](int plane) { return angle_text(report, report.field[plane], " deg"); };
  return format(pattern, "beam", "50 %", plane_text(report, 0).c_str(), plane_text(report, 1).c_str()) +
         format(pattern, "field", "10 %", field(0).c_str(), field(1).c_str());
}

}  // namespace ups::report
