// What a data sheet says of a distribution: beam and field angles, flux by zones, light output ratio, efficacy,
// luminance of the opening. Computed from a Photometry on request; called by the C API and by programs.
#pragma once
#include "photometry/photometry.h"

namespace photometry {

// The lobe around the peak of one plane, a full circle: its angles are gamma on the half plane C and -gamma on the half
// plane C + 180.
struct Beam {
  double peak_cd = 0, peak_deg = 0;  // of this plane; of equal peaks the one nearest to the nadir, then on the side C
  double from_deg = 0, to_deg = 0;   // from_deg <= peak_deg <= to_deg; beyond +-180 where the lobe holds the zenith
  double angle_deg = -1;             // to_deg - from_deg; < 0: nowhere below the level, or no light in this plane
};

// The directions on both sides of the plane's peak where the intensity first falls below `fraction` of that peak, found
// on the interpolated intensity (a table's end is such a place). 0 < fraction <= 1.
//
// 0.5 gives the beam angle of ANSI/IES LS-1 (50 % of the maximum in a plane), CIE's half-peak divergence (e-ILV 2011,
// 17-840); 0.1 the field angle. The beam angle of CIE TN 010:2019 and IEC TR 61341 refers to the intensity at the
// centre of the beam instead: the same where the peak is there, undefined for batwings and washers, so not used here.
Beam beam_of(const Photometry& photometry, double c_deg, double fraction);

enum class FluxRule {
  band,         // 2 pi (cos a - cos b) (I_a + I_b) / 2 a band; a band across an edge is parted by solid angle. Where
                // there are rays, their sum.
  interpolated  // integral of the interpolated intensity
};
// By the band rule; of rays their sum, which their table has as it is interpolated.
double flux_lm(const Photometry& photometry);
// Of the lamps, that ratios are over; < 0: none is stated (absolute photometry), or less than the luminaire's own flux,
// as of LED files that state a single chip's.
double lamp_flux_lm(const Photometry& photometry);
inline constexpr double most_output_ratio = 1.05;  // by rounding and interpolation
// Flux between two gamma angles, degrees, lm; 0 <= from <= to <= 180. Over the whole sphere it is the distribution's
// flux by that rule. Tables of type A and B have no bands about the vertical: their flux by either rule is parted as a
// quadrature of the interpolated intensity is (half a degree of gamma, one of C).
double zonal_flux_lm(const Photometry& photometry, double from_deg, double to_deg, FluxRule rule);

// Area of the opening seen from a direction of any length > 0, m^2: all its sides shine, so the area of its silhouette.
double projected_area_m2(const Opening& opening, double x, double y, double z);
// Mean luminance of the opening seen from there, cd/m^2; < 0: a point, or flat and seen edge on.
double luminance_cd_m2(const Photometry& photometry, double x, double y, double z);

struct Metrics {
  static constexpr double plane_deg[2] = {0, 90};  // C0-C180, C90-C270
  static constexpr double zone_deg[5][2] = {{0, 30}, {0, 40}, {0, 60}, {0, 90}, {90, 180}};
  static constexpr double luminance_c_deg[4] = {0, 90, 180, 270}, luminance_gamma_deg[4] = {45, 65, 75, 85};

  Beam beam[2], field[2];                                             // of 50 % and 10 %, in the planes plane_deg
  double down_flux_lm = 0, up_flux_lm = 0;                            // by the band rule, below and above gamma 90
  double interpolated_down_flux_lm = 0, interpolated_up_flux_lm = 0;  // of the interpolated intensity
  double zonal_flux_lm[5] = {0, 0, 0, 0, 0};                          // by the band rule
  double light_output_ratio = -1;  // flux by the band rule / rated flux; < 0: absolute photometry
  double efficacy_lm_per_w = -1;   // flux by the band rule / input power; < 0: power not stated
  double luminance_cd_m2[4][4];    // [c][gamma]; < 0: no opening, or seen edge on
};
Metrics metrics_of(const Photometry& photometry);

}  // namespace photometry
