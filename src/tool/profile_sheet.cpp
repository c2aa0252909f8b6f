// The sheet around the diagrams: title, facts, files.
#include "tool/profile_sheet.h"

#include <algorithm>
#include <cmath>

#include "platform/paths.h"
#include "report/drawing_file.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

constexpr double legend_row = 20;

std::string keyword(const ProfileReport& report, const char* name) {
  for (const auto& [key, value] : report.keywords)
    if (key == name && !value.empty()) return value;
  return {};
}

std::string shortened(std::string text, double size, double width) {
  if (width_of(text, size) <= width) return text;
  while (!text.empty() && width_of(text + "...", size) > width) {
    do {
      text.pop_back();
    } while (!text.empty() && (uint8_t(text.back()) & 0xc0) == 0x80);  // not inside a character
    if (!text.empty() && uint8_t(text.back()) >= 0xc0) text.pop_back();
  }
  return text + "...";
}

std::string quantity_text(double value, const char* unit) {
  const Prefix prefix = prefix_of(value);
  return format("%.5g %s%s", value / prefix.factor, prefix.sign, unit);
}

std::string facts(const ProfileReport& report) {
  const ups_profile_info& info = report.info;
  std::string text = "flux " + quantity_text(info.flux_lm, "lm");
  if (report.info.light_output_ratio >= 0) {
    text += format(" (%.1f %% of ", 100 * report.info.light_output_ratio);
    text += quantity_text(info.rated_flux_lm, "lm") + ")";
  }
  text += "    peak " + quantity_text(info.peak_cd, "cd");
  if (info.peak_cd > 0) text += format(" at C %g\u00b0, gamma %g\u00b0", info.peak_c_deg, info.peak_gamma_deg);
  if (report.efficacy_lm_per_w() >= 0)
    text += format("    %.6g W, %.4g lm/W", info.input_power_w, report.efficacy_lm_per_w());
  return text;
}

// Columns as wide as their widest text: the line, the plane, its beam, its field.
void draw_legend(Drawing& drawing, double x, double y, const ProfileReport& report) {
  constexpr double size = 12, least = 90, space = 12;
  const std::vector<PlaneReport> planes = drawn_planes(report);
  std::vector<std::string> columns[3];
  for (size_t i = 0; i < planes.size(); ++i) {
    const double line_y = y + legend_row * double(i) - 4;
    drawing.add(Line{{{x, line_y}, {x + 34, line_y}}, plane_ink[i], 2.2, plane_dash[i]});
    const double c_deg = 0.1 * std::round(10 * planes[i].c_deg);  // of tables of type A and B any number
    columns[0].push_back(format("C%g-C%g", c_deg, c_deg + 180));
    columns[1].push_back("beam " + angle_text(report, planes[i].beam, "\u00b0"));
    columns[2].push_back("field " + angle_text(report, planes[i].field, "\u00b0"));
  }
  double left = x + 42;
  for (const auto& column : columns) {
    double widest = &column == columns ? 0 : least;
    for (size_t i = 0; i < column.size(); ++i) {
      drawing.add(
          Label{{left, y + legend_row * double(i)}, column[i], size, black, Anchor::start, &column == columns});
      widest = std::max(widest, width_of(column[i], size));
    }
    left += widest + space;
  }
}

}  // namespace

Drawing plot_of(const ups_profile* profile, const ProfileReport& report) {
  constexpr double width = 1000, margin = 30, top = 100;
  const double legend_height = legend_row * double(drawn_planes(report).size());
  const double height = (shines_up(profile, report) ? 600 : 460) + legend_height;
  Drawing drawing{width, height, {}};
  const std::string name = platform::file_name_of(report.file);
  drawing.add(Label{{margin, 40}, shortened(name, 22, 620), 22, black, Anchor::start, true});
  drawing.add(Label{{width - margin, 40}, report.format, 13, grey, Anchor::end});
  const std::string maker = keyword(report, "MANUFAC"), luminaire = keyword(report, "LUMINAIRE");
  const std::string what = maker + (maker.empty() || luminaire.empty() ? "" : ", ") + luminaire;
  drawing.add(Label{{margin, 62}, shortened(what, 13, width - 2 * margin), 13, grey});
  drawing.add(Line{{{margin, 74}, {width - margin, 74}}, pale, 1});
  drawing.add(Label{{margin, height - 18}, facts(report), 13, black});
  drawing.add(Line{{{margin, height - 40}, {width - margin, height - 40}}, pale, 1});
  draw_polar(drawing, {margin, top - 10, 450, height - top - 52 - legend_height}, profile, report);
  draw_legend(drawing, margin, height - 34 - legend_height, report);
  draw_cone(drawing, {530, top - 10, width - margin - 530, height - top - 42}, profile, report);
  return drawing;
}

void write_plot(const std::string& path, const ups_profile* profile, const ProfileReport& report) {
  write_drawing(path, plot_of(profile, report), {"Luminous intensity of " + report.file, ""});
}

}  // namespace ups::tool
