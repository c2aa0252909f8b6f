// See page.h: the schedule of luminaires with polar diagrams, and where they are.
#include <algorithm>
#include <cmath>
#include <map>

#include "report/data_sheet.h"
#include "report/page.h"
#include "report/profile_plot.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

constexpr size_t most_places = 80, most_diagrams = 12;

std::string what_it_is(const ups_scene_source& s) {
  constexpr const char* lights[] = {"point light", "spot light", "directional light"};  // UPS_LIGHT_*
  if (s.kind == UPS_SOURCE_INSTANCE) return s.maintained ? "emitter of a fixture" : "luminous surface";
  return s.light_kind >= 0 ? lights[s.light_kind] : "luminaire";
}

PlacedSource source_at(const LitScene& scene, uint32_t index) {
  PlacedSource source{};
  source.info.struct_size = sizeof source.info;
  check(ups_scene_get_source(scene.scene, index, &source.info));
  const SourceWords words = scene.source_words(source.info.kind, source.info.id);
  source.name = words.name;
  source.file = words.file;
  if (source.info.kind == UPS_SOURCE_LUMINAIRE && source.info.light_kind < 0) {
    ups_profile* profile = nullptr;
    check(ups_scene_get_source_profile(scene.scene, index, &profile));
    source.profile.reset(profile);
  }
  return source;
}

ups_profile_info info_of(const PlacedSource& source) {
  auto info = sized<ups_profile_info>();
  check(ups_profile_get_info(source.profile.get(), &info));
  return info;
}

// The photometry itself where no file is told, so that two luminaires of the same flux are not taken for one type.
std::string photometry_of(const PlacedSource& source) {
  if (!source.profile) return what_it_is(source.info);
  if (!source.file.empty()) return source.file;
  constexpr int planes = 24, angles = 37;
  constexpr double pi = 180 * radian;
  std::vector<float> directions, cd(planes * angles);
  for (int c = 0; c < planes; ++c)
    for (int g = 0; g < angles; ++g) {
      const double azimuth = 2 * pi * c / planes, gamma = pi * g / (angles - 1);
      const double aside = std::sin(gamma);
      for (const double x : {aside * std::cos(azimuth), aside * std::sin(azimuth), -std::cos(gamma)})
        directions.push_back(float(x));
    }
  check(ups_profile_eval(source.profile.get(), directions.data(), cd.size(), cd.data()));
  std::string all = read_text([&](char* to, size_t capacity, size_t* needed) {
    return ups_profile_get_text(source.profile.get(), UPS_PROFILE_TEXT_KEYWORDS, to, capacity, needed);
  });
  const ups_profile_info info = info_of(source);
  for (const float x : cd) all += format(" %.5g", double(x));
  return all + format(" %.5g %d %.5g %.5g %.5g", double(info.input_power_w), int(info.opening_shape),
                      double(info.opening_m[0]), double(info.opening_m[1]), double(info.opening_m[2]));
}

ProfileReport profile_of(const LuminaireType& type) {
  return make_report(type.file, type.sources[0].profile.get());
}

std::string keyword(const ProfileReport& report, const char* name) {
  for (const auto& [key, value] : report.keywords)
    if (key == name) return value;
  return {};
}

double new_flux(const PlacedSource& source, const ups_scene_info& scene) {
  return source.info.flux_lm / (source.info.maintained ? scene.maintenance_factor : 1);
}

// By which it shines more or less than its file says, new. What a render emits is the flux of the table as it is
// interpolated, or of the rays of a file.
double scale_of(const PlacedSource& source, const ups_scene_info& scene) {
  const ups_profile_info info = info_of(source);
  const double filed = info.ray_count > 0 ? info.flux_lm : info.interpolated_flux_lm;
  return new_flux(source, scene) / filed;
}

// "desk_1, desk_2, desk_3 and 5 more"
std::string names_of(const LuminaireType& type) {
  constexpr size_t shown = 3;
  std::string all;
  for (size_t i = 0; i < std::min(shown, type.sources.size()); ++i) all += (i ? ", " : "") + type.sources[i].name;
  return all + (type.sources.size() > shown ? " and " + std::to_string(type.sources.size() - shown) + " more" : "");
}

std::string product_of(const ProfileReport& report) {
  std::string all;
  for (const char* name : {"MANUFAC", "LUMINAIRE", "LUMCAT"})
    if (const std::string word = keyword(report, name); !word.empty()) all += (all.empty() ? "" : ", ") + word;
  return all;
}

// Of a luminaire that shines as its file says; else the file's power says nothing of it.
double power_w(const LuminaireType& type, const ProfileReport& report) {
  return std::abs(type.scale - 1) < 0.01 && report.info.input_power_w > 0 ? report.info.input_power_w : -1;
}

// In all, and of the scene's extent seen from above, which is the room's where nothing stands outside it.
std::string connected_load(const ups_scene_info& scene, double power_w) {
  const double area = (scene.bounds_max_m[0] - scene.bounds_min_m[0]) * (scene.bounds_max_m[1] - scene.bounds_min_m[1]);
  std::string text = "<p>Connected load: " + significant(power_w, 5) + " W";
  if (area > 0 && std::isfinite(area))
    text += ", " + significant(power_w / area, 3) + " W/m\u00b2 of the scene's extent in plan, " + significant(area, 4) +
            " m\u00b2";
  return text + ".</p>\n";
}

std::string schedule(const std::vector<LuminaireType>& types, const ups_scene_info& scene) {
  const char* maintained = scene.maintenance_factor < 1 ? ", new, without the maintenance factor" : "";
  HtmlTable table{"Luminaires <span class=\"soft\">as they are dimmed in the scene" + std::string(maintained) + "</span>",
                  {"Type", "Luminaire", "Count", "Flux of each, lm", "Flux of all, lm"}, {}, 2};
  double flux = 0, power = 0;
  size_t count = 0;
  bool with_power = false, all_powers = true;
  std::vector<double> powers;
  for (const LuminaireType& type : types) {
    powers.push_back(type.sources[0].profile ? power_w(type, profile_of(type)) : -1);
    with_power = with_power || powers.back() > 0;
    all_powers = all_powers && powers.back() > 0;
  }
  for (size_t i = 0; i < types.size(); ++i) {
    const LuminaireType& type = types[i];
    std::string what = html_text(type.file);
    if (type.sources[0].profile) {
      const std::string product = product_of(profile_of(type));
      if (!product.empty()) what += "<span class=\"i\">" + html_text(product) + "</span>";
    }
    what += "<span class=\"i\">" + html_text(names_of(type)) + "</span>";
    const double n = double(type.sources.size());
    table.rows.push_back({std::to_string(i + 1), what, std::to_string(type.sources.size()), lux(type.flux_lm),
                          lux(n * type.flux_lm)});
    if (with_power) table.rows.back().push_back(powers[i] > 0 ? significant(powers[i], 4) : "");
    if (with_power) table.rows.back().push_back(powers[i] > 0 ? significant(type.flux_lm / powers[i], 3) : "");
    flux += n * type.flux_lm, power += n * powers[i], count += type.sources.size();
  }
  if (with_power) table.head.insert(table.head.end(), {"Power of each, W", "Efficacy, lm/W"});
  if (types.size() > 1 || count > 1) {
    table.rows.push_back({"All", "", std::to_string(count), "", lux(flux)});
    if (with_power) table.rows.back().push_back("");
    if (with_power) table.rows.back().push_back(all_powers ? format("%.3g", flux / power) : "");
  }
  return html_table(table, "Schedule of luminaires") +
         (all_powers && with_power ? connected_load(scene, power) : "");
}

// With the flux that it has in the scene: a rating rises by 8 log10 of it.
std::string rating(float table_value, double flux_ratio) {
  return table_value == -1 ? "none" : format("%.1f", double(table_value) + 8 * std::log10(flux_ratio));
}

// What data sheets are compared by: flux code, luminance that troubles screens, UGR of the standard room.
std::string sheet_text(const LuminaireType& type, const ProfileReport& report) {
  const DataSheet sheet = data_sheet_of(report, type.sources[0].profile.get());
  std::string text = " CIE flux code";
  for (const float part : sheet.sheet.flux_code) text += format(" %.0f", double(part));
  text += ".";
  if (sheet.sheet.highest_luminance_cd_m2 >= 0)
    text += " Luminance from 65\u00b0 to 85\u00b0: at most " +
            lux(type.scale * double(sheet.sheet.highest_luminance_cd_m2)) + " cd/m\u00b2.";
  if (!sheet.ugr) return text;
  const std::string room = "4H 8H", reflectances = "70/50/20";
  for (int r = 0; r < ugr_rooms; ++r)
    for (int k = 0; k < ugr_sets; ++k)
      if (room_name(*sheet.ugr, r) == room && reflectance_name(sheet.ugr->reflectances + 3 * k) == reflectances)
        text += " UGR in the room " + room + ", " + reflectances + " (CIE 190, spacing 0.25 H): " +
                rating(sheet.ugr->crosswise[r * ugr_sets + k], type.scale) + " crosswise, " +
                rating(sheet.ugr->endwise[r * ugr_sets + k], type.scale) + " endwise.";
  return text;
}

std::string polar(const LuminaireType& type, size_t number) {
  const ProfileReport report = profile_of(type);
  const ups_profile* profile = type.sources[0].profile.get();
  constexpr double width = 330, margin = 8;
  const double height = shines_up(profile, report) ? 340 : 250;
  Drawing drawing{width, height, {}};
  draw_polar(drawing, {margin, margin, width - 2 * margin, height - 2 * margin}, profile, report);
  std::string caption = "<strong>Type " + std::to_string(number) + "</strong>: " + html_text(type.file) +
                        ". Peak " + significant(type.scale * double(report.info.peak_cd), 4) + " cd";
  if (std::abs(type.scale - 1) > 0.005)
    caption += ", " + significant(type.scale, 3) + " of what its file says" +
               (is_per_kilolumen(report) ? "" : ", which the diagram shows");
  std::string planes;
  constexpr const char* colours[] = {"blue, solid", "orange, dashed", "green, dotted"};
  const auto drawn = drawn_planes(report);
  for (size_t i = 0; i < drawn.size(); ++i)
    planes += format("; C%.0f-C%.0f (%s): beam ", drawn[i].c_deg, drawn[i].c_deg + 180, colours[i]) +
              html_text(angle_text(report, drawn[i].beam, "\u00b0"));
  caption += planes + ".";
  if (report.info.opening_shape != UPS_OPENING_POINT)
    caption += " Luminous opening: " + html_text(opening_text(report.info)) + ".";
  caption += sheet_text(type, report);
  return html_figure(inline_svg(drawing, "Polar diagram of " + type.file,
                                "Luminous intensity by angle in the planes " + std::to_string(drawn.size()) +
                                    " of the luminaire, nadir at the bottom. " + beams_text(report),
                                "polar" + std::to_string(number)),
                     caption);
}

std::string diagrams(const std::vector<LuminaireType>& types) {
  std::string html;
  size_t drawn = 0, number = 0;
  std::map<std::string, bool> seen;  // one of a photometry, whatever its flux
  for (const LuminaireType& type : types) {
    ++number;
    if (!type.sources[0].profile || seen[type.photometry] || drawn == most_diagrams) continue;
    seen[type.photometry] = true;
    html += polar(type, number), ++drawn;
  }
  return html.empty() ? "" : "<h3>Luminous intensity</h3>\n<div class=\"cards\">\n" + html + "</div>\n";
}

// Degrees from the nadir and, of what does not shine straight down, from +X towards +Y.
std::string aim(const ups_scene_source& s) {
  if (s.kind == UPS_SOURCE_INSTANCE) return "";
  if (s.light_kind == UPS_LIGHT_POINT) return "all around";
  const double* m = s.to_world;
  const double d[3] = {-m[2], -m[6], -m[10]}, length = std::sqrt(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
  const double tilt = std::acos(std::clamp(-d[2] / length, -1.0, 1.0)) / radian;
  if (tilt < 0.05) return "down";
  if (tilt > 179.95) return "up";
  return format("%.0f\u00b0 from down, towards %.0f\u00b0", tilt,
                std::fmod(std::atan2(d[1], d[0]) / radian + 360, 360));
}

std::string places(const std::vector<LuminaireType>& types) {
  HtmlTable table{"Places <span class=\"soft\">of the luminaires' centres, m; directions from +X towards +Y</span>",
                  {"Name", "Type", "x", "y", "z", "Shines"}, {}, 1};
  size_t number = 0, all = 0;
  for (const LuminaireType& type : types) {
    ++number;
    for (const PlacedSource& source : type.sources) {
      if (++all > most_places) continue;
      std::vector<std::string> row = {html_text(source.name), std::to_string(number)};
      const bool from_afar = source.info.light_kind == UPS_LIGHT_DIRECTIONAL;
      for (int k = 0; k < 3; ++k)
        row.push_back(from_afar ? ""
                                : format("%.2f", 0.5 * (source.info.bounds_min_m[k] + source.info.bounds_max_m[k])));
      row.push_back(aim(source.info));
      table.rows.push_back(row);
    }
  }
  if (table.rows.empty()) return {};
  return html_table(table, "Places of luminaires") +
         (all > most_places ? format("<p>The first %zu of %zu.</p>\n", most_places, all) : "");
}

}  // namespace

std::vector<LuminaireType> luminaire_types(const LitScene& scene) {
  uint32_t count = 0;
  check(ups_scene_get_source_count(scene.scene, &count));
  std::vector<LuminaireType> types;
  std::map<std::pair<std::string, std::string>, size_t> known;
  for (uint32_t i = 0; i < count; ++i) {
    PlacedSource source = source_at(scene, i);
    if (!(source.info.flux_lm > 0)) continue;
    const std::string file = source.file.empty() ? what_it_is(source.info) : source.file,
                      photometry = photometry_of(source);
    const auto [at, is_new] = known.try_emplace({photometry, format("%.4g", source.info.flux_lm)}, types.size());
    if (is_new) {
      const ups_scene_info info = info_of(scene);
      const double scale = source.profile ? scale_of(source, info) : 1;
      const double flux = source.profile ? scale * info_of(source).flux_lm : new_flux(source, info);
      types.push_back({file, photometry, flux, scale, {}});
    }
    types[at->second].sources.push_back(std::move(source));
  }
  return types;
}

Section luminaires_section(const PageInput& in, const std::vector<LuminaireType>& types) {
  if (types.empty()) return {};
  return {"luminaires", "Luminaires", schedule(types, info_of(in.scene)) + diagrams(types) + places(types)};
}

}  // namespace ups::report
