// The polar diagram: nadir at the bottom, C0 (C90) on the right, rings of equal intensity, spokes of equal gamma.
#include <algorithm>
#include <cmath>

#include "report/profile_plot.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

constexpr double step_deg = 0.1;
constexpr double faint = 0.005;  // of the peak: less above the horizon does not ask for a full circle

struct Sample {
  double angle_deg, value;  // gamma, negative on the far half plane
};
using Curve = std::vector<Sample>;

// Of the plane C / C + 180: fine steps, and where a narrow lobe has its peak and edges.
Curve curve_of(const ups_profile* profile, const ProfileReport& report, const PlaneReport& plane) {
  std::vector<double> angles;
  for (int i = -1800; i <= 1800; ++i) angles.push_back(step_deg * i);
  for (const ups_profile_beam* beam : {&plane.beam, &plane.field})
    for (double a : {beam->peak_deg, beam->from_deg, beam->to_deg}) angles.push_back(std::remainder(a, 360));
  std::sort(angles.begin(), angles.end());
  const std::vector<float> values = intensities_in_plane(profile, plane.c_deg, angles);
  const double scale = is_per_kilolumen(report) ? 1000 / report.info.rated_flux_lm : 1;
  Curve curve;
  for (size_t i = 0; i < angles.size(); ++i) curve.push_back({angles[i], scale * values[i]});
  return curve;
}

struct Axes {
  Point centre;
  double radius, step;  // of the outermost ring; intensity from ring to ring
  int rings;
  bool full;

  Point at(double angle_deg, double value) const {
    const double r = radius * value / (rings * step);
    return {centre.x + r * std::sin(angle_deg * radian), centre.y + r * std::cos(angle_deg * radian)};
  }
};

// Without the points that a straight line through their neighbours passes closely by.
std::vector<Point> thinned(const std::vector<Point>& points) {
  constexpr double closely = 0.02;
  std::vector<Point> kept;
  size_t start = 0;
  for (size_t i = 0; i < points.size(); ++i) {
    bool straight = i > 0 && i + 1 < points.size() && i - start < 40;
    for (size_t k = start + 1; straight && k <= i; ++k) {
      const Point a = points[start], b = points[i + 1], p = points[k];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      const double off = length > 0 ? std::abs((p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x)) / length
                                    : std::hypot(p.x - a.x, p.y - a.y);
      const double along = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
      straight = off < closely && along >= 0 && along <= length * length;
    }
    if (straight) continue;
    kept.push_back(points[i]);
    start = i;
  }
  return kept;
}

void draw_grid(Drawing& drawing, const Axes& axes) {
  const double end = axes.full ? 180 : 90, outermost = axes.rings * axes.step;
  for (int ring = 1; ring <= axes.rings; ++ring) {
    std::vector<Point> points;
    for (double a = -end; a <= end; a += 2) points.push_back(axes.at(a, ring * axes.step));
    drawing.add(Line{points, pale, ring == axes.rings ? 1.2 : 0.8});
  }
  for (double a = -end; a <= end; a += 15) {
    const bool labelled = std::remainder(a, 30) == 0;
    if (a == -180) continue;
    drawing.add(Line{{axes.centre, axes.at(a, outermost)}, pale, labelled ? 0.9 : 0.5});
    if (!labelled) continue;
    Point p = axes.at(a, outermost * (1 + 15 / axes.radius));
    p.y += 4.5;
    const Anchor anchor = std::abs(std::sin(a * radian)) < 0.1 ? Anchor::middle : a > 0 ? Anchor::start : Anchor::end;
    p.x += anchor == Anchor::start ? -5 : anchor == Anchor::end ? 5 : 0;
    drawing.add(Label{p, format("%g\u00b0", std::abs(a)), 12, grey, anchor});
  }
}

// Where a curve runs, close enough that no label between two of them is missed.
std::vector<Point> places_of(const std::vector<std::vector<Point>>& lines) {
  constexpr double spacing = 2;
  std::vector<Point> places;
  for (const auto& line : lines) {
    for (size_t i = 0; i + 1 < line.size(); ++i) {
      const Point a = line[i], b = line[i + 1];
      const int pieces = 1 + int(std::hypot(b.x - a.x, b.y - a.y) / spacing);
      for (int k = 0; k < pieces; ++k)
        places.push_back({a.x + (b.x - a.x) * k / pieces, a.y + (b.y - a.y) * k / pieces});
    }
  }
  return places;
}

constexpr double ring_label_size = 11, ring_label_up = 7, ring_label_down = 6;

// How far the nearest curve is beyond the label's edge, the larger of both axes; < 0: it runs through the label.
double room_around(Point p, double half_width, const std::vector<Point>& places) {
  double room = INFINITY;
  for (const Point& q : places) {
    const double above = p.y - ring_label_up - q.y, below = q.y - p.y - ring_label_down;
    room = std::min(room, std::max({std::abs(q.x - p.x) - half_width, above, below}));
  }
  return room;
}

// Along the spoke where most of them are clear of the curves, on the side with most room; a label that is not clear
// there stands elsewhere on its ring or, where a curve follows the ring, beside it.
void draw_ring_labels(Drawing& drawing, const Axes& axes, const std::vector<std::vector<Point>>& lines) {
  const std::vector<Point> places = places_of(lines);
  const Prefix prefix = prefix_of(axes.rings * axes.step);
  std::vector<double> spokes;
  for (double a = axes.full ? -165 : -75; a <= (axes.full ? 165 : 75); a += 30) spokes.push_back(a);
  const auto text = [&](int ring) { return format("%g", ring * axes.step / prefix.factor); };
  const auto half = [&](int ring) { return 0.5 * width_of(text(ring), ring_label_size) + 2; };
  const auto at = [&](double spoke, int ring, double beside) {
    return axes.at(spoke, ring * axes.step * (1 + beside * axes.rings / (ring * axes.radius)));
  };
  const auto room = [&](double spoke, int ring, double beside) {
    return room_around(at(spoke, ring, beside), half(ring), places);
  };
  double best = spokes.front(), most = -INFINITY;
  for (const double spoke : spokes) {
    double score = 0;
    for (int ring = 1; ring <= axes.rings; ++ring) {
      const double r = room(spoke, ring, 0);
      score += r > 0 ? 100 + std::min(r, 20.0) : 0;
    }
    if (score > most + 1e-6) best = spoke, most = score;
  }
  for (int ring = 1; ring <= axes.rings; ++ring) {
    Point p = at(best, ring, 0);
    double free = room(best, ring, 0);
    for (const double beside : {0.0, 13.0, -13.0}) {
      for (size_t i = 0; free <= 0 && i < spokes.size(); ++i) {
        free = room(spokes[i], ring, beside);
        p = at(spokes[i], ring, beside);
      }
    }
    if (free <= 0) continue;
    const double h = half(ring), top = p.y - ring_label_up, bottom = p.y + ring_label_down;
    drawing.add(
        Area{{{p.x - h, top}, {p.x + h, top}, {p.x + h, bottom}, {p.x - h, bottom}}, {255, 255, 255}});
    drawing.add(Label{{p.x, p.y + 4}, text(ring), ring_label_size, grey, Anchor::middle});
  }
}

}  // namespace

bool shines_up(const ups_profile* profile, const ProfileReport& report) {
  std::vector<double> angles;
  for (int angle = 91; angle <= 269; ++angle) angles.push_back(angle);
  for (const PlaneReport& plane : drawn_planes(report)) {
    const std::vector<float> values = intensities_in_plane(profile, plane.c_deg, angles);
    if (*std::max_element(values.begin(), values.end()) > faint * report.info.peak_cd) return true;
  }
  return false;
}

void draw_polar(Drawing& drawing, const Frame& frame, const ups_profile* profile, const ProfileReport& report) {
  std::vector<Curve> curves;
  for (const PlaneReport& plane : drawn_planes(report)) curves.push_back(curve_of(profile, report, plane));
  double largest = 0;
  for (const auto& curve : curves)
    for (const Sample& s : curve) largest = std::max(largest, s.value);

  constexpr double label_room = 34;
  Axes axes{};
  axes.full = shines_up(profile, report);
  axes.step = round_step(largest / 5);
  axes.rings = std::max(1, int(std::ceil(largest / axes.step - 1e-9)));
  axes.radius = 0.5 * frame.width - label_room;
  if (axes.full) axes.radius = std::min(axes.radius, 0.5 * frame.height - label_room + 6);
  axes.centre = {frame.left + 0.5 * frame.width, axes.full ? frame.top + 0.5 * frame.height : frame.top + 56};

  draw_grid(drawing, axes);
  std::vector<std::vector<Point>> lines;
  for (const Curve& curve : curves) {
    lines.emplace_back();
    for (const Sample& s : curve)
      if (std::abs(s.angle_deg) <= (axes.full ? 180 : 90)) lines.back().push_back(axes.at(s.angle_deg, s.value));
  }
  if (largest > 0) {
    draw_ring_labels(drawing, axes, lines);
  } else {
    drawing.add(Label{axes.at(0, 0.5), "no light", 13, grey, Anchor::middle});
  }
  for (size_t i = 0; i < lines.size(); ++i)
    drawing.add(Line{thinned(lines[i]), plane_ink[i], 2.2, plane_dash[i]});
  const std::string unit =
      std::string(prefix_of(axes.rings * axes.step).sign) + (is_per_kilolumen(report) ? "cd/klm" : "cd");
  drawing.add(
      Label{{frame.left, frame.top + 8}, "Luminous intensity, " + unit, 13, black, Anchor::start, true});
}

}  // namespace ups::report
