// Sums of one camera's image over iterations, its techniques with them, and what can be said of its error. Kept by the
// accumulator.
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "base/zeroed.h"
#include "render/illuminance_sums.h"
#include "render/largest_samples.h"
#include "render/layer_sums.h"
#include "render/pixel_caustics.h"
#include "render/prediction.h"
#include "render/zero_bound.h"
#include "transport/tally.h"

namespace ups {

// 3 floats a pixel each.
struct TechniqueReading {
  Technique technique;
  std::vector<float> weighted, unweighted;
};

struct ImageReading {
  uint32_t width = 0, height = 0;
  std::vector<float> luminance_rgb, standard_error_rgb;  // 3 a pixel; standard error -1: not known
  std::vector<float> robust_rgb;                         // 3 a pixel
  std::vector<float> bias, error_bound;                  // of luminance; bound -1: not known
  std::optional<IlluminanceReading> illuminance;         // where asked for
  LayerReading layers;
  std::array<std::vector<float>, 2> families;            // luminance_rgb apart by Family; empty where not asked for
  std::vector<TechniqueReading> techniques;
};

class ImageSums {
 public:
  // emitted_cd_m2: luminance of the scene's bounding sphere, were it to give off all light of the emitters.
  ImageSums(const Camera& camera, const Plan& plan, double emitted_cd_m2);
  // What the camera's image takes, a pixel: its sums, where techniques are asked for with an iteration's tally; the
  // reading, which is kept; and what reading it takes besides. passes: of all pixels.
  struct Bytes {
    double sums, reading, scratch;
  };
  static Bytes bytes_per_pixel(const Camera& camera, const TransportSettings& settings, double passes);

  void add(uint32_t iteration, const IterationTally& tally, size_t camera);
  // Without its techniques. caustic_lm: that one light path starts with, where photons alone may bring light by way of
  // casters; 0: nowhere.
  ImageReading read(uint32_t iterations, double caustic_lm) const;
  void read_techniques(uint32_t iterations, ImageReading& reading) const;
  void find_largest(uint32_t iterations, const ImageReading& reading, LargestSamples& out) const;
  size_t unvisited_pixels(uint32_t iterations) const;  // by eye paths so far
  // Adds those of all pixels: bound / max(L, share_of_mean of the image's mean), of luminance. together: those of pixels
  // that some path has brought light to, and one of all others: had any of them much, some path would have found it.
  // Nor do the others make an image any better: they may be as dark as they look, or none of their light found yet.
  // False where they are not known yet.
  bool relative_errors(uint32_t iterations, double caustic_lm, std::vector<double>& out, MeanError& together) const;

 private:
  uint32_t passes(uint32_t iterations) const { return iterations / plan_.camera_subsets; }
  ChanceLight chance(size_t pixel, uint32_t passes) const;
  std::vector<float> largest_of_tiles() const;
  // What a pixel's error bound is made of, of so many whole passes.
  MeterError apart(uint32_t pixel, uint32_t passes, uint32_t visits, const ImageReading& reading,
                   const PixelMergeSums::Errors& errors) const;
  ImageReading read(uint32_t iterations, double caustic_lm, PixelMergeSums::Errors& errors) const;
  void add_techniques(const TechniqueTally& tally);
  uint32_t visits(uint32_t iterations, uint32_t x, uint32_t y) const {
    return iterations / plan_.camera_subsets + (plan_.pixel_subset(x, y) < iterations % plan_.camera_subsets);
  }
  std::vector<uint32_t> all_visits(uint32_t iterations) const;
  bool is_blank(size_t pixel) const { return !blank_.empty() && blank_[pixel]; }
  void read_errors(uint32_t passes, ImageReading& reading) const;
  // Keeps for apart() what pixels' bounds are made of, once `passes` are enough for them.
  void read_bounds(uint32_t passes, const std::vector<uint32_t>& visits, double caustic_lm, ImageReading& reading,
                   PixelMergeSums::Errors& errors) const;
  void fill_unvisited(const std::vector<uint32_t>& visits, ImageReading& reading) const;
  void clear_blank(ImageReading& reading) const;

  const Plan& plan_;
  const uint32_t width_, height_;
  const Tiles tiles_;
  const double emitted_cd_m2_;
  std::vector<bool> blank_;          // pixels that see nothing at all: they are black without error; empty: none
  LayerSums layers_;
  std::optional<IlluminanceSums> illuminance_;  // where asked for
  ZeroedVector<double> eye_;          // 3 a pixel, of all visits
  ZeroedVector<double> splat_;        // 3 a pixel, of all iterations; empty until light paths bring something
  ZeroedVector<float> pending_;       // eye and splats of the pass under way
  ZeroedVector<Sample> largest_;      // of each pixel, luminance
  // 3 a pixel, of whole passes; each is empty before its first.
  std::array<ZeroedVector<float>, batch_count> batches_;
  std::optional<PixelMergeSums> merges_;  // where photons are merged
  // Of all iterations, 3 a pixel, technique by technique; empty where not asked for.
  ZeroedVector<double> weighted_, unweighted_;
  std::array<ZeroedVector<double>, 2> families_;  // of eye paths
};

}  // namespace ups
