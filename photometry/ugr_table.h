// The table of unified glare ratings that a luminaire's data sheet has: 19 rooms, five sets of reflectances, viewed
// crosswise and endwise (CIE 117:1995, CIE 190:2010). The standard library only.
#pragma once
#include "photometry/photometry.h"
#include "photometry/room.h"

namespace photometry {

// The luminaires hang or are recessed in a plane 2 m above the eye, H, in a regular array with the spacing H / 4, the
// outer ones H / 8 from the walls. The eye is at the middle of a wall and looks straight to the opposite one: crosswise
// across the luminaires' longer side, endwise along it. Where both are as long, crosswise C0 faces it, in IES files C90,
// as these have the lamps along C90 and C0. Sources beyond the table of position indices are left out.
//
// The background is the mean illuminance of the walls between eye and luminaires without their direct light, over pi:
// by the transfer method of CIE 190 (exchange() of room.h, whose factors are those of its table 5), but with the direct
// light of the array itself where CIE 190 has four zonal factors for a spacing of H.
struct UgrTable {
  static constexpr int rooms = 19, reflectance_sets = 5, views = 2;
  static constexpr double spacing = 0.25, height_m = 2;  // H
  static constexpr RoomShape shapes[rooms] = {{2, 2}, {2, 3}, {2, 4}, {2, 6},  {2, 8}, {2, 12}, {4, 2},
                                              {4, 3}, {4, 4}, {4, 6}, {4, 8},  {4, 12}, {8, 4}, {8, 6},
                                              {8, 8}, {8, 12}, {12, 4}, {12, 6}, {12, 8}};  // across and along the view
  static constexpr Reflectances reflectances[reflectance_sets] = {
      {0.7, 0.5, 0.2}, {0.7, 0.3, 0.2}, {0.5, 0.5, 0.2}, {0.5, 0.3, 0.2}, {0.3, 0.3, 0.2}};

  double ugr[views][rooms][reflectance_sets];  // crosswise, endwise; at lamp_flux_lm; no_glare: see there
  double lamp_flux_lm;                         // see metrics.h; of the luminaire where it states none
  // Where no luminaire that counts sends light to the eye.
  static constexpr double no_glare = -1;
};

// As the file is: the "corrected" table. That for 1000 lm of lamp flux is lower by 8 log10(lamp_flux_lm / 1000).
// Throws UnsupportedError where the opening has no area, std::invalid_argument where there is no flux.
UgrTable ugr_table(const Photometry& photometry);

}  // namespace photometry
