// Sums of what a camera's pixels see first, over all visits: its layers (UPS_LAYER_*). Kept by ImageSums.
#pragma once
#include <vector>

#include "transport/plan.h"
#include "transport/tally.h"

namespace ups {

struct LayerReading {  // each empty where not asked for
  std::vector<float> albedo_rgb, normal;  // 3 a pixel
  std::vector<float> depth, id;           // 1 a pixel
  static double bytes_per_pixel(const Camera& camera);
};

class LayerSums {
 public:
  explicit LayerSums(const Camera& camera);
  static double bytes_per_pixel(const Camera& camera);
  void add(const Plan& plan, uint32_t iteration, const IterationTally& tally, size_t camera);
  LayerReading read() const;

 private:
  const uint32_t width_, height_, layers_;
  std::vector<uint32_t> met_;                   // visits that met a surface
  std::vector<double> albedo_, normal_, depth_; // 3, 3, 1 a pixel
  std::vector<uint32_t> id_;
};

}  // namespace ups
