// The unified glare rating of CIE 117:1995 from the sources that an eye sees. The standard library only.
#pragma once
#include <cstddef>

namespace photometry {

// As an eye sees it.
struct GlareSource {
  double luminance_cd_m2 = 0;  // mean of its luminous parts; < 0: a point
  double solid_angle_sr = 0;   // of its visible luminous parts
  double intensity_cd = 0;     // towards the eye, of its visible part
  double distance_m = 0;
  double position_index = -1;  // < 0: none, ignored
  bool is_small = false;       // counts by its intensity
};

// CIE 147:2002: a source whose luminous area looks smaller is a small one: it has the glare of one of this size.
inline constexpr double small_source_m2 = 0.005;
// Beyond these UGR underrates glare.
inline constexpr double large_source_sr = 0.1;   // CIE 117
inline constexpr double large_source_m2 = 1.5;   // CIE 147

// L^2 w / p^2 of one source; of a small one 200 I^2 / (r^2 p^2).
double glare_term(const GlareSource& source);

// 8 log10(0.25 / L_b * sum of terms); both > 0.
double ugr(double sum_of_terms, double background_cd_m2);

// CIE 147:2002, great glare rating, of an eye in a room with large sources. coverage: their area as seen from below over
// the ceiling's; where it is below 0.15 the UGR, at 1 a ceiling that is all luminous. Direct and indirect illuminance of
// the eye; indirect_lx > 0.
double great_glare_rating(double ugr, double coverage, double direct_lx, double indirect_lx);

}  // namespace photometry
