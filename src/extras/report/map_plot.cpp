// See map_plot.h: from the bottom up colours, the room, isolines, luminaires, numbers.
#include "report/map_plot.h"

#include <algorithm>
#include <cmath>

#include "report/map_labels.h"
#include "report/page.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

constexpr double pixels_a_unit = 2, line_label_size = 8.5, number_size = 8, number_height = 10;
constexpr Ink strong{15, 15, 15}, furniture{60, 60, 60}, white{255, 255, 255};

bool is_inside(const std::vector<std::vector<Place>>& area, const Place& p) {
  bool inside = area.empty();
  for (const auto& outline : area) {
    for (size_t i = 0; i < outline.size(); ++i) {
      const Place a = outline[i], b = outline[(i + 1) % outline.size()];
      if ((a.y <= p.y) != (b.y <= p.y) && p.x < a.x + (b.x - a.x) * (p.y - a.y) / (b.y - a.y)) inside = !inside;
    }
  }
  return inside;
}

class Plot {
 public:
  Plot(Drawing& drawing, const MapView& view, const MapData& data, const MapField& field, const MapStyle& style,
       const MapRange& range)
      : drawing_(drawing), view_(view), data_(data), field_(field), style_(style), range_(range) {}

  void draw() {
    const Frame& f = view_.frame;
    drawing_.add(ClipBegin{{{{f.left, f.top},
                             {f.left + f.width, f.top},
                             {f.left + f.width, f.top + f.height},
                             {f.left, f.top + f.height}}}});
    draw_colours();
    if (style_.threshold > 0 && !data_.is_image) draw_hatching();
    for (const MapLine& line : data_.room)
      if (!line.cut) add_line(line.points, furniture, 0.6, 0.75);
    std::vector<Label> labels;
    const auto [least, most] = extremes();
    take_symbols();
    if (style_.numbers && !data_.is_image && least != most) {
      add_number(least, "min ", labels);
      add_number(most, "max ", labels);
    }
    draw_isolines(labels);
    for (const MapLine& line : data_.room)
      if (line.cut) add_line(line.points, strong, 1.6, 1);
    draw_luminaires();
    for (const MapLuminaire& l : data_.luminaires) occupy(ring_of(l));
    draw_observers(labels);
    if (style_.numbers && !data_.is_image && most != Lattice::none) add_numbers(least, most, labels);
    for (Label& label : labels) drawing_.add(std::move(label));
    drawing_.add(ClipEnd{});
    if (data_.is_image) draw_frame();
  }

 private:
  // ---- colours

  Ink ink_of_value(uint32_t value, const Place& p) const {
    const MapValue& v = data_.values[value];
    if (style_.threshold > 0) return ink_of(verdict_of(v, style_.threshold));
    double shown = v.value;
    if (const auto& lattice = field_.lattice(); lattice && !style_.cells) {
      const double x = (p.x - lattice->corner.x) / lattice->step_x, y = (p.y - lattice->corner.y) / lattice->step_y;
      shown = field_.between(x, y, int64_t(std::floor(x)), int64_t(std::floor(y)));
    }
    return colour_at(style_.colours, range_.share(shown));
  }

  void draw_colours() {
    const MapBox& box = field_.box();
    if (box.empty()) return;
    const Point corner = view_.at({box.left, box.high});
    // An image's own pixels where they are the coarser ones, and may run into one another as they are enlarged.
    const auto& lattice = field_.lattice();
    const bool crisp = style_.cells || style_.threshold > 0;
    const bool own =
        data_.is_image && !crisp && lattice && lattice->columns <= pixels_a_unit * box.width() * view_.scale;
    const auto side = [&](double length) {
      return uint32_t(std::max(1.0, std::ceil(length * view_.scale * pixels_a_unit - 1e-6)));
    };
    Picture picture{corner,
                    box.width() * view_.scale,
                    box.height() * view_.scale,
                    own ? lattice->columns : side(box.width()),
                    own ? lattice->rows : side(box.height()),
                    {},
                    crisp};
    picture.rgba.assign(4 * size_t(picture.columns) * picture.rows, 0);
    for (uint32_t row = 0; row < picture.rows; ++row) {
      for (uint32_t column = 0; column < picture.columns; ++column) {
        const Place p{box.left + box.width() * (column + 0.5) / picture.columns,
                      box.high - box.height() * (row + 0.5) / picture.rows};
        const uint32_t value = field_.nearest(p);
        if (value == Lattice::none || !is_inside(data_.area, p)) continue;
        const Ink ink = ink_of_value(value, p);
        uint8_t* to = &picture.rgba[4 * (size_t(row) * picture.columns + column)];
        std::copy(ink.begin(), ink.end(), to);
        to[3] = 255;
      }
    }
    drawing_.add(std::move(picture));
  }

  // Across the cells that are not sure: to be told from the others without colours too.
  void draw_hatching() {
    constexpr double distance = 5;
    ClipBegin clip;
    for (size_t i = 0; i < data_.values.size(); ++i)
      if (verdict_of(data_.values[i], style_.threshold) == Verdict::not_sure)
        clip.outlines.push_back(on_paper(field_.cell(i)));
    if (clip.outlines.empty()) return;
    drawing_.add(std::move(clip));
    // One line that turns back beyond the frame: Cairo writes a clip anew for every line.
    const Frame& f = view_.frame;
    const double top = f.top - distance, bottom = f.top + f.height + distance;
    Line hatches{{}, {150, 120, 20}, 0.7};
    bool up = true;
    for (double x = f.left - f.height; x < f.left + f.width; x += distance, up = !up) {
      const Point low{x - distance, bottom}, high{x + f.height + distance, top};
      hatches.points.insert(hatches.points.end(), {up ? low : high, up ? high : low});
    }
    drawing_.add(std::move(hatches));
    drawing_.add(ClipEnd{});
  }

  // ---- lines

  std::vector<Point> on_paper(const std::vector<Place>& places) const {
    std::vector<Point> points;
    for (const Place& p : places) points.push_back(view_.at(p));
    return points;
  }

  void add_line(const std::vector<Place>& places, const Ink& ink, double width, double opacity) {
    drawing_.add(Line{on_paper(places), ink, width, 0, opacity});
  }

  void draw_isolines(std::vector<Label>& labels) {
    std::vector<double> levels = style_.isolines && !(style_.threshold > 0) ? range_.levels : std::vector<double>{};
    if (style_.threshold > 0 && !data_.is_image) levels = {style_.threshold};
    std::vector<std::vector<Point>> drawn;
    const MapData calm = data_.is_image ? calmed(data_) : MapData{};
    const bool blurred = data_.is_image && (data_.of_camera || calm.columns < data_.columns);
    const double shortest = blurred ? 40 : 6;
    for (const Isoline& line : isolines_of(data_.is_image ? MapField(calm) : field_, levels)) {
      const std::vector<Point> points = on_paper(line.points);
      std::vector<double> along = {0};
      for (size_t i = 1; i < points.size(); ++i)
        along.push_back(along.back() + std::hypot(points[i].x - points[i - 1].x, points[i].y - points[i - 1].y));
      if (along.back() < shortest) continue;  // a speck of noise
      draw_labelled(line.level, points, along, labels);
      drawn.push_back(points);
    }
    for (const auto& points : drawn) occupy(points);
  }

  // With its value in gaps of the line, about one each 260 units.
  void draw_labelled(double level, const std::vector<Point>& points, const std::vector<double>& along,
                     std::vector<Label>& labels) {
    const std::string text = format("%.6g", level);
    const double half = 0.5 * width_of(text, line_label_size) + 2, length = along.back();
    std::vector<double> gaps;
    const int wanted = std::clamp(int(length / 260), 1, 4);
    for (int k = 0; length > 5 * half && k < wanted; ++k) {
      const double from = length * k / wanted, to = length * (k + 1) / wanted;
      if (const double at = best_place(points, along, from + half, to - half, half); at >= 0) {
        const double turn = turn_at(points, along, at, half);
        const Point p = point_at(points, along, at);
        if (!is_well_inside(p, half) || !taken_.take(p, 2 * half, line_label_size + 3, turn)) continue;
        const double down = 0.36 * line_label_size;  // from the middle of the letters to their baseline
        labels.push_back({{p.x - down * std::sin(turn), p.y + down * std::cos(turn)}, text, line_label_size, strong,
                          Anchor::middle, style_.threshold > 0, turn, 1.6});
        gaps.push_back(at);
      }
    }
    std::vector<Point> piece;
    const auto finish = [&] {
      if (piece.size() > 1) {
        drawing_.add(Line{piece, white, style_.threshold > 0 ? 3.0 : 2.2, 0, 0.45});
        drawing_.add(Line{piece, strong, style_.threshold > 0 ? 1.6 : 0.9, 0, 0.9});
      }
      piece.clear();
    };
    for (size_t i = 0; i < points.size(); ++i) {
      const auto is_in = [&](double gap) { return std::abs(along[i] - gap) < half; };
      if (std::none_of(gaps.begin(), gaps.end(), is_in)) {
        piece.push_back(points[i]);
      } else {
        finish();
      }
    }
    finish();
  }

  bool is_well_inside(const Point& p, double room) const {
    const Frame& f = view_.frame;
    return p.x > f.left + room && p.x < f.left + f.width - room && p.y > f.top + 7 && p.y < f.top + f.height - 7;
  }

  // ---- things

  static constexpr double arm = 4, eye = 4.5, look = 20;  // of a luminaire's cross, an observer's circle and arrow

  void take_symbols() {
    for (const MapLuminaire& l : data_.luminaires) taken_.take(view_.at(l.centre), 2 * arm, 2 * arm);
    for (const MapObserver& o : data_.observers) {
      const Point c = view_.at(o.at);
      const double turn = std::atan2(-o.looks_along.y, o.looks_along.x), middle = 0.5 * (look - eye);
      taken_.take({c.x + middle * std::cos(turn), c.y + middle * std::sin(turn)}, look + eye, 2 * eye, turn);
    }
  }

  void occupy(const std::vector<Point>& line) {
    const Frame& f = view_.frame;
    taken_.occupy(line, {f.left, f.top}, {f.left + f.width, f.top + f.height});
  }

  std::vector<Point> ring_of(const MapLuminaire& l) const {
    std::vector<Point> ring = on_paper(l.outline);
    if (!ring.empty()) ring.push_back(ring.front());
    return ring;
  }

  void draw_luminaires() {
    for (const MapLuminaire& l : data_.luminaires) {
      std::vector<std::vector<Point>> strokes;
      if (!l.outline.empty()) strokes.push_back(ring_of(l));
      const Point c = view_.at(l.centre);
      strokes.push_back({{c.x - arm, c.y - arm}, {c.x + arm, c.y + arm}});
      strokes.push_back({{c.x - arm, c.y + arm}, {c.x + arm, c.y - arm}});
      if (l.outline.size() < 2 || extent_on_paper(l.outline) < 2 * arm) strokes.push_back(circle(c, arm * 1.45));
      for (const auto& stroke : strokes) drawing_.add(Line{stroke, white, 2.8, 0, 0.85});
      for (const auto& stroke : strokes) drawing_.add(Line{stroke, strong, 1});
    }
  }

  double extent_on_paper(const std::vector<Place>& outline) const {
    MapBox box;
    for (const Place& p : outline) box.grow(p);
    return std::max(box.width(), box.height()) * view_.scale;
  }

  static std::vector<Point> circle(const Point& c, double radius) {
    std::vector<Point> points;
    constexpr int corners = 24;
    for (int k = 0; k <= corners; ++k) {
      const double angle = 4 * std::acos(0.0) * k / corners;
      points.push_back({c.x + radius * std::cos(angle), c.y + radius * std::sin(angle)});
    }
    return points;
  }

  void draw_observers(std::vector<Label>& labels) {
    for (const MapObserver& o : data_.observers) {
      const Point c = view_.at(o.at);
      const double length = std::hypot(o.looks_along.x, o.looks_along.y);
      drawing_.add(Area{circle(c, eye), white});
      drawing_.add(Line{circle(c, eye), strong, 1.2});
      if (length > 0) {
        const double x = o.looks_along.x / length, y = -o.looks_along.y / length;
        const double head = look - 7;
        drawing_.add(Line{{{c.x + eye * x, c.y + eye * y}, {c.x + head * x, c.y + head * y}}, strong, 1.2});
        drawing_.add(Area{{{c.x + look * x, c.y + look * y},
                           {c.x + head * x - 3.5 * y, c.y + head * y + 3.5 * x},
                           {c.x + head * x + 3.5 * y, c.y + head * y - 3.5 * x}},
                          strong});
      }
      const double width = width_of(o.name, number_size, true), aside = 0.5 * width + 8;
      const Point places[] = {{c.x, c.y + 12}, {c.x + aside, c.y}, {c.x - aside, c.y}, {c.x, c.y - 12}};
      for (const Point& p : places) {
        if (o.name.empty() || !taken_.take(p, width, number_height)) continue;
        labels.push_back({{p.x, p.y + 0.36 * number_size}, o.name, number_size, strong, Anchor::middle, true, 0, 1.6});
        break;
      }
    }
  }

  // ---- numbers

  std::pair<uint32_t, uint32_t> extremes() const {
    uint32_t least = Lattice::none, most = Lattice::none;
    for (size_t i = 0; i < data_.values.size(); ++i) {
      if (!is_known(data_.values[i])) continue;
      if (least == Lattice::none || data_.values[i].value < data_.values[least].value) least = uint32_t(i);
      if (most == Lattice::none || data_.values[i].value > data_.values[most].value) most = uint32_t(i);
    }
    return {least, most};
  }

  // As many as have room; the rest are dots.
  void add_numbers(uint32_t least, uint32_t most, std::vector<Label>& labels) {
    const double widest = width_of(value_text(data_.values[most].value, data_.values[most].value), number_size) + 5;
    const auto& lattice = field_.lattice();
    const auto stride = [&](double room, double step) {
      return int64_t(std::max(1.0, std::ceil(room / (step * view_.scale))));
    };
    const int64_t every_column = lattice ? stride(widest, lattice->step_x) : 1;
    const int64_t every_row = lattice ? stride(number_height + 2, lattice->step_y) : 1;
    const bool dotted = lattice && std::min(lattice->step_x, lattice->step_y) * view_.scale >= 4;
    for (size_t i = 0; i < data_.values.size(); ++i) {
      const MapValue& v = data_.values[i];
      if (!is_known(v) || (least != most && (i == least || i == most))) continue;
      bool in_turn = true;
      if (lattice) {
        const auto column = int64_t((v.at.x - lattice->corner.x) / lattice->step_x);
        const auto row = int64_t((v.at.y - lattice->corner.y) / lattice->step_y);
        in_turn = column % every_column == every_column / 2 && row % every_row == every_row / 2;
      }
      if (in_turn && add_number(uint32_t(i), "", labels)) continue;
      if (dotted || !lattice) drawing_.add(Area{circle(view_.at(v.at), 0.7), strong, 0.6});
    }
  }

  bool add_number(uint32_t value, const std::string& before, std::vector<Label>& labels) {
    const Point p = view_.at(data_.values[value].at);
    const double v = data_.values[value].value;
    std::string text = value_text(v, range_.most);  // of the side of the threshold that its colour is of
    if (style_.threshold > 0) text = beside(v, style_.threshold, text);
    text = before + text;
    const bool bold = !before.empty();
    const double width = width_of(text, number_size, bold) + 3;
    // What is named may stand beside its place, and moves inwards at the border.
    const double left = view_.at({field_.box().left, 0}).x + 0.5 * width + 1;
    const double right = view_.at({field_.box().right, 0}).x - 0.5 * width - 1;
    const double x = bold && left < right ? std::clamp(p.x, left, right) : p.x;
    for (const double beside : {0.0, 12.0, -12.0, 20.0, -20.0}) {
      if (beside != 0 && !bold) return false;
      if (!taken_.take({x, p.y + beside}, width, number_height)) continue;
      const Point at{x, p.y + beside + 0.36 * number_size};
      labels.push_back({at, text, number_size, bold ? strong : ink_on(value), Anchor::middle, bold, 0, bold ? 1.4 : 0});
      return true;
    }
    return false;
  }

  // That is read on the value's own colour.
  Ink ink_on(uint32_t value) const {
    const Ink under = ink_of_value(value, data_.values[value].at);
    return 0.3 * under[0] + 0.59 * under[1] + 0.11 * under[2] > 115 ? strong : white;
  }

  void draw_frame() {
    const Frame& f = view_.frame;
    drawing_.add(Line{{{f.left, f.top},
                       {f.left + f.width, f.top},
                       {f.left + f.width, f.top + f.height},
                       {f.left, f.top + f.height},
                       {f.left, f.top}},
                      grey,
                      0.8});
  }

  Drawing& drawing_;
  const MapView& view_;
  const MapData& data_;
  const MapField& field_;
  const MapStyle& style_;
  const MapRange& range_;
  TakenPlaces taken_;
};

}  // namespace

MapBox extent_of(const MapData& data, const MapField& field) {
  MapBox box = field.box();
  if (box.empty()) box.grow({0, 0}), box.grow({1, 1});
  if (data.is_image) return box;
  const double side = std::max(box.width(), box.height()), reach = std::max(0.25 * side, 0.3);
  const MapBox cells = box;
  for (const MapLine& line : data.room) {
    for (const Place& p : line.points) {
      if (line.cut && p.x > cells.left - reach && p.x < cells.right + reach && p.y > cells.low - reach &&
          p.y < cells.high + reach)
        box.grow(p);
    }
  }
  const double rim = 0.02 * std::max(box.width(), box.height());
  return {box.left - rim, box.low - rim, box.right + rim, box.high + rim};
}

void draw_plot(Drawing& drawing, const MapView& view, const MapData& data, const MapField& field,
               const MapStyle& style, const MapRange& range) {
  Plot(drawing, view, data, field, style, range).draw();
}

std::string value_text(double value, double largest) {
  const int decimals = largest > 0 ? std::clamp(2 - int(std::floor(std::log10(largest) + 1e-9)), 0, 6) : 0;
  return format("%.*f", decimals, value);
}

}  // namespace ups::report
