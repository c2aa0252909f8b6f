// What a material returns of light from one direction.
#pragma once
#include "cases.h"

namespace ups::test {

// i in the digits of `base`, mirrored at the point (van der Corput).
inline float radical_inverse(uint32_t i, uint32_t base) {
  double value = 0, digit = 1.0 / base;
  for (; i > 0; i /= base, digit /= base) value += digit * (i % base);
  return std::min(float(value), 0x1.fffffep-1f);
}

// Directional albedo in importance mode: the mean weight over Hammersley's points in three dimensions.
inline double albedo(const Material& m, float cosine, uint32_t count = 1 << 14) {
  const Bsdf bsdf(m, {0, 0});
  const Vec3 wo = direction(cosine);
  double sum = 0;
  for (uint32_t i = 0; i < count; ++i) {
    BsdfSample s;
    const Vec2 u{radical_inverse(i, 2), (float(i) + 0.5f) / float(count)};
    if (bsdf.sample(wo, radical_inverse(i, 3), u, TransportMode::importance, s)) sum += luminance(s.weight);
  }
  return sum / count;
}

}  // namespace ups::test
