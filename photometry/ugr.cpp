#include "photometry/ugr.h"

#include <algorithm>
#include <cmath>

namespace photometry {

double glare_term(const GlareSource& s) {
  if (!(s.position_index > 0)) return 0;
  const double r2 = s.distance_m * s.distance_m, p2 = s.position_index * s.position_index;
  if (s.is_small) return s.intensity_cd * s.intensity_cd / (small_source_m2 * r2 * p2);
  return s.luminance_cd_m2 * s.luminance_cd_m2 * s.solid_angle_sr / p2;
}

double ugr(double sum_of_terms, double background_cd_m2) {
  return 8 * std::log10(0.25 / background_cd_m2 * sum_of_terms);
}

double great_glare_rating(double ugr, double coverage, double direct_lx, double indirect_lx) {
  const double share = coverage > 0 ? std::max(0.0, 1.18 - 0.18 / std::min(coverage, 1.0)) : 0;
  return ugr + share * 8 * std::log10(2.55 * (1 + direct_lx / 220) / (1 + direct_lx / indirect_lx));
}

}  // namespace photometry
