// Everything that the core can tell of a photometric profile, as numbers to print and to draw. Called by the page and
// by the program's commands.
#pragma once
#include <array>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "report/handles.h"

namespace ups::report {

inline constexpr double radian = 3.14159265358979323846 / 180;  // of a degree

inline constexpr std::array<float, 4> luminance_c_deg = {0, 90, 180, 270}, luminance_gamma_deg = {45, 65, 75, 85};
inline constexpr std::array<std::array<float, 2>, 5> zones_deg = {{{0, 30}, {0, 40}, {0, 60}, {0, 90}, {90, 180}}};

// A plane C / C + 180, a full circle.
struct PlaneReport {
  double c_deg;
  ups_profile_beam beam, field;  // of 50 % and 10 % of its peak
};

struct Lobe {
  double from_deg, to_deg;  // as in ups_profile_beam
};

struct LampSetReport {
  ups_profile_lamp_set info;
  std::string type, colour, rendering;  // as the file has them
};

struct ProfileReport {
  std::string file, format;
  std::string tilt_table;  // empty: none
  ups_profile_info info;
  ups_profile_beam beam[2], field[2];                   // of 50 % and 10 % of the peak in C0-C180 and C90-C270
  std::vector<Lobe> other_lobes[2];                     // where those planes rise clearly above 50 % once more
  std::optional<PlaneReport> peak_plane;                // of the peak, where those two miss it; c_deg in [0, 180)
  std::array<double, 5> zonal_flux_lm;                  // by the band rule
  std::array<std::array<float, 4>, 4> luminance_cd_m2;  // [c][gamma]; < 0: no opening, or seen edge on
  std::vector<LampSetReport> lamp_sets;
  std::vector<std::pair<std::string, std::string>> keywords;
  std::vector<std::string> warnings;

  double efficacy_lm_per_w() const { return info.input_power_w > 0 ? info.flux_lm / info.input_power_w : -1; }
  bool is_lit(const ups_profile_beam& plane) const { return plane.peak_cd > dark * info.peak_cd; }
  static constexpr double dark = 0.001;  // of the peak: less in a whole plane is rounding or a table's dust, no beam
  bool has_luminance() const { return info.opening_shape != UPS_OPENING_POINT; }
  bool is_eulumdat() const { return format.rfind("EULUMDAT", 0) == 0; }
};
ProfileReport make_report(const std::string& file, const ups_profile* profile);

// Intensity at (C, gamma) in degrees, cd.
std::vector<float> intensities(const ups_profile* profile, const std::vector<std::pair<double, double>>& c_gamma_deg);
// The same in the plane C / C + 180: gamma on the side C, -gamma on the side C + 180, any angle.
std::vector<float> intensities_in_plane(const ups_profile* profile, double c_deg, const std::vector<double>& angles);

// "48.8 deg (12.7 to 61.5)", "none" where nothing is below the level, "no light". unit: " deg" or its sign.
std::string angle_text(const ProfileReport& report, const ups_profile_beam& beam, const char* unit);
std::string beams_text(const ProfileReport& report);  // lines of beam and field angle
std::string opening_text(const ups_profile_info& info);  // shape and sizes
const char* shape_word(ups_opening_shape shape);
const char* opening_axis_word(const ups_profile_info& info);  // "x", "y", "z" of a cylinder or a line, else ""
const char* symmetry_word(ups_profile_symmetry symmetry);

}  // namespace ups::report
