// Large arrays that start as zeros: the machine gives pages of zeros when they are first touched, so that making one
// takes no time, however large it is.
#pragma once
#include <cstdlib>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace ups {

// Of types whose default is all bits 0, in vectors that never shrink.
template <class T>
struct ZeroedAllocator {
  static_assert(std::is_trivially_copyable_v<T>);
  using value_type = T;

  ZeroedAllocator() = default;
  template <class U>
  ZeroedAllocator(const ZeroedAllocator<U>&) {}
  T* allocate(size_t count) {
    if (void* memory = std::calloc(count, sizeof(T))) return static_cast<T*>(memory);
    throw std::bad_alloc();
  }
  void deallocate(T* memory, size_t) { std::free(memory); }
  template <class U>
  void construct(U*) {}  // it is there
  template <class U, class... Arguments>
  void construct(U* at, Arguments&&... arguments) {
    ::new (static_cast<void*>(at)) U(std::forward<Arguments>(arguments)...);
  }
  friend bool operator==(const ZeroedAllocator&, const ZeroedAllocator&) { return true; }
};
template <class T>
using ZeroedVector = std::vector<T, ZeroedAllocator<T>>;

}  // namespace ups
