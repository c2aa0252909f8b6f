// See page.h: what was lit: the scene in plan, section and numbers, and the cameras' pictures of it.
#include <algorithm>
#include <cmath>

#include "report/page.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

std::string wide_figure(const std::string& svg, const std::string& label, const std::string& caption,
                        const char* style = "wide") {
  return html_figure("<div class=\"scroll\" role=\"region\" tabindex=\"0\" aria-label=\"" + html_text(label) + "\">\n" +
                         svg + "</div>\n",
                     caption, style);
}

std::string size_text(const ups_scene_info& info) {
  if (info.bounds_min_m[0] > info.bounds_max_m[0]) return {};
  double size[3];
  for (int k = 0; k < 3; ++k) size[k] = info.bounds_max_m[k] - info.bounds_min_m[k];
  return format("%.2f m \u00d7 %.2f m \u00d7 %.2f m (x, y, z)", size[0], size[1], size[2]);
}

std::string exposure_text(const CameraReport::Picture& p) {
  std::string text;
  if (p.told)
    text = format("Exposure %s: %s cd/m\u00b2 is shown as a middle grey (EV100 %.1f).",
                  p.given ? "as asked for" : "chosen from the picture itself",
                  significant(0.125 * std::exp2(p.ev100), 3).c_str(), p.ev100);
  return text + (p.smoothed ? " Smoothed for display, for looking at alone." : "");
}

std::string picture(const PageInput& in, const CameraReport& camera) {
  const std::vector<uint8_t> bytes = in.picture(camera.sensor);
  if (bytes.empty()) return {};
  const std::string caption = "<strong>" + html_text(camera.name) + "</strong>. " +
                              "Mean luminance " + significant(camera.mean_luminance_cd_m2, 4) + " cd/m\u00b2. " +
                              (camera.picture ? exposure_text(*camera.picture) : "");
  return html_figure(
      html_image("image/png", bytes, "Rendered picture of the camera " + camera.name, camera.width, camera.height),
      caption);
}

}  // namespace

Section scene_section(const PageInput& in, const std::vector<LuminaireType>& types) {
  const ups_scene_info info = info_of(in.scene);
  size_t luminaires = 0, sets = 0, meters = 0, cameras = 0;
  const size_t observers = in.report.observers.size();
  double flux = 0;
  bool others = false;  // lights, surfaces, of which a fixture may have many
  for (const LuminaireType& type : types) {
    luminaires += type.sources.size();
    others = others || !type.sources[0].profile;
    flux += type.flux_lm * double(type.sources.size());
  }
  for (const SensorEntry& sensor : in.scene.sensors) {
    sets += sensor.info.kind == SensorKind::meters;
    meters += sensor.info.kind == SensorKind::meters ? sensor.info.meter_count : 0;
    cameras += sensor.info.kind == SensorKind::camera;
  }
  const std::string lights = others ? counted(luminaires, "light source", "light sources")
                                    : counted(luminaires, "luminaire", "luminaires");
  std::string body = html_facts(
      {{"Size", html_text(size_text(info))},
       {"Luminaires", lights + ", " + lux(flux) + " lm"},
       {"Meters", sets ? counted(meters, "point", "points") + " in " + counted(sets, "set", "sets") : ""},
       {"Observers", observers ? std::to_string(observers) : ""},
       {"Cameras", cameras ? std::to_string(cameras) : ""},
       {"Maintenance factor", info.maintenance_factor < 1 ? format("%.3g", info.maintenance_factor) : ""},
       {"Surfaces", counted(size_t(info.triangle_count), "triangle", "triangles")}});
  if (!has_plan(in, types)) return {"scene", "Scene", body};
  const std::string words = lights + " and " +
                            counted(sets, "set of meters", "sets of meters") + " of a scene of " + size_text(info) +
                            ".";
  body += wide_figure(inline_svg(plan_drawing(in, types), "Plan of the scene", "Seen from above: " + words, "plan"),
                      "Plan of the scene",
                      "Plan. Black: what the plane cuts; grey: what lies below; yellow: luminaires" +
                          std::string(types.size() > 1 ? ", with the numbers of their types" : "") +
                          "; blue: meters and the names of their sets" +
                          (in.report.observers.empty() ? "." : "; violet: observers and where they look."));
  body += wide_figure(
      inline_svg(section_drawing(in, types), "Section of the scene", "Seen from the side: " + words, "section"),
      "Section of the scene", "Section A-A through the middle, with all luminaires and meters projected onto it.",
      "wide low");
  return {"scene", "Scene", body};
}

Section pictures_section(const PageInput& in) {
  std::string body;
  for (const CameraReport& camera : in.report.cameras) body += picture(in, camera);
  if (body.empty()) return {};
  return {"pictures", "Pictures", body + "<p>Pictures are for looking at; numbers are those of the meters.</p>\n"};
}

}  // namespace ups::report
