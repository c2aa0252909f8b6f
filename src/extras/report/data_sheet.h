// The tables of a luminaire's data sheet. Called by the page and by the command info.
#pragma once
#include <optional>

#include "report/profile_data.h"

namespace ups::report {

struct DataSheet {
  float front_c_deg;  // for the BUG rating
  ups_data_sheet sheet;
  std::optional<ups_ugr_table> ugr;                  // none without a luminous opening
  std::optional<ups_utilisation_table> utilisation;  // none without light
  std::vector<float> c_deg, gamma_deg;               // of the candela table
  std::vector<float> candela;                        // gamma fastest
  std::vector<float> zone_deg;                       // edges of the zones
  std::vector<double> zonal_flux_lm;
};
DataSheet data_sheet_of(const ProfileReport& report, const ups_profile* profile);

inline constexpr int ugr_rooms = 19, ugr_sets = 5, utilisation_rooms = 10, utilisation_sets = 10;
std::string room_name(const ups_ugr_table& table, int room);    // "4H 8H"
std::string reflectance_name(const float* ceiling_walls_floor);  // "70/50/20"

}  // namespace ups::report
