// See data_sheet.h.
#include "report/data_sheet.h"

#include <cmath>
#include <iterator>

#include "report/text_format.h"

namespace ups::report {
namespace {

constexpr float step_deg = 10;
// Half planes of the candela table: what the symmetry leaves.
constexpr float quadrant_planes[] = {0, 22.5f, 45, 67.5f, 90};

std::vector<float> planes_of(ups_profile_symmetry symmetry) {
  if (symmetry == UPS_SYMMETRY_AXIAL) return {0};
  if (symmetry == UPS_SYMMETRY_QUADRANTS) return {std::begin(quadrant_planes), std::end(quadrant_planes)};
  std::vector<float> planes;
  for (float c = 0; c < 360; c += 22.5f) {
    const bool repeats = (symmetry == UPS_SYMMETRY_C0_C180 && c > 180) ||
                         (symmetry == UPS_SYMMETRY_C90_C270 && c > 90 && c < 270);
    if (!repeats) planes.push_back(c);
  }
  return planes;
}

}  // namespace

DataSheet data_sheet_of(const ProfileReport& report, const ups_profile* profile) {
  DataSheet s{};
  s.front_c_deg = report.is_eulumdat() ? 90 : 0;
  s.sheet.struct_size = sizeof s.sheet;
  check(ups_profile_get_data_sheet(profile, s.front_c_deg, &s.sheet));
  if (report.info.flux_lm > 0 && report.info.interpolated_flux_lm > 0) {
    s.utilisation.emplace();
    s.utilisation->struct_size = sizeof *s.utilisation;
    check(ups_profile_get_utilisation(profile, &*s.utilisation));
    ups_ugr_table ugr{};
    ugr.struct_size = sizeof ugr;
    const ups_status status = ups_profile_get_ugr_table(profile, &ugr);
    if (status != UPS_ERROR_UNSUPPORTED) check(status);  // UNSUPPORTED: no opening with an area
    if (status == UPS_OK) s.ugr = ugr;
  }
  s.c_deg = planes_of(report.info.symmetry);
  for (float gamma = 0; gamma <= 180; gamma += step_deg) s.gamma_deg.push_back(gamma);
  s.zone_deg = s.gamma_deg;
  std::vector<std::pair<double, double>> directions;
  for (float c : s.c_deg)
    for (float gamma : s.gamma_deg) directions.emplace_back(c, gamma);
  s.candela = intensities(profile, directions);
  s.zonal_flux_lm.resize(s.zone_deg.size() - 1);
  check(ups_profile_get_zonal_flux(profile, s.zone_deg.data(), s.zone_deg.size(), s.zonal_flux_lm.data()));
  return s;
}

std::string room_name(const ups_ugr_table& table, int room) {
  return format("%gH %gH", table.room_across_h[room], table.room_along_h[room]);
}

std::string reflectance_name(const float* rho) {
  const auto percent = [](float r) { return int(std::lround(100 * r)); };
  return format("%d/%d/%d", percent(rho[0]), percent(rho[1]), percent(rho[2]));
}

}  // namespace ups::report
