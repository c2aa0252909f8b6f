// Everything that is fixed for one iteration, built once and read by both walks: which samples are drawn, how many paths
// and techniques there are, and the radii within which photons are merged.
#pragma once
#include <cmath>

#include "base/prefetch.h"
#include "base/stop.h"
#include "transport/plan.h"
#include "transport/sampler.h"

namespace ups {

class Moments;
class PathRecorder;

struct Iteration {
  // A batch shares the scrambling of its stratified numbers; visit: how many earlier passes it had.
  struct Visit {
    uint32_t batch, number;
  };

  // Numbers of a render's own iterations; of a pilot's, which are drawn from a stream of their own.
  Iteration(const Snapshot& of_scene, const Plan& by_plan, const TransportSettings& by_settings, uint32_t running_number,
            const StopSignal& stop_signal);
  static Iteration of_pilot(const Snapshot& of_scene, const Plan& by_plan, const TransportSettings& by_settings,
                            uint32_t running_number, const StopSignal& stop_signal, Stream stream);

  const Snapshot& scene;
  const Plan& plan;
  const TransportSettings& settings;
  const StopSignal& stop;  // when set, what is found is incomplete and to be thrown away
  uint32_t number;
  Visit light_visit, camera_visit, meter_visit;
  Stream light_stream = Stream::light;
  bool stores_vertices;
  bool light_samples_alone;  // no other technique finds light: no emitter can be hit, and there are no light paths
  double camera_shrinkage;  // r_i^2 / r_1^2
  double walk_radius2;      // of merges beyond the first vertex
  bool trains_guide = false;
  const Moments* moments = nullptr;          // of a pilot that chooses techniques
  PathRecorder* recorder = nullptr;          // of a test or a replay

  bool has(uint32_t technique) const { return settings.has(technique); }
  bool weighted() const { return settings.method.weighted && !light_samples_alone; }
  bool looks_into_mirrors() const { return has(UPS_TECHNIQUE_MIRROR_SAMPLE) && !scene.flat_mirrors.empty(); }
  bool is_too_long(uint32_t edges) const { return settings.max_path_length && edges > settings.max_path_length; }
  // Squared radii of this iteration; 0: photons are not merged there.
  double pixel_radius2(size_t c, uint32_t pixel) const {
    return plan.pixel_radius.empty() ? 0 : plan.radius2(plan.pixel_radius[c][pixel], camera_shrinkage);
  }
  double meter_radius2(size_t s, uint32_t m) const {  // of a disc of as much area as is seen, which does not shrink
    return plan.meter_discs.empty() || plan.meter_discs[s].empty()
               ? 0
               : plan.meter_discs[s].area(m) / 3.14159265358979323846;
  }
  double eta(double radius2) const;                 // N pi r^2 where photons are merged
  double photon_norm(double radius2) const;         // 1 / (N pi r^2)
  mis::Counts camera_counts(size_t c, uint32_t pixel) const;
  void prefetch_camera_counts(size_t c, uint32_t pixel) const {
    if (!plan.pixel_radius.empty()) prefetch(&plan.pixel_radius[c][pixel]);
  }
  mis::Counts meter_counts(size_t set) const;
  bool merges_at(size_t set) const {
    return has(UPS_TECHNIQUE_MERGE) && plan.merges_at(set);
  }
  mis::Counts light_counts() const { return counts({}); }  // of what is baked into light vertices
  const mis::Gates& gates_of(uint32_t emitter) const { return plan.gates[emitter]; }

 private:
  // unit(): which one, asked only where they differ.
  template <class Unit>
  TechniqueShare share(const Unit& unit) const { return plan.shares.empty() ? TechniqueShare{} : plan.shares[unit()]; }
  mis::Counts counts(const TechniqueShare& share) const;
};

}  // namespace ups
