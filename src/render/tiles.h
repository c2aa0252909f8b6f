// Tiles of an image, Units::side pixels wide, by which it is told what one path may bring to a pixel. Used by the sums
// of images.
#pragma once
#include <algorithm>
#include <vector>

#include "transport/plan.h"

namespace ups {

class Tiles {
 public:
  Tiles(uint32_t width, uint32_t height)
      : width_(width), columns_((width + Units::side - 1) / Units::side),
        rows_((height + Units::side - 1) / Units::side) {}
  size_t count() const { return size_t(columns_) * rows_; }
  size_t of(uint32_t pixel) const {
    return pixel % width_ / Units::side + size_t(pixel / width_ / Units::side) * columns_;
  }
  // The largest of each tile and those beside it, by tile.
  std::vector<float> around(const std::vector<float>& own, double least) const {
    const int columns = int(columns_), rows = int(rows_);
    std::vector<float> out(own.size(), float(least));
    for (int i = 0; i < rows * columns; ++i)
      for (int y = std::max(0, i / columns - 1); y <= std::min(rows - 1, i / columns + 1); ++y)
        for (int x = std::max(0, i % columns - 1); x <= std::min(columns - 1, i % columns + 1); ++x)
          out[size_t(i)] = std::max(out[size_t(i)], own[size_t(y * columns + x)]);
    return out;
  }

 private:
  uint32_t width_, columns_, rows_;
};

}  // namespace ups
