// Traces the eye paths of one iteration: from every visited pixel and from every meter, with emitter hits, next-event
// estimation, connections to a light path and merges at each vertex.
#pragma once
#include "base/parallel.h"
#include "transport/direct_light.h"
#include "transport/light_vertex.h"
#include "transport/photon_index.h"
#include "transport/tally.h"

namespace ups {

// Light paths as eye paths find them.
struct Photons {
  LightPaths paths;
  PhotonIndex of_pixels;  // for the radii of pixels; may be empty
  PhotonIndex of_walks;   // for Iteration::walk_radius2
};

// `first_path`: running number of the pass's first eye path, for its pairing with light paths. Returns the next one's.
uint32_t trace_camera_paths(const Iteration& in, const Photons& photons, uint32_t camera, uint32_t first_path, ThreadPool& pool,
                            IterationTally& tally);
uint32_t trace_meter_paths(const Iteration& in, const Photons& photons, const DirectLight& direct, uint32_t set,
                           uint32_t first_path, ThreadPool& pool, IterationTally& tally);

// One of these paths alone, as a replay: what it brings, cd/m2, or lx to its meter's estimate; -1: the iteration traces
// none such. path: of the meter's own.
float retrace_pixel(const Iteration& in, const Photons& photons, uint32_t camera, uint32_t first_path, uint32_t pixel,
                    IterationTally& tally);
float retrace_meter(const Iteration& in, const Photons& photons, const DirectLight& direct, uint32_t set,
                    uint32_t first_path, uint32_t meter, uint32_t path, IterationTally& tally);

}  // namespace ups
