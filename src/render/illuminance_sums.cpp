// See illuminance_sums.h.
#include "render/illuminance_sums.h"

#include "render/zero_bound.h"

namespace ups {

IlluminanceSums::IlluminanceSums(const Camera& camera, const Plan& plan, double emitted_lx)
    : plan_(plan), width_(camera.width()), height_(camera.height()), emitted_lx_(emitted_lx), tiles_(width_, height_),
      largest_(tiles_.count()), sums_(camera.pixel_count()) {}

void IlluminanceSums::add(uint32_t iteration, const std::vector<PixelIlluminance>& found, bool merges) {
  ZeroedVector<float>& batch = batches_[plan_.pass(iteration) % batch_count];
  batch.resize(sums_.size());
  if (merges && !merges_) merges_.emplace(width_, height_);
  plan_.for_visited_pixels(iteration, width_, height_, [&](uint32_t i, uint32_t pixel) {
    sums_[pixel] += found[i].lx;
    batch[pixel] += found[i].lx;
    float& largest = largest_[tiles_.of(pixel)];
    largest = std::max(largest, found[i].lx);
    if (merges_) merges_->add(pixel, found[i].merges);
  });
  if (merges_ && (iteration + 1) % plan_.camera_subsets == 0) merges_->bias.end_pass(plan_.pass(iteration));
}

IlluminanceReading IlluminanceSums::read(const std::vector<uint32_t>& visits, uint32_t passes,
                                         double caustic_lm) const {
  IlluminanceReading r(sums_.size());
  for (uint32_t p = 0; p < sums_.size(); ++p) {
    if (visits[p] == 0) continue;
    r.lx[p] = float(sums_[p] / visits[p]);
    if (merges_) r.bias[p] = merges_->bias.mean(p, visits[p]);
  }
  read_bounds(visits, passes, caustic_lm, r);
  return r;
}

void IlluminanceSums::read_bounds(const std::vector<uint32_t>& visits, uint32_t passes, double caustic_lm,
                                  IlluminanceReading& r) const {
  double mean = 0;
  for (const float lx : r.lx) mean += lx / double(r.lx.size());
  const std::vector<float> largest = tiles_.largest_around(largest_, mean > 0 ? mean : emitted_lx_);
  const bool whole = passes >= min_batches;
  std::vector<PixelBias::OfSquare> squares;
  if (merges_ && whole) squares = merges_->bias.of_squares(passes, r.lx);
  std::vector<PixelCaustics::Unfound> unfound(tiles_.count());
  if (merges_) unfound = merges_->caustics.unfound(caustic_lm, plan_.light_paths);
  for (uint32_t p = 0; p < sums_.size(); ++p) {
    const uint32_t n = visits[p];
    float sums[batch_count];
    for (uint32_t b = 0; b < std::min(n, batch_count); ++b) sums[b] = batches_[b][p];
    const ChanceLight light = chance_light(sums, n);
    if (!(emitted_lx_ > 0) || light.is_enough(n)) r.standard_error[p] = float(spread(sums, n).standard_error);
    if (!whole) continue;
    const double noise = double(r.standard_error[p]);
    const Spread bias = merges_ ? merges_->bias.of_pixel(p, n, r.lx[p], squares) : Spread{0, 0};
    const double few = unfound[tiles_.of(p)].noise(n);
    r.error_bound[p] = noise >= 0 ? error_bound({r.lx[p], std::hypot(noise, few)}, bias, n)
                                  : float(std::abs(bias.mean) + light.bound(largest[tiles_.of(p)], n));
    r.error_bound[p] += float(unfound[tiles_.of(p)].lx);
  }
}

}  // namespace ups
