// Sums of iterations and what can be said of their error. 16 interleaved batches, each with its own scrambling of the
// stratified numbers, are independent replicates with the same radius history: their spread is the standard error, and
// drift of the radius cancels out of it.
#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "render/goniometer_sums.h"
#include "render/image_sums.h"
#include "render/meter_statistics.h"
#include "ups/ups_render.h"

namespace ups {

// Sums of one meter, or of one source's part of its light. By batch where they are arrays.
struct MeterSums {
  double value[batch_count] = {}, direct[batch_count] = {}, bias[batch_count] = {};
  double exact = 0, rounding = 0;
  std::array<PathRecord, light_part_count> paths;
  std::array<uint16_t, light_part_count> batches{};  // a bit for each that such paths have brought light to
  uint8_t largest_batch = 0;                         // that with paths[whole_light].largest

  void add(uint32_t batch, const MeterTally& tally);
};

struct MeterSetReading {
  std::vector<ups_meter_reading> meters;
  std::vector<uint32_t> flags;                       // UPS_READING_*
  std::array<std::vector<ups_meter_part_reading>, 2> parts;  // by ups_light_part
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
  static constexpr double bytes_per_meter = sizeof(MeterSums) + sizeof(ups_meter_reading) +
                                            2 * sizeof(ups_meter_part_reading) + MeterBatches::bytes_per_meter;
  void add(const IterationTally& tally);  // the next iteration
  uint32_t iterations() const { return iterations_; }
  const WorkCounts& work() const { return work_; }

  MeterSetReading read_meters(size_t set) const;  // without what is separated
  MeterSetReading read_meters_and_sources(size_t set) const;
  GoniometerReading read_goniometer(size_t goniometer) const;
  std::string goniometer_asymmetry(size_t goniometer) const {
    return goniometers_[goniometer].asymmetry(iterations_);
  }
  ImageReading read_image(size_t camera) const { return images_[camera].read(iterations_); }  // without its techniques
  ImageReading read_image_and_techniques(size_t camera) const;
  ErrorSummary summarize() const;
  size_t unvisited_pixels(size_t camera) const { return images_[camera].unvisited_pixels(iterations_); }
  size_t unvisited_meters(size_t set) const;

 private:
  uint32_t visits(size_t meter) const {
    return plan_.meter_pass(iterations_) + (meter % plan_.meter_subsets < iterations_ % plan_.meter_subsets);
  }
  using Largest = std::array<float, light_part_count>;
  ups_meter_reading reading_of(const MeterSums& sums, uint32_t visits, size_t set, double largest) const;
  // Of the light of one part: standard error and bound; -1: not known.
  std::pair<float, float> error_of(const MeterSums& sums, LightPart part, uint32_t visits, size_t set,
                                   double largest) const;
  // What one path may bring to an iteration's reading, as far as is known.
  double largest_path(size_t set, size_t meter, const Largest& found, LightPart part) const;
  ups_meter_part_reading part_of(const MeterSums& sums, ups_light_part part, uint32_t visits, size_t set,
                                 double largest) const;
  uint32_t flags_of(const MeterSums& sums, uint32_t visits, const ups_meter_reading& reading) const;
  std::vector<ups_meter_reading> readings_of(size_t set) const;
  ups_meter_statistics statistics_of(size_t set, const std::vector<ups_meter_reading>& readings) const;
  ErrorSummary summarize_images() const;
  ErrorSummary summarize_goniometers() const;
  const Snapshot& scene_;
  const Plan& plan_;
  const double emitted_lm_;
  const double scene_lx_;  // on the scene's bounding sphere, were all light to reach it
  const bool emits_;
  uint32_t iterations_ = 0;
  std::vector<std::vector<MeterSums>> meters_;
  std::vector<std::vector<MeterSums>> separated_;  // a meter by a column, column fastest
  // That one path brought to any meter: by set; by set and column. Exact light of any meter, by set.
  std::vector<Largest> largest_;
  std::vector<std::vector<Largest>> largest_separated_;
  std::vector<double> largest_exact_;
  std::vector<ImageSums> images_;
  std::vector<GoniometerSums> goniometers_;
  WorkCounts work_;
};

}  // namespace ups
