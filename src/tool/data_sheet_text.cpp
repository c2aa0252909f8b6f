// See data_sheet.h.
#include "tool/data_sheet.h"

#include <cmath>

#include "tool/text_format.h"

namespace ups::tool {
namespace {

// -1 is "not known" or "no glare" in all tables of numbers.
std::string cell(double value, const char* pattern) { return value < 0 ? "-" : format(pattern, value); }

double shown(double luminance) { return luminance < 0.005 ? 0 : luminance; }

std::string ugr_text(const ups_ugr_table& t) {
  std::string text = format(
      "UGR table (CIE 190, spacing 0.25 H, for %.6g lm of lamps, for 1000 lm %+.2f; rooms across and along the view):\n"
      "  %-9s",
      t.lamp_flux_lm, -8 * std::log10(double(t.lamp_flux_lm) / 1000), "");
  std::string sets;
  for (int k = 0; k < ugr_sets; ++k) sets += format("%9s", reflectance_name(t.reflectances + 3 * k).c_str());
  text += " crosswise" + std::string(sets.size() - 10, ' ') + "   endwise\n";
  text += std::string(11, ' ') + sets + "   " + sets + "\n";
  for (int r = 0; r < ugr_rooms; ++r) {
    text += format("  %-9s", room_name(t, r).c_str());
    for (const float* values : {t.crosswise, t.endwise}) {
      for (int k = 0; k < ugr_sets; ++k)
        text += format("%9s", values[r * ugr_sets + k] == -1 ? "-" : format("%.1f", values[r * ugr_sets + k]).c_str());
      if (values == t.crosswise) text += "   ";
    }
    text += "\n";
  }
  return text;
}

std::string utilisation_text(const ups_utilisation_table& t) {
  std::string text = "utilisation factors, % of the lamps' flux (CIE 52, spread over the ceiling):\n  room index";
  for (int k = 0; k < utilisation_sets; ++k) text += format("%9s", reflectance_name(t.reflectances + 3 * k).c_str());
  for (int r = 0; r < utilisation_rooms; ++r) {
    text += format("\n  %-10.2f", t.room_index[r]);
    for (int k = 0; k < utilisation_sets; ++k) text += format("%9.1f", 100 * t.factors[r * utilisation_sets + k]);
  }
  return text + "\n";
}

std::string candela_text(const DataSheet& s) {
  std::string text = "intensity, cd, and flux by zones, lm:\n  gamma ";
  for (float c : s.c_deg) text += format("%10s", format("C %g", c).c_str());
  text += "        zone        lm";
  for (size_t j = 0; j < s.gamma_deg.size(); ++j) {
    text += format("\n  %-6g", s.gamma_deg[j]);
    for (size_t i = 0; i < s.c_deg.size(); ++i) text += format("%10.5g", s.candela[i * s.gamma_deg.size() + j]);
    if (j < s.zonal_flux_lm.size())
      text += format("%12s%10.5g", format("%g-%g", s.zone_deg[j], s.zone_deg[j + 1]).c_str(), s.zonal_flux_lm[j]);
  }
  return text + "\n";
}

std::string zones_text(const ups_data_sheet& d) {
  std::string text = "  zones, lm: front";
  for (float lm : d.front_lm) text += format(" %.5g", lm);
  text += ", back";
  for (float lm : d.back_lm) text += format(" %.5g", lm);
  return text + format(" (to 30, 60, 80, 90 deg), up %.5g %.5g (to 100, 180 deg)\n", d.up_lm[0], d.up_lm[1]);
}

}  // namespace

std::string to_text(const DataSheet& s) {
  const ups_data_sheet& d = s.sheet;
  std::string text = "CIE flux code:";
  for (float n : d.flux_code) text += format(" %.0f", n);
  text += "\n";
  if (d.highest_luminance_cd_m2 >= 0)
    text += format("highest luminance from 65 to 85 deg: %.5g cd/m^2 at C %g, gamma %g deg ",
                   d.highest_luminance_cd_m2, d.highest_luminance_c_deg, d.highest_luminance_gamma_deg) +
            format("(at 65 deg %.5g, 75 deg %.5g, 85 deg %.5g)\n", shown(d.luminance_cd_m2[0]),
                   shown(d.luminance_cd_m2[1]), shown(d.luminance_cd_m2[2]));
  const auto spacing = [&](int i) { return cell(d.spacing_criterion[i], "%.2f"); };
  text += "spacing criterion: C0-C180 " + spacing(0) + ", C90-C270 " + spacing(1) + ", diagonal " + spacing(2) + "\n";
  const auto nema = [](int type) { return type > 0 ? std::to_string(type) : std::string("-"); };
  text += "NEMA type: " + nema(d.nema_horizontal) + " x " + nema(d.nema_vertical) + " (C90-C270 x C0-C180)\n";
  text += format("BUG rating: B%d U%d G%d (front to C%g, glare limits of types %s)\n", d.backlight_rating,
                 d.uplight_rating, d.glare_rating, s.front_c_deg, d.bug_type_v ? "V" : "I to IV");
  text += zones_text(d);
  text += s.ugr ? ugr_text(*s.ugr)
                : std::string("UGR table: none, as the file states no luminous opening with an area\n");
  if (s.utilisation) text += utilisation_text(*s.utilisation);
  return text + candela_text(s);
}

std::string csv_header() { return "file,table,row,column,value\n"; }

std::string csv_rows(const std::string& file, const DataSheet& s) {
  std::string quoted = "\"";
  for (char c : file) quoted += c == '"' ? "\"\"" : std::string(1, c);
  quoted += "\"";
  std::string text;
  const auto add = [&](const char* table, const std::string& row, const std::string& column, double value) {
    text += quoted + format(",%s,%s,%s,%.9g\n", table, row.c_str(), column.c_str(), value);
  };
  const auto degrees = [](float a) { return format("%g", a); };
  const ups_data_sheet& d = s.sheet;
  for (int i = 0; i < 5; ++i) add("flux_code", format("N%d", i + 1), "percent", d.flux_code[i]);
  for (int i = 0; i < 3; ++i) add("luminance_cd_m2", degrees(65.f + 10.f * float(i)), "highest", d.luminance_cd_m2[i]);
  add("luminance_cd_m2", "65-85", "highest", d.highest_luminance_cd_m2);
  constexpr const char *sc_rows[] = {"C0-C180", "C90-C270", "diagonal"}, *zones[] = {"30", "60", "80", "90"};
  for (int i = 0; i < 3; ++i) add("spacing_criterion", sc_rows[i], "ratio", d.spacing_criterion[i]);
  add("nema_type", sc_rows[1], "type", d.nema_horizontal), add("nema_type", sc_rows[0], "type", d.nema_vertical);
  for (int i = 0; i < 4; ++i) {
    add("bug_lm", zones[i], "front", d.front_lm[i]);
    add("bug_lm", zones[i], "back", d.back_lm[i]);
  }
  add("bug_lm", "100", "up", d.up_lm[0]), add("bug_lm", "180", "up", d.up_lm[1]);
  add("bug_rating", "B", "rating", d.backlight_rating), add("bug_rating", "U", "rating", d.uplight_rating);
  add("bug_rating", "G", "rating", d.glare_rating);
  for (int r = 0; s.ugr && r < ugr_rooms; ++r)
    for (int k = 0; k < ugr_sets; ++k) {
      const std::string set = reflectance_name(s.ugr->reflectances + 3 * k);
      add("ugr_crosswise", room_name(*s.ugr, r), set, s.ugr->crosswise[r * ugr_sets + k]);
      add("ugr_endwise", room_name(*s.ugr, r), set, s.ugr->endwise[r * ugr_sets + k]);
    }
  for (int r = 0; s.utilisation && r < utilisation_rooms; ++r)
    for (int k = 0; k < utilisation_sets; ++k)
      add("utilisation", format("%g", s.utilisation->room_index[r]),
          reflectance_name(s.utilisation->reflectances + 3 * k), s.utilisation->factors[r * utilisation_sets + k]);
  for (size_t i = 0; i < s.c_deg.size(); ++i)
    for (size_t j = 0; j < s.gamma_deg.size(); ++j)
      add("candela", degrees(s.gamma_deg[j]), format("C%g", s.c_deg[i]), s.candela[i * s.gamma_deg.size() + j]);
  for (size_t j = 0; j < s.zonal_flux_lm.size(); ++j)
    add("zonal_lm", degrees(s.zone_deg[j]) + "-" + degrees(s.zone_deg[j + 1]), "flux", s.zonal_flux_lm[j]);
  return text;
}

}  // namespace ups::tool
