// The light vector at a point, from six planar meters that face the axes (MeterSet): their differences by batch, so that
// what two of them share of chance cancels. Called by the accumulator.
#pragma once
#include <array>

#include "base/vec.h"
#include "render/meter_sums.h"
#include "sensor/response.h"

namespace ups {

class VectorLight {
 public:
  using Sides = std::array<const MeterLight*, vector_sides>;
  // eye_paths: of each side in an iteration, by which samples are told apart.
  VectorLight(const Sides& sides, uint32_t eye_paths) : sides_(sides), eye_paths_(eye_paths) {}

  // The vector's length as a meter's light, or that of the direct or the indirect light's own vector: what lies along
  // it, and as bias also what noise across it adds to a length.
  MeterLight length(LightPart part) const;
  // Its reading and parts: lengths all of them. length: that of whole_light.
  ups_meter_reading reading(const MeterLight& length) const;
  ups_meter_part_reading part(ups_light_part part) const;
  std::array<ups_vector_part_reading, 3> components() const;  // by ups_light_part

 private:
  MeterLight along(const Vec3d& direction) const;
  Vec3d vector(LightPart part) const;

  Sides sides_;
  uint32_t eye_paths_;
};

}  // namespace ups
