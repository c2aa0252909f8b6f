// See page.h: what was asked for and what was found: verdicts, statistics of the meters, their maps.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include "tool/page.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

std::string chip(Judgement judgement) {
  const char* words = judgement == Judgement::met       ? "\u2713 met"
                      : judgement == Judgement::not_met ? "\u2717 not met"
                                                        : "? not sure";
  return std::string("<span class=\"verdict ") + judgement_word(judgement) + "\">" + words + "</span>";
}

struct Quantity {
  const char* word;    // of TargetVerdict
  const char* html;
  const char* unit;
  std::string (*text)(double);
};

std::string one_decimal(double value) { return format("%.1f", value); }

const Quantity& quantity_of(const std::string& word) {
  static const Quantity all[] = {{"mean_lx", "mean illuminance <i>E</i><sub>m</sub>", " lx", lux},
                                 {"min_lx", "smallest illuminance <i>E</i><sub>min</sub>", " lx", lux},
                                 {"uniformity", "uniformity <i>U</i><sub>0</sub>", "", ratio},
                                 {"ugr", "glare UGR", "", one_decimal}};
  return *std::find_if(std::begin(all), std::end(all) - 1, [&](const Quantity& q) { return word == q.word; });
}

std::string required_text(double value) { return format("%.6g", value); }

size_t count_of(const Report& report, Judgement judgement) {
  return size_t(std::count_if(report.targets.begin(), report.targets.end(),
                              [&](const TargetVerdict& v) { return v.judgement == judgement; }));
}

std::string verdicts_text(const Report& report) {
  const size_t met = count_of(report, Judgement::met), failed = count_of(report, Judgement::not_met),
               open = count_of(report, Judgement::not_sure);
  if (met == report.targets.size()) return counted(met, "requirement is met.", "requirements are all met.");
  std::string text = std::to_string(met) + " of " + counted(report.targets.size(), "requirement", "requirements") +
                     " met";
  if (failed > 0) text += ", " + std::to_string(failed) + " not met";
  if (open > 0) text += ", " + std::to_string(open) + " not sure: the 95 % interval holds the required value";
  return text + ".";
}

std::string area_table(const PageInput& in, size_t index) {
  const TargetArea& area = in.targets->areas[index];
  std::string caption = html_text(area.name);
  if (!area.use.empty()) {
    caption += " <span class=\"soft\">" + html_text(area.use);
    const std::string& standard = in.targets->standard;
    if (!area.reference.empty() && !standard.empty())
      caption += ", " + html_text(standard) + ", " + html_text(area.reference);
    caption += "</span>";
  }
  HtmlTable table{caption, {"Where", "What", "Required", "Found", "95&nbsp;% interval", "Verdict"}, {}, 2};
  for (const TargetVerdict& v : in.report.targets) {
    if (v.area != index) continue;
    const Quantity& q = quantity_of(v.quantity);
    std::string range;
    if (v.low >= 0 && v.high >= 0) {
      const std::string low = beside(v.low, v.required, q.text), high = beside(v.high, v.required, q.text);
      range = low == high ? low : low + " to " + high;
    }
    table.rows.push_back({html_text(v.subject), q.html,
                          (v.at_most ? "\u2264 " : "\u2265 ") + required_text(v.required) + q.unit,
                          beside(v.value, v.required, q.text) + q.unit, range, chip(v.judgement)});
  }
  return html_table(table, "Requirements of " + area.name);
}

// ---- statistics

std::string statistics_table(const PageInput& in) {
  HtmlTable table{"Illuminance of each set of meters <span class=\"soft\">lx, with 95&nbsp;% intervals below</span>",
                  {"Meters", "Count", "Mean", "Minimum", "Maximum", "<i>U</i><sub>0</sub>", "5&nbsp;% are below"},
                  {}, 1};
  for (const MeterReport& meters : in.report.meters) {
    const ups_meter_statistics& s = meters.statistics;
    const bool known = s.mean_error_bound_lx >= 0;
    const bool one = s.count == 1;
    std::vector<std::string> row = {
        html_text(meters.name), std::to_string(s.count),
        with_interval(s.mean_lx, known ? std::max(0.0, s.mean_lx - s.mean_error_bound_lx) : -1,
                      known ? s.mean_lx + s.mean_error_bound_lx : -1, lux)};
    if (one) {
      row.resize(7);
    } else {
      row.push_back(with_interval(s.min_lx, s.min_low_lx, s.min_high_lx, lux));
      row.push_back(with_interval(s.max_lx, s.max_low_lx, s.max_high_lx, lux));
      row.push_back(with_interval(s.uniformity, s.uniformity_low, s.uniformity_high, ratio));
      row.push_back(with_interval(s.percentile_5_lx, s.percentile_5_low_lx, s.percentile_5_high_lx, lux));
    }
    table.rows.push_back(row);
  }
  return html_table(table, "Statistics of the meters");
}

}  // namespace

// The page in a few lines: for whoever reads no further.
Section summary_section(const PageInput& in) {
  std::vector<std::string> lines;
  if (!in.report.targets.empty()) lines.push_back("<strong>" + html_text(verdicts_text(in.report)) + "</strong>");
  constexpr size_t shown = 6;
  for (size_t i = 0; i < std::min(shown, in.report.meters.size()); ++i) {
    const ups_meter_statistics& s = in.report.meters[i].statistics;
    std::string line = "<strong>" + html_text(in.report.meters[i].name) + "</strong>: " + lux(s.mean_lx) + " lx";
    if (s.mean_error_bound_lx >= 0) line += " \u00b1 " + format("%.2g", s.mean_error_bound_lx);
    if (s.count > 1) line += " on average, " + lux(s.min_lx) + " to " + lux(s.max_lx) + " lx, <i>U</i><sub>0</sub> " + ratio(s.uniformity);
    lines.push_back(line);
  }
  if (in.report.meters.size() > shown)
    lines.push_back("and " + counted(in.report.meters.size() - shown, "set of meters", "sets of meters") + " more");
  if (!in.report.convergence.empty() && in.report.convergence.back().p95_relative_error >= 0 && !in.report.meters.empty())
    lines.push_back(format("95&nbsp;%% of the meters are known to %.2g&nbsp;%% or better, the worst to %.2g&nbsp;%%.",
                           100 * double(in.report.convergence.back().p95_relative_error),
                           100 * double(in.report.convergence.back().worst_relative_error)));
  if (!in.report.warnings.empty())
    lines.push_back("<a href=\"#warnings\">" + counted(in.report.warnings.size(), "warning", "warnings") + "</a>");
  if (lines.empty()) return {};
  std::string body;
  for (const std::string& line : lines) body += "<p>" + line + "</p>\n";
  return {"summary", "In short", "<div class=\"answer\">\n" + body + "</div>\n"};
}

Section targets_section(const PageInput& in) {
  if (!in.targets || in.report.targets.empty()) return {};
  std::string body;
  for (size_t i = 0; i < in.targets->areas.size(); ++i) body += area_table(in, i);
  body += "<p>Met and not met are said only where the whole 95&nbsp;% interval lies on one side of what is required. "
          "Nothing is rounded up.</p>\n";
  if (!in.targets->note.empty()) body += "<p class=\"soft\">" + html_text(in.targets->note) + "</p>\n";
  return {"requirements", "Requirements", body};
}

Section illuminance_section(const PageInput& in) {
  if (in.report.meters.empty()) return {};
  return {"illuminance", "Illuminance", statistics_table(in)};
}

}  // namespace ups::tool
