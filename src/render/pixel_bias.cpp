// See pixel_bias.h.
#include "render/pixel_bias.h"

namespace ups {

void PixelBias::end_pass(uint32_t pass) {
  std::vector<double>& batch = batches_[pass % batch_count];
  batch.resize(pending_.size());
  for (size_t i = 0; i < batch.size(); ++i) batch[i] += pending_[i];
  std::fill(pending_.begin(), pending_.end(), 0.0);
}

std::vector<PixelBias::OfSquare> PixelBias::of_squares(uint32_t passes, const std::vector<float>& light) const {
  std::vector<uint32_t> pixels(pending_.size());
  std::vector<OfSquare> squares(pending_.size());
  for (uint32_t p = 0; p < light.size(); ++p)
    if (squares_[p] > 0) ++pixels[square_of(p)], squares[square_of(p)].light += light[p];
  for (size_t i = 0; i < squares.size(); ++i) {
    if (pixels[i] == 0) continue;
    double sums[batch_count];
    for (uint32_t b = 0; b < std::min(passes, batch_count); ++b) sums[b] = batches_[b][i] / pixels[i];
    squares[i] = {spread(sums, passes), squares[i].light / pixels[i]};
  }
  return squares;
}

Spread PixelBias::own(uint32_t pixel, uint32_t visits) const {
  Spread own{mean(pixel, visits)};
  if (visits < min_batches) return own;
  own.standard_error = std::sqrt(std::max(0.0, double(squares_[pixel]) / visits - own.mean * own.mean) / (visits - 1));
  return own;
}

Spread PixelBias::of_pixel(uint32_t pixel, uint32_t visits, float light,
                           const std::vector<OfSquare>& squares) const {
  const Spread own = this->own(pixel, visits);
  if (own.standard_error >= 0 && std::abs(own.mean) > 3 * own.standard_error) return own;
  const OfSquare& square = squares[square_of(pixel)];
  const bool brighter = squares_[pixel] > 0 && square.light > 0 && light > square.light;
  const double times = brighter ? light / square.light : 1;
  return {square.bias.mean * times, square.bias.standard_error * times};
}

}  // namespace ups
