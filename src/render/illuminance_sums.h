// Sums of one camera's image of illuminance, what its pixels see measured like meters there, and what can be said of
// its error. Kept by the image's sums where the camera asks for it.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "base/zeroed.h"
#include "render/pixel_caustics.h"
#include "render/tiles.h"
#include "transport/tally.h"

namespace ups {

// lx, 1 a pixel. -1: not known, of standard errors and bounds.
struct IlluminanceReading {
  static constexpr double bytes_per_pixel = 4 * sizeof(float);
  std::vector<float> lx, standard_error, bias, error_bound;
  explicit IlluminanceReading(size_t pixels)
      : lx(pixels), standard_error(pixels, -1.0f), bias(pixels), error_bound(pixels, -1.0f) {}
};

class IlluminanceSums {
 public:
  // emitted_lx: on the scene's bounding sphere, were it to take all light of the emitters.
  IlluminanceSums(const Camera& camera, const Plan& plan, double emitted_lx);
  // batches: whole passes of all pixels, at most batch_count; begun: with the one under way.
  static double bytes_per_pixel(bool merges, double batches, double begun) {
    return 8 + 4 * begun + merges * PixelMergeSums::bytes_per_pixel(batches);
  }

  // merges: photons, within the iteration.
  void add(uint32_t iteration, const std::vector<PixelIlluminance>& found, bool merges);
  // visits: of each pixel; passes: of all; caustic_lm: see ImageSums::read().
  IlluminanceReading read(const std::vector<uint32_t>& visits, uint32_t passes, double caustic_lm) const;

 private:
  void read_bounds(const std::vector<uint32_t>& visits, uint32_t passes, double caustic_lm,
                   IlluminanceReading& reading) const;
  const Plan& plan_;
  const uint32_t width_, height_;
  const double emitted_lx_;
  const Tiles tiles_;
  std::vector<float> largest_;  // by tile, of one visit
  ZeroedVector<double> sums_;   // of all visits
  std::array<ZeroedVector<float>, batch_count> batches_;  // the same, by a pixel's own visits
  std::optional<PixelMergeSums> merges_;                  // where photons are merged
};

}  // namespace ups
