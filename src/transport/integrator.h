// One iteration of Unified Path Sampling, in reading order: light pass, photon index, eye pass. Called by render/job.
#pragma once
#include <memory>
#include <optional>

#include "base/parallel.h"
#include "base/stop.h"
#include "transport/caster_aim.h"
#include "transport/direct_light.h"
#include "transport/light_pass.h"
#include "transport/selection.h"
#include "transport/tally.h"

namespace ups {

struct SampleAddress;
struct Photons;
struct Replayed;
class SensorIndex;

class Integrator {
 public:
  // Traces a pilot; once `stop` is set only run() returning false is to be expected of it.
  Integrator(std::shared_ptr<const Snapshot> scene, const TransportSettings& settings, ThreadPool& pool,
             const StopSignal& stop);
  const Plan& plan() const { return plan_; }  // run() adds how far meters see, and nothing else
  const TransportSettings& settings() const { return settings_; }  // with the techniques that were selected
  const Selection& selection() const { return selection_; }
  // Its light paths are whole, and show where all flux goes.
  bool books_flux() const { return settings_.traces_light() && !plan_.traces_caustics_alone(); }
  const Snapshot& scene() const { return *scene_; }
  size_t bytes() const { return plan_.bytes() + direct_.bytes(); }
  // That an iteration's light paths, their index and what they bring are expected to take.
  double bytes_of_light_paths(const StopSignal& stop) const;
  // Iterations from 0, in order. False where `stop` was set on the way: the tally is then incomplete. The same bits for
  // any number of threads.
  bool run(uint32_t iteration, const StopSignal& stop, IterationTally& tally);
  // After the last iteration: gives back what is kept from one to the next.
  void end() { light_pass_.clear(); }
  // One path of such an iteration again. An integrator that replays does not run.
  Replayed replay(const SampleAddress& address, const StopSignal& stop);

 private:
  void choose_first_radii(const StopSignal& stop);
  void select(const std::optional<CasterAims>& aims, const StopSignal& stop);
  EmissionGuide train_guide(const CasterAims& aims, const StopSignal& stop);
  bool trace(const Iteration& in, IterationTally& tally);
  Photons trace_light(const Iteration& in, const SensorIndex& sensors, IterationTally& tally);
  // What meters see for the whole render, of those that the iteration is the first to visit.
  void look_from_meters(uint32_t iteration, const StopSignal& stop, WorkCounts& work);
  double replay_eye_path(const Iteration& in, const Photons& photons, const SampleAddress& address,
                         IterationTally& tally);
  std::shared_ptr<const Snapshot> scene_;
  TransportSettings settings_;
  ThreadPool& pool_;
  Plan plan_;
  DirectLight direct_;
  WorkCounts pilot_shadow_rays_;  // of what it has found before the first iteration
  LightPass light_pass_;
  Selection selection_;
  float largest_pixel_radius_ = 0;
  std::shared_ptr<const DiscIndex> sensor_discs_;  // of the last iteration, where each visits all meters
};

}  // namespace ups
