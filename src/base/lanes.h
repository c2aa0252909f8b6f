// Four floats at once, by the vector extensions of GCC and Clang. Each lane has the bits that a float by itself would
// have, so that templates over both give the same answers.
#pragma once
#include <cmath>
#include <cstdint>
#include <cstring>
#if defined(__SSE2__)
#include <emmintrin.h>
#endif

#include "base/vec.h"

namespace ups {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int32_t __attribute__((vector_size(16)));
inline constexpr int lane_count = 4;

// Of four floats in a row, wherever they start.
inline Float4 four_at(const float* first) {
  Float4 out;
  std::memcpy(&out, first, sizeof out);
  return out;
}
inline Float4 abs(Float4 x) { return Float4(Int4(x) & 0x7fffffff); }
inline Float4 copysign(Float4 size, Float4 sign) {
  return Float4((Int4(size) & 0x7fffffff) | (Int4(sign) & INT32_MIN));
}
inline Float4 sqrt(Float4 x) {
  return Float4{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}
// a where it is the larger or smaller, else b, also where either is no number: single instructions.
inline float larger(float a, float b) { return a > b ? a : b; }
inline float smaller(float a, float b) { return a < b ? a : b; }
#if defined(__SSE2__)
inline Float4 larger(Float4 a, Float4 b) { return _mm_max_ps(a, b); }
inline Float4 smaller(Float4 a, Float4 b) { return _mm_min_ps(a, b); }
#else
inline Float4 larger(Float4 a, Float4 b) { return a > b ? a : b; }
inline Float4 smaller(Float4 a, Float4 b) { return a < b ? a : b; }
#endif
// A bit of each lane of a comparison, the first lane's the lowest.
#if defined(__SSE2__)
inline uint32_t bits_of(Int4 mask) { return uint32_t(_mm_movemask_ps(Float4(mask))); }
#else
inline uint32_t bits_of(Int4 mask) {
  return uint32_t((mask[0] & 1) | (mask[1] & 2) | (mask[2] & 4) | (mask[3] & 8));
}
#endif
inline uint32_t bits_of(bool mask) { return mask; }
inline Int4 truncated(Float4 x) { return __builtin_convertvector(x, Int4); }
inline int truncated(float x) { return int(x); }

template <class T> T all_lanes(float x) {
  if constexpr (sizeof(T) == sizeof(float)) return x;
  else return T{x, x, x, x};
}
template <class T> Vec3T<T> all_lanes(const Vec3& v) {
  return {all_lanes<T>(v.x), all_lanes<T>(v.y), all_lanes<T>(v.z)};
}

}  // namespace ups
