// What one iteration does: the techniques of the method, how many paths go where, and the merge radii. Fixed before the
// first iteration from the scene alone, so that a seed and an iteration count determine every bit.
#pragma once
#include <algorithm>
#include <cstdint>
#include <string>
#include <vector>

#include "base/memory_budget.h"
#include "emitter/guide.h"
#include "scene/separation.h"
#include "transport/meter_discs.h"
#include "transport/method.h"
#include "transport/weights.h"

namespace ups {

inline constexpr uint32_t batch_count = 16;  // interleaved, independently scrambled; see render/accumulator.h

struct TransportSettings {
  Method method;
  uint32_t techniques = 0;           // UPS_TECHNIQUE_*: those of the method that are left
  float glossy_alpha = 0;            // sharper gloss is what the method passes; 0: none
  double radius_alpha = 2.0 / 3;     // of the radius schedule
  bool actual_perturbation = false;  // UPS_PERTURBATION_ACTUAL
  uint32_t technique_edges = 0;      // images of each technique for paths of up to so many edges; 0: none
  ups_separation separation = UPS_SEPARATE_NOTHING;
  bool automatic = false;          // techniques are chosen by a pilot
  bool prefers_eye_paths = false;  // unless others are foretold to pay
  uint64_t seed = 0;
  uint32_t max_path_length = 0;  // edges; 0: none
  uint32_t light_paths = 0;      // a power of two; 0: chosen here
  float merge_radius = 0;        // 0: from the scene
  MemoryBudget* memory = nullptr;  // of what grows within an iteration; null: it may take any

  bool has(uint32_t technique) const { return (techniques & technique) != 0; }
  bool traces_light() const {
    return has(UPS_TECHNIQUE_CONNECT | UPS_TECHNIQUE_SENSOR_CONNECT | UPS_TECHNIQUE_MERGE | UPS_TECHNIQUE_SENSOR_HIT);
  }
};

// Which techniques a part of the sensors takes beside hits and next-event estimation.
struct TechniqueShare {
  // Caustics: where a light path met casters alone.
  enum Merge : uint8_t {
    no_merge = UPS_PHOTONS_NONE,
    merge_caustics = UPS_PHOTONS_CAUSTIC,
    merge_all = UPS_PHOTONS_ALL
  };
  bool connect = true, light = true;  // light: splats, landings
  Merge merge = merge_all;
};

// Parts of the sensors that may differ in their techniques: tiles of images, sets of meters.
class Units {
 public:
  static constexpr uint32_t side = 16;  // of a tile, pixels
  explicit Units(const Snapshot& scene);
  Units() = default;
  uint32_t count = 0;
  uint32_t columns(size_t camera) const { return columns_[camera]; }
  uint32_t tiles(size_t camera) const { return end(camera) - begin(camera); }
  uint32_t of_pixel(size_t camera, uint32_t pixel) const {
    const uint32_t x = pixel % widths_[camera], y = pixel / widths_[camera];
    return begins_[camera] + y / side * columns_[camera] + x / side;
  }
  uint32_t of_set(size_t set) const { return begins_[columns_.size() + set]; }
  // Sensors: cameras, then sets.
  size_t sensors() const { return begins_.size() - 1; }
  uint32_t begin(size_t sensor) const { return begins_[sensor]; }
  uint32_t end(size_t sensor) const { return begins_[sensor + 1]; }

 private:
  std::vector<uint32_t> begins_, widths_, columns_;
};

// Fixed sizes of an iteration.
struct Plan {
  uint32_t light_paths = 0;     // N
  uint32_t camera_subsets = 1;  // every pixel is visited each such many iterations; their subsets interleave; odd
  uint32_t pilot_shift = 0;     // from row to row, of a pilot: its one subset lies all over an image
  uint32_t meter_subsets = 1;   // the same of meters, by eye paths, discs and cells alike; odd, see make_plan()
  uint32_t meter_samples = 1;   // Ke, a power of two
  std::vector<mis::Gates> gates;  // by emitter
  // By emitter: nothing but next-event estimation brings its light straight to a point meter, without chance.
  std::vector<bool> exact;
  // Of point meters: all light straight from emitters is found so; no other light can reach them.
  bool exact_direct = false, exact_light = false;
  bool images_suffice = false;  // all that casters make of light straight from emitters is that of their images
  bool lands = false;  // light paths do, on cells
  bool seeks_caustics = false;  // casters may make such of what photons alone bring
  // By way of casters some light may come to meters without photons that eye paths alone find, as they run into its
  // emitter.
  bool hits_alone = false;
  std::vector<bool> counts_hits;  // by emitter: at least an eighth as bright as the brightest is; empty: none are counted
  Separation separation;  // of meters' readings
  // r_1 of each pixel, for the first vertex of its eye paths that scatters; empty without merging. All other vertices
  // merge within walk_radius: a hemisphere away from the sensor blur is not seen, but few photons are.
  std::vector<std::vector<float>> pixel_radius;
  // Of each set: what catches photons for all of a meter's eye paths at once; empty without merging.
  std::vector<MeterDiscs> meter_discs;
  std::vector<float> meter_reach;  // the largest radius of a set's discs; 0: nothing is in their way
  float walk_radius = 0;

  Units units;
  std::vector<TechniqueShare> shares;  // by unit; empty: all techniques everywhere
  bool merges_at(size_t set) const {
    return shares.empty() || shares[units.of_set(set)].merge != TechniqueShare::no_merge;
  }
  // Light paths land on cells of the set; photons on discs of it, some of them straight from an emitter.
  bool lands_on_cells(size_t set) const { return lands && (shares.empty() || shares[units.of_set(set)].light); }
  bool lands_on(size_t set) const { return set < meter_discs.size() && !meter_discs[set].empty() && merges_at(set); }
  bool hits_alone_at(size_t set) const { return hits_alone && !lands_on(set) && !lands_on_cells(set); }
  bool merges_direct_light() const {
    return std::any_of(gates.begin(), gates.end(), [](const mis::Gates& g) { return g.merge_at_first; });
  }
  // Light paths end where nothing but caustics is merged and they have met something that is no caster.
  bool traces_caustics_alone() const;
  // Where light paths start, which those of the books of flux may not be told.
  EmissionGuide guide;

  float min_radius = 0;  // below some ulps of the coordinates a radius means nothing

  // r_i^2 / r_1^2 after `visits` earlier iterations: r^2_{i+1} = r^2_i (i + alpha) / (i + 1) (Knaus, Zwicker 2011,
  // Eq. 16).
  static double radius2_factor(uint32_t visits, double alpha);
  // Squared radius of this iteration; 0 where radius_1 is 0: no merging.
  double radius2(double radius_1, double factor) const {
    return radius_1 > 0 ? std::max(radius_1 * radius_1 * factor, double(min_radius) * min_radius) : 0.0;
  }
  // How many of the radii stand at min_radius after `visits` earlier iterations or passes, and since which.
  struct AtFloor {
    size_t count = 0;
    uint32_t since = 0;
  };
  AtFloor at_floor(const std::vector<float>& radii, uint32_t visits, double alpha) const;
  // visit(running number, pixel) for each pixel that the iteration visits, in rising order. The numbers index what the
  // iteration found (IterationTally).
  template <class Visit>
  void for_visited_pixels(uint32_t iteration, uint32_t width, uint32_t height, const Visit& visit) const {
    uint32_t i = 0;
    for (uint32_t y = 0; y < height; ++y) {
      const uint32_t in_row = uint32_t(uint64_t(y) * subset_shift() % camera_subsets);
      for (uint32_t x = (iteration % camera_subsets + camera_subsets - in_row) % camera_subsets; x < width;
           x += camera_subsets)
        visit(i++, y * width + x);
    }
  }
  // The subset of a pixel: iterations i with i % camera_subsets equal to it visit it.
  uint32_t pixel_subset(uint32_t x, uint32_t y) const { return (x + y * subset_shift()) % camera_subsets; }
  uint32_t subset_shift() const { return pilot_shift ? pilot_shift : camera_subsets < 3 ? 1 : 2; }
  uint32_t pass(uint32_t iteration) const { return iteration / camera_subsets; }

  // Meters of a set that the iteration visits, and the i-th of them.
  size_t visited_meters(uint32_t iteration, size_t meters) const {
    return (meters + meter_subsets - 1 - iteration % meter_subsets) / meter_subsets;
  }
  uint32_t visited_meter(uint32_t iteration, size_t i) const {
    return uint32_t(i) * meter_subsets + iteration % meter_subsets;
  }
  uint32_t meter_pass(uint32_t iteration) const { return iteration / meter_subsets; }
  size_t bytes() const;
};

// Rows of sums that photons on discs may need: each point meter's, and one more of it a column.
size_t ring_rows(const Snapshot& scene, const Separation& separation);
Plan make_plan(const Snapshot& scene, const TransportSettings& settings);
// Numbers of paths an iteration, of a pilot's for at most so many from each end.
void set_path_counts(const Snapshot& scene, const TransportSettings& settings, uint32_t most, Plan& plan);

}  // namespace ups
