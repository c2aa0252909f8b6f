// Counter-based random numbers with fixed addresses: a number depends only on (seed, stream, a, b, c), never on what
// was drawn before, so results do not depend on threads and every path can be replayed.
#pragma once
#include <array>
#include <cstdint>

#include "base/vec.h"

namespace ups {

// Philox4x32-10 (Salmon et al. 2011, "Parallel Random Numbers: As Easy as 1, 2, 3").
inline std::array<uint32_t, 4> philox(std::array<uint32_t, 4> c, std::array<uint32_t, 2> k) {
  for (int round = 0; round < 10; ++round) {
    const uint64_t p0 = uint64_t(0xD2511F53u) * c[0], p1 = uint64_t(0xCD9E8D57u) * c[2];
    c = {uint32_t(p1 >> 32) ^ c[1] ^ k[0], uint32_t(p1), uint32_t(p0 >> 32) ^ c[3] ^ k[1], uint32_t(p0)};
    k = {k[0] + 0x9E3779B9u, k[1] + 0xBB67AE85u};
  }
  return c;
}

// [0, 1), 24 bits, so that it never rounds to 1.
inline float to_unit_float(uint32_t bits) { return float(bits >> 8) * 0x1p-24f; }

// Finalizer of MurmurHash3: mixes a seed into well-spread 64 bits.
inline uint64_t mix64(uint64_t x) {
  x ^= x >> 33;
  x *= 0xff51afd7ed558ccdull;
  x ^= x >> 33;
  x *= 0xc4ceb9fe1a85ec53ull;
  return x ^ (x >> 33);
}
inline uint64_t hash_combine(uint64_t a, uint64_t b) { return mix64(a + 0x9e3779b97f4a7c15ull * (b + 1)); }

}  // namespace ups
