// Asks memory for what is read soon, so that it answers while something else is done. Any address will do. A function
// that does nothing else must be inline: g++ takes it for one without effect and drops its calls.
#pragma once
#include <cstddef>
#include <cstdint>

namespace ups {

template <class T>
inline void prefetch(const T* objects, size_t count = 1) {
  constexpr uintptr_t line = 64;
  const auto begin = reinterpret_cast<uintptr_t>(objects), end = begin + count * sizeof(T);
  for (uintptr_t at = begin & ~(line - 1); at < end; at += line) __builtin_prefetch(reinterpret_cast<const void*>(at));
}

}  // namespace ups
