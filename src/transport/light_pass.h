// Traces the light paths of one iteration: stores vertices for connections and merges, splats to cameras (t = 1), lands
// on cells (t = 0), merges at point meters, keeps the books of flux.
#pragma once
#include "base/parallel.h"
#include "transport/light_vertex.h"
#include "transport/sensor_index.h"
#include "transport/tally.h"

namespace ups {

// Its memory is used again from one iteration to the next.
class LightPass {
 public:
  LightPass();
  ~LightPass();
  // Adds to tally.splats, tally.meters, tally.landings, tally.work; the same bits for any number of threads. The
  // vertices stay until the next call.
  LightPaths trace(const Iteration& in, const SensorIndex& sensors, ThreadPool& pool, IterationTally& tally);
  // What is thrown away after a radius is chosen from it.
  LightPaths trace_pilot(const Iteration& in, ThreadPool& pool);
  void clear();  // gives the memory back

  struct Block;  // what a block of paths found

 private:
  std::vector<Block> blocks_;
};

// One of these paths alone, as a replay, for the iteration's recorder.
void retrace_light_path(const Iteration& in, const SensorIndex& sensors, uint32_t path);
// What a light path leaves in the mean, as a few of them show; what so many take while they are traced and used.
struct LightPassCounts {
  double vertices = 0, merged = 0, splats = 0, landings = 0, escapes = 0;
  double bytes(uint32_t paths) const;
};
LightPassCounts count_light_pass(const Iteration& in, const SensorIndex& sensors, ThreadPool& pool, uint32_t paths);

}  // namespace ups
