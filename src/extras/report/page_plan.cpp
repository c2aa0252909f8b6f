// See page.h: the scene in plan and in section, to scale: where a plane cuts its surfaces, with the luminaires, meters
// and cameras projected onto it.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "report/meter_places.h"
#include "report/page.h"
#include "report/profile_plot.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

constexpr double width = 680, margin = 26, most_height = 620, foot = 40;
constexpr size_t most_dots = 900, most_places = 200000;  // of a set; of a lightmap the outline alone would cost much
constexpr Ink lamp_ink{214, 130, 0}, meter_ink{0, 92, 175}, observer_ink{110, 40, 140}, seen_ink{125, 131, 140};

using Polyline = std::vector<Point>;

struct Axes {
  int across, up;  // coordinates
  Point flat(const double* p) const { return {p[across], p[up]}; }
};

std::vector<ups_segment> cut(const ups_scene* scene, int axis, double at) {
  double point[3] = {0, 0, 0}, normal[3] = {0, 0, 0};
  point[axis] = at, normal[axis] = 1;
  return read_array<ups_segment>([&](ups_segment* to, size_t capacity, size_t* needed) {
    return ups_scene_read_section(scene, point, normal, to, capacity, needed);
  });
}

// Segments that touch, joined to lines, and without what is too small to see: a mesh of a million triangles stays a
// drawing of a few thousand points.
class Chains {
 public:
  Chains(const std::vector<ups_segment>& segments, const Axes& axes, double step) : step_(step) {
    std::map<Key, std::vector<size_t>> ends;
    std::vector<std::array<Point, 2>> all;
    for (const ups_segment& s : segments) {
      const Point a = axes.flat(s.from_m), b = axes.flat(s.to_m);
      if (key(a) == key(b)) continue;
      ends[key(a)].push_back(all.size());
      ends[key(b)].push_back(all.size());
      all.push_back({a, b});
    }
    std::vector<char> used(all.size(), 0);
    for (size_t i = 0; i < all.size(); ++i) {
      if (used[i]) continue;
      used[i] = 1;
      Polyline line = {all[i][0], all[i][1]};
      for (const bool front : {false, true}) {
        if (front) std::reverse(line.begin(), line.end());
        for (bool grown = true; grown;) {
          grown = false;
          for (const size_t k : ends[key(line.back())]) {
            if (used[k]) continue;
            used[k] = 1, grown = true;
            line.push_back(key(all[k][0]) == key(line.back()) ? all[k][1] : all[k][0]);
            break;
          }
        }
      }
      lines.push_back(straightened(line));
    }
  }
  std::vector<Polyline> lines;

 private:
  using Key = std::pair<long long, long long>;
  Key key(const Point& p) const { return {std::llround(p.x / step_), std::llround(p.y / step_)}; }

  Polyline straightened(const Polyline& line) const {
    Polyline kept = {line[0]};
    for (size_t i = 1; i + 1 < line.size(); ++i) {
      const Point &a = kept.back(), &p = line[i], &b = line[i + 1];
      const double length = std::hypot(b.x - a.x, b.y - a.y);
      if (length <= step_) {  // there and back, as where the edges of a thing lie one above the other
        if (std::hypot(p.x - a.x, p.y - a.y) > step_) kept.push_back(p);
        continue;
      }
      const double off = std::abs((p.x - a.x) * (b.y - a.y) - (p.y - a.y) * (b.x - a.x)) / length;
      const double along = (p.x - a.x) * (b.x - a.x) + (p.y - a.y) * (b.y - a.y);
      if (off > 0.3 * step_ || along < 0 || along > length * length) kept.push_back(p);
    }
    kept.push_back(line.back());
    return kept;
  }
  double step_;
};

struct Bounds {
  double low[3], high[3];
  double size(int k) const { return high[k] - low[k]; }
};

// Of the geometry, and of all luminaires and meters that have a place: a scene may have no surfaces.
Bounds bounds_of(const PageInput& in, const std::vector<LuminaireType>& types) {
  const ups_scene_info info = info_of(in.scene);
  const bool has_surfaces = info.bounds_min_m[0] <= info.bounds_max_m[0];
  Bounds b;
  for (int k = 0; k < 3; ++k) b.low[k] = INFINITY, b.high[k] = -INFINITY;
  const auto grow = [&](const double* p) {
    if (!std::isfinite(p[0] + p[1] + p[2])) return;
    for (int k = 0; k < 3; ++k) b.low[k] = std::min(b.low[k], p[k]), b.high[k] = std::max(b.high[k], p[k]);
  };
  for (const LuminaireType& type : types)
    for (const PlacedSource& s : type.sources)
      if (s.info.light_kind != UPS_LIGHT_DIRECTIONAL) grow(s.info.bounds_min_m), grow(s.info.bounds_max_m);
  for (const SensorEntry& sensor : in.scene.sensors) {
    if (sensor.info.kind != SensorKind::meters || sensor.info.meter_count > most_places) continue;
    const MeterPlaces places = meter_places(in.scene, sensor);
    for (const size_t m : places.listed)
      if (places.has_place(m)) grow(&places.positions[3 * m]);
  }
  if (has_surfaces) grow(info.bounds_min_m), grow(info.bounds_max_m);
  return b;
}

class View {
 public:
  View(const PageInput& in, const std::vector<LuminaireType>& types, const Axes& axes, double most_view_height)
      : in_(in), types_(types), axes_(axes), bounds_(bounds_of(in, types)) {
    const double w = std::max(bounds_.size(axes.across), 1e-6), h = std::max(bounds_.size(axes.up), 1e-6);
    scale_ = std::min((width - 2 * margin) / w, most_view_height / h);
    left_ = 0.5 * (width - w * scale_);
    drawing_ = {width, h * scale_ + 2 * margin + foot, {}};
  }

  const Bounds& bounds() const { return bounds_; }

  void surfaces(int axis, double at, const Ink& ink, double line_width) {
    draw(cut(in_.scene.scene, axis, at), ink, line_width);
  }

  void draw(const std::vector<ups_segment>& segments, const Ink& ink, double line_width) {
    const Chains chains(segments, axes_, 0.4 / scale_);
    for (const Polyline& line : chains.lines) {
      Line drawn{{}, ink, line_width};
      for (const Point& p : line) drawn.points.push_back(place(p));
      drawing_.add(drawn);
    }
  }

  // What lies below a height, as it is seen from there.
  void outlines_below(double height) {
    const double point[3] = {0, 0, height}, up[3] = {0, 0, 1};
    draw(read_array<ups_segment>([&](ups_segment* to, size_t capacity, size_t* needed) {
           return ups_scene_read_outlines(in_.scene.scene, point, up, INFINITY, to, capacity, needed);
         }),
         seen_ink, 0.7);
  }

  void meters() {
    for (const SensorEntry& sensor : in_.scene.sensors) {
      if (sensor.info.kind != SensorKind::meters || sensor.info.meter_count > most_places) continue;
      const MeterPlaces places = meter_places(in_.scene, sensor);
      Point low{INFINITY, INFINITY}, high{-INFINITY, -INFINITY};
      for (const size_t m : places.listed) {
        if (!places.has_place(m)) continue;
        const Point p = place(axes_.flat(&places.positions[3 * m]));
        low = {std::min(low.x, p.x), std::min(low.y, p.y)}, high = {std::max(high.x, p.x), std::max(high.y, p.y)};
        if (places.listed.size() <= most_dots) dot(p, 1.3, meter_ink);
      }
      if (!(low.x <= high.x)) continue;
      constexpr double rim = 4;
      drawing_.add(Line{{{low.x - rim, low.y - rim}, {high.x + rim, low.y - rim},
                                     {high.x + rim, high.y + rim}, {low.x - rim, high.y + rim},
                                     {low.x - rim, low.y - rim}},
                                    meter_ink, 0.9, 4});
      name({low.x - rim + 2, low.y - rim - 3}, sensor.name, meter_ink);
    }
  }

  void luminaires(bool numbered) {
    for (size_t t = 0; t < types_.size(); ++t) {
      for (const PlacedSource& source : types_[t].sources) {
        if (source.info.light_kind == UPS_LIGHT_DIRECTIONAL) continue;
        Point a = place(axes_.flat(source.info.bounds_min_m)), b = place(axes_.flat(source.info.bounds_max_m));
        constexpr double least = 3.5;  // half of what can be seen
        const Point c{0.5 * (a.x + b.x), 0.5 * (a.y + b.y)};
        const double half_x = std::max(0.5 * std::abs(b.x - a.x), least),
                     half_y = std::max(0.5 * std::abs(b.y - a.y), least);
        a = {c.x - half_x, c.y - half_y}, b = {c.x + half_x, c.y + half_y};
        const Polyline box = {a, {b.x, a.y}, b, {a.x, b.y}, a};
        drawing_.add(Area{box, {255, 214, 102}, 0.85});
        drawing_.add(Line{box, lamp_ink, 1});
        if (numbered && types_.size() > 1) name({b.x + 3, a.y + 4}, std::to_string(t + 1), lamp_ink);
      }
    }
  }

  // An eye, with a stroke along its line of sight.
  void observers() {
    for (const SensorEntry& sensor : in_.scene.sensors) {
      if (sensor.info.kind != SensorKind::observer) continue;
      const Eye eye = eye_of(in_.scene, sensor);
      const Point at = place(axes_.flat(eye.at_m));
      const double x = eye.along[axes_.across], y = -eye.along[axes_.up];
      constexpr double stroke = 18;
      drawing_.add(Line{{at, {at.x + stroke * x, at.y + stroke * y}}, observer_ink, 1.6});
      dot(at, 3.6, observer_ink);
      name({at.x + 6, at.y + 4}, sensor.name, observer_ink);
    }
  }

  // The line along which the section is cut.
  void section_line(double at) {
    const double y = place({0, at}).y;
    drawing_.add(Line{{{8, y}, {width - 8, y}}, grey, 0.8, 9});
    for (const double x : {4.0, width - 12})
      drawing_.add(Label{{x, y - 5}, "A", 12, black, Anchor::start, true});
  }

  Drawing finish(const std::string& text) {
    for (const Label& label : names_) drawing_.add(label);
    const double metre = round_step(60 / scale_), y = drawing_.height - 14;
    drawing_.add(Line{{{margin, y}, {margin + metre * scale_, y}}, black, 2});
    drawing_.add(Label{{margin + metre * scale_ + 6, y + 4}, format("%g m", metre), 12, black});
    drawing_.add(Label{{width - margin, y + 4}, text, 12, grey, Anchor::end});
    return std::move(drawing_);
  }

 private:
  Point place(const Point& p) const {
    return {left_ + (p.x - bounds_.low[axes_.across]) * scale_,
            margin + (bounds_.high[axes_.up] - p.y) * scale_};
  }
  void dot(const Point& p, double radius, const Ink& ink) {
    Area area{{}, ink};
    for (int k = 0; k < 8; ++k)
      area.points.push_back({p.x + radius * std::cos(0.785398 * k), p.y + radius * std::sin(0.785398 * k)});
    drawing_.add(area);
  }
  // Where no other is; else a line lower, a few times.
  void name(Point at, const std::string& text, const Ink& ink) {
    constexpr double size = 11.5;
    const double w = width_of(text, size, true);
    at.x = std::clamp(at.x, 2.0, std::max(2.0, width - w - 2));
    at.y = std::max(at.y, size);
    const auto overlaps = [&](const Label& other) {
      return at.x < other.at.x + width_of(other.text, size, true) + 2 && other.at.x < at.x + w + 2 &&
             std::abs(at.y - other.at.y) < size;
    };
    for (int tries = 0; tries < 4 && std::any_of(names_.begin(), names_.end(), overlaps); ++tries) at.y -= size + 1;
    if (std::any_of(names_.begin(), names_.end(), overlaps)) return;
    names_.push_back(Label{at, text, size, ink, Anchor::start, true, 0, 2.5});
  }

  const PageInput& in_;
  const std::vector<LuminaireType>& types_;
  Axes axes_;
  Bounds bounds_;
  double scale_, left_;
  Drawing drawing_;
  std::vector<Label> names_;
};

// A little below half the height, where plans are cut: above desks, through doors and windows.
double plan_height(const Bounds& b) { return b.low[2] + 0.43 * b.size(2); }

}  // namespace

bool has_plan(const PageInput& in, const std::vector<LuminaireType>& types) {
  const Bounds b = bounds_of(in, types);
  return b.low[0] <= b.high[0];
}

Drawing plan_drawing(const PageInput& in, const std::vector<LuminaireType>& types) {
  View view(in, types, {0, 1}, most_height);
  const Bounds& b = view.bounds();
  view.outlines_below(plan_height(b));
  view.surfaces(2, plan_height(b), black, 1.8);
  view.section_line(0.5 * (b.low[1] + b.high[1]));
  view.meters();
  view.luminaires(true);
  view.observers();
  return view.finish(format("Plan, cut at z = %.2f m; +X to the right, +Y up", plan_height(b)));
}

Drawing section_drawing(const PageInput& in, const std::vector<LuminaireType>& types) {
  View view(in, types, {0, 2}, 0.6 * most_height);
  const Bounds& b = view.bounds();
  const double at = 0.5 * (b.low[1] + b.high[1]);
  view.surfaces(1, at, black, 1.8);
  view.meters();
  view.luminaires(false);
  view.observers();
  return view.finish(format("Section A-A, cut at y = %.2f m, seen towards +Y", at));
}

}  // namespace ups::report
