// How much memory a render will take, and whether it may. Adds up what the arrays' own files say of them; asked by the
// job before it renders, and by the API.
#pragma once
#include <string>

#include "transport/integrator.h"
#include "ups/ups_render.h"

namespace ups {

// Bytes.
struct MemoryEstimate {
  double scene = 0;
  double plan = 0;                                     // radii, discs, direct light
  double images = 0, meters = 0, goniometers = 0;      // sums
  double iteration = 0, light_paths = 0;               // of one iteration: all but its light paths, and these
  double reading = 0, scratch = 0;                     // of a result, and while it is read
  double pilots = 0;                                   // before all but the scene
  double sums() const { return plan + images + meters + goniometers; }
  double working() const { return std::max(sums() + iteration + light_paths, pilots); }
  double fixed_while_tracing() const { return scene + sums() + iteration; }
  double peak() const {
    return scene + std::max(sums() + std::max(iteration + light_paths, reading + scratch), pilots);
  }
};

// What no plan changes: of a desc whose techniques are chosen by a pilot, what any choice takes.
MemoryEstimate least_memory(const Snapshot& scene, const TransportSettings& settings, const Plan& plan,
                            const ups_render_desc& desc);
// Traces a few light paths. Until `stop` is set. pilots: that the light paths of the integrator's pilots took.
MemoryEstimate estimate_memory(const Integrator& integrator, const ups_render_desc& desc, double pilots,
                               const StopSignal& stop);

// What the scene and the render may take together.
struct AllowedMemory {
  double bytes;
  std::string limit;  // in words
};
AllowedMemory allowed_memory(double scene_bytes, const ups_render_desc& desc);
size_t whole_bytes(double bytes);  // as much as there is may be more than a size holds
ups_memory_estimate in_bytes(const MemoryEstimate& estimate, const AllowedMemory& allowed);
// Throws Error OUT_OF_MEMORY with what is wanted and what would be right.
void check_memory(const MemoryEstimate& estimate, const AllowedMemory& allowed, const Snapshot& scene, const Plan& plan,
                  const ups_render_desc& desc);

}  // namespace ups
