// Sums of iterations and what can be said of their error. 16 interleaved batches, each with its own scrambling of the
// stratified numbers, are independent replicates with the same radius history: their spread is the standard error, and
// drift of the radius cancels out of it.
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "render/goniometer_sums.h"
#include "render/image_sums.h"
#include "render/prediction.h"
#include "ups/ups_render.h"

namespace ups {

struct MeterSetReading {
  std::vector<ups_meter_reading> meters;
  std::vector<std::vector<ups_meter_reading>> separated;  // by column of Plan::separation; empty where not asked for
  ups_meter_statistics statistics{};
};

// Quantiles of the relative error over all meters, without meters over all pixels; -1: not known yet.
struct ErrorSummary {
  float median = -1, p95 = -1, worst = -1, mean = -1, bias_share = -1;
  std::vector<MeterError> meters;  // of all sets; empty where the quantiles are over pixels or a goniometer's nodes
  struct Place {
    size_t set, meter;
    MeterError error;
  };
  std::optional<Place> worst_place;  // of `meters`
};

class Accumulator {
 public:
  explicit Accumulator(const Snapshot& scene, const Plan& plan);
  static constexpr double bytes_per_meter = sizeof(double) * (2 * batch_count + 1) + sizeof(ups_meter_reading);
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
  // value, direct, bias of each batch of one meter
  struct MeterSums {
    double value[batch_count] = {}, direct = 0, bias[batch_count] = {};
    void add(uint32_t batch, const MeterTally& tally);
  };
  uint32_t visits(size_t meter) const {
    return plan_.meter_pass(iterations_) + (meter % plan_.meter_subsets < iterations_ % plan_.meter_subsets);
  }
  ups_meter_reading reading_of(const MeterSums& sums, uint32_t visits) const;
  ups_meter_statistics statistics_of(size_t set, const std::vector<ups_meter_reading>& readings) const;
  ErrorSummary summarize_images() const;
  ErrorSummary summarize_goniometers() const;
  // Light that has not been found by then is taken not to be there.
  bool takes_dark_for_dark() const { return !emits_ || iterations_ >= 16 * batch_count * plan_.meter_subsets; }

  const Plan& plan_;
  const double emitted_lm_;
  const bool emits_;
  uint32_t iterations_ = 0;
  std::vector<std::vector<MeterSums>> meters_;
  std::vector<std::vector<MeterSums>> separated_;  // a meter by a column, column fastest
  std::vector<ImageSums> images_;
  std::vector<GoniometerSums> goniometers_;
  WorkCounts work_;
};

}  // namespace ups
