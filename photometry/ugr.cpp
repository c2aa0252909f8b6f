#include "photometry/ugr.h"

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

}  // namespace photometry
