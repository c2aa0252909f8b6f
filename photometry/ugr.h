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
// Beyond it UGR underrates glare; CIE 147 has formulas for large sources, which are not used here.
inline constexpr double large_source_sr = 0.1;

// L^2 w / p^2 of one source; of a small one 200 I^2 / (r^2 p^2).
double glare_term(const GlareSource& source);

// 8 log10(0.25 / L_b * sum of terms); both > 0.
double ugr(double sum_of_terms, double background_cd_m2);

}  // namespace photometry
