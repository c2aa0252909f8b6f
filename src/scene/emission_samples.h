// Some of an emitter's light, spread over its area, the same each time.
#pragma once
#include "base/rng.h"
#include "emitter/emitter.h"

namespace ups {

// visit(sample): whether to go on. stream: numbers of its own for each purpose.
template <class Visit>
void each_emission(const Emitter& emitter, uint32_t count, uint32_t stream, const Visit& visit) {
  for (uint32_t i = 0; i < count; ++i) {
    const auto u = philox({i, stream, 0, 0}, {0, 0});
    EmissionSample s;
    if (emitter.sample_emission({(float(i) + 0.5f) / float(count), to_unit_float(u[0])},
                                {to_unit_float(u[1]), to_unit_float(u[2])}, s) &&
        !visit(s))
      return;
  }
}

}  // namespace ups
