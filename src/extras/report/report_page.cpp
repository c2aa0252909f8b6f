// See page.h: the page around its sections.
#include "report/page.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

// Sections that start a page on paper.
bool starts_page(const Section& section) {
  return section.id == "scene" || section.id == "luminaires" || section.id == "flux";
}

std::string contents(const std::vector<Section>& sections) {
  std::string html;
  for (const Section& s : sections) html += "<li><a href=\"#" + s.id + "\">" + s.title + "</a></li>\n";
  return "<nav aria-label=\"Contents\"><ul>\n" + html + "</ul></nav>\n";
}

}  // namespace

std::string inline_svg(const Drawing& drawing, const std::string& title, const std::string& description,
                       const std::string& id) {
  std::string svg = to_svg(drawing, {title, description}, id + "-");
  return svg.erase(0, svg.find("<svg"));  // what stands before it is for documents of their own
}

std::string report_page(const PageInput& in) {
  const std::vector<LuminaireType> types = luminaire_types(in.scene);
  std::vector<Section> sections;
  for (Section section :
       {summary_section(in), targets_section(in), scene_section(in, types), luminaires_section(in, types),
        illuminance_section(in), glare_section(in), pictures_section(in), flux_section(in), effects_section(in),
        accuracy_section(in), warnings_section(in), reading_section(in), repeat_section(in)})
    if (!section.body.empty()) sections.push_back(std::move(section));
  const std::string title = html_text(in.title);
  std::string html =
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n"
      "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n"
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; "
      "style-src 'unsafe-inline'\">\n<meta name=\"generator\" content=\"ups " +
      version_number() + "\">\n<title>Lighting report: " + title +
      "</title>\n<link rel=\"icon\" href=\"data:,\">\n<style>\n" + page_style() +
      "</style>\n</head>\n<body>\n<header>\n<p class=\"kind\">Lighting report</p>\n<h1>" + title +
      "</h1>\n<p class=\"soft\">" + html_text(in.report.scene) +
      (in.date.empty() || in.report.scene.empty() ? "" : " \u00b7 ") + html_text(in.date) + "</p>\n" +
      contents(sections) + "</header>\n<main>\n";
  for (const Section& s : sections)
    html += "<section id=\"" + s.id + "\" aria-labelledby=\"" + s.id + "-heading\"" +
            (starts_page(s) ? " class=\"page\"" : "") + ">\n<h2 id=\"" + s.id + "-heading\">" + s.title + "</h2>\n" +
            s.body + "</section>\n";
  return html + "</main>\n<footer>\n<p>Made by ups " + version_number() +
         ", which computes illuminance by Unified Path Sampling.</p>\n</footer>\n</body>\n</html>\n";
}

}  // namespace ups::report
