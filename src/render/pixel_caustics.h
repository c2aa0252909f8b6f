// What an image may not show yet: light by way of casters. Kept by its sums where photons are merged.
#pragma once
#include <vector>

#include "render/caustic_search.h"
#include "render/pixel_bias.h"

namespace ups {

// By squares of pixels: a smaller caustic is not looked for, as nothing that is seen elsewhere says where it may be.
class PixelCaustics {
 public:
  static constexpr double bytes_per_pixel = 24.0 / (PixelSquares::side * PixelSquares::side);
  PixelCaustics(uint32_t width, uint32_t height) : squares_(width, height), of_square_(squares_.count()) {}

  void add(uint32_t pixel, const PixelMerges& merges) {
    Square& s = of_square_[squares_.of(pixel)];
    ++s.visits;
    s.seen += merges.disc_m2 > 0;
    s.search.add({double(merges.disc_m2), double(merges.caustics)});
  }
  double photons(uint32_t pixel) const { return of_square_[squares_.of(pixel)].search.paths; }  // in its square
  // In the mean over the pixel's square, parts of which may see nothing that light falls on.
  double unfound_lx(uint32_t pixel, double brightest_lm, uint32_t light_paths) const {
    const Square& s = of_square_[squares_.of(pixel)];
    return s.visits ? s.search.unfound_lx(brightest_lm, light_paths) * s.seen / s.visits : 0;
  }

 private:
  struct Square {
    CausticSearch search;
    uint32_t visits = 0, seen = 0;  // of its pixels, together; with a disc
  };
  const PixelSquares squares_;
  std::vector<Square> of_square_;
};

}  // namespace ups
