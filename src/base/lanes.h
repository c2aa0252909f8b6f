// Four floats at once, by the vector extensions of GCC and Clang. Each lane has the bits that a float by itself would
// have, so that templates over both give the same answers.
#pragma once
#include <cmath>
#include <cstdint>

#include "base/vec.h"

namespace ups {

using Float4 = float __attribute__((vector_size(16)));
using Int4 = int32_t __attribute__((vector_size(16)));
inline constexpr int lane_count = 4;

inline Float4 abs(Float4 x) { return Float4(Int4(x) & 0x7fffffff); }
inline Float4 copysign(Float4 size, Float4 sign) {
  return Float4((Int4(size) & 0x7fffffff) | (Int4(sign) & INT32_MIN));
}
inline Float4 sqrt(Float4 x) {
  return Float4{std::sqrt(x[0]), std::sqrt(x[1]), std::sqrt(x[2]), std::sqrt(x[3])};
}
inline bool any(Int4 mask) {
  using Long2 = int64_t __attribute__((vector_size(16)));
  return (Long2(mask)[0] | Long2(mask)[1]) != 0;
}
inline bool any(bool mask) { return mask; }
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
