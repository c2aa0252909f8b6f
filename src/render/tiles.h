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
  // Of the tile and those beside it.
  template <class Visit>
  void each_around(size_t tile, const Visit& visit) const {
    const int x = int(tile % columns_), y = int(tile / columns_), columns = int(columns_), rows = int(rows_);
    for (int j = std::max(0, y - 1); j <= std::min(rows - 1, y + 1); ++j)
      for (int i = std::max(0, x - 1); i <= std::min(columns - 1, x + 1); ++i) visit(size_t(j) * columns_ + size_t(i));
  }
  // The largest of each tile and those beside it, by tile.
  std::vector<float> largest_around(const std::vector<float>& own, double least) const {
    std::vector<float> out(own.size(), float(least));
    for (size_t t = 0; t < out.size(); ++t)
      each_around(t, [&](size_t tile) { out[t] = std::max(out[t], own[tile]); });
    return out;
  }

 private:
  uint32_t width_, columns_, rows_;
};

}  // namespace ups
