// The data sheet of a luminaire in `ups info --json`.
#include "tool/json_values.h"

namespace ups::tool {
namespace {

ordered_json ugr_json(const ups_ugr_table& t) {
  ordered_json rooms = ordered_json::array(), sets = ordered_json::array();
  for (int k = 0; k < ugr_sets; ++k) sets.push_back(reflectance_name(t.reflectances + 3 * k));
  for (int r = 0; r < ugr_rooms; ++r) {
    ordered_json crosswise = ordered_json::array(), endwise = ordered_json::array();
    for (int k = 0; k < ugr_sets; ++k) {
      crosswise.push_back(number(t.crosswise[r * ugr_sets + k]));
      endwise.push_back(number(t.endwise[r * ugr_sets + k]));
    }
    rooms.push_back({{"room", room_name(t, r)}, {"crosswise", crosswise}, {"endwise", endwise}});
  }
  return {{"lamp_flux_lm", number(t.lamp_flux_lm)}, {"reflectances", sets}, {"rooms", rooms}};
}

ordered_json utilisation_json(const ups_utilisation_table& t) {
  ordered_json rooms = ordered_json::array(), sets = ordered_json::array();
  for (int k = 0; k < utilisation_sets; ++k) sets.push_back(reflectance_name(t.reflectances + 3 * k));
  for (int r = 0; r < utilisation_rooms; ++r) {
    ordered_json factors = ordered_json::array();
    for (int k = 0; k < utilisation_sets; ++k) factors.push_back(number(t.factors[r * utilisation_sets + k]));
    rooms.push_back({{"room_index", number(t.room_index[r])}, {"factors", factors}});
  }
  return {{"reflectances", sets}, {"rooms", rooms}};
}

}  // namespace

ordered_json sheet_json(const DataSheet& s) {
  const ups_data_sheet& d = s.sheet;
  ordered_json candela = ordered_json::array(), zones = ordered_json::array();
  const size_t rows = s.gamma_deg.size();
  for (size_t i = 0; i < s.c_deg.size(); ++i) {
    const auto first = s.candela.begin() + ptrdiff_t(i * rows);
    candela.push_back({{"c_deg", number(s.c_deg[i])},
                       {"gamma_deg", array_json(s.gamma_deg)},
                       {"intensity_cd", array_json(std::vector<float>(first, first + ptrdiff_t(rows)))}});
  }
  for (size_t j = 0; j < s.zonal_flux_lm.size(); ++j)
    zones.push_back({{"from_deg", number(s.zone_deg[j])},
                     {"to_deg", number(s.zone_deg[j + 1])},
                     {"flux_lm", number(s.zonal_flux_lm[j])}});
  ordered_json all = {
      {"flux_code", array_json(d.flux_code)},
      {"high_luminance",
       {{"gamma_deg", {65, 75, 85}},
        {"luminance_cd_m2", array_json(d.luminance_cd_m2)},
        {"highest_cd_m2", number(d.highest_luminance_cd_m2)},
        {"c_deg", number(d.highest_luminance_c_deg)},
        {"highest_gamma_deg", number(d.highest_luminance_gamma_deg)}}},
      {"spacing_criterion",
       {{"c0_c180", number(d.spacing_criterion[0])},
        {"c90_c270", number(d.spacing_criterion[1])},
        {"diagonal", number(d.spacing_criterion[2])}}},
      {"nema_type", {{"horizontal", d.nema_horizontal}, {"vertical", d.nema_vertical}}},
      {"bug",
       {{"backlight", d.backlight_rating},
        {"uplight", d.uplight_rating},
        {"glare", d.glare_rating},
        {"type_v", d.bug_type_v == 1},
        {"front_c_deg", number(s.front_c_deg)},
        {"front_lm", array_json(d.front_lm)},
        {"back_lm", array_json(d.back_lm)},
        {"up_lm", array_json(d.up_lm)}}},
      {"candela", candela},
      {"zonal_flux", zones}};
  if (s.ugr) all["ugr_table"] = ugr_json(*s.ugr);
  if (s.utilisation) all["utilisation"] = utilisation_json(*s.utilisation);
  return all;
}

}  // namespace ups::tool
