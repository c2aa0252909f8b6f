// A diagram as lines, areas, pictures and labels, and how it is written: as SVG, PNG or PDF, all three by Cairo. Filled
// by the plots and maps; knows nothing of photometry.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

namespace ups::report {

using Ink = std::array<uint8_t, 3>;

struct Point {
  double x, y;  // in the drawing's units, y downwards
};

struct Line {
  std::vector<Point> points;
  Ink ink;
  double width;
  double dash = 0;  // length of dashes; the gaps between them are `gap` of it; 0: solid
  double opacity = 1;
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
  double turn_rad = 0;  // about `at`, clockwise on paper
  double halo = 0;      // width of a white rim around the letters
};

// Pixels stretched over a rectangle; viewers smooth between them as they like, so they are as fine as is to be seen.
struct Picture {
  Point corner;  // top left
  double width, height;
  uint32_t columns, rows;
  std::vector<uint8_t> rgba;  // row 0 at the top; not multiplied by alpha
  bool crisp = false;         // each in one colour, as far as a viewer heeds it
};

// The parts up to the matching ClipEnd are drawn within these outlines alone, even-odd.
struct ClipBegin {
  std::vector<std::vector<Point>> outlines;
};
struct ClipEnd {};

struct Drawing {
  using Part = std::variant<Line, Area, Label, Picture, ClipBegin, ClipEnd>;
  double width, height;  // units: CSS pixels, 96 an inch
  std::vector<Part> parts = {};  // the later ones on top

  void add(Part part);
};

// As the sans-serif font sets it.
double width_of(const std::string& text, double size, bool bold = false);

// Documents, on white. title and description: for those who cannot see it; without a description its labels.
struct Words {
  std::string title, description;
};
// ids_begin: of all ids in it; documents that are joined in one page need different ones.
std::string to_svg(const Drawing& drawing, const Words& words, const std::string& ids_begin = "");
std::string to_pdf(const Drawing& drawing, const Words& words);  // one page of the drawing's size
std::string to_png(const Drawing& drawing, double zoom);         // `zoom` pixels a unit

}  // namespace ups::report
