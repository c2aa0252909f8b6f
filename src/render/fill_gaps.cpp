// See fill_gaps.h: a level of half the size from the known values, the same for its own gaps, then back down.
#include "render/fill_gaps.h"

#include <algorithm>
#include <cmath>

namespace ups {

namespace {

struct Level {
  uint32_t width, height;
  std::vector<uint8_t> known;
  std::vector<float> values;
};

// Means of the known among two by two.
Level halved(uint32_t width, uint32_t height, uint32_t channels, const std::vector<uint8_t>& known,
             const std::vector<float>& values) {
  Level half{(width + 1) / 2, (height + 1) / 2, {}, {}};
  half.known.resize(size_t(half.width) * half.height);
  half.values.resize(half.known.size() * channels);
  for (uint32_t y = 0; y < half.height; ++y)
    for (uint32_t x = 0; x < half.width; ++x) {
      const size_t to = size_t(y) * half.width + x;
      int count = 0;
      for (uint32_t v = 2 * y; v < std::min(2 * y + 2, height); ++v)
        for (uint32_t u = 2 * x; u < std::min(2 * x + 2, width); ++u) {
          const size_t from = size_t(v) * width + u;
          if (!known[from]) continue;
          ++count;
          for (uint32_t k = 0; k < channels; ++k) half.values[to * channels + k] += values[from * channels + k];
        }
      for (uint32_t k = 0; count && k < channels; ++k) half.values[to * channels + k] /= float(count);
      half.known[to] = count > 0;
    }
  return half;
}

// The two cells of the level of half the size about the middle of cell i, and how much of the second.
struct Between {
  uint32_t low, high;
  float share;
};
Between between(uint32_t i, uint32_t half_size) {
  const uint32_t parent = i / 2;
  return i % 2 ? Between{parent, std::min(parent + 1, half_size - 1), 0.25f}
               : Between{parent > 0 ? parent - 1 : 0, parent, 0.75f};
}

}  // namespace

void fill_gaps(uint32_t width, uint32_t height, uint32_t channels, const std::vector<uint8_t>& known,
               std::vector<float>& values) {
  if ((width == 1 && height == 1) || std::find(known.begin(), known.end(), 0) == known.end()) return;
  Level half = halved(width, height, channels, known, values);
  fill_gaps(half.width, half.height, channels, half.known, half.values);
  for (uint32_t y = 0; y < height; ++y) {
    const Between rows = between(y, half.height);
    for (uint32_t x = 0; x < width; ++x) {
      const size_t p = size_t(y) * width + x;
      if (known[p]) continue;
      const Between columns = between(x, half.width);
      const auto at = [&](uint32_t u, uint32_t v) { return &half.values[(size_t(v) * half.width + u) * channels]; };
      const float *a = at(columns.low, rows.low), *b = at(columns.high, rows.low), *c = at(columns.low, rows.high),
                  *d = at(columns.high, rows.high);
      for (uint32_t k = 0; k < channels; ++k)
        values[p * channels + k] = std::lerp(std::lerp(a[k], b[k], columns.share),
                                             std::lerp(c[k], d[k], columns.share), rows.share);
    }
  }
}

}  // namespace ups
