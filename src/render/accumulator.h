// Sums of iterations and what can be said of their error. 16 interleaved batches, each with its own scrambling of the
// stratified numbers, are independent replicates with the same radius history: their spread is the standard error, and
// drift of the radius cancels out of it.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "base/stop.h"
#include "base/zeroed.h"
#include "render/caustic_search.h"
#include "render/goniometer_sums.h"
#include "render/image_sums.h"
#include "render/meter_statistics.h"
#include "render/meter_sums.h"
#include "render/prediction.h"
#include "render/vector_light.h"
#include "ups/ups_render.h"

namespace ups {

struct MeterSetReading {
  std::vector<ups_meter_reading> meters;
  std::vector<uint32_t> flags;                       // UPS_READING_*
  std::vector<Sample> largest;                       // of each meter; 0: none by chance
  std::array<std::vector<ups_meter_part_reading>, 2> parts;  // by ups_light_part, of which all together are `meters`
  std::vector<std::vector<ups_meter_reading>> separated;  // by column of Plan::separation; empty where not asked for
  std::array<std::vector<ups_vector_part_reading>, 3> vectors;  // of a vector set, by ups_light_part
  ups_meter_statistics statistics{};
  MeterBatches batches;  // of those that were visited, in their order
};

// Quantiles of the relative error over all meters, without meters over all pixels; -1: not known yet.
struct ErrorSummary {
  float median = -1, p95 = -1, worst = -1, mean = -1, bias_share = -1;
  std::vector<MeterError> meters;  // of all sets; one that stands for all pixels; empty: a goniometer's nodes
  struct Place {
    size_t set, meter;
    MeterError error;
  };
  std::optional<Place> worst_place;  // of `meters`
};

class Accumulator {
 public:
  explicit Accumulator(const Snapshot& scene, const Plan& plan);
  // Of a meter, without MeterRings: its sums, as many again for each column of a separation; its reading, which is kept;
  // and what reading its set takes besides.
  static constexpr double sum_bytes = sizeof(MeterSums), reading_bytes = sizeof(ups_meter_reading),
                          part_bytes = 2 * sizeof(ups_meter_part_reading) + sizeof(uint32_t) +
                                               sizeof(Sample) + MeterBatches::bytes_per_meter;
  static double scratch_bytes(bool has_discs);
  void add(const IterationTally& tally);  // the next iteration
  uint32_t iterations() const { return iterations_; }
  const WorkCounts& work() const { return work_; }

  MeterSetReading read_meters(size_t set) const { return read_meters(set, choose_discs(set)); }  // nothing separated
  MeterSetReading read_meters_and_sources(size_t set) const;
  GoniometerReading read_goniometer(size_t goniometer) const;
  std::string goniometer_asymmetry(size_t goniometer) const {
    return goniometers_[goniometer].asymmetry(iterations_);
  }
  ImageReading read_image(size_t camera) const {  // without its techniques
    return images_[camera].read(iterations_, brightest_caustic_lm(0));
  }
  ImageReading read_image_and_techniques(size_t camera) const;
  std::vector<ups_sample> largest_samples(size_t camera, const ImageReading& image, uint64_t seed) const;
  std::vector<ups_sample> largest_samples(size_t set, const MeterSetReading& meters, uint64_t seed) const;
  // stop: throws Cancelled once it is cancelled.
  ErrorSummary summarize(const StopSignal* stop = nullptr) const;
  size_t unvisited_pixels(size_t camera) const { return images_[camera].unvisited_pixels(iterations_); }
  size_t unvisited_meters(size_t set) const;

 private:
  uint32_t visits(size_t meter) const {
    return plan_.meter_pass(iterations_) + (meter % plan_.meter_subsets < iterations_ % plan_.meter_subsets);
  }
  using Largest = std::array<float, light_part_count>;
  // Of all emitters, or of those of a column of Plan::separation, as they are before any path.
  struct Emitted {
    double lm = 0;
    double brightest_lm = 0;     // that one of its light paths may start with
    double brightest_cd_m2 = 0;  // that an eye path may run into
  };
  // What comes by way of casters alone has discs of its own: a caustic may be far narrower than all other light.
  enum LightClass : size_t { other_light, caustic_light, class_count };
  using ClassChoices = std::vector<MeterRings::Choice>;  // by meter; of cells and where nothing is merged, none
  using Choices = std::array<ClassChoices, class_count>;
  static std::vector<Emitted> emitted_by_column(const Snapshot& scene, const Plan& plan);
  // That one light path starts with; that it may bring by way of casters alone: before division by N.
  double brightest_lm(size_t column) const;
  double brightest_caustic_lm(size_t column) const;
  NeighbourProfiles profiles_of(size_t set, LightClass of, size_t column, const StopSignal* stop) const;
  ClassChoices choose_discs(size_t set, LightClass of, const StopSignal* stop) const;
  Choices choose_discs(size_t set, const StopSignal* stop = nullptr) const {
    return {choose_discs(set, other_light, stop), choose_discs(set, caustic_light, stop)};
  }
  // column: 0, all its light, or one more than that of a separated source's; all take the disc that the meter chooses.
  // own: the bias of each class, as the meter tells it.
  MeterLight light_of(size_t set, size_t meter, const Choices& discs, size_t column,
                      std::array<OwnBias, class_count>& own) const;
  std::vector<MeterLight> lights_of(size_t set, const Choices& discs, size_t column = 0,
                                    const StopSignal* stop = nullptr) const;
  // Of a set's meters as the caller counts them; of vectors their lengths, and beside them their sides.
  struct SetLight {
    std::vector<MeterLight> meters, sides;
  };
  SetLight light_of_set(size_t set, const Choices& discs, size_t column = 0, const StopSignal* stop = nullptr) const;
  ups_meter_reading reading_of(const SetLight& light, size_t meter) const;
  VectorLight vector_of(const std::vector<MeterLight>& sides, size_t meter) const;
  // Of a meter whose eye paths alone bring it. Visits stand for area, their number in one for light paths.
  double unfound_by_hits(size_t set, size_t meter, size_t column, double hits, double visits) const;
  CausticSearch search_of_cell(size_t set, size_t meter, size_t column) const;
  CausticSearch search_about_cell(size_t set, size_t meter, size_t column) const;
  CausticSearch search_of_mean(size_t set, const std::vector<MeterLight>& lights) const;
  // lx, by all meters of the set together; -1: by each.
  double unfound_in_mean(size_t set, const std::vector<MeterLight>& lights) const;
  // What one path may bring to an iteration's reading, as far as is known.
  double largest_path(size_t set, size_t meter, size_t column, double disc_area, LightPart part) const;
  MeterSetReading read_meters(size_t set, const Choices& discs) const;
  void add_statistics(size_t set, const std::vector<MeterLight>& lights, MeterSetReading& r) const;
  ErrorSummary summarize_images() const;
  ErrorSummary summarize_goniometers() const;
  const Snapshot& scene_;
  const Plan& plan_;
  const double emitted_lm_;
  const double scene_lx_;  // on the scene's bounding sphere, were all light to reach it
  const bool emits_;
  uint32_t iterations_ = 0;
  std::vector<ZeroedVector<MeterSums>> meters_;
  std::vector<ZeroedVector<MeterSums>> separated_;  // a meter by a column, column fastest
  // Of all light, then by column of Plan::separation: that one path brought to any meter of a set.
  std::vector<std::vector<Largest>> largest_;
  std::vector<double> largest_exact_;  // of a set, lx
  std::vector<Emitted> emitted_;
  // By set and class: a meter by all its light and the columns, these fastest; empty: nothing is merged.
  std::vector<std::array<MeterRings, class_count>> rings_;
  std::vector<uint32_t> discs_that_meet_;  // of a set, at most
  std::vector<ImageSums> images_;
  std::vector<GoniometerSums> goniometers_;
  WorkCounts work_;
};

}  // namespace ups
