// See map.h: the page of a map: its heading, the plot, the scale or the verdicts, a bar of metres and north.
#include "report/map.h"

#include <algorithm>
#include <cmath>

#include "report/map_plot.h"
#include "report/text_format.h"

namespace ups::report {
namespace {

constexpr double margin = 14, heading = 46, side = 92, foot = 26, text_size = 9;
constexpr Verdict verdicts[] = {Verdict::met, Verdict::not_sure, Verdict::not_met, Verdict::unknown};

const char* word_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::met:
      return "met";
    case Verdict::not_met:
      return "not met";
    case Verdict::not_sure:
      return "not sure";
    default:
      return "not known";
  }
}

size_t count_of(const MapData& data, double threshold, Verdict verdict) {
  return size_t(std::count_if(data.values.begin(), data.values.end(),
                              [&](const MapValue& v) { return verdict_of(v, threshold) == verdict; }));
}

// Not all of them is never 100 %, nor are some of them 0.
std::string share_text(size_t count, size_t of) {
  const double share = 100.0 * double(count) / double(of);
  std::string text = format("%.3g", share);
  for (int digits = 4; count < of && text == "100" && digits < 12; ++digits) text = format("%.*g", digits, share);
  return text + " %";
}

std::string heading_of(const MapData& data) {
  return data.quantity + (data.unit.empty() ? "" : ", " + data.unit) + (data.title.empty() ? "" : ": " + data.title);
}

void draw_box(Drawing& drawing, const Frame& f) {
  drawing.add(Line{{{f.left, f.top}, {f.left + f.width, f.top}, {f.left + f.width, f.top + f.height},
                    {f.left, f.top + f.height}, {f.left, f.top}},
                   grey,
                   0.7});
}

void draw_scale(Drawing& drawing, const Frame& f, const MapData& data, const MapStyle& style, const MapRange& range) {
  Picture picture{{f.left, f.top}, f.width, f.height, 1, 256, {}};
  for (int row = 0; row < 256; ++row) {
    const Ink ink = colour_at(style.colours, 1 - (row + 0.5) / 256);
    picture.rgba.insert(picture.rgba.end(), {ink[0], ink[1], ink[2], 255});
  }
  drawing.add(std::move(picture));
  draw_box(drawing, f);
  std::vector<double> marks = {range.low, range.high};  // first: no level takes the place of an end
  marks.insert(marks.end(), range.levels.begin(), range.levels.end());
  std::vector<double> taken;
  for (const double mark : marks) {
    const double y = f.top + f.height * (1 - range.share(mark));
    const auto is_near = [&](double other) { return std::abs(y - other) < text_size + 1; };
    if (std::any_of(taken.begin(), taken.end(), is_near)) continue;
    taken.push_back(y);
    const bool beyond_high = mark >= range.high && range.most > range.high * (1 + 1e-9);
    const bool beyond_low = mark <= range.low && range.least >= 0 && range.least < range.low * (1 - 1e-9);
    const std::string text = (beyond_high ? "\u2265 " : beyond_low ? "\u2264 " : "") + format("%.6g", mark);
    drawing.add(Line{{{f.left + f.width, y}, {f.left + f.width + 4, y}}, grey, 0.8});
    drawing.add(Label{{f.left + f.width + 7, y + 0.36 * text_size}, text, text_size, black});
  }
  drawing.add(Label{{f.left, f.top - 10}, data.unit + (range.scale == MapScale::logarithmic ? ", log scale" : ""),
                    text_size, black, Anchor::start, true});
}

void draw_verdicts(Drawing& drawing, double left, double top, const MapData& data, const MapStyle& style) {
  drawing.add(Label{{left, top - 8}, format("\u2265 %g ", style.threshold) + data.unit, text_size, black, Anchor::start,
                    true});
  double y = top + 4;
  for (const Verdict verdict : verdicts) {
    const size_t count = count_of(data, style.threshold, verdict);
    if (count == 0 && verdict == Verdict::unknown) continue;
    const Frame box{left, y, 14, 14};
    const std::vector<Point> corners = {{left, y}, {left + 14, y}, {left + 14, y + 14}, {left, y + 14}};
    drawing.add(Area{corners, ink_of(verdict)});
    if (verdict == Verdict::not_sure && !data.is_image) {
      drawing.add(ClipBegin{{corners}});
      for (double x = left - 10; x < left + 14; x += 5)
        drawing.add(Line{{{x, y + 14}, {x + 14, y}}, {150, 120, 20}, 0.7});
      drawing.add(ClipEnd{});
    }
    draw_box(drawing, box);
    drawing.add(Label{{left + 19, y + 7}, word_of(verdict), text_size, black});
    drawing.add(Label{{left + 19, y + 17}, share_text(count, data.values.size()), text_size, grey});
    y += 28;
  }
  drawing.add(Label{{left, y + 8}, "not sure: the", 7.5, grey});
  drawing.add(Label{{left, y + 17}, "95 % bound", 7.5, grey});
  drawing.add(Label{{left, y + 26}, "crosses it", 7.5, grey});
}

void draw_north(Drawing& drawing, const Point& centre, const MapData& data) {
  const double length = std::hypot(data.north_x, data.north_y);
  if (!(length > 0)) return;
  const double x = data.north_x / length, y = -data.north_y / length, r = 14;
  const Point tip{centre.x + r * x, centre.y + r * y}, tail{centre.x - r * x, centre.y - r * y};
  drawing.add(Area{{tip, {tail.x - 6 * y, tail.y + 6 * x}, {centre.x - 0.6 * r * x, centre.y - 0.6 * r * y}}, black});
  drawing.add(Line{{tip, {tail.x - 6 * y, tail.y + 6 * x}, {centre.x - 0.6 * r * x, centre.y - 0.6 * r * y},
                    {tail.x + 6 * y, tail.y - 6 * x}, tip},
                   black,
                   0.9});
  const Point name{tip.x + 8 * x, tip.y + 8 * y + 0.36 * text_size};
  drawing.add(Label{name, data.north, text_size, black, Anchor::middle, true});
}

// To where it ends.
double draw_metres(Drawing& drawing, const Point& at, double scale) {
  const double metres = round_step(50 / scale), length = metres * scale;
  constexpr int parts = 2;
  for (int i = 0; i < parts; ++i) {
    const double from = at.x + length * i / parts, to = at.x + length * (i + 1) / parts;
    const std::vector<Point> bar = {{from, at.y}, {to, at.y}, {to, at.y + 4}, {from, at.y + 4}};
    if (i % 2 == 0) drawing.add(Area{bar, black});
    drawing.add(Line{{bar[0], bar[1], bar[2], bar[3], bar[0]}, black, 0.7});
  }
  const std::string text = format("%g m", metres);
  drawing.add(Label{{at.x + length + 6, at.y + 6}, text, text_size, black});
  return at.x + length + 6 + width_of(text, text_size);
}

// What the symbols on the map mean, beside the bar of metres.
void draw_legend(Drawing& drawing, double left, double y, const MapData& data, const MapBox& extent) {
  const auto is_shown = [&](const Place& p) {
    return p.x >= extent.left && p.x <= extent.right && p.y >= extent.low && p.y <= extent.high;
  };
  const auto any = [&](const auto& things, const auto& place) {
    return std::any_of(things.begin(), things.end(), [&](const auto& thing) { return is_shown(place(thing)); });
  };
  const auto entry = [&](const std::string& text) {
    drawing.add(Label{{left, y + 6}, text, text_size, grey});
    left += width_of(text, text_size) + 14;
  };
  if (any(data.luminaires, [](const MapLuminaire& l) { return l.centre; })) {
    const Point c{left + 4, y + 3};
    drawing.add(Line{{{c.x - 3.5, c.y - 3.5}, {c.x + 3.5, c.y + 3.5}}, black, 1});
    drawing.add(Line{{{c.x - 3.5, c.y + 3.5}, {c.x + 3.5, c.y - 3.5}}, black, 1});
    left += 13;
    entry("luminaire");
  }
  if (any(data.observers, [](const MapObserver& o) { return o.at; })) {
    drawing.add(Line{{{left, y + 3}, {left + 12, y + 3}}, black, 1.2});
    drawing.add(Area{{{left + 14, y + 3}, {left + 8, y}, {left + 8, y + 6}}, black});
    left += 19;
    entry("observer");
  }
}

}  // namespace

Drawing map_drawing(const MapData& data, const MapStyle& style) {
  const MapField field(data);
  const MapRange range = range_of(data, style);
  MapView view{extent_of(data, field), {margin, margin + heading, 0, 0}, 1};
  const double width = style.width - 2 * margin - side;
  const double height = std::max(style.most_height - 2 * margin - heading - foot, 60.0);
  view.scale = std::min(width / view.extent.width(), height / view.extent.height());
  view.frame.width = view.extent.width() * view.scale;
  view.frame.height = view.extent.height() * view.scale;
  const double least = style.threshold > 0 ? 170 : 150;  // for what stands beside it
  const double body = std::max(view.frame.height, least);

  const double content = std::max({view.frame.width + 2 + side, width_of(heading_of(data), 14, true),
                                   width_of(data.summary, text_size)});
  Drawing drawing{std::min(style.width, std::ceil(content + 2 * margin)),
                  2 * margin + heading + body + (data.is_image ? 0 : foot), {}};
  drawing.add(Label{{margin, margin + 13}, heading_of(data), 14, black, Anchor::start, true});
  drawing.add(Label{{margin, margin + 29}, data.summary, text_size, grey});
  draw_plot(drawing, view, data, field, style, range);
  const double left = margin + view.frame.width + 16, top = view.frame.top + 16;
  const bool arrow = data.north_x != 0 || data.north_y != 0;
  if (style.threshold > 0) {
    draw_verdicts(drawing, left, top, data, style);
  } else {
    draw_scale(drawing, {left, top, 13, std::min(body - 20 - (arrow ? 56 : 0), 260.0)}, data, style, range);
  }
  if (data.is_image) return drawing;
  draw_north(drawing, {left + 22, view.frame.top + body - 22}, data);
  const double y = view.frame.top + body + 12;
  draw_legend(drawing, draw_metres(drawing, {margin + 1, y}, view.scale) + 24, y, data, view.extent);
  return drawing;
}

Words map_words(const MapData& data, const MapStyle& style) {
  return {data.quantity + (data.title.empty() ? "" : ": " + data.title), map_description(data, style)};
}

std::string map_description(const MapData& data, const MapStyle& style) {
  std::string text = heading_of(data) + ". " + data.summary;
  if (style.threshold > 0) {
    text += format(". Of %zu values, %g ", data.values.size(), style.threshold) + data.unit;
    std::string parts;
    for (const Verdict verdict : verdicts)
      if (const size_t count = count_of(data, style.threshold, verdict))
        parts += (parts.empty() ? " is " : ", ") + std::string(word_of(verdict)) + format(" at %zu", count);
    return text + parts + ".";
  }
  const MapRange range = range_of(data, style);
  if (range.most >= 0)
    text += ". From " + value_text(range.least, range.most) + " to " + value_text(range.most, range.most) + " " +
            data.unit;
  std::string levels;
  if (style.isolines)
    for (const double level : range.levels) levels += (levels.empty() ? "" : ", ") + format("%.6g", level);
  return text + (levels.empty() ? "" : "; lines at " + levels + " " + data.unit) + ".";
}

}  // namespace ups::report
