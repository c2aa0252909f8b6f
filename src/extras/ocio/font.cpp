// Text in pictures: the letters of glyphs.h as squares.
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

}  // namespace ups::ocio
