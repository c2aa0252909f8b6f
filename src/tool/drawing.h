// A diagram as lines, areas and labels, and how it is written: as SVG text or as pixels. Filled by profile_plot.cpp;
// knows nothing of photometry.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ups::tool {

using Ink = std::array<uint8_t, 3>;

struct Point {
  double x, y;  // in the drawing's units, y downwards
};

struct Line {
  std::vector<Point> points;
  Ink ink;
  double width;
  double dash = 0;  // length of dashes; the gaps between them are `gap` of it; 0: solid
  static constexpr double gap = 0.75;
};

struct Area {
  std::vector<Point> points;  // closed, even-odd
  Ink ink;
  double opacity = 1;
};

enum class Anchor { start, middle, end };

struct Label {
  Point at;          // on the baseline
  std::string text;  // UTF-8
  double size;       // of an em
  Ink ink;
  Anchor anchor = Anchor::start;
  bool bold = false;
};

struct Drawing {
  double width, height;
  std::vector<std::variant<Line, Area, Label>> parts;  // the later ones on top
};

// About as wide as a sans-serif font sets it.
double width_of(const std::string& text, double size);

// A document of its own that needs no font but the viewer's sans-serif one. title: for those who cannot see it.
std::string to_svg(const Drawing& drawing, const std::string& title);

struct Pixels {
  uint32_t width, height;
  std::vector<uint8_t> rgb;  // row 0 at the top
};
// Smoothed, on white, `zoom` pixels a unit.
Pixels to_pixels(const Drawing& drawing, double zoom);

}  // namespace ups::tool
