// Follows the walks of an iteration of one thread, where a test has set Iteration::recorder: what each met and how it
// went on, and what techniques found. So tests can compute a path's weight by its definition.
#pragma once
#include <cstddef>
#include <cstdint>

#include "base/vec.h"

namespace ups {

struct Contribution;
struct Encounter;
struct EyeSensor;

class PathRecorder {
 public:
  virtual ~PathRecorder() = default;
  virtual void start_light(uint32_t emitter, const Vec3& p) = 0;
  virtual void start_eye(const EyeSensor& sensor, const Vec3& p, const Vec3& n, float error) = 0;  // n: of a meter
  virtual void meet(const Encounter& met) = 0;  // the walk's next vertex
  virtual void scatter(bool delta) = 0;         // there
  virtual void store() = 0;                     // it, as the next of LightPaths::vertices
  // By the current eye walk. photon: what it merged; none for other techniques.
  virtual void found(const Contribution& c, double pass, uint32_t photon) = 0;
  // By the current light walk.
  virtual void splatted(const Contribution& c, double pass, size_t camera, uint32_t pixel) = 0;
  virtual void landed(const Contribution& c, const Vec3& p, uint32_t set, uint32_t meter) = 0;
};

}  // namespace ups
