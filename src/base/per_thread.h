// Storage that each thread has of its own and uses again: a thread_local for what has a destructor. Such a thread_local
// needs memory at its first use in a thread and ends the process where there is none; this throws std::bad_alloc.
#pragma once
#include <memory>
#include <new>

#include "platform/thread_slot.h"

namespace ups {

// For statics: a thread's object lives as long as the thread.
template <class T>
class PerThread {
 public:
  T& get() const {
    if (void* kept = slot_.get()) return *static_cast<T*>(kept);
    auto fresh = std::make_unique<T>();
    if (!slot_.set(fresh.get())) throw std::bad_alloc();
    return *fresh.release();
  }

 private:
  platform::ThreadSlot slot_{[](void* kept) { delete static_cast<T*>(kept); }};
};

}  // namespace ups
