// What `ups info` prints of photometric files for people: a page for one, a table for many.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tool/info_report.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

std::string luminance_text(const ProfileReport& report) {
  std::string text = "mean luminance of the opening, cd/m^2:\n  gamma  ";
  for (float gamma : luminance_gamma_deg) text += format("%11g", gamma);
  for (size_t i = 0; i < luminance_c_deg.size(); ++i) {
    text += format("\n  C %-5g", luminance_c_deg[i]);
    for (float value : report.luminance_cd_m2[i])
      text += value < 0 ? format("%11s", "-") : format("%11.5g", value < 0.005f ? 0.f : value);
  }
  return text + "\n";
}

std::string zones_text(const ProfileReport& report) {
  std::string text = "flux by zones, lm:";
  for (size_t i = 0; i < zones_deg.size(); ++i) {
    text += format("%s %g-%g deg %.6g", i == 0 ? "" : ",", zones_deg[i][0], zones_deg[i][1], report.zonal_flux_lm[i]);
    if (report.info.flux_lm > 0) text += format(" (%.1f %%)", 100 * report.zonal_flux_lm[i] / report.info.flux_lm);
  }
  return text + "\n";
}

const char* symmetry_text(ups_profile_symmetry symmetry) {
  switch (symmetry) {
    case UPS_SYMMETRY_AXIAL:
      return "axial";
    case UPS_SYMMETRY_C0_C180:
      return "about the plane C0-C180";
    case UPS_SYMMETRY_C90_C270:
      return "about the plane C90-C270";
    case UPS_SYMMETRY_QUADRANTS:
      return "about both planes, C0-C180 and C90-C270";
    default:
      return "none";
  }
}

std::string table_text(const ups_profile_info& info) {
  const char* pattern = info.photometric_type == UPS_PHOTOMETRIC_A   ? "table: type A, %u planes H x %u angles V\n"
                        : info.photometric_type == UPS_PHOTOMETRIC_B ? "table: type B, %u planes V x %u angles H\n"
                                                                     : "table: %u C-planes x %u gamma angles\n";
  std::string text = format(pattern, info.c_count, info.gamma_count);
  if (info.ray_count > 0) text += format("rays: %u\n", info.ray_count);
  return text;
}

// "2 x LED, 4000 lm, 40 W, 3000 K, CRI 80".
std::string lamp_set_text(const LampSetReport& set) {
  const ups_profile_lamp_set& info = set.info;
  std::vector<std::string> parts;
  if (info.count < 0) parts.push_back("absolute photometry");
  if (info.count > 0 || !set.type.empty())
    parts.push_back((info.count > 0 ? format("%d x ", info.count) : "") + (set.type.empty() ? "lamp" : set.type));
  if (info.flux_lm >= 0) parts.push_back(format("%.6g lm", info.flux_lm));
  if (info.input_power_w >= 0) parts.push_back(format("%g W", info.input_power_w));
  if (info.colour_temperature_k >= 0)
    parts.push_back(format("%g K", info.colour_temperature_k));
  else if (!set.colour.empty())
    parts.push_back("colour " + set.colour);
  if (info.colour_rendering_index >= 0)
    parts.push_back(format("CRI %g", info.colour_rendering_index));
  else if (!set.rendering.empty())
    parts.push_back("colour rendering " + set.rendering);
  std::string text;
  for (const std::string& part : parts) text += (text.empty() ? "" : ", ") + part;
  return text.empty() ? "not described" : text;
}

std::string lamps_text(const ProfileReport& report) {
  const auto& sets = report.lamp_sets;
  if (sets.empty()) return {};
  if (sets.size() == 1) return "lamps: " + lamp_set_text(sets[0]) + "\n";
  const auto chosen = [](const LampSetReport& set) { return set.info.chosen == 1; };
  const bool together = std::all_of(sets.begin(), sets.end(), chosen);
  std::string text = format("lamp sets: %zu, %s\n", sets.size(), together ? "together" : "alternatives");
  for (size_t i = 0; i < sets.size(); ++i)
    text += format("  %zu: ", i + 1) + lamp_set_text(sets[i]) + (chosen(sets[i]) && !together ? " (taken)" : "") + "\n";
  return text;
}

std::string ratios_text(const ProfileReport& report) {
  const ups_profile_info& info = report.info;
  std::string text;
  if (info.rated_flux_lm >= 0) {
    text = format("rated lamp flux: %.6g lm\n", info.rated_flux_lm);
    if (report.info.light_output_ratio >= 0)
      text += format("light output ratio: %.1f %%\n", 100 * report.info.light_output_ratio);
  } else {
    text = "rated lamp flux: none, absolute photometry\n";
  }
  if (info.input_power_w >= 0) text += format("input power: %g W\n", info.input_power_w);
  if (report.efficacy_lm_per_w() >= 0) text += format("luminous efficacy: %.4g lm/W\n", report.efficacy_lm_per_w());
  return text;
}

// Names may be longer than their column; the rest of the line then moves to the right.
std::string padded(const std::string& name, size_t width) {
  return name + std::string(name.size() < width ? width - name.size() : 0, ' ');
}

std::string beam_cell(const ups_profile_beam& beam) {
  return beam.angle_deg < 0 ? "-" : format("%.1f", beam.angle_deg);
}

}  // namespace

std::string list_text(const char* title, const std::vector<std::string>& lines) {
  std::string text = format("%s:%s\n", title, lines.empty() ? " none" : "");
  for (const std::string& line : lines) text += "  " + line + "\n";
  return text;
}

std::string to_text(const ProfileReport& report) {
  const ups_profile_info& info = report.info;
  std::string text = report.file + "\nformat: " + report.format + "\n";
  text += format("flux: %.6g lm (as interpolated for rendering: %.6g lm)\n", info.flux_lm, info.interpolated_flux_lm);
  text += ratios_text(report);
  text += format("peak: %.6g cd at C %g deg, gamma %g deg\n", info.peak_cd, info.peak_c_deg, info.peak_gamma_deg);
  text += beams_text(report);
  text += zones_text(report);
  text += format("symmetry: %s\nopening: %s\n", symmetry_text(info.symmetry), opening_text(info).c_str());
  if (report.has_luminance()) text += luminance_text(report);
  text += table_text(info);
  text += lamps_text(report);
  std::vector<std::string> keywords;
  for (const auto& [name, value] : report.keywords) keywords.push_back(name + "=" + value);
  return text + list_text("keywords", keywords) + list_text("warnings", report.warnings);
}

std::string table_head(size_t name_width) {
  return padded("file", name_width) + format("  %-17s %10s %10s %7s %7s  %-9s  %-26s %s\n", "format", "flux lm",
                                             "peak cd", "beam C0", "C90 deg", "symmetry", "opening", "warnings");
}

std::string table_line(const ProfileReport& report, const std::string& name, size_t name_width) {
  const ups_profile_info& info = report.info;
  return padded(name, name_width) +
         format("  %-17s %10.6g %10.6g %7s %7s  %-9s  %-26s %zu\n", report.format.c_str(), info.flux_lm, info.peak_cd,
                beam_cell(report.beam[0]).c_str(), beam_cell(report.beam[1]).c_str(), symmetry_word(info.symmetry),
                opening_text(info).c_str(), report.warnings.size());
}

std::string table_line(const SceneReport& report, const std::string& name, size_t name_width) {
  return padded(name, name_width) + format("  %-17s %10.6g %10s %7s %7s  %-9s  %-26s %zu\n",
                                                             "glTF scene", report.info.emitted_flux_lm, "-", "-", "-",
                                                             "-", "-", report.warnings.size());
}

std::string table_error(const std::string& file, const std::string& error, const std::string& name,
                        size_t name_width) {
  const std::string prefix = file + ": ";  // the first column says that
  return padded(name, name_width) +
         "  error: " + (error.compare(0, prefix.size(), prefix) == 0 ? error.substr(prefix.size()) : error) + "\n";
}

}  // namespace ups::tool
