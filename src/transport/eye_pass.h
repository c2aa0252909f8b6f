// Traces the eye paths of one iteration: from every visited pixel and from every meter, with emitter hits, next-event
// estimation, connections to a light path and merges at each vertex.
#pragma once
#include "base/parallel.h"
#include "base/stop.h"
#include "transport/light_vertex.h"
#include "transport/photon_index.h"
#include "transport/plan.h"
#include "transport/tally.h"

namespace ups {

struct EyePassInput {
  const Snapshot& scene;
  const Plan& plan;
  const TransportSettings& settings;
  const LightPaths& light;
  const PhotonIndex& pixel_photons;  // for the radii of pixels; may be empty
  const PhotonIndex& walk_photons;   // for walk_radius2
  uint32_t iteration;
  uint32_t camera_batch, camera_batch_visit;
  uint32_t meter_batch, meter_batch_visit;
  double camera_radius_factor, meter_radius_factor, walk_radius2;
  const StopSignal& stop;  // when set, what is found is incomplete and to be thrown away
};

// `first_path`: running number of the pass's first eye path, for its pairing with light paths. Returns the next one's.
uint32_t trace_camera_paths(const EyePassInput& in, uint32_t camera, uint32_t first_path, ThreadPool& pool,
                            IterationTally& tally);
uint32_t trace_meter_paths(const EyePassInput& in, uint32_t set, uint32_t first_path, ThreadPool& pool,
                           IterationTally& tally);

}  // namespace ups
