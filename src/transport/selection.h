// Which techniques pay: for each set of meters and each tile of an image, from second moments that a pilot measures and
// from counted operations, never from the clock. What the pilot finds is thrown away, so the choice changes no
// expectation. After Grittmann et al. 2022, Efficiency-aware multiple importance sampling, with the weights' own sums.
#pragma once
#include <functional>
#include <vector>

#include "base/parallel.h"
#include "transport/iteration.h"
#include "transport/tally.h"
#include "ups/ups_render.h"

namespace ups {

// Second moments of sets of techniques, beyond that of the set that is traced.
class Moments {
 public:
  // splats: how many times as many of them there will be to an eye path as are traced. complete: every set is proved to
  // have a technique for every path.
  explicit Moments(std::vector<mis::Classes> sets, double splats = 1, bool complete = false)
      : sets_(std::move(sets)), splats_(splats), complete_(complete) {}
  size_t count() const { return sets_.size(); }
  // Of one sensor's row of sums: an excess a set, then of its eye paths sum and square, light paths' squares, and all
  // light and that by photons of caustics.
  size_t row() const { return sets_.size() + 5; }
  void add_eye_path(double value, double* of_row) const {
    of_row[sets_.size()] += value, of_row[sets_.size() + 1] += value * value;
  }
  void add_light_path(double value, const mis::Classes& relative, bool camera, double* of_row) const {
    add(value, relative, camera, of_row);
    of_row[sets_.size() + 2] += value * value;
  }
  // A contribution of weight w = 1 / sum(relative densities) in the traced set: E[v^2] becomes E[v^2 D / D_j].
  void add(double value, const mis::Classes& relative, bool camera, double* excess) const;

 private:
  std::vector<mis::Classes> sets_;  // counts of each class over those traced, of splats over splats_ times those
  double splats_;
  bool complete_;
};

struct Selection {
  uint32_t light_paths = 0;
  std::vector<TechniqueShare> shares;      // by Units; empty: nothing was chosen
  std::vector<ups_sensor_choice> sensors;  // cameras, then sets of meters, then goniometers
};

// trace: one iteration of the plan that it is given. guide: where light paths start that only caustics need. Chooses
// nothing once `stop` is set.
using TraceIteration = std::function<bool(const Iteration&, IterationTally&)>;
Selection select_techniques(const Snapshot& scene, const Plan& plan, const TransportSettings& settings,
                            const EmissionGuide& guide, const StopSignal& stop, const TraceIteration& trace);
// Of what `choices` have, or where there are none of all techniques: what brings light to each kind of sensor.
void complete(const Snapshot& scene, const Plan& plan, const TransportSettings& settings,
              std::vector<ups_sensor_choice>& choices);

}  // namespace ups
