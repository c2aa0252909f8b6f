// The cone below the luminaire: how wide the beam is 1 to 5 m below, and the illuminance there on a horizontal plane,
// E = I cos^3(gamma) / h^2, straight below and at the edges of the beam.
#include <algorithm>
#include <cmath>

#include "tool/profile_sheet.h"
#include "tool/text_format.h"

namespace ups::tool {
namespace {

constexpr int metres = 5;
constexpr double widest_deg = 85;                         // an edge beyond meets the floor too far away to be drawn
constexpr double ellipse_flattening = 0.16, deepest = 9;  // so that the lowest leaves the axis its numbers

struct Cone {
  bool known;
  double from, to;                                // where the edges of the beam are 1 m below, m from the axis
  double e_from, e_to;                            // lx there
  std::vector<std::pair<double, double>> others;  // from, to of the plane's other lobes
  double width() const { return to - from; }
  double reach() const {
    double reach = std::max(-from, to);
    for (const auto& [start, end] : others) reach = std::max({reach, -start, end});
    return reach;
  }
};

std::vector<std::pair<double, double>> lobes_of(const Cone& cone) {
  if (!cone.known) return {};
  std::vector<std::pair<double, double>> lobes = cone.others;
  lobes.emplace_back(cone.from, cone.to);
  return lobes;
}

bool meets_floor(double from_deg, double to_deg) { return from_deg >= -widest_deg && to_deg <= widest_deg; }

Cone cone_of(const ups_profile* profile, const ProfileReport& report, int plane) {
  const ups_profile_beam& beam = report.beam[plane];
  Cone cone{};
  cone.known = beam.angle_deg >= 0 && meets_floor(beam.from_deg, beam.to_deg);
  if (!cone.known) return cone;
  cone.from = std::tan(beam.from_deg * radian);
  cone.to = std::tan(beam.to_deg * radian);
  for (const Lobe& lobe : report.other_lobes[plane]) {
    if (meets_floor(lobe.from_deg, lobe.to_deg))
      cone.others.emplace_back(std::tan(lobe.from_deg * radian), std::tan(lobe.to_deg * radian));
  }
  // At the edge the intensity is half the peak; read it a little inside, as a table may end there.
  const double inside = 1e-4 * (beam.to_deg - beam.from_deg);
  const auto lux = [&](double angle) {
    return intensities_in_plane(profile, 90 * plane, {angle})[0] * std::pow(std::cos(angle * radian), 3);
  };
  cone.e_from = lux(beam.from_deg + inside);
  cone.e_to = lux(beam.to_deg - inside);
  return cone;
}

// Without an exponent, with two digits of even a small value; below the sixth decimal it is as good as none.
std::string small_text(double value, double smallest) {
  const double digits = smallest > 0 ? std::ceil(1 - std::log10(smallest)) : 0;
  return format("%.*f", digits > 6 ? 2 : int(std::max(digits, 2.0)), value);
}

std::string lux_text(double lux) {
  return lux >= 99.95 ? format("%.0f", lux) : lux >= 9.995 ? format("%.1f", lux) : small_text(lux, lux);
}

std::string edges_text(const Cone& cone, double h) {
  if (!cone.known) return "-";
  const double a = cone.e_from / (h * h), b = cone.e_to / (h * h);
  const bool alike = std::abs(a - b) <= 0.01 * std::max(a, b);
  return alike ? lux_text(0.5 * (a + b)) : lux_text(a) + " / " + lux_text(b);
}

struct Chart {
  Frame frame;
  double x_scale, y_scale;  // units a metre
  Point at(double x, double h) const { return {frame.left + 0.5 * frame.width + x * x_scale, frame.top + h * y_scale}; }
};

void draw_chart(Drawing& drawing, const Chart& chart, const Cone (&cones)[2]) {
  const double half = 0.5 * chart.frame.width / chart.x_scale;
  for (int h = 0; h <= metres; ++h) {
    drawing.add(Line{{chart.at(-half, h), chart.at(half, h)}, pale, 0.8});
    const Point p = chart.at(-half, h);
    drawing.add(Label{{p.x - 8, p.y + 4}, format(h == metres ? "%d m" : "%d", h), 12, grey, Anchor::end});
  }
  const double step = round_step(half / 4);
  for (int i = -int(half / step + 1e-9); i * step <= half * (1 + 1e-9); ++i) {
    const Point p = chart.at(i * step, metres);
    drawing.add(Line{{p, {p.x, p.y + 4}}, grey, 0.8});
    const bool last = (i + 1) * step > half * (1 + 1e-9);
    drawing.add(Label{{p.x, p.y + 20}, format(last ? "%g m" : "%g", i * step), 12, grey, Anchor::middle});
  }
  drawing.add(Line{{chart.at(0, 0), chart.at(0, metres)}, grey, 0.8, 4});
  // The spot at each metre, seen at a slant: its width in the plane C0-C180, its depth in C90-C270.
  const bool round = cones[0].known && cones[1].known;
  for (int h = 1; round && h <= metres; ++h) {
    for (const auto& [from, to] : lobes_of(cones[0])) {
      std::vector<Point> spot;
      const double depth = std::min(0.5 * cones[1].width() * h * chart.x_scale * ellipse_flattening, deepest);
      for (int a = 0; a <= 360; a += 5) {
        const Point p = chart.at((0.5 * (from + to) + 0.5 * (to - from) * std::cos(a * radian)) * h, h);
        spot.push_back({p.x, p.y + depth * std::sin(a * radian)});
      }
      drawing.add(Area{spot, plane_ink[0], 0.10});
      drawing.add(Line{spot, plane_ink[0], 0.7});
    }
  }
  for (const int plane : {0, 1}) {
    for (const auto& [start, end] : lobes_of(cones[plane])) {
      const Point apex = chart.at(0, 0), from = chart.at(metres * start, metres), to = chart.at(metres * end, metres);
      if (plane == 0) drawing.add(Area{{apex, from, to}, plane_ink[0], 0.08});
      drawing.add(Line{{from, apex}, plane_ink[plane], 2, plane_dash[plane]});
      drawing.add(Line{{apex, to}, plane_ink[plane], 2, plane_dash[plane]});
    }
  }
}

void draw_table(Drawing& drawing, const Frame& frame, const Cone (&cones)[2], double nadir_cd) {
  constexpr double size = 12, row = 19;
  const double columns[6] = {34, 112, 190, 262, 346, 440};  // right ends
  const auto cell = [&](int column, double y, const std::string& text, const Ink& ink, bool bold) {
    drawing.add(Label{{frame.left + columns[column], y}, text, size, ink, Anchor::end, bold});
  };
  drawing.add(Label{{frame.left + columns[2], frame.top}, "beam width, m", size, grey, Anchor::end});
  drawing.add(
      Label{{frame.left + columns[5], frame.top}, "illuminance, lx: below, at the edges", size, grey, Anchor::end});
  double y = frame.top + row;
  const char* heads[6] = {"m", "C0-C180", "C90-C270", "below", "C0-C180", "C90-C270"};
  for (int i = 0; i < 6; ++i)
    cell(i, y, heads[i], i == 1 || i == 4 ? plane_ink[0] : i == 2 || i == 5 ? plane_ink[1] : black, true);
  drawing.add(Line{{{frame.left, y + 5}, {frame.left + columns[5], y + 5}}, pale, 1});
  for (int h = 1; h <= metres; ++h) {
    y += row;
    cell(0, y, format("%d", h), black, true);
    for (int plane = 0; plane < 2; ++plane) {
      cell(1 + plane, y, cones[plane].known ? small_text(cones[plane].width() * h, cones[plane].width()) : "-", black,
           false);
      cell(4 + plane, y, edges_text(cones[plane], h), black, false);
    }
    cell(3, y, lux_text(nadir_cd / (h * h)), black, false);
  }
}

const char* why_no_cone(const ProfileReport& report) {
  if (!(report.info.peak_cd > 0)) return "No cone: no light.";
  if (!report.is_lit(report.beam[0]) && !report.is_lit(report.beam[1]))
    return "No cone: no light in the planes C0-C180 and C90-C270.";
  if (report.beam[0].angle_deg < 0 && report.beam[1].angle_deg < 0) return "No cone: the intensity has no beam.";
  return "No cone: the beam is not within 85\u00b0 of the nadir.";
}

// A line for each plane with several lobes: its numbers are of one of them.
std::vector<std::string> notes_on(const ProfileReport& report, const Cone (&cones)[2]) {
  std::vector<std::string> notes;
  for (int plane = 0; plane < 2; ++plane) {
    const size_t others = report.other_lobes[plane].size();
    const ups_profile_beam& beam = report.beam[plane];
    if (others == 0) continue;
    notes.push_back(format("C%d-C%d%s: one of %zu lobes, from %.1f\u00b0 to %.1f\u00b0", 90 * plane, 90 * plane + 180,
                           cones[plane].known ? " in the table" : "", others + 1, beam.from_deg, beam.to_deg));
  }
  return notes;
}

}  // namespace

void draw_cone(Drawing& drawing, const Frame& frame, const ups_profile* profile, const ProfileReport& report) {
  const Cone cones[2] = {cone_of(profile, report, 0), cone_of(profile, report, 1)};
  drawing.add(
      Label{{frame.left, frame.top + 8}, "Cone of the beam (50 % of the peak)", 13, black, Anchor::start, true});
  constexpr double table_height = 136, axis_height = 34, left = 34;
  double head = 10;
  for (const std::string& note : notes_on(report, cones))
    drawing.add(Label{{frame.left, frame.top + (head += 15)}, note, 12, grey});
  head += 20;
  Chart chart{
      {frame.left + left, frame.top + head, frame.width - left, frame.height - table_height - axis_height - head},
      0,
      0};
  chart.y_scale = chart.frame.height / metres;
  if (cones[0].known || cones[1].known) {
    double reach = 0;
    for (const Cone& cone : cones) reach = std::max(reach, metres * cone.reach());
    // Both axes alike where the beam fits, else the width shrinks: its axis says so.
    chart.x_scale = std::min(chart.y_scale, 0.5 * chart.frame.width / (1.02 * reach));
    draw_chart(drawing, chart, cones);
  } else {
    const Point middle{frame.left + 0.5 * frame.width, chart.frame.top + 0.5 * chart.frame.height};
    drawing.add(Label{middle, why_no_cone(report), 13, grey, Anchor::middle});
  }
  const double nadir_cd = intensities(profile, {{0, 0}})[0];
  draw_table(drawing, {frame.left, frame.top + frame.height - table_height + 8, frame.width, table_height}, cones,
             nadir_cd);
}

}  // namespace ups::tool
