// Sums of iterations and what can be said of their error. 16 interleaved batches, each with its own scrambling of the
// stratified numbers, are independent replicates with the same radius history: their spread is the standard error, and
// drift of the radius cancels out of it.
#pragma once
#include <cstdint>
#include <vector>

#include "render/goniometer_sums.h"
#include "ups/ups_render.h"

namespace ups {

// 3 floats a pixel each.
struct TechniqueReading {
  Technique technique;
  std::vector<float> weighted, unweighted;
};

struct ImageReading {
  uint32_t width = 0, height = 0;
  std::vector<float> luminance_rgb, standard_error_rgb;  // 3 a pixel; standard error -1: not known
  std::vector<float> illuminance;                        // 1 a pixel; empty where not asked for
  std::array<std::vector<float>, 2> families;            // luminance_rgb apart by Family; empty where not asked for
  std::vector<TechniqueReading> techniques;
};

struct MeterSetReading {
  std::vector<ups_meter_reading> meters;
  std::vector<std::vector<ups_meter_reading>> separated;  // by column of Plan::separation; empty where not asked for
  ups_meter_statistics statistics{};
};

// Quantiles of the relative error over all meters, without meters over all pixels; -1: not known yet.
struct ErrorSummary {
  float median = -1, p95 = -1, worst = -1, mean = -1, bias_share = -1;
};

class Accumulator {
 public:
  explicit Accumulator(const Snapshot& scene, const Plan& plan);
  void add(const IterationTally& tally);  // the next iteration
  uint32_t iterations() const { return iterations_; }
  const WorkCounts& work() const { return work_; }

  MeterSetReading read_meters(size_t set) const;  // without what is separated
  MeterSetReading read_meters_and_sources(size_t set) const;
  GoniometerReading read_goniometer(size_t goniometer) const;
  std::string goniometer_asymmetry(size_t goniometer) const {
    return goniometers_[goniometer].asymmetry(iterations_);
  }
  ImageReading read_image(size_t camera) const;  // without its techniques
  ImageReading read_image_and_techniques(size_t camera) const;
  ErrorSummary summarize() const;
  size_t unvisited_pixels(size_t camera) const;  // by eye paths so far

 private:
  // value, direct, bias of each batch of one meter
  struct MeterSums {
    double value[batch_count] = {}, direct = 0, bias[batch_count] = {};
    void add(uint32_t batch, const MeterTally& tally);
  };
  ups_meter_reading reading_of(const MeterSums& sums) const;
  struct Image {
    uint32_t width, height;
    std::vector<double> illuminance;     // of all visits; empty where not asked for
    std::vector<double> eye, splat;      // 3 a pixel, of all iterations
    std::vector<float> pending;          // eye + splat of the pass under way
    std::vector<float> batches;          // 3 a pixel, batch by batch, of whole passes
    std::vector<uint32_t> visits;        // by subset
    // Of all iterations, 3 a pixel, technique by technique; empty where not asked for.
    std::vector<double> weighted, unweighted;
    std::array<std::vector<double>, 2> families;  // of eye paths
  };
  void add_techniques(Image& image, const TechniqueTally& tally);
  void read_techniques(const Image& image, ImageReading& reading) const;
  void add_image(size_t c, const IterationTally& tally);
  ErrorSummary summarize_images() const;
  ErrorSummary summarize_goniometers() const;
  uint32_t visits(const Image& image, size_t pixel) const;
  void fill_from_neighbours(const Image& image, ImageReading& reading) const;
  // Light that has not been found by then is taken not to be there.
  bool takes_dark_for_dark() const { return !emits_ || iterations_ >= 16 * batch_count; }

  const Plan& plan_;
  const double emitted_lm_;
  const bool emits_;
  uint32_t iterations_ = 0;
  std::vector<std::vector<MeterSums>> meters_;
  std::vector<std::vector<MeterSums>> separated_;  // as IterationTally::separated
  std::vector<Image> images_;
  std::vector<GoniometerSums> goniometers_;
  WorkCounts work_;
};

}  // namespace ups
