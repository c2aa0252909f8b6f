// A drawing as smoothed pixels. Lines cover a pixel by their distance from its centre, areas by the part of it that
// lies inside. Letters are strokes between neighbouring dots of the 5x7 font.
#include <algorithm>
#include <array>
#include <cmath>

#include "common/glyphs.h"
#include "tool/drawing.h"
#include "tool/fold.h"

namespace ups::tool {
namespace {

// Of the font, in ems: from dot to dot across and down, and between letters.
constexpr double across = 0.105, down = 0.12, gap = 0.19, blank = 0.28;

// What the font lacks is '?'.
std::string letters_of(const std::string& text) {
  std::string out;
  for (const char c : folded(text)) out += c == ' ' || extras::find_glyph(c) ? c : '?';
  return out;
}

constexpr int tall = int(extras::glyph_height) + 2;
using Rows = std::array<uint8_t, tall>;  // as in Glyph, with two below the baseline

// The font squeezes tails in above the baseline; here they hang below it.
Rows rows_of(const extras::Glyph& glyph) {
  switch (glyph.letter) {
    case 'g':
      return {0x00, 0x00, 0x0f, 0x11, 0x11, 0x11, 0x0f, 0x01, 0x0e};
    case 'j':
      return {0x02, 0x00, 0x06, 0x02, 0x02, 0x02, 0x02, 0x12, 0x0c};
    case 'p':
      return {0x00, 0x00, 0x1e, 0x11, 0x11, 0x11, 0x1e, 0x10, 0x10};
    case 'q':
      return {0x00, 0x00, 0x0f, 0x11, 0x11, 0x11, 0x0f, 0x01, 0x01};
    case 'y':
      return {0x00, 0x00, 0x11, 0x11, 0x11, 0x11, 0x0f, 0x01, 0x0e};
    default: {
      Rows rows{};
      std::copy(std::begin(glyph.rows), std::end(glyph.rows), rows.begin());
      return rows;
    }
  }
}

bool is_dot(const Rows& rows, int row, int column) {
  return row >= 0 && row < tall && column >= 0 && column < 5 && (rows[row] >> (4 - column) & 1);
}

struct Columns {
  int first, count;
};
// The columns that a letter fills; digits all fill five, so that numbers stand under one another.
Columns columns_of(char letter, const extras::Glyph& glyph) {
  if (letter >= '0' && letter <= '9') return {0, 5};
  const Rows rows = rows_of(glyph);
  int first = 5, last = -1;
  for (int column = 0; column < 5; ++column) {
    for (int row = 0; row < tall; ++row) {
      if (!is_dot(rows, row, column)) continue;
      first = std::min(first, column);
      last = std::max(last, column);
    }
  }
  return {first, last - first + 1};
}

double advance_of(char letter) {
  const extras::Glyph* glyph = extras::find_glyph(letter);
  return glyph ? (columns_of(letter, *glyph).count - 1) * across + gap : blank;
}

// The parts of a line that are drawn.
std::vector<std::vector<Point>> dashes_of(const Line& line) {
  if (line.dash <= 0) return {line.points};
  std::vector<std::vector<Point>> dashes;
  const double drawn = std::max(line.dash - line.width, 0.1);  // and a round end on both sides
  const double period = (1 + Line::gap) * line.dash;
  double place = 0;  // along the line, within its period
  bool drawing = false;
  for (size_t i = 0; i + 1 < line.points.size(); ++i) {
    const Point a = line.points[i], b = line.points[i + 1];
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    for (double at = 0; at < length;) {
      const bool on = place < drawn;
      const double step = std::min(length - at, (on ? drawn : period) - place);
      const auto point = [&](double t) { return Point{a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t}; };
      if (on && !drawing) dashes.push_back({point(at / length)});
      if (on) dashes.back().push_back(point((at + step) / length));
      drawing = on;
      at += std::max(step, 1e-9 * length);
      place += step;
      if (place >= period - 1e-9) place = 0;
    }
  }
  return dashes;
}

class Canvas {
 public:
  Canvas(const Drawing& drawing, double zoom) : zoom_(zoom) {
    out_.width = uint32_t(std::lround(drawing.width * zoom));
    out_.height = uint32_t(std::lround(drawing.height * zoom));
    out_.rgb.assign(size_t(out_.width) * out_.height * 3, 255);
    cover_.assign(size_t(out_.width) * out_.height, 0.f);
  }

  void draw(const Line& line) {
    for (const auto& dash : dashes_of(line))
      for (size_t i = 0; i + 1 < dash.size(); ++i) cover_stroke(dash[i], dash[i + 1], line.width);
    blend(line.ink, 1);
  }

  void draw(const Area& area) {
    constexpr int samples = 4;  // lines a pixel
    for (uint32_t line = 0; line < samples * out_.height; ++line) {
      const double y = (line + 0.5) / samples;
      std::vector<double> crossings;
      for (size_t i = 0; i < area.points.size(); ++i) {
        const Point a = scaled(area.points[i]), b = scaled(area.points[(i + 1) % area.points.size()]);
        if ((a.y <= y) != (b.y <= y)) crossings.push_back(a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y));
      }
      std::sort(crossings.begin(), crossings.end());
      for (size_t i = 0; i + 1 < crossings.size(); i += 2)
        cover_span(line / samples, crossings[i], crossings[i + 1], 1.f / samples);
    }
    blend(area.ink, area.opacity);
  }

  void draw(const Label& label) {
    const double width = width_of(label.text, label.size), em = label.size;
    double x = label.at.x - (label.anchor == Anchor::middle ? 0.5 * width : label.anchor == Anchor::end ? width : 0);
    const double stroke = em * (label.bold ? 0.135 : 0.085);
    for (const char letter : letters_of(label.text)) {
      if (const extras::Glyph* glyph = extras::find_glyph(letter)) {
        const int first = columns_of(letter, *glyph).first;
        const double sunk = letter == ',' || letter == ';' ? down * em : 0;  // the font's rows end at the baseline
        const Point top_left{x + (0.5 * gap - first * across) * em, label.at.y - 6 * down * em + sunk};
        cover_glyph(rows_of(*glyph), top_left, em, stroke);
      }
      x += advance_of(letter) * em;
    }
    blend(label.ink, 1);
  }

  Pixels take() { return std::move(out_); }

 private:
  Point scaled(Point p) const { return {p.x * zoom_, p.y * zoom_}; }

  void cover_stroke(Point from, Point to, double width) {
    const Point a = scaled(from), b = scaled(to);
    const double radius = 0.5 * width * zoom_, reach = radius + 1;
    const auto low = [](double v) { return uint32_t(std::max(0.0, std::floor(v))); };
    const auto high = [](double v, uint32_t end) { return uint32_t(std::clamp(std::ceil(v), 0.0, double(end))); };
    const double length2 = (b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y);
    for (uint32_t y = low(std::min(a.y, b.y) - reach); y < high(std::max(a.y, b.y) + reach, out_.height); ++y) {
      for (uint32_t x = low(std::min(a.x, b.x) - reach); x < high(std::max(a.x, b.x) + reach, out_.width); ++x) {
        const double px = x + 0.5 - a.x, py = y + 0.5 - a.y;
        const double t = length2 > 0 ? std::clamp((px * (b.x - a.x) + py * (b.y - a.y)) / length2, 0.0, 1.0) : 0;
        const double distance = std::hypot(px - t * (b.x - a.x), py - t * (b.y - a.y));
        // A line thinner than a pixel is fainter, not thinner.
        const double cover = std::clamp(radius + 0.5 - distance, 0.0, std::min(1.0, 2 * radius));
        float& c = touch(x, y);
        c = std::max(c, float(cover));
      }
    }
  }

  void cover_span(uint32_t y, double from, double to, float share) {
    from = std::clamp(from, 0.0, double(out_.width));
    to = std::clamp(to, 0.0, double(out_.width));
    for (uint32_t x = uint32_t(from); x < to && x < out_.width; ++x)
      touch(x, y) += share * float(std::min(to, x + 1.0) - std::max(from, double(x)));
  }

  // Dots side by side are joined; diagonally only where no dot between them already joins them.
  void cover_glyph(const Rows& rows, Point top_left, double em, double stroke) {
    const auto at = [&](int row, int column) {
      return Point{top_left.x + column * across * em, top_left.y + row * down * em};
    };
    for (int row = 0; row < tall; ++row) {
      for (int column = 0; column < 5; ++column) {
        if (!is_dot(rows, row, column)) continue;
        const bool right = is_dot(rows, row, column + 1), below = is_dot(rows, row + 1, column);
        cover_stroke(at(row, column), at(row, column), stroke);
        if (right) cover_stroke(at(row, column), at(row, column + 1), stroke);
        if (below) cover_stroke(at(row, column), at(row + 1, column), stroke);
        for (const int side : {-1, 1}) {
          if (!below && is_dot(rows, row + 1, column + side) && !is_dot(rows, row, column + side))
            cover_stroke(at(row, column), at(row + 1, column + side), stroke);
        }
      }
    }
  }

  float& touch(uint32_t x, uint32_t y) {
    first_row_ = std::min(first_row_, y);
    last_row_ = std::max(last_row_, y);
    return cover_[size_t(y) * out_.width + x];
  }

  void blend(const Ink& ink, double opacity) {
    if (first_row_ <= last_row_) {
      for (size_t i = size_t(first_row_) * out_.width; i < size_t(last_row_ + 1) * out_.width; ++i) {
        const double share = opacity * std::min(1.f, cover_[i]);
        for (size_t k = 0; k < 3; ++k)
          out_.rgb[3 * i + k] = uint8_t(std::lround(out_.rgb[3 * i + k] * (1 - share) + ink[k] * share));
        cover_[i] = 0;
      }
    }
    first_row_ = UINT32_MAX;
    last_row_ = 0;
  }

  double zoom_;
  Pixels out_{};
  std::vector<float> cover_;  // of the part being drawn
  uint32_t first_row_ = UINT32_MAX, last_row_ = 0;
};

}  // namespace

double width_of(const std::string& text, double size) {
  double width = 0;
  for (const char letter : letters_of(text)) width += advance_of(letter);
  return width * size;
}

Pixels to_pixels(const Drawing& drawing, double zoom) {
  Canvas canvas(drawing, zoom);
  for (const auto& part : drawing.parts) std::visit([&](const auto& p) { canvas.draw(p); }, part);
  return canvas.take();
}

}  // namespace ups::tool
