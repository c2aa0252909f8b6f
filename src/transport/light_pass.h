// Traces the light paths of one iteration: stores vertices for connections and merges, splats to cameras (t = 1), lands
// on cells (t = 0), merges at point meters, keeps the books of flux.
#pragma once
#include "base/parallel.h"
#include "transport/light_vertex.h"
#include "transport/sensor_index.h"
#include "transport/tally.h"

namespace ups {

// Adds to tally.splats, tally.meters, tally.landings, tally.work; the same bits for any number of threads.
LightPaths trace_light_paths(const Iteration& in, const SensorIndex& sensors, ThreadPool& pool,
                             IterationTally& tally);

// One of these paths alone, as a replay, for the iteration's recorder.
void retrace_light_path(const Iteration& in, const SensorIndex& sensors, uint32_t path);

// What is thrown away after a radius is chosen from it.
std::vector<LightVertex> trace_pilot_vertices(const Iteration& in, ThreadPool& pool);

}  // namespace ups
