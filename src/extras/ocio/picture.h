// An 8-bit RGB picture in memory, what is drawn on it, and its PNG file. Called by the parts of ups_ocio.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "ocio/glyphs.h"

namespace ups::ocio {

using Color = std::array<uint8_t, 3>;

struct Picture {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgb;  // row 0 at the top

  Picture(uint32_t w, uint32_t h, const Color& background);
  void fill(uint32_t x, uint32_t y, uint32_t w, uint32_t h, const Color& color);  // cut at the borders
};

// Letters of a 5x7 font, each dot a square of `size` pixels; characters that it lacks are blanks. x, y: top left.
inline constexpr uint32_t glyph_width = 6;  // with the gap between letters
uint32_t text_width(const std::string& text, uint32_t size);
void draw_text(Picture& picture, const std::string& text, uint32_t x, uint32_t y, uint32_t size, const Color& color);

// White on a dark strip along the bottom edge.
void draw_bottom_line(Picture& picture, const std::string& text);

// Keyword and Latin-1 text of tEXt chunks (PNG 11.3.4.3).
using PngTexts = std::vector<std::pair<std::string, std::string>>;
// Throws extras::Error.
void write_png(const std::string& path, const Picture& picture, const PngTexts& texts = {});

}  // namespace ups::ocio
