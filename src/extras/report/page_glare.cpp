// See page.h: the glare ratings of observers, and what makes them.
#include <algorithm>
#include <cmath>

#include "report/page.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

constexpr size_t shown_sources = 3;

// "19.4", to a tenth as CIE 117 gives it; "none" where there is nothing to rate.
std::string rating(const ups_observer_reading& r) {
  if (r.flags & UPS_OBSERVER_NO_SOURCE)
    return r.ugr_high == -1           ? "no source in view"
           : std::isfinite(r.ugr_high) ? format("none seen <span class=\"i\">at most %.1f</span>", double(r.ugr_high))
                                       : "none seen <span class=\"i\">at most unknown</span>";
  if (r.flags & UPS_OBSERVER_NO_BACKGROUND) return "no background";
  std::string text = format("%.1f", double(r.ugr));
  if (const std::string range = rating_interval(double(r.ugr_low), double(r.ugr_high)); !range.empty())
    text += " <span class=\"i\">" + range + "</span>";
  if (r.ceiling_coverage > 0) {
    text += format(" <span class=\"i\">GGR %.1f", double(r.ggr));
    if (const std::string range = rating_interval(double(r.ggr_low), double(r.ggr_high)); !range.empty())
      text += ", " + range;
    text += "</span>";
  }
  return text;
}

std::string background(const ups_observer_reading& r) {
  if (r.background_cd_m2 < 0) return {};
  std::string text = significant(double(r.background_cd_m2), 3);
  if (r.background_error_bound_cd_m2 >= 0)
    text += " <span class=\"i\">\u00b1 " + bound_text(double(r.background_error_bound_cd_m2)) + "</span>";
  return text;
}

std::string sources(const ObserverReport& observer) {
  std::string text;
  for (size_t i = 0; i < std::min(shown_sources, observer.sources.size()); ++i)
    text += (i ? ", " : "") + html_text(observer.sources[i].name) +
            format(" %.0f&nbsp;%%", 100 * double(observer.sources[i].source.share));
  if (observer.sources.size() > shown_sources)
    text += ", " + std::to_string(observer.sources.size() - shown_sources) + " more";
  return text;
}

std::string remarks(const Report& report) {
  const std::pair<uint32_t, const char*> all[] = {
      {UPS_OBSERVER_LARGE_SOURCE, "A source of more than 0.1 sr is in view, for which UGR is too low (CIE 147)"},
      {UPS_OBSERVER_POINT_SOURCE, "A source without extent is in view, rated as a small one (CIE 147)"},
      {UPS_OBSERVER_UNRATED_SOURCE,
       "A directional light, the rays of a file or light beyond what numbers hold are in no rating"},
      {UPS_OBSERVER_FIXTURE,
       "A fixture is in view, whose own reflectors, lenses and covers count as background: the rating is too low"},
      {UPS_OBSERVER_COVERED_SOURCE,
       "A source is in view behind glass or a diffuser, which count as background: the rating is too low"}};
  std::vector<std::string> items;
  for (const auto& [flag, words] : all) {
    std::string names;
    for (const ObserverReport& observer : report.observers)
      if (observer.reading.flags & flag) names += (names.empty() ? "" : ", ") + html_text(observer.name);
    if (!names.empty()) items.push_back(std::string(words) + ": " + names + ".");
  }
  return html_list(items);
}

}  // namespace

Section glare_section(const PageInput& in) {
  if (in.report.observers.empty()) return {};
  HtmlTable table{"UGR of observers <span class=\"soft\">with 95&nbsp;% intervals below</span>",
                  {"Observer", "What troubles most", "Background, cd/m\u00b2", "UGR"}, {}, 2};
  for (const ObserverReport& observer : in.report.observers)
    table.rows.push_back(
        {html_text(observer.name), sources(observer), background(observer.reading), rating(observer.reading)});
  return {"glare", "Glare",
          html_table(table, "Glare ratings") + remarks(in.report) +
              "<p>Unified glare rating of CIE 117 from the eye's place and line of sight; the background is the "
              "indirect light at the eye. Steps that people tell apart: 10, 13, 16, 19, 22, 25, 28; less is "
              "better. GGR is the rating of CIE 147 where sources above 1.5\u00a0m\u00b2 are in view.</p>\n"};
}

}  // namespace ups::report
