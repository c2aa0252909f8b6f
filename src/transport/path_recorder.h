// Follows the walks of an iteration of one thread, where Iteration::recorder is set: what each met and how it went on, and
// what techniques found. So a test can compute a path's weight by its definition, and a replay can show a path.
#pragma once
#include <cstddef>
#include <cstdint>

#include "base/rgb.h"
#include "base/vec.h"

namespace ups {

struct BsdfSample;
struct Contribution;
struct EmissionSample;
struct Encounter;
struct EyeSensor;

// What a contribution came to.
struct Brought {
  double pass;     // share of light that its new edge's panes let pass by
  Rgb unweighted;  // lx, cd/m2; of a light path that crosses a meter lm, or where that is a cell lx
  double weight;
};

class PathRecorder {
 public:
  virtual ~PathRecorder() = default;
  // Every edge of an eye path gets its shadow ray, not only those that are drawn.
  virtual bool wants_all_edges() const { return true; }
  // carried: the walk's throughput, lm for a light path.
  virtual void start_light(uint32_t emitter, const EmissionSample& start, const Rgb& carried) = 0;
  virtual void start_eye(const EyeSensor& sensor, const Vec3& p, const Vec3& n, float error) = 0;  // n: of a meter
  virtual void meet(const Encounter& met) = 0;  // the walk's next vertex
  virtual void scatter(const BsdfSample& lobe, float survival, const Rgb& carried) = 0;  // there
  virtual void store() = 0;                                  // it, as the next of LightPaths
  // By the current eye walk. photon: the running number of the vertex that it merged; none for other techniques.
  virtual void found(const Contribution& c, const Brought& brought, uint32_t photon) = 0;
  // By the current light walk.
  virtual void splatted(const Contribution& c, const Brought& brought, size_t camera, uint32_t pixel) = 0;
  virtual void landed(const Contribution& c, const Brought& brought, const Vec3& p, uint32_t set, uint32_t meter) = 0;
};

}  // namespace ups
