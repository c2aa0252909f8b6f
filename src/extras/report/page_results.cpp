// See page.h: what was asked for and what was found: the page in short, verdicts, statistics of the meters.
#include <algorithm>
#include <cmath>
#include <optional>

#include "report/meter_places.h"
#include "report/page.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

std::string chip(Judgement judgement) {
  const char* words = judgement == Judgement::met       ? "\u2713 met"
                      : judgement == Judgement::not_met ? "\u2717 not met"
                                                        : "? not sure";
  return std::string("<span class=\"verdict ") + judgement_word(judgement) + "\">" + words + "</span>";
}

struct Quantity {
  const char* word;  // of TargetVerdict
  const char* html;
  const char* unit;
  std::string (*text)(double);
};

constexpr Quantity quantities[] = {{"mean_lx", "Mean illuminance", " lx", lux},
                                   {"min_lx", "Smallest illuminance", " lx", lux},
                                   {"uniformity", "Uniformity <i>U</i><sub>0</sub>", "", ratio},
                                   {"ugr", "Glare UGR", "", one_decimal}};

const Quantity& quantity_of(const std::string& word) {
  return *std::find_if(std::begin(quantities), std::end(quantities) - 1,
                       [&](const Quantity& q) { return word == q.word; });
}

std::string required_text(const TargetVerdict& v) {
  return (v.at_most ? "\u2264\u00a0" : "\u2265\u00a0") + format("%.6g", v.required) + quantity_of(v.quantity).unit;
}

size_t count_of(const Report& report, Judgement judgement) {
  return size_t(std::count_if(report.targets.begin(), report.targets.end(),
                              [&](const TargetVerdict& v) { return v.judgement == judgement; }));
}

std::string verdicts_text(const Report& report) {
  const size_t all = report.targets.size(), met = count_of(report, Judgement::met),
               failed = count_of(report, Judgement::not_met), open = count_of(report, Judgement::not_sure);
  if (met == all) return all == 1 ? "The requirement is met." : "All " + std::to_string(all) + " requirements are met.";
  std::string text = std::to_string(met) + " of " + counted(all, "requirement is", "requirements are") + " met";
  if (failed > 0) text += ", " + std::to_string(failed) + " not met";
  if (open > 0) text += ", " + std::to_string(open) + " not sure";
  return text + ".";
}

// Value, interval and verdict of one requirement.
std::string finding(const TargetVerdict& v) {
  const std::string range = interval_text(v);
  return chip(v.judgement) + " " + value_text(v) + (range.empty() ? "" : " <span class=\"i\">" + range + "</span>");
}

std::string area_caption(const Targets& targets, const TargetArea& area) {
  std::string soft = html_text(area.use);
  if (!area.reference.empty() && !targets.standard.empty())
    soft += ", " + html_text(targets.standard) + ", " + html_text(area.reference);
  if (area.colour_rendering > 0)
    soft += format("%scolour rendering <i>R</i><sub>a</sub> \u2265 %g asked for, not calculated",
                   soft.empty() ? "" : "; ", area.colour_rendering);
  return html_text(area.name) + (soft.empty() ? "" : " <span class=\"soft\">" + soft + "</span>");
}

// A row a set of meters or observer, a column a quantity with what is required at its head.
std::string area_table(const PageInput& in, size_t index) {
  const TargetArea& area = in.targets->areas[index];
  HtmlTable table{area_caption(*in.targets, area), {"Where"}, {}, 1};
  std::vector<std::string> columns;
  for (const TargetVerdict& v : in.report.targets) {
    if (v.area != index || std::find(columns.begin(), columns.end(), v.quantity) != columns.end()) continue;
    columns.push_back(v.quantity);
    table.head.push_back(quantity_of(v.quantity).html + (" <span class=\"i\">" + required_text(v)) + "</span>");
  }
  std::string subject;
  for (const TargetVerdict& v : in.report.targets) {
    if (v.area != index) continue;
    const auto place = std::find(columns.begin(), columns.end(), v.quantity) - columns.begin();
    const size_t column = size_t(place) + 1;
    const bool another = table.rows.empty() || subject != v.subject || !table.rows.back()[column].empty();
    if (another) {  // two may have the same name
      table.rows.push_back(std::vector<std::string>(1 + columns.size()));
      table.rows.back()[0] = html_text(subject = v.subject);
    }
    table.rows.back()[column] = finding(v);
  }
  return html_table(table, "Requirements of " + area.name);
}

std::string shortfalls(const PageInput& in) {
  std::string html;
  for (const TargetVerdict& v : in.report.targets) {
    if (v.judgement == Judgement::met) continue;
    const Quantity& q = quantity_of(v.quantity);
    html += "<li>" + html_text(in.targets->areas[v.area].name) + ", " + html_text(v.subject) + ": " + q.html + " " +
            value_text(v) + ", required " + required_text(v) + " " + chip(v.judgement) +
            "</li>\n";
  }
  return html.empty() ? "" : "<ul>\n" + html + "</ul>\n";
}

std::string found_in_short(const Report& report) {
  constexpr size_t shown = 8;
  std::string html;
  for (size_t i = 0; i < std::min(shown, report.meters.size()); ++i) {
    const ups_meter_statistics& s = report.meters[i].statistics;
    html += "<p><strong>" + html_text(report.meters[i].name) + "</strong>: ";
    if (s.mean_lx < 0) {
      html += "not known yet</p>\n";
      continue;
    }
    html += lux(s.mean_lx) + " lx";
    if (s.mean_error_bound_lx >= 0) html += " \u00b1 " + bound_text(s.mean_error_bound_lx);
    if (s.count > 1)
      html += " on average, " + lux(s.min_lx) + " to " + lux(s.max_lx) + " lx, <i>U</i><sub>0</sub> " +
              ratio(s.uniformity);
    html += "</p>\n";
  }
  if (report.meters.size() > shown)
    html += "<p>and " + counted(report.meters.size() - shown, "set of meters", "sets of meters") + " more</p>\n";
  return html;
}

// ---- statistics

// Columns that say nothing of any set are left out.
struct Column {
  std::string head;
  std::vector<std::string> cells;
};

std::string bounded(const ups_interval& i, std::string (*text)(double)) {
  return with_interval(i.value, i.low, i.high, text);
}

ups_interval in_percent(const ups_interval& i) {
  return {100 * i.value, i.low < 0 ? -1 : 100 * i.low, i.high < 0 ? -1 : 100 * i.high};
}

// Of one column, a cell a set; none of a set of a single meter, which has a mean alone.
template <class Cell>
Column column(const Report& report, const std::string& head, const Cell& cell) {
  Column c{head, {}};
  for (const MeterReport& meters : report.meters) c.cells.push_back(meters.statistics.count > 1 ? cell(meters) : "");
  return c;
}

Column kinds_of(const Report& report) {
  Column kinds{"Kind", {}};
  for (const MeterReport& meters : report.meters) kinds.cells.push_back(meters.kind);
  if (std::all_of(kinds.cells.begin(), kinds.cells.end(), [](const std::string& k) { return k == "planar"; }))
    for (std::string& cell : kinds.cells) cell.clear();
  return kinds;
}

std::vector<Column> columns_of(const Report& report) {
  std::vector<Column> columns;
  Column count{"Meters", {}}, mean{"Mean", {}};
  for (const MeterReport& meters : report.meters) {
    const ups_meter_statistics& s = meters.statistics;
    const bool known = s.mean_error_bound_lx >= 0;
    count.cells.push_back(std::to_string(s.count));
    mean.cells.push_back(with_interval(s.mean_lx, known ? std::max(0.0, s.mean_lx - s.mean_error_bound_lx) : -1,
                                       known ? s.mean_lx + s.mean_error_bound_lx : -1, lux));
  }
  columns = {kinds_of(report), count, mean};
  columns.push_back(column(report, "Minimum", [](const MeterReport& m) {
    return with_interval(m.statistics.min_lx, m.statistics.min_low_lx, m.statistics.min_high_lx, lux);
  }));
  columns.push_back(column(report, "Maximum", [](const MeterReport& m) {
    return with_interval(m.statistics.max_lx, m.statistics.max_low_lx, m.statistics.max_high_lx, lux);
  }));
  columns.push_back(column(report, "<i>U</i><sub>0</sub> <span class=\"i\">min/mean</span>", [](const MeterReport& m) {
    return with_interval(m.statistics.uniformity, m.statistics.uniformity_low, m.statistics.uniformity_high, ratio);
  }));
  columns.push_back(column(report, "<i>U</i><sub>d</sub> <span class=\"i\">min/max</span>", [](const MeterReport& m) {
    return with_interval(m.statistics.diversity, m.statistics.diversity_low, m.statistics.diversity_high, ratio);
  }));
  return columns;
}

std::vector<Column> percentile_columns(const Report& report) {
  std::vector<Column> columns;
  for (size_t i = 0; i < report.meters[0].percentiles.size(); ++i)
    columns.push_back(column(report, format("%g&nbsp;%% are below", 100 * report.meters[0].percentiles[i].at),
                             [&](const MeterReport& m) { return bounded(m.percentiles[i].interval, lux); }));
  for (size_t i = 0; i < report.meters[0].above.size(); ++i)
    columns.push_back(column(report, format("At least %g lx <span class=\"i\">%%</span>", report.meters[0].above[i].at),
                             [&](const MeterReport& m) { return bounded(in_percent(m.above[i].interval), one_decimal); }));
  return columns;
}

// "8 x 4" of a grid, "12 triangles" of surfaces, "64 x 64 texels" of a lightmap; else nothing.
std::string layout_of(const SensorInfo& info) {
  if (info.layout == MeterLayout::surface) return format("%u triangles", info.meter_count);
  if (info.layout == MeterLayout::lightmap) return format("%u \u00d7 %u texels", info.width, info.height);
  return info.columns > 0 ? format("%u \u00d7 %u", info.columns, info.rows) : "";
}

// "8 x 4, horizontal, at 0.75 m": how many, which way, how high. Empty where they have nothing of it in common.
std::string place_of(const LitScene& scene, const SensorEntry& set) {
  constexpr size_t most = 200000;
  if (set.info.meter_count > most) return {};
  const MeterPlaces places = meter_places(scene, set);
  std::string text = layout_of(set.info);
  std::optional<double> first;  // height of
  bool level = true, upward = true, vertical = true;
  for (const size_t m : places.listed) {
    if (!places.has_place(m)) continue;
    const double height = first.value_or(places.positions[3 * m + 2]);
    first = height;
    const float up = places.normals[3 * m + 2];
    level = level && std::abs(places.positions[3 * m + 2] - height) < 1e-4;
    upward = upward && up > 0.9999f;
    vertical = vertical && std::abs(up) < 1e-3f;
  }
  if (!first) return text;
  if (set.info.meter_kind == UPS_METER_PLANAR && (upward || vertical))
    text += (text.empty() ? "" : ", ") + std::string(upward ? "horizontal" : "vertical");
  if (level) text += (text.empty() ? "" : ", ") + format("at %.2f m", *first);
  return text;
}

std::string table_of(const PageInput& in, const std::string& caption, const std::vector<Column>& columns,
                     const std::string& label, bool with_places) {
  const Report& report = in.report;
  HtmlTable table{caption, {"Set of meters"}, {}, 1};
  for (const MeterReport& meters : report.meters) {
    const std::string place = with_places ? place_of(in.scene, in.scene.sensors[meters.sensor]) : std::string();
    table.rows.push_back({html_text(meters.name) + (place.empty() ? "" : " <span class=\"i\">" + place + "</span>")});
  }
  for (const Column& c : columns) {
    if (std::all_of(c.cells.begin(), c.cells.end(), [](const std::string& cell) { return cell.empty(); })) continue;
    table.head.push_back(c.head);
    for (size_t i = 0; i < c.cells.size(); ++i) table.rows[i].push_back(c.cells[i]);
  }
  return table.head.size() > 1 ? html_table(table, label) : "";
}

bool has_extremes(const RatioReport& ratio) { return ratio.points > 0; }

std::string ratios_table(const Report& report) {
  if (report.ratios.empty()) return {};
  HtmlTable table{"Ratios of mean illuminances", {"Of", "To", "Ratio"}, {}, 2};
  const bool by_meter = std::any_of(report.ratios.begin(), report.ratios.end(), has_extremes);
  if (by_meter) table.head.insert(table.head.end(), {"Least, meter by meter", "Greatest, meter by meter"});
  for (const RatioReport& r : report.ratios) {
    table.rows.push_back({html_text(r.numerator), html_text(r.denominator), bounded(r.ratio, ratio)});
    if (!by_meter) continue;
    for (const ups_interval& extreme : {r.least, r.greatest})
      table.rows.back().push_back(has_extremes(r) ? bounded(extreme, ratio) : "");
  }
  return html_table(table, "Ratios");
}

}  // namespace

// A rating of -1 is none: see ups_observer_reading.
std::string value_text(const TargetVerdict& v) {
  const Quantity& q = quantity_of(v.quantity);
  if (v.at_most && v.value == -1 && v.low == -1)
    return v.judgement == Judgement::met ? "no source in view" : "no rating";
  if (!v.at_most && v.value < 0) return "not known";
  return beside(v.value, v.required, q.text) + q.unit;
}

std::string interval_text(const TargetVerdict& v) {
  const auto unknown = [&](double end) { return v.at_most ? end == -1 : end < 0; };  // ratings may be below 0
  if (unknown(v.low) || unknown(v.high)) return {};
  const auto text = quantity_of(v.quantity).text;
  const std::string low = beside(v.low, v.required, end_text(v.low, -1, text)),
                    high = beside(v.high, v.required, end_text(v.high, 1, text));
  return low == high ? low : low + " to " + high;
}

std::string maintenance_text(const PageInput& in) {
  const double factor = in.report.info.maintenance_factor;
  return factor < 1 ? format("All values are maintained ones, with a maintenance factor of %.3g.", factor)
                    : std::string("All values are those of new luminaires: the scene sets no maintenance factor.");
}

// The page in a few lines: for whoever reads no further.
Section summary_section(const PageInput& in) {
  const bool judged = in.targets && !in.report.targets.empty();
  std::string body = judged ? "<p><strong>" + html_text(verdicts_text(in.report)) + "</strong></p>\n" + shortfalls(in)
                            : found_in_short(in.report);
  const auto& curve = in.report.convergence;
  if (!curve.empty() && curve.back().p95_relative_error >= 0 && !in.report.meters.empty())
    body += "<p>95&nbsp;% of the meters are known to " + bound_text(100 * double(curve.back().p95_relative_error)) +
            "&nbsp;% or better, the worst to " + bound_text(100 * double(curve.back().worst_relative_error)) +
            "&nbsp;%.</p>\n";
  if (!in.report.warnings.empty() || !in.report.advice.empty()) {
    const size_t count = in.report.warnings.size() + in.report.advice.size();
    body += "<p><a href=\"#warnings\">" + counted(count, "remark", "remarks") + "</a> to read before use.</p>\n";
  }
  if (body.empty()) return {};
  return {"summary", "In short", "<div class=\"answer\">\n" + body + "</div>\n"};
}

Section targets_section(const PageInput& in) {
  if (!in.targets || in.report.targets.empty()) return {};
  std::string body;
  for (size_t i = 0; i < in.targets->areas.size(); ++i) body += area_table(in, i);
  body += "<p>Met and not met are said only where the whole 95&nbsp;% interval, which stands below each value, lies on "
          "one side of what is required; nothing is rounded up. " + maintenance_text(in) + "</p>\n";
  if (!in.targets->note.empty()) body += "<p class=\"soft\">" + html_text(in.targets->note) + "</p>\n";
  return {"requirements", "Requirements", body};
}

Section illuminance_section(const PageInput& in) {
  const Report& report = in.report;
  if (report.meters.empty()) return {};
  const std::string soft = " <span class=\"soft\">lx, with 95&nbsp;% intervals below</span>";
  return {"illuminance", "Illuminance",
          "<p>" + maintenance_text(in) + "</p>\n" +
              table_of(in, "Means, extremes and uniformity" + soft, columns_of(report), "Statistics", true) +
              table_of(in, "Distribution" + soft, percentile_columns(report), "Distribution", false) +
              ratios_table(report) + maps_part(in)};
}

}  // namespace ups::report
