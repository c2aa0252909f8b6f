// See page.h: how sure the numbers are and what that cost: the curve of errors against time, and when more is reached.
#include <algorithm>
#include <cmath>

#include "report/page.h"
#include "report/profile_plot.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

struct Curve {
  const char* name;
  float ups_curve_point::*error;
  Ink ink;
  double dash;
};
constexpr Curve curves[] = {{"worst", &ups_curve_point::worst_relative_error, plane_ink[1], 7},
                            {"95th percentile", &ups_curve_point::p95_relative_error, plane_ink[2], 2.5},
                            {"median", &ups_curve_point::median_relative_error, plane_ink[0], 0}};

bool is_drawn(double seconds, double error) {
  return std::isfinite(seconds) && std::isfinite(error) && seconds > 0 && error > 0;
}

// Of one axis: from 1, 2 or 5 times a power of ten to another.
struct LogAxis {
  double low = INFINITY, high = 0;
  void grow(double value) { low = std::min(low, value), high = std::max(high, value); }
  static double step_up(double v) { return round_step(v); }
  static double step_down(double v) { return 1 / round_step(1 / v * (1 - 1e-9)); }
  void round() {
    low = step_down(low), high = step_up(high);
    if (!(high > low)) high = 10 * low;
  }
  std::vector<double> ticks() const {
    std::vector<double> all;
    for (double power = std::pow(10.0, std::floor(std::log10(low))); power <= high; power *= 10)
      for (const double digit : {1.0, 2.0, 5.0})
        if (const double v = digit * power; v >= low * 0.999 && v <= high * 1.001) all.push_back(v);
    return all;
  }
  double at(double value) const { return std::log(value / low) / std::log(high / low); }
};

class Plot {
 public:
  Plot(const Report& report, double target) : report_(report), target_(target) {
    for (const ups_curve_point& p : report.convergence)
      for (const Curve& curve : curves)
        if (const double error = p.*curve.error; is_drawn(p.elapsed_s, error))
          time_.grow(p.elapsed_s), error_.grow(error);
    for (const PredictionReport& p : report.predictions) {
      if (!is_drawn(p.prediction.seconds, p.relative_error)) continue;
      time_.grow(p.prediction.seconds), error_.grow(p.relative_error);
    }
    if (target > 0) error_.grow(target);
    if (!(time_.high > 0)) return;
    time_.round(), error_.round();
  }

  Drawing draw() {
    if (!(time_.high > 0)) return {};
    drawing_ = {width, height, {}};
    draw_axes();
    for (const Curve& curve : curves) draw_curve(curve);
    draw_predictions();
    if (target_ > 0) {
      const double y = place(time_.low, target_).y;
      drawing_.add(Line{{{left, y}, {right, y}}, black, 1, 5});
      drawing_.add(Label{{right, y - 4}, "target", 11, black, Anchor::end});
    }
    draw_legend();
    return std::move(drawing_);
  }

 private:
  static constexpr double width = 560, height = 380, left = 58, right = 545, top = 14, bottom = 300;
  Point place(double seconds, double error) const {
    return {left + (right - left) * time_.at(seconds), bottom - (bottom - top) * error_.at(error)};
  }

  void draw_axes() {
    for (const double v : error_.ticks()) {
      const double y = place(time_.low, v).y;
      drawing_.add(Line{{{left, y}, {right, y}}, pale, 0.7});
      drawing_.add(Label{{left - 7, y + 4}, format("%g %%", 100 * v), 12, black, Anchor::end});
    }
    const std::vector<double> ticks = time_.ticks();
    const size_t every = ticks.size() > 14 ? 3 : 1;  // powers of ten alone, of a long axis
    for (size_t i = 0; i < ticks.size(); ++i) {
      const double x = place(ticks[i], error_.low).x;
      const bool is_power = std::abs(std::remainder(std::log10(ticks[i]), 1)) < 1e-6;
      drawing_.add(Line{{{x, top}, {x, bottom}}, pale, 0.7});
      if (every == 1 || is_power)
        drawing_.add(Label{{x, bottom + 17}, format("%g", ticks[i]), 12, black, Anchor::middle});
    }
    drawing_.add(Line{{{left, top}, {left, bottom}, {right, bottom}}, black, 1});
    drawing_.add(Label{{0.5 * (left + right), bottom + 36}, "seconds of rendering", 12, grey, Anchor::middle});
  }

  void draw_curve(const Curve& curve) {
    Line line{{}, curve.ink, 2, curve.dash};
    for (const ups_curve_point& p : report_.convergence)
      if (const double error = p.*curve.error; is_drawn(p.elapsed_s, error))
        line.points.push_back(place(p.elapsed_s, error));
    if (line.points.size() > 1) drawing_.add(line);
    for (const Point& p : line.points) mark(p, curve.ink, 2);
  }

  void draw_predictions() {
    for (const PredictionReport& p : report_.predictions) {
      if (!is_drawn(p.prediction.seconds, p.relative_error)) continue;
      const double low = std::max(p.prediction.seconds_low, time_.low),
                   high = p.prediction.seconds_high < 0 ? time_.high : std::min(p.prediction.seconds_high, time_.high);
      if (high > low)
        drawing_.add(Line{{place(low, p.relative_error), place(high, p.relative_error)}, black, 1.4});
      mark(place(p.prediction.seconds, p.relative_error), black, 3.2);
    }
  }

  void mark(const Point& p, const Ink& ink, double radius) {
    drawing_.add(
        Area{{{p.x - radius, p.y}, {p.x, p.y - radius}, {p.x + radius, p.y}, {p.x, p.y + radius}}, ink});
  }

  void draw_legend() {
    double x = left;
    for (const Curve& curve : curves) {
      drawing_.add(Line{{{x, height - 16}, {x + 26, height - 16}}, curve.ink, 2, curve.dash});
      drawing_.add(Label{{x + 32, height - 12}, curve.name, 12, black});
      x += 32 + width_of(curve.name, 12) + 18;
    }
    if (report_.predictions.empty()) return;
    mark({x + 4, height - 16}, black, 3.2);
    drawing_.add(Label{{x + 13, height - 12}, "foretold, with its interval", 12, black});
  }

  const Report& report_;
  double target_;
  LogAxis time_, error_;
  Drawing drawing_;
};

std::string percent(double fraction) { return fraction < 0 ? "not known" : significant(100 * fraction, 2) + "&nbsp;%"; }

std::string predictions_table(const Report& report) {
  HtmlTable table{"When a smaller error is reached <span class=\"soft\">in all, from the start, on this machine</span>",
                  {"Error", "After", "95&nbsp;% interval", "Limited by"}, {}, 1};
  for (const PredictionReport& p : report.predictions) {
    const ups_prediction& f = p.prediction;
    const bool reached = f.seconds >= 0 && f.seconds_low == f.seconds_high;
    const std::string when = f.seconds < 0 ? "never at this rate" : duration_text(f.seconds);
    const std::string low = f.seconds_low < 0 ? "" : duration_text(f.seconds_low);
    const std::string range = reached              ? "reached"
                              : low.empty()        ? ""
                              : f.seconds_high < 0 ? "from " + low + " on"
                                                   : low + " to " + duration_text(f.seconds_high);
    table.rows.push_back(
        {percent(p.relative_error), when, range, f.limited_by == UPS_LIMIT_BIAS ? "bias" : "noise"});
  }
  return table.rows.empty() ? "" : html_table(table, "Predicted times");
}

std::string last_errors(const Report& report) {
  const ups_curve_point& p = report.convergence.back();
  const bool meters = !report.meters.empty();
  return "<p>At the last look, after " + significant(p.elapsed_s, 3) + " s" + " and " + std::to_string(p.iterations) +
         " iterations, the 95&nbsp;% error bound was " + percent(double(p.median_relative_error)) + " at the median " +
         (meters ? "meter" : "pixel") + ", " + percent(double(p.p95_relative_error)) + " at the 95th percentile and " +
         percent(double(p.worst_relative_error)) + " at the worst one.</p>\n";
}

std::string worst_meter(const Report& report) {
  if (!report.worst_meter) return {};
  const ups_largest_error& e = report.worst_meter->error;
  return format("<p>The largest error, %s, has meter %u of ", percent(double(e.relative_error)).c_str(), e.index) +
         html_text(report.worst_meter->set) +
         format(", at (%.2f, %.2f, %.2f) m; %.0f&nbsp;%% of its bound is estimated bias.</p>\n", e.position_m[0],
                e.position_m[1], e.position_m[2], 100 * double(e.bias_share));
}

}  // namespace

Drawing accuracy_drawing(const Report& report, double target) { return Plot(report, target).draw(); }

Section accuracy_section(const PageInput& in) {
  if (in.report.convergence.empty()) return {};
  const Drawing drawing = accuracy_drawing(in.report, in.report.target_error);
  std::string body = last_errors(in.report);
  if (!drawing.parts.empty())
    body += html_figure(inline_svg(drawing, "Error against time",
                                   "The relative error of the median, of the 95th percentile and of the worst, against "
                                   "seconds of rendering, both logarithmic. The last values stand in the text above.",
                                   "accuracy"),
                        "Relative error against time. Where it is noise alone it falls to a tenth in a hundredfold "
                        "time.");
  body += predictions_table(in.report) + worst_meter(in.report);
  return {"accuracy", "Accuracy and time", body};
}

}  // namespace ups::report
