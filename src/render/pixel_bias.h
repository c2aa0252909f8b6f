// What merging moves in an image: each pixel's bias, and what a bound must add for it. Kept by the image's sums where the
// render merges photons.
#pragma once
#include <array>
#include <vector>

#include "render/spread.h"
#include "transport/plan.h"

namespace ups {

// One pixel's photons seldom tell bias from noise, and neighbours share them: squares of pixels have batches of their
// own, so that the noise of their mean is known with all that they share.
class PixelBias {
 public:
  static constexpr uint32_t side = 8;  // of a square, pixels
  static double bytes_per_pixel(double batches) { return 4 + 4 + (batches + 1) * 8 / (side * side); }

  PixelBias(uint32_t width, uint32_t height)
      : columns_((width + side - 1) / side), width_(width), sums_(size_t(width) * height), squares_(sums_.size()),
        pending_(size_t(columns_) * ((height + side - 1) / side)) {}

  void add(uint32_t pixel, float bias) {
    sums_[pixel] += bias;
    squares_[pixel] += bias * bias;
    pending_[square_of(pixel)] += bias;
  }
  void end_pass(uint32_t pass);

  float mean(uint32_t pixel, uint32_t visits) const { return visits ? sums_[pixel] / float(visits) : 0; }
  Spread own(uint32_t pixel, uint32_t visits) const;
  // Means over those pixels of a square that have merged photons; where none has, there is no bias.
  struct OfSquare {
    Spread bias{0, 0};
    double light = 0;
  };
  // light: luminance, or illuminance; of whole passes.
  std::vector<OfSquare> of_squares(uint32_t passes, const std::vector<float>& light) const;
  // The pixel's own where it is beyond doubt, else its square's: in proportion to its light where it has merged photons and
  // is brighter than the square, otherwise as it is, as what makes another bright need not be merged.
  Spread of_pixel(uint32_t pixel, uint32_t visits, float light, const std::vector<OfSquare>& squares) const;

 private:
  size_t square_of(uint32_t pixel) const { return size_t(pixel / width_ / side) * columns_ + pixel % width_ / side; }

  const uint32_t columns_, width_;
  std::vector<float> sums_, squares_;  // by pixel, of all visits
  std::vector<double> pending_;        // by square, of the pass under way
  std::array<std::vector<double>, batch_count> batches_;
};

}  // namespace ups
