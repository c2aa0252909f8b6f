// Text in pictures: the letters of glyphs.h as squares.
#include <algorithm>

#include "ocio/glyphs.h"

#include "ocio/picture.h"

namespace ups::ocio {

uint32_t text_width(const std::string& text, uint32_t size) { return uint32_t(text.size()) * glyph_width * size; }

void draw_text(Picture& picture, const std::string& text, uint32_t x, uint32_t y, uint32_t size, const Color& color) {
  for (const char letter : text) {
    if (const Glyph* glyph = find_glyph(letter)) {
      for (uint32_t row = 0; row < glyph_height; ++row) {
        for (uint32_t column = 0; column < 5; ++column) {
          if (glyph->rows[row] >> (4 - column) & 1) picture.fill(x + column * size, y + row * size, size, size, color);
        }
      }
    }
    x += glyph_width * size;
  }
}

void draw_bottom_line(Picture& picture, const std::string& text) {
  const uint32_t size = std::max(1u, picture.height / 360), margin = 3 * size, strip = glyph_height * size + 2 * margin;
  for (size_t i = picture.rgb.size() - size_t(std::min(strip, picture.height)) * picture.width * 3;
       i < picture.rgb.size(); ++i)
    picture.rgb[i] = uint8_t(picture.rgb[i] / 4);
  if (picture.height >= strip)
    draw_text(picture, text, margin, picture.height - strip + margin, size, {255, 255, 255});
}

}  // namespace ups::ocio
