// See false_color.h: statistics of the values, a scale of round numbers, the colours, and the picture around them.
#include "ocio/false_color.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <vector>

#include "common/boundary.h"

namespace ups::ocio {

namespace {

// 17 knots of the colour map viridis (van der Walt and Smith, 2015, CC0): its lightness rises evenly, so that order can
// be seen, by colour-blind people and in print too.
constexpr Color knots[] = {{68, 1, 84},    {72, 24, 106},  {71, 45, 123},  {66, 64, 134},  {59, 82, 139},
                           {51, 99, 141},  {44, 114, 142}, {38, 129, 142}, {33, 144, 140}, {31, 159, 136},
                           {40, 174, 128}, {62, 188, 116}, {93, 201, 99},  {130, 211, 76}, {171, 220, 50},
                           {213, 226, 26}, {253, 231, 37}};
constexpr int knot_count = int(std::size(knots));

constexpr Color background{255, 255, 255}, ink{30, 30, 30}, unknown{150, 150, 150};
constexpr uint32_t letter_units = 7;   // a capital's height, in the picture's unit of length
constexpr uint32_t target_size = 480;  // pixels of the longer side of an enlarged grid
constexpr uint32_t max_text_width = 16384;
constexpr double large_share = 0.99;   // where the scale ends: a few hot pixels must not take all of it

bool is_known(float value) { return std::isfinite(value) && value >= 0; }

struct Statistics {
  double min = 0, mean = 0, max = 0, large = 0;
  size_t count = 0;
};

Statistics statistics_of(const ups_ocio_false_color_desc& desc) {
  std::vector<float> known;
  for (size_t i = 0; i < size_t(desc.columns) * desc.rows; ++i) {
    if (is_known(desc.values[i])) known.push_back(desc.values[i]);
  }
  Statistics result;
  result.count = known.size();
  if (known.empty()) return result;
  std::sort(known.begin(), known.end());
  double sum = 0;
  for (float value : known) sum += value;
  result.min = known.front();
  result.max = known.back();
  result.mean = sum / double(known.size());
  result.large = known[size_t(std::ceil(large_share * double(known.size()))) - 1];
  return result;
}

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, std::abs(value) < 1e5 ? "%.*f" : "%.*e",
                std::abs(value) >= 1e5 ? 2
                : value >= 100         ? 0
                : value >= 1           ? 1
                                       : 3,
                value);
  return text;
}

void draw_values(Picture& picture, const ups_ocio_false_color_desc& desc, const Scale& scale, uint32_t x0, uint32_t y0,
                 uint32_t zoom) {
  for (uint32_t row = 0; row < desc.rows; ++row) {
    const uint32_t line = desc.first_row_at_bottom ? desc.rows - 1 - row : row;
    for (uint32_t column = 0; column < desc.columns; ++column) {
      const float value = desc.values[size_t(row) * desc.columns + column];
      const Color color = is_known(value) ? false_color((value - scale.min) / (scale.max - scale.min)) : unknown;
      picture.fill(x0 + column * zoom, y0 + line * zoom, zoom, zoom, color);
    }
  }
}

// largest: of the values; where it lies beyond the scale's end, the label there says "at least".
void draw_scale(Picture& picture, const Scale& scale, double largest, const std::string& unit, uint32_t x, uint32_t y,
                uint32_t width, uint32_t height, uint32_t size) {
  const uint32_t letter = letter_units * size;
  for (uint32_t i = 0; i < height; ++i) {
    picture.fill(x, y + i, width, 1, false_color(height > 1 ? 1 - double(i) / (height - 1) : 0));
  }
  const double first = std::ceil(scale.min / scale.step - 1e-9);
  for (int i = 0; (first + i) * scale.step <= scale.max + 1e-9 * scale.step; ++i) {
    const double value = (first + i) * scale.step;
    const double fraction = std::clamp((value - scale.min) / (scale.max - scale.min), 0.0, 1.0);
    const auto line = uint32_t(std::lround((1 - fraction) * (height - 1)));
    picture.fill(x + width, y + line, 3 * size, 1, ink);
    const uint32_t half = letter / 2;
    std::string label = tick_label(value, scale.step);
    if (line == 0 && largest > scale.max) label.insert(label.begin(), at_least_sign);
    draw_text(picture, label, x + width + 5 * size, y + line > half ? y + line - half : 0, letter, ink);
  }
  draw_text(picture, unit, x, y - letter - 4 * size, letter, ink);
}

}  // namespace

Scale round_scale(double min, double max) {
  if (!(max > min)) max = min + (min > 0 ? min : 1);
  const double raw = (max - min) / 5;
  const double power = std::pow(10.0, std::floor(std::log10(raw)));
  const double factor = raw / power;
  const double step = power * (factor <= 1 ? 1 : factor <= 2 ? 2 : factor <= 5 ? 5 : 10);
  return {min, std::ceil(max / step - 1e-9) * step, step};
}

std::string tick_label(double value, double step) {
  char text[32];
  if (value != 0 && (std::abs(value) >= 1e6 || step < 1e-4)) {
    std::snprintf(text, sizeof text, "%g", value);
  } else {
    std::snprintf(text, sizeof text, "%.*f", std::max(0, int(-std::floor(std::log10(step) + 1e-9))), value);
  }
  return text;
}

Color false_color(double fraction) {
  const double place = (fraction >= 0 ? std::min(fraction, 1.0) : 0) * (knot_count - 1);  // not a number: the lowest
  const int knot = std::min(int(place), knot_count - 2);
  Color result;
  for (size_t c = 0; c < 3; ++c) {
    result[c] = uint8_t(std::lround(knots[knot][c] + (place - knot) * (double(knots[knot + 1][c]) - knots[knot][c])));
  }
  return result;
}

Picture false_color_picture(const ups_ocio_false_color_desc& desc) {
  const Statistics statistics = statistics_of(desc);
  const bool automatic = desc.scale_min == 0 && desc.scale_max == 0;
  const Scale scale = round_scale(automatic ? 0 : desc.scale_min, automatic ? statistics.large : desc.scale_max);
  const std::string unit = desc.unit ? desc.unit : "lx";
  const std::string title = desc.title ? desc.title : "";
  const std::string footer = statistics.count == 0
                                 ? "no values"
                                 : "min " + number_text(statistics.min) + "  mean " + number_text(statistics.mean) +
                                       "  max " + number_text(statistics.max) + " " + unit;

  const uint32_t zoom = std::max(1u, target_size / std::max(desc.columns, desc.rows));
  const uint32_t width = desc.columns * zoom, height = desc.rows * zoom;
  const uint32_t size = std::max(1u, std::max(width, height) / 240);  // what all lengths are counted in
  const uint32_t margin = 10 * size, letter = letter_units * size, line = letter + 5 * size, bar = 14 * size;
  const uint32_t top = margin + 2 * line;
  const uint32_t scale_height = std::max(height, 12 * line);
  const uint32_t label_space = 5 * size + text_width("0000000000", letter);
  const uint32_t content =
      std::max(width + 2 * margin + bar + label_space, std::max(text_width(title, letter), text_width(footer, letter)));
  if (content > std::max(max_text_width, width + 2 * margin + bar + label_space))
    throw ups::extras::Error(UPS_ERROR_INVALID_ARGUMENT, "title or unit is " + std::to_string(content) +
                                                        " pixels wide at the picture's size; " +
                                                        std::to_string(max_text_width) + " are the most");
  Picture picture(2 * margin + content, top + scale_height + line + 2 * margin, background);
  draw_text(picture, title, margin, margin, letter, ink);
  draw_values(picture, desc, scale, margin, top, zoom);
  draw_scale(picture, scale, statistics.max, unit, 3 * margin + width, top, bar, scale_height, size);
  draw_text(picture, footer, margin, top + scale_height + margin, letter, ink);
  return picture;
}

}  // namespace ups::ocio
