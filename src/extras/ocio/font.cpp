// Text in pictures: the letters of letters.h at any size.
#include <algorithm>
#include <cmath>

#include "ocio/letters.h"
#include "ocio/picture.h"

namespace ups::ocio {

namespace {

const Letter* find_letter(char letter) {
  for (const Letter& known : letters) {
    if (known.letter == letter) return &known;
  }
  return nullptr;
}

float advance_of(const Letter* letter) { return letter ? letter->advance : blank_advance; }

float ink_at(const Letter& letter, int column, int row) {
  const char digit = coverage[letter.first + uint32_t(row * letter.width + column)];
  return float(digit <= '9' ? digit - '0' : digit - 'a' + 10) / 15;
}

// How much of [begin, end) lies in the cell that begins at `cell`.
float overlap(float begin, float end, int cell) {
  return std::max(0.f, std::min(end, float(cell + 1)) - std::max(begin, float(cell)));
}

// The mean of the letter's pixels over a square of them about (u, v).
float mean_ink(const Letter& letter, float u, float v, float side) {
  const float left = u - side / 2, top = v - side / 2;
  float sum = 0;
  for (int row = std::max(0, int(std::floor(top))); row < std::min<int>(letter.height, int(top + side) + 1); ++row) {
    const float height = overlap(top, top + side, row);
    for (int c = std::max(0, int(std::floor(left))); c < std::min<int>(letter.width, int(left + side) + 1); ++c)
      sum += ink_at(letter, c, row) * height * overlap(left, left + side, c);
  }
  return sum / (side * side);
}

// pen, baseline: in the picture's pixels.
void draw_letter(Picture& picture, const Letter& letter, float pen, float baseline, float scale, const Color& color) {
  const float x = pen + letter.left * scale, y = baseline - letter.top * scale;
  const float side = std::max(1.f, 1 / scale);  // enlarged: interpolated
  const float right = x + (letter.width + 1) * scale, bottom = y + (letter.height + 1) * scale;
  for (int row = std::max(0, int(y - scale)); row < std::min<int>(int(picture.height), int(bottom) + 1); ++row) {
    for (int c = std::max(0, int(x - scale)); c < std::min<int>(int(picture.width), int(right) + 1); ++c) {
      const float ink = mean_ink(letter, (float(c) + 0.5f - x) / scale, (float(row) + 0.5f - y) / scale, side);
      uint8_t* pixel = &picture.rgb[(size_t(row) * picture.width + size_t(c)) * 3];
      for (size_t k = 0; k < 3; ++k)
        pixel[k] = uint8_t(std::lround(float(pixel[k]) + ink * (float(color[k]) - float(pixel[k]))));
    }
  }
}

}  // namespace

uint32_t text_width(const std::string& text, uint32_t height) {
  float width = 0;
  for (const char letter : text) width += advance_of(find_letter(letter));
  return uint32_t(std::ceil(width * float(height) / capital_height));
}

void draw_text(Picture& picture, const std::string& text, uint32_t x, uint32_t y, uint32_t height, const Color& color) {
  const float scale = float(height) / capital_height;
  float pen = float(x);
  for (const char letter : text) {
    const Letter* known = find_letter(letter);
    if (known) draw_letter(picture, *known, pen, float(y + height), scale, color);
    pen += advance_of(known) * scale;
  }
}

void draw_bottom_line(Picture& picture, const std::string& text) {
  const uint32_t height = std::max(9u, picture.height / 50), margin = height / 2, strip = height + 2 * margin;
  if (4 * strip > picture.height || text_width(text, height) + 2 * margin > picture.width) return;
  for (size_t i = picture.rgb.size() - size_t(strip) * picture.width * 3; i < picture.rgb.size(); ++i)
    picture.rgb[i] = uint8_t(picture.rgb[i] / 4);
  draw_text(picture, text, margin, picture.height - strip + margin, height, {255, 255, 255});
}

}  // namespace ups::ocio
