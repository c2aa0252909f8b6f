// What data sheets and tenders ask of a luminaire beyond metrics.h: CIE flux code, luminance limits, spacing criterion,
// classes, utilisation factors. The standard library only.
#pragma once
#include "photometry/photometry.h"
#include "photometry/room.h"

namespace photometry {

// CIE 52:1982: of the flux below the horizon the shares within 41.4, 60 and 75.5 degrees (a quarter, half and three
// quarters of the hemisphere), the share of all flux that is below it, and the light output ratio (1 where the file
// states no lamp flux); in per cent.
struct FluxCode {
  double n[5];
};
FluxCode flux_code(const Photometry& photometry);

// Over all planes C: at 65, 75 and 85 degrees, and the highest from 65 to 85 degrees, the last angle of EN 13032-2:
// above it the projected area of flat openings goes to 0 and takes the luminance out of what was measured.
// < 0: no opening with an area.
struct HighLuminance {
  static constexpr double gamma_deg[3] = {65, 75, 85};
  double at_cd_m2[3] = {-1, -1, -1};
  double highest_cd_m2 = -1, c_deg = 0, highest_gamma_deg = 0;  // and where
};
HighLuminance high_luminance(const Photometry& photometry);

// The IES's spacing criterion: spacing over mounting height above the plane at which the illuminance midway between two
// luminaires, in the planes C0-C180 and C90-C270, or at the centre of four in a square (its side), is that under one of
// them from that one alone. The smallest such spacing, <= 10; < 0: none, or no light at nadir.
struct SpacingCriterion {
  double along_c0, along_c90, diagonal;
};
SpacingCriterion spacing_criterion(const Photometry& photometry);

// NEMA beam type by the field angle (a tenth of the plane's peak): 1 from 10 degrees, 2 above 18, 3 above 29, 4 above
// 46, 5 above 70, 6 above 100, 7 above 130; 0: narrower, or there is no such angle.
int nema_type(double field_angle_deg);

// Luminaire classification system and ratings of IES TM-15-11 with its addendum A. `front_c_deg`: where the luminaire's
// front faces, C0 in LM-63 files of outdoor luminaires, C90 by the custom of EULUMDAT. Luminaires that are symmetric to
// both planes, or round, take the glare limits of types V; others those of types I to IV.
struct BugRating {
  // Front and back low (to 30), mid (60), high (80), very high (90 degrees), uplight low (100) and high; lm.
  double front_lm[4], back_lm[4], up_lm[2];
  int backlight, uplight, glare;  // 0 to 5
  bool type_v;
};
BugRating bug_rating(const Photometry& photometry, double front_c_deg);

// Utilisation factors: of the lamps' flux (the luminaire's, where the file states none), what reaches the reference
// plane of a square room whose luminaires are spread evenly over its ceiling; room.h.
struct UtilisationFactors {
  static constexpr int rooms = 10, reflectance_sets = 10;
  static constexpr double room_index[rooms] = {0.6, 0.8, 1, 1.25, 1.5, 2, 2.5, 3, 4, 5};
  static constexpr Reflectances reflectances[reflectance_sets] = {
      {0.7, 0.5, 0.2}, {0.7, 0.3, 0.2}, {0.7, 0.1, 0.2}, {0.5, 0.5, 0.2}, {0.5, 0.3, 0.2},
      {0.5, 0.1, 0.2}, {0.3, 0.5, 0.2}, {0.3, 0.3, 0.2}, {0.3, 0.1, 0.2}, {0, 0, 0}};
  double factor[rooms][reflectance_sets];
};
// Throws std::invalid_argument where there is no flux.
UtilisationFactors utilisation_factors(const Photometry& photometry);

}  // namespace photometry
