// An 8-bit RGB picture in memory, what is drawn on it, and its PNG file. Called by the parts of ups_ocio.
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace ups::ocio {

using Color = std::array<uint8_t, 3>;

struct Picture {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgb;  // row 0 at the top

  Picture(uint32_t w, uint32_t h, const Color& background);
  void fill(uint32_t x, uint32_t y, uint32_t w, uint32_t h, const Color& color);  // cut at the borders
};

// Printable ASCII and at_least_sign; other characters are blanks. height: of a capital, pixels. x, y: top left of it.
inline constexpr char at_least_sign = '\1';  // that ASCII lacks
uint32_t text_width(const std::string& text, uint32_t height);
void draw_text(Picture& picture, const std::string& text, uint32_t x, uint32_t y, uint32_t height, const Color& color);

// White on a dark strip along the bottom edge; nothing where the text is wider than the picture, or the strip higher
// than a quarter of it.
void draw_bottom_line(Picture& picture, const std::string& text);

// Keyword and Latin-1 text of tEXt chunks (PNG 11.3.4.3).
using PngTexts = std::vector<std::pair<std::string, std::string>>;
// Throws extras::Error.
void write_png(const std::string& path, const Picture& picture, const PngTexts& texts = {});

}  // namespace ups::ocio
